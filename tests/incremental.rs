//! What a session says after edits is what a fresh one says of the same text, and a first look never claims what
//! the whole check does not.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::World;
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::rules::Finding;
use xacro_lsp::vfs::Environment;

/// A session over a folder whose descriptions are all open.
struct Session {
    world: World,
    texts: BTreeMap<PathBuf, String>,
}

impl Session {
    fn over(folder: &Path, texts: &BTreeMap<PathBuf, String>) -> Self {
        let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), "/nowhere".to_owned())]);
        let env = Environment { vars, cwd: folder.to_owned() };
        let mut world = World::new(env, vec![folder.to_owned()]);
        while world.scan(|| false).is_some() {}
        for (path, text) in texts {
            world.set_text(path, text.clone());
        }
        Self { world, texts: texts.clone() }
    }

    fn edit(&mut self, path: &Path, start: usize, end: usize, new: &str) {
        self.world.edit(path, TextRange::new(start as u32, end as u32), new);
        self.texts.get_mut(path).unwrap().replace_range(start..end, new);
    }

    fn replace(&mut self, path: &Path, old: &str, new: &str) {
        let start = self.texts[path].find(old).unwrap_or_else(|| panic!("no {old}"));
        self.edit(path, start, start + old.len(), new);
    }

    /// All findings of all open files.
    fn findings(&mut self) -> Vec<String> {
        let paths: Vec<PathBuf> = self.texts.keys().cloned().collect();
        let report = self.world.report(&paths, &CancelFlag::default()).unwrap();
        let mut shown: Vec<String> = report
            .findings
            .iter()
            .map(|finding| format!("{} {}", report.path(finding.span.file).display(), line(finding)))
            .collect();
        shown.sort();
        shown
    }

    fn first_look(&self, path: &Path) -> Option<Vec<String>> {
        Some(self.world.first_look(path, &CancelFlag::default())?.findings.iter().map(line).collect())
    }
}

fn line(finding: &Finding) -> String {
    let span = finding.span.range;
    format!("{}..{} {} {}", span.start, span.end, finding.rule.name, finding.message)
}

fn descriptions(folder: &Path, into: &mut BTreeMap<PathBuf, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            descriptions(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "xacro" || ending == "urdf") {
            into.insert(path.clone(), fs::read_to_string(&path).unwrap());
        }
    }
}

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) % below.max(1) as u64) as usize
    }
}

/// Somewhere in a text, a few bytes long.
fn somewhere(dice: &mut Dice, text: &str) -> (usize, usize) {
    let boundary = |mut at: usize| {
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = boundary(dice.roll(text.len() + 1));
    (start, boundary((start + dice.roll(6)).min(text.len())))
}

#[test]
fn an_edited_session_says_what_a_fresh_one_says() {
    const NEW: [&str; 12] =
        ["", "x", "0", " ", "${", "}", "<link name=\"extra\"/>", "<", "\"", "-->", "<!-- words -->", "\n"];
    for (seed, robot) in
        ["industrial_arm", "two_joint_gripper", "broken_cell", "measuring_cell"].iter().enumerate()
    {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples").join(robot);
        let mut texts = BTreeMap::new();
        descriptions(&folder, &mut texts);
        let paths: Vec<PathBuf> = texts.keys().cloned().collect();
        assert!(!paths.is_empty(), "{robot}");
        let mut session = Session::over(&folder, &texts);
        session.findings();
        let mut dice = Dice(seed as u64 + 1);
        for round in 0..12 {
            // edits that are taken back now and then, so that texts do not rot
            let before = session.texts.clone();
            for _ in 0..1 + dice.roll(4) {
                let path = paths[dice.roll(paths.len())].clone();
                let (start, end) = somewhere(&mut dice, &session.texts[&path]);
                session.edit(&path, start, end, NEW[dice.roll(NEW.len())]);
                session.first_look(&path);
            }
            let fresh = Session::over(&folder, &session.texts).findings();
            assert_eq!(session.findings(), fresh, "{robot}, round {round}");
            if round % 3 == 2 {
                for (path, text) in before {
                    session.world.set_text(&path, text.clone());
                    session.texts.insert(path, text);
                }
            }
        }
    }
}

/// A robot large enough that its check takes a while.
fn large_robot(name: &str) -> (PathBuf, PathBuf, Session) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("incremental").join(name);
    fs::create_dir_all(&folder).unwrap();
    let mut text = "<robot name=\"big\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <!-- how heavy -->
  <xacro:property name=\"base_mass\" value=\"2.5\"/>
  <xacro:macro name=\"seg\" params=\"name parent\">
    <link name=\"${name}\">
      <inertial>
        <mass value=\"${base_mass * 2}\"/>
        <inertia ixx=\"0.02\" ixy=\"0\" ixz=\"0\" iyy=\"0.03\" iyz=\"0\" izz=\"0.025\"/>
      </inertial>
    </link>
    <joint name=\"${name}_joint\" type=\"fixed\"><parent link=\"${parent}\"/><child link=\"${name}\"/></joint>
  </xacro:macro>
  <link name=\"s0\"/>\n"
        .to_owned();
    for n in 1..300 {
        text.push_str(&format!("  <xacro:seg name=\"s{n}\" parent=\"s{}\"/>\n", n - 1));
    }
    text.push_str("  <xacro:seg name=\"last\" parent=\"nobody\"/>\n</robot>\n");
    let path = folder.join("big.urdf.xacro");
    fs::write(&path, &text).unwrap();
    let session = Session::over(&folder, &BTreeMap::from([(path.clone(), text)]));
    (folder, path, session)
}

