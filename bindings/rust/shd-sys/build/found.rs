// SPDX-License-Identifier: MIT
//! Links libraries that exist.
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

use crate::{fail, libraries};

/// Links the libraries of a folder, shared ones if there are any.
pub fn link_folder(folder: &OsStr) {
    let folder = match Path::new(folder).canonicalize() {
        Ok(folder) => folder,
        Err(error) => fail(&format!("SHD_LIB_DIR: {}: {error}", Path::new(folder).display())),
    };
    println!("cargo:rustc-link-search=native={}", folder.display());
    for name in libraries() {
        let has = |file: String| folder.join(file).exists();
        if has(format!("lib{name}.so")) || has(format!("lib{name}.dylib")) || has(format!("{name}.lib")) {
            println!("cargo:rustc-link-lib=dylib={name}");
        } else if has(format!("lib{name}.a")) {
            println!("cargo:rustc-link-lib=static={name}");
            println!("cargo:rustc-link-lib=dylib=hwy");
            println!("cargo:rustc-link-lib=dylib=stdc++");
        } else {
            fail(&format!("SHD_LIB_DIR: {} has no lib{name}", folder.display()));
        }
    }
    // The crate `shd` reads DEP_SHD_RPATH and lets its tests and examples find the library.
    println!("cargo:rpath={}", folder.display());
}

/// Links what pkg-config prints for the libraries.
pub fn link_packages() {
    let names = libraries();
    let output = match Command::new("pkg-config").arg("--libs").args(&names).output() {
        Ok(output) => output,
        Err(error) => fail(&format!("pkg-config cannot be run: {error}. Install it (Debian: pkg-config)")),
    };
    if !output.status.success() {
        fail(&format!("pkg-config {}: {}", names.join(" "), String::from_utf8_lossy(&output.stderr).trim()));
    }
    for word in String::from_utf8_lossy(&output.stdout).split_whitespace() {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={folder}");
        } else if let Some(name) = word.strip_prefix("-l") {
            println!("cargo:rustc-link-lib=dylib={name}");
        }
    }
}
