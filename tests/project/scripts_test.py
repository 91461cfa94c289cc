#!/usr/bin/env python3
"""Imports each Python script of scripts/, so that a name which another script no longer has is an error here.

usage: scripts_test.py
"""

import importlib
import sys
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCRIPTS))


class ScriptsTest(unittest.TestCase):
    def test_each_script_finds_the_names_that_it_imports(self):
        names = sorted(script.stem for script in SCRIPTS.glob("*.py"))
        self.assertIn("latency", names)
        for name in names:
            with self.subTest(name):
                importlib.import_module(name)


if __name__ == "__main__":
    unittest.main()
