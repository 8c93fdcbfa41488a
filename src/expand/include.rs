//! `xacro:include`, and loading files.
use std::path::PathBuf;

use ecow::EcoString;

use super::binding_info::{BindingInfo, BindingKind};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::names::EvalContext;
use super::node::XId;
use super::origin::{FileIdx, FrameKind, Origin};
use super::record::Read;
use super::scope::PropertyState;
use super::state::IncludeFrame;
use super::symbols::SymbolKind;
use super::tag::Tag;
use base::TextRange;
use base::limits::{GLOB_ENTRIES, GLOB_FILES};
use base::paths::HERE;
use expr::{Value, display, literal};
use vfs::{TooMany, slashed};
use xml::NodeKind;

/// What every tag of an include knows.
#[derive(Clone)]
struct IncludeTag {
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
    pub fn include(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        self.note_unclear();
        let Some((text, place)) = self.required_attr(tag, "filename", cx) else {
            return;
        };
        self.check_attrs(tag, &["filename", "ns", "optional"], cx);
        let inner = self.include_scope(tag, cx);
        let Some(optional) = self.optional_flag(tag, cx) else {
            return;
        };
        self.warn_about_children(tag, cx);
        let mark = self.names.reads.len();
        let value = self.eval_text(&text, place, cx.scope);
        let argument = self.empty_argument(mark);
        self.names.reads.truncate(mark);
        let Some(name) = display::to_str(&value) else {
            self.gaps.include_missing = true;
            self.result.complete = false;
            return;
        };
        let names = self.included_names(&name, place.origin);
        let inclusion = IncludeTag {
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

    fn include_file(
        &mut self,
        name: &str,
        inclusion: &IncludeTag,
        content: XId,
        parent: XId,
        cx: EvalContext,
    ) {
        self.result.includes.push(name.to_owned());
        self.files.optional_includes.push(inclusion.optional);
        if let Some(file) = self.load(name, inclusion.at, inclusion.argument.as_ref())
            && !self.is_include_cycle(file, inclusion)
        {
            let conditions = self.flow.conditions;
            self.flow.conditions += u32::from(inclusion.computed);
            self.files.open.push(IncludeFrame {
                name: name.to_owned(),
                file: Some(file),
                conditions,
            });
            let frame = self.push_frame(FrameKind::Include, name.into(), inclusion.tag, None);
            let root = self.container(inclusion.tag);
            self.eval_included(file, root, EvalContext { frame, ..cx });
            if !self.flow.unwinding {
                self.lift_namespaces(root, parent, cx);
                self.result.tree.move_children(root, content);
            }
            self.files.open.pop();
            self.flow.conditions = conditions;
        }
        self.files.optional_includes.pop();
        if inclusion.optional {
            // a missing file somewhere inside undoes what this include would have contributed
            self.flow.unwinding = false;
        }
    }

    fn eval_included(&mut self, file: FileIdx, root: XId, cx: EvalContext) {
        let Some(used) = self.result.files.get(file) else {
            return;
        };
        let (document, header) = (used.source.document.clone(), used.first_source);
        if let Some(node) = document.root() {
            self.eval_attributes(
                Tag {
                    node,
                    src: header,
                    name: node.name(),
                    used: &[],
                },
                root,
                cx,
            );
        }
        self.eval_root_content(file, root, cx);
    }

    /// The scopes an included file is evaluated in: those of `ns=`, or the includer's.
    fn include_scope(&mut self, tag: Tag<'_>, cx: EvalContext) -> EvalContext {
        let Some((text, place)) = self
            .attr(tag, "ns", cx)
            .filter(|(text, _)| !text.is_empty())
        else {
            return cx;
        };
        let value = self.eval_text(&text, place, cx.scope);
        if let Value::List(_) | Value::Dict(_) | Value::Set(_) = value {
            let shown = display::repr(&value).unwrap_or_default();
            let message = format!("namespace `ns` is {shown}, which is not a string");
            self.error(
                ProblemKind::ExpressionError,
                place.origin,
                message,
                "namespaces are supported with in-order option only",
            );
            return cx;
        }
        let Some(name) = display::to_str(&value) else {
            return cx;
        };
        self.steps.journal.is_lost = true;
        let macros = self.names.macros.push(None);
        let scope = self.names.scopes.push(cx.scope, true);
        self.names
            .macros
            .define_namespace(cx.macros, name.clone(), macros);
        let definition = self.define(SymbolKind::Namespace, &name, place.origin);
        let info =
            BindingInfo::new(name.clone(), BindingKind::Namespace, place.origin).of(definition);
        self.bind(
            cx.scope,
            name,
            PropertyState::Ready(Value::Scope(scope)),
            info,
            place.origin,
        );
        EvalContext {
            scope,
            macros,
            ..cx
        }
    }

    /// `optional=`, which is not evaluated. `None`: it is neither true nor false.
    fn optional_flag(&mut self, tag: Tag<'_>, cx: EvalContext) -> Option<bool> {
        let Some((text, place)) = self.attr(tag, "optional", cx) else {
            return Some(false);
        };
        let truth = literal::boolean(&Value::Str(text.as_ref().into()));
        if truth.is_none() {
            let message = format!("`optional` is `{text}`, which is not a boolean");
            let reference = format!(
                "Xacro conditional \"None\" evaluated to \"{text}\", which is not a boolean expression."
            );
            let problem = self
                .problem(ProblemKind::InvalidCondition, place.origin, message)
                .says(reference)
                .help("write `true` or `false`; expressions are not evaluated in `optional`");
            self.push(problem);
        }
        truth
    }

    fn warn_about_children(&mut self, tag: Tag<'_>, cx: EvalContext) {
        let Some(child) = tag.node.children().find(|n| n.kind() == NodeKind::Element) else {
            return;
        };
        let name = child.name_range();
        let range = TextRange::new(name.start.saturating_sub(1), name.end);
        let at = Origin {
            src: tag.src,
            range,
            frame: cx.frame,
        };
        let message = "child elements of `xacro:include` are ignored";
        self.warn(
            ProblemKind::IncludeChildrenIgnored,
            at,
            message,
            "Child elements of a <xacro:include> tag are ignored",
        );
    }

    /// A relative name joined to the folder of the file processed now, as it will be printed.
    pub fn absolute_name(&self, name: &str) -> String {
        let name = HERE.slashed(name);
        if !HERE.root(&name).is_empty() {
            return name.into_owned();
        }
        match self
            .current_file()
            .rsplit_once('/')
            .map(|(folder, _)| (folder, folder.trim_end_matches('/')))
        {
            // as Python's `dirname`: slashes at the end go, except when there is nothing else
            Some((folder, "")) => format!("{folder}/{name}"),
            Some((_, folder)) => format!("{folder}/{name}"),
            None => name.into_owned(),
        }
    }

    /// The path of a name in the file system.
    pub fn file_path(&self, name: &str) -> PathBuf {
        let root = self.request.root_dir.as_deref().unwrap_or("");
        self.sources.env.cwd.join(root).join(name)
    }

    fn included_names(&mut self, name: &EcoString, at: Origin) -> Vec<String> {
        let name = self.absolute_name(name);
        if !name.contains(['*', '?', '[']) {
            return vec![name];
        }
        let found =
            match self
                .sources
                .vfs
                .glob(&name, &self.sources.env.cwd, &mut self.files.glob_entries)
            {
                Ok(found) => found,
                Err(why) => {
                    self.matches_too_much(&name, why, at);
                    return Vec::new();
                }
            };
        self.result
            .record
            .add(Read::Glob(name.clone(), found.clone()));
        if found.is_empty() {
            let message = format!("no files match `{name}`");
            let reference = format!("Include tag's filename spec \"{name}\" matched no files.");
            self.warn(ProblemKind::GlobIncludeNoMatch, at, message, reference);
        }
        found.iter().map(|path| slashed(path)).collect()
    }

    /// None of the files is included. What matches is not part of the record either: to ask again whether it still is too
    /// much would cost as much as it did now.
    fn matches_too_much(&mut self, name: &str, why: TooMany, at: Origin) {
        self.gaps.include_missing = true;
        self.result.complete = false;
        let message = match why {
            TooMany::Files => {
                format!("`{name}` matches more than {GLOB_FILES} files, the limit for one include")
            }
            TooMany::Entries => format!(
                "too many folder entries to search for `{name}`: the limit for all includes of a robot is {GLOB_ENTRIES}"
            ),
        };
        let help =
            "write the folder and the common part of the file names; none of the files is included";
        let problem = self
            .problem(ProblemKind::InfiniteMacroRecursion, at, message)
            .help(help);
        self.push(problem);
    }

    /// Whether including `file` once more can never end; reports it.
    fn is_include_cycle(&mut self, file: FileIdx, inclusion: &IncludeTag) -> bool {
        let most = self.request.limits.include_depth;
        let open = self.files.open.iter().rev().find(|f| f.file == Some(file));
        let endless =
            open.is_some_and(|f| f.conditions == self.flow.conditions && !inclusion.computed);
        let undecided = open.is_some() && self.flow.unknown_conditions > 0;
        if !endless && !undecided && (self.files.open.len() as u32) < most {
            return false;
        }
        self.result.complete = false;
        self.gaps.content_lost = true;
        if undecided {
            // whether to go on cannot be known, so the recursion ends here
            return true;
        }
        let chain: Vec<&str> = self.files.open.iter().map(|f| f.name.as_str()).collect();
        let name = self.result.files.get(file).map_or("", |f| f.name.as_str());
        if endless {
            let start = self
                .files
                .open
                .iter()
                .position(|f| f.file == Some(file))
                .unwrap_or(0);
            let chain = chain.get(start..).unwrap_or_default().join("` -> `");
            let message = format!("`{name}` includes itself: `{chain}` -> `{name}`");
            let problem = self
                .problem(ProblemKind::IncludeCycle, inclusion.tag, message)
                .says("maximum recursion depth exceeded");
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
