"""Tests the recipes in packaging/ without vcpkg and without Conan.

CMake runs the vcpkg port with simple replacements for vcpkg's functions, which record their arguments. The Conan recipe runs
with a replacement for the module conan.
"""

import json
import re
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VCPKG = ROOT / "packaging" / "vcpkg" / "waywright"
CONAN = ROOT / "packaging" / "conan"

VCPKG_FUNCTIONS = """
cmake_minimum_required(VERSION 3.22)
set(CURRENT_PACKAGES_DIR @FOLDER@)
set(PORT waywright)
function(note)
  file(APPEND @FOLDER@/calls "${ARGN}\\n")
endfunction()
function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES")
  list(GET arg_FEATURES 1 option)
  set(${arg_OUT_FEATURE_OPTIONS} -D${option}=ON PARENT_SCOPE)
endfunction()
foreach(name vcpkg_cmake_configure vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_copy_pdbs
             vcpkg_copy_tools vcpkg_install_copyright)
  cmake_language(EVAL CODE "function(${name})\\n note(${name} \\${ARGN})\\n endfunction()")
endforeach()
set(FEATURES tools)
include(@PORT@/portfile.cmake)
"""


def project_version():
    header = (ROOT / "include" / "waywright" / "version.hpp").read_text(encoding="utf-8")
    return re.search(r'#define WAYWRIGHT_VERSION "([^"]+)"', header).group(1)


def project_options():
    listing = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return set(re.findall(r"^option\((\w+)", listing, re.MULTILINE))


class Vcpkg(unittest.TestCase):
    def test_manifest(self):
        manifest = json.loads((VCPKG / "vcpkg.json").read_text(encoding="utf-8"))
        self.assertEqual(manifest["name"], "waywright")
        self.assertEqual(manifest["version"], project_version())
        self.assertIn("boost-multiprecision", manifest["dependencies"])
        self.assertEqual(set(manifest["features"]), {"tools"})

    def test_port(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "port.cmake"
            script.write_text(VCPKG_FUNCTIONS.replace("@FOLDER@", folder).replace("@PORT@", VCPKG.as_posix()))
            subprocess.run(["cmake", "-P", str(script)], check=True)
            calls = (Path(folder) / "calls").read_text(encoding="utf-8").splitlines()
            self.assertTrue((Path(folder) / "share" / "waywright" / "usage").is_file())
        configure = next(call for call in calls if call.startswith("vcpkg_cmake_configure;")).split(";")
        source = Path(configure[configure.index("SOURCE_PATH") + 1])
        self.assertEqual(source, ROOT)
        options = {argument[2:].split("=")[0] for argument in configure if argument.startswith("-D")}
        self.assertIn("WAYWRIGHT_BUILD_TOOLS", options)
        self.assertLessEqual(options, project_options())
        licence = next(call for call in calls if call.startswith("vcpkg_install_copyright;")).split(";")[-1]
        self.assertTrue(Path(licence).is_file())


class Toolchain:
    def __init__(self, recipe):
        self.cache_variables = {}
        recipe.toolchain = self

    def generate(self):
        pass


class Nothing:
    def __init__(self, *_):
        pass

    def __getattr__(self, _):
        return lambda *_arguments, **_options: None


def copy(recipe, pattern, src, dst):
    recipe.copied.append((pattern, [path for path in Path(src).glob(pattern)]))


def load_recipe():
    """Returns the class of the recipe. The replaced module contains only those names of Conan 2 that the recipe uses."""
    modules = {
        "conan": {"ConanFile": type("ConanFile", (), {})},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": lambda recipe, standard: None},
        "conan.tools.cmake": {"CMake": Nothing, "CMakeDeps": Nothing, "CMakeToolchain": Toolchain, "cmake_layout": Nothing},
        "conan.tools.files": {"copy": copy, "load": lambda recipe, path: Path(path).read_text(encoding="utf-8"), "rmdir": Nothing},
    }
    for name, members in modules.items():
        module = types.ModuleType(name)
        module.__dict__.update(members)
        sys.modules[name] = module
    names = {}
    exec(compile((CONAN / "conanfile.py").read_text(encoding="utf-8"), "conanfile.py", "exec"), names)
    recipe = names["WaywrightConan"]()
    recipe.recipe_folder = str(CONAN)
    recipe.copied = []
    return recipe


class Conan(unittest.TestCase):
    def test_version(self):
        recipe = load_recipe()
        recipe.set_version()
        self.assertEqual(recipe.version, project_version())

    def test_exports_all_that_the_build_reads(self):
        recipe = load_recipe()
        recipe.export_sources_folder = ""
        recipe.export_sources()
        for pattern, files in recipe.copied:
            self.assertTrue(files, pattern)
        self.assertIn("src/*", [pattern for pattern, _ in recipe.copied])

    def test_options(self):
        recipe = load_recipe()
        recipe.generate()
        self.assertFalse(recipe.toolchain.cache_variables["WAYWRIGHT_BUILD_TOOLS"])
        self.assertLessEqual(set(recipe.toolchain.cache_variables), project_options())

    def test_program_that_tests_the_package_exists(self):
        listing = (CONAN / "test_package" / "CMakeLists.txt").read_text(encoding="utf-8")
        source = re.search(r"\$\{CMAKE_CURRENT_SOURCE_DIR\}/(\S+\.cpp)", listing).group(1)
        self.assertTrue((CONAN / "test_package" / source).is_file())


if __name__ == "__main__":
    unittest.main()
