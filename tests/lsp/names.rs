//! Names that no expansion evaluated: branches that are not taken, skipped parts of expressions, macros that nobody calls.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{fresh_folder, write};

const MAIN: &str = "src/arm.urdf.xacro";
const PART: &str = "src/part.xacro";
const TOOL: &str = "src/tool.xacro";

const MAIN_TEXT: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="tool" default="false"/>
  <xacro:property name="width" value="2"/>
  <xacro:include filename="part.xacro"/>
  <link name="base"/>
  <xacro:if value="$(arg tool)">
    <xacro:include filename="tool.xacro" ns="extra"/>
    <xacro:property name="grip" value="${width * 3}"/>
    <xacro:extra.hand size="${grip}"/>
    <xacro:wrap><link name="in_${width}"/></xacro:wrap>
    <link name="s${[n for n in [width]][0]}_${extra.reach}"/>
  </xacro:if>
  <xacro:finger length="1"/>
  <link name="x_${width if 1 &lt; 2 else gap}"/>
  <xacro:property name="gap" value="4"/>
</robot>
"#;

const PART_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wrap" params="*inner">
    <xacro:insert_block name="inner"/>
  </xacro:macro>
  <xacro:macro name="finger" params="length soft:=false scale:=1
      gap:=^|7">
    <xacro:if value="${soft}"><link name="soft_${length}_${gap}"/></xacro:if>
    <xacro:unless value="${soft}"><link name="hard_${length * scale}"/></xacro:unless>
  </xacro:macro>
  <xacro:macro name="idle" params="depth"><xacro:if value="${False}"><link name="${depth}_${width}"/></xacro:if></xacro:macro>
</robot>
"#;

const TOOL_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="reach" value="9"/>
  <xacro:macro name="hand" params="size"><link name="hand_${size}_${reach}"/></xacro:macro>
</robot>
"#;

fn arm() -> Client {
    let folder = fresh_folder();
    for (name, text) in [(MAIN, MAIN_TEXT), (PART, PART_TEXT), (TOOL, TOOL_TEXT)] {
        write(&folder, name, text);
    }
    let mut client = Client::with(folder, Options::default());
    client.open(MAIN);
    client.open(PART);
    client.open(TOOL);
    client
}

#[track_caller]
pub(super) fn leads(client: &mut Client, file: &str, at: &str, expected: &[&str]) {
    let targets = client.request("textDocument/definition", client.at(file, at));
    let shown = |link: &Value| {
        client.shown(
            link["targetUri"].as_str().unwrap(),
            &link["targetSelectionRange"],
        )
    };
    let shown: Vec<String> = targets
        .as_array()
        .into_iter()
        .flatten()
        .map(shown)
        .collect();
    assert_eq!(shown, expected, "{at}");
}

#[test]
fn names_in_branches_that_are_not_taken_lead_to_their_definitions() {
    let mut client = arm();
    leads(
        &mut client,
        MAIN,
        "${wid|th * 3}",
        &["arm.urdf.xacro:3 width"],
    );
    leads(
        &mut client,
        MAIN,
        "size=\"${gr|ip}",
        &["arm.urdf.xacro:8 grip"],
    );
    leads(
        &mut client,
        MAIN,
        "<xacro:extra.ha|nd",
        &["tool.xacro:3 hand"],
    );
    leads(
        &mut client,
        MAIN,
        "<xacro:ex|tra.hand",
        &["arm.urdf.xacro:7 extra"],
    );
    leads(&mut client, MAIN, "hand si|ze=", &["tool.xacro:3 size"]);
    leads(&mut client, MAIN, "extra.rea|ch}", &["tool.xacro:2 reach"]);
    leads(&mut client, MAIN, "else ga|p}", &["arm.urdf.xacro:15 gap"]);
    leads(
        &mut client,
        MAIN,
        "in [wid|th]]",
        &["arm.urdf.xacro:3 width"],
    );
    leads(
        &mut client,
        PART,
        "soft_${len|gth}",
        &["part.xacro:5 length"],
    );
    leads(&mut client, PART, "_${ga|p}", &["part.xacro:6 gap"]);
    leads(&mut client, PART, "${dep|th}", &["part.xacro:10 depth"]);
    leads(
        &mut client,
        PART,
        "}_${wid|th}",
        &["arm.urdf.xacro:3 width"],
    );
}

