"""Conan 2: `conan create pkgconfig/conan` in a checkout of contdyn."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Contdyn(ConanFile):
    name = "contdyn"
    description = "Ropes, hair, sheets and water on regular lattices"
    package_type = "shared-library"  # the archive comes along: CMake's target contdyn::contdyn_static
    settings = "os", "arch", "compiler", "build_type"

    def _sources(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        text = load(self, os.path.join(self._sources(), "include", "contdyn", "base.h"))
        self.version = ".".join(re.findall(r"#define CD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "include/*", "src/*", "bindings/CMakeLists.txt", "bindings/cpp/*",
                        "pkgconfig/contdyn.pc.in"):
            copy(self, pattern, self._sources(), self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def configure(self):
        self.settings.rm_safe("compiler.cppstd")  # C outside: what its C++ inside is made of binds nobody
        self.settings.rm_safe("compiler.libcxx")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(CONTDYN_TESTS=False, CONTDYN_REPORT=False)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the library's own package files are used
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "contdyn")]
        self.cpp_info.libs = ["contdyn"]
