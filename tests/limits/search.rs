//! How far packages and files of the workspace are searched for, and how much of their build files is read.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use xacro_lsp::base::limits::*;
use xacro_lsp::packages::{PackageOptions, Packages};
use xacro_lsp::vfs::{Environment, Vfs};

use super::{LINK, MANIFEST, folder, robot, run, write};

/// Whether the package `far` is found whose manifest lies so many folders down.
fn found_below(levels: usize) -> bool {
    let folder = folder();
    let deep: PathBuf = (0..levels).map(|_| "d").collect();
    // packages of the other tests lie in the same workspace
    let name = format!("far{levels}");
    write(
        &folder,
        &format!("{}/package.xml", deep.display()),
        MANIFEST.replace("far", &name),
    );
    write(&folder, "r.urdf", "<robot name=\"r\"/>");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let options = PackageOptions {
        explicit: vec![folder.clone()],
        ..PackageOptions::default()
    };
    Packages::new(
        Arc::new(Vfs::with_cwd(1 << 20, folder.clone())),
        &env,
        options,
    )
    .find(&name, &folder.join("r.urdf"))
    .is_ok()
}

#[test]
fn scan_depth() {
    assert_eq!(
        (found_below(SCAN_DEPTH - 4), found_below(SCAN_DEPTH + 4)),
        (true, false)
    );
}

/// Whether a file of the same name is suggested that lies so many folders down.
fn suggested_below(levels: usize) -> bool {
    let folder = folder();
    let deep: PathBuf = (0..levels).map(|_| "d").collect();
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    let name = format!("part{levels}.stl");
    write(&folder, &format!("{}/{name}", deep.display()), "");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let packages = Packages::new(
        Arc::new(Vfs::with_cwd(1 << 20, folder.clone())),
        &env,
        PackageOptions::default(),
    );
    packages
        .namesake(
            &folder.join("gone").join(name),
            Some(&folder),
            &folder.join("r.urdf"),
        )
        .is_some()
}

#[test]
fn namesake_depth() {
    assert_eq!(
        (
            suggested_below(NAMESAKE_DEPTH - 4),
            suggested_below(NAMESAKE_DEPTH + 4)
        ),
        (true, false)
    );
}

#[test]
fn manifest_nodes() {
    let found = |count: usize| {
        let folder = folder();
        let filler = "<a/>".repeat(count);
        write(
            &folder,
            "far/package.xml",
            MANIFEST.replace("</package>", &format!("{filler}</package>")),
        );
        let env = Environment {
            vars: BTreeMap::new(),
            cwd: folder.clone(),
            ..Environment::default()
        };
        let options = PackageOptions {
            explicit: vec![folder.clone()],
            ..PackageOptions::default()
        };
        let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
        Packages::new(vfs, &env, options)
            .find("far", &folder.join("r.urdf"))
            .is_ok()
    };
    // its name counts all the same
    assert_eq!((found(1000), found(MANIFEST_NODES as usize)), (true, true));
}

/// Whether a mesh is found where a `CMakeLists.txt` installs it that says something else before.
fn installed_behind(before: &str) -> bool {
    let folder = folder();
    let install = "install(DIRECTORY description/meshes DESTINATION share/near)";
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    write(
        &folder,
        "CMakeLists.txt",
        before.replace("INSTALL", install),
    );
    write(&folder, "description/meshes/a.stl", "");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    Packages::new(vfs, &env, PackageOptions::default())
        .built(&folder.join("meshes/a.stl"))
        .is_some()
}

#[test]
fn build_bytes() {
    let behind =
        |count: usize| installed_behind(&format!("{} INSTALL", "set(a bbbbbbb)\n".repeat(count)));
    assert_eq!(
        (behind(100), behind(BUILD_BYTES as usize / 10)),
        (true, false)
    );
}

#[test]
fn build_depth() {
    let below = |levels: usize| {
        installed_behind(&format!(
            "{} INSTALL {}",
            "foreach(a b)\n".repeat(levels),
            "endforeach()\n".repeat(levels)
        ))
    };
    assert_eq!(
        (below(BUILD_DEPTH as usize), below(BUILD_DEPTH as usize + 1)),
        (true, false)
    );
    let nested = format!("share/near', {}", "[".repeat(1_000_000));
    let folder = folder();
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    write(&folder, "setup.py", format!("x = ('{nested}"));
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    assert!(
        Packages::new(vfs, &env, PackageOptions::default())
            .built(&folder.join("a.stl"))
            .is_none()
    );
}

/// Makes a hundred thousand folders and twenty thousand files: run it by `cargo test --test limits -- --ignored`.
#[test]
#[ignore = "makes 100,000 folders"]
fn many_folders() {
    let folder = folder();
    write(&folder, "r.urdf", robot(LINK));
    for n in 0..SCAN_FOLDERS + 5_000 {
        let group = folder.join((n / 1000).to_string());
        if n % 1000 == 0 {
            fs::create_dir(&group).unwrap();
        }
        let path = group.join(n.to_string());
        fs::create_dir(&path).unwrap();
        if n % 5 == 0 {
            fs::write(path.join("x.urdf"), "<robot name=\"x\"/>").unwrap();
        }
    }
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let options = PackageOptions {
        explicit: vec![folder.clone()],
        ..PackageOptions::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 20, folder.clone()));
    let packages = Packages::new(vfs.clone(), &env, options);
    // packages of the other tests lie in the same workspace
    assert!(packages.find("nowhere", &folder.join("r.urdf")).is_err());
    assert!(
        packages
            .namesake(
                &folder.join("gone.stl"),
                Some(&folder),
                &folder.join("r.urdf")
            )
            .is_none()
    );
    let mut host = xacro_lsp::analysis::AnalysisHost::new(env, vec![folder.clone()]);
    while host.scan(|| false).is_some() {}
    assert!(
        host.known_files().len() <= SCAN_FILES + 1,
        "{}",
        host.known_files().len()
    );
    let _ = fs::remove_dir_all(folder);
}

#[test]
fn files_beside() {
    let folder = folder();
    write(
        &folder,
        "package.xml",
        "<package><name>arm</name></package>",
    );
    write(
        &folder,
        "urdf/arm.urdf",
        "<robot name=\"arm\"><link name=\"base\"/></robot>",
    );
    let srdf = "<robot name=\"arm\"><group name=\"all\"><link name=\"base\"/><link name=\"hand\"/></group></robot>";
    for n in 0..FILES_BESIDE {
        write(&folder, &format!("config/arm_{n}.srdf"), srdf);
    }
    let reported = || {
        let arguments = ["check", "--no-group", "--format", "json", "."];
        let said = run(&folder, &arguments, &mut std::io::empty());
        said.matches("unknown link `hand`").count()
    };
    assert_eq!(reported(), FILES_BESIDE);
    write(&folder, "config/more.srdf", srdf);
    assert_eq!(reported(), 0);
    let _ = fs::remove_dir_all(folder);
}
