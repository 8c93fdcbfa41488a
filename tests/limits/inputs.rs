//! How large files, standard input and messages may be.

use std::io::Read;

use xacro_lsp::base::limits::*;
use xacro_lsp::server;

use super::{LINK, check, folder, robot, run, sparse, write};

#[test]
fn file_mb() {
    let folder = folder();
    write(&folder, "xacro-lint.toml", "[limits]\nfile-mb = 1\n");
    let large = robot(&" ".repeat(1_100_000));
    write(&folder, "large.xacro", &large);
    write(
        &folder,
        "r.urdf.xacro",
        robot("<xacro:include filename=\"large.xacro\"/>\n<link name=\"a\"/>"),
    );
    let said = run(&folder, &["check", "r.urdf.xacro"], &mut std::io::empty());
    assert!(
        said.contains("`large.xacro` cannot be read: it has more than 1 MB, the limit"),
        "{said}"
    );
    assert!(
        said.contains("r.urdf.xacro:2:") && said.contains("raise `file-mb` under `[limits]`"),
        "{said}"
    );
    let said = run(&folder, &["check", "large.xacro"], &mut std::io::empty());
    assert!(
        said.contains("large.xacro") && said.contains("it has more than 1 MB, the limit"),
        "{said}"
    );
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert!(
        said.contains("File too large") && said.contains("raise `file-mb`"),
        "{said}"
    );
    write(&folder, "xacro-lint.toml", "[limits]\nfile-mb = 2\n");
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert!(said.contains("[exit 0]"), "{said}");
}

#[test]
fn file_mb_most() {
    let said = check(LINK, &[("xacro-lint.toml", "[limits]\nfile-mb = 1001\n")]);
    assert!(
        said.contains("xacro-lint.toml") && said.contains("must be from 1 to 1000"),
        "{said}"
    );
    // a configuration is read before it can say how much is read
    let folder = folder();
    write(&folder, "r.urdf.xacro", robot(LINK));
    sparse(&folder, "xacro-lint.toml", "", 5_000_000_000);
    let said = run(&folder, &["check", "r.urdf.xacro"], &mut std::io::empty());
    assert!(said.contains("[exit"), "{said}");
}

#[test]
fn stdin_bytes() {
    for command in ["check", "format", "expand"] {
        let mut input = std::io::repeat(b' ').take(STDIN_BYTES + 1);
        let said = run(&folder(), &[command, "-"], &mut input);
        assert!(
            said.contains("input is larger than 20 MB; pass the file name instead"),
            "{command}: {said}"
        );
        assert!(said.contains("[exit 2]"), "{command}: {said}");
    }
}

const SMALL: &str = "Content-Length: 30\r\n\r\n{\"jsonrpc\":\"2.0\",\"method\":\"x\"}";

#[test]
fn message_bytes() {
    let said = |length: u64| {
        server::reframe(format!("Content-Length: {length}\r\n\r\n{SMALL}").as_bytes())
    };
    assert_eq!(
        said(MESSAGE_BYTES + 1),
        SMALL.as_bytes(),
        "a header that claims too much is none"
    );
    assert_eq!(
        said(MESSAGE_BYTES),
        b"",
        "the rest of the message is waited for"
    );
}

#[test]
fn header_bytes() {
    let line = "x".repeat(HEADER_BYTES as usize * 3);
    assert_eq!(
        server::reframe(format!("{line}\r\n{SMALL}").as_bytes()),
        SMALL.as_bytes()
    );
}
