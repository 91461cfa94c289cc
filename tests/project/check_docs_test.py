"""Tests which pages scripts/check_docs.py refuses."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_docs.py"

CODE = """int main() {
  if (a) {
    b();
  }
  c();
}
"""


class CheckDocs(unittest.TestCase):
    def check(self, guide, readme=""):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "docs" / "guides").mkdir(parents=True)
            (root / "examples").mkdir()
            (root / "examples" / "game.cpp").write_text(CODE, encoding="utf-8")
            (root / "examples" / "large").mkdir()
            (root / "examples" / "large" / "game.hpp").write_text("struct Game {\n  int ticks;\n};\n", encoding="utf-8")
            (root / "examples" / "game.txt").write_text("first\nsecond\nthird\n", encoding="utf-8")
            (root / "README.md").write_text(readme, encoding="utf-8")
            (root / "docs" / "guides" / "guide.md").write_text(guide, encoding="utf-8")
            result = subprocess.run([sys.executable, SCRIPT, root], check=False, capture_output=True, text=True)
            return result.returncode, result.stdout

    def refuse(self, guide, line):
        status, output = self.check(guide)
        self.assertEqual(status, 1)
        self.assertTrue(output.startswith(f"docs/guides/guide.md:{line}: "), output)

    def test_takes_quotes_whatever_their_indentation(self):
        for lines in ("if (a) {\n  b();\n}\n", "  if (a) {\n    b();\n  }\n", CODE):
            self.assertEqual(self.check(f"So:\n\n```cpp\n{lines}```\n"), (0, ""))

    def test_takes_quotes_of_output_and_other_languages(self):
        self.assertEqual(self.check("```text\nsecond\nthird\n```\n\n```sh\nrm nothing\n```\n"), (0, ""))

    def test_takes_quotes_of_examples_of_several_files(self):
        self.assertEqual(self.check("```cpp\nstruct Game {\n  int ticks;\n};\n```\n"), (0, ""))

    def test_refuses_code_that_no_example_has(self):
        self.refuse("So:\n\n```cpp\nd();\n```\n", 4)

    def test_refuses_lines_that_are_not_consecutive(self):
        self.refuse("```cpp\nif (a) {\n  c();\n}\n```\n", 2)

    def test_refuses_another_indentation_within(self):
        self.refuse("```cpp\nif (a) {\nb();\n}\n```\n", 2)

    def test_refuses_output_that_no_example_prints(self):
        self.refuse("```text\nfirst\nthird\n```\n", 2)

    def test_refuses_links_that_lead_nowhere(self):
        self.refuse("[one](../../README.md#part)\n[two](missing.md)\n", 2)
        status, output = self.check("", readme="[docs](docs), [it](docs/it.md), [web](https://example.org/it)\n")
        self.assertEqual((status, output), (1, "README.md:1: the link to docs/it.md leads nowhere\n"))


if __name__ == "__main__":
    unittest.main()
