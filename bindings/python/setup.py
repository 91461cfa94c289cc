"""Builds the module waywright._core with the CMake of the repository: pip install ./bindings/python

Needs CMake, a C++20 compiler, Boost's headers and pybind11. Downloads nothing.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def version():
    text = (ROOT / "include" / "waywright" / "version.hpp").read_text(encoding="utf-8")
    return re.search(r'#define WAYWRIGHT_VERSION "([^"]+)"', text)[1]


def pybind11_arguments():
    """Says where the CMake files of pybind11 are, if the Python package says it. Otherwise CMake looks for them."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


class CMakeBuild(build_ext):
    """Builds the library and the module in the folder that setuptools gives. WAYWRIGHT_CMAKE_ARGS adds options."""

    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "Python_EXECUTABLE": sys.executable,
            "BUILD_SHARED_LIBS": "OFF",
            "WAYWRIGHT_BUILD_PYTHON": "ON",
            "WAYWRIGHT_BUILD_TESTS": "OFF",
            "WAYWRIGHT_BUILD_TOOLS": "OFF",
            "WAYWRIGHT_BUILD_EXAMPLES": "OFF",
            "WAYWRIGHT_INSTALL": "OFF",
        }
        arguments = [f"-D{name}={value}" for name, value in options.items()] + pybind11_arguments()
        arguments += os.environ.get("WAYWRIGHT_CMAKE_ARGS", "").split()
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *arguments], check=True)
        jobs = os.environ.get("WAYWRIGHT_JOBS") or str(os.cpu_count() or 1)
        command = ["cmake", "--build", build, "--config", "Release", "--target", "waywright_python", "--parallel", jobs]
        subprocess.run(command, check=True)
        built = next((build / "bindings" / "python" / "waywright").rglob("_core*" + target.suffix))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built), str(target))


setup(
    version=version(),
    ext_modules=[Extension("waywright._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
