//! A package that is used and not declared as a dependency.
use super::super::context::FileCx;
use super::super::finding::Edit;
use super::super::grouping::Group;
use super::super::package::dependencies::{brings, manifest_around};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::mention::PackageMention;
use super::{dependencies, mentions};
use base::FastSet;

pub(in super::super) static RULE: Rule = Rule {
    code: "PKG002",
    name: "missing-package-dependency",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("missing-package-dependency"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let mentions = mentions::packages(cx);
    if mentions.is_empty() {
        return;
    }
    let Some(manifest) = dependencies::of_file(cx.world, cx.expansion, cx.file) else {
        return;
    };
    let mut said: FastSet<&str> = FastSet::default();
    let (maybe, always): (Vec<&PackageMention>, Vec<&PackageMention>) =
        mentions.iter().partition(|mention| mention.is_conditional);
    for mention in always.into_iter().chain(maybe) {
        let name = mention.name.as_str();
        let declared = name == manifest.name || manifest.declares(name);
        if declared || !said.insert(name) || is_unknown(cx, name) {
            continue;
        }
        let (span, content) = manifest.addition(name);
        // what a condition brings in may be optional, and what another dependency brings along is there
        let comes_along = mention.is_conditional || brings(&manifest, cx.world, name);
        let is_known = manifest.leaves_out(name)
            || manifest.builds_with(name)
            || needs(cx, name, &manifest.name)
            || mentions
                .iter()
                .filter(|other| other.name == name)
                .all(|other| leads_nowhere(cx, other));
        let severity = if comes_along || is_known {
            Severity::Info
        } else {
            RULE.severity
        };
        out.report_in(
            cx.file,
            mention.range,
            format!("package `{}` does not declare its dependency on `{name}`", manifest.name),
        )
        .severity(severity)
        .group(Group::Thing(format!("{} of {}", name, vfs::slashed(&manifest.folder)).into()))
        .help(format!(
            "add <exec_depend>{name}</exec_depend> to package.xml; undeclared dependencies are not installed"
        ))
        .edits(Safety::Safe, "add the dependency to package.xml", vec![Edit { span, content }])
        .done();
    }
}

/// Whether a package depends on the one that names it: declared both ways, neither could be built.
fn needs(cx: &FileCx<'_>, name: &str, own: &str) -> bool {
    let from = &cx.source.path;
    let Ok(found) = cx.world.packages.find(name, from) else {
        return false;
    };
    let manifest = manifest_around(cx.world, &found.path.join("package.xml"));
    manifest.is_some_and(|manifest| manifest.declares(own) || brings(&manifest, cx.world, own))
}

/// Whether the folder of the file that a URI names is not in the package: another package is meant.
fn leads_nowhere(cx: &FileCx<'_>, mention: &PackageMention) -> bool {
    let Some((folder, _)) = mention
        .path
        .as_ref()
        .and_then(|(path, _)| path.rsplit_once('/'))
    else {
        return false;
    };
    let world = cx.world;
    let found = world.packages.find(&mention.name, &cx.source.path);
    found.is_ok_and(|found| {
        let folder = found.path.join(folder);
        !world.vfs.is_dir(&folder) && world.packages.built(&folder).is_none()
    })
}

/// Whether no such package is known: that is said elsewhere.
fn is_unknown(cx: &FileCx<'_>, name: &str) -> bool {
    cx.world.packages.find(name, &cx.source.path).is_err()
}
