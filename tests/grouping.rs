//! One defect, one finding: what `docs/cli.md` says about grouping, one test for each statement.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::Value;
use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

/// A folder with files, and what commands print in it.
struct Folder(PathBuf);

impl Folder {
    fn of(files: &[(&str, String)]) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("grouping")
            .join(number.to_string());
        let _ = fs::remove_dir_all(&folder);
        // a repository of its own: nothing is read of folders above
        fs::create_dir_all(folder.join(".git")).unwrap();
        let folder = Self(folder);
        files
            .iter()
            .for_each(|(name, text)| folder.write(name, text));
        folder
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Both outputs.
    fn run(&self, line: &str) -> String {
        let cwd = self.0.canonicalize().unwrap();
        let vars = BTreeMap::from([(
            "AMENT_PREFIX_PATH".to_owned(),
            cwd.join("none").display().to_string(),
        )]);
        let (mut out, mut err, mut stdin) = (Vec::new(), Vec::new(), std::io::empty());
        let mut io = Io::plain(&mut out, &mut err, &mut stdin);
        let words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        cli::run(
            &words,
            &Environment {
                vars,
                cwd,
                ..Environment::default()
            },
            &mut io,
        );
        out.extend(err);
        String::from_utf8(out).unwrap()
    }

    fn json(&self, line: &str) -> Vec<Value> {
        serde_json::from_str(&self.run(line)).unwrap()
    }
}

/// A robot whose links have a mass and no inertia: one warning each, on lines 2, 3 ...
fn robot(links: &[&str]) -> String {
    let link = |name: &&str| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" \
             iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>\n"
        )
    };
    format!(
        "<robot name=\"r\">\n{}</robot>\n",
        links.iter().map(link).collect::<String>()
    )
}

fn rows(findings: &[Value]) -> Vec<u64> {
    findings
        .iter()
        .map(|finding| finding["location"]["row"].as_u64().unwrap())
        .collect()
}

fn message(finding: &Value) -> &str {
    finding["message"].as_str().unwrap()
}

const CHECK: &str = "check --select zero-inertia --format json";

#[test]
fn two_are_two_and_three_are_one() {
    let folder = Folder::of(&[("r.urdf", robot(&["a", "b"]))]);
    assert_eq!(rows(&folder.json(CHECK)), [2, 3]);
    folder.write("r.urdf", &robot(&["a", "b", "c"]));
    let found = folder.json(CHECK);
    assert_eq!(rows(&found), [2]);
    assert!(
        message(&found[0]).ends_with("; 2 more locations in this file"),
        "{found:?}"
    );
    assert_eq!(found[0]["places"], 3);
    let related = found[0]["related"].as_array().unwrap();
    assert_eq!(rows(related), [3, 4]);
    assert!(message(&related[1]).contains("link `c`"), "{found:?}");
    assert_eq!(
        rows(&folder.json(&format!("{CHECK} --no-group"))),
        [2, 3, 4]
    );
    assert_eq!(
        rows(&folder.json(&format!("{CHECK} --show all"))),
        [2, 3, 4]
    );
}

#[test]
fn all_places_are_related_and_a_drawing_shows_some() {
    let names: Vec<String> = (0..30).map(|n| format!("l{n}")).collect();
    let folder = Folder::of(&[(
        "r.urdf",
        robot(&names.iter().map(String::as_str).collect::<Vec<_>>()),
    )]);
    assert_eq!(
        folder.json(CHECK)[0]["related"].as_array().unwrap().len(),
        29
    );
    let drawn = folder.run("check --select zero-inertia");
    assert!(drawn.contains("26 more locations not shown"), "{drawn}");
    assert_eq!(drawn.matches("warning[zero-inertia]").count(), 1, "{drawn}");
}

