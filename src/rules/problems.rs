//! Problems of the expansion as findings.
use super::context::{RuleEnv, is_plain_urdf};
use super::finding::{Edit, Finding, Fix, Related};
use super::grouping::Group;
use super::package::{PACKAGE_NOT_FOUND, excuse_find};
use super::place;
use super::problem_cx::ProblemCx;
use super::rule::{Rule, Safety, Severity};
use super::sink::{limit_calls, span};
use super::xacro::{
    found, include_children_ignored, include_not_found, invalid_property_name, missing_macro_param,
    redefined_macro, shadowed_builtin, unknown_macro_param, unknown_xacro_attribute,
};
use super::xml::{XML_ENCODING_MISMATCH, missing_xacro_namespace, xml_syntax_error};
use base::{FastMap, FastSet, FileId, Span, TextRange};
use expand::{Expansion, Problem, ProblemKind, TraceStep};
use vfs::Vfs;
use xml::{Document, SyntaxError, SyntaxErrorKind};

/// How problems of a kind become findings.
struct Conversion {
    rule: &'static Rule,
    /// The range to report, when it is not that of the problem.
    range: Option<fn(&Document, TextRange) -> TextRange>,
    /// The fix of a problem without a replacement.
    fix: Option<fn(&ProblemCx<'_>) -> Option<Fix>>,
}

impl Conversion {
    const fn to(rule: &'static Rule) -> Self {
        Self {
            rule,
            range: None,
            fix: None,
        }
    }

    const fn at(mut self, range: fn(&Document, TextRange) -> TextRange) -> Self {
        self.range = Some(range);
        self
    }

