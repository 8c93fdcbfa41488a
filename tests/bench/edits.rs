//! What one edit costs, for callgrind to count and for the clock.
//!
//!     edits expand|check CALLS EDITS     edit a number in one call of a large robot, so many times
//!     edits type ROBOT PLACE EDITS       type letters behind a text in a file and delete them again, so many keys
//!     edits dependants ROBOTS                 edit a part that so many open robots include
//!
//! The instructions of 2N edits less those of N edits, divided by N, are those of one (`edits.py` does that).
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::print_stdout,
    clippy::disallowed_methods
)] // benches may fail loudly

mod large;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use large::robot;
use xacro_lsp::analysis::{self, AnalysisHost, RootConfig};
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::vfs::Environment;

fn main() {
    let args: Vec<String> = std::env::args()
        .skip(1)
        .filter(|arg| arg != "--bench")
        .collect();
    let number = |place: usize| args.get(place).map_or(100, |text| text.parse().unwrap());
    match args.first().map(String::as_str) {
        None => [(100, 20), (1000, 20)]
            .into_iter()
            .for_each(|(calls, edits)| edit_call("check", calls, edits)),
        Some("dependants") => dependants(number(1)),
        Some("type") => {
            let text = std::fs::read_to_string(&args[1]).unwrap();
            let at = text.find(&args[2]).unwrap() + args[2].len();
            edit("type", text, at, number(3));
        }
        Some(what) => edit_call(what, number(1), number(2)),
    }
}

fn host(folder: &Path) -> AnalysisHost {
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    AnalysisHost::new(env, vec![folder.to_owned()])
}

/// Edit the number in the call in the middle, and expand the robot, or check it.
fn edit_call(what: &str, calls: usize, edits: usize) {
    let call = format!("parent=\"s{}\" radius=\"", calls / 2);
    let text = robot(calls);
    let at = text.find(&call).unwrap() + call.len();
    edit(what, text, at, edits);
}

/// Edit the value that begins at a place, and expand the robot, or check it.
fn edit(what: &str, text: String, at: usize, edits: usize) {
    let (folder, path) = (Path::new("/nowhere"), Path::new("/nowhere/bench.xacro"));
    let (mut host, none) = (host(folder), CancelFlag::default());
    let mut length = text[at..].find('"').unwrap() as u32;
    let (at, lines) = (at as u32, text.lines().count());
    host.set_text(path, text);
    let open = [path.to_owned()];
    let known = analysis::report_on(&mut host, &open, &none)
        .unwrap()
        .findings
        .len();
    let mut seen = Vec::new();
    let start = Instant::now();
    for number in 0..edits {
        let (range, new) = match (what, number as u32 % 6) {
            ("type", key @ 0..3) => (TextRange::empty(at + key), "x".to_owned()),
            ("type", key) => (TextRange::new(at + 5 - key, at + 6 - key), String::new()),
            _ => {
                let new = format!("0.{:04}", 1000 + number % 9000);
                let old = TextRange::new(at, at + length);
                length = new.len() as u32;
                (old, new)
            }
        };
        host.edit(path, range, &new);
        seen.push(match what {
            "expand" => host
                .analyzed(&RootConfig::plain(path), &none)
                .unwrap()
                .expansion
                .problems
                .len(),
            _ => analysis::report_on(&mut host, &open, &none)
                .unwrap()
                .findings
                .len(),
        });
    }
    let each = start.elapsed().as_secs_f64() * 1e3 / edits.max(1) as f64;
    seen.dedup();
    println!(
        "{what}: {lines} lines, {edits} edits, {each:.2} ms each, {known} findings before, {seen:?} after"
    );
}

/// A part that many robots include: what its author waits for, and how long it takes until all are checked.
fn dependants(robots: usize) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("dependants");
    std::fs::create_dir_all(&folder).unwrap();
    let part = folder.join("part.xacro");
    std::fs::write(&part, robot(20).replace("<link name=\"s0\"/>", "")).unwrap();
    let mut open: Vec<PathBuf> = vec![part.clone()];
    for number in 0..robots {
        let path = folder.join(format!("robot_{number}.urdf.xacro"));
        let text = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"s0\"/>\
                    <xacro:include filename=\"part.xacro\"/></robot>";
        std::fs::write(&path, text).unwrap();
        open.push(path);
    }
    let (mut host, none) = (host(&folder), CancelFlag::default());
    host.scan(|| false);
    for path in &open {
        host.set_text(path, std::fs::read_to_string(path).unwrap());
    }
    analysis::report_on(&mut host, &open, &none).unwrap();
    let at = std::fs::read_to_string(&part).unwrap().find("2.5").unwrap() as u32;
    let (mut own, mut all, mut given_up) = (Vec::new(), Vec::new(), Vec::new());
    for number in 0..20 {
        host.edit(
            &part,
            TextRange::new(at, at + 3),
            &format!("{}.{}", number % 9 + 1, number % 10),
        );
        let start = Instant::now();
        analysis::report_on(&mut host, &open[..1], &none).unwrap();
        own.push(start.elapsed());
        let cancel = CancelFlag::default();
        let key = std::thread::spawn({
            let cancel = cancel.clone();
            move || {
                std::thread::sleep(Duration::from_millis(2));
                cancel.cancel();
                Instant::now()
            }
        });
        analysis::report_on(&mut host, &open, &cancel);
        let back = Instant::now();
        given_up.push(back.saturating_duration_since(key.join().unwrap()));
        analysis::report_on(&mut host, &open, &none).unwrap();
        all.push(start.elapsed());
    }
    let median = |times: &mut Vec<Duration>| {
        times.sort_unstable();
        times[times.len() / 2].as_secs_f64() * 1e3
    };
    let (own, all, given_up) = (median(&mut own), median(&mut all), median(&mut given_up));
    println!(
        "{robots} robots: own findings {own:.2} ms, all robots {all:.2} ms, given up after {given_up:.2} ms"
    );
}
