//! Mass and inertia.
use super::super::inertia::principal;
use super::bodies::RigidBody;
use super::facts::{ConstructCollector, RobotFacts, link_owner};
use model::{Inertial, Link};

/// Up to here, Gazebo takes a mass for zero, kg.
const TINY_MASS: f64 = 1e-6;
/// Below, MuJoCo takes a principal moment for zero, kg m².
const TINY_MOMENT: f64 = 1e-14;
/// From here on, MuJoCo warns and cuts the mass, kg.
const HUGE_MASS: f64 = 1e10;
/// Consumers compare moments as they are; this part of the greatest is our own rounding.
const ROUNDING: f64 = 1e-12;

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    for body in &facts.bodies {
        for &index in &body.links {
            let Some(link) = facts.robot.links.get(index) else {
                continue;
            };
            let is_top = body.links.first() == Some(&index);
            match &link.inertial {
                Some(inertial) => {
                    if body.is_root && is_top {
                        out.add("root-inertia", facts.at(inertial.element), link_owner(link));
                    }
                    written(facts, link, inertial, (body, is_top), out);
                }
                None => missing(facts, link, (body, is_top), out),
            }
        }
    }
}

fn missing(
    facts: &RobotFacts<'_, '_>,
    link: &Link,
    (body, is_top): (&RigidBody, bool),
    out: &mut ConstructCollector,
) {
    let name = match (is_top, body.is_root) {
        (true, true) if facts.robot.joints.is_empty() || body.has_mass => return,
        (true, true) => "massless-root",
        (true, false) if links(facts, body).any(|link| link.inertial.is_some()) => return,
        (true, false) if links(facts, body).any(|link| !link.collisions.is_empty()) => {
            "no-inertial-with-collision"
        }
        (true, false) => "no-inertial",
        (false, _) => "no-inertial-fixed",
    };
    out.add(
        name,
        facts.at_name(link.name.as_ref(), link.element),
        link_owner(link),
    );
}

/// The links of a body, the one that moves first.
fn links<'a>(facts: &RobotFacts<'a, '_>, body: &RigidBody) -> impl Iterator<Item = &'a Link> {
    let robot = facts.robot;
    body.links
        .iter()
        .filter_map(|&index| robot.links.get(index))
}

fn written(
    facts: &RobotFacts<'_, '_>,
    link: &Link,
    inertial: &Inertial,
    (body, is_top): (&RigidBody, bool),
    out: &mut ConstructCollector,
) {
    let owner = link_owner(link);
    let at = facts.at(inertial.element);
    if facts.children(link.element, "inertial").nth(1).is_some() {
        out.add("two-inertials", at, owner);
    }
    if facts.children(inertial.element, "mass").nth(1).is_some() {
        out.add("two-masses", at, owner);
    }
    match (inertial.mass_element, inertial.inertia_element) {
        (None, None) => return out.add("empty-inertial", at, owner),
        (None, Some(_)) => return out.add("no-mass", at, owner),
        (Some(_), None) => return out.add("no-inertia", at, owner),
        (Some(_), Some(_)) => {}
    }
    let (Some(mass), Some(entries)) = (inertial.mass(), inertial.entries()) else {
        return;
    };
    if let Some(name) = mass_row(mass, entries == [0.0; 6], body, is_top) {
        out.add(name, at, owner);
    }
    if let Some(name) = inertia_row(entries, body, is_top) {
        let at = inertial
            .inertia_element
            .map_or(at, |element| facts.at(element));
        out.add(name, at, owner);
    }
}

fn mass_row(mass: f64, is_bare: bool, body: &RigidBody, is_top: bool) -> Option<&'static str> {
    let whole = body.sum.map_or(mass, |(mass, _)| mass);
    Some(match (mass == 0.0, is_bare) {
        _ if mass < 0.0 && whole > TINY_MASS => "mass-negative-joined",
        _ if mass < 0.0 && body.is_root => "root-mass-negative",
        _ if mass < 0.0 => "mass-negative",
        _ if mass >= HUGE_MASS => "mass-huge",
        (true, _) if is_top && body.is_root && whole == 0.0 => "root-mass-zero",
        (true, _) if is_top && body.is_root => return None,
        (true, true) if is_top && whole == 0.0 => "mass-and-inertia-zero",
        (true, true) => "mass-and-inertia-zero-fixed",
        (true, false) if is_top && whole == 0.0 => "mass-zero",
        (true, false) => "mass-zero-fixed",
        (false, _) if is_top && !body.is_root && whole <= TINY_MASS => "mass-tiny",
        _ => return None,
    })
}

fn inertia_row(entries: [f64; 6], body: &RigidBody, is_top: bool) -> Option<&'static str> {
    let whole = body.sum.map_or([0.0; 3], |(_, entries)| principal(entries));
    if entries == [0.0; 6] {
        let [least, ..] = whole;
        return (is_top && !body.is_root && least < TINY_MOMENT).then_some("inertia-zero");
    }
    let own = principal(entries);
    let is_joined = body.links.len() > 1 && !is_impossible(whole);
    Some(match own {
        [least, _, most] if least < -ROUNDING * most.abs() => {
            if is_joined {
                "inertia-negative-joined"
            } else {
                "inertia-negative"
            }
        }
        moments if is_impossible(moments) => {
            if is_joined {
                "inertia-triangle-joined"
            } else {
                "inertia-triangle"
            }
        }
        [least, ..] if least < TINY_MOMENT => "inertia-singular",
        _ => return None,
    })
}

/// Whether no body has such moments: one is negative, or greater than the other two together.
fn is_impossible([a, b, c]: [f64; 3]) -> bool {
    a < -ROUNDING * c.abs() || a + b < c * (1.0 - ROUNDING)
}
