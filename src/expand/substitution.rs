//! `$(...)`: arguments, packages, the environment.
use ecow::EcoString;

use super::expander::Expander;
use super::functions::text_argument;
use super::kind::ProblemKind;
use super::meant;
use super::origin::Origin;
use super::problem::Outside;
use super::record::Read;
use super::split_text::TextSite;
use super::symbols::UseKind;
use base::paths::HERE;
use base::{TextRange, counted};
use expr::{
    self, ErrorKind, EvalError, Host, HostFn, Lookup, Module, ScopeId, Subst, SubstArg, SubstError,
    Value, display, literal,
};
use packages::RosVariable;
use vfs::slashed;

/// Why a substitution has no value.
enum SubstFailure {
    /// Reported already.
    Reported,
    /// To be reported.
    Error(SubstError),
}

impl From<SubstError> for SubstFailure {
    fn from(error: SubstError) -> Self {
        SubstFailure::Error(error)
    }
}

/// A substitution in the text it stands in.
#[derive(Clone, Copy)]
struct SubstitutionSite<'t> {
    inner: &'t str,
    whole: TextRange,
    /// Where the inner text stands; none when it was put together at run time.
    start: Option<u32>,
    site: TextSite<'t>,
}

impl Expander<'_> {
    /// The value of `$(inner)`, which stands in `scope`; `whole` is its range, `static_inner` that of its content where that
    /// is literal. What was read for the content follows the first `mark` reads.
    pub fn substitute(
        &mut self,
        inner: &str,
        whole: TextRange,
        static_inner: Option<TextRange>,
        site: TextSite<'_>,
        (scope, mark): (ScopeId, usize),
    ) -> Value {
        let here = SubstitutionSite {
            inner,
            whole,
            start: static_inner.map(|range| range.start),
            site,
        };
        match expr::resolve_substitution(inner, |subst| self.substitution_text(subst, here)) {
            Ok(text) => Value::Str(text),
            Err(SubstFailure::Reported) => Value::Unknown,
            Err(SubstFailure::Error(error)) => {
                self.bad_substitution(&error, here, (scope, mark));
                Value::Unknown
            }
        }
    }

    fn substitution_text(
        &mut self,
        subst: &Subst,
        here: SubstitutionSite<'_>,
    ) -> Result<EcoString, SubstFailure> {
        match subst {
            Subst::Arg(name) => self.argument(name, here),
            Subst::Find(name) => self.package(name, here),
            Subst::Env(name) => self.environment(&name.text),
            Subst::OptEnv { name, default } => {
                Ok(self.env_var(&name.text).unwrap_or_else(|| default.clone()))
            }
            Subst::Cwd => {
                let root = self.file_path("");
                Ok(HERE.normalized(&root.to_string_lossy()).into())
            }
            Subst::Eval { code } => self.eval_substitution(code.slice(here.inner), here),
            _ => Ok(format!("$({})", here.inner).into()),
        }
    }

    fn argument(
        &mut self,
        name: &SubstArg,
        here: SubstitutionSite<'_>,
    ) -> Result<EcoString, SubstFailure> {
        self.note_argument(&name.text);
        match self.names.args.get(&name.text) {
            Some((Some(value), info)) => {
                let (value, info) = (value.clone(), *info);
                self.names.reads.push(info);
                self.note_read(self.word_origin(name, here), info, UseKind::Read);
                Ok(value)
            }
            Some((None, _)) => Err(SubstFailure::Reported),
            None => {
                let at = self.word_origin(name, here);
                self.result
                    .record
                    .add(Read::Arg(name.text.to_string(), None));
                self.undefined_arg(
                    &name.text,
                    at,
                    format!("Undefined substitution argument {}", name.text),
                );
                Err(SubstFailure::Reported)
            }
        }
    }

    fn package(
        &mut self,
        name: &SubstArg,
        here: SubstitutionSite<'_>,
    ) -> Result<EcoString, SubstFailure> {
        let at = self.word_origin(name, here);
        let from = self
            .result
            .sources
            .get(at.src)
            .and_then(|s| self.result.files.get(s.file))
            .map_or_else(
                || self.sources.env.cwd.clone(),
                |f| f.source.path.to_path_buf(),
            );
        match self.sources.packages.find(&name.text, &from) {
            Ok(found) => {
                self.note_package(&name.text, &from, Some(&found.path));
                self.result.record.add(Read::Package(
                    name.text.to_string(),
                    Some(found.path.clone()),
                ));
                Ok(slashed(&found.path).into())
            }
            Err(missing) => {
                self.note_package(&name.text, &from, None);
                self.result
                    .record
                    .add(Read::Package(name.text.to_string(), None));
                let places: Vec<String> = missing
                    .tried
                    .iter()
                    .map(|(_, p)| format!("'{}'", slashed(p)))
                    .collect();
                let text = format!(
                    "\"package '{}' not found, searching: [{}]\"",
                    name.text,
                    places.join(", ")
                );
                let reference = format!(
                    "<class 'ament_index_python.packages.PackageNotFoundError'>: {text} {text}"
                );
                let message = format!(
                    "package `{}` not found (searched {})",
                    name.text,
                    counted(places.len(), "folder")
                );
                let mut problem = self
                    .problem(ProblemKind::PackageNotFound, at, message)
                    .says(reference)
                    .depends_on(Outside::File);
                problem = match self.sources.packages.meant(&name.text, &from) {
                    Some(near) => {
                        problem.help(format!("did you mean `{near}`?")).replace_with(near)
                    }
                    None => problem.help(
                        "source its workspace, or pass its folder with --package-path (or set `package-path` in xacro-lint.toml)"
                    ),
                };
                self.push(problem);
                Err(SubstFailure::Reported)
            }
        }
    }

    /// The value of an environment variable that must be set.
    fn environment(&mut self, name: &str) -> Result<EcoString, SubstFailure> {
        match self
            .env_var(name)
            .map(Some)
            .or_else(|| self.ros_variable(name))
        {
            Some(value) => value.ok_or(SubstFailure::Reported),
            None => {
                let message = format!("environment variable '{name}' is not set");
                Err(SubstFailure::Error(SubstError::new(message)))
            }
        }
    }

    fn env_var(&mut self, name: &str) -> Option<EcoString> {
        let value = self.sources.env.var(name).map(EcoString::from);
        self.result.record.add(Read::Env(
            name.to_owned(),
            value.as_ref().map(EcoString::to_string),
        ));
        value
    }

    /// What a shell in which ROS was sourced has in a variable that is not set here; `Some(None)`: one of several values.
    fn ros_variable(&mut self, name: &str) -> Option<Option<EcoString>> {
        self.note_unclear();
        if !self.request.ros_shell {
            return None;
        }
        let root = self.file_path(&self.request.file);
        match self.sources.packages.ros_variable(name, &root)? {
            RosVariable::Value(value) => Some(Some(value.into())),
            RosVariable::Unknown => {
                self.gaps.guessed = true;
                Some(None)
            }
        }
    }

    /// `$(eval code)`: arguments are its variables.
    fn eval_substitution(
        &mut self,
        code: &str,
        here: SubstitutionSite<'_>,
    ) -> Result<EcoString, SubstFailure> {
        let parsed = expr::parse(code);
        if let Some(error) = parsed.errors.first() {
            let error = SubstError {
                class: "SyntaxError",
                message: error.reference.clone(),
            };
            return Err(SubstFailure::Error(error));
        }
        let mut budget = self.guards.budget.clone();
        let mut host = ArgHost {
            expander: self,
            here,
            undefined: None,
            failed: None,
        };
        let value = expr::evaluate(&parsed.expr, &mut host, &mut budget);
        let (undefined, failed) = (host.undefined.take(), host.failed.take());
        self.guards.budget.steps = self.guards.budget.steps.min(budget.steps);
        self.guards.budget.bytes = self.guards.budget.bytes.min(budget.bytes);
        if let Some(failure) = failed {
            return Err(failure);
        }
        if let Some(name) = undefined {
            let message = format!("name '{name}' is not defined");
            return Err(SubstFailure::Error(SubstError {
                class: "NameError",
                message,
            }));
        }
        match value {
            Ok(value) => display::to_str(&value).ok_or(SubstFailure::Reported),
            Err(error) => Err(SubstFailure::Error(SubstError {
                class: class_of(&error),
                message: error.message,
            })),
        }
    }

    fn bad_substitution(
        &mut self,
        error: &SubstError,
        here: SubstitutionSite<'_>,
        (scope, mark): (ScopeId, usize),
    ) {
        let at = self.origin_in(here.site, here.whole);
        let SubstError { class, message } = error;
        let inner = here.inner.trim();
        let is_unknown = message.starts_with("Unknown substitution command");
        let said = match inner.split_whitespace().next().filter(|_| is_unknown) {
            Some(word) => format!("unknown substitution command `{word}` in `$({inner})`"),
            None => format!(
                "cannot evaluate `$({inner})`: {}",
                message.trim_end_matches('.')
            ),
        };
        let mut problem = self
            .problem(ProblemKind::ExpressionError, at, said)
            .says(format!("<class '{class}'>: {message} {message}"));
        if inner.starts_with("env ") {
            problem = problem.depends_on(Outside::Environment);
        } else if let Some(argument) = self.empty_argument(mark) {
            problem = problem.depends_on(Outside::Argument(argument));
        }
        if let Some(package) = inner.strip_prefix("find-pkg-share ") {
            let find = format!("$(find {})", package.trim());
            problem = problem
                .help(format!(
                    "write `{find}`; `find-pkg-share` works only in launch files"
                ))
                .replace_with(find);
        } else if inner == "dirname" {
            problem = problem.help(
                "remove `$(dirname)/`; relative paths are relative to the file that contains them",
            );
        } else if is_unknown {
            let is_property = self.names.scopes.find(scope, inner).is_some();
            problem = match meant::by_round_brackets(inner, is_property, self.names.args.contains_key(inner)) {
                Some(meant) => meant.said_of(problem),
                None => problem.help("use $(find PACKAGE), $(arg NAME), $(env NAME), $(optenv NAME DEFAULT) or $(eval EXPRESSION)"),
            };
        }
        self.push(problem);
    }

    fn word_origin(&self, word: &SubstArg, here: SubstitutionSite<'_>) -> Origin {
        let inside = here
            .start
            .filter(|_| word.range.slice(here.inner) == word.text);
        let range = inside.map_or(here.whole, |start| word.range.shift(start));
        self.origin_in(here.site, range)
    }
}

