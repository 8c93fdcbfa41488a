//! A robot without name.
use super::super::context::{DocumentCx, RootKind};
use super::super::finding::{Edit, Finding, Fix};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::{Span, TextRange};
use expand::{Expansion, FileIdx};
use model::{Robot, tag_start};

pub(in super::super) static RULE: Rule = Rule {
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

const HELP: &str = "add name=\"...\"; urdfdom rejects a robot without a name";

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.kind == RootKind::Robot) else {
        return;
    };
    let message = match &robot.name {
        None => "robot has no name",
        Some(name) if name.is_known() && name.value.is_empty() => "robot has an empty name",
        Some(_) => return,
    };
    let report = out
        .report(tag_start(cx.expansion, robot.element), message)
        .help(HELP);
    match named_like_file(cx.expansion, robot) {
        Some((range, content)) => report
            .fix(Safety::Unsafe, FIX, FileIdx(0), [(range, content)])
            .done(),
        None => report.done(),
    }
}

const FIX: &str = "use the file name as robot name";

/// The same of a file that is a robot, as its surroundings say.
pub fn missing_robot_name(expansion: &Expansion, robot: &Robot) -> Option<Finding> {
    let file = expansion.files.first()?.source.id;
    let tag = expansion
        .place(tag_start(expansion, robot.element))
        .filter(|place| place.file == FileIdx(0))?;
    let fix = named_like_file(expansion, robot).map(|(range, content)| Fix {
        safety: Safety::Unsafe,
        message: FIX.to_owned(),
        edits: vec![Edit {
            span: Span { file, range },
            content,
        }],
    });
    let span = Span {
        file,
        range: tag.range,
    };
    let finding = Finding::new(&RULE, span, "robot has no name");
    Some(Finding {
        help: Some(HELP.to_owned()),
        fix,
        ..finding
    })
}

/// The edit that names the robot like its file.
fn named_like_file(expansion: &Expansion, robot: &Robot) -> Option<(TextRange, String)> {
    let file = expansion.files.first()?;
    let stem = file.source.path.file_name()?.to_str()?.split('.').next()?;
    let plain = stem.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && !stem.is_empty();
    match &robot.name {
        _ if !plain => None,
        // an empty value: between the quotes, when they are in this file
        Some(name) => {
            let place = expansion
                .place(name.origin)
                .filter(|place| place.file == FileIdx(0))?;
            name.is_literal().then(|| (place.range, stem.to_owned()))
        }
        None => {
            let end = file.source.document.root()?.name_range().end;
            Some((TextRange::empty(end), format!(" name=\"{stem}\"")))
        }
    }
}
