//! Expansions after edits, against expansions from scratch: `expand_again` compares the two itself in builds for tests.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::disallowed_methods,
    clippy::print_stdout
)] // a test may fail loudly
use std::time::Duration;

use super::{Expansion, Request, Sources, expand_again};
use base::{ExpansionLimits, TextRange};
use packages::{PackageOptions, Packages};
use vfs::Environment;
use vfs::testing::Tree;

const ROBOT: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- settings -->
  <xacro:arg name="side" default="left"/>
  <xacro:include filename="part.xacro"/>
  <xacro:property name="mass" value="2.5"/>
  <xacro:property name="double" value="${mass * 2}"/>
  <xacro:property name="yaml" value="${xacro.load_yaml('values.yaml')}"/>
  <xacro:property name="width" value="${yaml['width']}"/>
  <xacro:property name="frame" value="world"/>
  <xacro:property name="pose"><origin xyz="0 0 ${mass}"/></xacro:property>
  <xacro:macro name="seg" params="name parent radius:=0.1 *origin">
    <link name="${name}">
      <xacro:if value="${radius > 0.2}"><visual><geometry><sphere radius="${radius}"/></geometry></visual></xacro:if>
      <inertial><mass value="${double * radius}"/></inertial>
    </link>
    <joint name="${name}_joint" type="fixed">
      <parent link="${parent}"/><child link="${name}"/>
      <xacro:insert_block name="origin"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="pair" params="prefix parent:=^|base mass:=^">
    <!-- two -->
    <xacro:property name="own" value="${mass + 1}"/>
    <xacro:seg name="${prefix}_a" parent="${parent}"><origin xyz="0 0 ${own}"/></xacro:seg>
    <xacro:seg name="${prefix}_b" parent="${prefix}_a" radius="0.3"><xacro:insert_block name="pose"/></xacro:seg>
  </xacro:macro>
  <xacro:macro name="count" params="n"><xacro:property name="counted" value="${n}" scope="parent"/><gazebo/></xacro:macro>
  <link name="base"/>
  <!-- first -->
  <xacro:seg name="s1" parent="base" radius="${mass / 10}"><origin xyz="0 0 1"/></xacro:seg>
  <xacro:seg name="s2" parent="s1"><origin xyz="0 ${double} 1"/></xacro:seg><!-- behind -->
  <xacro:pair prefix="p1"/>
  <xacro:count n="4"/>
  <xacro:wheel name="w1" parent="s2" width="${width}"/><xacro:wheel name="w2" parent="s2" width="0.2"/>
  <xacro:seg name="${side_name}_3" parent="s2"><origin xyz="0 0 3"/></xacro:seg>
  <!-- kept -->

  <xacro:pair prefix="$(arg side)" parent="s2" mass="3"/>
  <xacro:if value="${counted > 3}"><xacro:seg name="s4" parent="s2"><origin/></xacro:seg></xacro:if>
  <xacro:wheel name="w3" parent="${frame}" width="${width * 2}"/>
  <xacro:seg name="s5" parent="w3"><origin xyz="${counted} 0 0"/></xacro:seg>
</robot>
"#;

const PART: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="tread" value="0.5"/>
  <xacro:property name="side_name" value="$(arg side)"/>
  <xacro:macro name="wheel" params="name parent width">
    <link name="${name}"><collision><geometry><cylinder radius="${tread}" length="${width}"/></geometry></collision></link>
    <joint name="${name}_joint" type="continuous"><parent link="${parent}"/><child link="${name}"/><axis xyz="0 1 0"/></joint>
  </xacro:macro>
  <xacro:wheel name="spare" parent="base" width="0.1"/>
</robot>
"#;

const VALUES: &str = "width: 0.25\nnames: [a, b]\n";

const FILES: [(&str, &str); 3] = [
    ("robot.xacro", ROBOT),
    ("part.xacro", PART),
    ("values.yaml", VALUES),
];

