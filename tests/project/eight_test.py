#!/usr/bin/env python3
"""Tests scripts/eight.py, without running benchmarks.

usage: eight_test.py
"""

import sys
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))

import eight


def fake(folder, output, errors, status=0):
    """Returns a program that stands for valgrind."""
    program = Path(folder) / "valgrind"
    program.write_text(f"#!/bin/sh\necho '{output}'\necho '{errors}' >&2\nexit {status}\n")
    program.chmod(0o755)
    return program


class EightTest(unittest.TestCase):
    def counted(self, output, errors, status=0):
        with TemporaryDirectory() as folder:
            return eight.instructions("bench", "rts/9/waywright", str(fake(folder, output, errors, status)))

    def test_reads_the_count_of_callgrind(self):
        self.assertEqual(self.counted("rts/9/waywright/iterations:1 5 ns", "==7== Collected : 1234567"), 1234567)

    def test_a_benchmark_that_did_not_run_is_an_error(self):
        for output, errors, status in [
            ("Failed to match any benchmarks", "==7== Collected : 12", 0),
            ("rts/9/waywright/iterations:1", "no count", 0),
            ("rts/9/waywright/iterations:1", "==7== Collected : 12", 1),
        ]:
            with self.assertRaises(SystemExit):
                self.counted(output, errors, status)

    def test_prints_ratios_and_their_sum(self):
        lines = eight.table("1234abcd", {"one": (1000, 900), "two": (3000, 3300)}).splitlines()
        self.assertEqual(lines[0], "| benchmark | 1234abcd | tree | ratio |")
        self.assertEqual(lines[2:], ["| one | 1,000 | 900 | 0.9000 |", "| two | 3,000 | 3,300 | 1.1000 |",
                                     "| sum | 4,000 | 4,200 | 1.0500 |"])


if __name__ == "__main__":
    unittest.main()