/// Python's name of an error's class.
fn class_of(error: &EvalError) -> &'static str {
    use expr::ErrorKind as Kind;
    match error.kind {
        Kind::Name => "NameError",
        Kind::Syntax => "SyntaxError",
        Kind::Type => "TypeError",
        Kind::ZeroDivision => "ZeroDivisionError",
        Kind::Overflow => "OverflowError",
        Kind::Index => "IndexError",
        Kind::Key | Kind::YamlKey => "KeyError",
        Kind::Attribute => "AttributeError",
        Kind::Recursion => "RecursionError",
        _ => "ValueError",
    }
}

/// The names of `$(eval)`: its functions, `math`, and arguments, converted by their looks.
struct ArgHost<'m, 'w, 't> {
    expander: &'m mut Expander<'w>,
    here: SubstitutionSite<'t>,
    undefined: Option<String>,
    /// Why the first call of a function has no value.
    failed: Option<SubstFailure>,
}

impl ArgHost<'_, '_, '_> {
    /// A function or type of Python that needs no import. Nothing else of the reference's own can be reached.
    fn python_symbol(&mut self, name: &str) -> Lookup {
        let found = expr::module_symbol(Module::Python, name).unwrap_or_else(|| {
            self.undefined.get_or_insert_with(|| name.to_owned());
            Value::Unknown
        });
        Lookup::Found(found)
    }

    fn function(
        &mut self,
        function: HostFn,
        args: &[Value],
        keywords: &[(EcoString, Value)],
    ) -> Result<Result<Value, SubstFailure>, EvalError> {
        Ok(match function {
            HostFn::Arg => {
                let name = text_argument("_eval_arg_context", "name", args, keywords)?;
                self.expander
                    .argument(&unplaced(name), self.here)
                    .map(|text| converted(&text))
            }
            HostFn::Env => {
                let name = text_argument("_eval_env", "name", args, keywords)?;
                self.expander.environment(&name).map(Value::Str)
            }
            HostFn::OptEnv => {
                let is_default = |(keyword, _): &&(EcoString, Value)| keyword == "default";
                let default = args
                    .get(1)
                    .or(keywords.iter().find(is_default).map(|(_, value)| value));
                let others: Vec<_> = keywords
                    .iter()
                    .filter(|pair| !is_default(pair))
                    .cloned()
                    .collect();
                let first = if args.len() > 2 {
                    args
                } else {
                    args.get(..1).unwrap_or_default()
                };
                let name = text_argument("_eval_optenv", "name", first, &others)?;
                let value = self.expander.env_var(&name).map(Value::Str);
                Ok(value
                    .or_else(|| default.cloned())
                    .unwrap_or_else(|| Value::Str(EcoString::new())))
            }
            HostFn::Find => {
                let name = text_argument("_eval_find", "pkg", args, keywords)?;
                self.expander
                    .package(&unplaced(name), self.here)
                    .map(Value::Str)
            }
            HostFn::Dirname => return Err(EvalError::new(ErrorKind::Key, "'filename'")),
            _ => Ok(Value::Unknown),
        })
    }
}

