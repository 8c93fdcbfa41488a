//! Files that nobody uses: copies and old versions, and what xacro generated.

use std::path::{Path, PathBuf};

use super::drift::banner;
use super::job::Outcome;
use super::roots::{Job, Reason};
use super::session::Session;
use super::walk;
use base::FastSet;
use rules::{Category, Finding, Group, Severity};
use vfs::SourceFile;
use workspace::Era;

/// Words in the name of a file or folder that say that it is kept and not used.
const KEPT: [&str; 13] = [
    "archive",
    "archived",
    "attic",
    "backup",
    "backups",
    "bak",
    "deprecated",
    "legacy",
    "obsolete",
    "old",
    "orig",
    "original",
    "unused",
];

/// Rules about collisions that a robot which is only shown does not need.
const ABOUT_CONTACTS: [&str; 2] = ["collision-mesh-too-detailed", "mesh-inconsistent-normals"];

/// Rules about what only urdfdom rejects, and Bullet accepts.
/// Source: `UrdfParser.cpp` of Bullet 3.25, and loading with PyBullet.
const TAKEN_BY_BULLET: [&str; 9] = [
    "duplicate-material",
    "invalid-number",
    "missing-attribute",
    "missing-limit-attribute",
    "missing-robot-name",
    "unknown-geometry-type",
    "unknown-joint-type",
    "wrong-vector-length",
    // the base of a robot that does not move
    "zero-mass",
];

impl Session {
    /// What is wrong in a file that was set aside is an info. Not when somebody asks for this very file.
    pub(super) fn settle_set_aside(&self, job: &Job, findings: &mut [Finding]) {
        let is_news = |finding: &Finding| finding.severity > Severity::Info;
        if job.reason != Reason::Walked || !findings.iter().any(is_news) {
            return;
        }
        if self.is_set_aside(&job.file) {
            lower(findings);
        }
        let about_simulation = |finding: &Finding| {
            finding.rule.category == Category::Inertia || ABOUT_CONTACTS.contains(&finding.rule.name)
        };
        self.lower_where(findings, about_simulation, || {
            self.is_only_shown(&job.file).then_some(Severity::Info)
        });
        // Bullet computes inertia from the shapes unless it is told otherwise
        let about_bullet = |finding: &Finding| {
            // what has a fix is text before the declaration
            let is_before = finding.rule.name == "xml-syntax-error" && finding.fix.is_some();
            let is_taken = is_before || TAKEN_BY_BULLET.contains(&finding.rule.name);
            is_taken || finding.rule.category == Category::Inertia
        };
        self.lower_where(findings, about_bullet, || self.is_for_bullet(&job.file).then_some(Severity::Info));
        let about_prefixes = |finding: &Finding| {
            ["unprefixed-xacro-tag", "unprefixed-macro-call"].contains(&finding.rule.name)
        };
        if let Some(most) =
            self.lower_where(findings, about_prefixes, || self.severity_of_bare_tags(&job.file))
        {
            // all of them are for another xacro
            let of_old_xacro = |finding: &&mut Finding| finding.severity == most && about_prefixes(finding);
            findings.iter_mut().filter(of_old_xacro).for_each(|finding| {
                finding.group = Some(Group::Value("for an old xacro".into()));
            });
        }
        let is_placeholder = |finding: &Finding| match finding.rule.name {
            "invalid-number" => self.is_filled_in(&job.file, finding),
            "expression-error" => self.is_replaced(&job.file, finding),
            _ => false,
        };
        self.lower_where(findings, is_placeholder, || Some(Severity::Info));
    }

    /// Whether the text that is wrong is a word that a program puts something else for: it names the file and the word.
    fn is_filled_in(&self, file: &Path, finding: &Finding) -> bool {
        let source = self.vfs.document(&self.vfs.path(finding.span.file));
        let word = source.map(|source| source.document.slice(finding.span.range)).unwrap_or_default();
        let is_word =
            word.chars().all(|c| c.is_alphanumeric() || c == '_') && word.contains(char::is_alphabetic);
        is_word && self.is_named_with(file, &word)
    }