#[test]
fn a_first_look_shows_a_typing_error_in_a_macro_and_carries_the_rest_along() {
    let (folder, path, mut session) = large_robot("macro");
    let clean = session.findings();
    assert_eq!(clean.len(), 1, "{clean:?}");
    assert!(clean[0].contains("nobody"), "{clean:?}");
    session.replace(&path, "base_mass * 2", "base_mas * 2");
    let look = session.first_look(&path).unwrap();
    assert_eq!(look.len(), 2, "{look:?}");
    assert!(look[0].ends_with("undefined-property property `base_mas` is not defined"), "{look:?}");
    let fresh = Session::over(&folder, &session.texts).findings();
    for line in &look {
        assert!(fresh.iter().any(|whole| whole.contains(line.as_str())), "{line} is not in {fresh:?}");
    }
    session.replace(&path, "base_mas * 2", "base_mass * 2");
    assert_eq!(session.first_look(&path).unwrap().len(), 1);
}

#[test]
fn a_first_look_at_a_call_names_what_is_wrong_with_it() {
    let (_, path, mut session) = large_robot("call");
    session.findings();
    session.replace(&path, "<xacro:seg name=\"s7\" parent=\"s6\"/>", "<xacro:seg name=\"s7\"/>");
    let look = session.first_look(&path).unwrap();
    assert!(look.iter().any(|line| line.contains("missing-macro-param")), "{look:?}");
    session.replace(&path, "<xacro:seg name=\"s7\"/>", "<xacro:sag name=\"s7\" parent=\"s6\"/>");
    let look = session.first_look(&path).unwrap();
    assert!(look.iter().any(|line| line.contains("undefined-macro")), "{look:?}");
}

#[test]
fn a_first_look_follows_names_to_where_they_are_defined() {
    let (_, path, mut session) = large_robot("names");
    let defined = r#"<xacro:property name="a" value="1"/>
  <xacro:property name="b" value="${a + 1}"/>
  <xacro:property name="sizes" value="${dict(wide=b)}"/>
  <xacro:property name="at"><origin xyz="${b} 0 0"/></xacro:property>
  <xacro:arg name="more" default="2"/>
  <xacro:macro name="inner" params="name width:=^"><link name="${name}_${width}"/></xacro:macro>
  <xacro:property name="width" value="${sizes['wide'] * 2}"/>
  <xacro:macro name="xacro:outer" params="name"><xacro:inner name="${name}"/></xacro:macro>
  <xacro:if value="${b == 2}"><xacro:property name="chosen" value="${b}"/></xacro:if>
"#;
    session.replace(&path, "  <xacro:seg name=\"last\"", &format!("{defined}  <xacro:seg name=\"last\""));
    let before = session.findings();
    let mut last = "nobody".to_owned();
    for wanted in [
        "s${sizes['wide']}",
        "s${chosen + int('$(arg more)')}",
        "s5\"/><xacro:outer name=\"x\"/><link name=\"${width",
        "s5\"/><link name=\"y\"><xacro:insert_block name=\"at\"/></link><xacro:call macro=\"outer\" name=\"z",
    ] {
        session.replace(&path, &format!("parent=\"{last}\""), &format!("parent=\"{wanted}\""));
        last = wanted.to_owned();
        let look = session.first_look(&path).unwrap();
        let undefined: Vec<&String> = look.iter().filter(|line| line.contains("undefined-")).collect();
        let known = |line: &&&String| before.iter().any(|known| known.contains(line.as_str()));
        assert_eq!(undefined.iter().filter(|line| !known(line)).count(), 0, "{wanted}: {look:?}");
    }
    session.findings();
    session.replace(&path, "value=\"${b == 2}\"", "value=\"${bb == 2}\"");
    let look = session.first_look(&path).unwrap();
    assert!(look.iter().any(|line| line.contains("property `bb` is not defined")), "{look:?}");
}

#[test]
fn words_in_a_comment_need_no_check() {
    let (_, path, mut session) = large_robot("comment");
    session.findings();
    session.replace(&path, "how heavy", "how heavy it is");
    let look = session.world.first_look(&path, &CancelFlag::default()).unwrap();
    assert!(look.is_complete);
    assert_eq!(look.findings.len(), 1);
    let said = look.findings[0].span.range.slice(&session.texts[&path]);
    // the call passes a link that does not exist
    assert_eq!(said, "nobody");
    // a word that the linter looks for makes it a change
    session.replace(&path, "how heavy it is", "xacro-lint: disable-file undefined-link: later");
    assert!(!session.world.first_look(&path, &CancelFlag::default()).unwrap().is_complete);
}
