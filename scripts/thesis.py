#!/usr/bin/env python3
"""Runs the experiments of Chen's thesis that measure time, and prints and draws their results.

usage: thesis.py PROGRAM FOLDER [EXPERIMENT...]

PROGRAM is waywright_thesis. The results of each experiment are written to FOLDER/EXPERIMENT.json, then to a Markdown table
on standard output (by bench_ratios.py) and, for experiments that the thesis draws, to FOLDER/thesis_EXPERIMENT.svg. Without
a name, runs all experiments:

  exactness    the cost of exactness: the largest sizes, nine times each, the arithmetics in turn
  location     experiment 2: where walks start, queries
  insertion    experiment 3: where walks start, insertions
  points       experiment 4: points under each arithmetic
  constraints  experiment 5: constraints under each arithmetic
  moving       experiment 6: the moving square under each arithmetic
  rationals    GMP's rationals alone beside the library's arithmetic, once each, because they are slow
"""

import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent
LARGEST = (
    r"(^points/10000|uniform_points/10000|short_segments/8000|long_segments/400|random_segments/1000"
    r"|moving_square_[a-z0-9]+/8000|rts/20000)"
)
ARITHMETICS = "(waywright|double|interval_exact)/"

# The benchmarks of each experiment, and the number of repetitions.
EXPERIMENTS = {
    "exactness": (f"{LARGEST}/{ARITHMETICS}", 9),
    "location": ("^location/", 5),
    "insertion": ("^insertion/", 5),
    "points": (f"^points/[0-9]+/{ARITHMETICS}", 5),
    "constraints": (f"_segments/[0-9]+/{ARITHMETICS}", 3),
    "moving": (f"^moving_square_[a-z0-9]+/[0-9]+/{ARITHMETICS}", 3),
    "rationals": (f"{LARGEST}/(waywright|rational)/", 1),
}


def run(program, folder, name):
    benchmark_filter, repetitions = EXPERIMENTS[name]
    result = folder / f"{name}.json"
    command = [
        program,
        f"--benchmark_filter={benchmark_filter}",
        f"--benchmark_repetitions={repetitions}",
        "--benchmark_enable_random_interleaving",
        f"--benchmark_out={result}",
        "--benchmark_out_format=json",
    ]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    print(f"\n## {name}\n", flush=True)
    subprocess.run([SCRIPTS / "bench_ratios.py", result], check=True)
    subprocess.run([SCRIPTS / "thesis_figures.py", folder, folder], check=True)


def main(arguments):
    names = arguments[2:] or list(EXPERIMENTS)
    if len(arguments) < 2 or not set(names) <= set(EXPERIMENTS):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    folder = Path(arguments[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        run(arguments[0], folder, name)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
