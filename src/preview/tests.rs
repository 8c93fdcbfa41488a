//! Models of small robots.

use std::path::{Path, PathBuf};

use super::messages::ModelMessage;
use super::model::Model;
use super::{LocationFormat, Views, file_uri};
use analysis::{AnalysisHost, RootConfig};
use base::{CancelFlag, Encoding};
use vfs::testing::Tree;

fn with_names<T>(work: impl FnOnce(&LocationFormat<'_>) -> T) -> T {
    let uri = |path: &Path| Some(file_uri(path));
    let path = |uri: &str| Some(PathBuf::from(uri.strip_prefix("file://")?));
    work(&LocationFormat {
        uri: &uri,
        path: &path,
        encoding: Encoding::Utf16,
    })
}

struct Shown {
    tree: Tree,
    host: AnalysisHost,
    views: Views,
}

impl Shown {
    fn new(robot: &str) -> Self {
        let tree = Tree::new();
        tree.write("bot/package.xml", "<package><name>bot</name></package>");
        tree.write("bot/robot.urdf.xacro", robot);
        let mut views = Views::default();
        views.open(RootConfig::plain(&tree.path("bot/robot.urdf.xacro")));
        let host = AnalysisHost::new(tree.environment(&[]), vec![tree.root().to_path_buf()]);
        Self { tree, host, views }
    }

    fn messages(&mut self) -> Vec<ModelMessage> {
        let Self { host, views, .. } = self;
        with_names(|names| views.update(host, names, &|_| true, &CancelFlag::default())).0
    }

    fn model(&mut self) -> Model {
        let message = self.messages().pop().unwrap();
        (*message.model.unwrap()).clone()
    }

    fn shape(&mut self) -> serde_json::Value {
        let model = self.model();
        serde_json::to_value(&model.links[0].visuals[0].shape).unwrap()
    }
}

fn robot(content: &str) -> String {
    format!("<robot name=\"bot\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">{content}</robot>")
}

fn visual(geometry: &str, material: &str) -> String {
    robot(&format!(
        "<link name=\"a\"><visual><geometry>{geometry}</geometry>{material}</visual></link>"
    ))
}

#[test]
fn colors_are_looked_up_by_name() {
    let shared = "<material name=\"red\"><color rgba=\"1 0 0 0.5\"/></material>";
    let link = |name: &str, material: &str| {
        format!(
            "<link name=\"{name}\"><visual><geometry><sphere radius=\"1\"/></geometry>{material}</visual></link>"
        )
    };
    let by_name = link("a", "<material name=\"red\"/>");
    let own = link(
        "b",
        "<material name=\"green\"><color rgba=\"0 1 0 1\"/></material>",
    );
    let of_another = link("c", "<material name=\"green\"/>");
    let unknown = link("d", "<material name=\"blue\"/>");
    let mut shown = Shown::new(&robot(&format!(
        "{shared}{by_name}{own}{of_another}{unknown}"
    )));
    let model = shown.model();
    let colors: Vec<_> = model
        .links
        .iter()
        .map(|link| link.visuals[0].color)
        .collect();
    let green = Some([0.0, 1.0, 0.0, 1.0]);
    assert_eq!(colors, [Some([1.0, 0.0, 0.0, 0.5]), green, green, None]);
}

#[test]
fn joints_have_defaults_as_urdfdom_has_them() {
    let text = "<link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\
        <joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/><limit effort=\"1\" velocity=\"2\"/></joint>\
        <joint name=\"k\" type=\"continuous\"><parent link=\"b\"/><child link=\"c\"/><axis xyz=\"0 0 2\"/>\
        <origin xyz=\"1 2 3\" rpy=\"0 0 1\"/><mimic joint=\"j\" offset=\"0.5\"/></joint>";
    let model = Shown::new(&robot(text)).model();
    let (j, k) = (&model.joints[0], &model.joints[1]);
    let limit = j.limit.unwrap();
    assert_eq!(
        (j.axis, limit.lower, limit.upper, limit.velocity),
        ([1.0, 0.0, 0.0], 0.0, 0.0, Some(2.0))
    );
    assert_eq!(
        (k.axis, k.pose.xyz, k.pose.rpy),
        ([0.0, 0.0, 2.0], [1.0, 2.0, 3.0], [0.0, 0.0, 1.0])
    );
    let mimic = k.mimic.as_ref().unwrap();
    assert_eq!(
        (mimic.joint.as_str(), mimic.multiplier, mimic.offset),
        ("j", 1.0, 0.5)
    );
}

#[test]
fn what_a_macro_makes_names_the_outermost_call() {
    let text = robot(
        "\n<xacro:macro name=\"inner\" params=\"n\"><link name=\"${n}\"/></xacro:macro>\n\
         <xacro:macro name=\"outer\" params=\"n\"><xacro:inner n=\"${n}\"/></xacro:macro>\n<xacro:outer n=\"a\"/>\n",
    );
    let model = Shown::new(&text).model();
    let lines = |location: &Option<super::Location>| location.as_ref().unwrap().range.start.line;
    assert_eq!(
        (lines(&model.links[0].origin), lines(&model.links[0].call)),
        (1, 3)
    );
}

#[test]
fn meshes_bring_the_files_they_name() {
    let mut shown = Shown::new(&visual(
        "<mesh filename=\"package://bot/part.obj\" scale=\"1 2 3\"/>",
        "",
    ));
    shown.tree.write(
        "bot/part.obj",
        "mtllib part.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    shown
        .tree
        .write("bot/part.mtl", "newmtl a\nmap_Kd wood.png\n");
    shown.tree.write("bot/wood.png", "-");
    let model = shown.model();
    let shape = serde_json::to_value(&model.links[0].visuals[0].shape).unwrap();
    assert_eq!(shape["scale"], serde_json::json!([1.0, 2.0, 3.0]));
    let file = &model.meshes[shape["mesh"].as_str().unwrap()];
    assert_eq!(
        (file.format.as_str(), file.bounds),
        ("obj", Some([[0.0; 3], [1.0, 1.0, 0.0]]))
    );
    let names: Vec<&str> = file.files.keys().map(String::as_str).collect();
    assert_eq!(names, ["part.mtl", "wood.png"]);
    for id in file.files.values() {
        assert!(shown.views.mesh(&shown.host, id).is_ok());
    }
}

#[test]
fn a_mesh_that_is_not_there_says_why() {
    let cases = [
        ("package://bot/no.stl", "no.stl not found"),
        ("package://nobody/a.stl", "its package was not found"),
        ("http://example.org/a.stl", "it is not on this computer"),
        ("package:/bot/a.stl", "slashes"),
    ];
    for (name, why) in cases {
        let shape = Shown::new(&visual(&format!("<mesh filename=\"{name}\"/>"), "")).shape();
        assert!(
            shape["mesh"].is_null() && shape["problem"].as_str().unwrap().contains(why),
            "{shape}"
        );
    }
    let folder = Shown::new(&visual("<mesh filename=\"package://bot/\"/>", "")).shape();
    assert!(
        folder["problem"]
            .as_str()
            .unwrap()
            .ends_with("is not a file"),
        "{folder}"
    );
}

#[test]
fn shapes_without_numbers_are_not_guessed() {
    for geometry in [
        "<box size=\"1 2\"/>",
        "<sphere/>",
        "<cylinder radius=\"1\"/>",
        "<capsule/>",
        "",
    ] {
        let shape = Shown::new(&visual(geometry, "")).shape();
        assert_eq!(shape["kind"], "unknown", "{geometry}: {shape}");
    }
}

#[test]
fn programs_that_reject_the_robot_are_named() {
    let text = robot(
        "<link name=\"a\"/><link name=\"universe\"/><joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"universe\"/></joint>",
    );
    let mut shown = Shown::new(&text);
    let programs = shown.messages().pop().unwrap().programs.unwrap();
    assert!(programs.names.contains(&"Pinocchio") && programs.names.len() > 10);
    let is_name = |title: &str| title.contains("universe");
    let found = programs
        .constructs
        .iter()
        .find(|found| is_name(found.title));
    let found = found.unwrap_or_else(|| panic!("{programs:?}"));
    assert_eq!(
        (found.rejected.len(), found.changed.as_slice()),
        (0, ["Pinocchio"].as_slice())
    );
    assert_eq!(
        (found.count, found.places[0].of.as_str()),
        (1, "link `universe`")
    );
    let robot = shown.tree.path("bot/robot.urdf.xacro");
    shown
        .host
        .set_text(&robot, "<robot name=\"bot\"><link name=\"a\"/>".into());
    assert_eq!(
        shown.messages().pop().unwrap().programs,
        None,
        "no program reads a file with errors"
    );
}

#[test]
fn programs_are_those_of_the_configuration() {
    let mut shown = Shown::new(&robot("<link name=\"universe\"/>"));
    shown.tree.write(
        "bot/xacro-lint.toml",
        "consumers = [\"mujoco\", \"gazebo\"]\n",
    );
    let programs = shown.messages().pop().unwrap().programs.unwrap();
    assert_eq!(programs.names.len(), 2, "{programs:?}");
    let who = programs
        .constructs
        .iter()
        .flat_map(|found| found.rejected.iter().chain(&found.changed));
    assert!(
        who.clone().all(|name| programs.names.contains(name)),
        "{programs:?}"
    );
}

#[test]
fn nothing_is_sent_while_nothing_changes() {
    let mut shown = Shown::new(&robot("<link name=\"a\"/>"));
    assert_eq!(shown.messages().len(), 1);
    assert_eq!(shown.messages().len(), 0);
    shown.host.set_text(
        &shown.tree.path("bot/robot.urdf.xacro"),
        robot("<link name=\"b\"/>"),
    );
    let second = shown.messages().pop().unwrap();
    assert_eq!(
        (
            second.revision,
            second.model.unwrap().links[0].name.as_str()
        ),
        (2, "b")
    );
    shown.views.forget(1);
    assert_eq!(shown.messages().len(), 1);
}

#[test]
fn a_file_that_is_gone_is_an_error() {
    let tree = Tree::new();
    let mut views = Views::default();
    views.open(RootConfig::plain(&tree.path("no.urdf")));
    let host = AnalysisHost::new(tree.environment(&[]), Vec::new());
    let message = Shown { tree, host, views }.messages().pop().unwrap();
    assert!(
        !message.ok && message.errors[0].message.contains("cannot read the file"),
        "{message:?}"
    );
}
