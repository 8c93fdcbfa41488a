//! What counts as used: what any file may use that some arguments bring in.
use super::set_aside_tests::found;
use rules::Severity;

#[test]
fn files_that_other_arguments_include_use_names() {
    let robot = |include: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:arg name='hand' default='left'/><xacro:property name='kinds' value='parts'/>\
             <xacro:property name='width' value='1'/><xacro:include filename='{include}'/><link name='base_$(arg hand)_${{kinds}}'/></robot>"
        )
    };
    let reads = "<robot xmlns:xacro='x'><xacro:property name='half' value='${width / 2}'/></robot>";
    let unused = |include: &str, file: &str| {
        let robot = robot(include);
        let files = [
            ("left.xacro", "<robot/>"),
            ("parts/left.xacro", "<robot/>"),
            (file, reads),
            ("r.urdf.xacro", &robot),
        ];
        let found = found(&files, "unused-property").into_iter();
        found.filter(|(path, _)| path == "r.urdf.xacro").count()
    };
    // read with `hand:=right`, or by nobody
    assert_eq!(unused("$(arg hand).xacro", "right.xacro"), 0);
    assert_eq!(unused("${kinds}/$(arg hand).xacro", "parts/right.xacro"), 0);
    assert_eq!(unused("left.xacro", "right.xacro"), 1);
    assert_eq!(unused("$(arg hand).xacro", "parts/right.xacro"), 1);
}

#[test]
fn frames_that_only_programs_for_localization_publish() {
    let robot = "<robot name='leg'><link name='map'/><link name='thigh'/><joint name='stand' type='fixed'>\
                 <parent link='map'/><child link='thigh'/></joint></robot>";
    let severity = |launch: &str, page: &str| {
        let files = [
            ("package.xml", "<package><name>leg</name></package>"),
            ("urdf/leg.urdf", robot),
            ("launch/show.launch", launch),
            ("README.md", page),
        ];
        found(&files, "reserved-frame-name")
            .first()
            .map(|one| one.1)
    };
    let show =
        "<launch><param name='robot_description' textfile='$(find leg)/urdf/leg.urdf'/></launch>";
    assert_eq!(severity(show, "A leg.\n"), Some(Severity::Info));
    assert_eq!(severity(show, "A leg for SLAM.\n"), Some(Severity::Warning));
    let locates = show.replace(
        "</launch>",
        "<node pkg='amcl' type='amcl' name='a'/></launch>",
    );
    assert_eq!(severity(&locates, "A leg.\n"), Some(Severity::Warning));
}
