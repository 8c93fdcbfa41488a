//! F24: each quick fix of the list, by an example.

use super::actions::{FILE, fixes, robot, show, titled};
use super::client::Client;
use super::workspace::write;

const MODEL: &str = "<link name=\"🤖\"/><link name=\"b\"/>";

/// A revolute joint, its type and what stands in it.
fn joint(kind: &str, rest: &str) -> String {
    robot(&format!(
        "{MODEL}<joint name=\"j\" type=\"{kind}\"><parent link=\"🤖\"/><child link=\"b\"/>{rest}</joint>"
    ))
}

const AXIS: &str = "<axis xyz=\"0 0 1\"/>";
const LIMIT: &str = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";

/// The text after the fix of this title for the only finding of a rule.
#[track_caller]
fn fixed(client: &mut Client, text: &str, rule: &str, title: &str) -> String {
    show(client, text);
    let found = fixes(client, FILE, rule);
    let action = titled(&found, title);
    assert_eq!(action["diagnostics"][0]["code"], rule, "{action}");
    client.after(FILE, &action["edit"])
}

#[test]
fn fixes_of_syntax_and_of_xacro() {
    let mut client = Client::start();
    let unbound = "<robot name=\"🤖\">\n<xacro:property name=\"a\" value=\"1\"/><link name=\"l${a}\"/>\n</robot>\n";
    let old = robot(MODEL).replace("http://www.ros.org/wiki/xacro", "http://ros.org/wiki/xacro");
    let call = |call: &str| {
        robot(&format!(
            "<xacro:macro name=\"m\" params=\"size:=1 tool\"><link name=\"l${{size}}${{tool}}\"/></xacro:macro>{call}"
        ))
    };
    let unused = |what: &str| robot(&format!("{MODEL}\n  {what}"));
    for (text, rule, title, expected) in [
        (
            robot("<link name=\"🤖${m_0}\"/><xacro:property name=\"m0\" value=\"1\"/>")
                .replace("m_0", "m1"),
            "undefined-property",
            "Add property `m1`",
            "name=\"m1\" value=\"0\"",
        ),
        (
            unbound.to_owned(),
            "missing-xacro-namespace",
            "Declare the prefix",
            "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"",
        ),
        (
            old,
            "nonstandard-xacro-namespace",
            "",
            "\"http://www.ros.org/wiki/xacro\"",
        ),
        (
            robot("<link name=\"🤖\"><visual></link>"),
            "xml-syntax-error",
            "Add `</visual>`",
            "</visual></link>",
        ),
        (
            robot("<link name=\"🤖\"></lnk>"),
            "xml-syntax-error",
            "Change end tag to `link`",
            "</link>",
        ),
        (
            robot("<link name=\"🤖\" name=\"b\"/>"),
            "xml-syntax-error",
            "Remove duplicate `name`",
            "<link name=\"🤖\"/>",
        ),
        (
            robot("<link name=\"🤖 & b\"/>"),
            "xml-syntax-error",
            "Replace with `&amp;`",
            "🤖 &amp; b",
        ),
        (
            robot("<link name=\"🤖 < b\"/>"),
            "xml-syntax-error",
            "Replace with `&lt;`",
            "🤖 &lt; b",
        ),
        (
            call("<xacro:m tool=\"🤖\" sise=\"2\"/>"),
            "unknown-macro-param",
            "size",
            "<xacro:m tool=\"🤖\" size=\"2\"/>",
        ),
        (
            call("<xacro:m tool=\"🤖\" sise=\"2\"/>"),
            "unknown-macro-param",
            "Remove `sise`",
            "<xacro:m tool=\"🤖\"/>",
        ),
        (
            robot("<link name=\"🤖$(arg side)\"/>"),
            "undefined-arg",
            "Add argument `side`",
            "<xacro:arg name=\"side\" default=\"\"/>",
        ),
        (
            robot("<xacro:lens prefix=\"🤖\"/>"),
            "undefined-macro",
            "Include `$(find lens)/urdf/lens.xacro`",
            "$(find lens)/urdf/lens.xacro\"/>",
        ),
        (
            robot("<xacro:lensy prefix=\"🤖\"/>"),
            "undefined-macro",
            "Add macro `lensy`",
            "<xacro:macro name=\"lensy\" params=\"prefix\">",
        ),
        (
            unused("<xacro:property name=\"spare\" value=\"🤖\"/>"),
            "unused-property",
            "Remove",
            "<link name=\"b\"/>\n</robot>",
        ),
        (
            unused("<xacro:macro name=\"spare\" params=\"a\"><link name=\"${a}\"/></xacro:macro>"),
            "unused-macro",
            "Remove",
            "<link name=\"b\"/>\n</robot>",
        ),
        (
            unused("<xacro:include filename=\"unit.xacro\"/>"),
            "unused-include",
            "Remove",
            "<link name=\"b\"/>\n</robot>",
        ),
    ] {
        let made = fixed(&mut client, &text, rule, title);
        assert!(made.contains(expected), "{rule}: {made}");
    }
}

