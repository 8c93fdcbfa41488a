//! The command line of `expand`, as xacro reads it.

use super::assets::AssetOptions;

/// What `expand` was asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpandOptions {
    /// The input file; `-` is standard input.
    pub input: String,
    /// `name:=value`, stripped.
    pub args: Vec<(String, String)>,
    /// `-o`
    pub output: Option<String>,
    /// `--deps`
    pub deps: bool,
    /// `-i`
    pub in_order: bool,
    /// `--root-dir`
    pub root_dir: Option<String>,
    /// `-q`, `-v`, `--verbosity`; 1 by default.
    pub verbosity: i64,
    /// `--package-path`
    pub package_path: Vec<String>,
    /// `--source-map`
    pub source_map: Option<String>,
    /// `--check`
    pub check: Option<String>,
    /// What is done with the names of meshes and textures.
    pub assets: AssetOptions,
}

/// Why the command line cannot be carried out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UsageError {
    /// Help was asked for.
    Help,
    /// A wrong option or number of files: exit 2.
    Usage(String),
    /// A broken mapping: exit 1, as an uncaught exception of the reference.
    Mapping(String),
}

impl UsageError {
    /// What to tell the user.
    pub fn message(self) -> String {
        match self {
            UsageError::Mapping(message) | UsageError::Usage(message) => message,
            UsageError::Help => String::new(),
        }
    }
}

const LONG: [&str; 12] = [
    "--check",
    "--copy-assets-to",
    "--deps",
    "--inorder",
    "--relative-paths",
    "--root-dir",
    "--strip-protocols",
    "--verbosity",
    "--help",
    "--package-path",
    "--source-map",
    "--output",
];

/// A complaint about a path, with what to type where it looks like an argument.
pub(super) fn with_assignment(complaint: &str, path: &str) -> String {
    match path.split_once('=').filter(|(name, _)| is_name(name)) {
        Some((name, value)) => format!("{complaint}; to pass an argument, write `{name}:={value}`"),
        None => complaint.to_owned(),
    }
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '_')
}

/// `a:=b` on the command line, in the reference's way: stripped, empty ones and `_private` ones ignored.
///
/// # Errors
/// When an argument holds `:=` more than once.
pub fn mappings<'a>(
    args: impl IntoIterator<Item = &'a str>,
) -> Result<Vec<(String, String)>, UsageError> {
    let mut found = Vec::new();
    for arg in args.into_iter().filter(|a| a.contains(":=")) {
        let parts: Vec<&str> = arg.split(":=").map(str::trim).collect();
        let [name, value] = parts.as_slice() else {
            return Err(UsageError::Mapping(format!(
                "Invalid remapping argument '{arg}'"
            )));
        };
        let private = name.starts_with('_') && !name.starts_with("__") && name.len() > 1;
        if !name.is_empty() && !value.is_empty() && !private {
            found.push(((*name).to_owned(), (*value).to_owned()));
        }
    }
    Ok(found)
}

/// Read the arguments behind `expand`.
///
/// # Errors
/// When they do not name exactly one input file, or hold something unknown.
pub fn parse(args: &[String]) -> Result<ExpandOptions, UsageError> {
    let mut options = ExpandOptions {
        input: String::new(),
        args: mappings(args.iter().map(String::as_str))?,
        output: None,
        deps: false,
        in_order: false,
        root_dir: None,
        verbosity: 1,
        package_path: Vec::new(),
        source_map: None,
        check: None,
        assets: AssetOptions::default(),
    };
    let mut files = Vec::new();
    let mut rest = args
        .iter()
        .filter(|a| !a.contains(":="))
        .map(String::as_str);
    while let Some(arg) = rest.next() {
        if arg == "--" {
            files.extend(rest.by_ref());
        } else if arg.starts_with("--") {
            long_option(arg, &mut rest, &mut options)?;
        } else if arg.len() > 1 && arg.starts_with('-') {
            short_options(arg, &mut rest, &mut options)?;
        } else {
            files.push(arg);
        }
    }
    if options.check.is_some() && (options.output.is_some() || options.deps) {
        return Err(UsageError::Usage(
            "--check cannot be used with -o or --deps".into(),
        ));
    }
    if options.assets.strip_protocols && options.assets.relative_paths {
        return Err(UsageError::Usage(
            "--strip-protocols cannot be used with --relative-paths".into(),
        ));
    }
    if options.assets.copy_to.is_some() && (options.check.is_some() || options.deps) {
        return Err(UsageError::Usage(
            "--copy-assets-to cannot be used with --check or --deps".into(),
        ));
    }
    match files.as_slice() {
        [file] => options.input = (*file).to_owned(),
        _ => {
            return Err(UsageError::Usage(
                "expected exactly one input file as argument".into(),
            ));
        }
    }
    Ok(options)
}

