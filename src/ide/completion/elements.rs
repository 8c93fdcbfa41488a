//! Whole elements, as robots nearly always have them: one item inserts all that belongs together.

use super::item::{Completion, ItemKind};

/// A label, what it is good for, and the text behind its `<`.
struct ElementSnippet {
    label: &'static str,
    detail: &'static str,
    snippet: &'static str,
}

const WHOLE: [ElementSnippet; 6] = [
    ElementSnippet {
        label: "link with visual, collision and inertial",
        detail: "a box of 1 kg with the inertia of a solid box",
        snippet: "link name=\"${1:link}\">\n\t<visual>\n\t\t<origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n\t\t<geometry>\n\t\t\t\
                  <box size=\"${2:0.1 0.1 0.1}\"/>\n\t\t</geometry>\n\t</visual>\n\t<collision>\n\t\t\
                  <origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n\t\t<geometry>\n\t\t\t<box size=\"${2:0.1 0.1 0.1}\"/>\n\t\t\
                  </geometry>\n\t</collision>\n\t<inertial>\n\t\t<origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n\t\t\
                  <mass value=\"${3:1.0}\"/>\n\t\t<inertia ixx=\"${4:0.00167}\" ixy=\"0\" ixz=\"0\" \
                  iyy=\"${5:0.00167}\" iyz=\"0\" izz=\"${6:0.00167}\"/>\n\t</inertial>\n</link>$0",
    },
    ElementSnippet {
        label: "joint revolute with limit",
        detail: "a joint that rotates between two angles",
        snippet: "joint name=\"${1:joint}\" type=\"revolute\">\n\t<parent link=\"${2}\"/>\n\t<child link=\"${3}\"/>\n\t\
                  <origin xyz=\"${4:0 0 0}\" rpy=\"0 0 0\"/>\n\t<axis xyz=\"${5:0 0 1}\"/>\n\t\
                  <limit lower=\"${6:-1.57}\" upper=\"${7:1.57}\" effort=\"${8:10}\" velocity=\"${9:1}\"/>\n</joint>$0",
    },
    ElementSnippet {
        label: "joint prismatic with limit",
        detail: "a joint that slides between two positions",
        snippet: "joint name=\"${1:joint}\" type=\"prismatic\">\n\t<parent link=\"${2}\"/>\n\t<child link=\"${3}\"/>\n\t\
                  <origin xyz=\"${4:0 0 0}\" rpy=\"0 0 0\"/>\n\t<axis xyz=\"${5:0 0 1}\"/>\n\t\
                  <limit lower=\"${6:0}\" upper=\"${7:0.1}\" effort=\"${8:10}\" velocity=\"${9:0.1}\"/>\n</joint>$0",
    },
    ElementSnippet {
        label: "joint fixed",
        detail: "connects a link without motion",
        snippet: "joint name=\"${1:joint}\" type=\"fixed\">\n\t<parent link=\"${2}\"/>\n\t<child link=\"${3}\"/>\n\t\
                  <origin xyz=\"${4:0 0 0}\" rpy=\"${5:0 0 0}\"/>\n</joint>$0",
    },
    ElementSnippet {
        label: "link and joint of an optical frame",
        detail: "z forward, x right, y down, for a camera (REP 103)",
        snippet: "link name=\"${1:camera}_optical_frame\"/>\n<joint name=\"${1:camera}_optical_joint\" type=\"fixed\">\n\t\
                  <parent link=\"${1:camera}_link\"/>\n\t<child link=\"${1:camera}_optical_frame\"/>\n\t\
                  <origin xyz=\"0 0 0\" rpy=\"-1.570796 0 -1.570796\"/>\n</joint>$0",
    },
    ElementSnippet {
        label: "ros2_control with a joint",
        detail: "a system with one joint; the plugin is the mock of ros2_control",
        snippet: "ros2_control name=\"${1:system}\" type=\"system\">\n\t<hardware>\n\t\t\
                  <plugin>${2:mock_components/GenericSystem}</plugin>\n\t</hardware>\n\t<joint name=\"${3:joint}\">\n\t\t\
                  <command_interface name=\"${4|position,velocity,effort|}\"/>\n\t\t<state_interface name=\"position\"/>\n\t\t\
                  <state_interface name=\"velocity\"/>\n\t</joint>\n</ros2_control>$0",
    },
];

/// The whole elements that may be children of `<robot>`.
pub(super) fn whole_elements() -> impl Iterator<Item = Completion> {
    WHOLE.iter().map(|whole| {
        Completion::new(ItemKind::Snippet, whole.label)
            .text(plain(whole.snippet))
            .snippet(whole.snippet)
            .note("snippet")
            .detail(whole.detail)
            .rank(3)
    })
}

/// The text of a snippet for editors without places to fill in: the first word of each choice, and each default.
fn plain(snippet: &str) -> String {
    let mut text = String::new();
    let mut rest = snippet;
    while let Some((before, after)) = rest.split_once('$') {
        text.push_str(before);
        rest = after.trim_start_matches(|c: char| c.is_ascii_digit());
        if let Some((place, behind)) = after
            .strip_prefix('{')
            .and_then(|place| place.split_once('}'))
        {
            let value = place.trim_start_matches(|c: char| c.is_ascii_digit());
            let choice = value
                .strip_prefix('|')
                .and_then(|words| words.split([',', '|']).next());
            text.push_str(choice.unwrap_or_else(|| value.trim_start_matches(':')));
            rest = behind;
        }
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::{WHOLE, plain};

    #[test]
    fn without_places_a_snippet_is_its_defaults() {
        assert_eq!(
            plain("a x=\"${1:0 1}\" y=\"${2}\" z=\"${3|b,c|}\"/>$0"),
            "a x=\"0 1\" y=\"\" z=\"b\"/>"
        );
        for whole in &WHOLE {
            assert!(
                xml::Document::parse(&format!("<r><{}</r>", plain(whole.snippet)))
                    .errors()
                    .is_empty()
            );
        }
    }
}
