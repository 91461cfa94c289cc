#!/usr/bin/env python3
"""Draws the demo map: prints the world script of examples/maps/highground.wws.

Usage: make_highground.py [OUT]      standard output if OUT is missing

Two main bases on cliff-ringed plateaus, two expansions, a river with bridges and fords around a lake, ridges, rocks,
forests, buildings and walls. The script draws one half and rotates it by half a turn about the middle, as on a
fair game map. Its output is the same on every machine, as all coordinates are rounded to quarters.
"""

import math
import random
import sys

WIDTH, HEIGHT = 512, 384


def quarter(value):
    return round(value * 4) / 4


def place(x, y):
    """Returns the nearest point inside the map whose coordinates are quarters."""
    return (min(max(quarter(x), 0.0), float(WIDTH)), min(max(quarter(y), 0.0), float(HEIGHT)))


def turned(point):
    """Returns the point rotated by half a turn about the middle of the map."""
    return (WIDTH - point[0], HEIGHT - point[1])


def distance_to_side(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    t = 0.0 if square == 0 else min(1.0, max(0.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def inside(p, ring):
    odd = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]):
            odd = not odd
    return odd


class Map:
    """Items in groups, each with a heading, and the areas that are still free."""

    def __init__(self):
        self.groups = {}
        self.rings = []
        self.chains = []
        self.lanes = []

    def polygon(self, group, *rings):
        rings = [[place(x, y) for x, y in ring] for ring in rings]
        for copy in (rings, [[turned(p) for p in ring] for ring in rings]):
            self.groups.setdefault(group, []).append(("polygon", copy))
            self.rings.extend(copy)

    def wall(self, group, chain):
        chain = [place(x, y) for x, y in chain]
        for copy in (chain, [turned(p) for p in chain]):
            self.groups.setdefault(group, []).append(("segment" if len(copy) == 2 else "polyline", [copy]))
            self.chains.append(copy)

    def point(self, group, x, y):
        for copy in (place(x, y), turned(place(x, y))):
            self.groups.setdefault(group, []).append(("point", [[copy]]))

    def lane(self, width, *stops):
        """Marks an area that scattered items must not use."""
        for copy in (list(stops), [turned(p) for p in stops]):
            self.lanes.append((width / 2, copy))

    def is_free(self, x, y, radius):
        p = (x, y)
        if not (radius <= x <= WIDTH - radius and radius <= y <= HEIGHT - radius):
            return False
        if sum(inside(p, ring) for ring in self.rings) % 2:
            return False
        closed = [zip(ring, ring[1:] + ring[:1]) for ring in self.rings]
        opened = [zip(chain, chain[1:]) for chain in self.chains]
        if any(distance_to_side(p, a, b) < radius for sides in closed + opened for a, b in sides):
            return False
        return all(distance_to_side(p, a, b) >= half + radius
                   for half, stops in self.lanes for a, b in zip(stops, stops[1:]))

    def text(self):
        lines = ["# Highground: the demo map, drawn by scripts/make_highground.py", "waywright 1",
                 f"domain 0 0 {WIDTH} {HEIGHT}"]
        number = 0
        for group, items in self.groups.items():
            lines += ["", f"# {group}"]
            for word, rings in items:
                number += 1
                lines.append(f"{word} {number} {numbers(word, rings)}")
        return "\n".join(lines) + "\n"


def numbers(word, rings):
    parts = []
    for ring in rings:
        count = f"{len(ring)} " if word in ("polygon", "polyline") else ""
        parts.append(count + " ".join(f"{value:g}" for p in ring for value in p))
    return " / ".join(parts)


class Wobble:
    """Returns a smooth, closed, irregular function of an angle, within about -1 to 1."""

    def __init__(self, rng, waves=(2, 3, 5, 8), weights=(0.45, 0.3, 0.2, 0.12)):
        self.terms = [(wave, weight, rng.uniform(0, 2 * math.pi)) for wave, weight in zip(waves, weights)]

    def __call__(self, angle):
        return sum(weight * math.sin(wave * angle + phase) for wave, weight, phase in self.terms)


def blob(rng, x, y, radius, corners, roughness=0.25, stretch=1.0, angle=0.0):
    """Returns an irregular ring around a point."""
    ring = []
    for k in range(corners):
        turn = 2 * math.pi * (k + rng.uniform(-0.25, 0.25)) / corners
        reach = radius * (1 + rng.uniform(-roughness, roughness))
        u, v = reach * stretch * math.cos(turn), reach / stretch * math.sin(turn)
        ring.append((x + u * math.cos(angle) - v * math.sin(angle), y + u * math.sin(angle) + v * math.cos(angle)))
    return ring


def cliff(world, rng, x, y, radius, ramps, thickness=6.5):
    """Returns a plateau's rim with gaps for ramps (angle in degrees, width), each with walls to its left and right."""
    wobble, crag = Wobble(rng), Wobble(rng, (7, 11, 16, 23), (0.4, 0.3, 0.3, 0.25))

    def rim(angle, inset):
        reach = radius * (1 + 0.13 * wobble(angle)) - inset
        return (x + reach * math.cos(angle), y + reach * math.sin(angle))

    edges = []
    for degrees, width in ramps:
        half = math.atan2(width / 2, radius)
        edges.append((math.radians(degrees) - half, math.radians(degrees) + half))
    for (_, start), (end, _) in zip(edges, edges[1:] + edges[:1]):
        while end <= start:
            end += 2 * math.pi
        steps = max(8, round((end - start) * radius / 4.5))
        angles = [start + (end - start) * k / steps for k in range(steps + 1)]
        outer = [rim(a, -1.6 * crag(a)) for a in angles]
        inner = [rim(a, thickness * (1 + 0.45 * crag(1.7 * a)) + rng.uniform(-0.8, 0.8)) for a in reversed(angles)]
        world.polygon("cliffs", outer + inner)
    for start, end in edges:
        for angle, lean in ((start, -0.10), (end, 0.10)):
            world.wall("ramp walls", [rim(angle, thickness + 3), rim(angle, 0), rim(angle + lean, -9)])


def river_point(t):
    """Returns the river's middle line from the map's upper edge, t = 0, to the lake, t = 1."""
    x = 146 + 110 * t + 26 * math.sin(2 * math.pi * t) * (1 - 0.35 * t)
    return (x, 384 - 192 * t)


def river_frame(t):
    a, b = river_point(t - 0.005), river_point(t + 0.005)
    length = math.hypot(b[0] - a[0], b[1] - a[1])
    return (b[0] - a[0]) / length, (b[1] - a[1]) / length


def river_piece(world, rng, start, end):
    """Returns the water from one crossing to the next; its ends are straight."""
    left, right = [], []
    steps = max(5, round((end - start) * 34))
    for k in range(steps + 1):
        t = start + (end - start) * k / steps
        (x, y), (dx, dy) = river_point(t), river_frame(t)
        for bank, side in ((left, 1), (right, -1)):
            half = 8.5 + 1.6 * math.sin(23 * t + side) + rng.uniform(-0.8, 0.8)
            bank.append((x - side * dy * half, y + side * dx * half))
    world.polygon("water", left + right[::-1])


def bridge(world, t, width, reach):
    """Returns two rails across the river, which overlap the ends of the water."""
    (x, y), (dx, dy) = river_point(t), river_frame(t)
    for side in (-1, 1):
        chain = []
        for along, flare in ((-reach - 4, 3), (-reach, 0), (reach, 0), (reach + 4, 3)):
            off = side * (width / 2 + flare)
            chain.append((x + dx * off - dy * along, y + dy * off + dx * along))
        world.wall("bridge rails", chain)


def lake(world, rng):
    """Returns the lake in the middle of the map, with an island. Half a turn maps its shape to itself."""
    wobble, shore = Wobble(rng, (2, 4, 6, 10), (0.5, 0.3, 0.2, 0.1)), []
    for k in range(44):
        angle = 2 * math.pi * k / 44
        reach = 33 * (1 + 0.16 * wobble(angle))
        shore.append(place(256 + 1.15 * reach * math.cos(angle), 192 + 0.95 * reach * math.sin(angle)))
    shore = shore[:22] + [turned(p) for p in shore[:22]]
    island = [place(*p) for p in blob(rng, 256, 192, 13, 9, 0.2)]
    world.groups.setdefault("water", []).append(("polygon", [shore, island]))
    world.rings += [shore, island]


def water(world, rng):
    bridges, ford = (0.46,), 0.74
    cuts = [-0.02, bridges[0] - 0.026, bridges[0] + 0.026, ford - 0.016, ford + 0.016, 0.95]
    for start, end in zip(cuts[::2], cuts[1::2]):
        river_piece(world, rng, max(start, 0.0), end)
    lake(world, rng)
    for t in bridges:
        bridge(world, t, 10, 12)


def edge_mountains(world, rng):
    """Returns jagged foothills along the map's sides; their outer sides lie on the domain's boundary."""
    for side, start, end, deep in (("left", 128, 196, 15), ("left", 205, 262, 11), ("bottom", 150, 232, 16),
                                   ("bottom", 246, 322, 12), ("top", 92, 132, 10), ("left", 0, 34, 11),
                                   ("bottom", 22, 64, 9)):
        ridge, steps = [], max(5, round((end - start) / 6))
        for k in range(steps + 1):
            bow = math.sin(math.pi * k / steps)
            ridge.append((start + (end - start) * k / steps + rng.uniform(-1.5, 1.5),
                          deep * (0.15 + 0.85 * bow) * rng.uniform(0.7, 1.25)))
        ring = [(start, 0.0)] + ridge + [(end, 0.0)]
        if side == "left":
            ring = [(v, u) for u, v in ring]
        elif side == "top":
            ring = [(u, HEIGHT - v) for u, v in ring]
        world.polygon("mountains", ring)


def ridge(world, rng, stops, width):
    """Returns a mountain chain along a line: broad, irregular, pointed at its ends."""
    left, right = [], []
    for (ax, ay), (bx, by) in zip(stops, stops[1:]):
        length = math.hypot(bx - ax, by - ay)
        steps = max(2, round(length / 6))
        for k in range(steps):
            t = k / steps
            left.append((ax + (bx - ax) * t, ay + (by - ay) * t, -(by - ay) / length, (bx - ax) / length))
    total = len(left)
    spine, left = left, []
    for k, (x, y, nx, ny) in enumerate(spine):
        bow = min(1.0, 0.25 + 3.0 * min(k, total - 1 - k) / total)
        a, b = (width / 2 * bow * rng.uniform(0.65, 1.3) for _ in range(2))
        left.append((x + nx * a, y + ny * a))
        right.append((x - nx * b, y - ny * b))
    world.polygon("mountains", left + [stops[-1]] + right[::-1])


def ridges(world, rng):
    ridge(world, rng, [(168, 52), (178, 84), (172, 120), (148, 153)], 13)
    ridge(world, rng, [(128, 178), (152, 196), (160, 222), (150, 246)], 12)
    ridge(world, rng, [(208, 112), (213, 140), (206, 172), (186, 204)], 12)
    ridge(world, rng, [(228, 62), (252, 76), (262, 98)], 10)
    ridge(world, rng, [(28, 186), (52, 196), (78, 192)], 10)


def rocks(world, rng):
    """Returns groups of boulders that touch each other."""
    for x, y, spread, count in ((132, 158, 8, 5), (184, 240, 7, 5), (238, 112, 8, 6), (96, 226, 8, 5),
                                (290, 50, 8, 5), (186, 22, 6, 4), (120, 262, 6, 4), (196, 330, 7, 4)):
        for _ in range(count):
            angle, reach = rng.uniform(0, 2 * math.pi), spread * math.sqrt(rng.random())
            world.polygon("rocks", blob(rng, x + reach * math.cos(angle), y + reach * math.sin(angle),
                                        rng.uniform(2.2, 5.0), rng.randint(5, 8), 0.22, rng.uniform(1.0, 1.3),
                                        rng.uniform(0, math.pi)))


def forests(world, rng):
    """Returns groves of small, irregular crowns, some of which overlap."""
    for x, y, spread, count in ((46, 166, 17, 20), (196, 96, 17, 22), (118, 322, 19, 22), (262, 30, 20, 16),
                                (178, 288, 15, 14), (100, 196, 13, 12), (226, 18, 14, 10), (146, 30, 13, 10),
                                (30, 232, 13, 12), (180, 158, 12, 13)):
        grown = 0
        for _ in range(900):
            angle, reach = rng.uniform(0, 2 * math.pi), spread * math.sqrt(rng.random())
            size = rng.uniform(1.3, 2.9)
            tx, ty = x + reach * math.cos(angle), y + 0.85 * reach * math.sin(angle)
            if grown < 1.6 * count and world.is_free(tx, ty, size * rng.uniform(0.55, 1.15)):
                world.polygon("forests", blob(rng, tx, ty, size, rng.randint(5, 8), 0.3))
                grown += 1


def house(world, x, y, width, depth, degrees=0, notch=None):
    """Returns a rectangle, or an L if a notch (its width and depth) is cut from a corner; rotated about its middle."""
    w, d = width / 2, depth / 2
    ring = [(-w, -d), (w, -d), (w, d), (-w, d)]
    if notch:
        ring = [(-w, -d), (w, -d), (w, d - notch[1]), (w - notch[0], d - notch[1]), (w - notch[0], d), (-w, d)]
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    world.polygon("buildings", [(x + u * c - v * s, y + u * s + v * c) for u, v in ring])


def buildings(world):
    main = ((80, 76, 16, 14, 0, (5, 5)), (58, 96, 9, 7, 0), (70, 106, 8, 8, 0), (104, 94, 12, 7, 30),
            (108, 66, 10, 10, 45), (92, 50, 14, 7, 0, (6, 3)), (64, 52, 8, 8, 15), (46, 76, 7, 11, 0),
            (88, 106, 6, 5, 0), (116, 80, 6, 6, 0), (76, 38, 7, 5, -20), (48, 58, 6, 6, 0), (100, 110, 5, 5, 20),
            (94, 80, 4, 4, 0))
    expansion = ((60, 304, 13, 11, 0, (5, 4)), (80, 318, 8, 7, 0), (44, 286, 9, 6, -25), (76, 284, 7, 7, 40),
                 (40, 312, 6, 9, 0), (60, 326, 9, 5, 0))
    outposts = ((152, 268, 7, 5, 35), (112, 148, 6, 6, 0), (238, 246, 9, 6, 10), (226, 258, 5, 5, 10),
                (244, 258, 6, 4, 10, (3, 2)))
    for plan in main + expansion + outposts:
        house(world, *plan)


def minerals(world, rng):
    """Returns crystals in an arc beside each town hall, and a marker for the gatherers before each arc."""
    for x, y, radius, first, last, count in ((78, 76, 26, 150, 232, 7), (60, 304, 20, 95, 190, 6)):
        for k in range(count):
            degrees = first + (last - first) * k / (count - 1)
            angle = math.radians(degrees)
            cx, cy = x + radius * math.cos(angle), y + radius * math.sin(angle)
            if not world.is_free(cx, cy, 2.6):
                continue
            along = (-math.sin(angle), math.cos(angle))
            ring = [(cx + along[0] * u + math.cos(angle) * v, cy + along[1] * u + math.sin(angle) * v)
                    for u, v in ((-1.9, 0.2), (0.2, 1.5), (1.9, -0.1), (-0.1, -1.4 - rng.random() * 0.5))]
            world.polygon("minerals", ring)


def walls(world):
    """Returns fences and the ruins of a fort. Some cross each other, and some run into the rocks."""
    for chain in (
            [(84, 150), (94, 158), (110, 160)], [(66, 158), (72, 152), (74, 146)],
            [(100, 252), (112, 246), (126, 250), (134, 262)], [(116, 240), (122, 262)],
            [(226, 240), (222, 270), (234, 274)], [(242, 272), (256, 266), (254, 250)], [(218, 252), (230, 262)],
            [(196, 68), (214, 78), (222, 70)], [(206, 66), (216, 84)],
            [(140, 92), (152, 100), (150, 112)], [(136, 106), (158, 96)],
            [(14, 262), (24, 254), (40, 250)], [(150, 300), (158, 314), (152, 330)], [(146, 318), (164, 322)],
            [(180, 132), (190, 137), (199, 130), (213, 135)]):
        world.wall("walls", chain)


def posts(world):
    for x, y in ((102, 152), (150, 156), (190, 228), (112, 284), (240, 130), (272, 120), (22, 150), (228, 40),
                 (122, 352), (84, 64)):
        world.point("watch posts", x, y)


def draw():
    rng = random.Random(20090)
    world = Map()
    world.lane(12, (84, 64), (94, 140), (118, 172), (112, 214), (140, 270), (160, 290), (225, 300))
    world.lane(10, (84, 64), (94, 140), (140, 140), (180, 140), (200, 214), (246, 250))
    cliff(world, rng, 82, 78, 58, ((74, 15),))
    cliff(world, rng, 60, 304, 41, ((-38, 13), (-120, 7)), 5.5)
    water(world, rng)
    edge_mountains(world, rng)
    ridges(world, rng)
    buildings(world)
    minerals(world, rng)
    walls(world)
    rocks(world, rng)
    forests(world, rng)
    posts(world)
    return world.text()


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    if len(sys.argv) == 2:
        with open(sys.argv[1], "w", encoding="ascii", newline="\n") as out:
            out.write(draw())
    else:
        sys.stdout.write(draw())


if __name__ == "__main__":
    main()
