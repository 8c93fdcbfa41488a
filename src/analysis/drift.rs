//! Files that xacro generated, and that differ from what their sources give now.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::check_task::{CheckReason, CheckTask};
use super::expect::{entry_at, filled, worded};
use super::generated::banner;
use super::options::CheckOptions;
use super::root_result::RootResult;
use super::roots::variants;
use super::run_cache::{RunResult, RunSetting};
use super::run_task;
use super::runs::run_once;
use super::session::Session;
use super::threads::map_all;
use base::limits::{DRIFT_RUNS, DRIFT_SOURCES};
use base::{CancelFlag, FastSet, Span, TextRange};
use expand::{BindingKind, Request, expand, write, write_mapped};
use model::{Comparison, Difference, compare};
use rules::{
    Edit, Finding, Fix, Related, Safety, Severity, generated_urdf_out_of_date, named, span_of,
};
use vfs::SourceFile;

/// The arguments with which a file may have been generated.
struct Generation {
    source: PathBuf,
    args: Vec<(String, String)>,
    /// Whether the configuration lists it.
    is_configured: bool,
    /// Whether the configuration says that this file comes from it.
    is_meant: bool,
}

/// Such arguments with what they give.
struct Tried {
    variant: Generation,
    run: Arc<RunResult>,
    difference: Difference,
}

impl Tried {
    /// How much of the file it gives; configured arguments come first.
    fn likeness(&self) -> (bool, usize) {
        (self.variant.is_configured, self.difference.other.start)
    }
}

/// Generated files that no known arguments give any more.
pub(super) fn drift_findings(
    session: &Session,
    options: &CheckOptions,
    results: &[RootResult],
) -> Vec<Finding> {
    let rule = named::GENERATED_URDF_OUT_OF_DATE;
    let mut seen: FastSet<&Path> = FastSet::default();
    let generated: Vec<&Arc<SourceFile>> = (results.iter())
        .filter(|result| seen.insert(&result.task.file))
        .filter_map(|result| result.files.first())
        .filter(|file| {
            session.settings(&file.path).runs(rule, &file.path) && banner(file).is_some()
        })
        .collect();
    let found = map_all(generated, |file| drift(session, file, &options.cancel));
    found.into_iter().flatten().collect()
}

fn drift(session: &Session, file: &SourceFile, cancel: &CancelFlag) -> Option<Finding> {
    let (name, range) = banner(file)?;
    let text = file.document.text();
    let mut variants: Vec<(Generation, Arc<RunResult>)> = Vec::new();
    for source in sources_named(session, &name, &file.path) {
        for variant in generations(session, &source) {
            let (task, setting) = (
                variant.task(),
                RunSetting {
                    args: variant.args.clone(),
                    ..RunSetting::default()
                },
            );
            let run = run_once(
                &session.drift_runs,
                session,
                &session.vfs,
                cancel,
                &task,
                &setting,
            );
            let variant = Generation {
                is_meant: is_meant(session, &variant, &run, &file.path),
                ..variant
            };
            variants.push((variant, run));
        }
    }
    if variants.iter().any(|(variant, _)| variant.is_meant) {
        variants.retain(|(variant, _)| variant.is_meant);
    }
    let mut tried = Vec::new();
    for (variant, run) in variants
        .into_iter()
        .filter(|(_, run)| !run.refused && !is_for_old_xacro(&run.text))
    {
        match compare(&run.text, &text) {
            Comparison::Same => return None,
            Comparison::Different(difference) => tried.push(Tried {
                variant,
                run,
                difference,
            }),
            Comparison::Unknown => {}
        }
    }
    // the arguments that give most of the file
    let mut best: Option<Tried> = None;
    for tried in tried {
        if best
            .as_ref()
            .is_none_or(|best| best.likeness() < tried.likeness())
        {
            best = Some(tried);
        }
    }
    out_of_date(session, file, (&name, range), best?)
}

/// The files that a banner may mean, the most likely ones.
fn sources_named(session: &Session, written: &str, from: &Path) -> Vec<PathBuf> {
    let written = Path::new(written);
    let Some(name) = written.file_name().and_then(|name| name.to_str()) else {
        return Vec::new();
    };
    let mut found = session.packages.files_named(name, from);
    let own = package_folder(session, from);
    found.retain(|path| {
        path != from
            && path.file_name().is_some_and(|own| own == name)
            && is_near(session, path, written, own.as_deref())
    });
    let nearness = |path: &PathBuf| {
        let tail = shared(path.iter().rev(), written.iter().rev());
        (tail, shared(path.iter(), from.iter()))
    };
    let best = found.iter().map(nearness).max();
    found.retain(|path| Some(nearness(path)) == best);
    found.truncate(DRIFT_SOURCES);
    found
}

