//! Files that nobody uses: copies and old versions, and what xacro generated.
use std::path::{Path, PathBuf};

use super::check_task::{CheckReason, CheckTask};
use super::drift::banner;
use super::outside_packages::settle_outside_packages;
use super::root_result::RootResult;
use super::session::Session;
use base::{FastMap, FastSet, FileId};
use expand::{Expansion, ProblemKind};
use model::{Joint, Robot};
use packages::RosVersion;
use rules::{Category, Edit, Finding, Group, Severity, Trait, named};
use vfs::SourceFile;
use workspace::{Caller, Era};
use xml::NodeKind;

/// Words in the name of a file or folder that say that it is kept and not used.
const KEPT: [&str; 19] = [
    "archive",
    "archived",
    "attic",
    "backup",
    "backups",
    "bak",
    "copy",
    "deprecated",
    "legacy",
    "obsolete",
    "old",
    "orig",
    "original",
    "outdated",
    "past",
    "temp",
    "testing",
    "tmp",
    "unused",
];

/// Folders of tests.
const TESTS: [&str; 4] = ["fixtures", "test", "testdata", "tests"];

/// Words in the name of a file for a test that say that it has to be refused.
const REFUSED: [&str; 9] = [
    "bad",
    "broken",
    "error",
    "fail",
    "failing",
    "fails",
    "invalid",
    "malformed",
    "wrong",
];

/// How many folders above a file a model of Gazebo begins at most.
const MODEL_DEPTH: usize = 3;

