//! What an editor asks about launch files and configurations.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use xacro_lsp::analysis::{self, AnalysisHost, RootConfig};
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::vfs::Environment;
use xacro_lsp::workspace::config::{ConfigCursorKind, doc, place_at, wanted};

use super::choice_and_text;

/// The launch files of the package; each input is the text of one of them.
const NAMES: [&str; 6] = [
    "a.launch.py",
    "a.launch",
    "a.launch.xml",
    "a.sh",
    "a.launch.yaml",
    "b.launch.py",
];

const ROBOT: &str = "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='side' default='left'/>\
    <xacro:arg name='n' default='1'/><xacro:arg name='sim'/><link name='$(arg side)'/><xacro:if value=\"${'$(arg side)' == 'right'}\">\
    <link name='b$(arg n)'/></xacro:if></robot>";

/// A package with a robot and launch files, made once for each process.
fn package() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let temporary = std::env::temp_dir()
            .canonicalize()
            .expect("there is a folder for temporary files");
        let folder = temporary.join(format!("xacro-lsp-launch-{}", std::process::id()));
        fs::create_dir_all(folder.join("launch")).expect("it can be written to");
        let write = |name: &str, text: &str| {
            fs::write(folder.join(name), text).expect("it can be written to")
        };
        write(
            "package.xml",
            "<package format=\"3\"><name>arm</name></package>",
        );
        write("arm.urdf.xacro", ROBOT);
        for name in NAMES {
            write(&format!("launch/{name}"), "# xacro\n");
        }
        folder
    })
}

/// Every request about a launch file is answered: at any place of any text, with ranges that lie in it.
pub fn launch_requests(data: &[u8]) {
    let (choice, text) = choice_and_text(data);
    let folder = package();
    let path = folder
        .join("launch")
        .join(NAMES[usize::from(choice) % NAMES.len()]);
    let robot = folder.join("arm.urdf.xacro");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let mut host = AnalysisHost::new(env, vec![folder.to_owned()]);
    host.set_text(&path, text.clone());
    let lies_within = |range: TextRange| {
        assert!(
            text.get(range.start as usize..range.end as usize).is_some(),
            "{range:?} of {text:?}"
        );
    };
    for offset in places(&text, choice) {
        let session = host.session();
        if let Some(name) = analysis::launch_name_at(session, &path, offset) {
            lies_within(name.span.range);
            assert_eq!(name.span.range.slice(&text), name.name, "{text:?}");
            analysis::gives_to_another(session, name.span, &name.robots, &name.name);
        }
        if let Some(choices) = analysis::launch_choices_at(session, &path, offset) {
            lies_within(choices.range);
            assert!(
                choices.range.start <= offset && offset <= choices.range.end,
                "{choices:?} of {text:?}"
            );
        }
    }
    for name in ["side", "n", "sim"] {
        let session = host.session();
        analysis::launch_values(session, &robot, name);
        for place in analysis::launch_places(session, std::slice::from_ref(&robot), name) {
            let own = *session.vfs.path(place.file) == *path;
            assert!(
                !own || place.range.slice(&text) == name,
                "{place:?} of {text:?}"
            );
        }
    }
    let roots: Vec<RootConfig> = analysis::launched_roots(host.session(), &robot);
    assert!(roots.len() <= xacro_lsp::base::limits::CALL_RUNS);
    let report = analysis::report_on(&mut host, &[robot, path.clone()], &CancelFlag::default())
        .expect("nobody cancels");
    for finding in &report.findings {
        assert_eq!(
            finding.message.lines().count(),
            1,
            "{finding:?} of {text:?}"
        );
        if *report.path(finding.span.file) == *path {
            lies_within(finding.span.range);
        }
    }
}

/// A place in a configuration is told at any offset of any text.
pub fn config_places(text: &str) {
    for offset in places(text, 0) {
        let Some(place) = place_at(text, offset) else {
            continue;
        };
        let range = place.range;
        assert!(
            text.get(range.start as usize..range.end as usize).is_some(),
            "{range:?} of {text:?}"
        );
        assert!(
            range.start <= offset && offset <= range.end,
            "{place:?} of {text:?}"
        );
        let mut path = place.path.clone();
        if !matches!(place.kind, ConfigCursorKind::Value { .. }) {
            path.push(range.slice(text).to_owned());
        }
        wanted(&place);
        doc(&path);
    }
}

/// Some offsets of a text: those behind what begins a word, and others.
fn places(text: &str, choice: u8) -> Vec<u32> {
    const MOST: usize = 12;
    let all: Vec<u32> = text
        .char_indices()
        .map(|(at, _)| at as u32)
        .chain([text.len() as u32])
        .collect();
    let step = (all.len() / MOST).max(1);
    let spread = all
        .iter()
        .skip(usize::from(choice) % step)
        .step_by(step)
        .copied();
    let signs = text
        .match_indices([':', '\'', '{', '='])
        .map(|(at, _)| at as u32);
    spread.chain(signs.take(MOST)).collect()
}