/// Whether a banner in a file of the package in folder `own` may mean a file: `robot.xacro` of another package is another
/// robot, unless the banner names that package's folder.
fn is_near(session: &Session, path: &Path, written: &Path, own: Option<&Path>) -> bool {
    match package_folder(session, path) {
        other if own == other.as_deref() => true,
        Some(other) => other
            .file_name()
            .is_some_and(|folder| written.iter().any(|part| part == folder)),
        None => shared(path.iter().rev(), written.iter().rev()) > 1,
    }
}

fn package_folder(session: &Session, path: &Path) -> Option<PathBuf> {
    session
        .packages
        .containing(path)
        .map(|package| package.folder)
}

/// The arguments with which a file may be expanded: those of the configuration, its defaults, and those of launch files.
fn generations(session: &Session, source: &Path) -> Vec<Generation> {
    let settings = session.settings(source);
    let mut found: Vec<Generation> = Vec::new();
    for root in &settings.config.roots {
        if root.files(&session.vfs).iter().any(|file| file == source) {
            variants(&session.callers, root, source)
                .into_iter()
                .for_each(|variant| add_generation(&mut found, source, variant.args, true));
        }
    }
    add_generation(&mut found, source, Vec::new(), false);
    for call in session
        .robot_calls(source)
        .iter()
        .filter(|call| call.target.as_deref() == Some(source))
    {
        let known = call.call.args.iter().filter_map(|argument| {
            let value = argument.given(&session.packages, &call.call.caller)?;
            Some((argument.name.clone(), value))
        });
        add_generation(&mut found, source, known.collect(), false);
    }
    found
}

/// Whether the configuration expects a robot to be the content of a file.
fn is_meant(session: &Session, variant: &Generation, run: &RunResult, file: &Path) -> bool {
    let settings = session.settings(&variant.source);
    let roots = settings.config.roots.iter();
    let mut expected = roots
        .filter(|_| variant.is_configured)
        .flat_map(|root| &root.expect);
    expected.any(|expected| {
        let name = expected
            .expands_to
            .as_ref()
            .and_then(|name| filled(name, &run.arguments).ok());
        let folder = expected.place.path.parent();
        let path = folder.zip(name).map(|(folder, name)| folder.join(name));
        path.is_some_and(|path| vfs::without_parents(&path) == file)
    })
}

fn out_of_date(
    session: &Session,
    file: &SourceFile,
    (name, range): (&str, TextRange),
    best: Tried,
) -> Option<Finding> {
    let variant = &best.variant;
    let source_name = variant.source.file_name()?.to_string_lossy().into_owned();
    let own_name = file.path.file_name()?.to_string_lossy().into_owned();
    let is_known = variant.is_configured || variant.is_meant;
    let command = command(session, variant, &file.path);
    let help = if is_known {
        format!("run `{command}`")
    } else {
        format!("if it is in use, generate it again, for example with `{command}`")
    };
    let mut finding = generated_urdf_out_of_date(
        Span {
            file: file.id,
            range,
        },
        &source_name,
        help,
    );
    finding.severity = if is_known {
        Severity::Warning
    } else {
        Severity::Info
    };
    let (text, place) = regenerated(session, variant, name, &best.difference)?;
    let what = worded(&best.difference.what, &own_name);
    finding.related.extend(place.map(|span| Related {
        span,
        message: what,
        is_call: false,
    }));
    let other = &best.difference.other;
    let span = Span {
        file: file.id,
        range: TextRange::new(other.start as u32, other.end as u32),
    };
    finding.related.push(Related {
        span,
        message: "first difference".to_owned(),
        is_call: false,
    });
    let whole = Span {
        file: file.id,
        range: TextRange::new(0, file.document.text().len() as u32),
    };
    finding.fix = Some(Fix {
        safety: Safety::Unsafe,
        message: format!("generate `{own_name}` from `{source_name}`"),
        edits: vec![Edit {
            span: whole,
            content: text,
        }],
    });
    drop(best.run);
    Some(finding)
}

/// What the file is to hold, and the source of the first difference. None where an argument makes the difference and the
/// configuration does not say with which arguments the file was generated.
fn regenerated(
    session: &Session,
    variant: &Generation,
    name: &str,
    difference: &Difference,
) -> Option<(String, Option<Span>)> {
    let request = Request {
        probe: false,
        args: variant.args.clone(),
        ..run_task::request(session, &CancelFlag::default(), &variant.task())
    };
    let expansion = expand(run_task::sources(session), &request);
    // what was compared has no name in its banner
    let written = write_mapped(&expansion.tree, "");
    let entry = entry_at(&written.map, &difference.one);
    let mut read = entry
        .into_iter()
        .flat_map(|entry| expansion.index.read_in(entry.reads))
        .filter_map(|&binding| expansion.index.bindings.get(binding));
    if !variant.is_configured && read.any(|binding| binding.kind == BindingKind::Argument) {
        return None;
    }
    let place = entry.and_then(|entry| span_of(&expansion, entry.origin));
    Some((write(&expansion.tree, name).text, place))
}

