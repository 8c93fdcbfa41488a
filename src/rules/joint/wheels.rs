//! Wheels: pairs of them, and where their axes point.
use nalgebra::Vector3;

use model::{Joint, transform};

/// Words for one side of a robot, and the same for the other one.
const SIDES: [(&str, &str); 4] = [("left", "right"), ("l", "r"), ("lf", "rf"), ("lr", "rr")];

/// The name of the joint on the other side, in small letters; none when the name tells no side.
pub(super) fn other_side(name: &str) -> Option<String> {
    let name = name.to_lowercase();
    let mut other = String::new();
    let mut found = false;
    for part in name.split_inclusive(|c: char| !c.is_alphanumeric()) {
        let word = part.trim_end_matches(|c: char| !c.is_alphanumeric());
        let new = swapped(word);
        found |= new.is_some();
        other.push_str(new.unwrap_or(word));
        other.push_str(part.get(word.len()..).unwrap_or_default());
    }
    if found {
        return Some(other);
    }
    // `leftwheel`, `wheelLeft`
    let long = SIDES
        .iter()
        .take(1)
        .flat_map(|&(left, right)| [(left, right), (right, left)]);
    long.into_iter()
        .find(|(from, _)| name.contains(from))
        .map(|(from, to)| name.replacen(from, to, 1))
}

/// The word for the other side.
fn swapped(word: &str) -> Option<&'static str> {
    let &(left, right) = SIDES
        .iter()
        .find(|(left, right)| *left == word || *right == word)?;
    Some(if left == word { right } else { left })
}

/// The axis of a joint in the frame of its parent; none when a value is not known or there is no direction.
pub(super) fn axis_in_parent(joint: &Joint) -> Option<Vector3<f64>> {
    let axis = Vector3::from(joint.axis()?).try_normalize(1e-9)?;
    Some(transform(joint.origin.as_ref())?.rotation * axis)
}

#[cfg(test)]
mod tests {
    use super::other_side;

    #[test]
    fn the_other_side_has_the_other_word() {
        let other = |name| other_side(name).unwrap_or_default();
        assert_eq!(other("left_wheel_joint"), "right_wheel_joint");
        assert_eq!(other("wheel_RF"), "wheel_lf");
        assert_eq!(other("joint-r"), "joint-l");
        assert_eq!(other("leftWheel"), "rightwheel");
        assert_eq!(other_side("wheel_front"), None);
    }
}
