//! Files that may not be written, disks that are full, and who writes at the same time: every file stays whole.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{MetadataExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use super::{
    LINT, fixable, fixed, folder, lint, lint_bound, meanwhile, mode, run, texts, told, write,
};

#[test]
fn a_workspace_that_may_only_be_read_is_checked_and_left_alone() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    mode(&folder, 0o555);
    if let Some((code, text)) = lint_bound(&folder, &["fix", "."]) {
        assert_eq!(code, 2, "{text}");
        assert!(
            text.contains("cannot write r.urdf.xacro: Permission denied"),
            "{text}"
        );
    }
    mode(&folder, 0o777);
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(3))])
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_that_is_protected_is_not_replaced() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    mode(&folder.join("r.urdf.xacro"), 0o444);
    if let Some((code, text)) = lint_bound(&folder, &["fix", "."]) {
        assert_eq!(code, 2, "{text}");
        assert!(
            text.contains("cannot write r.urdf.xacro: Permission denied"),
            "{text}"
        );
    }
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(3))])
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn permissions_and_owner_stay() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    let path = folder.join("r.urdf.xacro");
    mode(&path, 0o640);
    if fs::metadata(&path).unwrap().uid() == 0 {
        std::os::unix::fs::chown(&path, Some(65534), Some(65534)).unwrap();
    }
    let before = fs::metadata(&path).unwrap();
    let (code, text) = lint(&folder, &["fix", "."]);
    assert_eq!(
        (code, fs::read_to_string(&path).unwrap()),
        (0, fixed(3)),
        "{text}"
    );
    let after = fs::metadata(&path).unwrap();
    assert_eq!(
        (after.mode(), after.uid(), after.gid()),
        (before.mode(), before.uid(), before.gid())
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn links_are_followed_inside_the_workspace_and_refused_outside() {
    let (folder, other) = (folder(), folder());
    write(&folder, "robots/r.urdf.xacro", &fixable(1));
    write(&other, "foreign.urdf.xacro", &fixable(1));
    symlink("robots/r.urdf.xacro", folder.join("link.urdf.xacro")).unwrap();
    symlink(
        other.join("foreign.urdf.xacro"),
        folder.join("away.urdf.xacro"),
    )
    .unwrap();
    lint(&folder, &["fix", "."]);
    assert!(
        folder
            .join("link.urdf.xacro")
            .symlink_metadata()
            .unwrap()
            .is_symlink()
    );
    assert_eq!(
        fs::read_to_string(folder.join("robots/r.urdf.xacro")).unwrap(),
        fixed(1)
    );
    assert_eq!(
        fs::read_to_string(other.join("foreign.urdf.xacro")).unwrap(),
        fixable(1)
    );
    fs::remove_dir_all(folder).unwrap();
    fs::remove_dir_all(other).unwrap();
}

/// Files may not grow beyond a kilobyte: writing fails as on a full disk.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(400));
    let mut command = Command::new("sh");
    command
        .arg("-c")
        .arg("trap '' XFSZ; ulimit -f 1; exec \"$0\" fix .")
        .arg(LINT);
    let (code, text) = run(command, &folder);
    assert_eq!(code, 2, "{text}");
    assert!(
        text.contains("cannot write r.urdf.xacro: File too large"),
        "{text}"
    );
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(400))])
    );
    fs::remove_dir_all(folder).unwrap();
}

/// The same on a file system without room, where the test may make one.
#[test]
fn a_small_file_system_leaves_the_old_file() {
    let folder = folder();
    let small = folder.join("small");
    fs::create_dir(&small).unwrap();
    let mounted = Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=64k", "none"])
        .arg(&small)
        .output();
    if !mounted.is_ok_and(|done| done.status.success()) {
        println!("skipped: a small file system can be made by the superuser only");
        return;
    }
    write(&small, "r.urdf.xacro", &fixable(2000));
    let (code, text) = lint(&small, &["fix", "."]);
    let left = texts(&small);
    Command::new("umount").arg(&small).status().unwrap();
    assert!(
        code == 2 && text.contains("cannot write r.urdf.xacro: No space left on device"),
        "{text}"
    );
    assert_eq!(
        left,
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(2000))])
    );
    fs::remove_dir_all(folder).unwrap();
}

fn many(folder: &Path) {
    for n in 0..40 {
        write(folder, &format!("r{n}.urdf.xacro"), &fixable(200));
    }
}

#[test]
fn two_runs_of_fix_at_once() {
    let folder = folder();
    for round in 0..5 {
        many(&folder);
        let start = || {
            Command::new(LINT)
                .args(["fix", "."])
                .current_dir(&folder)
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let runs = [start(), start(), start()];
        for run in runs {
            let (code, text) = told(run.wait_with_output().unwrap());
            assert_eq!(code, 0, "round {round}: {text}");
        }
        let left = texts(&folder);
        assert_eq!(left.len(), 40, "{:?}", left.keys());
        assert!(
            left.values().all(|text| *text == fixed(200)),
            "round {round}"
        );
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn who_saves_a_file_while_it_is_fixed_finds_it_whole() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(10));
    let path = folder.join("r.urdf.xacro");
    // an editor that writes as editors do: a new file that takes the name
    let saved = std::sync::Mutex::new(String::new());
    let disturb = |turn: usize| {
        let text = fixable(10).replace("l3", &format!("saved{turn}"));
        let new = folder.join("editor~");
        fs::write(&new, &text).unwrap();
        fs::rename(&new, &path).unwrap();
        *saved.lock().unwrap() = format!("saved{turn}");
        std::thread::sleep(Duration::from_millis(20));
    };
    meanwhile(disturb, || {
        for _ in 0..8 {
            let (code, text) = lint(&folder, &["fix", "r.urdf.xacro"]);
            let fine = code == 0 || text.contains("it was changed by another program");
            assert!(fine, "{text}");
        }
    });
    // whole in every case: one of the texts that were saved, fixed or not
    let text = fs::read_to_string(&path)
        .unwrap()
        .replace("<xacro:property", "<property");
    let number = text
        .split("\"saved")
        .nth(1)
        .and_then(|rest| rest.split('"').next())
        .unwrap();
    assert_eq!(text, fixable(10).replace("l3", &format!("saved{number}")));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn ctrl_c_at_any_time_leaves_every_file_whole() {
    let folder = folder();
    let mut interrupted = 0;
    for round in 0..25 {
        many(&folder);
        let mut child = Command::new(LINT)
            .args(["fix", "."])
            .current_dir(&folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(round * 8));
        // a shell that started the tests in the background has told them to ignore the first one
        let signal = if round % 2 == 0 { "-INT" } else { "-TERM" };
        Command::new("kill")
            .args([signal, &child.id().to_string()])
            .stderr(Stdio::null())
            .status()
            .unwrap();
        interrupted += usize::from(child.wait().unwrap().code().is_none());
        for (name, text) in texts(&folder) {
            // a new file that did not get its name yet is no description and may be cut
            let is_new = name.starts_with('.') && name.ends_with(".tmp");
            assert!(
                is_new || text == fixable(200) || text == fixed(200),
                "round {round}: {name} is cut"
            );
        }
    }
    assert!(interrupted > 0, "no run was interrupted");
    // what was left over disturbs nobody
    let (code, text) = lint(&folder, &["fix", "."]);
    assert_eq!(code, 0, "{text}");
    fs::remove_dir_all(folder).unwrap();
}