impl Session {
    /// What is wrong in a file that was set aside is an info. Not when somebody asks for this very file.
    pub(super) fn settle_set_aside(
        &self,
        task: &CheckTask,
        (expansion, robot): (&Expansion, Option<&Robot>),
        findings: &mut [Finding],
    ) {
        let is_news = |finding: &Finding| finding.severity > Severity::Info;
        if task.reason != CheckReason::Walked || !findings.iter().any(is_news) {
            return;
        }
        if robot.is_some_and(is_list_of_joints)
            || self.is_wrong_on_purpose(&task.file)
            || self.is_for_tests(&task.file)
            || self.packages.is_never_built(&task.file) && !self.is_named_in_use(&task.file)
        {
            lower(findings);
        } else if self.is_set_aside(&task.file) {
            self.lower_unused(&task.file, findings);
        }
        let is_impossible = |finding: &Finding| finding.rule == named::INERTIA_TRIANGLE_INEQUALITY;
        self.lower_where(findings, is_impossible, || {
            self.callers
                .never_refuse(&task.file)
                .then_some(Severity::Warning)
        });
        // the program that wrote one of them wrote all of them
        let is_mild = |finding: &&mut Finding| {
            finding.severity == Severity::Warning && is_impossible(finding)
        };
        for finding in findings.iter_mut().filter(is_mild) {
            finding.group = Some(Group::File);
        }
        // Bullet computes inertia from the shapes unless it is told otherwise
        let about_bullet = |finding: &Finding| {
            let is_taken = is_before_declaration(finding)
                || has_dashes(finding)
                || finding.rule.has(Trait::AcceptedByBullet)
                || finding.rule.has(Trait::Gazebo)
                || finding.rule == named::MESH_NOT_FOUND && self.is_above(&task.file, finding);
            is_taken || finding.rule.category == Category::Inertia
        };
        self.lower_where(findings, about_bullet, || {
            self.callers
                .load_in_bullet(&task.file)
                .then_some(Severity::Info)
        });
        // a file without content that nobody names is not begun yet
        let is_blank = |finding: &Finding| {
            let text = || self.vfs.text(&task.file);
            finding.rule == named::XML_SYNTAX_ERROR
                && text().is_ok_and(|text| text.text.trim().is_empty())
        };
        self.lower_where(findings, is_blank, || {
            (!self.callers.name(&task.file)).then_some(Severity::Info)
        });
        // an element of URDF by itself is a piece of a robot
        let is_piece = |finding: &Finding| {
            finding.rule == named::UNKNOWN_ROOT_ELEMENT
                && ["`link`", "`joint`"]
                    .iter()
                    .any(|name| finding.message.contains(name))
        };
        self.lower_where(findings, is_piece, || {
            (!self.callers.load(&task.file)).then_some(Severity::Info)
        });
        let is_mesh = |finding: &Finding| finding.rule == named::MESH_NOT_FOUND;
        self.lower_where(findings, is_mesh, || {
            self.callers
                .load_in_matlab(&task.file)
                .then_some(Severity::Info)
        });
        let about_raisim = |finding: &Finding| {
            is_before_declaration(finding) || finding.rule.has(Trait::AcceptedByRaiSim)
        };
        self.lower_where(findings, about_raisim, || {
            self.callers
                .load_in_raisim(&task.file)
                .then_some(Severity::Info)
        });
        // urdfdom and the readers that use it skip what is blank
        self.lower_where(findings, is_before_declaration, || {
            self.is_read_without_xacro(&task.file)
                .then_some(Severity::Warning)
        });
        let about_prefixes = |finding: &Finding| {
            finding.rule == named::UNPREFIXED_XACRO_TAG
                || finding.rule == named::UNPREFIXED_MACRO_CALL
                || finding.rule == named::UNKNOWN_GEOMETRY_TYPE
                    && finding.message.starts_with("`insert_block`")
                || finding.rule == named::MISSING_JOINT_LIMIT && self.holds_bare_block(finding)
        };
        if let Some(most) = self.lower_where(findings, about_prefixes, || {
            self.severity_of_bare_tags(&task.file)
        }) {
            // all of them are for another xacro
            let of_old_xacro =
                |finding: &&mut Finding| finding.severity == most && about_prefixes(finding);
            findings
                .iter_mut()
                .filter(of_old_xacro)
                .for_each(|finding| {
                    finding.group = Some(Group::Value("for an old xacro".into()));
                });
        }
        let about_order =
            |finding: &Finding| finding.problem == Some(ProblemKind::UseBeforeDefinition);
        let is_unordered =
            || (self.callers.era(&task.file) == Era::Unordered).then_some(Severity::Info);
        self.lower_where(findings, about_order, is_unordered);
        // a library of which the robots that are launched use a part
        let is_uncalled = |finding: &Finding| finding.probed;
        let is_library = || {
            self.callers
                .launch_any(&task.file)
                .then_some(Severity::Info)
        };
        self.lower_where(findings, is_uncalled, is_library);
        let is_placeholder = |finding: &Finding| match finding.problem {
            Some(ProblemKind::ExpressionError) => self.is_replaced(&task.file, finding),
            _ => finding.rule == named::INVALID_NUMBER && self.is_filled_in(&task.file, finding),
        };
        self.lower_where(findings, is_placeholder, || Some(Severity::Info));
        self.settle_made_elsewhere(task, findings);
        self.settle_by_use(task, findings);
        self.settle_by_purpose(&task.file, (expansion, robot), findings);
        settle_outside_packages(self, &task.file, findings);
    }

