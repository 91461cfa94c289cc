#!/usr/bin/env python3
"""Tests scripts/bench_ratios.py with the results of small runs.

usage: bench_ratios_test.py
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "bench_ratios.py"
FIXED = {"repetitions": 1, "threads": 1, "iterations": 1, "real_time": 2.0, "cpu_time": 1.5, "time_unit": "ms"}


def run_of(name, index, **counters):
    return {"run_name": name + "/iterations:1", "family_index": index, "run_type": "iteration", **FIXED, **counters}


def tables(*runs):
    """Returns what the script prints for the runs, as lists of cells."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "runs.json"
        file.write_text(json.dumps({"benchmarks": list(runs)}), encoding="utf-8")
        output = subprocess.run([sys.executable, SCRIPT, file], check=True, capture_output=True, text=True).stdout
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in output.splitlines()]


class BenchRatiosTest(unittest.TestCase):
    def test_compares_the_medians_of_two_contenders(self):
        mine = [run_of("moves/9/waywright", 0, per_op=time, vertices=12) for time in (2e-6, 1e-6, 3e-6)]
        theirs = [run_of("moves/9/rival", 1, per_op=8e-6, vertices=12)]
        rows = tables(*mine, *theirs)
        self.assertEqual(rows[2], ["moves/9", "waywright", "2", "50 %", "12", ""])
        self.assertEqual(rows[3], ["moves/9", "rival", "8", "", "12", "0.25"])

    def test_lists_the_counters_of_benchmarks_without_a_time_of_an_operation(self):
        runs = [run_of("publish/9/released", 0, p50_us=time, vertices=12) for time in (5, 7, 6)]
        rows = tables(*runs)
        self.assertEqual(rows[-1], ["publish/9/released", "p50_us 6, vertices 12"])

    def test_prints_one_table_if_all_benchmarks_have_a_time_of_an_operation(self):
        rows = tables(run_of("moves/9/waywright", 0, per_op=1e-6, vertices=12))
        self.assertEqual(len(rows), 3)


if __name__ == "__main__":
    unittest.main()
