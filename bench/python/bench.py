"""Measures the Python package against the C++ library, and beside other packages.

usage: bench.py PROGRAM [--points N] [--queries N] [--map FILE]

PROGRAM is waywright_python_bench. Both read the same random numbers. Prints a table: the best of 5 runs each. With --map,
also measures the queries of a map on a Dask cluster with one and with two workers. `./dev python bench` runs it.
"""

import argparse
import json
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import waywright

ROUNDS = 5
SIDE = 1000.0


def best(function, rounds=ROUNDS):
    """Returns the shortest time of some calls, in seconds."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def make_data(points, queries):
    generator = np.random.default_rng(1)
    walls = generator.uniform(3, SIDE - 3, (2000, 2))
    walls = np.stack([walls, walls + generator.uniform(-3, 3, walls.shape)], axis=1).reshape(-1, 2)
    starts = generator.uniform(0, SIDE, (queries, 2))
    goals = np.clip(starts + generator.uniform(-20, 20, starts.shape), 0, SIDE)
    return {"points": generator.uniform(0, SIDE, (points, 2)), "walls": walls, "starts": starts, "goals": goals}


def times_of_cpp(program, data):
    with tempfile.TemporaryDirectory() as folder:
        for name, array in data.items():
            (Path(folder) / name).write_bytes(array.tobytes())
        output = subprocess.run([program, folder], check=True, capture_output=True, text=True).stdout
    return {line["name"]: line["seconds"] for line in map(json.loads, output.splitlines())}


def load_points(points):
    world = waywright.World((0, 0, SIDE, SIDE))
    world.insert_points(points)


def times_of_python(data):
    world = waywright.World((0, 0, SIDE, SIDE))
    world.insert_ragged("segment", data["walls"], np.arange(0, len(data["walls"]) + 1, 2))
    starts, goals = data["starts"], data["goals"]
    start_pairs, goal_pairs = ([tuple(pair) for pair in array.tolist()] for array in (starts, goals))
    pairs = list(zip(start_pairs, goal_pairs))

    def paths():
        for start, goal in pairs:
            world.find_path(start, goal)

    def rays():
        for start, goal in pairs:
            world.ray(start, goal)

    disc = waywright.Agent(radius=0.5)

    def discs():
        for start in start_pairs:
            world.fit_disc(start, disc)

    return {
        "load points": best(lambda: load_points(data["points"])),
        "path batch": (batch := best(lambda: world.find_paths(starts, goals))),
        "path batch, new memory": batch,
        "path single": best(paths, 3),
        "ray single": best(rays, 3),
        "fit_disc single": best(discs, 3),
    }


def compare_triangulations(points):
    """Prints the times to triangulate points beside other packages."""
    mesh_only = best(lambda: waywright.World((0, 0, SIDE, SIDE), keep_abstraction=False).insert_points(points), 3)
    print(f"waywright, without the path abstraction: {mesh_only:.3f} s")
    try:
        from scipy.spatial import Delaunay
    except ImportError:
        print("scipy is not installed")
    else:
        print(f"scipy.spatial.Delaunay (Qhull): {best(lambda: Delaunay(points), 2):.3f} s")
    try:
        from matplotlib.tri import Triangulation
    except ImportError:
        print("matplotlib is not installed")
    else:
        print(f"matplotlib.tri.Triangulation (Qhull): {best(lambda: Triangulation(*points.T), 2):.3f} s")


def measure_cluster(map_file, count):
    import distributed

    from waywright.distributed import DistributedWorld

    world = waywright.World.from_scene(waywright.read_scene(map_file))
    generator = np.random.default_rng(2)
    x0, y0, x1, y1 = world.domain
    ends = generator.uniform((x0, y0), (x1, y1), (40 * count, 2))
    ends = ends[world.fit_discs(ends, waywright.Agent())][: 2 * count]
    count = len(ends) // 2
    times = {}
    for workers in (1, 2):
        with distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster, distributed.Client(cluster) as client:
            client.wait_for_workers(workers)
            everywhere = DistributedWorld(client, world)
            everywhere.find_paths(ends[:400], ends[400:800], chunk_size=50)  # the world reaches the workers
            times[workers] = best(lambda: everywhere.find_paths(ends[:count], ends[count : 2 * count]), 2)
    print(f"{count} queries on {Path(map_file).name}: {times[1]:.2f} s on one worker, {times[2]:.2f} s on two, "
          f"{times[1] / times[2]:.2f} times as fast")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--queries", type=int, default=1_000_000)
    parser.add_argument("--map")
    options = parser.parse_args()
    data = make_data(options.points, options.queries)
    cpp, python = times_of_cpp(options.program, data), times_of_python(data)
    print("| measurement | C++ | Python | quotient | difference for each call |")
    print("| --- | --- | --- | --- | --- |")
    for name, seconds in python.items():
        each = f"{(seconds - cpp[name]) / options.queries * 1e6:.2f} µs" if "single" in name else ""
        print(f"| {name} | {cpp[name]:.3f} s | {seconds:.3f} s | {seconds / cpp[name]:.2f} | {each} |")
    compare_triangulations(data["points"])
    if options.map:
        measure_cluster(options.map, 100_000)


if __name__ == "__main__":
    main()
