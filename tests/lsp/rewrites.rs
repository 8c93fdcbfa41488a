//! F25: numbers, properties, calls and elements written in another way, and what links and joints lack.

use serde_json::{Value, json};

use super::actions::{FILE, actions, robot, show, titled};
use super::client::{Client, Options};
use super::workspace::{ROBOT, ROBOT_TEXT, pan_tilt, write};

const SOLID: &str = "  <link name=\"a\">
    <inertial><mass value=\"${3 * 4}\"/></inertial>
    <collision><origin xyz=\"0 0 1\"/><geometry><box size=\"1 2 3\"/></geometry></collision>
  </link>";

#[test]
fn inertia_follows_from_the_geometry() {
    let mut client = Client::start();
    for (shape, expected) in [
        ("<box size=\"1 2 3\"/>", ["13", "10", "5"]),
        ("<cylinder radius=\"1\" length=\"2\"/>", ["7", "7", "6"]),
        (
            "<capsule radius=\"1\" length=\"2\"/>",
            ["14.52", "14.52", "5.52"],
        ),
        ("<sphere radius=\"0.5\"/>", ["1.2", "1.2", "1.2"]),
    ] {
        show(
            &mut client,
            &robot(&SOLID.replace("<box size=\"1 2 3\"/>", shape)),
        );
        let found = actions(&mut client, FILE, "<in|ertial>", &[], &["refactor.rewrite"]);
        let made = client.after(FILE, &titled(&found, "Compute inertia")["edit"]);
        let [x, y, z] = expected;
        let inertia =
            format!("<inertia ixx=\"{x}\" ixy=\"0\" ixz=\"0\" iyy=\"{y}\" iyz=\"0\" izz=\"{z}\"/>");
        assert!(made.contains(&inertia), "{made}");
        assert!(made.contains("<inertial><origin xyz=\"0 0 1\"/>"), "{made}");
    }
}

#[test]
fn inertia_that_differs_by_call_or_is_unknown_is_not_offered() {
    let mut client = Client::start();
    let in_macro = |calls: &str| {
        robot(&format!(
            "  <xacro:macro name=\"m\" params=\"n size\">\n{}\n  </xacro:macro>\n{calls}",
            SOLID
                .replace("\"1 2 3\"", "\"${size}\"")
                .replace("\"a\"", "\"${n}\"")
        ))
    };
    for (text, offered) in [
        (
            in_macro("<xacro:m n=\"a\" size=\"1 2 3\"/><xacro:m n=\"b\" size=\"1 2 3\"/>"),
            true,
        ),
        (
            in_macro("<xacro:m n=\"a\" size=\"1 2 3\"/><xacro:m n=\"b\" size=\"1 1 3\"/>"),
            false,
        ),
        (in_macro(""), false),
        (robot(&SOLID.replace("1 2 3", "1 x 3")), false),
        (robot(SOLID).replace("</robot>", ""), false),
    ] {
        show(&mut client, &text);
        let found = actions(&mut client, FILE, "<in|ertial>", &[], &["refactor"]);
        let is_offered = found
            .iter()
            .any(|action| action["title"].as_str().unwrap().contains("inertia"));
        assert_eq!(is_offered, offered, "{text}");
    }
}

#[test]
fn a_number_becomes_a_property_and_a_property_a_number() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot(
            "  <link name=\"🤖 0.1\"><visual><geometry><box size=\"0.1 0.2 ${0.1 * 2}\"/></geometry></visual></link>",
        ),
    );
    let found = actions(&mut client, FILE, "size=\"0|.1", &[], &["refactor.extract"]);
    let one = client.after(FILE, &titled(&found, "Extract `0.1`")["edit"]);
    let property = "  <xacro:property name=\"box_size\" value=\"0.1\"/>\n  <link name=\"🤖 0.1\">";
    assert!(
        one.contains(property) && one.contains("size=\"${box_size} 0.2 ${0.1 * 2}\""),
        "{one}"
    );
    let all = client.after(FILE, &titled(&found, "all 2")["edit"]);
    assert!(
        all.contains(property) && all.contains("size=\"${box_size} 0.2 ${box_size * 2}\""),
        "{all}"
    );
    show(&mut client, &all);
    for place in ["name=\"box|_size\"", "${box|_size}"] {
        let found = actions(&mut client, FILE, place, &[], &["refactor.inline"]);
        let back = client.after(FILE, &titled(&found, "Inline property `box_size`")["edit"]);
        assert!(back.contains("size=\"0.1 0.2 ${0.1 * 2}\""), "{back}");
        assert!(!back.contains("property"), "{back}");
    }
}