#[test]
fn where_callers_decide_each_definition_is_named() {
    let mut client = arm();
    client.edit(
        MAIN,
        "</robot>",
        "<xacro:macro name=\"far\" params=\"width\"><xacro:idle depth=\"1\"/></xacro:macro>\n<xacro:idle depth=\"2\"/></robot>",
    );
    leads(
        &mut client,
        PART,
        "}_${wid|th}",
        &["arm.urdf.xacro:3 width", "arm.urdf.xacro:16 width"],
    );
}

pub(super) fn references(client: &mut Client, file: &str, at: &str) -> Vec<String> {
    let mut params = client.at(file, at);
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", params);
    let shown = |place: &Value| client.shown(place["uri"].as_str().unwrap(), &place["range"]);
    let mut shown: Vec<String> = found.as_array().unwrap().iter().map(shown).collect();
    shown.sort();
    shown
}

#[test]
fn references_and_hover_know_what_is_not_evaluated() {
    let mut client = arm();
    let found = references(&mut client, PART, "params=\"len|gth");
    assert_eq!(
        found,
        [
            "arm.urdf.xacro:13 length",
            "part.xacro:5 length",
            "part.xacro:7 length",
            "part.xacro:8 length"
        ]
    );
    let found = references(&mut client, MAIN, "size=\"${gr|ip}");
    assert_eq!(found, ["arm.urdf.xacro:8 grip", "arm.urdf.xacro:9 grip"]);
    let hover = client.request("textDocument/hover", client.at(MAIN, "size=\"${gr|ip}"));
    let text = hover["contents"]["value"].as_str().unwrap();
    assert!(
        text.contains("**property** `grip`") && text.contains("arm.urdf.xacro:8"),
        "{text}"
    );
    let found = client.request(
        "textDocument/documentHighlight",
        client.at(MAIN, "size=\"${gr|ip}"),
    );
    assert_eq!(found.as_array().unwrap().len(), 2, "{found}");
}

/// The files after renaming what `at` marks; or the message of the error.
fn renamed(client: &mut Client, file: &str, at: &str, new: &str) -> Result<[String; 2], String> {
    let mut params = client.at(file, at);
    params["newName"] = json!(new);
    let id = client.post("textDocument/rename", params);
    let reply = client.reply(id);
    match reply.get("error") {
        Some(error) => Err(error["message"].as_str().unwrap().to_owned()),
        None => {
            Ok([MAIN, PART].map(
                |file| match reply["result"]["changes"].get(client.uri(file)) {
                    Some(_) => client.after(file, &reply["result"]),
                    None => client.text(file).to_owned(),
                },
            ))
        }
    }
}

#[test]
fn names_are_renamed_where_nothing_is_evaluated() {
    let mut client = arm();
    // a macro and a block that only a branch uses
    let [main, part] = renamed(&mut client, PART, "name=\"wr|ap\"", "cover").unwrap();
    assert!(
        main.contains("<xacro:cover><link") && main.contains("</xacro:cover>"),
        "{main}"
    );
    assert!(part.contains("<xacro:macro name=\"cover\""), "{part}");
    let [_, part] = renamed(&mut client, PART, "params=\"*in|ner", "body").unwrap();
    assert!(
        part.contains("params=\"*body\"") && part.contains("<xacro:insert_block name=\"body\"/>"),
        "{part}"
    );
    // a parameter that a branch reads
    let [main, part] = renamed(&mut client, PART, "params=\"len|gth", "size").unwrap();
    assert_eq!(part.matches("size").count(), 3, "{part}");
    assert!(main.contains("<xacro:finger size=\"1\"/>"), "{main}");
    // one that takes the value of a property: both
    let [main, part] = renamed(&mut client, PART, "_${ga|p}", "slit").unwrap();
    assert!(
        main.contains("else slit}") && main.contains("name=\"slit\""),
        "{main}"
    );
    assert!(
        part.contains("slit:=^|7") && part.contains("_${slit}"),
        "{part}"
    );
    // from within a branch, with its namespace
    let [main, _] = renamed(&mut client, MAIN, "<xacro:ex|tra.hand", "more").unwrap();
    assert!(
        main.contains("ns=\"more\"")
            && main.contains("<xacro:more.hand")
            && main.contains("${more.reach}"),
        "{main}"
    );
}

