//! How far configuration files reach: what they extend, combine and match.

use std::path::Path;

use xacro_lsp::base::limits::*;
use xacro_lsp::workspace::config::Pattern;

use super::{LINK, check};

#[test]
fn config_chain() {
    let mut files = vec![(
        "xacro-lint.toml".to_owned(),
        "extend = 'c0.toml'\n".to_owned(),
    )];
    files.extend((0..20).map(|n| {
        (
            format!("c{n}.toml"),
            format!("extend = 'c{}.toml'\n", n + 1),
        )
    }));
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    let said = check(LINK, &files);
    assert!(
        said.contains("c14.toml:1:")
            && said.contains("more than 16 configuration files extend each other"),
        "{said}"
    );
}

#[test]
fn matrix_runs() {
    let digits = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]";
    let config = |axes: usize| {
        let args: Vec<String> = (0..axes).map(|n| format!("a{n} = {digits}")).collect();
        format!(
            "[[roots]]\nfile = 'robot.urdf'\nargs = {{ {} }}\n",
            args.join(", ")
        )
    };
    let said = check(LINK, &[("xacro-lint.toml", &config(9))]);
    assert!(
        said.contains("1000000000 combinations of arguments; only 1000 are used"),
        "{said}"
    );
    let said = check(LINK, &[("xacro-lint.toml", &config(3))]);
    assert!(!said.contains("combinations"), "{said}");
}

#[test]
fn glob_alternatives() {
    let names: Vec<String> = (0..70).map(|n| format!("a{n}")).collect();
    let pattern = Pattern::new(&format!("{{{}}}", names.join(",")), Path::new("/w"));
    let matches = |n: usize| pattern.matches(&Path::new("/w").join(format!("a{n}")));
    assert!(matches(0) && matches(GLOB_ALTERNATIVES - 1) && !matches(GLOB_ALTERNATIVES));
}