/// The command that generates a file again.
fn command(session: &Session, variant: &Generation, file: &Path) -> String {
    let cwd = &session.env.cwd;
    let source = super::root_config::label(slashed_from(cwd, &variant.source), &variant.args);
    format!("xacro-lint expand {source} -o {}", slashed_from(cwd, file))
}

/// Whether a printed document has tags that xacro took without their prefix before ROS Jade: what generated the file then
/// gave another robot.
fn is_for_old_xacro(text: &str) -> bool {
    const TAGS: [&str; 3] = ["  <property ", "  <macro ", "  <include "];
    text.lines()
        .any(|line| TAGS.iter().any(|tag| line.starts_with(tag)))
}

impl Generation {
    fn task(&self) -> CheckTask {
        CheckTask::new(self.source.clone(), CheckReason::Named, self.args.clone())
    }
}

/// Add a way to expand a source that is not there yet, while there is room.
fn add_generation(
    variants: &mut Vec<Generation>,
    source: &Path,
    args: Vec<(String, String)>,
    is_configured: bool,
) {
    let is_new = variants.iter().all(|variant| variant.args != args);
    if is_new && variants.len() < DRIFT_RUNS {
        variants.push(Generation {
            source: source.to_owned(),
            args,
            is_configured,
            is_meant: false,
        });
    }
}

/// A path as a user in the folder `cwd` types it.
fn slashed_from(cwd: &Path, path: &Path) -> String {
    vfs::slashed(path.strip_prefix(cwd).unwrap_or(path))
}

