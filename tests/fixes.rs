//! What fixes must keep, tried on the bad blocks of `docs/rules/` and on the examples: a safe fix leaves the
//! robot as it is or removes findings, brings no new ones, and a second run changes nothing.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use xacro_lsp::analysis::{
    self, CheckOptions, FixOptions, Fixed, Overrides, Report, Session, Setup,
};
use xacro_lsp::cli::{self, Io};
use xacro_lsp::rules::{self, Finding, Safety, Severity};
use xacro_lsp::vfs::Environment;

fn temporary(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("fixes")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    // a repository of its own: nothing is read of folders above
    fs::create_dir_all(folder.join(".git")).unwrap();
    folder
}

fn environment(folder: &Path) -> Environment {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    }
}

/// The files of the bad blocks of a page, the one to check first.
fn bad_blocks(docs: &str) -> Vec<Vec<(String, String)>> {
    let mut found: Vec<Vec<(String, String)>> = Vec::new();
    let mut inside = false;
    for line in docs.lines() {
        if let Some(info) = line.strip_prefix("```") {
            inside = info.contains(",bad") && !info.contains("latin-1");
            if let Some((kind, _)) = info.split_once(',').filter(|_| inside) {
                found.push(vec![(format!("robot.{kind}"), String::new())]);
            }
        } else if inside {
            let files = found.last_mut().unwrap();
            let is_marker = line.contains('^') && line.chars().all(|c| c == ' ' || c == '^');
            match line.strip_prefix("//- ") {
                Some(name) => {
                    files.retain(|(_, text)| !text.is_empty());
                    files.push((name.to_owned(), String::new()));
                }
                None if is_marker => {}
                None => files.last_mut().unwrap().1.push_str(&format!("{line}\n")),
            }
        }
    }
    found
}

/// The elements of the expansion, without comments and white space; none when it cannot be expanded.
fn expansion(folder: &Path, file: &str) -> Option<Vec<String>> {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut stdin = std::io::empty();
    let mut io = Io::plain(&mut out, &mut err, &mut stdin);
    let code = cli::run(
        &["expand".to_owned(), file.to_owned()],
        &environment(folder),
        &mut io,
    );
    let text = String::from_utf8(out).unwrap();
    let document = roxmltree::Document::parse(&text)
        .ok()
        .filter(|_| code == 0)?;
    let nodes = document
        .root()
        .descendants()
        .filter(|node| node.is_element() || node.is_text());
    let shown = nodes.map(|node| match node.text().filter(|_| node.is_text()) {
        Some(text) => text.trim().to_owned(),
        None => {
            let attributes: BTreeMap<_, _> =
                node.attributes().map(|a| (a.name(), a.value())).collect();
            format!(
                "{} {:?} {attributes:?}",
                node.ancestors().count(),
                node.tag_name().name()
            )
        }
    });
    Some(shown.filter(|text| !text.is_empty()).collect())
}

fn fix(folder: &Path, file: &str, extend_select: Option<Vec<String>>, most: Safety) -> Fixed {
    let overrides = Overrides {
        extend_select,
        ..Overrides::default()
    };
    let setup = Setup {
        about: folder.to_owned(),
        overrides,
        ..Setup::default()
    };
    let session = Session::new(&environment(folder), setup).unwrap();
    let options = CheckOptions {
        paths: vec![file.into()],
        ..CheckOptions::default()
    };
    let fixed = analysis::fix(
        &session,
        &options,
        FixOptions {
            most,
            shown: Severity::Hint,
        },
    );
    for file in &fixed.files {
        session
            .vfs
            .rewrite(&file.path, &file.before, &file.after)
            .unwrap();
    }
    fixed
}

fn serious(report: &Report) -> Vec<(&'static str, &str)> {
    let findings = report
        .findings
        .iter()
        .filter(|finding| finding.severity >= Severity::Warning);
    findings
        .map(|finding| (finding.rule.name, finding.message.as_str()))
        .collect()
}