/// Items and texts that are put in between lines.
const LINES: [&str; 14] = [
    "  <link name=\"extra\"/>\n",
    "  <!-- words -->\n",
    "  <xacro:property name=\"mass\" value=\"7\"/>\n",
    "  <xacro:property name=\"tread\" value=\"${double}\"/>\n",
    "  <xacro:seg name=\"n\" parent=\"base\"><origin xyz=\"1 1 1\"/></xacro:seg>\n",
    "  <xacro:pair prefix=\"q\" parent=\"n\"/>\n",
    "  <xacro:count n=\"${mass}\"/>\n",
    "  <xacro:property name=\"double\" remove=\"true\"/>\n",
    "  <xacro:macro name=\"wheel\" params=\"name parent width\"><link name=\"${name}\"/><!-- c --> </xacro:macro>\n",
    "  <xacro:arg name=\"side\" default=\"right\"/>\n",
    "  <xacro:include filename=\"part.xacro\" ns=\"other\"/>\n",
    "  <xacro:other.wheel name=\"o\" parent=\"base\" width=\"1\"/>\n",
    "<xacro:seg name=\"m\" parent=\"base\"><origin/></xacro:seg>",
    "  text <![CDATA[x]]>\n",
];

const LETTERS: [&str; 12] = [
    "",
    "x",
    "0",
    " ",
    "${",
    "}",
    "<",
    "\"",
    "-->",
    "$(arg side)",
    "1",
    "\n",
];

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % below.max(1) as u64) as usize
    }
}

/// A robot that is edited.
struct Session {
    tree: Tree,
    env: Environment,
    packages: Packages,
    texts: [String; 3],
    last: Option<Expansion>,
}

impl Session {
    fn new() -> Self {
        let tree = Tree::new();
        let env = tree.environment(&[]);
        let packages = Packages::new(tree.vfs().clone(), &env, PackageOptions::default());
        let texts = FILES.map(|(_, text)| text.to_owned());
        let session = Self {
            tree,
            env,
            packages,
            texts,
            last: None,
        };
        for (name, text) in FILES {
            session.tree.write(name, text);
            session
                .tree
                .vfs()
                .set_buffer(&session.tree.path(name), Some(text.to_owned()));
        }
        session
    }

    fn set(&mut self, file: usize, text: &str) {
        self.texts[file] = text.to_owned();
        self.tree
            .vfs()
            .set_buffer(&self.tree.path(FILES[file].0), Some(text.to_owned()));
    }

    fn replace(&mut self, file: usize, (start, end): (usize, usize), new: &str) {
        self.texts[file].replace_range(start..end, new);
        let range = TextRange::new(start as u32, end as u32);
        self.tree
            .vfs()
            .edit_buffer(&self.tree.path(FILES[file].0), range, new);
    }

    /// Replace the first occurrence of a text in the robot.
    fn change(&mut self, old: &str, new: &str) {
        let start = self.texts[0].find(old).unwrap();
        self.replace(0, (start, start + old.len()), new);
    }

    /// Expand again; how many calls were taken over.
    fn expand(&mut self) -> usize {
        let sources = Sources {
            vfs: self.tree.vfs(),
            packages: &self.packages,
            env: &self.env,
        };
        let file = self.tree.path(FILES[0].0).display().to_string();
        // how far an expansion gets in a time is another thing each time
        let limits = ExpansionLimits {
            expand_time: Duration::from_secs(3600),
            expand_nodes: 20_000,
            ..ExpansionLimits::default()
        };
        let request = Request {
            file,
            limits,
            probe: true,
            keep: true,
            ros_shell: true,
            ..Request::default()
        };
        let made = expand_again(sources, &request, self.last.as_ref());
        let taken_over = made.taken_over();
        self.last = Some(made);
        taken_over
    }

    /// An edit of a letter, a number or a line.
    fn random_edit(&mut self, dice: &mut Dice) {
        let file = [0, 0, 0, 0, 1, 1, 2][dice.roll(7)];
        let text = self.texts[file].clone();
        let lines: Vec<usize> = std::iter::once(0)
            .chain(text.match_indices('\n').map(|(at, _)| at + 1))
            .collect();
        let line = dice.roll(lines.len());
        let (start, end) = (
            lines[line],
            lines.get(line + 1).copied().unwrap_or(text.len()),
        );
        match dice.roll(8) {
            0 => self.replace(file, (start, start), LINES[dice.roll(LINES.len())]),
            1 => self.replace(file, (start, end), ""),
            2 => self.replace(file, (start, start), &text[start..end]),
            3 => {
                let at = dice.roll(text.len() + 1);
                let end = (at + dice.roll(3)).min(text.len());
                self.replace(file, (at, end), LETTERS[dice.roll(LETTERS.len())]);
            }
            _ => {
                let digits: Vec<usize> = text
                    .match_indices(|c: char| c.is_ascii_digit())
                    .map(|(at, _)| at)
                    .collect();
                if !digits.is_empty() {
                    let at = digits[dice.roll(digits.len())];
                    self.replace(file, (at, at + 1), &dice.roll(10).to_string());
                }
            }
        }
    }
}

