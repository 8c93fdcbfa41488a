//! Packages as they are installed, and packages that are not there, seen from a whole check.
use super::{CheckOptions, Report, Session, Setup, grouped};
use rules::Severity;
use vfs::testing::Tree;

fn check(tree: &Tree, changed: &[&str]) -> Report {
    let session = Session::new(&tree.environment(&[]), Setup::default()).unwrap();
    let changed = changed.iter().map(|name| tree.path(name)).collect();
    let paths = vec![tree.root().to_owned()];
    let options = CheckOptions {
        paths,
        changed,
        ..CheckOptions::default()
    };
    grouped(crate::check(&session, &options))
}

/// Findings of a rule: severity, message, and the number of further places.
fn found(report: &Report, rule: &str) -> Vec<(Severity, String, usize)> {
    let of_rule = report
        .findings
        .iter()
        .filter(|finding| finding.rule.name == rule);
    of_rule
        .map(|finding| {
            (
                finding.severity,
                finding.message.clone(),
                finding.places.len(),
            )
        })
        .collect()
}

fn messages(report: &Report, rule: &str) -> Vec<String> {
    found(report, rule)
        .into_iter()
        .map(|(_, message, _)| message)
        .collect()
}

fn robot(content: &str) -> String {
    format!(
        "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='base'/>{content}</robot>"
    )
}

fn manifest(name: &str) -> String {
    format!("<package format='3'><name>{name}</name></package>")
}

#[test]
fn includes_of_installed_files() {
    let tree = Tree::new();
    let install = "install(DIRECTORY description/parts DESTINATION share/cell)";
    tree.write("cell/package.xml", &manifest("cell"));
    tree.write("cell/CMakeLists.txt", install);
    tree.write(
        "cell/description/parts/arm.xacro",
        &robot("").replace("<link name='base'/>", ""),
    );
    let include = "<xacro:include filename='$(find cell)/parts/arm.xacro'/>";
    tree.write("cell/description/urdf/r.urdf.xacro", &robot(include));
    assert!(check(&tree, &[]).findings.is_empty());
    // the build file belongs to what was read
    tree.write("cell/CMakeLists.txt", &install.replace("parts", "other"));
    let report = check(&tree, &["cell/CMakeLists.txt"]);
    assert_eq!(found(&report, "include-not-found").len(), 1);
    assert_eq!(found(&report, "include-not-found")[0].0, Severity::Error);
}

#[test]
fn includes_that_other_arguments_or_the_build_give() {
    let tree = Tree::new();
    tree.write("p/package.xml", &manifest("p"));
    let by_default = "<xacro:arg name='model' default=''/>\
                      <xacro:include filename='parts/$(arg model).xacro'/>";
    tree.write("p/a.urdf.xacro", &robot(by_default));
    tree.write(
        "p/b.urdf.xacro",
        &robot("<xacro:include filename='parts/made.xacro'/>${made}"),
    );
    tree.write(
        "p/c.urdf.xacro",
        &robot("<xacro:include filename='parts/plain.xacro'/><link name='${plain}'/>"),
    );
    tree.write(
        "p/d.urdf.xacro",
        &robot("<xacro:include filename='parts/gone.xacro'/>"),
    );
    let property = |text: &str| robot(text).replace("<link name='base'/>", "");
    tree.write(
        "p/parts/made.xacro.in",
        &property("<xacro:property name='made' value='@MADE@'/>"),
    );
    tree.write(
        "p/parts/plain.xacro.in",
        &property("<xacro:property name='plain' value='base'/>"),
    );
    let report = check(&tree, &[]);
    let includes = found(&report, "include-not-found");
    let severities: Vec<Severity> = includes.iter().map(|(severity, ..)| *severity).collect();
    assert_eq!(
        severities,
        [Severity::Info, Severity::Info, Severity::Error],
        "{includes:?}"
    );
    assert!(includes[1].1.contains("is generated from"), "{includes:?}");
    assert!(found(&report, "undefined-property").is_empty());
    // the template without placeholders is read: it names the link a second time
    assert_eq!(found(&report, "duplicate-link-name").len(), 1);
}

