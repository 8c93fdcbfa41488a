//! Groups in settings of MoveIt.

use super::super::beside::BesideCx;
use super::super::sink::Sink;
use project::{Kind, Named, is_computed};

/// Report the groups that no SRDF of the robot defines.
pub(super) fn unknown(cx: &BesideCx<'_>, out: &mut Sink<'_>, groups: &[Named], what: &str) {
    // what an SRDF defines is known only where there is one, and where all names in it are known
    let is_known = cx.srdfs().next().is_some()
        && cx.srdfs().all(|srdf| {
            srdf.groups.iter().all(|group| group.name.as_ref().is_some_and(|name| name.is_known()))
        });
    for group in groups.iter().filter(|group| is_known && !is_computed(&group.name)) {
        if cx.srdfs().all(|srdf| srdf.group(&group.name).is_none()) {
            let message = format!("{what} for unknown group `{}`", group.name);
            cx.report(out, group, message).help(cx.advice(Kind::Group, &group.name)).done();
        }
    }
}
