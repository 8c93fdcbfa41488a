//! Packages as they are installed.

use crate::{PackageOptions, Packages};
use vfs::testing::Tree;

/// What stands for a path of package `demo` in a workspace with these files; empty: nothing.
fn built(files: &[(&str, &str)], missing: &str) -> String {
    let tree = Tree::new();
    if !files.iter().any(|(name, _)| name.ends_with("package.xml")) {
        tree.write(
            "ws/src/demo/package.xml",
            "<package><name>demo</name></package>",
        );
    }
    for (name, text) in files {
        tree.write(&format!("ws/src/{name}"), text);
    }
    let packages = Packages::new(
        tree.vfs().clone(),
        &tree.environment(&[]),
        PackageOptions::default(),
    );
    let from = tree.path("ws/src/demo/r.urdf");
    let Ok(package) = packages.find("demo", &from) else {
        return "unknown package".to_owned();
    };
    let found = packages.built(&package.path.join(missing));
    let shown = found.map(|built| {
        let path = built
            .path
            .strip_prefix(tree.path("ws/src"))
            .unwrap_or(&built.path)
            .display()
            .to_string();
        if built.is_template {
            format!("template {path}")
        } else {
            path
        }
    });
    shown.unwrap_or_default()
}

const MESH: (&str, &str) = ("demo/description/meshes/a.stl", "");

#[test]
fn cmake_install() {
    let table = [
        (
            "install(DIRECTORY description/meshes DESTINATION share/demo)",
            "meshes/a.stl",
        ),
        (
            "install(DIRECTORY description/ DESTINATION share/demo)",
            "meshes/a.stl",
        ),
        (
            "install(DIRECTORY description DESTINATION share/demo/x)",
            "x/description/meshes/a.stl",
        ),
        (
            "install(DIRECTORY description/meshes/ DESTINATION share/demo)",
            "a.stl",
        ),
        (
            "install(DIRECTORY ./description/meshes DESTINATION ./share/demo/)",
            "meshes/a.stl",
        ),
        (
            "project(demo)\ninstall(DIRECTORY description/meshes DESTINATION share/${PROJECT_NAME})",
            "meshes/a.stl",
        ),
        (
            "project(demo)\ninstall(DIRECTORY description/ DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})",
            "meshes/a.stl",
        ),
        (
            "project(demo)\ninstall(DIRECTORY ${PROJECT_SOURCE_DIR}/description/meshes DESTINATION \
             ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME} FILES_MATCHING PATTERN \"*.stl\")",
            "meshes/a.stl",
        ),
        (
            "install(FILES description/meshes/a.stl DESTINATION share/demo/b)",
            "b/a.stl",
        ),
        (
            "install(FILES description/meshes/a.stl DESTINATION share/demo RENAME b.stl)",
            "b.stl",
        ),
        (
            "file(GLOB all description/meshes/*)\ninstall(FILES ${all} DESTINATION share/demo)",
            "a.stl",
        ),
        (
            "set(to share/demo)\nset(from description/meshes)\ninstall(DIRECTORY ${from} DESTINATION ${to})",
            "meshes/a.stl",
        ),
        (
            "foreach(d meshes urdf)\ninstall(DIRECTORY description/${d} DESTINATION share/demo)\nendforeach()",
            "meshes/a.stl",
        ),
        (
            "set(l meshes)\nforeach(d IN LISTS l)\ninstall(DIRECTORY description/${d} DESTINATION share/demo)\nendforeach()",
            "meshes/a.stl",
        ),
        (
            "project(demo)\nament_auto_package(INSTALL_TO_SHARE launch description/meshes)",
            "meshes/a.stl",
        ),
        (
            "if(X)\ninstall(DIRECTORY description/meshes DESTINATION share/demo)\nendif()",
            "meshes/a.stl",
        ),
        (
            "file(COPY description DESTINATION ${CMAKE_CURRENT_BINARY_DIR}/all)\n\
             install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/all/description/ DESTINATION share/demo)",
            "meshes/a.stl",
        ),
    ];
    for (text, missing) in table {
        let files = [MESH, ("demo/CMakeLists.txt", text)];
        assert_eq!(built(&files, missing), MESH.0, "{text}");
        assert_eq!(built(&files, "gone/a.stl"), "", "{text}");
        assert_eq!(built(&files, &format!("{missing}x")), "", "{text}");
    }
}