    /// Whether a program that names the file has the text that is wrong, such as `$(controllers)`, word for word: it puts something
    /// else for it.
    fn is_replaced(&self, file: &Path, finding: &Finding) -> bool {
        let source = self.vfs.document(&self.vfs.path(finding.span.file));
        let Ok(text) = source.map(|source| source.document.slice(finding.span.range)) else { return false };
        text.starts_with("$(") && self.is_quoted(file, &text)
    }

    /// Give findings of a kind at most the severity that is asked for when there are any, and return it.
    fn lower_where(
        &self,
        findings: &mut [Finding],
        is_of_kind: impl Fn(&Finding) -> bool,
        most: impl FnOnce() -> Option<Severity>,
    ) -> Option<Severity> {
        let mut found = findings.iter_mut().filter(|finding| is_of_kind(finding)).peekable();
        let most = found.peek().is_some().then(most).flatten()?;
        found.for_each(|finding| finding.severity = finding.severity.min(most));
        Some(most)
    }

    /// How bad tags without their prefix are where the xacro that a file is for takes them.
    fn severity_of_bare_tags(&self, file: &Path) -> Option<Severity> {
        match self.era(file) {
            _ if self.is_of_rosbuild(file) => Some(Severity::Info),
            Era::Old => Some(Severity::Info),
            Era::Melodic => Some(Severity::Warning),
            Era::Any => None,
        }
    }

    /// Whether a file belongs to a package of rosbuild, whose xacro took tags without a prefix.
    fn is_of_rosbuild(&self, file: &Path) -> bool {
        let top = self.packages.sources_around(file);
        let inside = |folder: &&Path| top.as_ref().is_none_or(|top| folder.starts_with(top));
        let has_manifest = |folder: &Path| self.vfs.is_file(&folder.join("manifest.xml"));
        self.packages.containing(file).is_none()
            && file.ancestors().skip(1).take_while(inside).any(has_manifest)
    }

    /// Whether nobody includes a file, and nobody names it either though its path says that it is old or a copy, or the
    /// launch files of its package load others. A template is filled by a script that names it.
    fn is_set_aside(&self, file: &Path) -> bool {
        let kept = || self.words_of(file).iter().any(|word| KEPT.contains(&word.as_str()));
        let is_empty = || self.vfs.text(file).is_ok_and(|file| file.text.trim().is_empty());
        let is_other = || kept() || self.is_left_over(file) || self.is_passed_over(file) || is_empty();
        let is_unused = |file: &Path| !self.is_named(file) && is_other();
        let is_unused_template = |file: &Path| is_template(file) && !self.is_launched(file);
        (is_unused(file) || is_unused_template(file)) && !self.is_included(file)
    }

    /// Whether launch files load other descriptions of the package, and nothing can mean this one.
    fn is_left_over(&self, file: &Path) -> bool {
        let launched = self.launched_instead(file);
        let Some(package) = self.packages.containing(file).filter(|_| !launched.is_empty()) else {
            return false;
        };
        let is_launched = |other: &PathBuf| {
            let name = other.file_name().and_then(|name| name.to_str());
            other != file && name.is_some_and(|name| launched.contains(name))
        };
        walk::all_descriptions(&package.folder, &self.env).iter().any(is_launched)
    }

    /// The words in the path of a file, from the top of the workspace. What file managers call copies are old.
    fn words_of(&self, file: &Path) -> Vec<String> {
        let top = self.packages.sources_around(file);
        let inside =
            top.and_then(|top| file.strip_prefix(top).ok().map(Path::to_path_buf)).unwrap_or_default();
        words(&inside.to_string_lossy().replace("(copy", "(old"))
    }
}

/// Whether the name of a file says that it is to be filled in.
fn is_template(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    words(&name).iter().any(|word| ["template", "tmpl"].contains(&word.as_str()))
}

