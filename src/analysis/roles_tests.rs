//! What files are for, and what is said of them.
use super::super::options::CheckOptions;
use super::super::session::Setup;
use super::Session;
use vfs::testing::Tree;

/// Check a workspace of files (name and text; `robot` stands around texts of descriptions) and compare what is
/// found of names, links and joints: `file severity rule`, in order.
fn check_roles(files: &[(&str, &str)], expected: &[&str]) {
    check_roles_of("", files, expected);
}

/// The same of one path of the workspace alone.
fn check_roles_of(path: &str, files: &[(&str, &str)], expected: &[&str]) {
    let tree = Tree::new();
    for (name, text) in files {
        let is_description =
            name.ends_with("xacro") && !text.is_empty() && !text.starts_with("<robot");
        let around = |text: &str| format!("<robot name='r' xmlns:xacro='x'>{text}</robot>");
        tree.write(
            name,
            &if is_description {
                around(text)
            } else {
                (*text).to_owned()
            },
        );
    }
    let setup = Setup {
        about: tree.root().to_owned(),
        folders: vec![tree.root().to_owned()],
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let options = CheckOptions {
        paths: vec![tree.root().join(path)],
        ..CheckOptions::default()
    };
    let report = crate::check(&session, &options);
    let about_names = ["XAC0", "STR", "CTL", "XML001", "XML010"];
    let passed_over = ["nonstandard-xacro-namespace", "unused"];
    let found = report.findings.iter().filter(|finding| {
        let is_other = passed_over
            .iter()
            .any(|name| finding.rule.name.starts_with(name));
        !is_other
            && about_names
                .iter()
                .any(|code| finding.rule.code.starts_with(code))
    });
    let found: Vec<String> = found
        .map(|finding| {
            let path = session.vfs.path(finding.span.file);
            let name = path
                .strip_prefix(tree.root())
                .unwrap_or(&path)
                .display()
                .to_string();
            format!("{name} {} {}", finding.severity, finding.rule.name)
        })
        .collect();
    assert_eq!(found, expected, "{files:#?}");
}

const ARM: &str = "<link name='base'/><link name='arm'/><joint name='j' type='fixed'><parent link='base'/>\
                   <child link='arm'/></joint>";

#[test]
fn parts_of_robots_are_not_judged_as_robots() {
    let part = "<link name='hand'/><joint name='h' type='fixed'><parent link='arm'/><child link='hand'/>\
                <origin xyz='${reach} 0 0'/></joint>\
                <transmission name='t'><type>x</type><joint name='j'><hardwareInterface>y</hardwareInterface></joint>\
                </transmission>";
    let robot = format!(
        "<xacro:arg name='hand' default='false'/><xacro:property name='reach' value='1'/>{ARM}"
    );
    let behind_condition = format!(
        "{robot}<xacro:if value='$(arg hand)'><xacro:include filename='hand.xacro'/></xacro:if>"
    );
    check_roles(
        &[("r.urdf.xacro", &behind_condition), ("hand.xacro", part)],
        &[],
    );
    let computed = format!(
        "{robot}<xacro:arg name='kind' default='none'/><xacro:include filename='$(arg kind).xacro'/>"
    );
    check_roles(
        &[
            ("r.urdf.xacro", &computed),
            ("hand.xacro", part),
            ("none.xacro", "<robot/>"),
        ],
        &[],
    );
    let unprefixed = format!("{robot}<include filename='hand.xacro'/>");
    check_roles(
        &[("r.urdf.xacro", &unprefixed), ("hand.xacro", part)],
        &["r.urdf.xacro error unprefixed-xacro-tag"],
    );
    // the same file under a robot that does not define what it needs
    let lacking = format!("{ARM}<xacro:include filename='hand.xacro'/>");
    check_roles(
        &[("r.urdf.xacro", &lacking), ("hand.xacro", part)],
        &["hand.xacro error undefined-property"],
    );
    // a launch file expands the part by itself
    let launch = ("see.launch", "<param command='xacro hand.xacro'/>");
    check_roles(
        &[
            ("r.urdf.xacro", &behind_condition),
            ("hand.xacro", part),
            launch,
        ],
        &[
            "hand.xacro error undefined-link",
            "hand.xacro error undefined-property",
            "hand.xacro warning transmission-unknown-joint",
        ],
    );
    // a launch file that only writes of the part does not expand it
    let writes = (
        "see.launch",
        "<arg name='hand' doc='adds what hand.xacro has'/>",
    );
    check_roles(
        &[
            ("r.urdf.xacro", &behind_condition),
            ("hand.xacro", part),
            writes,
        ],
        &[
            "hand.xacro error undefined-link",
            "hand.xacro info undefined-property",
            "hand.xacro warning transmission-unknown-joint",
        ],
    );
}

#[test]
fn a_chain_below_a_missing_link_is_made_to_be_attached() {
    let hand = "<robot name='hand'><link name='palm'/><joint name='h' type='fixed'><parent link='tool0'/>\
                <child link='palm'/></joint></robot>";
    check_roles(&[("hand.urdf", hand)], &["hand.urdf info undefined-link"]);
    // named by somebody, it is a robot
    check_roles(
        &[("hand.urdf", hand), ("README.md", "see hand.urdf")],
        &["hand.urdf error undefined-link"],
    );
    // named together with the link to which it is attached
    check_roles(
        &[("hand.urdf", hand), ("a.launch", "send hand.urdf -l tool0")],
        &["hand.urdf info undefined-link"],
    );
    // two chains below two links of another robot
    let second = "<link name='tip'/><joint name='t' type='fixed'><parent link='flange'/><child link='tip'/></joint></robot>";
    let both = hand.replace("</robot>", second);
    let found = [
        "hand.urdf info undefined-link",
        "hand.urdf info undefined-link",
    ];
    check_roles(&[("hand.urdf", &both)], &found);
    // the robot has a root: the parent of one link is misspelled
    let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='fixed'>\
                 <parent link='bse'/><child link='arm'/></joint></robot>";
    check_roles(&[("r.urdf", robot)], &["r.urdf error undefined-link"]);
}

#[test]
fn files_without_links() {
    let device = "<robot name='d'><webots><device reference='x'/></webots><ros2_control name='c' type='system'>\
                  <hardware><plugin>p</plugin></hardware><joint name='wheel'><command_interface name='velocity'/></joint>\
                  </ros2_control></robot>";
    check_roles(&[("device.urdf", device)], &[]);
    check_roles(
        &[("empty.urdf", "<robot name='e'/>")],
        &["empty.urdf error no-links"],
    );
    // one that stands in for parts that others add
    check_roles(
        &[("none.urdf", "<robot><!-- further links --></robot>")],
        &[],
    );
    // somebody has begun a description
    check_roles(
        &[("begun.xacro", "<robot name='e'/>")],
        &["begun.xacro info no-links"],
    );
    check_roles(
        &[(
            "joints.urdf",
            "<robot name='e'><joint name='j' type='fixed'/></robot>",
        )],
        &["joints.urdf error no-links"],
    );
}

#[test]
fn empty_files() {
    check_roles(
        &[("yet.urdf.xacro", "")],
        &["yet.urdf.xacro info xml-syntax-error"],
    );
    check_roles(&[("yet.urdf", "")], &["yet.urdf info xml-syntax-error"]);
    check_roles(
        &[("yet.urdf", ""), ("a.launch", "yet.urdf")],
        &["yet.urdf error xml-syntax-error"],
    );
    let includes = "<robot name='r' xmlns:xacro='x'><link name='b'/><xacro:include filename='yet.xacro'/></robot>";
    check_roles(
        &[("r.urdf.xacro", includes), ("yet.xacro", "")],
        &["yet.xacro error xml-syntax-error"],
    );
}

#[test]
fn a_file_that_is_asked_for_alone_has_to_work() {
    let begun = [("begun.xacro", "")];
    check_roles_of(
        "begun.xacro",
        &begun,
        &["begun.xacro error xml-syntax-error"],
    );
    let reads = "<link name='a'/><link name='$(env NO_SUCH_VARIABLE)'/>";
    check_roles_of(
        "r.xacro",
        &[("r.xacro", reads)],
        &["r.xacro error expression-error"],
    );
    let chain = "<link name='palm'/><joint name='h' type='fixed'><parent link='tool0'/><child link='palm'/></joint>";
    let hand = [("hand.xacro", chain)];
    check_roles_of("hand.xacro", &hand, &["hand.xacro error undefined-link"]);
    // but for what other files include
    let robot = format!("{ARM}<xacro:include filename='hand.xacro'/>");
    check_roles_of(
        "hand.xacro",
        &[("r.urdf.xacro", &robot), ("hand.xacro", chain)],
        &[],
    );
}

#[test]
fn transmissions_are_read_by_ros_1() {
    let manifest = |tool: &str| {
        format!("<package><name>p</name><buildtool_depend>{tool}</buildtool_depend></package>")
    };
    let transmission = |joint: &str| {
        format!(
            "<transmission name='{joint}'><type>x</type><joint name='{joint}'><hardwareInterface>y</hardwareInterface>\
             </joint></transmission>"
        )
    };
    let none_fits = format!("{ARM}{}", transmission("k"));
    let one_fits = format!("{ARM}{}{}", transmission("k"), transmission("j"));
    for (tool, robot, severity) in [
        ("catkin", &none_fits, "error"),
        ("catkin", &one_fits, "error"),
        ("ament_cmake", &none_fits, "info"),
        ("ament_cmake", &one_fits, "info"),
    ] {
        let files = [("package.xml", &*manifest(tool)), ("r.urdf.xacro", robot)];
        check_roles(
            &files,
            &[&format!(
                "r.urdf.xacro {severity} transmission-unknown-joint"
            )],
        );
    }
}

#[test]
fn names_that_a_caller_may_define() {
    let library = "<robot xmlns:xacro='x'><xacro:macro name='m' params='x'><link name='${prefix}${x}${prefix}'/>\
                   <xacro:insert_block name='origin'/><xacro:other/></xacro:macro></robot>";
    let notes = [
        "lib.xacro info undefined-property",
        "lib.xacro info undefined-block",
        "lib.xacro info undefined-macro",
    ];
    check_roles(&[("lib.xacro", library)], &notes);
    // a macro that nothing calls, in a file that a robot includes
    let robot = format!("{ARM}<xacro:include filename='lib.xacro'/>");
    check_roles(&[("r.urdf.xacro", &robot), ("lib.xacro", library)], &notes);
    // called, what is missing is missing
    let calls = format!("{robot}<xacro:m x='1'/>");
    check_roles(
        &[("r.urdf.xacro", &calls), ("lib.xacro", library)],
        &[
            "lib.xacro error undefined-property",
            "lib.xacro error undefined-property",
            "lib.xacro error undefined-block",
            "lib.xacro error undefined-macro",
        ],
    );
    // a robot that consists of one misspelled call
    check_roles(
        &[("r.urdf.xacro", "<xacro:rm/>")],
        &["r.urdf.xacro error undefined-macro"],
    );
}

#[test]
fn blocks_that_a_macro_passes_on() {
    let inner = "<xacro:macro name='inner' params='*origin *shape'><joint name='j' type='fixed'>\
                 <xacro:insert_block name='origin'/></joint><link name='l'><visual><geometry>\
                 <xacro:insert_block name='shape'/></geometry></visual></link></xacro:macro>";
    let library = |call: &str| {
        format!(
            "<robot xmlns:xacro='x'>{inner}<xacro:macro name='outer' params='*origin'>{call}</xacro:macro></robot>"
        )
    };
    let passes = library(
        "<xacro:inner><xacro:insert_block name='origin'/><box size='1 1 1'/></xacro:inner>",
    );
    check_roles(&[("lib.xacro", &passes)], &[]);
    // one that nobody defines is said by itself
    let undefined =
        "<xacro:inner><xacro:insert_block name='calibration'/><box size='1 1 1'/></xacro:inner>";
    check_roles(
        &[("lib.xacro", &library(undefined))],
        &["lib.xacro info undefined-block"],
    );
    let forgets = library("<xacro:inner><xacro:insert_block name='origin'/></xacro:inner>");
    check_roles(
        &[("lib.xacro", &forgets)],
        &["lib.xacro error macro-block-mismatch"],
    );
}

#[test]
fn one_cause_is_one_finding() {
    let uses = "<link name='${prefix}base'/><xacro:arm/><xacro:insert_block name='b'/><link name='$(arg a)'/>";
    let missing = format!(
        "<xacro:include filename='gone.xacro'/><xacro:property name='prefix_' value=''/>{uses}"
    );
    check_roles(
        &[("r.urdf.xacro", &missing)],
        &["r.urdf.xacro error include-not-found"],
    );
    // nothing that is missing makes a slip of the fingers right
    let slip = missing.replace("prefix_", "prefx");
    let found = [
        "r.urdf.xacro error include-not-found",
        "r.urdf.xacro error undefined-property",
    ];
    check_roles(&[("r.urdf.xacro", &slip)], &found);
    // a parameter of another macro is no definition that comes too late
    let late = format!(
        "<xacro:macro name='m'><link name='${{p}}'/></xacro:macro>{ARM}<xacro:m/>\
         <xacro:macro name='n' params='p'/><xacro:n p='1'/>"
    );
    check_roles(
        &[("r.urdf.xacro", &late)],
        &["r.urdf.xacro error undefined-property"],
    );
    let late = format!(
        "<xacro:property name='q' value='${{p}}' lazy_eval='false'/>{ARM}<xacro:property name='p' value='1'/>"
    );
    check_roles(
        &[("r.urdf.xacro", &late)],
        &["r.urdf.xacro error use-before-definition"],
    );
}

#[test]
fn built_in_functions_are_no_values() {
    let robot = format!("{ARM}<link name='x'><inertial><mass value='${{len}}'/></inertial></link>");
    check_roles(
        &[("r.urdf.xacro", &robot)],
        &[
            "r.urdf.xacro error orphan-link",
            "r.urdf.xacro error undefined-property",
        ],
    );
    let part = "<robot xmlns:xacro='x'><link name='x'><inertial><mass value='${len}'/></inertial></link></robot>";
    check_roles(
        &[("part.xacro", part)],
        &["part.xacro info undefined-property"],
    );
}
