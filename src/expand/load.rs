//! Loading files.
use std::path::Path;
use std::sync::Arc;

use ecow::EcoString;

use super::expander::{Expander, raise};
use super::expansion::FileUse;
use super::kind::ProblemKind;
use super::meant;
use super::origin::{FileIdx, Origin, SourceItem};
use super::problem::{Detail, Outside};
use super::record::Read;
use super::request::Sources;
use base::TextRange;
use base::paths::HERE;
use packages::Built;
use vfs::{LoadError, LoadErrorKind, SourceFile, slashed};
use xml::{Document, SyntaxError, SyntaxErrorKind};

impl Expander<'_> {
    /// Load a file for the include (or the request) at `at`; reports why it cannot be; `argument` is
    /// one that callers give and that the name is computed from.
    pub fn load(
        &mut self,
        name: &str,
        at: Origin,
        argument: Option<&EcoString>,
    ) -> Option<FileIdx> {
        let path = self.file_path(name);
        let (path, loaded) = match self.sources.vfs.document(&path) {
            Err(error) if error.kind == LoadErrorKind::NotFound && at != Origin::NOWHERE => {
                match self.built(&path) {
                    Some(built)
                        if built.is_template && has_placeholders(&self.sources, &built.path) =>
                    {
                        self.generated(name, &built.path, at);
                        return None;
                    }
                    Some(built) => {
                        let loaded = self.sources.vfs.document(&built.path);
                        (built.path, loaded)
                    }
                    None => (path, Err(error)),
                }
            }
            loaded => (path, loaded),
        };
        match loaded {
            Ok(source) => {
                self.result.record.add(Read::File(path, source.hash));
                if let Some(&file) = self.files.by_path.get(&source.path) {
                    return Some(file);
                }
                let file = self.result.files.next_id();
                self.files.by_path.insert(source.path.clone(), file);
                self.add_sources(file, name, &source);
                self.report_encoding(file, &source);
                self.report_syntax(file, at);
                Some(file)
            }
            Err(error) => {
                self.result.record.add(Read::Missing(path));
                self.not_loaded(name, error, at, argument);
                None
            }
        }
    }

    /// What the build of a package puts at a path that does not exist. The result depends on the path and on the
    /// build files.
    pub fn built(&mut self, path: &Path) -> Option<Built> {
        let Sources { vfs, packages, .. } = self.sources;
        self.result.record.add(Read::Missing(path.to_owned()));
        for file in packages
            .build_around(path)
            .iter()
            .flat_map(|build| &build.files)
        {
            self.result.record.add(match vfs.document_hash(file) {
                Some(hash) => Read::File(file.clone(), hash),
                None => Read::Missing(file.clone()),
            });
        }
        packages.built(path)
    }

    /// The content of a file is known to the build only.
    fn generated(&mut self, name: &str, template: &Path, at: Origin) {
        self.gaps.include_missing = true;
        self.result.complete = false;
        if self
            .files
            .optional_includes
            .iter()
            .any(|&optional| optional)
        {
            return;
        }
        let message = format!(
            "included file `{name}` is generated from `{}` at build time",
            slashed(template)
        );
        let problem = self
            .problem(ProblemKind::IncludeNotFound, at, message)
            .excused();
        self.push(
            problem
                .help("build the package to generate the file; definitions in it are not checked"),
        );
    }

    /// The reference reads every file as UTF-8.
    fn report_encoding(&mut self, file: FileIdx, source: &SourceFile) {
        let Some((offset, message)) = &source.encoding_error else {
            return;
        };
        let range = TextRange::empty((*offset).min(source.document.len()));
        let place = super::FileRange { file, range };
        let byte = message
            .strip_prefix("'utf-8' codec can't decode ")
            .and_then(|rest| rest.split(": ").next());
        let said = format!("file is not valid UTF-8: {}", byte.unwrap_or(message));
        let problem = super::Problem::new(ProblemKind::XmlEncodingMismatch, place, said);
        self.push(problem.says(message.clone()).help("save the file as UTF-8"));
    }

    fn add_sources(&mut self, file: FileIdx, name: &str, source: &Arc<SourceFile>) {
        let document = &source.document;
        let footer_base = document.len() - document.footer().text().len() as u32;
        let header = SourceItem {
            file,
            item: document.header().clone(),
            base: 0,
        };
        let items = document.items().map(|(base, item)| SourceItem {
            file,
            item: item.clone(),
            base,
        });
        let footer = SourceItem {
            file,
            item: document.footer().clone(),
            base: footer_base,
        };
        let first_source = self.result.sources.push(header);
        self.result.sources.extend(items);
        self.result.sources.push(footer);
        let items = self.result.sources.len() as u32 - first_source.0 - 2;
        self.result.files.push(FileUse {
            name: name.to_owned(),
            source: source.clone(),
            first_source,
            items,
        });
    }

    fn not_loaded(
        &mut self,
        name: &str,
        error: LoadError,
        at: Origin,
        argument: Option<&EcoString>,
    ) {
        if at == Origin::NOWHERE {
            self.result.root_error = Some(error);
            self.result.complete = false;
            return;
        }
        let missing_is_fine = self
            .files
            .optional_includes
            .iter()
            .any(|&optional| optional);
        if missing_is_fine
            && matches!(
                error.kind,
                LoadErrorKind::NotFound | LoadErrorKind::IsDirectory
            )
        {
            // undo everything up to the optional include; only a nested file has anything to undo
            self.flow.unwinding = self.files.optional_includes.last() != Some(&true);
            return;
        }
        self.gaps.include_missing = true;
        self.result.complete = false;
        let shown = if HERE.is_absolute(name) {
            name.to_owned()
        } else {
            format!("{}/{name}", self.root_name())
        };
        let LoadError {
            strerror, errno, ..
        } = &error;
        let message = match error.kind {
            LoadErrorKind::NotFound => format!("included file `{name}` not found"),
            LoadErrorKind::IsDirectory => format!("included file `{name}` is a folder"),
            _ => format!("included file `{name}` cannot be read: {}", error.reason()),
        };
        let help = match error.kind {
            LoadErrorKind::TooLarge { .. } => raise("file-mb"),
            _ => format!(
                "correct the path, or add the file: {}",
                slashed(&error.path)
            ),
        };
        let path = match error.kind {
            LoadErrorKind::TooLarge { .. } => None,
            _ => Some(slashed(&error.path)),
        };
        let meant = match error.kind {
            LoadErrorKind::NotFound => meant::by_include(self.text_of(at)),
            _ => None,
        };
        let is_other = meant.is_some();
        let meant = meant.or_else(|| match error.kind {
            LoadErrorKind::NotFound => self.namesake_of(&error.path, at),
            _ => None,
        });
        let message = if is_other {
            format!("included file `{}` not found", self.text_of(at))
        } else {
            message
        };
        let problem = self
            .problem(ProblemKind::IncludeNotFound, at, message)
            .says(format!(
                "{strerror}: {shown} [Errno {errno}] {strerror}: '{shown}'"
            ))
            .depends_on(argument.cloned().map_or(Outside::File, Outside::Argument))
            .help(help);
        let problem = super::Problem {
            detail: path.map(Detail::LookedFor),
            ..problem
        };
        let excuse = match error.kind {
            LoadErrorKind::NotFound if !is_other => self.excuse(&error.path, at),
            _ => None,
        };
        let problem = match excuse {
            Some(help) => problem.excused().help(help),
            None => problem,
        };
        self.push(match meant {
            Some(meant) => meant.said_of(problem),
            None => problem,
        });
    }

    /// What to do about a file that is missing here and may be there on another computer, or after a build.
    fn excuse(&self, path: &Path, at: Origin) -> Option<&'static str> {
        let packages = self.sources.packages;
        if packages.may_be_made(path) {
            Some("build the package to generate the file, or correct the path")
        } else if packages.is_in_a_build(path) {
            Some(
                "build the package again, or correct the path: only an installed copy of the package was found",
            )
        } else if packages.is_ignored_by_git(path) && !self.is_ignored_itself(at) {
            Some("get the file that `.gitignore` leaves out, or correct the path")
        } else if is_of_a_system(self.text_of(at)) {
            Some("install the file on this computer, or correct the path")
        } else {
            None
        }
    }

    /// Whether Git leaves out the file that a place is in as well: then it says nothing of another one.
    fn is_ignored_itself(&self, at: Origin) -> bool {
        let place = self.result.place(at);
        let file = place.and_then(|place| self.result.files.get(place.file));
        file.is_none_or(|file| self.sources.packages.is_ignored_by_git(&file.source.path))
    }

    fn root_name(&self) -> &str {
        self.request.root_dir.as_deref().unwrap_or(".")
    }

    /// One finding a file that is not well-formed; what its recovered tree seems to say is not trusted.
    fn report_syntax(&mut self, file: FileIdx, include: Origin) {
        let Some(used) = self.result.files.get(file) else {
            return;
        };
        let (document, base) = (used.source.document.clone(), used.first_source);
        let errors = document.errors();
        let Some(first) = errors.iter().min_by_key(|e| e.expat_offset) else {
            return;
        };
        self.files.broken.insert(file);
        if self.result.files.len() > 1 {
            self.gaps.include_missing = true;
        }
        let position = document.line_col(first.expat_offset, base::Encoding::Utf32);
        let at = Origin {
            src: base,
            range: first.range,
            frame: super::FrameId::ROOT,
        };
        let mut problem = self.syntax_problem(first, &document, at, file);
        if let Some(place) = self.result.place(include) {
            problem.trace.push(super::TraceStep {
                place,
                message: "included here".to_owned(),
            });
            problem
                .trace
                .extend(self.problem(ProblemKind::XmlSyntaxError, include, "").trace);
        }
        problem.reference = format!(
            "XML parsing error: {}: line {}, column {}",
            first.expat,
            position.line + 1,
            position.col
        );
        // one that nothing includes and that has comments at most is yet to be written, or the head of others
        if include == Origin::NOWHERE && first.kind == SyntaxErrorKind::NoRoot {
            problem = problem.depends_on(Outside::Includer);
        }
        self.push(problem);
    }

    fn syntax_problem(
        &self,
        error: &SyntaxError,
        document: &Document,
        at: Origin,
        file: FileIdx,
    ) -> super::Problem {
        // of an unbound prefix, the range holds the prefix
        let xacro = error.kind == SyntaxErrorKind::UnboundPrefix
            && document.slice(error.range).contains("xacro");
        let kind = if xacro {
            ProblemKind::MissingXacroNamespace
        } else {
            ProblemKind::XmlSyntaxError
        };
        let mut problem = self.problem(kind, at, error.headline());
        problem.place = super::FileRange {
            file,
            range: error.range,
        };
        problem = problem.help(if xacro {
            "add xmlns:xacro=\"http://www.ros.org/wiki/xacro\" to the root element"
        } else {
            error.help()
        });
        if let Some((range, what)) = error.related {
            problem.trace.push(super::TraceStep {
                place: super::FileRange { file, range },
                message: what.to_owned(),
            });
        }
        problem
    }
}

/// Whether a template has places that the build fills in: `@NAME@`, or those of a template language.
fn has_placeholders(sources: &Sources<'_>, template: &Path) -> bool {
    let Ok(file) = sources.vfs.text(template) else {
        return true;
    };
    let is_name =
        |text: &str| !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '_');
    let mut parts = file.text.split('@').skip(1);
    ["@(", "{{", "{%"]
        .iter()
        .any(|sign| file.text.contains(sign))
        || parts.any(is_name)
}

/// Whether a file is named by a path of the system folders of one computer: nothing in a repository can hold it.
fn is_of_a_system(written: &str) -> bool {
    const FOLDERS: [&str; 5] = ["/etc/", "/opt/", "/srv/", "/usr/", "/var/"];
    FOLDERS
        .iter()
        .any(|folder| written.trim_start().starts_with(folder))
}
