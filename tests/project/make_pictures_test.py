#!/usr/bin/env python3
"""Tests scripts/make_pictures.py with copies of the docs; each copy has one fault.

usage: make_pictures_test.py COMMAND DRAW_UNITS
"""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
import make_pictures  # noqa: E402 (found by the line above)

DRAW_UNITS = sys.argv.pop()
COMMAND = sys.argv.pop()


class MakePicturesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = make_pictures.draw_all(ROOT, COMMAND, DRAW_UNITS)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copytree(ROOT / "docs", self.root / "docs")

    def faults(self, texts=None):
        return make_pictures.faults_of(self.root, self.texts if texts is None else texts)

    def test_pictures_are_up_to_date(self):
        self.assertEqual(self.faults(), [])
        self.assertGreaterEqual(len(self.texts), 7)

    def test_every_picture_is_shown_somewhere(self):
        pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
        text = "".join(page.read_text(encoding="utf-8") for page in pages)
        for name in self.texts:
            self.assertIn(f"images/{name}.png", text)

    def test_another_picture_is_noticed(self):
        faults = self.faults({**self.texts, "demo": self.texts["demo"] + b" "})
        self.assertEqual(len(faults), 1)
        self.assertIn("docs/images/demo.png: is stale", faults[0])

    def test_a_picture_changed_by_hand_is_noticed(self):
        with open(self.root / "docs/images/units.png", "ab") as picture:
            picture.write(b" ")
        self.assertIn("docs/images/units.png: was changed by hand", self.faults()[0])

    def test_a_missing_picture_is_noticed(self):
        (self.root / "docs/images/dark.png").unlink()
        self.assertIn("docs/images/dark.png: is missing", self.faults()[0])

    def test_a_picture_that_nothing_draws_is_noticed(self):
        texts = {name: text for name, text in self.texts.items() if name != "queries"}
        self.assertIn("docs/images/queries.png: nothing draws it", self.faults(texts)[0])

    def test_a_length_that_the_text_tells_wrong_is_noticed(self):
        page = self.root / "docs/paths.md"
        page.write_text(page.read_text(encoding="utf-8").replace("| 366.88 |", "| 366.89 |"), encoding="utf-8")
        self.assertEqual(self.faults(), ["docs/paths.md: its table lacks the length 366.88, which its picture shows"])


if __name__ == "__main__":
    unittest.main()