fn long_option<'a>(
    arg: &'a str,
    rest: &mut impl Iterator<Item = &'a str>,
    options: &mut ExpandOptions,
) -> Result<(), UsageError> {
    let (given, mut value) = match arg.split_once('=') {
        Some((name, value)) => (name, Some(value.to_owned())),
        None => (arg, None),
    };
    // any unambiguous beginning will do
    let matching: Vec<&str> = if LONG.contains(&given) {
        vec![given]
    } else {
        LONG.into_iter().filter(|l| l.starts_with(given)).collect()
    };
    let name = match matching.as_slice() {
        [one] => *one,
        [] => return Err(UsageError::Usage(format!("no such option: {given}"))),
        many => {
            let list = many.join(", ");
            return Err(UsageError::Usage(format!(
                "ambiguous option: {given} ({list}?)"
            )));
        }
    };
    let takes_value = matches!(
        name,
        "--check"
            | "--copy-assets-to"
            | "--root-dir"
            | "--verbosity"
            | "--package-path"
            | "--source-map"
            | "--output"
    );
    if !takes_value && value.is_some() {
        return Err(UsageError::Usage(format!(
            "{name} option does not take a value"
        )));
    }
    if takes_value && value.is_none() {
        value = rest.next().map(str::to_owned);
    }
    let value = match (takes_value, value) {
        (true, None) => {
            return Err(UsageError::Usage(format!(
                "{name} option requires 1 argument"
            )));
        }
        (_, value) => value.unwrap_or_default(),
    };
    match name {
        "--copy-assets-to" => options.assets.copy_to = Some(value),
        "--relative-paths" => options.assets.relative_paths = true,
        "--strip-protocols" => options.assets.strip_protocols = true,
        "--deps" => options.deps = true,
        "--inorder" => options.in_order = true,
        "--root-dir" => options.root_dir = Some(value),
        "--package-path" => options.package_path.push(value),
        "--source-map" => options.source_map = Some(value),
        "--output" => options.output = Some(value),
        "--check" => options.check = Some(value),
        "--verbosity" => {
            let number = value.parse();
            options.verbosity = number.map_err(|_| {
                UsageError::Usage(format!(
                    "option --verbosity: invalid integer value: '{value}'"
                ))
            })?;
        }
        _ => return Err(UsageError::Help),
    }
    Ok(())
}

fn short_options<'a>(
    arg: &'a str,
    rest: &mut impl Iterator<Item = &'a str>,
    options: &mut ExpandOptions,
) -> Result<(), UsageError> {
    let mut letters = arg.chars().skip(1);
    while let Some(letter) = letters.next() {
        match letter {
            'o' => {
                let joined: String = letters.by_ref().collect();
                let value = if joined.is_empty() {
                    rest.next().map(str::to_owned)
                } else {
                    Some(joined)
                };
                let missing = || UsageError::Usage("-o option requires 1 argument".into());
                options.output = Some(value.ok_or_else(missing)?);
            }
            'i' => options.in_order = true,
            'q' => options.verbosity = 0,
            'v' => options.verbosity += 1,
            'h' => return Err(UsageError::Help),
            other => return Err(UsageError::Usage(format!("no such option: -{other}"))),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{UsageError, mappings, parse};

    fn args(text: &str) -> Vec<String> {
        text.split_whitespace().map(str::to_owned).collect()
    }

    #[test]
    fn options_in_any_order() {
        let options = parse(&args("-v a:=1 in.xacro -oout.urdf --root=x b:=2 a:=3 -vi")).unwrap();
        assert_eq!(options.input, "in.xacro");
        assert_eq!(options.output.as_deref(), Some("out.urdf"));
        assert_eq!(options.root_dir.as_deref(), Some("x"));
        assert_eq!(options.verbosity, 3);
        assert!(options.in_order);
        assert_eq!(options.args.len(), 3);
    }

    #[test]
    fn mappings_are_stripped_and_filtered() {
        let found = mappings([" a := 1 ", "b:=", ":=c", "_d:=1", "__e:=1", "_:=2"]).unwrap();
        let names: Vec<&str> = found.iter().map(|(n, _)| n.as_str()).collect();
        assert_eq!(names, ["a", "__e", "_"]);
        assert!(matches!(mappings(["a:=1:=2"]), Err(UsageError::Mapping(_))));
    }

    #[test]
    fn wrong_command_lines() {
        for (line, message) in [
            ("", "expected exactly one input file as argument"),
            ("a b", "expected exactly one input file as argument"),
            ("a --legacy", "no such option: --legacy"),
            ("a -x", "no such option: -x"),
            (
                "a --verbosity x",
                "option --verbosity: invalid integer value: 'x'",
            ),
            ("a -o", "-o option requires 1 argument"),
            ("a --deps=1", "--deps option does not take a value"),
        ] {
            assert_eq!(
                parse(&args(line)),
                Err(UsageError::Usage(message.into())),
                "{line}"
            );
        }
    }
}
