"""Builds the sources that contain this recipe, with Conan 2. Run: conan create packaging/conan --build=missing"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"


class WaywrightConan(ConanFile):
    name = "waywright"
    description = "A dynamic, exact constrained Delaunay triangulation with pathfinding on top"
    license = "MIT"
    topics = ("delaunay-triangulation", "pathfinding", "navigation-mesh", "computational-geometry")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True, "boost/*:header_only": True}
    implements = ["auto_shared_fpic"]

    @property
    def _project(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        header = load(self, os.path.join(self._project, "include", "waywright", "version.hpp"))
        self.version = re.search(r'#define WAYWRIGHT_VERSION "([^"]+)"', header).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*"):
            copy(self, pattern, src=self._project, dst=self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        # Only the library's sources use Boost, and only its headers.
        self.requires("boost/[>=1.74.0]", headers=True, libs=False, visible=False)

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("C", "TESTS", "TOOLS", "EXAMPLES"):
            toolchain.cache_variables[f"WAYWRIGHT_BUILD_{part}"] = False
        toolchain.cache_variables["WAYWRIGHT_INSTALL"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        # Conan writes these files itself.
        for folder in (os.path.join("lib", "cmake"), os.path.join("lib", "pkgconfig"), "share"):
            rmdir(self, os.path.join(self.package_folder, folder))

    def package_info(self):
        self.cpp_info.libs = ["waywright"]
        self.cpp_info.set_property("cmake_file_name", "waywright")
        self.cpp_info.set_property("cmake_target_name", "waywright::waywright")
        self.cpp_info.set_property("pkg_config_name", "waywright")
        if self.options.shared:
            self.cpp_info.defines = ["WAYWRIGHT_SHARED"]
        elif self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["pthread"]
