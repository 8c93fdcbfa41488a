//! How the programs are linked.

// this is how a build script talks to cargo
#![allow(clippy::print_stdout, clippy::disallowed_methods)]

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let is = |variable: &str, value: &str| env::var(variable).is_ok_and(|found| found == value);
    // A program that may lie anywhere has 14,000 addresses to mend at each start, in pages that are copied for it: a
    // fifth of the time of a short run.
    if is("CARGO_CFG_TARGET_OS", "linux") && is("CARGO_CFG_TARGET_ENV", "gnu") {
        println!("cargo:rustc-link-arg-bins=-no-pie");
    }
}
