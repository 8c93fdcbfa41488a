//! `expands-to`: files that describe the same robot.
use std::path::{Path, PathBuf};

use super::super::session::Session;
use super::RULE;
use super::evaluate::ExpectationContext;
use base::{Span, TextRange};
use expand::{MapEntry, Origin};
use model::{Comparison, Difference, DifferenceKind, compare};
use rules::{Finding, Related};
use vfs::without_parents;

/// What a file is to hold.
pub(super) struct Snapshot {
    pub(super) path: PathBuf,
    pub(super) text: String,
    /// The first test that wants it.
    pub(super) owner: String,
    /// The expectation.
    place: Span,
    /// Its path as it is written.
    shown: String,
}

impl Snapshot {
    /// Whether another test wants the same.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        compare(&self.text, &other.text) == Comparison::Same
    }

    /// Whether a file needs no update.
    pub(super) fn is_written_in(&self, text: &str) -> bool {
        compare(&self.text, text) == Comparison::Same
    }

    /// Another test wants something else in the same file.
    pub(super) fn conflict(&self, owner: &str) -> Finding {
        let message = format!(
            "`{}` is also the file of `{owner}`, a different robot",
            self.shown
        );
        let mut finding = Finding::new(&RULE, self.place, message);
        finding.help = Some(
            "add `$(arg NAME)` to the name of the file, or limit the expectation with `when`"
                .to_owned(),
        );
        finding
    }
}

impl ExpectationContext<'_> {
    /// Compare the robot with a file, or note what the file is to hold.
    pub(super) fn snapshot(&mut self, name: &str, update: bool) {
        let Some(name) = self.filled(name) else {
            return;
        };
        let path = match self.session.snapshot_path(&self.expected.place.path, &name) {
            Ok(path) => path,
            Err(why) => {
                let help =
                    "use a path inside the workspace that ends with `.urdf` or `.xml`".to_owned();
                return self.fail_snapshot(format!("cannot use file `{name}`: {why}"), help);
            }
        };
        let place = self.session.span_of_place(&self.expected.place);
        if update {
            let (text, owner) = (
                self.written().text.clone(),
                self.session.test_name(&self.case.root),
            );
            return self.snapshots.push(Snapshot {
                path,
                text,
                owner,
                place,
                shown: name,
            });
        }
        let file = match self.session.vfs.text(&path) {
            Ok(file) => file,
            Err(error) => {
                let help = "write it with `xacro-lint test --update`".to_owned();
                return self
                    .fail_snapshot(format!("cannot read `{name}`: {}", error.reason()), help);
            }
        };
        match compare(&self.written().text, &file.text) {
            Comparison::Same => {}
            Comparison::Unknown => {
                let help =
                    "correct it, or write it again with `xacro-lint test --update`".to_owned();
                self.fail_snapshot(
                    format!("`{name}` is not a well-formed robot description"),
                    help,
                );
            }
            Comparison::Different(difference) => self.fail_difference(&name, &path, &difference),
        }
    }

    fn fail_snapshot(&mut self, message: String, help: String) {
        let span = self.session.span_of_place(&self.expected.place);
        self.findings.push(Finding {
            help: Some(help),
            ..Finding::new(&RULE, span, message)
        });
    }

    /// The first difference, at the source that makes it.
    fn fail_difference(&mut self, name: &str, path: &Path, difference: &Difference) {
        let origin = entry_at(&self.written().map, &difference.one)
            .map_or(Origin::NOWHERE, |entry| entry.origin);
        let help = "if the change is intended, run `xacro-lint test --update`".to_owned();
        self.fail(origin, worded(&difference.what, name), Some(help));
        let range = TextRange::new(difference.other.start as u32, difference.other.end as u32);
        let span = Span {
            file: self.session.vfs.file_id(path),
            range,
        };
        let related = Related {
            span,
            message: "different here".to_owned(),
            is_call: false,
        };
        if let Some(finding) = self.findings.last_mut() {
            finding.related.push(related);
        }
    }
}

/// What differs between the robot and a file.
pub(crate) fn worded(what: &DifferenceKind, file: &str) -> String {
    match what {
        DifferenceKind::Value { of, one, other } => {
            let (one, other) = (quoted(one.as_deref()), quoted(other.as_deref()));
            format!("{of} is {one}, but {other} in `{file}`")
        }
        DifferenceKind::OnlyOne(element) => format!("{element} is not in `{file}`"),
        DifferenceKind::OnlyOther(element) => format!("{element} of `{file}` is missing"),
    }
}

fn quoted(text: Option<&str>) -> String {
    text.map_or("missing".to_owned(), |text| format!("`{text}`"))
}

/// What a part of the printed document came from: the innermost entry of the map that holds its start.
pub(crate) fn entry_at<'m>(
    map: &'m [MapEntry],
    range: &std::ops::Range<usize>,
) -> Option<&'m MapEntry> {
    let at = range.start as u32;
    let holds =
        |entry: &&MapEntry| entry.out.start <= at && at < entry.out.end.max(entry.out.start + 1);
    map.iter().filter(holds).min_by_key(|entry| entry.out.len())
}

impl Session {
    /// The file that an expectation in `config` names: below the workspace around the configuration, and not a file
    /// that anything but a snapshot would be in.
    ///
    /// # Errors
    /// Why there cannot be a snapshot.
    fn snapshot_path(&self, config: &Path, name: &str) -> Result<PathBuf, String> {
        let folder = config.parent().unwrap_or(config);
        let path = without_parents(&folder.join(name));
        let ending = path
            .extension()
            .and_then(|ending| ending.to_str())
            .unwrap_or_default();
        if !["urdf", "xml"].contains(&ending) {
            return Err("its name must end with `.urdf` or `.xml`".to_owned());
        }
        if self.vfs.is_present(&path) && !self.vfs.exists(&path) {
            return Err("it is a link to a file that does not exist".to_owned());
        }
        let existing = path
            .ancestors()
            .find(|path| self.vfs.is_present(path))
            .unwrap_or(folder);
        let folder = self.vfs.canonical(folder);
        let top = self.packages.workspace(&folder).unwrap_or(folder);
        let top = self.vfs.canonical(&top);
        if !self.vfs.canonical(existing).starts_with(&top) {
            return Err("it is outside of the workspace".to_owned());
        }
        Ok(path)
    }
}