#[test]
fn copies_in_other_files_belong_to_it() {
    let copies: Vec<(&str, String)> = ["a.urdf", "b.urdf", "c.urdf"]
        .map(|name| (name, robot(&["base"])))
        .into();
    let folder = Folder::of(&copies);
    let found = folder.json(CHECK);
    assert_eq!((found.len(), &found[0]["places"]), (1, &Value::from(3)));
    assert!(
        message(&found[0]).ends_with("; 2 more locations, in 3 files"),
        "{found:?}"
    );
    folder.write("c.urdf", &robot(&["other"]));
    assert_eq!(folder.json(CHECK).len(), 3, "two copies and another link");
}

#[test]
fn robots_that_were_written_in_series_have_one_defect() {
    let named = |number: usize| {
        (
            format!("robot_{number}.urdf"),
            robot(&[&format!("link_{number}")]),
        )
    };
    let series: Vec<(String, String)> = (0..10).map(named).collect();
    let (last, others) = series.split_last().unwrap();
    let folder = Folder::of(&[("robot.urdf", robot(&["other"]))]);
    others
        .iter()
        .for_each(|(name, text)| folder.write(name, text));
    assert_eq!(folder.json(CHECK).len(), 10, "nine may be variants");
    folder.write(&last.0, &last.1);
    let found = folder.json(CHECK);
    assert_eq!((found.len(), &found[1]["places"]), (2, &Value::from(10)));
    assert!(
        message(&found[1])
            .ends_with("`link_0` has a mass but zero inertia; 9 more locations, in 10 files"),
        "{found:?}"
    );
}

#[test]
fn different_names_and_structure_are_never_one() {
    let orphans =
        "<robot name=\"r\"><link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n</robot>";
    let folder = Folder::of(&[("r.urdf", orphans.to_owned())]);
    assert_eq!(
        folder
            .json("check --select orphan-link --format json")
            .len(),
        3
    );
    let uses = |names: &[&str]| {
        let link = |name: &&str| format!("<link name=\"${{{name}}}\"/>\n");
        let links: String = names.iter().map(link).collect();
        format!("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{links}</robot>")
    };
    folder.write("r.urdf", &uses(&["one", "two", "three"]));
    let check = "check --select undefined-property --format json";
    assert_eq!(folder.json(check).len(), 3);
    folder.write("r.urdf", &uses(&["one", "one", "one"]));
    assert_eq!(folder.json(check).len(), 1);
}

#[test]
fn a_mesh_is_one_thing_wherever_it_is_named() {
    let stl = "solid m\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid m\n";
    let robot = "<robot name=\"r\"><link name=\"a\">\
                 <visual><geometry><mesh filename=\"m.stl\"/></geometry></visual>\n\
                 <collision><geometry><mesh filename=\"m.stl\"/></geometry></collision></link></robot>";
    let folder = Folder::of(&[("r.urdf", robot.to_owned()), ("m.stl", stl.to_owned())]);
    let found = folder.json("check --select ascii-stl --format json");
    assert_eq!((found.len(), &found[0]["places"]), (1, &Value::from(2)));
}

#[test]
fn a_suppressed_place_leaves_the_group() {
    let text = robot(&["a", "b", "c", "d"]);
    let comment = "<!-- xacro-lint: disable-next-line zero-inertia: a dummy --><inertia";
    let hidden = text.replacen("<inertia ", &format!("{comment} "), 1);
    let folder = Folder::of(&[("r.urdf", hidden)]);
    let found = folder.json(CHECK);
    assert_eq!(
        (rows(&found), &found[0]["places"]),
        (vec![3], &Value::from(3))
    );
}

#[test]
fn a_baseline_counts_places() {
    let folder = Folder::of(&[("r.urdf", robot(&["a", "b", "c"]))]);
    let written = folder.run("check --select zero-inertia --write-baseline known.json");
    assert!(written.contains("wrote 3 findings"), "{written}");
    folder.write("r.urdf", &robot(&["a", "b", "c", "d"]));
    let with = "check --select zero-inertia --format concise --baseline known.json";
    let said = folder.run(with);
    assert!(
        said.contains("r.urdf:5:") && !said.contains("more location"),
        "{said}"
    );
    assert!(
        folder
            .run("check --select zero-inertia --write-baseline known.json")
            .contains("wrote 4")
    );
    assert_eq!(
        folder.run(with),
        "note: 4 findings from the baseline not shown\n"
    );
}

