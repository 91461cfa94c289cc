"""Tests scripts/check_layers.py with small source trees, valid and invalid."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"
sys.path.insert(0, str(SCRIPT.parent))
sys.dont_write_bytecode = True
from check_layers import ALL, OF_ITS_ROOMS, PUBLIC_HEADERS, ROOMS, Checker  # noqa: E402 (found by the line above)

GOOD = {
    "include/waywright/point.hpp": "#pragma once\n",
    "include/waywright/id.hpp": "#include <cstdint>\n",
    "include/waywright/world.hpp": '#include <vector>\n#include "waywright/point.hpp"\n',
    "src/base/compiler.hpp": "#include <immintrin.h>\n",
    "src/base/number_text.hpp": '#include <fmt/format.h>\n#include "base/compiler.hpp"\n',
    "src/text/words.hpp": '#include "base/number_text.hpp"\n#include "waywright/id.hpp"\n',
    "src/threads/thread_team.hpp": '#include <thread>\n#include "base/compiler.hpp"\n',
    "src/exact/sign.hpp": '#include "base/compiler.hpp"\n#include <boost/multiprecision/cpp_int.hpp>\n#include "waywright/point.hpp"\n',
    "src/mesh/mesh.hpp": '#include <array>\n#include "waywright/id.hpp"\n',
    "src/locate/walk.hpp": '#include "exact/sign.hpp"\n#include "mesh/mesh.hpp"\n',
    "src/delaunay/flip.hpp": '#include "locate/walk.hpp"\n',
    "src/delaunay/flip.inl": '#include "delaunay/flip.hpp"\n',
    "src/constraint/cut.hpp": '#include "delaunay/flip.hpp"\n#include "mesh/mesh.hpp"\n',
    "src/constraint/dump.cpp": '#include "constraint/cut.hpp"\n#include "text/words.hpp"\n',
    "src/nav/core.hpp": '#include "constraint/cut.hpp"\n',
    "src/path/funnel.hpp": '#include "nav/core.hpp"\n',
    "src/io/script.cpp": '#include "io/script.hpp"\n#include "text/words.hpp"\n#include "waywright/world.hpp"\n',
    "src/io/script.hpp": "#pragma once\n",
    "src/world/world.cpp": '#include "world/world_impl.hpp"\n#include "path/funnel.hpp"\n',
    "src/world/world_impl.hpp": '#include "constraint/cut.hpp"\n',
    "tools/waywright/main.cpp": '#include <fmt/format.h>\n#include "base/number_text.hpp"\n#include "run.hpp"\n#include "waywright/world.hpp"\n',
    "tools/waywright/run.hpp": "#pragma once\n",
    "examples/game.cpp": '#include "waywright/world.hpp"\n',
    "bench/walk.cpp": '#include <benchmark/benchmark.h>\n#include "locate/walk.hpp"\n',
    "bench/workloads.hpp": '#include "waywright/world.hpp"\n',
    "bench/thesis/places.hpp": "#include <gmpxx.h>\n",
    "bench/thesis/places.cpp": '#include "thesis/places.hpp"\n#include "workloads.hpp"\n',
    "tests/exact/sign_test.cpp": '#include <gtest/gtest.h>\n#include "exact/sign.hpp"\n#include "support/scenes.hpp"\n',
    "tests/support/scenes.hpp": '#include "waywright/world.hpp"\n',
    "tests/support/oracle_adapter.hpp": '#include "oracle/oracle.hpp"\n#include "waywright/world.hpp"\n',
    "tests/oracle/oracle.hpp": "#include <boost/multiprecision/cpp_int.hpp>\n",
    "tests/oracle/oracle.cpp": '#include "oracle/oracle.hpp"\n',
}

# Each entry: a file, and an include that the script must refuse there.
BAD = [
    ("src/base/compiler.hpp", '"mesh/mesh.hpp"'),
    ("src/base/compiler.hpp", '"waywright/id.hpp"'),
    ("src/text/words.hpp", '"exact/sign.hpp"'),
    ("src/threads/thread_team.hpp", '"mesh/mesh.hpp"'),
    ("src/exact/sign.hpp", '"mesh/mesh.hpp"'),
    ("src/exact/sign.hpp", '"locate/walk.hpp"'),
    ("src/exact/sign.hpp", '"waywright/world.hpp"'),
    ("src/mesh/mesh.hpp", '"exact/sign.hpp"'),
    ("src/mesh/mesh.hpp", '"waywright/point.hpp"'),
    ("src/mesh/mesh.hpp", "<boost/version.hpp>"),
    ("src/locate/walk.hpp", '"delaunay/flip.hpp"'),
    ("src/delaunay/flip.hpp", '"constraint/cut.hpp"'),
    ("src/constraint/cut.hpp", '"nav/core.hpp"'),
    ("src/constraint/cut.hpp", '"io/script.hpp"'),
    ("src/nav/core.hpp", '"path/funnel.hpp"'),
    ("src/path/funnel.hpp", '"io/script.hpp"'),
    ("src/path/funnel.hpp", '"world/world_impl.hpp"'),
    ("src/io/script.cpp", '"path/funnel.hpp"'),
    ("src/io/script.cpp", '"constraint/cut.hpp"'),
    ("src/io/script.cpp", '"world/world_impl.hpp"'),
    ("src/io/script.cpp", "<fmt/format.h>"),
    ("src/world/world.cpp", '"io/script.hpp"'),
    ("src/locate/walk.hpp", '"../constraint/cut.hpp"'),
    ("src/locate/walk.hpp", "<exact/sign.hpp>"),
    ("src/locate/walk.hpp", '"support/scenes.hpp"'),
    ("include/waywright/world.hpp", '"exact/sign.hpp"'),
    ("include/waywright/world.hpp", '"base/compiler.hpp"'),
    ("include/waywright/id.hpp", '"waywright/world.hpp"'),
    ("include/waywright/world.hpp", '"world/world_impl.hpp"'),
    ("include/waywright/world.hpp", "<boost/version.hpp>"),
    ("tools/waywright/main.cpp", '"mesh/mesh.hpp"'),
    ("tools/waywright/main.cpp", '"world/world_impl.hpp"'),
    ("examples/game.cpp", '"base/compiler.hpp"'),
    ("bench/walk.cpp", '"path/funnel.hpp"'),
    ("bench/walk.cpp", '"io/script.hpp"'),
    ("tests/oracle/oracle.cpp", '"waywright/point.hpp"'),
    ("tests/oracle/oracle.cpp", '"exact/sign.hpp"'),
    ("tests/oracle/oracle.cpp", '"support/scenes.hpp"'),
    ("src/exact/sign.hpp", "WAYWRIGHT_HEADER"),
    ("src/graph/new.hpp", "<vector>"),
]


class CheckLayers(unittest.TestCase):
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

    def run_check(self):
        return subprocess.run(
            [sys.executable, SCRIPT, self.root], check=False, capture_output=True, text=True, encoding="utf-8"
        )

    def test_a_good_tree_passes(self):
        result = self.run_check()
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_each_bad_include_is_refused_where_it_stands(self):
        for name, include in BAD:
            with self.subTest(file=name, include=include):
                self.write(name, f"// first line\n#  include {include}\n")
                faults = Checker(self.root).check()
                line = 1 if name.startswith("src/graph") else 2
                self.assertEqual(len(faults), 1, faults)
                self.assertTrue(faults[0].startswith(f"{name}:{line}: "), faults[0])
                if name in GOOD:
                    self.write(name, GOOD[name])
                else:
                    (self.root / name).unlink()

    def test_faults_are_printed_and_fail(self):
        self.write("src/mesh/mesh.hpp", '#include "exact/sign.hpp"\n')
        result = self.run_check()
        self.assertEqual(
            (result.returncode, result.stdout), (1, "src/mesh/mesh.hpp:1: src/mesh may not include src/exact\n")
        )

    def test_headers_that_include_each_other_are_refused(self):
        self.write("src/delaunay/flip.hpp", '#include "delaunay/flip.inl"\n')
        faults = Checker(self.root).check()
        self.assertEqual(len(faults), 2, faults)
        self.assertIn("includes itself", faults[0])

    def test_a_wrong_root_is_an_error(self):
        self.root = self.root / "absent"
        self.assertEqual(self.run_check().returncode, 2)


class ArchitectureTest(unittest.TestCase):
    """ARCHITECTURE.md describes the rooms as ROOMS defines them."""

    page = (SCRIPT.parents[1] / "ARCHITECTURE.md").read_text(encoding="utf-8")

    def test_the_table_of_rooms_equals_the_definition(self):
        table = self.page[self.page.index("| room | subject |") :].split("\n\n")[0]
        rows = [re.findall(r"[^|]+", line) for line in table.splitlines()[2:]]
        described = {}
        owned = {}
        for name, _, rooms, public, own in rows:
            headers = frozenset(f"{header}.hpp" for header in re.findall("`([^`]+)`", public))
            described[name.strip(" `")] = (
                frozenset(re.findall("`([^`]+)`", rooms)),
                {"all": ALL, "of its rooms": OF_ITS_ROOMS}.get(public.strip(), headers),
            )
            if own.strip() != "none":
                owned[Path(name.strip(" `")).name] = set(re.findall("`([^`]+)`", own))
        self.assertEqual(described, {name: (room.rooms, room.public) for name, room in ROOMS.items()})
        self.assertEqual(owned, PUBLIC_HEADERS)

    def test_the_sketch_shows_each_room_of_the_library(self):
        sketch = self.page[self.page.index("## Rooms") :].split("```")[1]
        shown = set(re.findall(r"(src/\w+|include/waywright)/", sketch))
        rooms = {name for name in ROOMS if name.startswith(("src/", "include/"))}
        folders = {f"src/{folder.name}" for folder in (SCRIPT.parents[1] / "src").iterdir() if folder.is_dir()}
        self.assertEqual(shown, rooms)
        self.assertEqual(folders, {name for name in rooms if name.startswith("src/")})


if __name__ == "__main__":
    unittest.main()
