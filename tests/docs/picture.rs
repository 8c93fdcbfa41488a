//! The picture of a terminal in the README and the book: what `check` prints about the broken example, in its colors.

use std::path::Path;

use anstyle_svg::Term;
use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

use crate::pages::{self, root};

/// Findings that the picture shows; `...` stands for the others. One fits on the first screen of the README.
const SHOWN: &[&str] = &["[missing-macro-param]"];
/// Colors of an old terminal, and softer ones.
const COLORS: &[(&str, &str)] = &[
    ("#000000", "#14161b"),
    ("#AAAAAA", "#e0e2ea"),
    ("#FF5555", "#ff7b7b"),
    ("#5555FF", "#8ab8ff"),
];
const EXAMPLE: &str = "docs/examples/broken_cell";

/// What `xacro-lint check` prints on a terminal.
fn printed() -> String {
    let vars = [("AMENT_PREFIX_PATH".to_owned(), "/none".to_owned())];
    let env = Environment {
        vars: vars.into(),
        cwd: root().to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut nothing = &b""[..];
    let mut io = Io::plain(&mut out, &mut err, &mut nothing);
    (io.color, io.color_out) = (true, true);
    cli::run(&["check".to_owned(), EXAMPLE.to_owned()], &env, &mut io);
    without_links(&(String::from_utf8(out).unwrap() + &String::from_utf8(err).unwrap()))
}

/// Terminals make links of some names; a picture does not.
fn without_links(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("\u{1b}]8;;") {
        kept.push_str(before);
        rest = after.split_once("\u{1b}\\").unwrap().1;
    }
    kept + rest
}

fn shown() -> String {
    let printed = printed();
    let parts: Vec<&str> = printed.trim_end().split("\n\n").collect();
    let (summary, findings) = parts.split_last().unwrap();
    let mut lines = vec![format!("\u{1b}[1m$ xacro-lint check {EXAMPLE}\u{1b}[0m\n")];
    for name in SHOWN {
        let finding = findings
            .iter()
            .find(|finding| finding.contains(name))
            .expect(name);
        lines.push(format!("{finding}\n"));
    }
    let left = findings.len() - SHOWN.len();
    lines.push(format!("... {left} more\n\n{summary}\n"));
    lines.join("\n")
}

#[test]
fn the_picture_of_the_terminal_is_what_is_printed() {
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(EXAMPLE).is_dir());
    let mut picture = Term::new().min_width_px(900).render_svg(&shown());
    for (old, new) in COLORS {
        assert!(picture.contains(old), "{old}");
        picture = picture.replace(old, new);
    }
    pages::up_to_date("docs/images/check.svg", &picture);
}