#[test]
fn fixes_of_the_robot() {
    let mut client = Client::start();
    write(&client.folder, "src/pan_tilt/meshes/Head.STL", cube(100.0));
    write(
        &client.folder,
        "src/pan_tilt/meshes/parts/arm.stl",
        cube(0.1),
    );
    let mesh = |file: &str| {
        let geometry =
            format!("<geometry><mesh filename=\"package://pan_tilt/meshes/{file}\"/></geometry>");
        robot(&format!(
            "<link name=\"🤖\"><visual>{geometry}</visual></link>"
        ))
    };
    let limit = |lower: &str, upper: &str| {
        joint(
            "revolute",
            &format!(
                "{AXIS}{}",
                LIMIT.replace("\"-1\"", lower).replace("upper=\"1\"", upper)
            ),
        )
    };
    for (text, rule, title, expected) in [
        (
            joint("Fixed", ""),
            "unknown-joint-type",
            "",
            "type=\"fixed\"",
        ),
        (
            joint("revolut", &format!("{AXIS}{LIMIT}")),
            "unknown-joint-type",
            "revolute",
            "type=\"revolute\"",
        ),
        (
            joint("revolute", AXIS),
            "missing-joint-limit",
            "Add `limit`",
            "<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>",
        ),
        (
            joint("revolute", LIMIT),
            "missing-axis",
            "",
            "<axis xyz=\"1 0 0\"/>",
        ),
        (
            joint("revolute", &format!("<axis xyz=\"0 0 2\"/>{LIMIT}")),
            "axis-not-normalized",
            "",
            "<axis xyz=\"0 0 1\"/>",
        ),
        (
            limit("\"1\"", "upper=\"-1\""),
            "joint-limit-inverted",
            "Swap",
            "lower=\"-1\" upper=\"1\"",
        ),
        (
            limit("\"-90\"", "upper=\"90\""),
            "joint-limit-degrees",
            "",
            "${radians(",
        ),
        (
            robot("<link name=\"🤖\"><inertial><mass/></inertial></link>"),
            "missing-attribute",
            "Add `value`",
            "<mass value=\"\"/>",
        ),
        (
            robot(
                "<link name=\"🤖\"/><joint name=\"j\" type=\"fixed\"><parent link=\"🤖\"/><child link=\"tip\"/></joint>",
            ),
            "undefined-link",
            "Add link `tip`",
            "<link name=\"tip\"/>",
        ),
        (
            robot(
                "<link name=\"🤖\"><visual><geometry><sphere radius=\"1\"/></geometry><material name=\"red\"/></visual></link>",
            ),
            "undefined-material",
            "Add material `red`",
            "<material name=\"red\"><color",
        ),
        (
            mesh("head.stl"),
            "mesh-case-mismatch",
            "Replace with `",
            "meshes/Head.STL\"",
        ),
        (
            mesh("arm.stl"),
            "mesh-not-found",
            "parts/arm.stl",
            "meshes/parts/arm.stl\"",
        ),
        (
            mesh("Head.STL"),
            "mesh-scale-suspicious",
            "millimeters",
            "scale=\"0.001 0.001 0.001\"",
        ),
    ] {
        let made = fixed(&mut client, &text, rule, title);
        assert!(made.contains(expected), "{rule}: {made}");
    }
    // the message names the mesh as the file does, not from the root of the disk
    show(&mut client, &mesh("head.stl"));
    let found = client.diagnostics(FILE);
    let found = found
        .iter()
        .find(|found| found["code"] == "mesh-case-mismatch")
        .unwrap();
    let message = found["message"].as_str().unwrap();
    assert!(
        message.contains("`package://pan_tilt/meshes/Head.STL`"),
        "{message}"
    );
    assert!(
        !message.contains(client.folder.to_str().unwrap()),
        "{message}"
    );
}