#[test]
fn missing_meshes_by_folder() {
    let tree = Tree::new();
    tree.write("cell/package.xml", &manifest("cell"));
    tree.write("cell/meshes/there.stl", "");
    let mesh = |uri: &str| {
        format!(
            "<link name='{}'><visual><geometry><mesh filename='{uri}'/></geometry></visual></link>",
            uri.replace('/', "_")
        )
    };
    let uris = [
        "package://cell/visual/a.stl",
        "package://cell/visual/b.stl",
        "package://cell/visual/b.stl",
        "package://cell/meshes/c.stl",
    ];
    tree.write("cell/r.urdf", &robot(&uris.map(mesh).concat()));
    let report = check(&tree, &[]);
    let meshes = found(&report, "mesh-not-found");
    assert_eq!(meshes.len(), 2, "{meshes:?}");
    assert!(
        meshes[0]
            .1
            .ends_with("package `cell` has no file `visual/a.stl`; 2 more locations in this file")
    );
    assert_eq!((meshes[0].2, meshes[1].2), (2, 0));
}

#[test]
fn one_wrong_beginning_of_all_meshes() {
    let tree = Tree::new();
    let mesh =
        |uri: &str| format!("<visual><geometry><mesh filename='{uri}'/></geometry></visual>");
    let exported: String = ["a", "b", "c"]
        .iter()
        .map(|name| mesh(&format!("package:///{name}.stl")))
        .collect();
    let plain = format!(
        "<robot name='r'><link name='base'>{exported}{}</link></robot>",
        mesh("package:/cell/d.stl")
    );
    tree.write("r.urdf", &plain);
    let places: Vec<usize> = found(&check(&tree, &[]), "malformed-resource-uri")
        .iter()
        .map(|(_, _, places)| *places)
        .collect();
    assert_eq!(places, [2, 0]);
}

#[test]
fn packages_that_are_not_there() {
    let tree = Tree::new();
    let include = |package: &str| {
        robot(&format!(
            "<xacro:include filename='$(find {package})/a.xacro'/>"
        ))
    };
    for name in ["a", "b"] {
        tree.write(&format!("{name}.urdf.xacro"), &include("far_description"));
    }
    let report = check(&tree, &[]);
    let expected = "none of the packages of this robot were found; 1 more location, in 2 files";
    assert_eq!(
        found(&report, "package-not-found"),
        [(Severity::Warning, expected.to_owned(), 1)]
    );
    tree.write(".git/HEAD", "");
    // one that is found tells that packages are looked for in the right places
    tree.write("cell/package.xml", &manifest("cell"));
    tree.write(
        "cell/a.xacro",
        &robot("").replace("<link name='base'/>", ""),
    );
    let both = robot(
        "<xacro:include filename='$(find cell)/a.xacro'/><xacro:include filename='$(find far_description)/a.xacro'/>",
    );
    tree.write("a.urdf.xacro", &both);
    std::fs::remove_file(tree.path("b.urdf.xacro")).unwrap();
    let severities: Vec<Severity> = found(&check(&tree, &[]), "package-not-found")
        .into_iter()
        .map(|(severity, ..)| severity)
        .collect();
    assert_eq!(severities, [Severity::Info]);
}

#[test]
fn packages_of_others() {
    let far = "package://far_description/meshes/hand.stl";
    let mesh = format!(
        "<link name='hand'><visual><geometry><mesh filename='{far}'/></geometry></visual></link>"
    );
    let severity = |files: &[(&str, &str)]| {
        let tree = Tree::new();
        tree.write("ws/.git/HEAD", "");
        tree.write("ws/arm/urdf/a.urdf.xacro", &robot(&mesh));
        files
            .iter()
            .for_each(|(name, text)| tree.write(&format!("ws/{name}"), text));
        found(&check(&tree, &[]), "package-not-found")[0].0
    };
    let own = manifest("cell");
    assert_eq!(severity(&[]), Severity::Warning);
    // packages are looked for in the right places
    assert_eq!(severity(&[("arm/package.xml", &own)]), Severity::Info);
    assert_eq!(
        severity(&[("arm/package.xml", &own), ("arm/models/hand.stl", "")]),
        Severity::Warning
    );
    // a list of repositories brings it, or the folder is the package
    assert_eq!(severity(&[("arm/all.repos", "")]), Severity::Info);
    assert_eq!(severity(&[("arm/meshes/hand.stl", "")]), Severity::Info);
}