fn words(text: &str) -> Vec<String> {
    let text = text.to_lowercase();
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

fn lower(findings: &mut [Finding]) {
    findings.iter_mut().for_each(|finding| finding.severity = finding.severity.min(Severity::Info));
}

/// What is wrong in a file that xacro generated, and in its source as well, is said of the source. The rest is an info
/// where nothing loads the file: it has to be generated anew.
pub(super) fn leave_out_copies(session: &Session, outcomes: &mut [Outcome]) {
    let generated: Vec<(usize, String)> = (0..)
        .zip(&*outcomes)
        .filter_map(|(number, outcome)| Some((number, generated_from(outcome.files.first()?)?)))
        .collect();
    for (number, source) in generated {
        let Some(file) = outcomes.get(number).map(|outcome| outcome.job.file.clone()) else { continue };
        let is_source = |outcome: &&Outcome| {
            outcome.job.file.file_name().is_some_and(|name| name == source.as_str())
                && outcome.job.file != file
        };
        let shared = |outcome: &&Outcome| {
            let (a, b) = (outcome.job.file.components(), file.components());
            a.zip(b).take_while(|(a, b)| a == b).count()
        };
        let Some(source) = outcomes.iter().filter(is_source).max_by_key(shared) else { continue };
        let said = |finding: &Finding| {
            let ways = finding.ways.iter().map(|way| way.message.clone());
            let code = finding.rule.code;
            ways.chain([finding.message.clone()]).map(|message| (code, message)).collect::<Vec<_>>()
        };
        let said: FastSet<(&str, String)> = source.findings.iter().flat_map(said).collect();
        if let Some(outcome) = outcomes.get_mut(number) {
            outcome.findings.retain(|finding| !said.contains(&(finding.rule.code, finding.message.clone())));
            let is_walked = outcome.job.reason == Reason::Walked;
            if is_walked && !session.is_loaded(&file) && !session.is_included(&file) {
                lower(&mut outcome.findings);
            }
        }
    }
}

/// The name of the file that xacro generated a file from.
fn generated_from(file: &SourceFile) -> Option<String> {
    let (source, _) = banner(file)?;
    Some(source.rsplit('/').next()?.to_owned())
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Session, Setup};
    use rules::Severity;
    use vfs::testing::Tree;

    /// The places of a rule in a workspace of these files.
    fn found(files: &[(&str, &str)], rule: &str) -> Vec<(String, Severity)> {
        let tree = Tree::new();
        for (name, text) in files {
            tree.write(name, text);
        }
        let setup = Setup { folders: vec![tree.root().to_owned()], ..Setup::default() };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let options = CheckOptions { paths: vec![tree.root().to_owned()], ..CheckOptions::default() };
        let report = session.check(&options);
        let of_rule = report.findings.iter().filter(|finding| finding.rule.name == rule);
        let place = |finding: &rules::Finding| {
            let path = session.vfs.path(finding.span.file);
            (path.strip_prefix(tree.root()).unwrap().display().to_string(), finding.severity)
        };
        of_rule.map(place).collect()
    }

    const BROKEN: &str = "<robot name='r'><link name='base'><visual/></link></robot>";

    #[test]
    fn old_files_that_nobody_uses() {
        let severity = |files: &[(&str, &str)]| found(files, "missing-element").first().map(|found| found.1);
        for (name, expected) in [
            ("urdf/arm.urdf", Severity::Error),
            ("urdf/golden.urdf", Severity::Error),
            ("urdf/deprecated/arm.urdf", Severity::Info),
            ("urdf/arm (copy).urdf", Severity::Info),
            ("old/arm.urdf", Severity::Info),
        ] {
            assert_eq!(severity(&[(name, BROKEN)]), Some(expected), "{name}");
        }
        let named = [("old/arm.urdf", BROKEN), ("old/see.launch", "<param textfile='old/arm.urdf'/>")];
        assert_eq!(severity(&named), Some(Severity::Error));
    }

    #[test]
    fn packages_of_rosbuild() {
        let robot =
            "<robot name='r' xmlns:xacro='x'><property name='a' value='1'/><link name='base'/></robot>";
        let severity = |manifest: &str| {
            found(&[(manifest, "<package/>"), ("urdf/r.urdf.xacro", robot)], "unprefixed-xacro-tag")[0].1
        };
        assert_eq!(severity("manifest.xml"), Severity::Info);
        assert_eq!(severity("other.xml"), Severity::Error);
        // launch files that run xacro as it was then
        let launched = |command: &str| {
            let launch = format!("<param command=\"{command} '$(find r)/urdf/r.urdf.xacro'\"/>");
            let files = [
                ("package.xml", "<package><name>r</name></package>"),
                ("r.launch", launch.as_str()),
                ("urdf/r.urdf.xacro", robot),
            ];
            found(&files, "unprefixed-xacro-tag")[0].1
        };
        assert_eq!(launched("$(find xacro)/xacro.py"), Severity::Info);
        assert_eq!(launched("$(find xacro)/xacro --inorder"), Severity::Warning);
        assert_eq!(launched("$(find xacro)/xacro"), Severity::Error);
    }

    #[test]
    fn references_that_fit_another_robot() {
        let part = "<robot><gazebo reference='lamp'><sensor name='eye' type='camera'/></gazebo></robot>";
        let robot = |links: &str| {
            format!(
                "<robot name='r' xmlns:xacro='x'><link name='base'/>{links}<xacro:include filename='part.xacro'/></robot>"
            )
        };
        let lamp = "<link name='lamp'/><joint name='j' type='fixed'><parent link='base'/><child link='lamp'/></joint>";
        let severity = |robots: &[(&str, &str)]| {
            found(&[robots, &[("part.xacro", part)]].concat(), "gazebo-unknown-reference")
                .first()
                .map(|found| found.1)
        };
        let (with, without) = (robot(lamp), robot(""));
        let untaken = robot(&format!("<xacro:if value='0'>{lamp}</xacro:if>"));
        assert_eq!(severity(&[("a.urdf.xacro", &without)]), Some(Severity::Warning));
        assert_eq!(severity(&[("a.urdf.xacro", &without), ("b.urdf.xacro", &with)]), Some(Severity::Info));
        assert_eq!(severity(&[("a.urdf.xacro", &untaken)]), Some(Severity::Info));
    }

    #[test]
    fn centers_of_small_parts() {
        let link = |name: &str, mass: f64, x: f64| {
            format!(
                "<link name='{name}'><inertial><origin xyz='{x} 0 0'/><mass value='{mass}'/>\
                 <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1.5'/></inertial>\
                 <collision><geometry><box size='0.2 0.2 0.2'/></geometry></collision></link>"
            )
        };
        let severity = |mass: f64, joint: &str| {
            let robot = format!(
                "<robot name='r'>{}{}<joint name='j' type='{joint}'><parent link='base'/><child link='lamp'/></joint></robot>",
                link("base", 20.0, 0.0),
                link("lamp", mass, 0.6)
            );
            found(&[("r.urdf", &robot)], "com-outside-geometry").first().map(|found| found.1)
        };
        assert_eq!(severity(0.5, "fixed"), Some(Severity::Info));
        assert_eq!(severity(5.0, "fixed"), Some(Severity::Warning));
        assert_eq!(severity(0.5, "continuous"), Some(Severity::Warning));
    }

    #[test]
    fn files_that_are_left_over() {
        let severity = |files: &[(&str, &str)]| {
            let manifest = ("package.xml", "<package><name>arm</name></package>");
            let all = [&[manifest, ("urdf/arm.urdf", BROKEN), ("urdf/new.urdf", BROKEN)], files].concat();
            found(&all, "missing-element").into_iter().find(|(name, _)| name == "urdf/arm.urdf").unwrap().1
        };
        let loads = |name: &str| format!("<launch><param textfile='$(find arm)/urdf/{name}'/></launch>");
        let new = loads("new.urdf");
        for (files, expected) in [
            (vec![], Severity::Error),
            (vec![("launch/show.launch", new.as_str())], Severity::Info),
            // the launch file loads nothing of this package
            (vec![("launch/show.launch", loads("other.urdf").as_str())], Severity::Error),
            (vec![("launch/show.launch", new.as_str()), ("README.md", "try arm.urdf")], Severity::Error),
            (
                vec![
                    ("launch/show.launch", new.as_str()),
                    (
                        "urdf/cell.xacro",
                        "<robot xmlns:xacro='x'><xacro:include filename='arm.urdf'/></robot>",
                    ),
                ],
                Severity::Error,
            ),
            // whoever calls the launch file names the robot
            (
                vec![(
                    "launch/show.launch",
                    "<param command='xacro $(arg model)'/><arg name='model' default='new.urdf'/>",
                )],
                Severity::Error,
            ),
            (
                vec![(
                    "launch/show.launch.py",
                    "Command(['xacro ', LaunchConfiguration('model')]), 'new.urdf'",
                )],
                Severity::Error,
            ),
        ] {
            assert_eq!(severity(&files), expected, "{files:?}");
        }
    }

    #[test]
    fn robots_that_are_only_shown() {
        let robot = "<robot name='r'><link name='base'><inertial><mass value='1'/>\
                     <inertia ixx='1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link></robot>";
        let severity = |shows: &str, simulates: &str| {
            let files = [
                ("package.xml", "<package><name>arm</name></package>"),
                ("urdf/view.urdf", robot),
                ("urdf/arm.urdf", "<robot name='arm'><link name='base'/></robot>"),
                ("launch/view.launch", shows),
                ("launch/sim.launch", simulates),
            ];
            found(&files, "inertia-triangle-inequality")[0].1
        };
        let shows = "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>";
        let simulates =
            "<param textfile='$(find arm)/urdf/arm.urdf'/><include file='$(find gazebo_ros)/x.launch'/>";
        assert_eq!(severity(shows, simulates), Severity::Info);
        assert_eq!(severity(shows, ""), Severity::Error);
        assert_eq!(severity(shows, &simulates.replace("arm.urdf", "view.urdf")), Severity::Error);
        assert_eq!(severity(&shows.replace("rviz", "gazebo_ros"), simulates), Severity::Error);
    }

    #[test]
    fn descriptions_of_bullet_beside_its_programs() {
        let robot = "<robot name=''><link name='base'/></robot>";
        let severity = |files: &[(&str, &str)]| {
            found(&[&[("data/box.urdf", robot)], files].concat(), "missing-robot-name")[0].1
        };
        let program = ("examples/fall.py", "p.loadURDF('plane.urdf')");
        assert_eq!(severity(&[program]), Severity::Info);
        assert_eq!(severity(&[("examples/fall.py", "read('plane.urdf')")]), Severity::Error);
        // a package of ROS
        assert_eq!(
            severity(&[program, ("package.xml", "<package><name>r</name></package>")]),
            Severity::Error
        );
        let launch = ("launch/box.launch", "<param textfile='data/box.urdf'/>");
        assert_eq!(severity(&[program, launch]), Severity::Error);
    }

    #[test]
    fn contacts_of_robots_that_are_only_shown() {
        // a tetrahedron with a face turned inside out
        let facets = ["0 1 2", "0 1 3", "1 2 3", "2 0 3"].map(|corners| {
            let points = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];
            let vertex = |n: &str| format!("vertex {}\n", points[n.parse::<usize>().unwrap()]);
            let vertices: String = corners.split(' ').map(vertex).collect();
            format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
        });
        let mesh = format!("solid part\n{}endsolid\n", facets.concat());
        let robot = "<robot name='r'><link name='base'><collision><geometry><mesh filename='part.stl'/></geometry>\
                     </collision></link></robot>";
        let severity = |simulated: &str| {
            let launch = format!(
                "<param textfile='$(find arm)/urdf/{simulated}'/><include file='$(find gazebo_ros)/x.launch'/>"
            );
            let files = [
                ("package.xml", "<package><name>arm</name></package>"),
                ("urdf/view.urdf", robot),
                ("urdf/part.stl", mesh.as_str()),
                ("urdf/arm.urdf", "<robot name='arm'><link name='base'/></robot>"),
                ("launch/view.launch", "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>"),
                ("launch/sim.launch", launch.as_str()),
            ];
            found(&files, "mesh-inconsistent-normals")[0].1
        };
        assert_eq!(severity("arm.urdf"), Severity::Info);
        assert_eq!(severity("view.urdf"), Severity::Warning);
    }

    #[test]
    fn substitutions_that_a_program_replaces() {
        let robot = "<robot name='r' xmlns:xacro='x'><link name='base'/><gazebo><plugin name='p' filename='p.so'>\
                     <parameters>$(controllers)</parameters></plugin></gazebo></robot>";
        let severity = |program: &str| {
            found(&[("urdf/r.urdf", robot), ("urdf/fill.py", program)], "expression-error")[0].1
        };
        assert_eq!(severity("open('r.urdf').read().replace('$(controllers)', path)"), Severity::Info);
        // an argument of that name was meant
        assert_eq!(severity("xacro r.urdf controllers:=x"), Severity::Error);
        assert_eq!(severity("open('other.urdf').read().replace('$(controllers)', path)"), Severity::Error);
    }

    #[test]
    fn words_that_a_program_replaces() {
        let robot = "<robot name='r'><link name='base'><visual><geometry><box size='1 1 1'/></geometry>\
                     <material name='m'><color rgba='COLOR_RGBA'/></material></visual></link></robot>";
        let severity = |program: &str| {
            found(&[("urdf/r.urdf", robot), ("urdf/fill.py", program)], "invalid-number")[0].1
        };
        assert_eq!(severity("open('r.urdf').read().replace('COLOR_RGBA', rgba)"), Severity::Info);
        assert_eq!(severity("open('r.urdf').read().replace('RGBA', rgba)"), Severity::Error);
    }

    #[test]
    fn what_bullet_takes() {
        let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='spherical'>\
                     <parent link='base'/><child link='arm'/></joint></robot>";
        let severity = |name: &str, text: &str| {
            found(&[("urdf/r.urdf", robot), (name, text)], "unknown-joint-type")[0].1
        };
        assert_eq!(severity("run.py", "p.loadURDF('urdf/r.urdf')"), Severity::Info);
        assert_eq!(severity("run.py", "p.load('urdf/r.urdf')"), Severity::Error);
        assert_eq!(severity("r.launch", "p.loadURDF('urdf/r.urdf')"), Severity::Error);
    }

    #[test]
    fn equal_names_in_other_folders() {
        let severity = |launch: &str| {
            let files = [
                ("package.xml", "<package><name>arm</name></package>"),
                ("urdf/old/arm.urdf", BROKEN),
                ("urdf/arm.urdf", BROKEN),
                ("launch/show.launch.py", launch),
            ];
            found(&files, "missing-element")
                .into_iter()
                .find(|(name, _)| name == "urdf/old/arm.urdf")
                .unwrap()
                .1
        };
        assert_eq!(severity("join(share, 'urdf', 'arm.urdf')"), Severity::Info);
        assert_eq!(severity("join(share, 'urdf', 'old', 'arm.urdf')"), Severity::Error);
        assert_eq!(severity("join(folder, 'arm.urdf')"), Severity::Error);
    }

    #[test]
    fn copies_outside_of_packages() {
        let severity = |files: &[(&str, &str)]| {
            let robot = [
                ("arm/package.xml", "<package><name>arm</name></package>"),
                ("arm/urdf/arm.urdf", BROKEN),
                ("gym/assets/dog/dog.urdf", BROKEN),
            ];
            let found = found(&[&robot, files].concat(), "missing-element");
            found.into_iter().find(|(name, _)| name == "gym/assets/dog/dog.urdf").unwrap().1
        };
        let launch = ("arm/launch/show.launch", "<param textfile='$(find arm)/urdf/arm.urdf'/>");
        assert_eq!(severity(&[]), Severity::Error);
        assert_eq!(severity(&[launch]), Severity::Info);
        // without launch files, programs load robots; not so tests, and what takes all files of a folder
        let program = |name: &'static str, text: &'static str| severity(&[(name, text)]);
        assert_eq!(program("run.py", "load('arm/urdf/arm.urdf')"), Severity::Info);
        assert_eq!(program("tests/run.py", "load('arm/urdf/arm.urdf')"), Severity::Error);
        assert_eq!(program("run.py", "load('arm/urdf/arm.urdf'), glob('*.urdf')"), Severity::Error);
        // what the launch file loads is elsewhere
        let foreign = ("arm/launch/show.launch", "<param textfile='$(find leg)/urdf/leg.urdf'/>");
        assert_eq!(severity(&[foreign]), Severity::Error);
        for script in ["load('assets/dog/dog.urdf')", "load('{root}/dog.urdf')", "load(f'{kind}.urdf')"] {
            assert_eq!(severity(&[launch, ("gym/run.py", script)]), Severity::Error, "{script}");
        }
        assert_eq!(severity(&[launch, ("gym/run.py", "load('assets/cat/dog.urdf')")]), Severity::Error);
        // a package has one of the same name and place
        let other = ("arm/dog/dog.urdf", BROKEN);
        let named = ("arm/launch/dog.launch", "<param textfile='$(find arm)/dog/dog.urdf'/>");
        assert_eq!(severity(&[launch, other, named]), Severity::Info);
        let cat = ("gym/assets/cat/dog.urdf", BROKEN);
        assert_eq!(severity(&[launch, cat, ("gym/run.py", "load('cat/dog.urdf')")]), Severity::Info);
    }

    #[test]
    fn templates_that_a_script_fills() {
        let severity = |files: &[(&str, &str)]| {
            let all = [&[("urdf/arm_template.xacro", BROKEN)], files].concat();
            found(&all, "missing-element").first().unwrap().1
        };
        let script = ("scripts/fill.py", "parse('urdf/arm_template.xacro')");
        assert_eq!(severity(&[script]), Severity::Info);
        assert_eq!(severity(&[script, ("arm.launch", "xacro arm_template.xacro")]), Severity::Error);
    }

    #[test]
    fn generated_files() {
        let with_head = |text: &str| {
            format!(
                "<?xml version='1.0'?>\n<!-- | This document was autogenerated by xacro from ../arm.urdf.xacro | -->\n{text}"
            )
        };
        let generated = with_head(BROKEN);
        // its source is elsewhere: this is the robot
        let places = found(&[("urdf/arm.urdf", &generated)], "missing-element");
        assert_eq!(places, [("urdf/arm.urdf".to_owned(), Severity::Error)]);
        let source = BROKEN.replace("<robot", "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'");
        let both = |generated: &str| {
            found(&[("urdf/arm.urdf", generated), ("arm.urdf.xacro", &source)], "missing-element")
        };
        assert_eq!(both(&generated), [("arm.urdf.xacro".to_owned(), Severity::Error)]);
        // what only the generated file has is said there
        let other = with_head(&BROKEN.replace("base", "hand"));
        assert_eq!(
            both(&other),
            [("arm.urdf.xacro".to_owned(), Severity::Error), ("urdf/arm.urdf".to_owned(), Severity::Info)]
        );
        let loaded = found(
            &[
                ("urdf/arm.urdf", &other),
                ("arm.urdf.xacro", &source),
                ("arm.launch", "<param textfile='urdf/arm.urdf'/>"),
            ],
            "missing-element",
        );
        assert_eq!(loaded.last(), Some(&("urdf/arm.urdf".to_owned(), Severity::Error)));
    }
}
