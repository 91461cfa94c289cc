"""What scripts/extract_examples.py extracts from headers."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "extract_examples.py"

HEADER = """#pragma once

/// A class.
///
/// @code{.cpp}
/// world.remove(7).value();
///
/// const int sum = 2 + 2;  // == 4
/// @endcode
class A {
  /// @code{.cpp}
  /// if (true) {
  ///   draw();
  /// }
  /// @endcode
};
"""


class ExtractExamples(unittest.TestCase):
    def extract(self, header):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.hpp").write_text(header, encoding="utf-8")
            code_file = Path(folder) / "code.cpp"
            result = subprocess.run([sys.executable, SCRIPT, folder, code_file], check=False, capture_output=True)
            return result.returncode, code_file.read_text() if code_file.exists() else result.stderr.decode()

    def test_makes_a_function_of_each_example(self):
        status, code = self.extract(HEADER)
        self.assertEqual(status, 0)
        self.assertEqual(code.count(": Fixture {"), 2)
        self.assertIn('run<a_6>("a_6");', code)
        self.assertIn('run<a_12>("a_12");', code)
        self.assertIn("if (true) {\n  draw();\n}\n", code)

    def test_keeps_the_line_numbers_of_the_header(self):
        self.assertRegex(self.extract(HEADER)[1], r'#line 6 ".*a\.hpp"\nworld\.remove\(7\)\.value\(\);\n')

    def test_checks_the_values_that_examples_name(self):
        self.assertIn('const int sum = 2 + 2;  // == 4\ncheck(sum == (4), "sum");\n', self.extract(HEADER)[1])

    def test_refuses_a_value_of_what_is_no_declaration(self):
        status, message = self.extract(HEADER.replace("const int sum = 2 + 2", "add(2, 2)"))
        self.assertEqual(status, 1)
        self.assertIn("a.hpp: the example of line 6: only a declaration", message)

    def test_refuses_an_example_without_end(self):
        status, message = self.extract(HEADER.replace("/// @endcode\nclass", "class"))
        self.assertEqual(status, 1)
        self.assertIn("a.hpp:9: the example of line 6 has no @endcode", message)

    def test_refuses_headers_without_examples(self):
        status, message = self.extract("#pragma once\n")
        self.assertEqual(status, 1)
        self.assertIn("no header has an example", message)


if __name__ == "__main__":
    unittest.main()
