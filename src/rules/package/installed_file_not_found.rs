//! Files and folders that the build of a package installs, and that are not there.
use std::path::Path;

use super::super::context::{DocumentCx, RuleEnv};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::dependencies::packages_of;
use base::Span;
use packages::{RequiredSource, nearest};

pub(super) static RULE: Rule = Rule {
    code: "PKG019",
    name: "installed-file-not-found",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("installed-file-not-found"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for package in packages_of(cx.world, cx.expansion) {
        check_package(cx.world, &package.folder, out);
    }
}

/// A name for some file in a folder.
const ANY: &str = "any";

fn check_package(world: RuleEnv<'_>, folder: &Path, out: &mut Sink<'_>) {
    // any path in it
    let Some(build) = world.packages.build_around(&folder.join("package.xml")) else {
        return;
    };
    for source in build.missing(world.vfs) {
        // a package for ROS 1 is used without being installed; what Git leaves out somebody makes
        let is_ignored = |path: &Path| world.packages.is_ignored_by_git(path);
        // a pattern such as `meshes/` matches what is in the folder
        let is_left_out = is_ignored(&source.path) || is_ignored(&source.path.join(ANY));
        let breaks = build.is_ament && !is_left_out;
        let what = if source.is_folder { "folder" } else { "file" };
        let span = Span {
            file: world.vfs.file_id(&source.file),
            range: source.range,
        };
        let message = format!("{what} `{}` to install does not exist", source.shown);
        out.report_span(span, message)
            .severity(if breaks {
                RULE.severity
            } else {
                Severity::Info
            })
            // one build stops for all of them
            .group(Group::Thing(vfs::slashed(&source.file).into()))
            .help(help(world, source))
            .done();
    }
}

/// What to do about it: Git keeps no empty folders, so the author of the package may well have one.
fn help(world: RuleEnv<'_>, source: &RequiredSource) -> String {
    let folder = source.path.parent().unwrap_or(Path::new(""));
    let name = source.path.file_name().unwrap_or_default();
    let entries = world.vfs.list_dir(folder);
    let same_kind = entries
        .iter()
        .filter(|entry| entry.is_dir == source.is_folder);
    match nearest(
        &name.to_string_lossy(),
        same_kind.map(|entry| &*entry.name),
    ) {
        Some(near) => format!("correct the name: there is `{near}`; installing the package fails here"),
        None if source.is_folder => {
            "remove it from the rule, or commit a file in it, since Git keeps no empty folders: installing the package fails here".to_owned()
        }
        None => "commit the file, or remove it from the rule: installing the package fails here".to_owned(),
    }
}
