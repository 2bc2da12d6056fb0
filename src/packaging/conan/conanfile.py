# SPDX-License-Identifier: MIT
"""Conan 2 recipe of shd. conandata.yml beside it names the archive of each version: README.md of the folder above."""
from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd, stdcpp_library
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir
from conan.tools.gnu import PkgConfigDeps

required_conan_version = ">=2.0"


class ShdConan(ConanFile):
    name = "shd"
    description = "Texture filtering, shading and software rasterisation on the CPU behind a C ABI"
    license = "MIT"
    topics = ("texture-filtering", "rasterizer", "rendering", "shading")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {
        "shared": [True, False],
        "fPIC": [True, False],
        "simd": ["auto", "all", "few", "scalar"],
        "with_tbb": [True, False],
        "with_color": [True, False],
        "with_io": [True, False],
        "with_scene": [True, False],
    }
    default_options = {
        "shared": False,
        "fPIC": True,
        "simd": "auto",
        "with_tbb": True,
        "with_color": False,
        "with_io": False,
        "with_scene": False,
    }
    implements = ["auto_shared_fpic"]

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration(f"os: shd is built on Linux alone, not on {self.settings.os}")
        if self.options.with_scene and not self.options.with_io:
            raise ConanInvalidConfiguration("with_scene: needs with_io=True, because libshd_scene loads textures")
        if self.settings.compiler.get_safe("cppstd"):
            check_min_cppstd(self, 17)

    def layout(self):
        cmake_layout(self, src_folder="src")

    def requirements(self):
        self.requires("highway/[>=1.0.3 <2]")
        if self.options.with_tbb:
            self.requires("onetbb/[>=2021.7 <2023]")
        if self.options.with_color:
            self.requires("opencolorio/[>=2.1 <3]")
        if self.options.with_io:
            self.requires("openimageio/[>=2.4 <3]")
        if self.options.with_scene:
            self.requires("assimp/[>=5.2 <6]")
            self.requires("nlohmann_json/[>=3.9 <4]")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["SHD_SIMD"] = str(self.options.simd)
        for variable, value in {
            "SHD_WITH_TBB": self.options.with_tbb,
            "SHD_WITH_OCIO": self.options.with_color,
            "SHD_WITH_IO": self.options.with_io,
            "SHD_WITH_SCENE": self.options.with_scene,
            "SHD_WITH_EIGEN": False,
            "SHD_WITH_EMBREE": False,
            "SHD_WITH_OPENVDB": False,
            "SHD_WITH_ZSTD": False,
            "SHD_WITH_ZLIB": False,
            "SHD_WITH_ASTCENC": False,
            "SHD_BUILD_EXAMPLES": False,
            "SHD_BUILD_TESTS": False,
            "SHD_BUILD_TOOLS": False,
        }.items():
            toolchain.cache_variables[variable] = bool(value)
        toolchain.generate()
        deps = CMakeDeps(self)
        # The names of Highway's own CMake package.
        deps.set_property("highway", "cmake_file_name", "hwy")
        deps.set_property("highway", "cmake_target_name", "hwy::hwy")
        deps.generate()
        PkgConfigDeps(self).generate()  # OpenColorIO, OpenImageIO and assimp are found by pkg-config

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, self.package_folder + "/licenses")
        CMake(self).install()
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):  # Conan writes files of its own for consumers
            rmdir(self, f"{self.package_folder}/{folder}")

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "shd")
        self._component("shd", "shd", ["highway::highway"] + (["onetbb::onetbb"] if self.options.with_tbb else []))
        self.cpp_info.components["shd"].system_libs = ["m", "pthread"]
        library = stdcpp_library(self)
        if library and not self.options.shared:
            self.cpp_info.components["shd"].system_libs.append(library)  # for programs in C
        cpp = self.cpp_info.components["cpp"]
        cpp.set_property("cmake_target_name", "shd::cpp")
        cpp.requires, cpp.libs = ["shd"], []
        if self.options.with_color:
            self._component("color", "shd_color", ["shd", "opencolorio::opencolorio"])
        if self.options.with_io:
            self._component("io", "shd_io", ["shd", "openimageio::openimageio"])
            self.cpp_info.components["io"].system_libs = ["dl"]
        if self.options.with_scene:
            self._component("scene", "shd_scene", ["io", "assimp::assimp", "nlohmann_json::nlohmann_json"])

    def _component(self, name, library, requires):
        component = self.cpp_info.components[name]
        component.set_property("cmake_target_name", f"shd::{name}")
        component.set_property("pkg_config_name", library)
        component.libs, component.requires = [library], requires