#[test]
fn dependencies_of_other_packages() {
    let include = robot("<xacro:include filename='$(find tool_descriptio)/x.xacro'/>");
    let severity = |manifest_of_cell: &str| {
        let tree = Tree::new();
        tree.write(".git/HEAD", "");
        tree.write(
            "tool_description/package.xml",
            &manifest("tool_description"),
        );
        tree.write("arm/package.xml", &manifest("arm"));
        tree.write("arm/a.urdf.xacro", &include);
        tree.write("cell/package.xml", manifest_of_cell);
        found(&check(&tree, &[]), "package-not-found")[0].0
    };
    let depends = manifest("cell").replace("</name>", "</name><depend>tool_descriptio</depend>");
    assert_eq!(severity(&manifest("cell")), Severity::Error);
    assert_eq!(severity(&depends), Severity::Info);
}

#[test]
fn circles_of_dependencies() {
    let severity = |manifest_of_tool: &str| {
        let tree = Tree::new();
        tree.write(".git/HEAD", "");
        tree.write("cell/package.xml", &manifest("cell"));
        tree.write(
            "cell/a.urdf.xacro",
            &robot("<xacro:include filename='$(find tool)/x.xacro'/>"),
        );
        tree.write("tool/package.xml", manifest_of_tool);
        tree.write(
            "tool/x.xacro",
            &robot("").replace("<link name='base'/>", ""),
        );
        found(&check(&tree, &[]), "missing-package-dependency")[0].0
    };
    let depends = manifest("tool").replace("</name>", "</name><exec_depend>cell</exec_depend>");
    assert_eq!(severity(&manifest("tool")), Severity::Warning);
    assert_eq!(severity(&depends), Severity::Info);
}

#[test]
fn dependencies_once_per_pair() {
    let tree = Tree::new();
    tree.write(".git/HEAD", "");
    for name in ["cell", "tool", "lamp"] {
        tree.write(&format!("{name}/package.xml"), &manifest(name));
        tree.write(
            &format!("{name}/x.xacro"),
            &robot("").replace("<link name='base'/>", ""),
        );
    }
    let include = |package: &str| format!("<xacro:include filename='$(find {package})/x.xacro'/>");
    let maybe = |package: &str| format!("<xacro:if value='true'>{}</xacro:if>", include(package));
    tree.write(
        "cell/a.urdf.xacro",
        &robot(&(include("tool") + &maybe("lamp"))),
    );
    tree.write(
        "cell/b.urdf.xacro",
        &robot(&(include("tool") + &include("gone"))),
    );
    let report = check(&tree, &[]);
    let mut dependencies = found(&report, "missing-package-dependency");
    dependencies.sort();
    assert_eq!(
        dependencies,
        [
            (Severity::Info, "package `cell` does not declare its dependency on `lamp`".to_owned(), 0),
            (
                Severity::Warning,
                "package `cell` does not declare its dependency on `tool`; 1 more location, in 2 files"
                    .to_owned(),
                1
            ),
        ]
    );
    assert_eq!(messages(&report, "package-not-found").len(), 1);
}

#[test]
fn descriptions_in_letters_of_any_case() {
    let tree = Tree::new();
    tree.write(
        "A.URDF",
        "<robot name='a'><link name='x'/><link name='y'/></robot>",
    );
    tree.write("B.Xacro", &robot("<link name='y'/>"));
    assert_eq!(check(&tree, &[]).robots, 2);
}
