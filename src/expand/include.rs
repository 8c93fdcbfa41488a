//! `xacro:include`, and loading files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::element::Tag;
use super::expansion::FileUse;
use super::machine::{Cx, Expander, OpenFile, World, raise};
use super::meant;
use super::origin::{FileIdx, FrameKind, Origin, Source, SrcId};
use super::problem::Outside;
use super::record::Read;
use super::resolve::{BindingInfo, BindingKind};
use super::scope::State;
use super::symbols::SymbolKind;
use super::tree::XId;
use base::TextRange;
use base::limits::{GLOB_ENTRIES, GLOB_FILES};
use base::paths::HERE;
use expr::{Value, display, literal};
use vfs::{LoadError, LoadErrorKind, SourceFile, TooMany, slashed};
use workspace::Built;
use xml::{NodeKind, SyntaxError, SyntaxErrorKind};

/// What every tag of an include knows.
#[derive(Clone)]
struct Inclusion {
    optional: bool,
    /// The file name is computed or stands under a condition: it can end a recursion.
    computed: bool,
    /// The file name is computed from this argument, which is empty by default: callers give it.
    argument: Option<EcoString>,
    /// The `filename` value.
    at: Origin,
    /// The tag.
    tag: Origin,
}

impl Expander<'_> {
    /// `xacro:include`
    pub fn include(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: Cx) {
        self.note_unclear();
        let Some((text, place)) = self.required_attr(tag, "filename", cx) else { return };
        self.check_attrs(tag, &["filename", "ns", "optional"], cx);
        let inner = self.include_scope(tag, cx);
        let Some(optional) = self.optional_flag(tag, cx) else { return };
        self.warn_about_children(tag, cx);
        let mark = self.reads.len();
        let value = self.eval_text(&text, place, cx.scope);
        let argument = self.empty_argument(mark);
        self.reads.truncate(mark);
        let Some(name) = display::to_str(&value) else {
            self.include_missing = true;
            self.result.complete = false;
            return;
        };
        let names = self.included_names(&name, place.origin);
        let inclusion = Inclusion {
            optional,
            computed: is_computed(&text),
            argument,
            at: place.origin,
            tag: self.tag_origin(tag, cx),
        };
        let content = self.container(place.origin);
        for name in names {
            self.include_file(&name, &inclusion, content, out, inner);
        }
        self.drop_comments(out, has_next);
        self.splice(content, out);
    }

    fn include_file(&mut self, name: &str, inclusion: &Inclusion, content: XId, parent: XId, cx: Cx) {
        self.result.includes.push(name.to_owned());
        self.optional_includes.push(inclusion.optional);
        if let Some(file) = self.load(name, inclusion.at, inclusion.argument.as_ref())
            && !self.is_include_cycle(file, inclusion)
        {
            let conditions = self.conditions;
            self.conditions += u32::from(inclusion.computed);
            self.open_files.push(OpenFile { name: name.to_owned(), file: Some(file), conditions });
            let frame = self.push_frame(FrameKind::Include, name.into(), inclusion.tag, None);
            let root = self.container(inclusion.tag);
            self.eval_included(file, root, Cx { frame, ..cx });
            if !self.unwinding {
                self.lift_namespaces(root, parent, cx);
                self.result.tree.move_children(root, content);
            }
            self.open_files.pop();
            self.conditions = conditions;
        }
        self.optional_includes.pop();
        if inclusion.optional {
            // a missing file somewhere inside undoes what this include would have contributed
            self.unwinding = false;
        }
    }

    fn eval_included(&mut self, file: FileIdx, root: XId, cx: Cx) {
        let Some(used) = self.result.files.get(file.0 as usize) else { return };
        let (document, header) = (used.source.document.clone(), used.first_source);
        if let Some(node) = document.root() {
            self.eval_attributes(Tag { node, src: header, name: node.name(), used: &[] }, root, cx);
        }
        self.eval_root_content(file, root, cx);
    }

    /// The scopes an included file is evaluated in: those of `ns=`, or the includer's.
    fn include_scope(&mut self, tag: Tag<'_>, cx: Cx) -> Cx {
        let Some((text, place)) = self.attr(tag, "ns", cx).filter(|(text, _)| !text.is_empty()) else {
            return cx;
        };
        let value = self.eval_text(&text, place, cx.scope);
        if let Value::List(_) | Value::Dict(_) | Value::Set(_) = value {
            let shown = display::repr(&value).unwrap_or_default();
            let message = format!("namespace `ns` is {shown}, which is not a string");
            self.error("XAC025", place.origin, message, "namespaces are supported with in-order option only");
            return cx;
        }
        let Some(name) = display::to_str(&value) else { return cx };
        let macros = self.macros.push(None);
        let scope = self.scopes.push(cx.scope, true);
        self.macros.define_namespace(cx.macros, name.clone(), macros);
        let definition = self.define(SymbolKind::Namespace, &name, place.origin);
        let info = BindingInfo::new(name.clone(), BindingKind::Namespace, place.origin).of(definition);
        self.bind(cx.scope, name, State::Ready(Value::Scope(scope)), info, place.origin);
        Cx { scope, macros, ..cx }
    }

    /// `optional=`, which is not evaluated. `None`: it is neither true nor false.
    fn optional_flag(&mut self, tag: Tag<'_>, cx: Cx) -> Option<bool> {
        let Some((text, place)) = self.attr(tag, "optional", cx) else { return Some(false) };
        let truth = literal::boolean(&Value::Str(text.as_ref().into()));
        if truth.is_none() {
            let message = format!("`optional` is `{text}`, which is not a boolean");
            let reference = format!(
                "Xacro conditional \"None\" evaluated to \"{text}\", which is not a boolean expression."
            );
            let problem = self
                .problem("XAC027", place.origin, message)
                .says(reference)
                .help("write `true` or `false`; expressions are not evaluated in `optional`");
            self.push(problem);
        }
        truth
    }

    fn warn_about_children(&mut self, tag: Tag<'_>, cx: Cx) {
        let Some(child) = tag.node.children().find(|n| n.kind() == NodeKind::Element) else { return };
        let name = child.name_range();
        let range = TextRange::new(name.start.saturating_sub(1), name.end);
        let at = Origin { src: tag.src, range, frame: cx.frame };
        let message = "child elements of `xacro:include` are ignored";
        self.warn("XAC033", at, message, "Child elements of a <xacro:include> tag are ignored");
    }

    /// A relative name joined to the folder of the file processed now, as it will be printed.
    pub fn absolute_name(&self, name: &str) -> String {
        let name = HERE.slashed(name);
        if !HERE.root(&name).is_empty() {
            return name.into_owned();
        }
        match self.current_file().rsplit_once('/').map(|(folder, _)| (folder, folder.trim_end_matches('/'))) {
            // as Python's `dirname`: slashes at the end go, except when there is nothing else
            Some((folder, "")) => format!("{folder}/{name}"),
            Some((_, folder)) => format!("{folder}/{name}"),
            None => name.into_owned(),
        }
    }

    /// The path of a name in the file system.
    pub fn file_path(&self, name: &str) -> PathBuf {
        let root = self.request.root_dir.as_deref().unwrap_or("");
        self.world.env.cwd.join(root).join(name)
    }

    fn included_names(&mut self, name: &EcoString, at: Origin) -> Vec<String> {
        let name = self.absolute_name(name);
        if !name.contains(['*', '?', '[']) {
            return vec![name];
        }
        let found = match self.world.vfs.glob(&name, &self.world.env.cwd, &mut self.glob_entries) {
            Ok(found) => found,
            Err(why) => {
                self.matches_too_much(&name, why, at);
                return Vec::new();
            }
        };
        self.result.record.add(Read::Glob(name.clone(), found.clone()));
        if found.is_empty() {
            let message = format!("no files match `{name}`");
            let reference = format!("Include tag's filename spec \"{name}\" matched no files.");
            self.warn("XAC035", at, message, reference);
        }
        found.iter().map(|path| slashed(path)).collect()
    }

    /// None of the files is included. What matches is not part of the record either: to ask again whether it still is too
    /// much would cost as much as it did now.
    fn matches_too_much(&mut self, name: &str, why: TooMany, at: Origin) {
        self.include_missing = true;
        self.result.complete = false;
        let message = match why {
            TooMany::Files => {
                format!("`{name}` matches more than {GLOB_FILES} files, the limit for one include")
            }
            TooMany::Entries => format!(
                "too many folder entries to search for `{name}`: the limit for all includes of a robot is {GLOB_ENTRIES}"
            ),
        };
        let help = "write the folder and the common part of the file names; none of the files is included";
        let problem = self.problem("XAC034", at, message).help(help);
        self.push(problem);
    }

    /// Load a file for the include (or the request) at `at`; reports why it cannot be; `argument` is
    /// one that callers give and that the name is computed from.
    pub fn load(&mut self, name: &str, at: Origin, argument: Option<&EcoString>) -> Option<FileIdx> {
        let path = self.file_path(name);
        let (path, loaded) = match self.world.vfs.document(&path) {
            Err(error) if error.kind == LoadErrorKind::NotFound && at != Origin::NOWHERE => {
                match self.built(&path) {
                    Some(built) if built.is_template && has_placeholders(&self.world, &built.path) => {
                        self.generated(name, &built.path, at);
                        return None;
                    }
                    Some(built) => {
                        let loaded = self.world.vfs.document(&built.path);
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
                if let Some(&file) = self.by_path.get(&source.path) {
                    return Some(file);
                }
                let file = FileIdx(self.result.files.len() as u32);
                self.by_path.insert(source.path.clone(), file);
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
        let World { vfs, packages, .. } = self.world;
        self.result.record.add(Read::Missing(path.to_owned()));
        for file in packages.build_around(path).iter().flat_map(|build| &build.files) {
            self.result.record.add(match vfs.document_hash(file) {
                Some(hash) => Read::File(file.clone(), hash),
                None => Read::Missing(file.clone()),
            });
        }
        packages.built(path)
    }

    /// The content of a file is known to the build only.
    fn generated(&mut self, name: &str, template: &Path, at: Origin) {
        self.include_missing = true;
        self.result.complete = false;
        if self.optional_includes.iter().any(|&optional| optional) {
            return;
        }
        let message =
            format!("included file `{name}` is generated from `{}` at build time", slashed(template));
        let problem = self.problem("XAC008", at, message).excused();
        self.push(problem.help("build the package to generate the file; definitions in it are not checked"));
    }

    /// The reference reads every file as UTF-8.
    fn report_encoding(&mut self, file: FileIdx, source: &SourceFile) {
        let Some((offset, message)) = &source.encoding_error else { return };
        let range = TextRange::empty((*offset).min(source.document.len()));
        let place = super::Place { file, range };
        let byte =
            message.strip_prefix("'utf-8' codec can't decode ").and_then(|rest| rest.split(": ").next());
        let said = format!("file is not valid UTF-8: {}", byte.unwrap_or(message));
        let problem = super::Problem::new("XML016", place, said);
        self.push(problem.says(message.clone()).help("save the file as UTF-8"));
    }

    fn add_sources(&mut self, file: FileIdx, name: &str, source: &Arc<SourceFile>) {
        let first_source = SrcId(self.result.sources.len() as u32);
        let document = &source.document;
        let footer_base = document.len() - document.footer().text().len() as u32;
        let header = Source { file, item: document.header().clone(), base: 0 };
        let items = document.items().map(|(base, item)| Source { file, item: item.clone(), base });
        let footer = Source { file, item: document.footer().clone(), base: footer_base };
        self.result.sources.push(header);
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

    fn not_loaded(&mut self, name: &str, error: LoadError, at: Origin, argument: Option<&EcoString>) {
        if at == Origin::NOWHERE {
            self.result.root_error = Some(error);
            self.result.complete = false;
            return;
        }
        let missing_is_fine = self.optional_includes.iter().any(|&optional| optional);
        if missing_is_fine && matches!(error.kind, LoadErrorKind::NotFound | LoadErrorKind::IsDirectory) {
            // undo everything up to the optional include; only a nested file has anything to undo
            self.unwinding = self.optional_includes.last() != Some(&true);
            return;
        }
        self.include_missing = true;
        self.result.complete = false;
        let shown =
            if HERE.is_absolute(name) { name.to_owned() } else { format!("{}/{name}", self.root_name()) };
        let LoadError { strerror, errno, .. } = &error;
        let message = match error.kind {
            LoadErrorKind::NotFound => format!("included file `{name}` not found"),
            LoadErrorKind::IsDirectory => format!("included file `{name}` is a folder"),
            _ => format!("included file `{name}` cannot be read: {}", error.reason()),
        };
        let help = match error.kind {
            LoadErrorKind::TooLarge { .. } => raise("file-mb"),
            _ => format!("correct the path, or add the file: {}", slashed(&error.path)),
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
        let message = match is_other {
            true => format!("included file `{}` not found", self.text_of(at)),
            false => message,
        };
        let problem = self
            .problem("XAC008", at, message)
            .says(format!("{strerror}: {shown} [Errno {errno}] {strerror}: '{shown}'"))
            .depends_on(argument.cloned().map_or(Outside::File, Outside::Argument))
            .help(help);
        let problem = super::Problem { detail: path, ..problem };
        let problem =
            match error.kind == LoadErrorKind::NotFound && self.world.packages.may_be_made(&error.path) {
                true => problem.excused().help("build the package to generate the file, or correct the path"),
                false => problem,
            };
        self.push(match meant {
            Some(meant) => meant.said_of(problem),
            None => problem,
        });
    }

    fn root_name(&self) -> &str {
        self.request.root_dir.as_deref().unwrap_or(".")
    }

    /// One finding a file that is not well-formed; what its recovered tree seems to say is not trusted.
    fn report_syntax(&mut self, file: FileIdx, include: Origin) {
        let Some(used) = self.result.files.get(file.0 as usize) else { return };
        let (document, base) = (used.source.document.clone(), used.first_source);
        let errors = document.errors();
        let Some(first) = errors.iter().min_by_key(|e| e.expat_offset) else { return };
        self.broken.insert(file);
        if self.result.files.len() > 1 {
            self.include_missing = true;
        }
        let position = document.line_col(first.expat_offset, base::Encoding::Utf32);
        let at = Origin { src: base, range: first.range, frame: super::FrameId::ROOT };
        let mut problem = self.syntax_problem(first, at, file);
        if let Some(place) = self.result.place(include) {
            problem.trace.push(super::Step { place, message: "included here".to_owned() });
            problem.trace.extend(self.problem("XML001", include, "").trace);
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

    fn syntax_problem(&self, error: &SyntaxError, at: Origin, file: FileIdx) -> super::Problem {
        let place = |range| super::Place { file, range };
        let xacro = error.kind == SyntaxErrorKind::UnboundPrefix && error.message.contains("xacro");
        let code = if xacro { "XML002" } else { "XML001" };
        let mut problem = self.problem(code, at, error.headline());
        problem.place = place(error.range);
        problem = problem.help(match xacro {
            true => "add xmlns:xacro=\"http://www.ros.org/wiki/xacro\" to the root element",
            false => error.help(),
        });
        if let Some((range, what)) = error.related {
            problem.trace.push(super::Step { place: place(range), message: what.to_owned() });
        }
        problem
    }

    /// Whether including `file` once more can never end; reports it.
    fn is_include_cycle(&mut self, file: FileIdx, inclusion: &Inclusion) -> bool {
        let most = self.request.limits.include_depth;
        let open = self.open_files.iter().rev().find(|f| f.file == Some(file));
        let endless = open.is_some_and(|f| f.conditions == self.conditions && !inclusion.computed);
        let undecided = open.is_some() && self.unknown_conditions > 0;
        if !endless && !undecided && (self.open_files.len() as u32) < most {
            return false;
        }
        self.result.complete = false;
        self.content_lost = true;
        if undecided {
            // whether to go on cannot be known, so the recursion ends here
            return true;
        }
        let chain: Vec<&str> = self.open_files.iter().map(|f| f.name.as_str()).collect();
        let name = self.result.files.get(file.0 as usize).map_or("", |f| f.name.as_str());
        if endless {
            let start = self.open_files.iter().position(|f| f.file == Some(file)).unwrap_or(0);
            let chain = chain.get(start..).unwrap_or_default().join("` -> `");
            let message = format!("`{name}` includes itself: `{chain}` -> `{name}`");
            let problem =
                self.problem("XAC009", inclusion.tag, message).says("maximum recursion depth exceeded");
            self.push(problem);
        } else {
            let message = format!("includes are nested more than {most} levels deep: `{name}`");
            self.stop(inclusion.tag, message, Some("include-depth"));
        }
        true
    }
}

/// Whether a file name may read otherwise the next time. Packages and the environment stay what they are.
fn is_computed(text: &str) -> bool {
    text.contains("${") || text.contains("$(arg") || text.contains("$(eval")
}

/// Whether a template has places that the build fills in: `@NAME@`, or those of a template language.
fn has_placeholders(world: &World<'_>, template: &Path) -> bool {
    let Ok(file) = world.vfs.text(template) else { return true };
    let is_name = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '_');
    let mut parts = file.text.split('@').skip(1);
    ["@(", "{{", "{%"].iter().any(|sign| file.text.contains(sign)) || parts.any(is_name)
}