#[test]
fn a_change_groups_what_concerns_it() {
    let copies: Vec<(&str, String)> = ["a.urdf", "b.urdf", "c.urdf"]
        .map(|name| (name, robot(&["base"])))
        .into();
    let folder = Folder::of(&copies);
    let found = folder.json(&format!("{CHECK} --changed b.urdf"));
    assert_eq!(
        (found.len(), &found[0]["filename"], &found[0]["places"]),
        (1, &"b.urdf".into(), &1.into())
    );
}

#[test]
fn fingerprints_do_not_depend_on_further_places() {
    let fingerprint = |folder: &Folder| {
        let text = folder.run("check --select zero-inertia --format sarif");
        let document: Value = serde_json::from_str(&text).unwrap();
        let results = document["runs"][0]["results"].as_array().unwrap().clone();
        assert_eq!(results.len(), 1);
        let related = results[0]["relatedLocations"].as_array().unwrap().len();
        (
            results[0]["partialFingerprints"]["xacroLint/v1"]
                .as_str()
                .unwrap()
                .to_owned(),
            related,
        )
    };
    let folder = Folder::of(&[("r.urdf", robot(&["a", "b", "c"]))]);
    let (before, related) = fingerprint(&folder);
    assert_eq!(related, 2);
    folder.write("r.urdf", &robot(&["a", "b", "c", "d"]));
    assert_eq!(fingerprint(&folder), (before, 3));
}

#[test]
fn a_pull_request_gets_one_annotation() {
    let folder = Folder::of(&[("r.urdf", robot(&["a", "b", "c"]))]);
    let said = folder.run("check --select zero-inertia --format github");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(
        said.starts_with("::warning file=r.urdf,line=2,") && said.contains("2 more locations"),
        "{said}"
    );
}

#[test]
fn the_fix_of_a_group_edits_all_places() {
    let tag = "<property name=\"p\" value=\"1\"/>\n";
    let robot = format!(
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{}<link name=\"l\"/></robot>",
        tag.repeat(3)
    );
    let folder = Folder::of(&[("r.urdf.xacro", robot)]);
    let found = folder.json("check --select unprefixed-xacro-tag --format json");
    assert_eq!(found.len(), 1);
    let mut rows: Vec<u64> = found[0]["fix"]["edits"]
        .as_array()
        .unwrap()
        .iter()
        .map(|edit| edit["location"]["row"].as_u64().unwrap())
        .collect();
    rows.dedup();
    assert_eq!(rows, [2, 3, 4]);
    let fixed = folder.run("check --select unprefixed-xacro-tag --fix");
    assert!(fixed.contains("fixed 3 findings"), "{fixed}");
}

#[test]
fn statistics_count_places_and_tell_severities_apart() {
    let inertia = |ixx: f64| {
        format!(
            "<link name=\"l{ixx}\"><inertial><mass value=\"1\"/><inertia ixx=\"{ixx}\" ixy=\"0\" ixz=\"0\" \
             iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>\n"
        )
    };
    let links: String = [5.0, 5.5, 6.0, 2.001].map(inertia).concat();
    let folder = Folder::of(&[("r.urdf", format!("<robot name=\"r\">\n{links}</robot>"))]);
    let said = folder.run("check --select inertia-triangle-inequality --statistics");
    let lines: Vec<Vec<&str>> = said
        .lines()
        .map(|line| line.split_whitespace().take(2).collect())
        .collect();
    assert_eq!(lines[0], ["3", "error"], "{said}");
    assert!(
        lines.len() == 2 && lines[1][0] == "1" && lines[1][1] != "error",
        "{said}"
    );
}