#[test]
fn a_parameter_that_is_defined_again_takes_its_uses_along() {
    let mut client = arm();
    client.edit(PART, "<xacro:if value=\"${soft}\">", "<xacro:if value=\"${scale == 0}\"><xacro:property name=\"scale\" value=\"5\"/></xacro:if><xacro:if value=\"${soft}\">");
    let [_, part] = renamed(&mut client, PART, "sca|le:=1", "factor").unwrap();
    assert!(
        !part.contains("scale") && part.matches("factor").count() == 4,
        "{part}"
    );
}

#[test]
fn what_would_change_a_branch_is_refused() {
    let mut client = arm();
    let refused = renamed(&mut client, PART, "params=\"len|gth", "gap").unwrap_err();
    assert!(refused.contains("`gap` is already defined"), "{refused}");
    let refused = renamed(&mut client, MAIN, "name=\"wid|th\"", "depth").unwrap_err();
    assert!(refused.contains("`depth` has another meaning"), "{refused}");
    assert!(refused.contains("part.xacro:10"), "{refused}");
    // a text that is put together is no name that could follow
    client.edit(
        MAIN,
        "<link name=\"base\"/>",
        "<xacro:if value=\"$(arg tool)\"><link name=\"${xacro.arg('tool')}\"/></xacro:if>",
    );
    let refused = renamed(&mut client, MAIN, "arg name=\"to|ol\"", "hand").unwrap_err();
    assert!(
        refused.contains("with the condition taken at arm.urdf.xacro:5"),
        "{refused}"
    );
}

#[test]
fn names_that_no_robot_has_are_refused_with_the_reason() {
    let mut client = arm();
    client.edit(
        PART,
        "</xacro:macro>\n</robot>",
        "<link name=\"${depth}_tip\"/></xacro:macro>\n</robot>",
    );
    let at = client.at(PART, "${depth}_ti|p");
    let id = client.post("textDocument/prepareRename", at);
    let reply = client.reply(id);
    let reason = reply["error"]["message"].as_str().unwrap_or_default();
    assert!(
        reason.contains("`${depth}_tip`") && reason.contains("calls macro `idle`"),
        "{reply}"
    );
    // what is no name is still nothing to rename
    let at = client.at(PART, "<xacro:insert_blo|ck");
    let id = client.post("textDocument/prepareRename", at);
    let reply = client.reply(id);
    assert!(
        reply["result"].is_null() && reply.get("error").is_none(),
        "{reply}"
    );
}

#[test]
fn links_are_renamed_in_branches_that_are_not_taken() {
    let mut client = arm();
    client.edit(
        MAIN,
        "</robot>",
        "<xacro:if value=\"$(arg tool)\"><link name=\"tip\"/><joint name=\"j\" type=\"fixed\"><parent link=\"base\"/>\
         <child link=\"tip\"/></joint></xacro:if></robot>",
    );
    for at in ["<link name=\"ba|se", "parent link=\"ba|se"] {
        let [main, _] = renamed(&mut client, MAIN, at, "root").unwrap();
        assert!(
            main.contains("<link name=\"root\"/>") && main.contains("parent link=\"root\""),
            "{main}"
        );
    }
    let [main, _] = renamed(&mut client, MAIN, "child link=\"ti|p", "top").unwrap();
    assert!(
        main.contains("<link name=\"top\"/>") && main.contains("child link=\"top\""),
        "{main}"
    );
}

#[test]
fn a_macro_that_the_body_around_defines_is_meant() {
    let folder = fresh_folder();
    // as controllers of one arm and of two: each has a macro of its own by the same name
    let part = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="KIND" params="prefix">
    <xacro:macro name="wheel" params="start"><link name="${prefix}KIND_${start}"/></xacro:macro>
    <xacro:wheel start="1"/>
  </xacro:macro>
</robot>
"#;
    let robot = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="control" default="false"/>
  <xacro:include filename="one.xacro"/>
  <xacro:include filename="two.xacro"/>
  <link name="base"/>
  <xacro:if value="$(arg control)"><xacro:two prefix="b"/><xacro:one prefix="a"/></xacro:if>
</robot>
"#;
    write(&folder, "src/arm.urdf.xacro", robot);
    let mut client = {
        for name in ["one", "two"] {
            write(
                &folder,
                &format!("src/{name}.xacro"),
                part.replace("KIND", name),
            );
        }
        Client::with(folder, Options::default())
    };
    client.open("src/arm.urdf.xacro");
    for name in ["one", "two"] {
        let file = format!("src/{name}.xacro");
        client.open(&file);
        leads(
            &mut client,
            &file,
            "<xacro:whe|el start=\"1",
            &[&format!("{name}.xacro:3 wheel")],
        );
        leads(
            &mut client,
            &file,
            "wheel sta|rt=\"1",
            &[&format!("{name}.xacro:3 start")],
        );
    }
}

