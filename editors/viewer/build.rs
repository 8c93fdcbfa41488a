//! Puts the viewer into the programs, when it was built (`npm run build`).

#![allow(clippy::disallowed_methods)] // it runs while building, not in the product

use std::env;
use std::fs;
use std::path::Path;

fn main() {
    let folder = env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let folder = Path::new(&folder);
    let viewer = folder.join("dist/viewer.js");
    println!("cargo::rerun-if-changed=build.rs");
    // a file that is not there would make cargo run this each time
    if let Some(watched) = [viewer.as_path(), folder]
        .into_iter()
        .find(|path| path.exists())
    {
        println!("cargo::rerun-if-changed={}", watched.display());
    }
    let out = Path::new(&env::var("OUT_DIR").unwrap_or_default()).join("viewer.rs");
    let text = match viewer.is_file() {
        true => format!("Some(include_bytes!({:?}))", viewer.display().to_string()),
        false => "None".to_owned(),
    };
    if let Err(error) = fs::write(&out, text) {
        println!("cargo::error={} cannot be written: {error}", out.display());
    }
}
