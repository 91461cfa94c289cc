"""Carries out a world script through the Python package: the answers of ``waywright run``.

usage: run_script.py SCRIPT
"""

import json
import sys
from pathlib import Path

import waywright


def number(value):
    """JSON of the command writes whole numbers without a fraction."""
    return int(value) if value == int(value) and abs(value) < 2**53 else value


def pair(point):
    return [number(float(value)) for value in point]


def locate(world, line):
    location = world.locate(line.start)
    return {"at": location.kind, "vertices": [pair(v) for v in location.vertices], "inside": location.polygons}


def ray(world, line):
    hit = world.ray(line.start, line.end, line.agent)
    if not hit:
        return {"hit": False}
    contact = {"contact": pair(hit.contact)} if line.has_radius else {}
    return {"hit": True, "at": pair(hit.at), **contact, "items": hit.items}


def disc(world, line):
    fit = world.fit_disc(line.start, line.agent)
    return {"free": fit.fits, "items": fit.items}


def nearest(world, line):
    fit = world.nearest_fit(line.start, line.agent, goal=line.end if line.has_goal else None)
    return {"found": True, "at": pair(fit.at)} if fit else {"found": False}


def pieces_of(path):
    pairs = zip(path.points, path.points[1:])
    yield from ({"line": [*pair(a), *pair(b)]} for a, b in pairs)
    for piece in path.pieces if path.length > 0 else ():
        if piece["kind"] == 0:
            yield {"line": [*pair(piece["from"]), *pair(piece["to"])]}
        else:
            numbers = [piece["radius"], piece["start_angle"], piece["end_angle"]]
            yield {"arc": [*pair(piece["centre"]), *(number(float(each)) for each in numbers)]}


def find_path(world, line):
    path = world.find_path(
        line.start, line.end, line.agent, line.algorithm or "optimal", end_tolerance=line.end_tolerance
    )
    if path:
        answer = {"found": True, "length": number(path.length), "pieces": list(pieces_of(path))}
        for name in ("moved_start", "moved_goal"):
            if getattr(path, name):
                answer[name] = [pair(point) for point in getattr(path, name)]
        return answer
    answer = {"found": False, "reason": path.status}
    if path.status != "no-path":
        answer["items"] = path.blockers
    if path.widest and path.widest.is_limited:
        items = sorted({*path.widest.from_items, *path.widest.to_items})
        gap = [pair(point) for point in path.widest.gap]
        answer["widest"] = {"radius": number(path.widest.radius), "gap": gap, "items": items}
    return answer


def check(world, line):
    fault = world.validate()
    return {"ok": True} if fault is None else {"ok": False, "fault": fault}


def tick(world, line):
    if line.items_hash in (None, world.items_hash):
        return None
    return {"tick": line.tick, "same": False, "expected": line.items_hash, "computed": world.items_hash}


QUERIES = {
    "locate": locate,
    "ray": ray,
    "disc": disc,
    "nearest": nearest,
    "path": find_path,
    "clear": lambda world, line: {"clear": world.is_clear(line.shape.points)},
    "check": check,
    "hash": lambda world, line: {"items": world.items_hash, "mesh": world.mesh_hash()},
    "tick": tick,
}

CHANGES = {
    "remove": lambda world, line: world.remove(line.id),
    "replace": lambda world, line: world.replace(line.id, line.shape),
    "mark": lambda world, line: world.mark(),
    "rewind": lambda world, line: world.rewind(line.tick),
}


def carry_out(world, line):
    """Makes the change of a line, or returns the answer of its query."""
    if line.word in QUERIES:
        return QUERIES[line.word](world, line)
    if line.word in CHANGES:
        CHANGES[line.word](world, line)
    else:
        world.insert(line.shape, line.id)
    return None


def answers(text, name):
    """Yields the answers of a script."""
    script = waywright.parse_script(text, name)
    needs_bridges = any((line.word == "path" or line.has_goal) and line.agent.radius > 0 for line in script.lines)
    world = waywright.World(script.domain, keep_bridges=needs_bridges)
    world.keep_history(sum(line.word == "mark" for line in script.lines))
    for line in script.lines:
        try:
            answer = carry_out(world, line)
        except waywright.WaywrightError as error:
            answer = {"error": error.code, "message": error.message}
        if answer is not None:
            yield {"line": line.line, "op": line.word, **answer}


if __name__ == "__main__":
    for each in answers(Path(sys.argv[1]).read_text(encoding="utf-8"), sys.argv[1]):
        print(json.dumps(each))