#[test]
fn what_is_installed_elsewhere_or_cannot_be_told() {
    for text in [
        "install(DIRECTORY description/meshes DESTINATION share/other)",
        "install(DIRECTORY description/meshes DESTINATION include)",
        "install(DIRECTORY ${unknown}/meshes DESTINATION share/demo)",
        "install(TARGETS meshes DESTINATION share/demo)",
        "# install(DIRECTORY description/meshes DESTINATION share/demo)",
        "macro(m)\ninstall(DIRECTORY description/meshes DESTINATION share/demo)\nendmacro()",
        "install(DIRECTORY",
        "",
    ] {
        assert_eq!(
            built(&[MESH, ("demo/CMakeLists.txt", text)], "meshes/a.stl"),
            "",
            "{text}"
        );
    }
}

#[test]
fn folders_below_and_above() {
    let nested = [
        MESH,
        (
            "demo/CMakeLists.txt",
            "project(demo)\nadd_subdirectory(description)",
        ),
        (
            "demo/description/CMakeLists.txt",
            "install(DIRECTORY meshes DESTINATION share/${PROJECT_NAME})",
        ),
    ];
    assert_eq!(built(&nested, "meshes/a.stl"), MESH.0);
    // a folder below has variables of its own, and hands some up
    let with = |below: &'static str| {
        [
            MESH,
            (
                "demo/CMakeLists.txt",
                "project(demo)\nset(WHERE share/other)\nadd_subdirectory(library)\ninstall(DIRECTORY description/meshes DESTINATION share/${PROJECT_NAME})\ninstall(FILES a.txt DESTINATION ${WHERE})",
            ),
            ("demo/library/CMakeLists.txt", below),
            ("demo/a.txt", ""),
        ]
    };
    let own = with("project(library)\nset(WHERE share/demo/mine)");
    assert_eq!(built(&own, "meshes/a.stl"), MESH.0);
    assert_eq!(built(&own, "mine/a.txt"), "");
    let up = with("set(WHERE share/demo/mine PARENT_SCOPE)");
    assert_eq!(built(&up, "mine/a.txt"), "demo/a.txt");
    let above = [
        (
            "demo/manual/package.xml",
            "<package><name>demo</name></package>",
        ),
        (
            "demo/CMakeLists.txt",
            "install(DIRECTORY generated/ DESTINATION share/demo)",
        ),
        ("demo/generated/meshes/a.stl", ""),
    ];
    assert_eq!(built(&above, "meshes/a.stl"), "demo/generated/meshes/a.stl");
    let endless = [
        MESH,
        (
            "demo/CMakeLists.txt",
            "add_subdirectory(.)\nadd_subdirectory(.)",
        ),
    ];
    assert_eq!(built(&endless, "meshes/a.stl"), "");
}

#[test]
fn setup_py() {
    let text = "package_name = 'demo'\nsetup(data_files=[\n ('share/' + package_name, ['package.xml']),\n \
                (os.path.join('share', package_name, 'meshes'), glob('description/meshes/*.stl')),\n])";
    let files = [
        MESH,
        ("demo/description/meshes/b.dae", ""),
        ("demo/setup.py", text),
    ];
    assert_eq!(built(&files, "meshes/a.stl"), MESH.0);
    assert_eq!(
        (built(&files, "meshes/b.dae"), built(&files, "urdf/a.stl")),
        (String::new(), String::new())
    );
}