#[test]
fn a_property_that_others_read_is_not_inlined() {
    let folder = pan_tilt();
    write(
        &folder,
        "src/pan_tilt/urdf/shared.xacro",
        robot("  <xacro:property name=\"shared\" value=\"1\"/>"),
    );
    let user = robot("  <xacro:include filename=\"shared.xacro\"/>\n  <link name=\"l${shared}\"/>");
    write(&folder, "src/pan_tilt/urdf/one.urdf.xacro", &user);
    let mut client = Client::with(folder, Options::default());
    client.open("src/pan_tilt/urdf/one.urdf.xacro");
    client.open("src/pan_tilt/urdf/shared.xacro");
    let inline = |client: &mut Client| {
        actions(
            client,
            "src/pan_tilt/urdf/one.urdf.xacro",
            "${sh|ared}",
            &[],
            &["refactor.inline"],
        )
        .len()
    };
    assert_eq!(inline(&mut client), 1);
    // a second robot reads it as well
    client.open_with("src/pan_tilt/urdf/two.urdf.xacro", &user);
    client.diagnostics("src/pan_tilt/urdf/two.urdf.xacro");
    assert_eq!(inline(&mut client), 0);
}

#[test]
fn elements_are_wrapped_in_a_condition() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot("  <link name=\"a\"/>\n  <link name=\"b\">\n    <!-- c -->\n  </link>"),
    );
    let found = actions(
        &mut client,
        FILE,
        "  «<link name=\"a\"/>\n  <link name=\"b\">\n    <!-- c -->\n  </link>»",
        &[],
        &["refactor"],
    );
    let made = client.after(FILE, &titled(&found, "Wrap in `xacro:if`")["edit"]);
    let expected = "  <xacro:if value=\"true\">\n    <link name=\"a\"/>\n    <link name=\"b\">\n      <!-- c -->\n    </link>\n  </xacro:if>";
    assert_eq!(made, robot(expected));
    let found = actions(
        &mut client,
        FILE,
        "  «<link name=\"a\"/>\n  <link name=\"b\">»",
        &[],
        &["refactor"],
    );
    assert!(
        found
            .iter()
            .all(|action| !action["title"].as_str().unwrap().contains("Wrap")),
        "{found:?}"
    );
}

#[test]
fn nothing_is_rewritten_in_a_broken_file() {
    let mut client = Client::start();
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", ""));
    let found = actions(&mut client, ROBOT, "value=\"0|.15\"", &[], &["refactor"]);
    assert_eq!(found, Vec::<Value>::new());
}

#[test]
fn a_call_gives_way_to_what_it_makes() {
    let mut client = Client::start();
    client.open(ROBOT);
    let found = actions(
        &mut client,
        ROBOT,
        "<xacro:un|it name=\"tilt\"",
        &[],
        &["refactor.inline"],
    );
    let made = client.after(
        ROBOT,
        &titled(&found, "Expand macro call `unit` with evaluated values")["edit"],
    );
    let expected = "  <link name=\"tilt_body\">\n    <inertial>\n      <mass value=\"0.3\"/>\n";
    assert!(made.contains(expected), "{made}");
    assert!(
        made.contains(
            "  <joint name=\"tilt\" type=\"revolute\">\n    <origin xyz=\"0 0 0.049999999999999996\"/>\n"
        ),
        "{made}"
    );
    let expand = |client: &mut Client| {
        let params = json!({ "textDocument": { "uri": client.uri(ROBOT) } });
        let text = client.request("xacro/expand", params)["urdf"]
            .as_str()
            .unwrap()
            .to_owned();
        let lines = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("<!--"));
        lines.map(str::to_owned).collect::<Vec<_>>().join("\n")
    };
    let before = expand(&mut client);
    client.edit(ROBOT, ROBOT_TEXT, &made);
    assert_eq!(expand(&mut client), before);
}

#[test]
fn what_links_and_joints_lack_is_added() {
    let mut client = Client::start();
    let content = "  <link name=\"🤖\">
    <visual>
      <origin xyz=\"0 0 1\"/>
      <geometry>
        <sphere radius=\"1\"/>
      </geometry>
      <material name=\"m\"/>
    </visual>
  </link>
  <joint name=\"j\" type=\"revolute\"/>";
    show(&mut client, &robot(content));
    let found = actions(&mut client, FILE, "<vis|ual>", &[], &["refactor.rewrite"]);
    let made = client.after(FILE, &titled(&found, "collision")["edit"]);
    let expected = "    </visual>
    <collision>
      <origin xyz=\"0 0 1\"/>
      <geometry>
        <sphere radius=\"1\"/>
      </geometry>
    </collision>
  </link>";
    assert!(made.contains(expected), "{made}");
    let found = actions(&mut client, FILE, "<joi|nt", &[], &["refactor.rewrite"]);
    let axis = client.after(FILE, &titled(&found, "axis")["edit"]);
    assert!(
        axis.contains("revolute\">\n    <axis xyz=\"1 0 0\"/>\n  </joint>"),
        "{axis}"
    );
    let limit = client.after(FILE, &titled(&found, "limit")["edit"]);
    assert!(
        limit.contains("<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>\n  </joint>"),
        "{limit}"
    );
    show(
        &mut client,
        &robot(content).replace("/>\n</robot>", "><xacro:x/></joint>\n</robot>"),
    );
    let found = actions(&mut client, FILE, "<joi|nt", &[], &["refactor.rewrite"]);
    assert!(
        found
            .iter()
            .all(|action| !action["title"].as_str().unwrap().starts_with("Add")),
        "{found:?}"
    );
}
