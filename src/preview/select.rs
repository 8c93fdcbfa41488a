//! Which links and joints a place of the source makes.

use super::locations::{Location, LocationMapper};
use super::messages::Selection;
use base::TextRange;
use expand::{FileIdx, Origin, XId};
use model::{Robot, element_range, tag_start};

/// The links and joints that the text at a place makes: those whose elements stand around it, else those that came
/// through the call there.
pub(super) fn made_by(
    robot: &Robot,
    places: &LocationMapper<'_>,
    location: &Location,
) -> Selection {
    let Some((file, at)) = places.range(location) else {
        return Selection::default();
    };
    let direct = select(robot, &|element| {
        covers(places, element_range(places.expansion, element), file, at).map(|_| 0)
    });
    if !direct.links.is_empty() || !direct.joints.is_empty() {
        return direct;
    }
    // of the calls around the place the innermost: the shortest
    let through = |element: XId| {
        let origin = places.expansion.tree.get(element).origin;
        let calls = places.expansion.frames_of(origin).map(|frame| frame.call);
        calls
            .filter_map(|call| covers(places, whole(places, call), file, at))
            .min()
    };
    let all = robot
        .links
        .iter()
        .map(|link| link.element)
        .chain(robot.joints.iter().map(|j| j.element));
    let Some(shortest) = all.filter_map(through).min() else {
        return Selection::default();
    };
    select(robot, &|element| {
        through(element).filter(|length| *length == shortest)
    })
}

/// Where a link or a joint stands.
pub(super) fn location_of(
    robot: &Robot,
    places: &LocationMapper<'_>,
    link: Option<&str>,
    joint: Option<&str>,
) -> Option<Location> {
    let link = link
        .and_then(|name| robot.link(name))
        .map(|link| link.element);
    let joint = joint
        .and_then(|name| robot.joint(name))
        .map(|joint| joint.element);
    places.of(tag_start(places.expansion, link.or(joint)?))
}

fn select(robot: &Robot, found: &dyn Fn(XId) -> Option<u32>) -> Selection {
    let links = robot
        .links
        .iter()
        .filter(|link| found(link.element).is_some());
    let joints = robot
        .joints
        .iter()
        .filter(|joint| found(joint.element).is_some());
    Selection {
        links: links.map(|link| link.shown().to_owned()).collect(),
        joints: joints.map(|joint| joint.shown().to_owned()).collect(),
        ..Selection::default()
    }
}

/// The length of a text that holds a place; none when it does not.
fn covers(
    places: &LocationMapper<'_>,
    origin: Origin,
    file: FileIdx,
    at: TextRange,
) -> Option<u32> {
    let place = places.expansion.place(origin)?;
    let holds = place.file == file && place.range.start <= at.start && at.end <= place.range.end;
    holds.then(|| place.range.len())
}

/// The whole element whose start tag is at `tag`.
fn whole(places: &LocationMapper<'_>, tag: Origin) -> Origin {
    let source = places.expansion.sources.get(tag.src);
    let node = source.and_then(|source| source.item.element_at(tag.range.start));
    node.map_or(tag, |node| Origin {
        range: node.range(),
        ..tag
    })
}