/// Whether errors had safe fixes. They are gone then.
fn fixed_errors(fixed: &Fixed) -> bool {
    let is_safe = |finding: &&Finding| {
        finding
            .fix
            .as_ref()
            .is_some_and(|fix| fix.safety == Safety::Safe)
    };
    let errors = |report: &Report| {
        let errors = report
            .findings
            .iter()
            .filter(|finding| finding.severity == Severity::Error);
        errors
            .filter(is_safe)
            .map(|finding| (finding.rule.name, finding.message.clone()))
            .collect()
    };
    let (found, left): (BTreeSet<_>, BTreeSet<_>) = (errors(&fixed.found), errors(fixed.left()));
    assert!(found.is_disjoint(&left), "{left:?} are still there");
    !found.is_empty()
}

/// Fix twice; what is wrong with that.
fn try_out(folder: &Path, file: &str, select: Option<&str>, most: Safety) -> Option<String> {
    let select = || select.map(|rule| vec![rule.to_owned()]);
    let before = expansion(folder, file);
    let fixed = fix(folder, file, select(), most);
    let after = expansion(folder, file);
    for finding in fixed
        .found
        .findings
        .iter()
        .filter(|finding| finding.fix.is_some())
    {
        assert!(
            finding.rule.fix.is_some(),
            "the page of {} says that it has no fix",
            finding.rule.name
        );
    }
    let (found, left) = (serious(&fixed.found), serious(fixed.left()));
    let news: BTreeSet<_> = left
        .iter()
        .filter(|finding| !found.contains(finding))
        .collect();
    // fixed errors may uncover what they hid; whatever else was fixed is just gone
    if most == Safety::Safe && !fixed_errors(&fixed) {
        if !news.is_empty() {
            return Some(format!("{news:?} are new"));
        }
        let settled = fixed.left().findings.len() < fixed.found.findings.len();
        if before.is_some() && before != after && !settled {
            return Some(format!("changes the robot:\n{before:#?}\n{after:#?}"));
        }
    }
    let again = fix(folder, file, select(), most);
    (!again.files.is_empty()).then(|| format!("a second run changes {:?}", again.files))
}

#[test]
fn fixes_of_the_pages() {
    let mut wrong = Vec::new();
    let mut fixed = BTreeSet::new();
    for rule in rules::all() {
        for (number, files) in bad_blocks(rule.docs).iter().enumerate() {
            for most in [Safety::Safe, Safety::Unsafe] {
                let folder = temporary(&format!("{}-{number}-{}", rule.name, most.name()));
                for (name, text) in files {
                    fs::create_dir_all(folder.join(name).parent().unwrap()).unwrap();
                    fs::write(folder.join(name), text).unwrap();
                }
                let file = &files[0].0;
                let trouble = try_out(&folder, file, Some(rule.name), most);
                wrong.extend(
                    trouble.map(|text| format!("{} #{number}, {}: {text}", rule.name, most.name())),
                );
                if files
                    .iter()
                    .any(|(name, text)| fs::read_to_string(folder.join(name)).unwrap() != *text)
                {
                    fixed.insert(rule.name);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        fixed.contains("nonstandard-xacro-namespace") && fixed.contains("unprefixed-xacro-tag")
    );
}

#[test]
fn fixes_of_the_examples() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples");
    let mut names = Vec::new();
    for entry in fs::read_dir(&examples).unwrap().map(Result::unwrap) {
        if entry.path().is_dir() {
            let folder = temporary(&format!("example-{}", entry.file_name().display()));
            copy_into(&entry.path(), &folder);
            let trouble = try_out(&folder, ".", None, Safety::Safe);
            assert_eq!(trouble, None, "{}", entry.path().display());
            names.push(entry.file_name());
        }
    }
    assert!(names.len() >= 4);
}

/// What safe fixes of all rules make of a robot with this content: the text of the file afterwards, as it was apart from
/// `expected`, pairs of old and new text.
#[track_caller]
fn check_safe_fix(content: &str, parts: &[(&str, &str)], expected: &[(&str, &str)]) {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let folder = temporary(&format!("safe-{}", COUNT.fetch_add(1, Ordering::Relaxed)));
    let robot = |content: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{content}\n</robot>\n"
        )
    };
    for (name, content) in parts {
        fs::write(folder.join(name), robot(content)).unwrap();
    }
    let before = robot(content);
    fs::write(folder.join("r.urdf.xacro"), &before).unwrap();
    let mut wanted = before.clone();
    for (old, new) in expected {
        assert!(wanted.contains(old), "{old}");
        wanted = wanted.replacen(old, new, 1);
    }
    for _ in 0..2 {
        fix(&folder, ".", Some(vec!["ALL".to_owned()]), Safety::Safe);
        assert_eq!(
            fs::read_to_string(folder.join("r.urdf.xacro")).unwrap(),
            wanted,
            "{content}"
        );
    }
}