/// A binary STL file of a cube; its edges in the unit of the file.
pub fn cube(edge: f32) -> Vec<u8> {
    let sides = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let corner = |i: u32| {
        [
            (i & 1) as f32 * edge,
            ((i >> 1) & 1) as f32 * edge,
            (i >> 2) as f32 * edge,
        ]
    };
    let mut bytes = vec![b' '; 80];
    bytes.extend(12_u32.to_le_bytes());
    for [a, b, c, d] in sides {
        for triangle in [[a, b, c], [a, c, d]] {
            bytes.extend([0_u8; 12]);
            bytes.extend(
                triangle
                    .into_iter()
                    .flat_map(corner)
                    .flat_map(f32::to_le_bytes),
            );
            bytes.extend([0_u8; 2]);
        }
    }
    bytes
}

const MANIFEST: &str = "src/pan_tilt/package.xml";

#[test]
fn a_package_that_is_used_is_declared() {
    let mut client = Client::start();
    client.open(MANIFEST);
    write(&client.folder, "src/lens/meshes/l.stl", cube(0.1));
    let mesh = "<mesh filename=\"package://lens/meshes/l.stl\"/>";
    for text in [
        robot(
            "<!-- 🤖 --><xacro:include filename=\"$(find lens)/urdf/lens.xacro\"/><xacro:lens prefix=\"a\"/>",
        ),
        robot(&format!(
            "<link name=\"🤖\"><visual><geometry>{mesh}</geometry></visual></link>"
        )),
    ] {
        show(&mut client, &text);
        let found = fixes(&mut client, FILE, "missing-package-dependency");
        let fix = titled(&found, "Add the dependency to package.xml");
        assert_eq!(fix["isPreferred"], true, "{fix}");
        let made = client.after(MANIFEST, &fix["edit"]);
        assert!(made.contains("<exec_depend>lens</exec_depend>"), "{made}");
    }
    // what the manifest says before it is saved counts
    client.edit(
        MANIFEST,
        "<exec_depend>",
        "<!-- 🤖 --><depend>lens</depend><exec_depend>",
    );
    let is_clean = |client: &mut Client| {
        !client
            .findings(FILE)
            .iter()
            .any(|found| found.ends_with("missing-package-dependency"))
    };
    assert!(client.eventually(is_clean));
}

#[test]
fn a_missing_parameter_gets_no_empty_value_that_makes_no_sense() {
    let mut client = Client::start();
    let call = |parameter: &str| {
        robot(&format!(
            "<xacro:macro name=\"m\" params=\"{parameter}\"><link name=\"🤖${{{parameter}}}\"/></xacro:macro><xacro:m/>"
        ))
    };
    show(&mut client, &call("length"));
    let found = fixes(&mut client, FILE, "missing-macro-param");
    let adds = |action: &serde_json::Value| action.to_string().contains("=\\\"\\\"");
    assert!(!found.iter().any(adds), "{found:?}");
    show(&mut client, &call("prefix"));
    let found = fixes(&mut client, FILE, "missing-macro-param");
    titled(&found, "Add the missing parameters with empty values");
}

