use std::path::Path;
use std::sync::Arc;

use super::testing::Tree;
use super::{LoadErrorKind, Vfs};
use base::TextRange;

#[test]
fn ids_follow_the_spelling() {
    let vfs = Vfs::with_cwd(1000, "/top".into());
    let id = vfs.file_id(Path::new("a/b.x"));
    assert_eq!(vfs.file_id(Path::new("/top/a/b.x")), id);
    assert_eq!(vfs.file_id(Path::new("./a/./b.x")), id);
    assert_ne!(vfs.file_id(Path::new("a/../a/b.x")), id);
    assert_eq!(&*vfs.path(id), Path::new("/top/a/b.x"));
}

#[test]
fn text_is_read_once_and_again_after_a_change() {
    let tree = Tree::new();
    tree.write("a.yaml", "a: 1");
    let path = tree.path("a.yaml");
    let old = std::time::SystemTime::now() - std::time::Duration::from_secs(60);
    std::fs::File::options()
        .write(true)
        .open(&path)
        .unwrap()
        .set_modified(old)
        .unwrap();
    let first = tree.vfs().text(&path).unwrap();
    assert!(Arc::ptr_eq(&first, &tree.vfs().text(&path).unwrap()));
    tree.write("a.yaml", "a: 2");
    let second = tree.vfs().text(&path).unwrap();
    assert_eq!(second.text, "a: 2");
    assert_ne!(first.hash, second.hash);
    // Same length, within the grain of the clock.
    tree.write("a.yaml", "a: 3");
    assert_eq!(tree.vfs().text(&path).unwrap().text, "a: 3");
}

#[test]
fn buffers_cover_the_disk() {
    let tree = Tree::new();
    tree.write("sub/a.x", "disk");
    let vfs = tree.vfs();
    let path = tree.path("sub/a.x");
    vfs.set_buffer(&path, Some("buffer".to_owned()));
    assert_eq!(vfs.text(&path).unwrap().text, "buffer");
    vfs.set_buffer(&path, Some("edited".to_owned()));
    assert_eq!(vfs.text(&path).unwrap().text, "edited");
    vfs.set_buffer(&path, None);
    assert_eq!(vfs.text(&path).unwrap().text, "disk");

    let unsaved = tree.path("new.x");
    vfs.set_buffer(&unsaved, Some("unsaved".to_owned()));
    assert!(vfs.is_file(&unsaved) && vfs.exists(&unsaved) && !vfs.is_dir(&unsaved));
    assert_eq!(vfs.text(&unsaved).unwrap().text, "unsaved");
}

#[cfg(unix)]
#[test]
fn ways_back_are_left_out_where_the_system_goes_them_too() {
    let tree = Tree::new();
    tree.write("a/b/c.x", "");
    std::os::unix::fs::symlink(tree.path("a/b"), tree.path("link")).unwrap();
    let vfs = tree.vfs();
    for (path, expected) in [
        ("a/b/../d.x", "a/d.x"),
        ("a/b/../../e.x", "e.x"),
        ("a/./b/../b/../b/c.x", "a/b/c.x"),
        ("link/../d.x", "link/../d.x"),
        ("gone/../d.x", "gone/../d.x"),
        ("a/b/c.x/../d.x", "a/b/c.x/../d.x"),
    ] {
        assert_eq!(
            vfs.absolute(&tree.path(path)),
            tree.path(expected),
            "{path}"
        );
    }
}

#[cfg(unix)]
#[test]
fn buffers_are_found_through_links_and_parents() {
    let tree = Tree::new();
    tree.write("src/a.x", "disk");
    std::os::unix::fs::symlink(tree.path("src"), tree.path("installed")).unwrap();
    tree.vfs()
        .set_buffer(&tree.path("src/a.x"), Some("buffer".to_owned()));
    for alias in ["installed/a.x", "src/../src/a.x"] {
        assert_eq!(
            tree.vfs().text(&tree.path(alias)).unwrap().text,
            "buffer",
            "{alias}"
        );
    }
    assert_eq!(
        tree.vfs().identity(&tree.path("installed")),
        tree.vfs().identity(&tree.path("src"))
    );
}