#[test]
fn comparisons_that_other_values_need() {
    let switch = |value: &str| {
        format!(
            "<xacro:property name=\"q\" value=\"{value}\"/><xacro:if value=\"${{q == 'true'}}\"><link name=\"a\"/></xacro:if>"
        )
    };
    // in every robot this is false, and would be true
    check_safe_fix(&switch("true"), &[], &[]);
    let argument = "<xacro:arg name=\"q\" default=\"true\"/>";
    check_safe_fix(&format!("{argument}{}", switch("$(arg q)")), &[], &[]);
    let called = "<xacro:macro name=\"m\" params=\"q\"><xacro:if value=\"${q == 'true'}\"><link name=\"a\"/></xacro:if></xacro:macro>";
    check_safe_fix(
        &format!("{called}<xacro:m q=\"true\"/><xacro:m q=\"maybe\"/>"),
        &[],
        &[],
    );
    check_safe_fix(called, &[], &[]);
}

const PAIR: &str = "<link name=\"base\"/><link name=\"b\"/><link name=\"c\"/>";

#[test]
fn elements_that_other_calls_need() {
    let joint = |parts: &str| {
        format!(
            "{PAIR}<xacro:macro name=\"j\" params=\"n type parent child\"><joint name=\"${{n}}\" type=\"${{type}}\">\
             <parent link=\"${{parent}}\"/><child link=\"${{child}}\"/>{parts}</joint></xacro:macro>\
             <xacro:j n=\"one\" type=\"fixed\" parent=\"base\" child=\"b\"/>\
             <xacro:j n=\"two\" type=\"revolute\" parent=\"b\" child=\"c\"/>"
        )
    };
    let limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
    check_safe_fix(&joint(&format!("<axis xyz=\"0 1 0\"/>{limit}")), &[], &[]);
    // written for one call, without effect for the other: neither rule may undo what the other one did
    check_safe_fix(&joint(limit), &[], &[]);
    // without effect in both
    let fixed = joint("<axis xyz=\"0 1 0\"/>").replace("revolute", "fixed");
    check_safe_fix(&fixed, &[], &[("<axis xyz=\"0 1 0\"/>", "")]);
    // the type of the joint is an argument
    let by_argument = "<xacro:arg name=\"kind\" default=\"fixed\"/><link name=\"base\"/><link name=\"b\"/><joint name=\"j\" type=\"$(arg kind)\">\
                       <parent link=\"base\"/><child link=\"b\"/><axis xyz=\"0 1 0\"/></joint>";
    check_safe_fix(by_argument, &[], &[]);
}

