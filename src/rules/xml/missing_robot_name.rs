//! A robot without name.

use super::super::context::{DocumentCx, RootKind};
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::TextRange;
use expand::FileIdx;
use model::{Robot, tag_start};

pub(super) const RULE: Rule = Rule {
    code: "XML014",
    name: "missing-robot-name",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("missing-robot-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.kind == RootKind::Robot) else { return };
    let message = match &robot.name {
        None => "the robot has no name",
        Some(name) if name.is_known() && name.value.is_empty() => "the name of the robot is empty",
        Some(_) => return,
    };
    let report = out
        .report(tag_start(cx.expansion, robot.element), message)
        .help("urdfdom refuses a robot without name: add name=\"...\"");
    match named_like_file(cx, robot) {
        Some((range, content)) => {
            report.fix(Safety::Unsafe, "name it like the file", FileIdx(0), [(range, content)]).done();
        }
        None => report.done(),
    }
}

/// The edit that names the robot like its file.
fn named_like_file(cx: &DocumentCx<'_>, robot: &Robot) -> Option<(TextRange, String)> {
    let file = cx.expansion.files.first()?;
    let stem = file.source.path.file_name()?.to_str()?.split('.').next()?;
    let plain = stem.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && !stem.is_empty();
    match &robot.name {
        _ if !plain => None,
        // an empty value: between the quotes, when they are in this file
        Some(name) => {
            let place = cx.expansion.place(name.origin).filter(|place| place.file == FileIdx(0))?;
            name.is_literal().then(|| (place.range, stem.to_owned()))
        }
        None => {
            let end = file.source.document.root()?.name_range().end;
            Some((TextRange::empty(end), format!(" name=\"{stem}\"")))
        }
    }
}