#[test]
fn missing_files_of_one_folder() {
    let robot = |files: &[&str]| {
        let includes: String = files
            .iter()
            .map(|file| format!("<xacro:include filename='{file}'/>\n"))
            .collect();
        let text = format!(
            "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n{includes}<link name='base'/>\n</robot>\n"
        );
        let folder = Folder::of(&[("r.urdf.xacro", text)]);
        let found = folder.json("check . --format json --select include-not-found");
        found
            .iter()
            .map(|finding| finding["places"].as_u64().unwrap())
            .collect::<Vec<_>>()
    };
    assert_eq!(robot(&["a/one.xacro", "a/two.xacro"]), [1, 1]);
    assert_eq!(
        robot(&["a/one.xacro", "a/two.xacro", "a/three.xacro", "b/one.xacro"]),
        [3, 1]
    );
}

#[test]
fn many_names_that_resemble_none_are_of_another_robot() {
    let srdf = |count: usize| {
        let links: String = (0..count)
            .map(|number| format!("    <link name=\"thumb_{number}\"/>\n"))
            .collect();
        format!(
            "<robot name=\"r\">\n  <group name=\"all\">\n    <link name=\"a\"/>\n    <link name=\"b\"/>\n    <link name=\"c\"/>\n\
                 <link name=\"d\"/>\n    <link name=\"e\"/>\n{links}  </group>\n</robot>\n"
        )
    };
    let folder = Folder::of(&[
        ("r.urdf", robot(&["a", "b", "c", "d", "e"])),
        ("r.srdf", srdf(4)),
    ]);
    let check = "check --select srdf-unknown-link --format json";
    assert_eq!(folder.json(check).len(), 4);
    folder.write("r.srdf", &srdf(5));
    let found = folder.json(check);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        message(&found[0]).ends_with("; 4 more locations in this file"),
        "{found:?}"
    );
}

#[test]
fn a_launch_file_that_names_a_missing_description_twice_has_one_wrong_path() {
    let places = |other: &str| {
        let launch = format!(
            "model = os.path.join(get_package_share_directory('arm'), 'urdf', 'arm.urdf')\n\
             given = DeclareLaunchArgument('model', default_value=model)\n\
             node = Node(parameters=[{{'robot_description': Command(['xacro ', LaunchConfiguration('model')])}}])\n\
             other = Node(parameters=[{{'robot_description': Command(['xacro ', {other}])}}])\n\
             start = LaunchDescription([given, node, other])\n"
        );
        let folder = Folder::of(&[
            ("package.xml", "<package><name>arm</name></package>".into()),
            ("launch/arm.launch.py", launch),
            ("urdf/other.urdf", robot(&["a"])),
        ]);
        let found = folder.json("check . --select launched-file-not-found --format json");
        let places = found.iter().map(|finding| finding["places"].as_u64());
        places.collect::<Vec<_>>()
    };
    // both are where the variable is set
    assert_eq!(places("model"), [Some(1)]);
    let again = "os.path.join(get_package_share_directory('arm'), 'urdf/arm.urdf')";
    assert_eq!(places(again), [Some(2)]);
}

#[test]
fn a_few_impossible_tensors_are_grouped_by_their_numbers_and_many_by_file() {
    let launch = "<param textfile='$(find arm)/urdf/a.urdf'/><node pkg='gazebo_ros'/>";
    let of = |tensors: &[&str]| {
        let links: String = tensors
            .iter()
            .enumerate()
            .map(|(number, izz)| {
                format!(
                    "<link name='l{number}'><inertial><mass value='1'/>\
                     <inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='{izz}'/></inertial></link>\n"
                )
            })
            .collect();
        let joints: String = (1..tensors.len())
            .map(|number| {
                format!(
                    "<joint name='j{number}' type='continuous'><parent link='l0'/><child link='l{number}'/></joint>\n"
                )
            })
            .collect();
        let folder = Folder::of(&[
            ("package.xml", "<package><name>arm</name></package>".into()),
            (
                "urdf/a.urdf",
                format!("<robot name='r'>\n{links}{joints}</robot>\n"),
            ),
            ("launch/arm.launch", launch.into()),
        ]);
        let check = "check . --select inertia-triangle-inequality --format json";
        folder.json(check).len()
    };
    assert_eq!(of(&["1", "2"]), 2);
    assert_eq!(of(&["1", "2", "3"]), 1);
}
