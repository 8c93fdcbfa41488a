//! The words of URDF and of xacro.
use super::schema;
use facts::xacro_tag;
use xml::Node;

/// Whether URDF knows an element.
pub(super) fn is_urdf_element(name: &str) -> bool {
    schema::is_urdf(name)
}

/// Whether the content of an element is none of URDF's business.
pub(super) fn is_free_zone(name: &str) -> bool {
    // asked for each element by many rules
    matches!(
        name,
        "gazebo" | "mujoco" | "ros2_control" | "sdf" | "sensor" | "transmission"
    ) || name.bytes().any(|byte| byte == b':') && !name.starts_with("xacro:")
}

/// Whether an element without a prefix is most likely a tag of xacro. Names that are common elsewhere (`element`, `attribute`,
/// `call`) are not.
pub(super) fn is_forgotten_prefix(name: &str) -> bool {
    xacro_tag(name).is_some_and(|tag| !tag.is_common_word)
}

/// The element of SDF for friction and contacts of a collision. URDF has none.
pub(super) const SDF_SURFACE: &str = "surface";

/// Whether a link stands for the surroundings of a robot by its name.
pub(super) fn is_surroundings(link: &str) -> bool {
    matches!(link, "world" | "map" | "odom" | "earth")
}

/// Whether a hardware plugin of ros2_control is that of a simulator, by its name.
pub(super) fn is_simulator_plugin(plugin: &str) -> bool {
    const SIMULATORS: [&str; 5] = ["gazebo", "gz_", "ign_", "isaac", "webots"];
    let name = plugin.to_lowercase();
    SIMULATORS.iter().any(|word| name.contains(word))
}

/// Passes over the content of free zones, in a row of elements as they follow each other in a document; the elements that
/// make the zones stay. Each is given with the offset of its item.
pub(super) fn outside_free_zones<'a>(
    elements: impl Iterator<Item = (u32, Node<'a>)>,
) -> impl Iterator<Item = (u32, Node<'a>)> {
    let mut end = 0;
    elements.filter(move |(base, node)| {
        let range = node.range().shift(*base);
        let is_outside = range.start >= end;
        if is_outside && is_free_zone(node.name()) {
            end = range.end;
        }
        is_outside
    })
}

/// The namespace that xacro's documentation names.
pub(super) const XACRO_URI: &str = "http://www.ros.org/wiki/xacro";

/// Whether a namespace is meant to be xacro's: files in the wild spell it in many ways.
pub(super) fn is_xacro_uri(uri: &str) -> bool {
    let rest = uri
        .trim_start_matches("http://")
        .trim_start_matches("https://");
    let host = rest
        .split('/')
        .next()
        .unwrap_or("")
        .trim_start_matches("www.");
    matches!(host, "ros.org" | "wiki.ros.org") && rest.trim_end_matches('/').ends_with("xacro")
}
#[cfg(test)]
mod tests {
    #[test]
    fn no_rule_about_forgotten_prefixes_speaks_of_an_ordinary_tag() {
        for tag in facts::ORDINARY_TAGS {
            assert!(super::is_urdf_element(tag), "{tag}");
            assert!(!super::is_forgotten_prefix(tag), "{tag}");
            assert!(!super::is_free_zone(tag), "{tag}");
            assert!(!facts::is_keyword(tag), "{tag}");
        }
    }

    #[test]
    fn words() {
        assert!(
            ["robot", "link", "capsule", "gazebo", "ros2_control"].map(super::is_urdf_element)
                == [true; 5]
        );
        assert!(["lnik", "hardware", "param"].map(super::is_urdf_element) == [false; 3]);
    }
}
