//! `expands-to`: files that describe the same robot.
use std::path::{Path, PathBuf};

use super::super::session::Session;
use super::context::ExpectationContext;
use super::outcome::{RULE, span_of_place, test_name};
use super::snapshot::{Snapshot, entry_at, worded};
use base::{Span, TextRange};
use expand::Origin;
use model::{Comparison, Difference, compare};
use rules::{Finding, Related};
use vfs::without_parents;

/// Compare the robot with a file, or note what the file is to hold.
pub(super) fn compare_with_file(cx: &mut ExpectationContext<'_>, name: &str, update: bool) {
    let Some(name) = cx.filled(name) else {
        return;
    };
    let path = match snapshot_path(cx.session, &cx.expected.place.path, &name) {
        Ok(path) => path,
        Err(why) => {
            let help =
                "use a path inside the workspace that ends with `.urdf` or `.xml`".to_owned();
            return fail_snapshot(cx, format!("cannot use file `{name}`: {why}"), help);
        }
    };
    let place = span_of_place(&cx.session.vfs, &cx.expected.place);
    if update {
        let (text, owner) = (cx.written().text.clone(), test_name(cx.session, cx.root));
        return cx.snapshots.push(Snapshot {
            path,
            text,
            owner,
            place,
            shown: name,
        });
    }
    let file = match cx.session.vfs.text(&path) {
        Ok(file) => file,
        Err(error) => {
            let help = "write it with `xacro-lint test --update`".to_owned();
            return fail_snapshot(
                cx,
                format!("cannot read `{name}`: {}", error.reason()),
                help,
            );
        }
    };
    match compare(&cx.written().text, &file.text) {
        Comparison::Same => {}
        Comparison::Unknown => {
            let help = "correct it, or write it again with `xacro-lint test --update`".to_owned();
            fail_snapshot(
                cx,
                format!("`{name}` is not a well-formed robot description"),
                help,
            );
        }
        Comparison::Different(difference) => fail_difference(cx, &name, &path, &difference),
    }
}

fn fail_snapshot(cx: &mut ExpectationContext<'_>, message: String, help: String) {
    let span = span_of_place(&cx.session.vfs, &cx.expected.place);
    cx.findings.push(Finding {
        help: Some(help),
        ..Finding::new(&RULE, span, message)
    });
}

/// The first difference, at the source that makes it.
fn fail_difference(
    cx: &mut ExpectationContext<'_>,
    name: &str,
    path: &Path,
    difference: &Difference,
) {
    let origin =
        entry_at(&cx.written().map, &difference.one).map_or(Origin::NOWHERE, |entry| entry.origin);
    let help = "if the change is intended, run `xacro-lint test --update`".to_owned();
    cx.fail(origin, worded(&difference.what, name), Some(help));
    let range = TextRange::new(difference.other.start as u32, difference.other.end as u32);
    let span = Span {
        file: cx.session.vfs.file_id(path),
        range,
    };
    let related = Related {
        span,
        message: "different here".to_owned(),
        is_call: false,
    };
    if let Some(finding) = cx.findings.last_mut() {
        finding.related.push(related);
    }
}

/// The file that an expectation in `config` names: below the workspace around the configuration, and not a file
/// that anything but a snapshot would be in.
///
/// # Errors
/// Why there cannot be a snapshot.
fn snapshot_path(session: &Session, config: &Path, name: &str) -> Result<PathBuf, String> {
    let folder = config.parent().unwrap_or(config);
    let path = without_parents(&folder.join(name));
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or_default();
    if !["urdf", "xml"].contains(&ending) {
        return Err("its name must end with `.urdf` or `.xml`".to_owned());
    }
    if session.vfs.is_present(&path) && !session.vfs.exists(&path) {
        return Err("it is a link to a file that does not exist".to_owned());
    }
    let existing = path
        .ancestors()
        .find(|path| session.vfs.is_present(path))
        .unwrap_or(folder);
    let folder = session.vfs.canonical(folder);
    let top = session.packages.workspace(&folder).unwrap_or(folder);
    let top = session.vfs.canonical(&top);
    if !session.vfs.canonical(existing).starts_with(&top) {
        return Err("it is outside of the workspace".to_owned());
    }
    Ok(path)
}