#[test]
fn calls_are_taken_over_that_an_edit_does_not_reach() {
    let mut session = Session::new();
    assert_eq!(session.expand(), 0);
    let all = session.expand();
    assert!(all >= 6, "{all}");
    session.change("xyz=\"0 0 3\"", "xyz=\"0 0 4\"");
    let beside = session.expand();
    assert!(beside >= 6 && beside < all, "{beside} of {all}");
    session.change("name=\"mass\" value=\"2.5\"", "name=\"mass\" value=\"2.6\"");
    let left = session.expand();
    assert!(
        left < all / 2,
        "{left} of {all}: what reads the mass is evaluated again"
    );
    session.change("<!-- settings -->", "<!-- SETTINGS -->");
    assert_eq!(session.expand(), all);
}

#[test]
fn items_are_left_out_that_an_edit_does_not_reach() {
    let mut session = Session::new();
    let items = ROBOT.matches("\n  <xacro:").count();
    session.expand();
    let mut check = |(old, new): (&str, &str), most: usize| {
        session.change(old, new);
        session.expand();
        let evaluated = items.saturating_sub(session.last.as_ref().unwrap().left_out());
        assert!(
            evaluated <= most,
            "{evaluated} of {items} items evaluated after {new}"
        );
    };
    // a value that nothing behind it reads
    check(("xyz=\"0 0 1\"", "xyz=\"0 0 7\""), 3);
    check(("<!-- first -->", "<!-- other -->"), 3);
    // a property that later items read
    check(("value=\"world\"", "value=\"map\""), items - 6);
    // a mistake, and back
    check(("width=\"0.2\"", "width=\"${0.2\""), 4);
    check(("width=\"${0.2\"", "width=\"0.2\""), 4);
}

#[test]
fn blank_text_of_a_file_without_elements_is_kept() {
    const MACROS: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="a" value="1"/>

  <xacro:macro name="one" params=""><link name="one"/></xacro:macro>
  <xacro:property name="b" value="2"/>
  <link name="only"/>
  <xacro:macro name="two" params=""><link name="two"/></xacro:macro>
</robot>
"#;
    let mut session = Session::new();
    session.set(0, MACROS);
    session.expand();
    for (old, new) in [
        ("value=\"2\"", "value=\"3\""),
        (
            "<link name=\"only\"/>",
            "<xacro:property name=\"c\" value=\"4\"/>",
        ),
        ("value=\"3\"", "value=\"5\""),
        (
            "<xacro:property name=\"c\" value=\"4\"/>",
            "<link name=\"only\"/>",
        ),
    ] {
        session.change(old, new);
        session.expand();
    }
}

#[test]
fn what_is_missing_behind_an_edit_is_missing_still() {
    let mut session = Session::new();
    session.change(
        "name=\"counted\" value=\"${n}\"",
        "name=\"counted\" value=\"${-\"",
    );
    session.expand();
    assert!(
        !session.last.as_ref().unwrap().whole,
        "a condition is unknown"
    );
    // the items behind are left out
    session.change(
        "<origin xyz=\"0 0 1\"/></xacro:seg>",
        "<origin xyz=\"0 0 4\"/></xacro:seg>",
    );
    session.expand();
    assert!(!session.last.as_ref().unwrap().whole);
}

#[test]
fn an_expansion_after_random_edits_is_one_from_scratch() {
    let edits = std::env::var("XACRO_EDITS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(600);
    let seed = std::env::var("XACRO_SEED")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(1);
    let (mut session, mut dice) = (Session::new(), Dice(seed));
    let (mut taken_over, mut left_out) = (0, 0);
    for number in 0..edits {
        if number % 12 == 0 {
            FILES
                .iter()
                .enumerate()
                .for_each(|(file, (_, text))| session.set(file, text));
            session.expand();
        }
        session.random_edit(&mut dice);
        if std::env::var_os("DBG").is_some() {
            println!("EDIT {number}\n{}", session.texts.join("\n=====\n"));
        }
        taken_over += session.expand();
        left_out += session.last.as_ref().unwrap().left_out();
    }
    println!("{taken_over} calls taken over, {left_out} items left out in {edits} edits");
    assert!(taken_over > edits, "{taken_over} calls in {edits} edits");
    assert!(left_out > 2 * edits, "{left_out} items in {edits} edits");
}
