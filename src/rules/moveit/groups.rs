//! Groups in settings of MoveIt.
use super::super::beside::BesideCx;
use super::super::rule::Severity;
use super::super::sink::Sink;
use model::AttrValue;
use packages::nearest;
use project::{ProjectNameKind, SpannedName, is_computed};

/// Report the groups that no SRDF of the robot defines. With `may_lack`, some groups have no such settings, as a gripper has no
/// kinematics solver and any group plans with the defaults: then a name counts as left over, unless it resembles that of a group without
/// settings.
pub(super) fn unknown(
    cx: &BesideCx<'_>,
    out: &mut Sink<'_>,
    groups: &[SpannedName],
    (what, may_lack): (&str, bool),
) {
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
    let (set, unset): (Vec<&AttrValue>, Vec<&AttrValue>) = defined.partition(|name| has(name));
    let is_left_over = |group: &SpannedName| {
        let names = unset.iter().map(|name| name.value.as_str());
        unset.is_empty() || may_lack && !set.is_empty() && nearest(&group.name, names).is_none()
    };
    for group in groups.iter().filter(|group| !is_computed(&group.name)) {
        if cx.lacks(ProjectNameKind::Group, &group.name) {
            let message = format!("{what} for unknown group `{}`", group.name);
            let severity = if is_left_over(group) {
                Severity::Info
            } else {
                Severity::Warning
            };
            let report = cx.report(out, group, message).severity(severity);
            report
                .help(cx.advice(ProjectNameKind::Group, &group.name))
                .done();
        }
    }
}
