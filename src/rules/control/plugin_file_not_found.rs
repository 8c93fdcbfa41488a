//! A file that is given to a plugin and is not there.
use std::path::Path;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins;
use expand::XId;
use model::AttrValue;
use packages::UriOutcome;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL021",
    name: "plugin-file-not-found",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("plugin-file-not-found"),
    check: Check::Document(check),
};

/// Endings of files that plugins read; others may be written by them.
const READ: [&str; 4] = [".yaml", ".yml", ".xml", ".srdf"];

/// Where the files of one person are. Others, such as those of an installation, may be on the computer that runs the robot.
const HOMES: [&str; 3] = ["/home/", "/root/", "/Users/"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for element in parameters(cx) {
        let Some(text) = AttrValue::content(&cx.expansion.tree, element) else {
            continue;
        };
        if let Some(path) = of_somebody(cx, &text) {
            out.report(text.origin, format!("file `{path}` not found"))
                .help(portable(cx, path))
                .done();
            continue;
        }
        let Some((package, path)) = missing(cx, &text) else {
            continue;
        };
        let message = format!(
            "file `{}` of package `{package}` not found",
            path.trim_start_matches('/')
        );
        out.report(text.origin, message)
            .help("correct the path, or add the file")
            .done();
    }
}

/// The elements inside of plugins of Gazebo, and the parameters of hardware.
fn parameters(cx: &DocumentCx<'_>) -> Vec<XId> {
    let tree = &cx.expansion.tree;
    let mut open = plugins(cx);
    open.extend(
        cx.robot
            .into_iter()
            .flat_map(|robot| &robot.controls)
            .flat_map(|control| &control.hardware),
    );
    let mut found = Vec::new();
    while let Some(element) = open.pop() {
        let before = open.len();
        open.extend(tree.elements(element));
        if open.len() == before {
            found.push(element);
        }
    }
    found
}

/// A file in the home folder of a person that a text names and that is not there.
fn of_somebody<'t>(cx: &DocumentCx<'_>, text: &'t AttrValue) -> Option<&'t str> {
    let path = text.name().filter(|_| text.is_literal())?.as_str();
    let is_own = HOMES.iter().any(|home| path.starts_with(home));
    let is_read = READ.iter().any(|ending| path.ends_with(ending));
    (is_own && is_read && !cx.world.vfs.is_file(Path::new(path))).then_some(path)
}

/// How to write such a path for every computer: with the package that has the file, if one of the folders is called so.
fn portable(cx: &DocumentCx<'_>, path: &str) -> String {
    let from = cx.expansion.files.first().map(|file| &*file.source.path);
    let found = from.and_then(|from| {
        let mut names = path.match_indices('/');
        names.find_map(|(at, _)| {
            let (package, rest) = path.get(at + 1..)?.split_once('/')?;
            let folder = cx.world.packages.find(package, from).ok()?.path;
            let is_there = cx.world.vfs.is_file(&folder.join(rest));
            is_there.then(|| format!("$(find {package})/{rest}"))
        })
    });
    let path = found.unwrap_or_else(|| "$(find PACKAGE)/PATH".to_owned());
    format!("write {path}; an absolute path works on one computer only")
}

/// The file that a text with `$(find package)` names, when the package is there and the file is not.
fn missing(cx: &DocumentCx<'_>, text: &AttrValue) -> Option<(String, String)> {
    let value = text.name()?.as_str();
    let is_meant =
        Path::new(value).is_absolute() && READ.iter().any(|ending| value.ends_with(ending));
    let written = is_meant
        .then(|| cx.expansion.place(text.origin))
        .flatten()?;
    let file = cx.expansion.files.get(written.file)?;
    let source = file.source.document.slice(written.range);
    let (_, rest) = source.split_once("$(find ")?;
    let (package, path) = rest.split_once(')')?;
    // what an argument or a property makes of the path may be another one
    let path = path
        .split_whitespace()
        .next()
        .filter(|path| path.starts_with('/') && !path.contains('$'))?;
    let from = cx.expansion.files.first()?.source.path.clone();
    cx.world.packages.find(package.trim(), &from).ok()?;
    let uri = format!("package://{}{path}", package.trim());
    let is_there = matches!(
        cx.world.packages.resolve_uri(&uri, &from).outcome,
        UriOutcome::Found(_)
    );
    (!is_there).then(|| (package.trim().to_owned(), path.to_owned()))
}