    const fn fixed(mut self, fix: fn(&ProblemCx<'_>) -> Option<Fix>) -> Self {
        self.fix = Some(fix);
        self
    }

    fn of(kind: ProblemKind) -> Self {
        use ProblemKind as Kind;
        match kind {
            Kind::XmlSyntaxError => Self::to(&xml_syntax_error::RULE).fixed(xml_syntax_error::fix),
            Kind::MissingXacroNamespace => Self::to(&missing_xacro_namespace::RULE)
                .at(place::whole_name)
                .fixed(missing_xacro_namespace::fix),
            Kind::XmlEncodingMismatch => Self::to(&XML_ENCODING_MISMATCH),
            Kind::UndefinedProperty => Self::to(&found::UNDEFINED_PROPERTY),
            Kind::UndefinedMacro => Self::to(&found::UNDEFINED_MACRO),
            Kind::UndefinedArg => Self::to(&found::UNDEFINED_ARG),
            Kind::UndefinedBlock => Self::to(&found::UNDEFINED_BLOCK),
            Kind::MissingMacroParam => {
                Self::to(&missing_macro_param::RULE).fixed(missing_macro_param::fix)
            }
            Kind::UnknownMacroParam => {
                Self::to(&unknown_macro_param::RULE).fixed(unknown_macro_param::fix)
            }
            Kind::MacroBlockMismatch => Self::to(&found::MACRO_BLOCK_MISMATCH),
            Kind::IncludeNotFound => {
                Self::to(&include_not_found::RULE).fixed(include_not_found::fix)
            }
            Kind::IncludeCycle => Self::to(&found::INCLUDE_CYCLE),
            Kind::RedefinedMacro => Self::to(&redefined_macro::RULE).fixed(redefined_macro::fix),
            Kind::ShadowedBuiltin => Self::to(&shadowed_builtin::RULE),
            Kind::InvalidPropertyName => {
                Self::to(&invalid_property_name::RULE).fixed(invalid_property_name::fix)
            }
            Kind::PropertyCycle => Self::to(&found::PROPERTY_CYCLE).at(place::name_of_element),
            Kind::InvalidExpression => Self::to(&found::INVALID_EXPRESSION),
            Kind::ExpressionError => Self::to(&found::EXPRESSION_ERROR),
            Kind::UnclosedExpression => Self::to(&found::UNCLOSED_EXPRESSION),
            Kind::InvalidCondition => Self::to(&found::INVALID_CONDITION),
            Kind::DeprecatedBuiltinCall => Self::to(&found::DEPRECATED_BUILTIN_CALL),
            Kind::MacroNameWithPrefix => Self::to(&found::MACRO_NAME_WITH_PREFIX),
            Kind::UnknownXacroAttribute => {
                Self::to(&unknown_xacro_attribute::RULE).fixed(unknown_xacro_attribute::fix)
            }
            Kind::MissingXacroAttribute => Self::to(&found::MISSING_XACRO_ATTRIBUTE),
            Kind::IncludeChildrenIgnored => {
                Self::to(&include_children_ignored::RULE).fixed(include_children_ignored::fix)
            }
            Kind::InfiniteMacroRecursion => Self::to(&found::INFINITE_MACRO_RECURSION),
            Kind::GlobIncludeNoMatch => Self::to(&found::GLOB_INCLUDE_NO_MATCH),
            Kind::ConflictingPropertyAttributes => {
                Self::to(&found::CONFLICTING_PROPERTY_ATTRIBUTES)
            }
            Kind::UseBeforeDefinition => Self::to(&found::USE_BEFORE_DEFINITION),
            Kind::ParentScopeAtTop => {
                Self::to(&found::PARENT_SCOPE_AT_TOP).at(place::whole_attribute)
            }
            Kind::DefaultWithScope => {
                Self::to(&found::DEFAULT_WITH_SCOPE).at(place::whole_attribute)
            }
            Kind::InvalidMacroName => Self::to(&found::INVALID_MACRO_NAME),
            Kind::InconsistentNamespaceRedefinition => {
                Self::to(&found::INCONSISTENT_NAMESPACE_REDEFINITION).at(place::whole_attribute)
            }
            Kind::PackageNotFound => Self::to(&PACKAGE_NOT_FOUND),
        }
    }
}

/// A missing package is reported once for each name and file; where no ROS is, as a note.
fn excuse_packages(findings: &mut Vec<Finding>, world: RuleEnv<'_>) {
    let mut first: FastMap<(FileId, String), usize> = FastMap::default();
    let mut kept: Vec<Finding> = Vec::with_capacity(findings.len());
    for mut finding in findings.drain(..) {
        if finding.problem == Some(ProblemKind::PackageNotFound) {
            let known = first
                .entry((finding.span.file, finding.message.clone()))
                .or_insert(kept.len());
            if let Some(known) = kept.get_mut(*known) {
                let message = "also used here".to_owned();
                known.related.push(Related {
                    span: finding.span,
                    message,
                    is_call: false,
                });
                if let (Some(fix), Some(more)) = (&mut known.fix, finding.fix) {
                    fix.edits.extend(more.edits);
                }
                continue;
            }
            excuse_find(world, &mut finding);
        }
        kept.push(finding);
    }
    *findings = kept;
}

/// The rule about problems of a kind.
pub fn rule_of(kind: ProblemKind) -> &'static Rule {
    Conversion::of(kind).rule
}

/// What expansion reported of a document, but for what `explained` accounts for.
pub(super) fn findings(
    expansion: &Expansion,
    explained: impl Fn(&Problem) -> bool,
    world: RuleEnv<'_>,
) -> Vec<Finding> {
    let root = expansion.files.first().map(|file| &*file.source.path);
    let refused = refused_names(expansion);
    // an expression cannot read a name that its definition must not have: that is said there
    let follows = |problem: &Problem| {
        problem.kind == ProblemKind::InvalidExpression
            && !refused.is_empty()
            && text_at(expansion, problem).is_some_and(|text| reads_only(&text, &refused))
    };
    let problems = expansion
        .problems
        .iter()
        .filter(|problem| !explained(problem) && !follows(problem));
    let mut found: Vec<Finding> = problems
        .filter_map(|problem| {
            let mut found = finding(expansion, problem, world.vfs)?;
            if problem.kind == ProblemKind::ShadowedBuiltin
                && shadowed_builtin::is_harmless(
                    expansion,
                    problem,
                    root.and_then(|root| world.packages.generation(root)),
                )
            {
                found.severity = Severity::Info;
            }
            Some(found)
        })
        .collect();
    excuse_packages(&mut found, world);
    found
}

/// The names of properties that no property may have.
fn refused_names(expansion: &Expansion) -> FastSet<String> {
    let problems = expansion.problems.iter();
    problems
        .filter(|problem| problem.kind == ProblemKind::InvalidPropertyName)
        .filter_map(|problem| text_at(expansion, problem))
        .collect()
}

/// Whether a text has names that start with `__`, and all of them are refused ones.
fn reads_only(text: &str, refused: &FastSet<String>) -> bool {
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let mut names = words.filter(|word| word.starts_with("__")).peekable();
    names.peek().is_some() && names.all(|name| refused.contains(name))
}

/// The text that a problem is about.
fn text_at(expansion: &Expansion, problem: &Problem) -> Option<String> {
    let file = expansion.files.get(problem.place.file)?;
    Some(file.source.document.slice(problem.place.range))
}

/// What makes xacro reject a file.
pub fn rejections(expansion: &Expansion, vfs: &Vfs) -> Vec<Finding> {
    let is_error = |problem: &&Problem| !problem.probed && problem.severity == Severity::Error;
    let errors = expansion.problems.iter().filter(is_error);
    let found = errors.filter_map(|problem| finding(expansion, problem, vfs));
    found
        .map(|found| Finding {
            severity: Severity::Error,
            ..found
        })
        .collect()
}

/// A problem of the expansion as a finding.
pub(super) fn finding(expansion: &Expansion, problem: &Problem, vfs: &Vfs) -> Option<Finding> {
    let Conversion {
        rule,
        range: placed,
        fix,
    } = Conversion::of(problem.kind);
    if problem.kind == ProblemKind::ShadowedBuiltin
        && !shadowed_builtin::is_news(expansion, problem)
    {
        return None;
    }
    let Span { file, range } = span(expansion, problem.place)?;
    let document = &expansion.files.get(problem.place.file)?.source.document;
    let mut calls = calls(expansion, problem);
    let mut place = Span {
        file,
        range: placed.map_or(range, |placed| placed(document, range)),
    };
    let is_syntax = problem.kind == ProblemKind::XmlSyntaxError;
    if let Some((range, opened)) = place::syntax(document, file).filter(|_| is_syntax) {
        place.range = range;
        // of the steps, only those in other files led here: the includes
        let includes = calls.into_iter().filter(|step| step.span.file != file);
        calls = opened.into_iter().chain(includes).collect();
    }
    let cx = ProblemCx {
        problem,
        document,
        span: place,
        vfs,
    };
    let replaced = problem.replacement.as_ref().map(|content| Fix {
        safety: rule.fix.unwrap_or(Safety::Unsafe),
        message: format!("replace with `{}`", content.trim_start_matches('<')),
        edits: vec![Edit {
            span: Span { file, range },
            content: content.clone(),
        }],
    });
    let fix = replaced.or_else(|| fix?(&cx));
    let mut finding = Finding {
        severity: severity(rule, expansion, problem, (file, document)),
        help: problem.help.clone(),
        fix,
        problem: Some(problem.kind),
        group: group(problem),
        outside: problem.outside.clone(),
        probed: problem.probed,
        ..Finding::new(rule, place, problem.message.clone())
    };
    limit_calls(&mut finding, calls);
    Some(finding)
}

/// What a problem shares with others that are the same defect, where its rule does not say it.
fn group(problem: &Problem) -> Option<Group> {
    // a habit of who wrote macros that nothing calls
    let is_idle = problem.kind == ProblemKind::InvalidExpression && problem.probed;
    is_idle
        .then_some(Group::File)
        .or_else(|| include_not_found::group(problem))
}

/// How bad a problem is in the file where it is.
fn severity(
    rule: &Rule,
    expansion: &Expansion,
    problem: &Problem,
    (file, document): (FileId, &Document),
) -> Severity {
    match problem.kind {
        _ if problem.excused => Severity::Info,
        ProblemKind::XmlSyntaxError if is_read_anyway(expansion, file) => Severity::Warning,
        ProblemKind::IncludeChildrenIgnored => {
            include_children_ignored::severity(problem, document)
        }
        ProblemKind::IncludeNotFound if include_not_found::is_of_caller(problem, document) => {
            Severity::Info
        }
        // xacro does not read the body of a macro that nothing calls
        ProblemKind::InvalidExpression if problem.probed => Severity::Warning,
        _ => rule.severity,
    }
}

/// The calls, includes and definitions on the way to a problem.
fn calls(expansion: &Expansion, problem: &Problem) -> Vec<Related> {
    let steps = problem.trace.iter().chain(&problem.more_calls);
    let related = |step: &TraceStep| {
        // calls and includes are given by their tags, definitions by their names
        let text = expansion
            .files
            .get(step.place.file)?
            .source
            .document
            .slice(step.place.range);
        let (message, is_call) = (
            step.message.clone(),
            text.starts_with('<') || text.starts_with('$'),
        );
        Some(Related {
            span: span(expansion, step.place)?,
            message,
            is_call,
        })
    };
    steps.filter_map(related).collect()
}

/// Whether a file that is not well-formed has only prefixes that nothing declares, in a name that calls it plain URDF:
/// readers of URDF do not mind.
fn is_read_anyway(expansion: &Expansion, file: FileId) -> bool {
    let used = expansion.files.iter().find(|used| used.source.id == file);
    let Some(used) = used else { return false };
    let is_prefix = |error: &SyntaxError| error.kind == SyntaxErrorKind::UnboundPrefix;
    is_plain_urdf(&used.source.path) && used.source.document.errors().iter().all(is_prefix)
}