#[test]
fn what_callers_define_before_they_call_is_meant() {
    let folder = fresh_folder();
    let write = |name: &str, content: &str| {
        let text = format!(
            "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{content}\n</robot>\n"
        );
        write(&folder, &format!("src/{name}.xacro"), text);
    };
    for part in ["arm", "hand"] {
        write(
            &format!("{part}_parts"),
            "<xacro:macro name=\"pad\" params=\"size\"><link name=\"${size}\"/></xacro:macro>",
        );
        let content = format!(
            "<xacro:macro name=\"{part}\"><xacro:if value=\"${{False}}\"><xacro:pad size=\"{part}\"/></xacro:if></xacro:macro>"
        );
        write(part, &content);
    }
    write(
        "cell",
        r#"<xacro:macro name="with" params="hand"><xacro:include filename="arm_parts.xacro"/><xacro:include filename="arm.xacro"/><xacro:arm/>
<xacro:if value="${hand}"><xacro:include filename="hand.xacro"/><xacro:include filename="hand_parts.xacro"/><xacro:hand/></xacro:if>
</xacro:macro>"#,
    );
    write(
        "r.urdf",
        r#"<xacro:include filename="cell.xacro"/><link name="base"/><xacro:with hand="false"/>"#,
    );
    let mut client = Client::with(folder, Options::default());
    for file in ["r.urdf", "cell", "arm", "hand", "arm_parts", "hand_parts"] {
        client.open(&format!("src/{file}.xacro"));
    }
    leads(
        &mut client,
        "src/arm.xacro",
        "<xacro:pa|d ",
        &["arm_parts.xacro:2 pad"],
    );
    leads(
        &mut client,
        "src/hand.xacro",
        "<xacro:pa|d ",
        &["hand_parts.xacro:2 pad"],
    );
    let found = references(&mut client, "src/hand_parts.xacro", "name=\"pa|d\"");
    assert_eq!(found, ["hand.xacro:2 pad", "hand_parts.xacro:2 pad"]);
}

#[test]
fn what_is_defined_in_front_of_the_calls_is_meant_and_nothing_behind_them() {
    let sensor = |name: &str, unit: u8| {
        format!(
            "<robot xmlns:xacro=\"x\"><xacro:property name=\"unit\" value=\"{unit}\"/><xacro:macro name=\"{name}\" params=\"on:=false\">\
             <xacro:if value=\"${{on}}\"><link name=\"{name}_${{unit}}\"/></xacro:if></xacro:macro></robot>\n"
        )
    };
    let main = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n\
        <xacro:include filename=\"near.xacro\"/>\n<xacro:near/>\n\
        <xacro:include filename=\"far.xacro\"/>\n<xacro:far/>\n</robot>\n";
    let folder = fresh_folder();
    write(&folder, "near.xacro", sensor("near", 1));
    write(&folder, "far.xacro", sensor("far", 2));
    write(&folder, "r.urdf.xacro", main);
    let mut client = Client::with(folder, Options::default());
    for file in ["r.urdf.xacro", "near.xacro", "far.xacro"] {
        client.open(file);
    }
    leads(
        &mut client,
        "near.xacro",
        "near_${u|nit}",
        &["near.xacro:1 unit"],
    );
    leads(
        &mut client,
        "far.xacro",
        "far_${u|nit}",
        &["far.xacro:1 unit"],
    );
    // a second call behind both may mean the one or the other
    client.edit("r.urdf.xacro", "<xacro:far/>", "<xacro:far/><xacro:near/>");
    leads(
        &mut client,
        "near.xacro",
        "near_${u|nit}",
        &["near.xacro:1 unit", "far.xacro:1 unit"],
    );
    leads(
        &mut client,
        "far.xacro",
        "far_${u|nit}",
        &["far.xacro:1 unit"],
    );
}

