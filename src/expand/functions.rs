//! What expressions can reach: names, and the functions of `xacro.`.
use std::path::{Path, PathBuf};

use ecow::EcoString;

use super::expander::Expander;
use super::kind::ProblemKind;
use super::record::Read;
use super::split_text::CodeSite;
use super::state::IncludeFrame;
use super::symbols::UseKind;
use super::yaml_value::file_value;
use base::TextRange;
use expr::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId, Value, display, literal};
use vfs::{LoadError, LoadErrorKind, YamlFile};
use yaml::{YamlError, YamlKind, YamlNode};

/// The host of one expression.
pub(super) struct ExprHost<'m, 'w, 't> {
    pub expander: &'m mut Expander<'w>,
    pub scope: ScopeId,
    pub at: CodeSite<'t>,
}

impl Host for ExprHost<'_, '_, '_> {
    fn lookup(&mut self, name: &str, range: TextRange) -> Lookup {
        let at = self.expander.origin_of(self.at, range);
        match self.expander.resolve(self.scope, name, at) {
            Some(value) => Lookup::Found(value),
            None => Lookup::Missing,
        }
    }

    fn scope_attribute(&mut self, scope: ScopeId, name: &str, range: TextRange) -> Lookup {
        if name == "depth" && self.expander.names.scopes.get(scope).is_namespace {
            // the reference answers with a counter of its own, whatever the file defines
            return Lookup::Found(Value::Int(self.expander.names.scopes.depth(scope)));
        }
        let at = self.expander.origin_of(self.at, range);
        match self.expander.resolve(scope, name, at) {
            Some(value) => Lookup::Found(value),
            None => Lookup::Missing,
        }
    }

    fn scope_entries(&mut self, scope: ScopeId) -> Option<Vec<(EcoString, Value)>> {
        Some(self.expander.names.scopes.entries(scope))
    }

    fn scope_holds(&mut self, scope: ScopeId, name: &str) -> bool {
        self.expander.names.scopes.holder(scope, name).is_some()
    }

    fn current_scope(&self) -> Option<ScopeId> {
        Some(self.scope)
    }

    fn call(
        &mut self,
        function: HostFn,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        range: TextRange,
    ) -> Result<Value, EvalError> {
        match function {
            HostFn::LoadYaml => self.load_yaml(args, keywords, range),
            HostFn::AbsFilename => {
                let name = text_argument("abs_filename", "filename_spec", args, keywords)?;
                Ok(Value::Str(self.expander.absolute_name(&name).into()))
            }
            HostFn::Arg => self.arg(args, keywords, range),
            HostFn::Message => self.message("", args, keywords, false),
            HostFn::Warning => self.message("warning: ", args, keywords, true),
            HostFn::Error => self.message("error: ", args, keywords, true),
            HostFn::PrintLocation => {
                let location = self.location();
                self.expander.result.messages.extend(location);
                Ok(Value::Str(EcoString::new()))
            }
            HostFn::Fatal => {
                let text = joined(args).unwrap_or_default();
                Err(EvalError::new(ErrorKind::Xacro, text))
            }
            // no name of an expression stands for these
            HostFn::Env | HostFn::OptEnv | HostFn::Find | HostFn::Dirname => Ok(Value::Unknown),
        }
    }

    fn deprecated(&mut self, name: &str, namespace: &str, range: TextRange) {
        // the call begins with the name of what it calls
        let name_range = TextRange::new(range.start, range.start + name.len() as u32);
        let at = self.expander.origin_of(self.at, name_range);
        let message = format!("using `{name}()` directly is deprecated");
        let reference =
            format!("Using {name}() directly is deprecated. Use {namespace}.{name}() instead.");
        let problem = self
            .expander
            .problem(ProblemKind::DeprecatedBuiltinCall, at, message)
            .says(reference)
            .warning()
            .help(format!("write `{namespace}.{name}`"))
            .replace_with(format!("{namespace}.{name}"));
        self.expander.push(problem);
    }

    fn undefined(&mut self, name: &str, range: TextRange) {
        let at = self.expander.origin_of(self.at, range);
        let code = self.at.code;
        self.expander.undefined_property(self.scope, name, code, at);
    }
}

