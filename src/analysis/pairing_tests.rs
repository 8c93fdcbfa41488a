//! Which robots an SRDF is for.
use super::set_aside_tests::found;
use rules::Severity;

const MANIFEST: (&str, &str) = (
    "moveit/package.xml",
    "<package><name>arm_moveit</name></package>",
);
const DESCRIPTION: (&str, &str) = (
    "arm/package.xml",
    "<package><name>arm_description</name></package>",
);

/// A robot of this name with links of these names in a row.
fn robot(name: &str, links: &[&str]) -> String {
    let all: String = links
        .iter()
        .map(|link| format!("<link name='{link}'/>"))
        .collect();
    let joints: String = links
        .windows(2)
        .map(|pair| {
            let (parent, child) = (pair[0], pair[1]);
            format!("<joint name='{child}_joint' type='fixed'><parent link='{parent}'/><child link='{child}'/></joint>")
        })
        .collect();
    format!("<robot name='{name}' xmlns:xacro='x'>{all}{joints}</robot>")
}

/// An SRDF with a group of these links.
fn srdf(links: &[&str]) -> String {
    let links: String = links
        .iter()
        .map(|link| format!("<link name='{link}'/>"))
        .collect();
    format!("<robot name='arm'><group name='all'>{links}</group></robot>")
}

/// How many links of the SRDF are unknown.
fn unknown(files: &[(&str, &str)]) -> usize {
    found(files, "srdf-unknown-link").len()
}

#[test]
fn a_robot_elsewhere_that_the_package_loads() {
    let (whole, stale) = (
        robot("arm", &["base", "wrist", "tip"]),
        robot("arm", &["base", "wrist"]),
    );
    let semantic = srdf(&["base", "wrist", "tip"]);
    let of = |launch: &str| {
        unknown(&[
            MANIFEST,
            DESCRIPTION,
            ("arm/urdf/whole.urdf.xacro", &whole),
            ("moveit/config/stale.urdf", &stale),
            ("moveit/config/arm.srdf", &semantic),
            ("moveit/launch/real.launch", launch),
        ])
    };
    assert_eq!(of("<launch/>"), 1);
    let loads = "<launch><param name='robot_description' command='xacro $(find arm_description)/urdf/whole.urdf.xacro'/></launch>";
    assert_eq!(of(loads), 0);
}

#[test]
fn robots_around_the_one_of_the_assistant() {
    let inner = robot("arm_right", &["base", "wrist"]);
    let semantic = srdf(&["base", "wrist"]);
    let around = "<robot name='arm' xmlns:xacro='x'><xacro:include filename='$(find arm_description)/urdf/right.urdf'/></robot>";
    let assistant = "moveit_setup_assistant_config:\n  urdf:\n    package: arm_description\n    relative_path: urdf/right.urdf\n  srdf:\n    relative_path: config/arm.srdf\n";
    let of = |others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            DESCRIPTION,
            ("arm/urdf/right.urdf", &*inner),
            ("moveit/.setup_assistant", assistant),
            ("moveit/config/arm.srdf", &semantic),
        ];
        found(&[&own, others].concat(), "srdf-robot-name").len()
    };
    assert_eq!(of(&[]), 1);
    let several = [
        ("moveit/config/right_a.urdf.xacro", around),
        ("moveit/config/right_b.urdf.xacro", around),
    ];
    assert_eq!(of(&several), 0);
}

#[test]
fn arguments_that_all_launch_files_give() {
    let choice = "<robot name='arm' xmlns:xacro='x'><xacro:arg name='kind' default='long'/><link name='base'/><link name='$(arg kind)_tip'/>\
                  <joint name='tip' type='fixed'><parent link='base'/><child link='$(arg kind)_tip'/></joint></robot>";
    let semantic = srdf(&["base", "short_tip"]);
    let assistant = "moveit_setup_assistant_config:\n  urdf:\n    package: arm_description\n    relative_path: urdf/arm.urdf.xacro\n  srdf:\n    relative_path: config/arm.srdf\n";
    let of = |launch: &str| {
        unknown(&[
            MANIFEST,
            DESCRIPTION,
            ("arm/urdf/arm.urdf.xacro", choice),
            ("moveit/.setup_assistant", assistant),
            ("moveit/config/arm.srdf", &semantic),
            ("moveit/launch/real.launch", launch),
        ])
    };
    let call = |args: &str| {
        format!(
            "<launch><param name='robot_description' command='xacro $(find arm_description)/urdf/arm.urdf.xacro{args}'/></launch>"
        )
    };
    assert_eq!(of(&call("")), 1);
    assert_eq!(of(&call(" kind:=short")), 0);
}

#[test]
fn groups_of_the_srdf_that_includes_a_part() {
    let of = |group: &str| {
        let whole = format!(
            "<robot name='arm' xmlns:xacro='x'><xacro:arg name='tool' default='none'/><group name='{group}'><link name='base'/></group>\
             <xacro:if value=\"${{'$(arg tool)' == 'hand'}}\"><xacro:include filename='hand.srdf.xacro'/></xacro:if></robot>"
        );
        let part = "<robot name='arm' xmlns:xacro='x'><group name='hand'><link name='tip'/></group>\
                    <end_effector name='hand' parent_link='base' group='hand' parent_group='whole'/></robot>";
        let model = robot("arm", &["base", "tip"]);
        let files = [
            MANIFEST,
            ("moveit/config/arm.urdf", &*model),
            ("moveit/config/arm.srdf.xacro", &whole),
            ("moveit/config/hand.srdf.xacro", part),
        ];
        found(&files, "srdf-unknown-group")
    };
    assert!(of("whole").is_empty());
    let missing = of("another");
    assert_eq!(
        missing.iter().map(|found| found.1).collect::<Vec<_>>(),
        [Severity::Error]
    );
}
