"""Tests scripts/check_portable.py with small source trees, portable and not."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_portable.py"
sys.path.insert(0, str(SCRIPT.parent))
sys.dont_write_bytecode = True
from check_portable import faults_of  # noqa: E402 (found by the line above)

# Each entry: a file, and a line that the script must refuse there.
BAD = [
    ("src/mesh/mesh.hpp", "void fetch(int* p) { __builtin_prefetch(p); }"),
    ("src/mesh/mesh.hpp", "[[gnu::always_inline]] inline void f() {}"),
    ("src/mesh/mesh.hpp", "[[nodiscard, gnu::noinline]] bool f();"),
    ("src/mesh/mesh.hpp", "int f() __attribute__((noinline));"),
    ("src/mesh/mesh.hpp", "unsigned __int128 product;"),
    ("src/mesh/mesh.hpp", "#if defined(_MSC_VER)"),
    ("src/mesh/mesh.hpp", "#pragma GCC diagnostic push"),
    ("src/mesh/mesh.hpp", "long double sum = 0;"),
    ("src/mesh/mesh.hpp", "unsigned long count = 0;"),
    ("src/mesh/mesh.hpp", "const long count = 0;"),
    ("src/exact/bits.hpp", "return std::bit_cast<double>(bits);"),
    ("src/path/best.cpp", "std::ranges::sort(list);"),
    ("src/path/best.cpp", "return std::hypot(x, y);"),
    ("src/io/text.cpp", "std::to_chars(a, b, x, std::chars_format::general, 5);"),
    ("include/waywright/world.hpp", "__attribute__((visibility(\"default\"))) void f();"),
    ("tools/waywright/main.cpp", "#include <unistd.h>"),
    ("tools/waywright/main.cpp", "std::signal(SIGPIPE, SIG_IGN);"),
    ("tools/waywright/main.cpp", "#if defined(_WIN32)"),
    ("tests/determinism/print_meshes.cpp", "#include <sys/resource.h>"),
    ("src/base/number_text.hpp", "__builtin_bit_cast(To, from);"),
]
# Each entry: a file, and a line that the script must accept there.
GOOD = [
    ("src/base/compiler.hpp", "__builtin_prefetch(address);"),
    ("include/waywright/export.hpp", "#define WAYWRIGHT_API __attribute__((visibility(\"default\")))"),
    ("tools/waywright/platform.cpp", "#include <unistd.h>"),
    ("src/mesh/mesh.hpp", "// __builtin_prefetch is in base"),
    ("src/mesh/mesh.hpp", 'say("a long way, __int128");'),
    ("src/mesh/mesh.hpp", "/* __int128\n__GNUC__ */ int x;"),
    ("src/mesh/mesh.hpp", "#pragma once"),
    ("src/mesh/mesh.hpp", "long long hundredths = std::llround(x); int along = 0;"),
    ("src/base/compiler.hpp", "return std::bit_cast<To>(from);"),
    ("tools/waywright/scenario.cpp", "return std::pow(10.0, digits);"),
]


class CheckPortable(unittest.TestCase):
    def test_what_is_not_portable_is_refused_where_it_stands(self):
        for name, line in BAD:
            with self.subTest(file=name, line=line):
                faults = list(faults_of(name, f"// first line\n{line}\n"))
                self.assertEqual(len(faults), 1, faults)
                self.assertTrue(faults[0].startswith(f"{name}:2: "), faults[0])

    def test_what_is_portable_passes(self):
        for name, line in GOOD:
            with self.subTest(file=name, line=line):
                self.assertEqual(list(faults_of(name, line + "\n")), [])

    def test_faults_are_printed_and_fail(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertEqual(self.run_check(root).returncode, 2)
            file = Path(root) / "src" / "mesh" / "mesh.hpp"
            file.parent.mkdir(parents=True)
            file.write_text("int x;\n", encoding="utf-8")
            self.assertEqual(self.run_check(root).returncode, 0)
            file.write_text("long x;\n", encoding="utf-8")
            result = self.run_check(root)
            self.assertEqual(result.returncode, 1)
            self.assertTrue(result.stdout.startswith("src/mesh/mesh.hpp:1: 'long' "), result.stdout)

    def run_check(self, root):
        return subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True, check=False)


if __name__ == "__main__":
    unittest.main()
