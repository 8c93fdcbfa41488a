//! Where the URIs of meshes and textures lead.

use std::path::{Path, PathBuf};

use super::package_sources::PackageSource;
use super::packages::{NotFound, Packages};
use base::paths::HERE;

/// Variables that list the folders `model://` is looked for in.
const MODEL_PATHS: [&str; 3] = [
    "GZ_SIM_RESOURCE_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
    "GAZEBO_MODEL_PATH",
];

/// The forms of a URI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UriKind {
    /// `package://pkg/path`
    Package,
    /// `model://model/path`
    Model,
    /// `file:///path`
    File,
    /// `/path`
    Absolute,
    /// `path`, from the folder of the file it stands in.
    Relative,
    /// Any other scheme.
    Other,
}

/// What became of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UriOutcome {
    /// A file or folder that exists.
    Found(PathBuf),
    /// The place it names holds nothing.
    Missing(PathBuf),
    /// It names a package, or a model, that is not known.
    UnknownPackage(NotFound),
    /// It names no place, whatever the disk holds; the text says why.
    Malformed(&'static str),
    /// Not something on this machine.
    Elsewhere,
}

/// A resolved URI.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UriResult {
    /// The form.
    pub kind: UriKind,
    /// Where it leads.
    pub outcome: UriOutcome,
    /// How its package was found.
    pub step: Option<PackageSource>,
    /// Files and folders looked for, in order.
    pub tried: Vec<PathBuf>,
}

impl UriResult {
    fn new(kind: UriKind, outcome: UriOutcome) -> Self {
        Self {
            kind,
            outcome,
            step: None,
            tried: Vec::new(),
        }
    }

    fn malformed(kind: UriKind, why: &'static str) -> Self {
        Self::new(kind, UriOutcome::Malformed(why))
    }
}

impl Packages {
    /// Resolve the URI or path of a resource named in `from_file`, as RViz and Gazebo do.
    pub fn resolve_uri(&self, uri: &str, from_file: &Path) -> UriResult {
        let Some((scheme, rest)) = split_scheme(uri) else {
            let kind = if HERE.is_absolute(uri) {
                UriKind::Absolute
            } else {
                UriKind::Relative
            };
            let folder = from_file.parent().unwrap_or(Path::new(""));
            return if uri.is_empty() {
                UriResult::new(kind, UriOutcome::Malformed("an empty path"))
            } else {
                self.first_existing(kind, vec![folder.join(uri)])
            };
        };
        match scheme.to_ascii_lowercase().as_str() {
            "package" => self.in_package(UriKind::Package, rest, from_file),
            "model" => self.in_package(UriKind::Model, rest, from_file),
            "file" => self.file_uri(rest),
            _ => UriResult::new(UriKind::Other, UriOutcome::Elsewhere),
        }
    }

    /// `rest` is `//name/path`.
    fn in_package(&self, kind: UriKind, rest: &str, from_file: &Path) -> UriResult {
        let Some(rest) = rest.strip_prefix("//") else {
            return UriResult::malformed(kind, "missing two slashes after the colon");
        };
        let (name, path) = match rest.split_once('/') {
            Some((name, path)) => (name, path),
            None if kind == UriKind::Package => {
                return UriResult::malformed(kind, "missing path after the package name");
            }
            None => (rest, ""),
        };
        if name.is_empty() {
            return UriResult::malformed(kind, "missing package name after the two slashes");
        }
        // readers put a slash between the folder and the path: a second one changes nothing
        let path = path.trim_start_matches('/');
        let package = self.find(name, from_file);
        let mut places: Vec<PathBuf> = package
            .iter()
            .map(|found| self.env.cwd.join(&found.path).join(path))
            .collect();
        if kind == UriKind::Model {
            let folders = MODEL_PATHS
                .iter()
                .flat_map(|variable| self.env.paths(variable));
            places.extend(folders.map(|folder| self.env.cwd.join(folder).join(name).join(path)));
        }
        let mut result = self.first_existing(kind, places);
        match package {
            Ok(found) => result.step = Some(found.step),
            Err(error) if !matches!(result.outcome, UriOutcome::Found(_)) => {
                result.outcome = UriOutcome::UnknownPackage(error);
            }
            Err(_) => {}
        }
        result
    }

    /// `rest` is what follows `file:`.
    fn file_uri(&self, rest: &str) -> UriResult {
        let Some(path) = HERE.of_file_uri(rest) else {
            let why = "`file:` must be followed by `///` and an absolute path";
            return UriResult::new(UriKind::File, UriOutcome::Malformed(why));
        };
        let decoded = percent_decoded(&path).map(PathBuf::from);
        let places = std::iter::once(PathBuf::from(path))
            .chain(decoded)
            .collect();
        self.first_existing(UriKind::File, places)
    }

    /// The first place that exists or that the build puts something at, else the first one as missing.
    fn first_existing(&self, kind: UriKind, places: Vec<PathBuf>) -> UriResult {
        let found = places.iter().find(|place| self.vfs.exists(place)).cloned();
        let built = || {
            places
                .iter()
                .find_map(|place| self.built(place))
                .map(|built| built.path)
        };
        let outcome = match (found.or_else(built), places.first()) {
            (Some(found), _) => UriOutcome::Found(found),
            (None, Some(first)) => UriOutcome::Missing(first.clone()),
            (None, None) => UriOutcome::Elsewhere,
        };
        UriResult {
            tried: places,
            ..UriResult::new(kind, outcome)
        }
    }
}

