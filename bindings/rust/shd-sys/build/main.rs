// SPDX-License-Identifier: MIT
//! Finds libshd, or builds it.
//!
//! - `SHD_LIB_DIR=folder`: links the libshd of this folder.
//! - Feature `pkg-config`: links the libshd that pkg-config names.
//! - Otherwise: builds a static libshd from its sources with CMake.
//!
//! Libraries of components (features `color`, `io`, `scene`, `embree`) are linked in the first two cases only.
mod found;
mod source;

use std::path::Path;
use std::{env, process};

/// Ends the build with a message.
fn fail(message: &str) -> ! {
    eprintln!("shd-sys: {message}");
    process::exit(1);
}

fn has_feature(name: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{}", name.to_uppercase().replace('-', "_"))).is_some()
}

/// Names of the libraries of the enabled features, libshd last.
fn libraries() -> Vec<String> {
    let components = ["scene", "io", "color", "embree"].into_iter().filter(|name| has_feature(name));
    components.map(|name| format!("shd_{name}")).chain(["shd".to_string()]).collect()
}

fn main() {
    if !Path::new("src/api.rs").exists() {
        fail("src/api.rs is not in git: run `python3 bindings/generate.py rust` in the clone");
    }
    println!("cargo:rerun-if-changed=build");
    println!("cargo:rerun-if-env-changed=SHD_LIB_DIR");
    if let Some(folder) = env::var_os("SHD_LIB_DIR") {
        found::link_folder(&folder);
    } else if has_feature("pkg-config") {
        found::link_packages();
    } else {
        let components: Vec<String> = libraries().into_iter().filter(|name| name != "shd").collect();
        if !components.is_empty() {
            fail(&format!(
                "{} must be installed: set SHD_LIB_DIR to the folder of the libraries, or enable pkg-config",
                components.join(" and ")
            ));
        }
        source::build();
    }
}
