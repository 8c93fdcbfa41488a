//! URIs and paths that no program, or not every program, can read.

/// What is wrong with a URI, and how it was meant.
pub(super) struct UriDefect {
    pub message: &'static str,
    /// Who reads the file all the same.
    pub readers: Readers,
    pub meant: Option<String>,
}

/// Who finds a file by a URI that is not right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Readers {
    None,
    /// All but those that ask libcurl 7.78 or later, as RViz 2 does.
    OldCurl,
    /// Gazebo: models of its Fuel server have spaces in their addresses.
    Gazebo,
}

/// What is wrong with a URI or path.
pub(super) fn defect(value: &str) -> Option<UriDefect> {
    let slashed = value.replace('\\', "/");
    if let Some(rest) = slashed.strip_prefix("package:") {
        let path = rest.trim_start_matches('/');
        let slashes = rest.len() - path.len();
        let meant = path.contains('/').then(|| format!("package://{path}"));
        return match path.split_once('/') {
            _ if slashes == 2 && slashed != value => found("URI contains backslashes", meant),
            _ if slashes < 2 => found("`package:` must be followed by `//`", meant),
            _ if slashes > 2 => found("missing package name after `package://`", meant),
            None | Some((_, "")) => found("missing path after the package name", None),
            _ if has_space(value) => spaces(Readers::OldCurl),
            _ => None,
        };
    }
    let file = slashed
        .strip_prefix("file:")
        .map(|rest| rest.strip_prefix("//").unwrap_or(rest));
    match value {
        _ if file.is_some_and(|path| !path.starts_with('/') && !path.starts_with("localhost/")) => {
            found(
                "`file:` must be followed by `///` and an absolute path",
                None,
            )
        }
        _ if slashed != value => {
            let drive = value.get(1..2) == Some(":") || value.starts_with("\\\\");
            found("path contains backslashes", (!drive).then_some(slashed))
        }
        _ if file.is_some() && has_space(value) => spaces(Readers::OldCurl),
        _ if is_of_web(value) && has_space(value) => spaces(Readers::Gazebo),
        _ if value.contains("://") && has_space(value) => spaces(Readers::None),
        _ if value.trim() != value => found(
            "path starts or ends with a space",
            Some(value.trim().to_owned()).filter(|path| !path.is_empty()),
        ),
        _ => None,
    }
}

/// What is wrong with a URI that nobody reads.
fn found(message: &'static str, meant: Option<String>) -> Option<UriDefect> {
    Some(UriDefect {
        message,
        readers: Readers::None,
        meant,
    })
}

fn spaces(readers: Readers) -> Option<UriDefect> {
    Some(UriDefect {
        message: "URI contains spaces",
        readers,
        meant: None,
    })
}

fn is_of_web(value: &str) -> bool {
    value.starts_with("https://") || value.starts_with("http://")
}

pub(super) fn has_space(value: &str) -> bool {
    value.contains(|c: char| c.is_ascii_whitespace())
}
