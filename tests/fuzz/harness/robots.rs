//! Whole descriptions: expansion, rules and fixes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use xacro_lsp::analysis::{self, CheckOptions, FixOptions, Session, Setup};
use xacro_lsp::base::ExpansionLimits;
use xacro_lsp::expand::{Request, Sources, expand, write_mapped};
use xacro_lsp::packages::Packages;
use xacro_lsp::rules::{Safety, Severity};
use xacro_lsp::vfs::{Environment, Vfs};
use xacro_lsp::xml::Document;

use super::choice_and_text;

const ROOT: &str = "/none/robot.urdf.xacro";
const PART: &str = "/none/part.xacro";

fn environment() -> Environment {
    let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), "/none/prefix".to_owned())]);
    Environment {
        vars,
        cwd: PathBuf::from("/none"),
        ..Environment::default()
    }
}

fn errors(text: &str) -> usize {
    Document::parse(text).errors().len()
}

/// Expansion ends within its limits; every problem has a place in a file; a document without problems is XML, and
/// writing it twice gives the same.
pub fn expander(data: &[u8]) {
    let (choice, text) = choice_and_text(data);
    let (env, vfs) = (
        environment(),
        Arc::new(Vfs::with_cwd(1 << 20, PathBuf::from("/none"))),
    );
    vfs.set_buffer(Path::new(ROOT), Some(text.clone()));
    // what a file may include is itself
    vfs.set_buffer(Path::new(PART), Some(text.clone()));
    let packages = Packages::new(vfs.clone(), &env, Default::default());
    let limits = ExpansionLimits {
        eval_steps: 50_000,
        output_bytes: 4 << 20,
        expand_nodes: 5_000,
        expand_time: Duration::from_secs(20),
        macro_depth: 40,
        include_depth: 10,
    };
    let probe = choice & 1 != 0;
    let request = Request {
        file: ROOT.to_owned(),
        limits,
        probe,
        ..Request::default()
    };
    let expansion = expand(
        Sources {
            vfs: &vfs,
            packages: &packages,
            env: &env,
        },
        &request,
    );
    for problem in &expansion.problems {
        let file = expansion.files.get(problem.place.file).unwrap();
        assert!(
            problem.place.range.end <= file.source.document.len(),
            "{problem:?} of {text:?}"
        );
        assert!(!problem.message.is_empty(), "{problem:?} of {text:?}");
    }
    if expansion.complete && !expansion.has_errors() && expansion.root_error.is_none() {
        let written = write_mapped(&expansion.tree, ROOT);
        assert_eq!(
            xacro_lsp::expand::write(&expansion.tree, ROOT).text,
            written.text
        );
        for entry in &written.map {
            assert!(entry.out.end as usize <= written.text.len(), "{entry:?}");
        }
    }
}

/// The rules look at anything; fixes leave XML as sound as it was, and are at an end some time.
pub fn fixes(data: &[u8]) {
    let (choice, text) = choice_and_text(data);
    let setup = Setup {
        about: PathBuf::from("/none"),
        ..Setup::default()
    };
    let session = Session::new(&environment(), setup).expect("no file is named");
    session.vfs.set_buffer(Path::new(ROOT), Some(text.clone()));
    let options = CheckOptions {
        paths: vec![ROOT.into()],
        ..CheckOptions::default()
    };
    let most = if choice & 1 == 0 {
        Safety::Safe
    } else {
        Safety::Unsafe
    };
    let fixed = analysis::fix(
        &session,
        &options,
        FixOptions {
            most,
            shown: Severity::Hint,
        },
    );
    for finding in &fixed.found.findings {
        let source = fixed
            .found
            .source(finding.span.file)
            .expect("a file that was read");
        assert!(
            finding.span.range.end <= source.document.len(),
            "{finding:?} of {text:?}"
        );
        let lines = finding.message.lines().count();
        assert_eq!(lines, 1, "{finding:?} of {text:?}");
    }
    for file in &fixed.files {
        assert!(
            errors(&file.after) <= errors(&file.before),
            "{text:?} became {:?}",
            file.after
        );
        assert_ne!(file.after, file.before);
    }
}