    /// Whether a file is plain URDF and nothing that names it runs xacro.
    fn is_read_without_xacro(&self, file: &Path) -> bool {
        let is_plain = file
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("urdf"));
        is_plain && !self.callers.of(file).iter().any(Caller::runs_xacro)
    }

    /// Make infos of what is wrong in a robot that was set aside, but for what is wrong in files that are loaded without it.
    fn lower_unused(&self, file: &Path, findings: &mut [Finding]) {
        let own = self.vfs.file_id(file);
        let mut known: FastMap<FileId, bool> = FastMap::default();
        for finding in findings
            .iter_mut()
            .filter(|finding| finding.severity > Severity::Info)
        {
            let at = finding.span.file;
            let is_used = || self.callers.load(&self.vfs.path(at));
            if at == own || !*known.entry(at).or_insert_with(is_used) {
                finding.severity = Severity::Info;
            }
        }
    }

    /// Whether the element that a finding is about inserts a block by a tag without its prefix.
    fn holds_bare_block(&self, finding: &Finding) -> bool {
        let Ok(source) = self.vfs.document(&self.vfs.path(finding.span.file)) else {
            return false;
        };
        let start = finding.span.range.start;
        source.document.parts().any(|(base, item)| {
            let mut nodes = item.all_nodes();
            let own = nodes.find(|node| {
                node.kind() == NodeKind::Element && node.range().shift(base).start == start
            });
            own.is_some_and(|own| own.children().any(|child| child.name() == "insert_block"))
        })
    }

    /// Whether the text that is wrong is a word that a program puts something else for: it names the file and the word.
    fn is_filled_in(&self, file: &Path, finding: &Finding) -> bool {
        let source = self.vfs.document(&self.vfs.path(finding.span.file));
        let word = source
            .map(|source| source.document.slice(finding.span.range))
            .unwrap_or_default();
        let is_word = word.chars().all(|c| c.is_alphanumeric() || c == '_')
            && word.contains(char::is_alphabetic);
        is_word && self.callers.mention(file, &word)
    }

    /// Whether a program that names the file has the text that is wrong, such as `$(controllers)`, word for word: it puts something
    /// else for it.
    fn is_replaced(&self, file: &Path, finding: &Finding) -> bool {
        let source = self.vfs.document(&self.vfs.path(finding.span.file));
        let Ok(text) = source.map(|source| source.document.slice(finding.span.range)) else {
            return false;
        };
        text.starts_with("$(") && self.callers.quote(file, &text)
    }

    /// Give findings of a kind at most the severity that is asked for when there are any, and return it.
    pub(super) fn lower_where(
        &self,
        findings: &mut [Finding],
        is_of_kind: impl Fn(&Finding) -> bool,
        most: impl FnOnce() -> Option<Severity>,
    ) -> Option<Severity> {
        let mut found = findings
            .iter_mut()
            .filter(|finding| is_of_kind(finding))
            .peekable();
        let most = found.peek().is_some().then(most).flatten()?;
        found.for_each(|finding| finding.severity = finding.severity.min(most));
        Some(most)
    }

    /// How bad tags without their prefix are where the xacro that a file is for takes them.
    fn severity_of_bare_tags(&self, file: &Path) -> Option<Severity> {
        match self.callers.era(file) {
            _ if self.is_of_rosbuild(file) => Some(Severity::Info),
            Era::Unordered | Era::Old => Some(Severity::Info),
            Era::Melodic if self.callers.is_for_old_ros(file) => Some(Severity::Info),
            Era::Melodic => Some(Severity::Warning),
            // to read all pages takes longer than to expand the robot
            Era::Any if self.packages.generation(file) == Some(RosVersion::Ros2) => None,
            Era::Any => self.callers.is_for_old_ros(file).then_some(Severity::Info),
        }
    }

    /// Whether a file belongs to a package of rosbuild, whose xacro took tags without a prefix.
    pub(super) fn is_of_rosbuild(&self, file: &Path) -> bool {
        let top = self.packages.sources_around(file);
        let inside = |folder: &&Path| top.as_ref().is_none_or(|top| folder.starts_with(top));
        let has_manifest = |folder: &Path| self.vfs.is_file(&folder.join("manifest.xml"));
        self.packages.containing(file).is_none()
            && file
                .ancestors()
                .skip(1)
                .take_while(inside)
                .any(has_manifest)
    }

    /// Whether a file is not in use, and only such files include it.
    pub(super) fn is_set_aside(&self, file: &Path) -> bool {
        self.holds_above(file, |file| self.is_unnamed(file))
    }

    /// Whether something holds for a file, and for all that include it.
    pub(super) fn holds_above(&self, file: &Path, holds: impl Fn(&Path) -> bool) -> bool {
        let mut open = vec![file.to_owned()];
        let mut seen: FastSet<PathBuf> = FastSet::default();
        while let Some(file) = open.pop() {
            if seen.contains(&file) {
                continue;
            }
            if !holds(&file) {
                return false;
            }
            open.extend(self.includers(&file));
            seen.insert(file);
        }
        true
    }

    /// Whether nobody names a file though its path says that it is old or a copy, or the launch files of its package load
    /// others. A template is filled by a script that names it.
    fn is_unnamed(&self, file: &Path) -> bool {
        !self.is_named_in_use(file) && self.is_given_up(file)
            || is_template(file) && !self.callers.launch(file)
            || self.callers.only_write(file)
    }

    /// Whether a file is old or a copy, others are loaded in its place, or it has no text.
    fn is_given_up(&self, file: &Path) -> bool {
        self.is_kept(file)
            || self.is_left_over(file)
            || self.callers.pass_over(file)
            || self.is_beside_model(file)
            || self.callers.spawn_models_instead(file)
            || (self.vfs.text(file)).is_ok_and(|file| file.text.trim().is_empty())
    }

    /// Whether the path of a file says that it is kept and not used.
    pub(super) fn is_kept(&self, file: &Path) -> bool {
        let words = self.words_of(file);
        // the second backup has a number
        let is_kept =
            |word: &String| KEPT.contains(&word.trim_end_matches(|c: char| c.is_ascii_digit()));
        words.iter().any(is_kept)
            || words.windows(2).any(|pair| pair == ["not", "used"])
            || is_second_download(file) && !self.callers.spell_out(file)
    }

    /// Whether the folder of a relative mesh lies in one above the file, where Bullet looks as well.
    fn is_above(&self, file: &Path, finding: &Finding) -> bool {
        const MOST_FOLDERS: usize = 4;
        let source = self.vfs.document(&self.vfs.path(finding.span.file));
        let name = source
            .map(|source| source.document.slice(finding.span.range))
            .unwrap_or_default();
        let folder = Path::new(name.trim_start_matches("./"))
            .parent()
            .map(Path::to_owned);
        let Some(folder) =
            folder.filter(|folder| folder.iter().next().is_some() && !name.contains(':'))
        else {
            return false;
        };
        let above = file.ancestors().skip(2).take(MOST_FOLDERS);
        above
            .into_iter()
            .any(|top| self.vfs.is_dir(&top.join(&folder)))
    }

    /// Whether a file is one of a test, which has to be refused.
    fn is_wrong_on_purpose(&self, file: &Path) -> bool {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let is_refused = words(&name)
            .iter()
            .any(|word| REFUSED.contains(&word.as_str()));
        is_refused
            && self
                .words_of(file)
                .iter()
                .any(|word| TESTS.contains(&word.as_str()))
    }

    /// Whether a file lies in a model of Gazebo, whose `model.config` names another one.
    fn is_beside_model(&self, file: &Path) -> bool {
        let config = file
            .ancestors()
            .skip(1)
            .take(MODEL_DEPTH)
            .map(|folder| folder.join("model.config"));
        let Some(config) = config.into_iter().find(|config| self.vfs.is_file(config)) else {
            return false;
        };
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        self.vfs
            .text(&config)
            .is_ok_and(|config| config.text.contains("</sdf>") && !config.text.contains(&*name))
    }

    /// The words in the path of a file, from the top of the workspace. What file managers call copies are old.
    fn words_of(&self, file: &Path) -> Vec<String> {
        let top = self.packages.sources_around(file);
        let inside = top
            .and_then(|top| file.strip_prefix(top).ok())
            .or_else(|| file.file_name().map(Path::new))
            .unwrap_or(Path::new(""));
        let copied = ["(copy", "(copia", "(otra copia", "(copie", "(kopie"];
        let path = inside.to_string_lossy().to_lowercase();
        words(
            &copied
                .iter()
                .fold(path, |path, copy| path.replace(copy, "(old")),
        )
    }
}