#[test]
fn errors_that_come_from_an_argument_begin_with_the_question_for_its_value() {
    let mut client = Client::start();
    write(
        &client.folder,
        "src/pan_tilt/config/arm_small/size.yaml",
        "length: 1\n",
    );
    write(
        &client.folder,
        "src/pan_tilt/config/arm_big/size.yaml",
        "width: 2\n",
    );
    write(
        &client.folder,
        "src/pan_tilt/urdf/arm_small.xacro",
        "<robot/>\n",
    );
    let load = "<xacro:property name=\"c\" value=\"${xacro.load_yaml('$(find pan_tilt)/config/$(arg kind)/size.yaml')}\"/>";
    let arg = |value: &str| {
        format!("<!-- one of: arm_big, arm_tiny --><xacro:arg name=\"kind\" default=\"{value}\"/>")
    };
    let link = "<link name=\"🤖${c['length']}\"/>";
    for (text, rule, values) in [
        (
            format!("{}{load}{link}", arg("none")),
            "expression-error",
            vec!["arm_big", "arm_small", "arm_tiny"],
        ),
        (
            format!("{}{load}{link}", arg("arm_big")),
            "undefined-property",
            vec!["arm_big", "arm_small", "arm_tiny"],
        ),
        (
            format!(
                "{}<link name=\"🤖${{dict(a=1)['$(arg kind)']}}\"/>",
                arg("none")
            ),
            "expression-error",
            vec!["arm_big", "arm_tiny"],
        ),
        (
            format!(
                "{}<xacro:if value=\"$(arg kind)\"><link name=\"🤖\"/></xacro:if>",
                arg("none")
            ),
            "invalid-condition",
            vec!["arm_big", "arm_tiny"],
        ),
        (
            format!(
                "{}<xacro:include filename=\"$(arg kind).xacro\"/><link name=\"🤖\"/>",
                arg("none")
            ),
            "include-not-found",
            vec!["arm_small", "arm_big", "arm_tiny"],
        ),
        (
            format!(
                "{}<link name=\"🤖${{float('$(arg kind)')}}\"/>",
                arg("none")
            ),
            "expression-error",
            vec!["arm_big", "arm_tiny"],
        ),
    ] {
        show(&mut client, &robot(&text));
        let found = fixes(&mut client, FILE, rule);
        assert_eq!(
            found[0]["title"], "Set argument `kind`…",
            "{text}: {found:?}"
        );
        let offered = found[0]["command"]["arguments"][0]["values"].clone();
        let offered: Vec<&str> = offered
            .as_array()
            .unwrap()
            .iter()
            .map(|value| value.as_str().unwrap())
            .collect();
        for value in values {
            assert!(offered.contains(&value), "{text}: {offered:?}");
        }
    }
    // an error that no argument has a part in
    show(
        &mut client,
        &robot(&format!(
            "{}<link name=\"🤖${{1/0}}$(arg kind)\"/>",
            arg("none")
        )),
    );
    let found = fixes(&mut client, FILE, "expression-error");
    let sets = |action: &serde_json::Value| action["title"].as_str().unwrap().starts_with("Set");
    assert!(!found.iter().any(sets), "{found:?}");
}

#[test]
fn an_error_of_an_argument_begins_with_the_question_for_its_value() {
    let mut client = Client::start();
    show(&mut client, &robot("<link name=\"🤖$(arg side)\"/>"));
    let found = fixes(&mut client, FILE, "undefined-arg");
    assert_eq!(found[0]["title"], "Set argument `side`…", "{found:?}");
    let command = &found[0]["command"];
    assert_eq!(command["command"], "xacro.setArgs");
    assert_eq!(command["arguments"][0]["name"], "side");
    assert!(command["arguments"][0]["values"].is_array(), "{command}");
}

#[test]
fn a_comment_behind_an_argument_lists_its_values() {
    let mut client = Client::start();
    let text = "  <xacro:arg name=\"size\" default=\"none\"/> <!-- one of: small, big -->\n  \
        <xacro:arg name=\"side\" default=\"none\"/>\n  <link name=\"🤖${int('$(arg size)') + int('$(arg side)')}\"/>";
    show(&mut client, &robot(text));
    let found = fixes(&mut client, FILE, "expression-error");
    let values = |number: usize| found[number]["command"]["arguments"][0]["values"].clone();
    assert_eq!(found[0]["title"], "Set argument `size`…", "{found:?}");
    assert_eq!(values(0), serde_json::json!(["small", "big"]));
    // it says nothing of the argument on the next line
    assert_eq!(found[1]["title"], "Set argument `side`…", "{found:?}");
    assert_eq!(values(1), serde_json::json!([]));
}

#[test]
fn the_page_of_a_rule_is_a_command() {
    let mut client = Client::start();
    let params = serde_json::json!({ "command": "xacro.explain", "arguments": [{ "rule": "undefined-arg" }] });
    let page = client.request("workspace/executeCommand", params);
    assert!(
        page.as_str()
            .is_some_and(|page| page.contains("undefined-arg")),
        "{page}"
    );
}
