"""Tests scripts/check_headers.py with small source trees."""

import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_headers.py"
sys.path.insert(0, str(SCRIPT.parent))
sys.dont_write_bytecode = True
from check_headers import check  # noqa: E402 (found by the line above)

GOOD = {
    "src/exact/sign.hpp": "#pragma once\n",
    "src/exact/gap.cpp": '#include "exact/sign.hpp"\n#include "exact/whole.hpp"\n',
    "src/exact/sweep.cpp": '#include "exact/sign.hpp"\n',
    "src/exact/whole.hpp": "#pragma once\n",
    "tests/exact/whole_test.cpp": '#include "exact/whole.hpp"\n',
}


class CheckHeaders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in GOOD.items():
            self.write(name, text)

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def test_headers_with_two_users_or_a_test_pass(self):
        self.assertEqual(check(self.root), [])

    def test_a_header_with_one_user_is_refused(self):
        self.write("src/exact/sweep.cpp", "#include <vector>\n")
        self.assertEqual(check(self.root), ["src/exact/sign.hpp:1: only src/exact/gap.cpp includes this header"])

    def test_a_header_that_only_its_own_source_includes_is_refused(self):
        self.write("src/nav/core.hpp", "#pragma once\n")
        self.write("src/nav/core.cpp", '#include "nav/core.hpp"\n')
        self.assertEqual(check(self.root), ["src/nav/core.hpp:1: only src/nav/core.cpp includes this header"])

    def test_the_project_has_no_such_header(self):
        self.assertEqual(check(SCRIPT.parents[1]), [])


if __name__ == "__main__":
    unittest.main()
