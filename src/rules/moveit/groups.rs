//! Groups in settings of MoveIt.
use super::super::beside::BesideCx;
use super::super::rule::Severity;
use super::super::sink::Sink;
use model::AttrValue;
use project::{ProjectNameKind, SpannedName, is_computed};

/// Report the groups that no SRDF of the robot defines.
pub(super) fn unknown(cx: &BesideCx<'_>, out: &mut Sink<'_>, groups: &[SpannedName], what: &str) {
    // what an SRDF defines is known only where there is one, and where its arguments do not decide the names in it
    let mut names = cx
        .srdfs()
        .flat_map(|srdf| &srdf.groups)
        .map(|group| group.name.as_ref());
    let is_sure = |name: &AttrValue| name.is_known() && (name.is_literal() || !cx.has_variants);
    if cx.srdfs().next().is_none()
        || !cx.has_all_groups
        || !names.all(|name| name.is_some_and(is_sure))
    {
        return;
    }
    // where each group of the SRDF has its settings, others are left over
    let has = |name: &AttrValue| groups.iter().any(|group| group.name == name.value);
    let defined = cx
        .srdfs()
        .flat_map(|srdf| &srdf.groups)
        .filter_map(|group| group.name.as_ref());
    let severity = if defined.into_iter().all(has) {
        Severity::Info
    } else {
        Severity::Warning
    };
    for group in groups.iter().filter(|group| !is_computed(&group.name)) {
        if cx.lacks(ProjectNameKind::Group, &group.name) {
            let message = format!("{what} for unknown group `{}`", group.name);
            let report = cx.report(out, group, message).severity(severity);
            report
                .help(cx.advice(ProjectNameKind::Group, &group.name))
                .done();
        }
    }
}