#[test]
fn load_errors() {
    let tree = Tree::new();
    tree.write("folder/file", "x");
    tree.write("large", &"x".repeat((1 << 20) + 1));
    let error = |name: &str| tree.vfs().text(&tree.path(name)).unwrap_err();
    let missing = error("gone.x");
    assert_eq!((missing.kind, missing.errno), (LoadErrorKind::NotFound, 2));
    let text = format!(
        "[Errno 2] No such file or directory: '{}'",
        tree.path("gone.x").display()
    );
    assert_eq!(missing.to_string(), text);
    let folder = error("folder");
    assert_eq!(
        (folder.kind, folder.errno, folder.strerror.as_str()),
        (LoadErrorKind::IsDirectory, 21, "Is a directory")
    );
    assert_eq!(
        error("large").kind,
        LoadErrorKind::TooLarge { limit: 1 << 20 }
    );
    if cfg!(target_os = "linux") {
        let through_file = error("folder/file/x");
        assert_eq!(
            (through_file.errno, through_file.strerror.as_str()),
            (20, "Not a directory")
        );
        let device = tree.vfs().text(Path::new("/dev/zero")).unwrap_err();
        assert_eq!(device.kind, LoadErrorKind::NotRegular);
        let long = "n".repeat(300);
        assert_eq!(error(&long).strerror, "File name too long");
    }
    assert_eq!(
        tree.vfs().text(Path::new("a\0b")).unwrap_err().kind,
        LoadErrorKind::Other
    );
}

#[test]
fn folders_are_listed_sorted() {
    let tree = Tree::new();
    tree.write("b", "");
    tree.write("a/x", "");
    let names: Vec<(String, bool)> = tree
        .vfs()
        .list_dir(tree.root())
        .iter()
        .map(|entry| (entry.name.clone(), entry.is_dir))
        .collect();
    assert_eq!(names, [("a".to_owned(), true), ("b".to_owned(), false)]);
    assert!(tree.vfs().list_dir(&tree.path("none")).is_empty());
}

#[test]
fn documents_are_parsed_once() {
    let tree = Tree::new();
    tree.write("a.xacro", "<robot><link name='a'/></robot>");
    let path = tree.path("a.xacro");
    let first = tree.vfs().document(&path).unwrap();
    assert!(Arc::ptr_eq(&first, &tree.vfs().document(&path).unwrap()));
    assert_eq!(first.document.item_count(), 1);
    tree.write("a.xacro", "<robot><link name='b'/></robot>");
    let second = tree.vfs().document(&path).unwrap();
    assert!(second.document.text().contains("'b'"));
    assert_ne!(first.hash, second.hash);
    assert_eq!(
        tree.vfs()
            .document(&tree.path("gone"))
            .err()
            .map(|error| error.errno),
        Some(2)
    );
}

#[test]
fn opening_a_file_as_it_is_on_disk_shares_its_tree() {
    let tree = Tree::new();
    let saved = "<robot><link name='a'/></robot>";
    tree.write("a.xacro", saved);
    let path = tree.path("a.xacro");
    let opened = |text: &str| {
        tree.vfs().set_buffer(&path, None);
        let on_disk = tree.vfs().document(&path).unwrap();
        tree.vfs().set_buffer(&path, Some(text.to_owned()));
        let shown = tree.vfs().document(&path).unwrap();
        assert_eq!(shown.document.text(), text);
        (on_disk, shown)
    };
    let (on_disk, shown) = opened(saved);
    assert!(Arc::ptr_eq(&on_disk, &shown));
    tree.vfs().edit_buffer(&path, TextRange::new(19, 20), "b");
    let edited = tree.vfs().document(&path).unwrap();
    assert_eq!(edited.document.text(), saved.replace("'a'", "'b'"));
    assert_eq!(on_disk.document.text(), saved);
    let (on_disk, shown) = opened("<robot><link name='unsaved'/></robot>");
    assert!(!Arc::ptr_eq(&on_disk, &shown));
    std::fs::write(&path, b"<robot>\xff</robot>").unwrap();
    let (on_disk, shown) = opened("<robot>\u{fffd}</robot>");
    assert!(on_disk.encoding_error.is_some() && shown.encoding_error.is_none());
}

