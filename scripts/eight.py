#!/usr/bin/env python3
"""Compares the instructions of eight benchmarks between a commit and the working tree.

usage: eight.py [COMMIT]

Runs each benchmark under valgrind's callgrind, in the tree and in a clean checkout of COMMIT (default: HEAD) in
build/eight, and prints a Markdown table of the counts and of their ratio (below 1: the tree needs fewer instructions).
Counts do not depend on other work of the machine. They include the start of the program and the preparation of the
workload. The build of a checkout stays, for the next comparison with the same commit.
"""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = "build/bench/bench/waywright_bench"
BENCHMARKS = (
    "bulk_points/10000/waywright",
    "random_points/10000/waywright",
    "short_segments/1000/waywright",
    "random_segments/100/waywright",
    "moving_square_30/1000/waywright",
    "rts/20000/waywright_for_paths",
    "path_squares/500/waywright_optimal",
    "path_squares/500/waywright_tra_radius_5",
)


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def checkout_of(commit):
    """Returns the folder of the commit's files, which it makes if it does not exist."""
    folder = ROOT / "build/eight" / commit[:12]
    if not (folder / "dev").exists():
        folder.mkdir(parents=True, exist_ok=True)
        archive = subprocess.run(["git", "archive", commit], cwd=ROOT, check=True, capture_output=True).stdout
        subprocess.run(["tar", "-x", "-C", folder], input=archive, check=True)
    return folder


def build(tree, jobs):
    """Builds the benchmarks of the tree and returns the program."""
    subprocess.run(["cmake", "--preset", "bench", "--log-level=NOTICE"], cwd=tree, check=True, stdout=sys.stderr)
    subprocess.run(
        ["cmake", "--build", "--preset", "bench", "--target", "waywright_bench", "--parallel", str(jobs)],
        cwd=tree,
        check=True,
        stdout=sys.stderr,
    )
    return tree / PROGRAM


def instructions(program, benchmark, valgrind="valgrind"):
    command = [
        valgrind,
        "--tool=callgrind",
        "--callgrind-out-file=/dev/null",
        program,
        f"--benchmark_filter=^{benchmark}/iterations",
    ]
    result = subprocess.run(command, capture_output=True, text=True)
    collected = re.search(r"Collected\s*:\s*(\d+)", result.stderr)
    if result.returncode != 0 or not collected or f"{benchmark}/iterations" not in result.stdout:
        sys.exit(f"eight.py: {program} {benchmark}:\n{result.stdout}{result.stderr}")
    return int(collected[1])


def table(title, pairs):
    """Returns the Markdown table of {benchmark: (count of the commit, count of the tree)}."""
    rows = [*pairs.items(), ("sum", tuple(map(sum, zip(*pairs.values()))))]
    lines = [f"| benchmark | {title} | tree | ratio |", "| --- | ---: | ---: | ---: |"]
    lines += [f"| {name} | {before:,} | {after:,} | {after / before:.4f} |" for name, (before, after) in rows]
    return "\n".join(lines)


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    commit = git("rev-parse", "--verify", (sys.argv[1:] or ["HEAD"])[0] + "^{commit}")
    jobs = int(os.environ.get("WAYWRIGHT_JOBS") or os.cpu_count())
    programs = [build(tree, jobs) for tree in (checkout_of(commit), ROOT)]
    with ThreadPoolExecutor(jobs) as pool:
        counts = list(pool.map(lambda run: instructions(*run), [(p, name) for name in BENCHMARKS for p in programs]))
    print(table(commit[:8], {name: (counts[2 * i], counts[2 * i + 1]) for i, name in enumerate(BENCHMARKS)}))


if __name__ == "__main__":
    main()
