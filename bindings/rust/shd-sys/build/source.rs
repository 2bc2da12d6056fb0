// SPDX-License-Identifier: MIT
//! Builds a static libshd with CMake.
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::{fail, has_feature};

/// libshd alone is added to a project of its own, so that tests, examples and components are not configured. The
/// project writes the libraries that a program links into link.txt.
const PROJECT: &str = r#"cmake_minimum_required(VERSION 3.23)
project(shd_sys LANGUAGES C CXX)
add_subdirectory("${SHD_SOURCE}" shd)
find_package(hwy REQUIRED CONFIG)
set(lines "static $<TARGET_FILE:shd>\n" "shared $<TARGET_FILE:hwy::hwy>\n")
if(SHD_WITH_TBB)
  find_package(TBB REQUIRED CONFIG)
  list(APPEND lines "shared $<TARGET_FILE:TBB::tbb>\n")
endif()
list(JOIN lines "" lines)
file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/link.txt" CONTENT "${lines}")
"#;

/// The sources: those of the package, or those of the repository that this crate lies in.
fn find_source() -> PathBuf {
    let crate_folder = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR"));
    let places = [crate_folder.join("source"), crate_folder.join("../../..")];
    let is_source =
        |place: &&PathBuf| place.join("include/shd/shd.h").exists() && place.join("CMakeLists.txt").exists();
    match places.iter().find(is_source) {
        Some(place) => place.canonicalize().unwrap_or_else(|_| place.clone()),
        None => fail(
            "the sources of libshd are neither in source/ nor in the repository above. Set SHD_LIB_DIR to the folder \
             of an installed libshd, or enable the feature pkg-config",
        ),
    }
}

fn run(step: &str, command: &mut Command) {
    match command.status() {
        Ok(status) if status.success() => {}
        Ok(status) => fail(&format!("cmake cannot {step} libshd ({status}); its messages are above")),
        Err(error) => fail(&format!(
            "cmake cannot be run: {error}. Install it (Debian: cmake g++ libhwy-dev), or set SHD_LIB_DIR to the folder \
             of an installed libshd"
        )),
    }
}

fn switch(name: &str, is_on: bool) -> String {
    format!("-D{name}={}", if is_on { "ON" } else { "OFF" })
}

/// Links the library of a line of link.txt: its kind and its path.
fn link(line: &str) {
    let (kind, path) = line.split_once(' ').unwrap_or(("shared", line));
    let path = Path::new(path);
    let stem = path.file_name().and_then(|name| name.to_str()).and_then(|name| name.split('.').next()).unwrap_or("");
    if let Some(folder) = path.parent() {
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    let kind = if kind == "static" { "static" } else { "dylib" };
    println!("cargo:rustc-link-lib={kind}={}", stem.strip_prefix("lib").unwrap_or(stem));
}

pub fn build() {
    let source = find_source();
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("libshd");
    for part in ["src", "include", "CMakeLists.txt"] {
        println!("cargo:rerun-if-changed={}", source.join(part).display());
    }
    println!("cargo:rerun-if-env-changed=CMAKE");
    if let Err(error) = fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join("CMakeLists.txt"), PROJECT)) {
        fail(&format!("{} cannot be written: {error}", folder.display()));
    }
    let cmake = env::var_os("CMAKE").unwrap_or_else(|| "cmake".into());
    let build = folder.join("build");
    let mut configure = Command::new(&cmake);
    configure.arg("-S").arg(&folder).arg("-B").arg(&build).arg(format!("-DSHD_SOURCE={}", source.display()));
    // libshd is always optimised: a debug build of a program shall not render ten times slower.
    configure.arg("-DCMAKE_BUILD_TYPE=Release").arg(switch("SHD_WITH_TBB", has_feature("tbb")));
    let off = ["BUILD_SHARED", "INSTALL", "BUILD_TESTS", "BUILD_EXAMPLES", "BUILD_TOOLS", "WITH_OCIO", "WITH_OIIO"];
    configure.args(off.map(|name| switch(&format!("SHD_{name}"), false))).arg("-DSHD_WITH_EMBREE=OFF");
    run("configure", &mut configure);
    let mut make = Command::new(&cmake);
    make.arg("--build").arg(&build).args(["--target", "shd", "--config", "Release"]);
    if let Some(jobs) = env::var_os("NUM_JOBS") {
        make.arg("--parallel").arg(jobs);
    }
    run("build", &mut make);
    match fs::read_to_string(build.join("link.txt")) {
        Ok(lines) => lines.lines().for_each(link),
        Err(error) => fail(&format!("link.txt, which cmake writes: {error}")),
    }
    println!("cargo:rustc-link-lib=dylib=stdc++");
    println!("cargo:include={}", source.join("include").display());
}
