//! Mass and inertia.

use super::super::inertia::{Verdict, verdict};
use super::facts::{Facts, Found, link_owner};
use model::{Inertial, Link};

/// Below, simulators take a moving link for one without mass, kg.
const TINY_MASS: f64 = 1e-6;
/// The same for its greatest moment, kg m².
const TINY_INERTIA: f64 = 1e-12;
/// From here on, MuJoCo warns and cuts the mass, kg.
const HUGE_MASS: f64 = 1e10;

pub(super) fn find(facts: &Facts<'_, '_>, out: &mut Found) {
    for (index, link) in facts.robot.links.iter().enumerate() {
        let is_root = facts.kinematics.up(index).is_empty();
        match &link.inertial {
            Some(inertial) => {
                if is_root {
                    out.add("root-inertia", facts.at(inertial.element), link_owner(link));
                }
                written(facts, (index, link), inertial, is_root, out);
            }
            None => missing(facts, (index, link), is_root, out),
        }
    }
}

fn missing(facts: &Facts<'_, '_>, (index, link): (usize, &Link), is_root: bool, out: &mut Found) {
    let at = facts.at_name(link.name.as_ref(), link.element);
    let name = match (is_root, facts.moves(index)) {
        (true, _) if facts.robot.joints.is_empty() => return,
        (true, _) if !facts.carries_mass(index) && has_moving_child(facts, index) => "massless-root",
        (true, _) => return,
        (false, true) if facts.carries_mass(index) => return,
        (false, true) if has_moving_child(facts, index) => "no-inertial-inside",
        (false, true) => "no-inertial",
        (false, false) => "no-inertial-fixed",
    };
    out.add(name, at, link_owner(link));
}

/// Whether a link, or one that is fixed below it, has a child that moves.
fn has_moving_child(facts: &Facts<'_, '_>, link: usize) -> bool {
    let mut open = vec![link];
    let mut steps = 0;
    while let Some(link) = open.pop().filter(|_| steps <= facts.robot.links.len()) {
        steps += 1;
        for (kind, child) in facts.children_of(link) {
            match kind {
                Some(model::JointType::Fixed) => open.push(child),
                Some(_) => return true,
                None => {}
            }
        }
    }
    false
}

fn written(
    facts: &Facts<'_, '_>,
    (index, link): (usize, &Link),
    inertial: &Inertial,
    is_root: bool,
    out: &mut Found,
) {
    let owner = link_owner(link);
    let mut add = |name: &str, element| out.add(name, facts.at(element), owner.as_str());
    if facts.children(link.element, "inertial").nth(1).is_some() {
        add("two-inertials", inertial.element);
    }
    if facts.children(inertial.element, "mass").nth(1).is_some() {
        add("two-masses", inertial.element);
    }
    match (inertial.mass_element, inertial.inertia_element) {
        (None, None) => return add("empty-inertial", inertial.element),
        (None, Some(_)) => return add("no-mass", inertial.element),
        (Some(_), None) => return add("no-inertia", inertial.element),
        (Some(_), Some(_)) => {}
    }
    let (Some(mass), Some(entries)) = (inertial.mass(), inertial.entries()) else { return };
    let moves = !is_root && facts.moves(index);
    let greatest = entries.into_iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let judged = verdict(entries);
    if let Some(name) = mass_row(mass, greatest, moves, is_root) {
        add(name, inertial.element);
    }
    if let Some(name) = inertia_row(mass, entries, judged) {
        add(name, inertial.inertia_element.unwrap_or(inertial.element));
    }
}

fn mass_row(mass: f64, greatest: f64, moves: bool, is_root: bool) -> Option<&'static str> {
    Some(match (mass == 0.0, greatest == 0.0) {
        _ if mass < 0.0 => "mass-negative",
        _ if mass >= HUGE_MASS => "mass-huge",
        (true, _) if is_root => return None,
        (true, true) if moves => "mass-and-inertia-zero",
        (true, true) => "mass-and-inertia-zero-fixed",
        (true, false) if moves => "mass-zero",
        (true, false) => "mass-zero-fixed",
        (false, _) if moves && mass < TINY_MASS && greatest < TINY_INERTIA => "mass-tiny",
        _ => return None,
    })
}

fn inertia_row(mass: f64, [ixx, _, _, iyy, _, izz]: [f64; 6], judged: Verdict) -> Option<&'static str> {
    match judged {
        _ if ixx < 0.0 || iyy < 0.0 || izz < 0.0 => Some("inertia-negative"),
        Verdict::Zero => (mass > 0.0).then_some("inertia-zero"),
        Verdict::Negative | Verdict::Singular => Some("inertia-not-positive-definite"),
        Verdict::Definite([a, b, c]) => (a + b < c * (1.0 - 1e-6)).then_some("inertia-triangle"),
    }
}