/// How many parts of two paths are the same in front of the first ones that differ.
fn shared<'p>(a: impl Iterator<Item = &'p OsStr>, b: impl Iterator<Item = &'p OsStr>) -> usize {
    a.zip(b).take_while(|(a, b)| a == b).count()
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Session, Setup};
    use rules::Finding;
    use vfs::testing::Tree;

    const SOURCE: &str = "<robot name='r' xmlns:xacro='x'><xacro:arg name='size' default='1'/>\
                          <xacro:property name='size' value='1'/>\
                          <xacro:unless value='${$(arg size) == 1}'><xacro:property name='size' value='$(arg size)'/></xacro:unless>\
                          <link name='base'><inertial><mass value='${size}'/></inertial></link></robot>";

    fn generated(source: &str, size: &str) -> String {
        format!(
            "<?xml version=\"1.0\" ?>\n<!-- | This document was autogenerated by xacro from {source}   | -->\n\
             <robot name=\"r\">\n<link name=\"base\"><inertial><mass value=\"{size}\"/></inertial></link>\n</robot>\n"
        )
    }

    /// What the rule says of these files.
    fn found(files: &[(&str, &str)]) -> (Tree, Vec<Finding>) {
        let tree = Tree::new();
        tree.write("package.xml", "<package><name>r</name></package>");
        for (name, text) in files {
            tree.write(name, text);
        }
        let setup = Setup {
            folders: vec![tree.root().to_owned()],
            ..Setup::default()
        };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let options = CheckOptions {
            paths: vec![tree.root().to_owned()],
            ..CheckOptions::default()
        };
        let mut findings = crate::check(&session, &options).findings;
        findings.retain(|finding| finding.rule.name == "generated-urdf-out-of-date");
        (tree, findings)
    }

    /// The severity and the related messages of what the rule says, beside the source.
    fn check_drift(files: &[(&str, &str)], expected: Option<(&str, &str)>) {
        let files = [&[("urdf/r.urdf.xacro", SOURCE)], files].concat();
        let (_tree, findings) = found(&files);
        let first = findings
            .first()
            .map(|finding| (finding.severity.name(), finding.related[0].message.as_str()));
        assert_eq!(first, expected, "{files:?}");
    }

    #[test]
    fn files_that_are_up_to_date() {
        for size in ["1", "1.0", "1.00000000000001"] {
            check_drift(&[("r.urdf", &generated("urdf/r.urdf.xacro", size))], None);
        }
        let of = |size: &str| generated("/home/me/ws/r/urdf/r.urdf.xacro", size);
        let roots =
            "[[roots]]\nfile = 'urdf/r.urdf.xacro'\nargs = { size = [2, 3] }\npresets.p.size = 4";
        for size in ["1", "2", "3", "4"] {
            check_drift(&[("r.urdf", &of(size)), ("xacro-lint.toml", roots)], None);
        }
        let launch = "Command(['xacro ', FindPackageShare('r'), '/urdf/r.urdf.xacro', ' size:=7'])";
        check_drift(
            &[("r.urdf", &of("7")), ("launch/r.launch.py", launch)],
            None,
        );
    }

    #[test]
    fn files_that_differ() {
        let what = "`value` of `mass` is `1.0`, but `5.0` in `r.urdf`";
        let made = generated("r.urdf.xacro", "5");
        check_drift(&[("r.urdf", &made)], Some(("info", what)));
        let roots = "[[roots]]\nfile = 'urdf/r.urdf.xacro'\nargs = { size = 1 }";
        check_drift(
            &[("r.urdf", &made), ("xacro-lint.toml", roots)],
            Some(("warning", what)),
        );
        // with the arguments that are meant for it
        let roots = "[[roots]]\nfile = 'urdf/r.urdf.xacro'\nargs = { size = [5, 6] }\n\
                     [[roots.expect]]\nwhen = { size = 6 }\nexpands-to = 'size_$(arg size).urdf'";
        let files = [("size_6.urdf", made.as_str()), ("xacro-lint.toml", roots)];
        let what = "`value` of `mass` is `6.0`, but `5.0` in `size_6.urdf`";
        check_drift(&files, Some(("warning", what)));
        let files = [("size_5.urdf", made.as_str()), ("xacro-lint.toml", roots)];
        check_drift(&files, None);
    }

    #[test]
    fn what_cannot_be_compared() {
        let made = generated("r.urdf.xacro", "5");
        check_drift(&[("r.urdf", &made.replace("<robot", "<robo"))], None);
        check_drift(
            &[("r.urdf", &made.replace("r.urdf.xacro", "other.xacro"))],
            None,
        );
        check_drift(&[("r.urdf", &made.replace("autogenerated", "made"))], None);
        let broken = SOURCE.replace("$(arg size)", "${gone}");
        assert!(
            found(&[("r.urdf.xacro", &broken), ("r.urdf", &made)])
                .1
                .is_empty()
        );
    }

    #[test]
    fn files_of_other_arguments() {
        let source = SOURCE.replace("${size}", "$(arg size)");
        let made = generated("r.urdf.xacro", "5");
        assert!(
            found(&[("r.urdf.xacro", &source), ("r.urdf", &made)])
                .1
                .is_empty()
        );
        let roots = "[[roots]]\nfile = 'r.urdf.xacro'";
        let files = [
            ("r.urdf.xacro", source.as_str()),
            ("r.urdf", &made),
            ("xacro-lint.toml", roots),
        ];
        assert_eq!(found(&files).1.len(), 1);
        // a source for a version of xacro that took tags without their prefix
        let old = SOURCE.replace("<link", "<property name='a' value='1'/><link");
        assert!(
            found(&[("r.urdf.xacro", &old), ("r.urdf", &made)])
                .1
                .is_empty()
        );
    }

    #[test]
    fn the_nearest_source_is_meant() {
        let other = SOURCE.replace("name='size' value='1'", "name='size' value='5'");
        let made = generated("urdf/r.urdf.xacro", "5");
        let files = |name: &'static str| [("r.urdf", made.as_str()), (name, other.as_str())];
        check_drift(
            &files("old/r.urdf.xacro"),
            Some(("info", "`value` of `mass` is `1.0`, but `5.0` in `r.urdf`")),
        );
        check_drift(&files("a/urdf/r.urdf.xacro"), None);
        let other = [
            ("arm/package.xml", "<package><name>arm</name></package>"),
            ("arm/b.xacro", SOURCE),
        ];
        for (banner, expected) in [("b.xacro", 0), ("arm/b.xacro", 1)] {
            let made = generated(banner, "5");
            assert_eq!(
                found(&[&[("r.urdf", made.as_str())], &other[..]].concat())
                    .1
                    .len(),
                expected,
                "{banner}"
            );
        }
    }

    #[test]
    fn the_fix_keeps_the_banner() {
        let made = generated("urdf/r.urdf.xacro", "5");
        let (_tree, findings) = found(&[("urdf/r.urdf.xacro", SOURCE), ("r.urdf", &made)]);
        let fix = findings[0].fix.as_ref().unwrap();
        assert_eq!(fix.edits[0].span.range.len() as usize, made.len());
        let text = &fix.edits[0].content;
        assert!(
            text.contains("from urdf/r.urdf.xacro ") && text.contains("<mass value=\"1\"/>"),
            "{text}"
        );
        assert_eq!(
            findings[0].help.as_deref(),
            Some(
                "if it is in use, generate it again, for example with `xacro-lint expand urdf/r.urdf.xacro -o r.urdf`"
            )
        );
    }
}