#[test]
fn yaml_is_loaded_once() {
    let tree = Tree::new();
    tree.write("a.yaml", "a: [1");
    let load = |name: &str| tree.vfs().yaml(&tree.path("a.yaml"), name).unwrap();
    let broken = load("./a.yaml");
    assert!(Arc::ptr_eq(&broken, &load("./a.yaml")));
    assert!(
        broken
            .value
            .as_ref()
            .unwrap_err()
            .message
            .contains("in \"./a.yaml\", line 1")
    );
    assert!(
        load("x/a.yaml")
            .value
            .as_ref()
            .unwrap_err()
            .message
            .contains("in \"x/a.yaml\"")
    );
    tree.write("a.yaml", "a: [1]");
    assert!(load("./a.yaml").value.is_ok());
    std::fs::write(tree.path("a.yaml"), b"a: \xff").unwrap();
    let message = "'utf-8' codec can't decode byte 0xff in position 3: invalid start byte";
    assert_eq!(
        load("./a.yaml").value.as_ref().unwrap_err().message,
        message
    );
}

#[test]
fn edits_of_buffers() {
    let tree = Tree::new();
    let vfs = tree.vfs();
    for name in ["parsed.xacro", "text.yaml"] {
        let path = tree.path(name);
        vfs.edit_buffer(&path, TextRange::new(0, 0), "no buffer, no effect");
        vfs.set_buffer(&path, Some("<a><b/></a>".to_owned()));
        if name == "parsed.xacro" {
            vfs.document(&path).unwrap();
        }
        vfs.edit_buffer(&path, TextRange::new(4, 5), "cé");
        vfs.edit_buffer(&path, TextRange::new(4, 4), "x");
        assert_eq!(vfs.text(&path).unwrap().text, "<a><xcé/></a>");
        vfs.set_buffer(&path, Some("<a><xcè/></a>".to_owned()));
        assert_eq!(
            vfs.document(&path).unwrap().document.text(),
            "<a><xcè/></a>"
        );
        assert_eq!(vfs.text(&path).unwrap().text, "<a><xcè/></a>");
    }
}

#[test]
fn states_of_a_buffer_have_different_hashes() {
    let tree = Tree::new();
    let path = tree.path("a.xacro");
    let mut seen = std::collections::HashSet::new();
    tree.vfs().set_buffer(&path, Some("<a/>".to_owned()));
    for _ in 0..5 {
        assert!(seen.insert(tree.vfs().document(&path).unwrap().hash));
        tree.vfs().edit_buffer(&path, TextRange::new(2, 2), "b");
    }
}

#[test]
fn threads_read_and_edit() {
    let tree = Tree::new();
    tree.write("a.xacro", "<robot/>");
    std::thread::scope(|scope| {
        for thread in 0..4 {
            let (vfs, tree) = (tree.vfs(), &tree);
            scope.spawn(move || {
                for round in 0..200 {
                    assert!(vfs.document(&tree.path("a.xacro")).is_ok());
                    assert!(vfs.text(&tree.path("a.xacro")).is_ok());
                    if round % 3 == thread {
                        vfs.set_buffer(
                            &tree.path("a.xacro"),
                            (round % 2 == 0).then(|| "<b/>".to_owned()),
                        );
                    }
                }
            });
        }
    });
}

#[test]
fn files_are_rewritten_only_as_they_were_read() {
    let tree = Tree::new();
    let vfs = tree.vfs();
    tree.write("a.urdf", "\u{FEFF}<robot/>\r\n");
    let path = tree.path("a.urdf");
    vfs.set_buffer(&path, Some("<other/>".to_owned()));
    vfs.rewrite(&path, "<robot/>\r\n", "<robot name='é'/>\r\n")
        .unwrap();
    assert_eq!(
        std::fs::read_to_string(&path).unwrap(),
        "\u{FEFF}<robot name='é'/>\r\n"
    );
    assert_eq!(vfs.text(&path).unwrap().text, "<other/>");
    let error = |before: &str| vfs.rewrite(&path, before, "").unwrap_err().to_string();
    assert_eq!(error("<robot/>\r\n"), "it was changed by another program");
    std::fs::write(&path, b"<?xml encoding='latin-1'?><r n='\xe9'/>").unwrap();
    assert_eq!(
        error("<?xml encoding='latin-1'?><r n='é'/>"),
        "it is not UTF-8"
    );
    assert!(vfs.rewrite(&tree.path("none"), "", "").is_err());
}