#[test]
fn templates() {
    let beside = [("demo/urdf/r.xacro.in", "")];
    assert_eq!(
        built(&beside, "urdf/r.xacro"),
        "template demo/urdf/r.xacro.in"
    );
    let text = "configure_file(in/r.xacro.in urdf/r.xacro)\n\
                install(FILES ${CMAKE_CURRENT_BINARY_DIR}/urdf/r.xacro DESTINATION share/demo/robots)";
    let configured = [("demo/in/r.xacro.in", ""), ("demo/CMakeLists.txt", text)];
    assert_eq!(
        built(&configured, "robots/r.xacro"),
        "template demo/in/r.xacro.in"
    );
    assert_eq!(built(&configured, "urdf/r.xacro"), "");
}

#[test]
fn files_that_xacro_makes() {
    let check = |arguments: &str, missing: &str, expected: &str| {
        let text = format!("project(demo)\nset(a b)\nxacro_add_files({arguments})");
        let files = [
            ("demo/urdf/r.urdf.xacro", ""),
            ("demo/CMakeLists.txt", &text),
        ];
        assert_eq!(built(&files, missing), expected, "{arguments}");
    };
    let source = "template demo/urdf/r.urdf.xacro";
    check("urdf/r.urdf.xacro INSTALL", "urdf/r.urdf", source);
    check(
        "TARGET all INORDER urdf/r.urdf.xacro INSTALL DESTINATION made",
        "made/r.urdf",
        source,
    );
    check(
        "urdf/r.urdf.xacro REMAP side:=${a} OUTPUT ${a}.urdf INSTALL DESTINATION made",
        "made/b.urdf",
        source,
    );
    check(
        "urdf/r.urdf.xacro OUTPUT b.urdf INSTALL DESTINATION made",
        "made/r.urdf",
        "",
    );
    check("urdf/r.urdf.xacro", "urdf/r.urdf", "");
    check("urdf/gone.urdf.xacro INSTALL", "urdf/gone.urdf", "");
}

#[test]
fn packages_without_a_manifest() {
    let install = "project(demo)\ninstall(DIRECTORY meshes DESTINATION share/${PROJECT_NAME})";
    let other = ("other/package.xml", "<package><name>other</name></package>");
    let files = [
        other,
        ("tree/CMakeLists.txt", install),
        ("tree/meshes/a.stl", ""),
        ("tree/x/package.xml.in", ""),
    ];
    assert_eq!(built(&files, "meshes/b.stl"), "");
    let files = [
        other,
        ("tree/CMakeLists.txt", "project(demo)\ninstall(TARGETS x)"),
    ];
    assert_eq!(built(&files, "meshes/a.stl"), "unknown package");
    for manifest in [
        "<package><name>demo</name></package>",
        "<package><name>@PROJECT_NAME@</name></package>",
    ] {
        let files = [
            other,
            (
                "tree/CMakeLists.txt",
                "project(demo)\ninstall(DIRECTORY d/ DESTINATION share/demo)",
            ),
            ("tree/package.xml.in", manifest),
            ("tree/d/a.stl", ""),
        ];
        assert_eq!(built(&files, "a.stl"), "tree/d/a.stl", "{manifest}");
    }
}

#[test]
fn the_build_type_decides_which_build_file_counts() {
    let build = |kind: &str| {
        let manifest = format!(
            "<package><name>demo</name><export><build_type>{kind}</build_type></export></package>"
        );
        let setup = "data_files=[('share/demo', glob('urdf/*'))]";
        let files = [
            ("demo/package.xml", manifest.as_str()),
            (
                "demo/CMakeLists.txt",
                "install(DIRECTORY urdf DESTINATION share/demo)",
            ),
            ("demo/setup.py", setup),
            ("demo/urdf/lamp.urdf", "<robot name='lamp'/>"),
        ];
        (built(&files, "lamp.urdf"), built(&files, "torch.urdf"))
    };
    let flat = ("demo/urdf/lamp.urdf".to_owned(), String::new());
    assert_eq!(build("ament_python"), flat);
    assert_eq!(build("ament_cmake"), Default::default());
}