impl Host for ArgHost<'_, '_, '_> {
    fn lookup(&mut self, name: &str, _: TextRange) -> Lookup {
        match name {
            "true" => return Lookup::Found(Value::Bool(true)),
            "false" => return Lookup::Found(Value::Bool(false)),
            _ => {}
        }
        let own = expr::eval_symbol(name).or_else(|| expr::module_symbol(Module::Math, name));
        if let Some(value) = own {
            return Lookup::Found(value);
        }
        self.expander.note_argument(&name.into());
        match self.expander.names.args.get(name) {
            Some((Some(value), info)) => {
                let (value, info) = (value.clone(), *info);
                self.expander.names.reads.push(info);
                Lookup::Found(converted(&value))
            }
            Some((None, _)) => Lookup::Found(Value::Unknown),
            None => self.python_symbol(name),
        }
    }

    fn lookup_inside(&mut self, name: &str, _: TextRange) -> Lookup {
        // arguments and functions are the locals of the whole: what is nested has only globals
        self.python_symbol(name)
    }

    fn scope_attribute(&mut self, _: ScopeId, _: &str, _: TextRange) -> Lookup {
        Lookup::Missing
    }

    fn call(
        &mut self,
        function: HostFn,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        self.function(function, args, keywords)?.map_err(|failure| {
            self.failed.get_or_insert(failure);
            EvalError::new(ErrorKind::Reported, "")
        })
    }

    fn deprecated(&mut self, _: &str, _: &str, _: TextRange) {}

    fn undefined(&mut self, name: &str, _: TextRange) {
        self.undefined.get_or_insert_with(|| name.to_owned());
    }
}

/// A word of a substitution that stands nowhere in the text.
fn unplaced(text: EcoString) -> SubstArg {
    SubstArg {
        text,
        range: TextRange::default(),
    }
}

/// With a dot a float, else an integer, else a boolean, else text.
fn converted(text: &str) -> Value {
    let number = if text.contains('.') {
        literal::float(text)
    } else {
        literal::int(text)
    };
    number.unwrap_or_else(|| match text.to_lowercase().as_str() {
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => Value::Str(text.into()),
    })
}
