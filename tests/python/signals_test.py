"""Ctrl-C ends long calls: SIGINT in a child process."""

import signal
import subprocess
import sys
import time

import pytest

START = """
import numpy as np, time, waywright
generator = np.random.default_rng(1)
world = waywright.World((0, 0, 1000, 1000))
a = generator.uniform(2, 998, (4000, 2))
points = np.stack([a, a + generator.uniform(-2, 2, (4000, 2))], axis=1).reshape(-1, 2)
world.insert_ragged("segment", points, np.arange(0, 8001, 2))
queries = generator.uniform(2, 998, (2, 3_000_000, 2))
many = generator.uniform(0, 1000, (3_000_000, 2))
before = world.items_hash
print("ready", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", world.items_hash == before, world.find_path((1, 1), (999, 999)).found, flush=True)
else:
    print("done", flush=True)
"""
CALLS = [
    "world.find_paths(queries[0], queries[1], wants_points=False)",
    "world.find_paths(queries[0], queries[1], wants_points=False, threads=3)",
    "world.insert_points(many)",
]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process")
@pytest.mark.parametrize("call", CALLS)
def test_ctrl_c_ends_a_long_call_and_changes_nothing(python, call):
    with subprocess.Popen([python, "-c", START.format(call=call)], stdout=subprocess.PIPE, text=True) as child:
        try:
            assert child.stdout.readline() == "ready\n"
            time.sleep(0.3)
            began = time.monotonic()
            child.send_signal(signal.SIGINT)
            assert child.stdout.readline() == "interrupted True True\n"
            assert time.monotonic() - began < 5
        finally:
            child.kill()
