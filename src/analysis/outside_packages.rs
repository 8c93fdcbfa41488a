//! What is wrong in descriptions that belong to no package.
use std::path::Path;

use super::includers::holds_above;
use super::session::Session;
use rules::{Category, Finding, Severity, Trait};
use workspace::Purpose;

/// In a description of no package that no launch file loads, while others are loaded, what only programs of ROS read is an info:
/// a simulator or library of its own takes the links, joints and masses. All of it is one where no program loads the file, or
/// others have written it. Errors stay, and what is said of comments and settings of this program.
pub(super) fn settle_outside_packages(session: &Session, file: &Path, findings: &mut [Finding]) {
    let is_warning = |finding: &Finding| {
        finding.severity == Severity::Warning && finding.rule.category != Category::Linter
    };
    if !findings.iter().any(is_warning) || !is_outside_packages(session, file) {
        return;
    }
    let is_loaded = !holds_above(session, file, |file| !session.callers.load(file));
    let purpose = session
        .callers
        .purpose(file, |_| false)
        .filter(|_| is_loaded && !session.callers.is_of_others(file));
    let is_read =
        |finding: &Finding| purpose.is_some_and(|purpose| is_for_any_reader(finding, purpose));
    for finding in findings
        .iter_mut()
        .filter(|finding| is_warning(finding) && !is_read(finding))
    {
        finding.severity = Severity::Info;
    }
}

/// Whether a description belongs to no package, and no launch file loads it or what includes it, while something else is loaded
/// here.
fn is_outside_packages(session: &Session, file: &Path) -> bool {
    let is_free = |file: &Path| {
        session.packages.containing(file).is_none()
            && !is_of_rosbuild(session, file)
            && !session.callers.launch(file)
    };
    holds_above(session, file, is_free)
        && (session.callers.load_any(file) || session.callers.is_of_others(file))
}

/// Whether a file belongs to a package of rosbuild, whose xacro took tags without a prefix.
pub(super) fn is_of_rosbuild(session: &Session, file: &Path) -> bool {
    let top = session.packages.sources_around(file);
    let inside = |folder: &&Path| top.as_ref().is_none_or(|top| folder.starts_with(top));
    let has_manifest = |folder: &Path| session.vfs.is_file(&folder.join("manifest.xml"));
    session.packages.containing(file).is_none()
        && file
            .ancestors()
            .skip(1)
            .take_while(inside)
            .any(has_manifest)
}

/// Whether a finding is about something that every program reads which loads the robot.
fn is_for_any_reader(finding: &Finding, purpose: Purpose) -> bool {
    match finding.rule.category {
        Category::Xacro | Category::Structure | Category::Joint => true,
        Category::Inertia => purpose.is_weighed,
        _ => finding.rule.has(Trait::Contact) && purpose.is_met,
    }
}
