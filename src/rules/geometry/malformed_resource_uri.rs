//! A URI of a mesh or texture that cannot be resolved.
use std::path::Path;

use super::super::context::DocumentCx;
use super::super::edits::source_text;
use super::super::geometry::uri::{Readers, UriDefect, defect, has_space};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::{is_replaceable, resource_names};
use model::AttrValue;
use packages::RosVersion;

pub(super) static RULE: Rule = Rule {
    code: "GEO021",
    name: "malformed-resource-uri",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("malformed-resource-uri"),
    check: Check::Document(check),
};

/// Characters of a URI that a message shows.
const MOST_SHOWN: usize = 80;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for name in resource_names(cx)
        .into_iter()
        .filter(|name| name.is_known())
    {
        if let Some(meant) = without_find(cx, name) {
            out.report(
                name.origin,
                "`package://` and `$(find ...)` exclude each other",
            )
            .help(format!("write {meant}"))
            .replace_with(Safety::Unsafe, format!("replace with `{meant}`"), meant)
            .done();
            continue;
        }
        let Some(UriDefect {
            message,
            readers,
            meant,
        }) = defect(&name.value)
        else {
            continue;
        };
        let help = match readers {
            Readers::OldCurl => {
                "rename the file or folder; RViz in ROS 2 Humble and later cannot load it"
            }
            Readers::Gazebo => "write `%20` for each space; RViz cannot load it",
            _ => "write package://PACKAGE/PATH, with slashes and without spaces",
        };
        let report = out
            .report(
                name.origin,
                format!("`{}`: {message}", shortened(&name.value)),
            )
            .severity(if is_beside(cx, name) || is_of_checkout(cx, name) {
                Severity::Info
            } else {
                severity(cx, readers)
            })
            .group(Group::Name(
                format!("{message} {}", beginning(&name.value)).into(),
            ))
            .help(help);
        match meant.filter(|meant| is_replaceable(name, meant) && leads_to_package(cx, name, meant))
        {
            Some(meant) => report
                .replace_with(Safety::Unsafe, format!("replace with `{meant}`"), meant)
                .done(),
            None => report.done(),
        }
    }
}

/// `package://$(find arm)/meshes/a.stl` as `package://arm/meshes/a.stl`.
fn without_find(cx: &DocumentCx<'_>, name: &AttrValue) -> Option<String> {
    let (_, _, source) = source_text(cx.expansion, name.origin).filter(|_| !name.is_literal())?;
    let (package, path) = source.strip_prefix("package://$(find ")?.split_once(')')?;
    path.starts_with('/')
        .then(|| format!("package://{}{path}", package.trim()))
}

fn severity(cx: &DocumentCx<'_>, readers: Readers) -> Severity {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    match readers {
        Readers::None if root.is_some_and(|root| is_of_model(cx, root)) => Severity::Info,
        Readers::None => Severity::Error,
        Readers::Gazebo => Severity::Info,
        Readers::OldCurl if root.is_some_and(|root| is_of_ros1(cx, root)) => Severity::Info,
        Readers::OldCurl => Severity::Warning,
    }
}

/// Whether a file lies in the folder of a model: Gazebo looks for other files there.
fn is_of_model(cx: &DocumentCx<'_>, file: &Path) -> bool {
    cx.world.vfs.is_file(&file.with_file_name("model.config"))
}

fn is_of_ros1(cx: &DocumentCx<'_>, file: &Path) -> bool {
    cx.world.packages.generation(file) == Some(RosVersion::Ros1)
}

/// Whether a URI that is computed has spaces only in the folders above its package: it is installed elsewhere.
fn is_of_checkout(cx: &DocumentCx<'_>, name: &AttrValue) -> bool {
    let path = name.value.strip_prefix("file://").map(Path::new);
    let Some(path) = path.filter(|_| !name.is_literal()) else {
        return false;
    };
    let inside = cx
        .world
        .packages
        .containing(path)
        .and_then(|package| path.strip_prefix(&package.folder).ok());
    inside.is_some_and(|inside| !has_space(&inside.to_string_lossy()))
        && has_space(&path.to_string_lossy())
}

