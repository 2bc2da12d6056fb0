// SPDX-License-Identifier: MIT
//! Lets tests and examples find a libshd that lies in a folder of its own.
fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if let Some(folder) = std::env::var_os("DEP_SHD_RPATH") {
        if cfg!(unix) {
            println!("cargo:rustc-link-arg=-Wl,-rpath,{}", folder.to_string_lossy());
        }
    }
}
