//! What a host sees.

#![allow(clippy::unwrap_used, clippy::indexing_slicing)] // a test may fail loudly

use serde_json::{Value, json};

use super::Bench;

const ARM: &str = "\
<robot name=\"arm\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:include filename=\"$(find arm)/urdf/part.xacro\"/>
  <xacro:arg name=\"side\" default=\"left\"/>
  <xacro:part name=\"$(arg side)_base\"/>
</robot>
";
const PART: &str = "\
<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:macro name=\"part\" params=\"name\">
    <link name=\"${name}\"/>
  </xacro:macro>
</robot>
";

fn arm() -> Bench {
    let mut bench = Bench::default();
    let manifest = "<package format=\"3\"><name>arm</name></package>";
    for (path, text) in [
        ("arm/package.xml", manifest),
        ("arm/urdf/arm.urdf.xacro", ARM),
        ("arm/urdf/part.xacro", PART),
    ] {
        bench.put(path, Some(text.as_bytes().to_vec()));
    }
    bench
}

fn ask(bench: &mut Bench, question: &Value) -> Value {
    serde_json::from_str(&bench.call(&question.to_string()).unwrap()).unwrap()
}

#[test]
fn a_mistake_comes_and_goes() {
    let mut bench = arm();
    let check = json!({ "call": "check" });
    assert_eq!(ask(&mut bench, &check), json!([]));
    bench.put(
        "arm/urdf/part.xacro",
        Some(PART.replace("${name}", "${nmae}").into_bytes()),
    );
    let found = ask(&mut bench, &check);
    assert_eq!(found[0]["message"], "property `nmae` is not defined");
    assert_eq!(
        (&found[0]["filename"], &found[0]["location"]["row"]),
        (&json!("arm/urdf/part.xacro"), &json!(3))
    );
    bench.put("arm/urdf/part.xacro", Some(PART.as_bytes().to_vec()));
    assert_eq!(ask(&mut bench, &check), json!([]));
}

#[test]
fn the_expanded_text_and_its_map() {
    let mut bench = arm();
    let robot =
        json!({ "call": "expand", "file": "arm/urdf/arm.urdf.xacro", "args": { "side": "right" } });
    let expanded = ask(&mut bench, &robot);
    assert!(
        expanded["text"]
            .as_str()
            .unwrap()
            .contains("<link name=\"right_base\"/>"),
        "{expanded}"
    );
    assert_eq!(expanded["arguments"], json!({ "side": "right" }));
    assert_eq!(
        expanded["map"]["files"],
        json!(["arm/urdf/arm.urdf.xacro", "arm/urdf/part.xacro"])
    );
    bench.put("arm/urdf/part.xacro", None);
    let broken = ask(&mut bench, &robot);
    assert_eq!(
        (&broken["text"], &broken["problems"][0]["severity"]),
        (&Value::Null, &json!("error"))
    );
    let gone = json!({ "call": "expand", "file": "gone.xacro" });
    assert_eq!(
        bench.call(&gone.to_string()).unwrap_err(),
        "gone.xacro: No such file or directory"
    );
}

#[test]
fn the_model_follows_the_text() {
    let mut bench = arm();
    assert_eq!(
        ask(&mut bench, &json!({ "call": "robots" })),
        json!(["arm/urdf/arm.urdf.xacro"])
    );
    let robot = json!({ "call": "model", "file": "arm/urdf/arm.urdf.xacro" });
    let model = ask(&mut bench, &robot);
    assert_eq!(model["model"]["links"][0]["name"], "left_base");
    assert_eq!(ask(&mut bench, &robot), Value::Null, "nothing changed");
    let link = json!({ "call": "select", "link": "left_base" });
    assert_eq!(
        ask(&mut bench, &link)["location"]["uri"],
        "arm/urdf/part.xacro"
    );
    bench.put(
        "arm/urdf/part.xacro",
        Some(PART.replace("${name}", "a_${name}").into_bytes()),
    );
    assert_eq!(
        ask(&mut bench, &robot)["model"]["links"][0]["name"],
        "a_left_base"
    );
}

#[test]
fn fixes() {
    let mut bench = arm();
    bench.put(
        "arm/urdf/part.xacro",
        Some(PART.replace("<link ", "<limk ").into_bytes()),
    );
    let fixed = ask(&mut bench, &json!({ "call": "fix", "unsafeFixes": true }));
    assert!(fixed["files"].is_object(), "{fixed}");
}

#[test]
fn questions_that_are_none() {
    let mut bench = Bench::default();
    assert_eq!(
        bench
            .call("{\"call\": \"check\", \"select\": [\"nothing\"]}")
            .unwrap_err(),
        rules::unknown_selector("nothing")
    );
    for question in [
        "",
        "{}",
        "{\"call\": \"dance\"}",
        "{\"call\": \"expand\"}",
        "[]",
    ] {
        assert!(bench.call(question).is_err(), "{question}");
    }
    assert!(bench.mesh("f1").is_err());
}
