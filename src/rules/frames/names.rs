//! Names of frames with their prefixes.
use model::Robot;

/// What stands in front of `frame` in a name: nothing, or a prefix with its separator. None when the name is
/// another one.
pub(super) fn prefix_of<'a>(name: &'a str, frame: &str) -> Option<&'a str> {
    let prefix = name.strip_suffix(frame)?;
    (prefix.is_empty() || prefix.ends_with(['_', '/', '-', '.'])).then_some(prefix)
}

/// Whether a robot has a joint that moves: objects and sensors follow no conventions about bases.
pub(super) fn can_move(robot: &Robot) -> bool {
    robot
        .joints
        .iter()
        .any(|joint| joint.joint_type().is_some_and(|kind| kind.has_axis()))
}

#[cfg(test)]
mod tests {
    use super::prefix_of;

    #[test]
    fn prefixes_end_with_a_separator() {
        assert_eq!(prefix_of("tool0", "tool0"), Some(""));
        assert_eq!(prefix_of("left/tool0", "tool0"), Some("left/"));
        assert_eq!(prefix_of("database", "base"), None);
        assert_eq!(prefix_of("tool0_mount", "tool0"), None);
    }
}