/// What a build file of package `demo` installs and its sources do not have, in order.
fn missing(build_file: &str) -> String {
    let tree = Tree::new();
    for (name, text) in [
        ("package.xml", "<package><name>demo</name></package>"),
        ("urdf/r.urdf", ""),
        (
            "tools/CMakeLists.txt",
            "install(FILES a.py DESTINATION lib/demo)",
        ),
        ("CMakeLists.txt", build_file),
    ] {
        tree.write(&format!("ws/src/demo/{name}"), text);
    }
    let options = PackageOptions::default();
    let packages = Packages::new(tree.vfs().clone(), &tree.environment(&[]), options);
    let build = packages.build_around(&tree.path("ws/src/demo/package.xml"));
    let build = build.unwrap_or_default();
    let shown = build.missing(tree.vfs()).map(|source| {
        let file = tree.vfs().text(&source.file);
        let text = file.map(|file| file.text.to_string()).unwrap_or_default();
        let kind = if source.is_folder { "/" } else { "" };
        format!("{}{kind} at {}", source.shown, source.range.slice(&text))
    });
    shown.collect::<Vec<_>>().join(", ")
}

#[test]
fn what_is_installed_and_not_there() {
    let table = [
        (
            "install(DIRECTORY urdf meshes DESTINATION share/demo)",
            "meshes/ at meshes",
        ),
        (
            "install(DIRECTORY \"meshes\" DESTINATION share/demo)",
            "meshes/ at \"meshes\"",
        ),
        (
            "install(FILES urdf/r.urdf urdf/s.urdf DESTINATION share/demo)",
            "urdf/s.urdf at urdf/s.urdf",
        ),
        (
            "install(PROGRAMS run.py DESTINATION lib/demo)",
            "run.py at run.py",
        ),
        (
            "foreach(d urdf rviz)\ninstall(DIRECTORY ${d}/ DESTINATION share/demo)\nendforeach()",
            "rviz// at ${d}/",
        ),
        (
            "set(DIRS urdf rviz)\ninstall(DIRECTORY ${DIRS} DESTINATION share/demo)",
            "rviz/ at ${DIRS}",
        ),
        (
            "ament_auto_package(INSTALL_TO_SHARE urdf maps)",
            "maps/ at maps",
        ),
        ("add_subdirectory(tools)", "a.py at a.py"),
        // may go on
        (
            "install(DIRECTORY meshes DESTINATION share/demo OPTIONAL)",
            "",
        ),
        (
            "install(DIRECTORY meshes DESTINATION share/demo FILES_MATCHING PATTERN \"*.stl\")",
            "",
        ),
        (
            "if(BUILD_TESTING)\ninstall(DIRECTORY meshes DESTINATION share/demo)\nendif()",
            "",
        ),
        (
            "if(EXISTS meshes)\nlist(APPEND DIRS meshes)\nendif()\ninstall(DIRECTORY ${DIRS} DESTINATION share/demo)",
            "",
        ),
        (
            "set(DIRS urdf)\nif(EXISTS meshes)\nlist(APPEND DIRS meshes)\nendif()\nforeach(d ${DIRS})\n\
             install(DIRECTORY ${d} DESTINATION share/demo)\nendforeach()",
            "",
        ),
        (
            "set(DIRS urdf)\nif(EXISTS meshes)\nlist(APPEND DIRS meshes)\nendif()\nforeach(d IN LISTS DIRS)\n\
             install(DIRECTORY ${d} DESTINATION share/demo)\nendforeach()",
            "",
        ),
        // not known
        ("install(DIRECTORY ${MESHES} DESTINATION share/demo)", ""),
        (
            "install(DIRECTORY ../other/meshes DESTINATION share/demo)",
            "",
        ),
        (
            "install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/meshes DESTINATION share/demo)",
            "",
        ),
        // the build makes it
        (
            "file(MAKE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/meshes)\ninstall(DIRECTORY meshes DESTINATION share/demo)",
            "",
        ),
        (
            "add_custom_command(OUTPUT s.urdf COMMAND xacro)\ninstall(FILES s.urdf DESTINATION share/demo)",
            "",
        ),
        ("# install(DIRECTORY meshes DESTINATION share/demo)", ""),
    ];
    for (build_file, expected) in table {
        assert_eq!(missing(build_file), expected, "{build_file}");
    }
}