/// Whether a path without a package follows `package://`, the file lies beside the description, and no package does:
/// exporters write that, and programs that are given the folder, and Bullet, find it.
fn is_beside(cx: &DocumentCx<'_>, name: &AttrValue) -> bool {
    let file = cx.expansion.files.first().map(|file| &*file.source.path);
    let path = name
        .value
        .strip_prefix("package://")
        .map(|path| path.trim_start_matches('/'))
        .filter(|path| !path.is_empty());
    let (Some(file), Some(path)) = (file, path) else {
        return false;
    };
    let beside = file.with_file_name("").join(path);
    cx.world.packages.containing(file).is_none() && cx.world.vfs.is_file(&beside)
}

/// The scheme and the first folder behind it: what is wrong with them is wrong in every URI of a file. The last name is
/// that of the mesh.
fn beginning(uri: &str) -> String {
    let mut names: Vec<&str> = uri
        .split(['/', '\\'])
        .filter(|name| !name.is_empty())
        .collect();
    names.pop();
    // without a package, the first name is that of a folder
    let most = if uri.starts_with("package:///") { 1 } else { 2 };
    names.truncate(most);
    names.join("/")
}

/// Whether the first name is a package that is known; with a slash too many, it may be a folder of one.
fn leads_to_package(cx: &DocumentCx<'_>, name: &AttrValue, meant: &str) -> bool {
    let package = meant
        .strip_prefix("package://")
        .and_then(|rest| rest.split('/').next());
    let certain = !name.value.starts_with("package:///");
    let place = cx.expansion.place(name.origin);
    let source = place.and_then(|place| cx.expansion.files.get(place.file));
    let known = |package| {
        source.is_some_and(|file| cx.world.packages.find(package, &file.source.path).is_ok())
    };
    certain || package.is_some_and(known)
}

fn shortened(value: &str) -> String {
    let plain: Vec<char> = value
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    let left_out = plain.len().saturating_sub(MOST_SHOWN);
    if left_out == 0 {
        return plain.into_iter().collect();
    }
    // the end names the file
    let (head, tail) = plain.split_at(MOST_SHOWN / 2);
    head.iter()
        .chain(&['.', '.', '.'])
        .chain(tail.iter().skip(left_out))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Readers, defect};

    #[test]
    fn uris() {
        let meant = |value: &str| defect(value).map(|defect| defect.meant.unwrap_or_default());
        let good = [
            "package://a/b.stl",
            "file:///a/b.stl",
            "file:/a/b.stl",
            "file://localhost/a.stl",
            "a b.stl",
            "/a/b.stl",
            "http://x/y",
            "",
        ];
        assert!(good.iter().all(|value| defect(value).is_none()));
        let bad = [
            ("package:/a/b.stl", "package://a/b.stl"),
            ("package:a/b.stl", "package://a/b.stl"),
            ("package:///a/b.stl", "package://a/b.stl"),
            ("package://a", ""),
            ("package://a/", ""),
            ("package://", ""),
            (r"package://a\b.stl", "package://a/b.stl"),
            (r"package:\\a\b.stl", "package://a/b.stl"),
            ("package://a/b c.stl", ""),
            ("file://a/b.stl", ""),
            (r"meshes\a.stl", "meshes/a.stl"),
            (r"C:\a.stl", ""),
            (r"\\server\a.stl", ""),
            (" a.stl ", "a.stl"),
        ];
        for (value, expected) in bad {
            assert_eq!(meant(value).as_deref(), Some(expected), "{value}");
        }
        for (uri, expected) in [
            ("file:///a/b c.stl", Readers::OldCurl),
            ("package://a/b c.stl", Readers::OldCurl),
            ("http://x/b c.stl", Readers::Gazebo),
            ("model://x/b c.stl", Readers::None),
            ("file://a/b c.stl", Readers::None),
        ] {
            assert_eq!(defect(uri).unwrap().readers, expected, "{uri}");
        }
    }

    #[test]
    fn a_long_name_is_shown_with_its_end() {
        let name = format!("package://arm/{}/base .stl", "m".repeat(200));
        let shown = super::shortened(&name);
        assert!(
            shown.starts_with("package://arm/") && shown.ends_with("base .stl") && shown.len() < 90
        );
        assert_eq!(super::shortened("a\tb.stl"), "a b.stl");
    }
}
