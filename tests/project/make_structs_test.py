"""Tests scripts/make_structs.py: a new field of a query needs one line in the table, and reaches every language."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
import make_structs  # noqa: E402 (found by the line above)

TABLE = (ROOT / "bindings/structs.toml").read_text(encoding="utf-8")
LINE = '  { name = "wants_time",'
TRIAL = '  { name = "first_trial", type = "TYPE", default = "DEFAULT", doc = "an experiment" },\n'


def made_with(kind, default):
    """Returns the generated files of a table with one more field of a path query."""
    line = TRIAL.replace("TYPE", kind).replace(', default = "DEFAULT"', f', default = "{default}"' if default else "")
    return dict(make_structs.make(make_structs.load(TABLE.replace(LINE, line + LINE, 1))))


class MakeStructsTest(unittest.TestCase):
    def test_the_committed_files_are_those_of_the_table(self):
        for name, text in make_structs.make(make_structs.load(TABLE)):
            self.assertEqual((ROOT / name).read_text(encoding="utf-8"), text, f"{name}: run scripts/make_structs.py")

    def test_a_new_field_reaches_every_language(self):
        for kind, default in (("double", "0.0"), ("bool", "false"), ("Point?", None), ("double?", None), ("Agent", "{}")):
            with self.subTest(kind):
                made = made_with(kind, default)
                self.assertEqual(len(made), 5)
                for name, text in made.items():
                    self.assertNotEqual(text, (ROOT / name).read_text(encoding="utf-8"), name)
                self.assertIn(" first_trial;", made["bindings/c/waywright.h"])
                self.assertIn("result.first_trial = ", made["bindings/c/structs.hpp"])
                self.assertIn("result.first_trial = first_trial;", made["bindings/python/src/structs.hpp"])
                stubs = made["bindings/python/waywright/_core.pyi"]
                self.assertEqual(stubs.count("        first_trial: "), 3)  # find_path, find_paths, PathSearch.begin
                typescript = made["bindings/wasm/src/structs.ts"]
                self.assertIn("  readonly firstTrial?: ", typescript)
                self.assertIn("struct + layout.firstTrial", typescript)

    def test_a_flag_says_whether_an_optional_field_is_set(self):
        made = made_with("double?", None)
        self.assertIn("  ww_bool has_first_trial;", made["bindings/c/waywright.h"])
        self.assertIn("if (is_set(given.has_first_trial)) result.first_trial", made["bindings/c/structs.hpp"])
        self.assertIn("put.flag(struct + layout.hasFirstTrial, true)", made["bindings/wasm/src/structs.ts"])

    def test_a_struct_that_the_c_header_lacks_is_an_error(self):
        with self.assertRaisesRegex(SystemExit, "has 0 structs ww_nothing"):
            dict(make_structs.make(make_structs.load(TABLE.replace("[RayHit]", "[Nothing]", 1))))


if __name__ == "__main__":
    unittest.main()