/// Whether a file has the form of a robot and only lists joints with their limits, as `joint_state_publisher` shows them.
fn is_list_of_joints(robot: &Robot) -> bool {
    let is_bare =
        |joint: &Joint| joint.kind.is_none() && joint.parent.is_none() && joint.child.is_none();
    robot.links.is_empty() && !robot.joints.is_empty() && robot.joints.iter().all(is_bare)
}

/// Whether a file has the name that browsers give to what is downloaded once more: `arm (1).urdf`.
fn is_second_download(file: &Path) -> bool {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let number = name
        .strip_suffix(')')
        .and_then(|name| name.rsplit_once(" ("));
    number.is_some_and(|(_, number)| number.parse::<u32>().is_ok())
}

/// Whether the name of a file says that it is to be filled in.
fn is_template(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    words(&name)
        .iter()
        .any(|word| ["template", "tmpl"].contains(&word.as_str()))
}

fn words(text: &str) -> Vec<String> {
    let text = text.to_lowercase();
    text.split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}

/// Whether a finding is about text in front of the XML declaration: its fix removes the start of the file.
fn is_before_declaration(finding: &Finding) -> bool {
    let removes_start = |edit: &Edit| edit.span.range.start == 0 && edit.content.is_empty();
    let mut edits = finding.fix.iter().flat_map(|fix| &fix.edits);
    finding.rule == named::XML_SYNTAX_ERROR && edits.any(removes_start)
}