impl ExprHost<'_, '_, '_> {
    fn location(&self) -> Vec<String> {
        self.expander.location_lines(self.at.site.place.origin)
    }

    fn arg(
        &mut self,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        range: TextRange,
    ) -> Result<Value, EvalError> {
        let name = text_argument("<lambda>", "name", args, keywords)?;
        self.expander.note_argument(&name);
        match self.expander.names.args.get(&name) {
            Some((Some(value), info)) => {
                let (value, info) = (value.clone(), *info);
                self.expander.names.reads.push(info);
                let at = self.expander.origin_of(self.at, range);
                self.expander.note_read(at, info, UseKind::Read);
                Ok(Value::Str(value))
            }
            Some((None, _)) => Ok(Value::Unknown),
            None => {
                let at = self.expander.origin_of(self.at, range);
                self.expander
                    .result
                    .record
                    .add(Read::Arg(name.to_string(), None));
                self.expander.undefined_arg(&name, at, format!("'{name}'"));
                Ok(Value::Unknown)
            }
        }
    }

    fn message(
        &mut self,
        prefix: &str,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        located: bool,
    ) -> Result<Value, EvalError> {
        let Some(text) = joined(args) else {
            return Ok(Value::Unknown);
        };
        let located = keywords
            .iter()
            .find(|(name, _)| name == "print_location")
            .map_or(located, |(_, value)| {
                literal::truth(value).unwrap_or(located)
            });
        self.expander
            .result
            .messages
            .push(format!("{prefix}{text}"));
        if located {
            let location = self.location();
            self.expander.result.messages.extend(location);
        }
        Ok(Value::Str(EcoString::new()))
    }

    fn load_yaml(
        &mut self,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        range: TextRange,
    ) -> Result<Value, EvalError> {
        let name = text_argument("load_yaml", "filename", args, keywords)?;
        self.expander.note_unclear();
        let name = self.expander.absolute_name(&name);
        // load_yaml opens relative to the working directory, whatever --root-dir says
        let mut path: PathBuf = self.expander.sources.env.cwd.join(&name);
        let mut loaded = self.expander.sources.vfs.yaml(&path, &name);
        if loaded
            .as_ref()
            .is_err_and(|error| error.kind == LoadErrorKind::NotFound)
            && let Some(built) = self.expander.built(&path)
        {
            path = built.path;
            loaded = self.expander.sources.vfs.yaml(&path, &name);
        }
        let loaded = match loaded {
            Ok(loaded) => loaded,
            Err(error) => {
                self.expander.result.record.add(Read::Missing(path));
                return self.unreadable(&name, &error);
            }
        };
        self.expander
            .result
            .record
            .add(Read::File(path, loaded.file.hash));
        self.expander.files.open.push(IncludeFrame {
            name: name.clone(),
            file: None,
            conditions: u32::MAX,
        });
        let value = match &loaded.value {
            value if is_telling(value) && self.is_foreign(&loaded.file.path) => {
                Err(refused(&name, &loaded))
            }
            Ok(node) => file_value(node, &mut self.expander.guards.budget),
            Err(error) => Err(EvalError::new(ErrorKind::Value, error.message.clone()).at(range)),
        };
        self.expander.files.open.pop();
        self.expander.result.includes.push(name);
        value
    }

    /// Whether a file does not belong to the robot.
    fn is_foreign(&self, path: &Path) -> bool {
        let Expander {
            sources, request, ..
        } = &self.expander;
        let root = self.expander.file_path(&request.file);
        !sources.packages.around([&*root]).hold(path)
    }

    fn unreadable(&mut self, name: &str, error: &LoadError) -> Result<Value, EvalError> {
        let missing_is_fine = self
            .expander
            .files
            .optional_includes
            .iter()
            .any(|&optional| optional);
        if missing_is_fine && self.expander.names.lazy_uses.is_empty() {
            self.expander.flow.unwinding = true;
            return Ok(Value::Unknown);
        }
        let LoadError {
            errno, strerror, ..
        } = error;
        Err(EvalError::new(
            ErrorKind::Io,
            format!("[Errno {errno}] {strerror}: '{name}'"),
        ))
    }
}

/// Whether a loaded file is one bare text, as any key, token or table of passwords reads as YAML; or none that can be
/// loaded, where the error may quote it.
fn is_telling(value: &Result<YamlNode, YamlError>) -> bool {
    !matches!(value, Ok(node) if !matches!(node.kind, YamlKind::Str(_)))
}

/// Why such a file is not loaded from outside of the robot. Its text is not quoted: the message may stand in a public log.
fn refused(name: &str, loaded: &YamlFile) -> EvalError {
    const OUTSIDE: &str = "outside the packages and folders of this robot";
    let text = loaded.file.text.as_bytes();
    let message = match &loaded.value {
        Ok(_) => format!("`{name}` is not loaded: it is a single string and {OUTSIDE}"),
        Err(error) => {
            let before = text.get(..error.range.start as usize).unwrap_or(text);
            let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
            format!(
                "`{name}` is not valid YAML at line {line}; it is {OUTSIDE}, so its text is not shown"
            )
        }
    };
    EvalError::new(ErrorKind::Xacro, message)
}

/// The only argument of a function, as text.
pub(super) fn text_argument(
    function: &str,
    name: &str,
    args: &[Value],
    keywords: &[(EcoString, Value)],
) -> Result<EcoString, EvalError> {
    let value = match (args, keywords) {
        ([value], []) => value,
        ([], [(keyword, value)]) if keyword == name => value,
        ([], []) => {
            let message = format!("{function}() missing 1 required positional argument: '{name}'");
            return Err(EvalError::new(ErrorKind::Type, message));
        }
        (args, _) => {
            let message = format!(
                "{function}() takes 1 positional argument but {} were given",
                args.len()
            );
            return Err(EvalError::new(ErrorKind::Type, message));
        }
    };
    match value {
        Value::Str(text) => Ok(text.clone()),
        Value::Unknown => Err(EvalError::new(ErrorKind::Reported, "")),
        other => {
            let kind = other.type_name();
            let message = format!("expected str, bytes or os.PathLike object, not {kind}");
            Err(EvalError::new(ErrorKind::Type, message))
        }
    }
}

/// Arguments joined by blanks; `None` when one of them is unknown.
fn joined(args: &[Value]) -> Option<String> {
    let texts: Option<Vec<_>> = args.iter().map(display::to_str).collect();
    Some(texts?.join(" "))
}
