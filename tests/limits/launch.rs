//! How much of a launch file is followed.

use std::path::Path;

use xacro_lsp::base::limits::*;
use xacro_lsp::workspace::launch;

use super::callers::callers_in;
use super::{folder, write};

/// The calls of robots that a launch file makes, as text.
fn launched(name: &str, text: &str) -> Vec<String> {
    let file = launch::read(Path::new(name), text);
    let shown = |call: launch::LaunchCall| {
        let args = call
            .args
            .iter()
            .map(|arg| format!(" {}={}", arg.name, arg.value.shown()));
        format!("{}{}", call.file.shown(), args.collect::<String>())
    };
    file.iter().flat_map(launch::calls).map(shown).collect()
}

#[test]
fn launch_calls() {
    let text = |count: usize| {
        (0..count)
            .map(|n| format!("xacro r.xacro n:={n}\n"))
            .collect::<String>()
    };
    assert_eq!(launched("a.sh", &text(LAUNCH_CALLS)).len(), LAUNCH_CALLS);
    assert_eq!(
        launched("a.sh", &text(LAUNCH_CALLS + 1)).len(),
        LAUNCH_CALLS
    );
}

#[test]
fn launch_includes() {
    let folder = folder();
    write(
        &folder,
        "0.launch",
        "<launch><arg name='a'/><param name='d' command='xacro r.xacro a:=$(arg a)'/></launch>",
    );
    let levels = LAUNCH_INCLUDES + 1;
    for n in 1..=levels {
        let give = if n == 1 {
            "1".to_owned()
        } else {
            "$(arg a)".to_owned()
        };
        let value = if n == levels { "deep" } else { &give };
        let below = n - 1;
        write(
            &folder,
            &format!("{n}.launch"),
            format!(
                "<launch><arg name='a'/><include file='$(dirname)/{below}.launch'><arg name='a' value='{value}'/></include></launch>"
            ),
        );
    }
    let calls = callers_in(&folder).calls_below(&folder);
    let most = calls.iter().map(|call| call.call.through.len()).max();
    assert!(most.is_some_and(|most| most <= LAUNCH_INCLUDES), "{most:?}");
}

#[test]
fn launch_steps() {
    let text = |lines: usize| {
        format!(
            "{}Command('xacro r.xacro')",
            "x = [1, 2, 3]\n".repeat(lines)
        )
    };
    assert_eq!(launched("a.py", &text(10)), ["r.xacro"]);
    assert_eq!(launched("a.py", &text(LAUNCH_STEPS / 4)), [""; 0]);
}

#[test]
fn launch_depth() {
    let text = |depth: usize| {
        let group = "<group>".repeat(depth);
        format!(
            "<launch>{group}<param command='xacro r.xacro'/>{}</launch>",
            "</group>".repeat(depth)
        )
    };
    assert_eq!(launched("a.launch", &text(LAUNCH_DEPTH)), ["r.xacro"]);
    assert_eq!(launched("a.launch", &text(LAUNCH_DEPTH + 1)), [""; 0]);
}

#[test]
fn launch_call_depth() {
    let text = |depth: usize| {
        let mut text = "def f0():\n    return 'r.xacro'\n".to_owned();
        for n in 1..depth {
            text.push_str(&format!("def f{n}():\n    return f{}()\n", n - 1));
        }
        format!("{text}Command(['xacro ', f{}()])\n", depth - 1)
    };
    assert_eq!(launched("a.py", &text(LAUNCH_CALL_DEPTH)), ["r.xacro"]);
    assert_eq!(launched("a.py", &text(LAUNCH_CALL_DEPTH + 1)), ["?"]);
}

#[test]
fn launch_pieces() {
    let text = |count: usize| {
        let pieces = "LaunchConfiguration('a'), ".repeat(count);
        format!(
            "DeclareLaunchArgument('a', default_value='b')\nCommand(['xacro r.xacro x:=', {pieces}])\n"
        )
    };
    assert_eq!(
        launched("a.py", &text(10)),
        [format!("r.xacro x={}", "b".repeat(10))]
    );
    assert_eq!(launched("a.py", &text(LAUNCH_PIECES)), [""; 0]);
}

#[test]
fn launch_text() {
    let text = |len: usize| {
        format!(
            "a = '{}'\nCommand(['xacro r.xacro x:=', a])\n",
            "b".repeat(len)
        )
    };
    assert_eq!(
        launched("a.py", &text(10)),
        [format!("r.xacro x={}", "b".repeat(10))]
    );
    assert_eq!(launched("a.py", &text(LAUNCH_TEXT)), [""; 0]);
    // what doubles with each line
    let doubles = format!(
        "a = 'xx'\n{}Command(['xacro r.xacro x:=', a])\n",
        "a = a + a\n".repeat(100)
    );
    assert_eq!(launched("a.py", &doubles), ["r.xacro x=?"]);
}