#[test]
fn renaming_waits_for_the_workspace() {
    let folder = fresh_folder();
    let far = MAIN_TEXT.replace(
        "filename=\"part.xacro\"",
        "filename=\"../../src/part.xacro\"",
    );
    write(&folder, PART, PART_TEXT);
    write(&folder, "other/deep/far.urdf.xacro", far);
    let mut client = Client::with(folder, Options::default());
    client.open(PART);
    let mut params = client.at(PART, "name=\"fin|ger\"");
    params["newName"] = json!("digit");
    let edit = client.request("textDocument/rename", params);
    let changed = edit["changes"].as_object().unwrap();
    assert!(
        changed.keys().any(|uri| uri.ends_with("far.urdf.xacro")),
        "{edit}"
    );
}

#[test]
fn a_file_that_other_arguments_include_belongs_to_the_robot() {
    let folder = fresh_folder();
    let robot = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="hand" default="left"/>
  <xacro:arg name="soft" default="false"/>
  <xacro:include filename="hand_$(arg hand).xacro"/>
  <link name="base"/>
</robot>
"#;
    write(&folder, "src/arm.urdf.xacro", robot);
    for side in ["left", "right"] {
        let text = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="SIDE_$(arg soft)"/>
</robot>
"#;
        write(
            &folder,
            &format!("src/hand_{side}.xacro"),
            text.replace("SIDE", side),
        );
    }
    let mut client = Client::with(folder, Options::default());
    client.open("src/arm.urdf.xacro");
    client.open("src/hand_right.xacro");
    leads(
        &mut client,
        "src/hand_right.xacro",
        "$(arg so|ft",
        &["arm.urdf.xacro:3 soft"],
    );
    let uses = references(&mut client, "src/arm.urdf.xacro", "name=\"so|ft");
    assert!(
        uses.iter().any(|place| place.contains("hand_right")),
        "{uses:?}"
    );
    let hover = client.request(
        "textDocument/hover",
        client.at("src/hand_right.xacro", "$(arg so|ft"),
    );
    let text = hover["contents"]["value"].as_str().unwrap();
    assert!(
        text.contains("not evaluated with these arguments") && text.contains("arm.urdf.xacro:3"),
        "{text}"
    );
}

#[test]
fn what_a_file_defines_itself_counts_however_often_it_is_included() {
    let folder = fresh_folder();
    let robot = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="kind" default="none"/>
  <xacro:property name="side" value="left"/>
  <xacro:macro name="arm">
    <xacro:include filename="pad.xacro"/>
    <xacro:if value="${'$(arg kind)' == 'finger'}">
      <xacro:include filename="tips.xacro"/>
      <xacro:pad width="1"/>
    </xacro:if>
    <xacro:if value="${'$(arg kind)' == 'cup'}">
      <xacro:include filename="tips.xacro"/>
      <xacro:pad width="2"/>
    </xacro:if>
  </xacro:macro>
  <xacro:arm/>
  <link name="base"/>
</robot>
"#;
    let pad = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="pad" params="width"><link name="KIND_${width}"/></xacro:macro>
</robot>
"#;
    let tips = pad.replace(
        "KIND",
        "tip\"/><xacro:property name=\"side\" value=\"${width}\"/><link name=\"${side}",
    );
    write(&folder, "src/arm.urdf.xacro", robot);
    write(&folder, "src/pad.xacro", pad.replace("KIND", "pad"));
    write(&folder, "src/tips.xacro", tips);
    let mut client = Client::with(folder, Options::default());
    let (arm, pad, tips) = ("src/arm.urdf.xacro", "src/pad.xacro", "src/tips.xacro");
    for file in [arm, pad, tips] {
        client.open(file);
    }
    leads(&mut client, tips, "${si|de}", &["tips.xacro:2 side"]);
    leads(&mut client, arm, "pa|d width=\"2", &["tips.xacro:2 pad"]);
    let uses = references(&mut client, pad, "wid|th}");
    assert!(
        !uses.iter().any(|place| place.starts_with("arm.urdf.xacro")),
        "{uses:?}"
    );
}
