//! A mesh whose name has other letter cases.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::missing::shown;
use super::shapes::is_replaceable;
use super::target::FileLookup;

pub(super) static RULE: Rule = Rule {
    code: "GEO002",
    name: "mesh-case-mismatch",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("mesh-case-mismatch"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let FileLookup::OtherCase(found) = mesh.target else {
            continue;
        };
        let message = format!(
            "mesh `{}` of link `{}` differs in case from the file on disk",
            mesh.name(),
            mesh.link.shown()
        );
        let written = mesh.file.value.as_str();
        let is = shown(cx, mesh.file, found);
        let help = format!("write `{is}`; Linux file systems are case-sensitive");
        let report = out
            .report(mesh.file.origin, message)
            .group(mesh.group())
            .help(help);
        // the path ends as the file does, but for case
        let tail = tail_of(written, &vfs::slashed(found));
        match tail.filter(|tail| is_replaceable(mesh.file, tail)) {
            Some(spelled) => report
                .replace_with(Safety::Unsafe, format!("replace with `{spelled}`"), spelled)
                .done(),
            None => report.done(),
        }
    }
}

/// `written` with its end in the letters of `found`: as much of it as is equal but for case.
fn tail_of(written: &str, found: &str) -> Option<String> {
    let same = |(a, b): &(char, char)| a.to_lowercase().eq(b.to_lowercase());
    let pairs: Vec<(char, char)> = written
        .chars()
        .rev()
        .zip(found.chars().rev())
        .take_while(same)
        .collect();
    let kept = written.chars().count().checked_sub(pairs.len())?;
    let spelled: String = written
        .chars()
        .take(kept)
        .chain(pairs.iter().rev().map(|(_, b)| *b))
        .collect();
    (spelled != written).then_some(spelled)
}