#[test]
fn includes_that_do_something_twice() {
    let include = "<xacro:include filename=\"p.xacro\"/>";
    let twice = |between: &str| {
        format!(
            "<xacro:property name=\"w\" value=\"1\"/>{include}<link name=\"a${{v}}\"/>{between}{include}"
        )
    };
    let part =
        |value: &str| format!("<xacro:property name=\"v\" value=\"{value}\" lazy_eval=\"false\"/>");
    let again = "<xacro:property name=\"w\" value=\"5\"/>";
    let uses = "<xacro:macro name=\"m\"><material name=\"${v}\"/></xacro:macro><xacro:m/>";
    check_safe_fix(
        &format!("{}{uses}", twice(again)),
        &[("p.xacro", &part("${w + 1}"))],
        &[],
    );
    let harmless = format!("{}{uses}", twice(""));
    let gone = format!("<link name=\"a${{v}}\"/>{include}");
    check_safe_fix(
        &harmless,
        &[("p.xacro", &part("2"))],
        &[(&gone, "<link name=\"a${v}\"/>")],
    );
}

#[test]
fn suppressions_that_other_arguments_need() {
    let comment = "<!-- xacro-lint: disable-next-line orphan-link, zero-mass: reason -->\n";
    let link = "<link name=\"base\"/>";
    let argument = "<xacro:arg name=\"sim\" default=\"false\"/>";
    let condition = format!(
        "{argument}{link}<xacro:if value=\"$(arg sim)\">\n{comment}<link name=\"b\"/></xacro:if>"
    );
    check_safe_fix(&condition, &[], &[]);
    let idle = format!(
        "{link}<xacro:macro name=\"m\" params=\"n\">\n{comment}<link name=\"${{n}}\"/></xacro:macro>"
    );
    check_safe_fix(&idle, &[], &[]);
    check_safe_fix(&format!("\n{comment}{link}"), &[], &[(comment, "")]);
    check_safe_fix(
        &format!(
            "{argument}<xacro:if value=\"$(arg sim)\"><link name=\"b\"/></xacro:if>\n{comment}{link}"
        ),
        &[],
        &[],
    );
}

#[test]
fn findings_that_are_not_shown_stay() {
    let folder = temporary("not-shown");
    let text = "<?xml version=\"1.0\"?>\n<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><link name=\"base\"/></robot>\n";
    fs::write(folder.join("r.urdf.xacro"), text).unwrap();
    let setup = Setup {
        about: folder.clone(),
        ..Setup::default()
    };
    let session = Session::new(&environment(&folder), setup).unwrap();
    let options = CheckOptions {
        paths: vec![".".into()],
        ..CheckOptions::default()
    };
    let how = FixOptions {
        most: Safety::Safe,
        shown: Severity::Warning,
    };
    let fixed = analysis::fix(&session, &options, how);
    assert_eq!((fixed.count, fixed.hidden), (0, 1));
    let fixed = analysis::fix(
        &session,
        &options,
        FixOptions {
            shown: Severity::Info,
            ..how
        },
    );
    assert_eq!((fixed.count, fixed.hidden), (1, 0));
}

#[test]
fn line_ends_stay() {
    let folder = temporary("line-ends");
    let text = "<robot name=\"r\">\r\n<link name=\"base\"/>\r\n<link name=\"b\"/>\r\n<joint name=\"j\" type=\"continuous\">\r\n  <parent link=\"base\"/>\r\n  <child link=\"b\"/>\r\n</joint>\r\n</robot>\r\n";
    fs::write(folder.join("r.urdf"), text).unwrap();
    fix(&folder, ".", Some(vec!["ALL".to_owned()]), Safety::Safe);
    let after = fs::read_to_string(folder.join("r.urdf")).unwrap();
    assert!(
        after.contains("<child link=\"b\"/>\r\n  <axis xyz=\"1 0 0\"/>\r\n"),
        "{after:?}"
    );
    assert_eq!(
        after.matches('\n').count(),
        after.matches("\r\n").count(),
        "{after:?}"
    );
}

fn copy_into(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() {
            copy_into(&path, &to)
        } else {
            fs::copy(&path, &to).map(|_| ()).unwrap()
        }
    }
}