/// Scheme and what follows its colon. A scheme has at least two letters (`C:` is a drive) and is followed
/// by a slash.
fn split_scheme(uri: &str) -> Option<(&str, &str)> {
    let (scheme, rest) = uri.split_once(':')?;
    let is_scheme = scheme.len() > 1
        && scheme.starts_with(|c: char| c.is_ascii_alphabetic())
        && scheme
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || matches!(c, '+' | '-' | '.'));
    (is_scheme && (rest.starts_with('/') || scheme.eq_ignore_ascii_case("file")))
        .then_some((scheme, rest))
}

/// The text with `%41` and the like replaced, if there is any.
pub fn percent_decoded(text: &str) -> Option<String> {
    let mut parts = text.split('%');
    let mut bytes = parts.next()?.as_bytes().to_vec();
    let mut changed = false;
    for part in parts {
        match part
            .get(..2)
            .and_then(|digits| u8::from_str_radix(digits, 16).ok())
        {
            Some(byte) => {
                bytes.push(byte);
                bytes.extend_from_slice(part.get(2..).unwrap_or_default().as_bytes());
                changed = true;
            }
            None => {
                bytes.push(b'%');
                bytes.extend_from_slice(part.as_bytes());
            }
        }
    }
    String::from_utf8(bytes).ok().filter(|_| changed)
}

#[cfg(test)]
mod tests {
    use super::{UriKind, UriOutcome};
    use crate::{PackageOptions, PackageSource, Packages};
    use vfs::testing::Tree;

    #[test]
    fn forms() {
        let tree = Tree::new();
        tree.write("bot/package.xml", "<package><name>bot</name></package>");
        for file in [
            "bot/meshes/a.stl",
            "bot/urdf/b.stl",
            "models/table/mesh.dae",
            "sp ace.stl",
        ] {
            tree.write(file, "");
        }
        let env = tree.environment(&[("GAZEBO_MODEL_PATH", "{root}/models")]);
        let system = tree.path("none");
        let packages = Packages::new(
            tree.vfs().clone(),
            &env,
            PackageOptions {
                system,
                ..Default::default()
            },
        );
        let root = tree.root().to_str().unwrap();
        let table = [
            (
                "package://bot/meshes/a.stl",
                UriKind::Package,
                "found bot/meshes/a.stl",
            ),
            (
                "package://bot/meshes/x.stl",
                UriKind::Package,
                "missing bot/meshes/x.stl",
            ),
            (
                "package://bit/meshes/a.stl",
                UriKind::Package,
                "unknown bit",
            ),
            ("package://bot", UriKind::Package, "malformed"),
            ("package:///meshes/a.stl", UriKind::Package, "malformed"),
            ("package:/bot/a.stl", UriKind::Package, "malformed"),
            ("package://../bot/a.stl", UriKind::Package, "unknown .."),
            (
                "model://bot/meshes/a.stl",
                UriKind::Model,
                "found bot/meshes/a.stl",
            ),
            (
                "model://table/mesh.dae",
                UriKind::Model,
                "found models/table/mesh.dae",
            ),
            ("model://table", UriKind::Model, "found models/table/"),
            ("model://chair/mesh.dae", UriKind::Model, "unknown chair"),
            (
                "file://{root}/bot/meshes/a.stl",
                UriKind::File,
                "found bot/meshes/a.stl",
            ),
            (
                "file:{root}/bot/meshes/a.stl",
                UriKind::File,
                "found bot/meshes/a.stl",
            ),
            (
                "file://localhost{root}/bot/meshes/a.stl",
                UriKind::File,
                "found bot/meshes/a.stl",
            ),
            (
                "file://{root}/sp%20ace.stl",
                UriKind::File,
                "found sp ace.stl",
            ),
            ("file://{root}/100%.stl", UriKind::File, "missing 100%.stl"),
            ("file://meshes/a.stl", UriKind::File, "malformed"),
            (
                "{root}/bot/meshes/a.stl",
                UriKind::Absolute,
                "found bot/meshes/a.stl",
            ),
            ("b.stl", UriKind::Relative, "found bot/urdf/b.stl"),
            (
                "../meshes/a.stl",
                UriKind::Relative,
                "found bot/urdf/../meshes/a.stl",
            ),
            ("c.stl", UriKind::Relative, "missing bot/urdf/c.stl"),
            ("", UriKind::Relative, "malformed"),
            ("https://example.org/a.stl", UriKind::Other, "elsewhere"),
        ];
        for (uri, kind, expected) in table {
            let result =
                packages.resolve_uri(&uri.replace("{root}", root), &tree.path("bot/urdf/x.xacro"));
            let relative = |path: &std::path::Path| {
                path.display().to_string().replace(&format!("{root}/"), "")
            };
            let outcome = match &result.outcome {
                UriOutcome::Found(path) => format!("found {}", relative(path)),
                UriOutcome::Missing(path) => format!("missing {}", relative(path)),
                UriOutcome::UnknownPackage(error) => format!("unknown {}", error.name),
                UriOutcome::Malformed(_) => "malformed".to_owned(),
                UriOutcome::Elsewhere => "elsewhere".to_owned(),
            };
            assert_eq!((result.kind, outcome.as_str()), (kind, expected), "{uri}");
        }
        let found =
            packages.resolve_uri("package://bot/meshes/a.stl", &tree.path("bot/urdf/x.xacro"));
        assert_eq!(found.step, Some(PackageSource::OwnPackage));
        let UriOutcome::UnknownPackage(error) = packages
            .resolve_uri("package://bit/a", &tree.path("bot/urdf/x.xacro"))
            .outcome
        else {
            panic!("bit is unknown")
        };
        let near = packages.meant(&error.name, &tree.path("bot/urdf/x.xacro"));
        assert_eq!(near.as_deref(), Some("bot"));
    }
}
