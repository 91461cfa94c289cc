#!/usr/bin/env python3
"""Runs the experiments of Chen's thesis with small sizes.

usage: thesis_test.py PROGRAM

PROGRAM is waywright_thesis. Exact arithmetic must give the right answer in all in-circle tests and for all meshes. Doubles
must fail in some, otherwise the experiments would be too easy to show a difference.
"""

import json
import re
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop()


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def rows(*arguments):
    """Returns the table's rows below its head, as lists of cell texts."""
    lines = [line for line in run(*arguments).splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


class ThesisTest(unittest.TestCase):
    def test_exact_arithmetic_is_right_about_circles_where_doubles_are_not(self):
        table = rows("in_circle", "300")
        self.assertEqual([row[0] for row in table], [f"10^-{n}" for n in range(1, 18)])
        for _, _, doubles, intervals, _, ours in table:
            self.assertEqual((intervals, ours), ("0.0000 %", "0.0000 %"))
            self.assertRegex(doubles, r"^[0-9]+\.[0-9]{4} %$")
        self.assertTrue(any(row[2] != "0.0000 %" for row in table))

    def test_exact_arithmetic_survives_every_scene(self):
        right = {row[0]: row[1] for row in rows("survival", "20")}
        self.assertEqual(set(right), {"double", "interval + exact", "rationals", "Waywright"})
        for name in ("interval + exact", "rationals", "Waywright"):
            self.assertEqual(right[name], "20", name)

    def test_all_arithmetics_agree_on_points(self):
        report = json.loads(run("--benchmark_filter=^points/1000/", "--benchmark_format=json"))
        contenders = {}
        for result in report["benchmarks"]:
            self.assertNotIn("error_message", result)
            contenders[re.split("/", result["name"])[2]] = result["vertices"]
        self.assertEqual(set(contenders), {"waywright", "double", "interval_exact", "rational"})
        self.assertEqual(set(contenders.values()), {1004.0})


if __name__ == "__main__":
    unittest.main()