/// Whether a finding is about two dashes in a comment, which Bullet reads up to its end.
fn has_dashes(finding: &Finding) -> bool {
    finding.rule == named::XML_SYNTAX_ERROR && finding.message.starts_with("`--` is not allowed")
}

fn lower(findings: &mut [Finding]) {
    findings
        .iter_mut()
        .for_each(|finding| finding.severity = finding.severity.min(Severity::Info));
}

/// What is wrong in a file that xacro generated, and in its source as well, is said of the source. The rest is an info
/// where nothing loads the file: it has to be generated again.
pub(super) fn leave_out_copies(session: &Session, results: &mut [RootResult]) {
    let generated: Vec<(usize, String)> = (0..)
        .zip(&*results)
        .filter_map(|(number, result)| Some((number, generated_from(result.files.first()?)?)))
        .collect();
    for (number, source) in generated {
        let Some(file) = results.get(number).map(|result| result.task.file.clone()) else {
            continue;
        };
        let is_source = |result: &&RootResult| {
            result
                .task
                .file
                .file_name()
                .is_some_and(|name| name == source.as_str())
                && result.task.file != file
        };
        let shared = |result: &&RootResult| {
            let (a, b) = (result.task.file.components(), file.components());
            a.zip(b).take_while(|(a, b)| a == b).count()
        };
        let Some(source) = results.iter().filter(is_source).max_by_key(shared) else {
            if is_scratch(session, results, number) {
                lower_all(results, number);
            }
            continue;
        };
        let said = |finding: &Finding| {
            let ways = finding.call_sites.iter().map(|way| way.message.to_string());
            let (code, severity) = (finding.rule.code, finding.severity);
            ways.chain([finding.message.clone()])
                .map(|message| (code, severity, message))
                .collect::<Vec<_>>()
        };
        let said: FastSet<(&str, Severity, String)> =
            source.findings.iter().flat_map(said).collect();
        if let Some(result) = results.get_mut(number) {
            result.findings.retain(|finding| {
                !said.contains(&(finding.rule.code, finding.severity, finding.message.clone()))
            });
            let is_walked = result.task.reason == CheckReason::Walked;
            if is_walked && !session.callers.load(&file) && !session.is_included(&file) {
                lower(&mut result.findings);
            }
        }
    }
}

/// Whether a file that was generated from another one, which is gone, lies beside a description that was not, and nothing
/// names or includes it while others are launched.
fn is_scratch(session: &Session, results: &[RootResult], number: usize) -> bool {
    let Some(own) = results.get(number) else {
        return false;
    };
    let is_beside = |other: &RootResult| {
        other.task.file != own.task.file
            && other.task.file.parent() == own.task.file.parent()
            && other
                .files
                .first()
                .is_some_and(|file| generated_from(file).is_none())
    };
    let file = &own.task.file;
    own.task.reason == CheckReason::Walked
        && results.iter().any(is_beside)
        && session.callers.load_another(file)
        && !session.callers.name(file)
        && !session.is_included(file)
}

fn lower_all(results: &mut [RootResult], number: usize) {
    if let Some(result) = results.get_mut(number) {
        lower(&mut result.findings);
    }
}

/// The name of the file that xacro generated a file from.
pub(super) fn generated_from(file: &SourceFile) -> Option<String> {
    let (source, _) = banner(file)?;
    Some(source.rsplit('/').next()?.to_owned())
}
