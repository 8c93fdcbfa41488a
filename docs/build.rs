//! Lists the pages of the rules.

#![allow(clippy::disallowed_methods)] // it runs while building, not in the product

use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("rules");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut pages = Vec::<PathBuf>::new();
    for entry in fs::read_dir(&folder)? {
        pages.extend(
            [entry?.path()]
                .into_iter()
                .filter(|path| path.extension().is_some_and(|end| end == "md")),
        );
    }
    pages.sort();
    let mut text = "const RULES: &[(&str, &str)] = &[\n".to_owned();
    for page in &pages {
        let name = page.file_stem().unwrap_or_default().to_string_lossy();
        text.push_str(&format!(
            "    ({name:?}, include_str!({:?})),\n",
            page.display().to_string()
        ));
    }
    text.push_str("];\n");
    fs::write(
        Path::new(&env::var("OUT_DIR").unwrap_or_default()).join("rules.rs"),
        text,
    )
}
