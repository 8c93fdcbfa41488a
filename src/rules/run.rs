//! Running rules.
use std::borrow::Cow;
use std::cell::OnceCell;

use ecow::EcoString;

use super::chosen::Chosen;
use super::consumers::tally;
use super::context::{
    DocumentCx, FileCx, RobotCx, RootKind, RuleEnv, elements, is_whole, named_macros,
    other_elements,
};
use super::finding::Finding;
use super::package::warn_once;
use super::problems;
use super::registry::all;
use super::rule::{Check, Rule};
use super::settled::Settled;
use super::sink::{Sink, span};
use super::visit::visit;
use super::vocabulary::{is_urdf_element, is_xacro_uri, outside_free_zones};
use super::xacro::is_unprefixed;
use base::{FastSet, FileId, Span, TextRange};
use expand::{Expansion, FileUse, Problem, ProblemKind};
use model::Robot;
use vfs::Vfs;

/// Whether a rule does not run on a robot that errors left out a part of.
pub fn needs_whole(rule: &Rule) -> bool {
    matches!(rule.check, Check::WholeDocument(_) | Check::WholeElement(_)) || needs_names(rule)
}

/// Whether a rule asks which links and joints there are: of a robot with names that could not be computed, it says less or
/// nothing.
pub fn needs_names(rule: &Rule) -> bool {
    matches!(rule.check, Check::Whole(_) | Check::Named(_))
}

/// Where the names of links and joints could not be computed.
pub fn unknown_names(expansion: &Expansion, robot: &Robot) -> Vec<Span> {
    if robot.names_are_known() {
        return Vec::new();
    }
    let pieces = robot.doubtful_names().flat_map(|text| &text.pieces);
    let unknown = pieces.filter(|piece| piece.unknown);
    let places = unknown.filter_map(|piece| expansion.place(piece.source));
    places.filter_map(|place| span(expansion, place)).collect()
}

/// The places of what left out a part of the robot, in the order of the expansion.
pub fn losses(expansion: &Expansion) -> Vec<Span> {
    let loses = |problem: &&Problem| {
        !problem.probed
            && (problem.kind.loses_content() || problem.kind == ProblemKind::PackageNotFound)
    };
    expansion
        .problems
        .iter()
        .filter(loses)
        .filter_map(|problem| span(expansion, problem.place))
        .collect()
}

/// What expansion of a file (what it is taken for, whether the user named it) reported, and what rules say about
/// the expanded document; and what need not be checked again next time, when `before` is that of the last time.
pub fn check_expansion(
    expansion: &Expansion,
    robot: Option<&Robot>,
    (kind, explicit): (RootKind, bool),
    world: RuleEnv<'_>,
    chosen: Chosen<'_>,
    before: &Settled,
) -> (Vec<Finding>, Settled) {
    let checked = check_again(expansion, robot, (kind, explicit), world, chosen, before);
    #[cfg(debug_assertions)]
    if !before.is_empty() && !chosen.cancel.is_cancelled() {
        let none = Settled::default();
        let fresh = check_again(expansion, robot, (kind, explicit), world, chosen, &none);
        verify(&checked.0, &fresh.0, chosen.cancel);
    }
    checked
}

/// In builds for tests: passing over what is settled leaves no finding out.
#[cfg(debug_assertions)]
fn verify(made: &[Finding], fresh: &[Finding], cancel: &base::CancelFlag) {
    let shown = |findings: &[Finding]| -> Vec<String> {
        findings.iter().map(|found| format!("{found:?}")).collect()
    };
    let (made, fresh) = (shown(made), shown(fresh));
    assert!(
        made == fresh || cancel.is_cancelled(),
        "findings of an incremental check: {made:#?} instead of {fresh:#?}"
    );
}

fn check_again(
    expansion: &Expansion,
    robot: Option<&Robot>,
    (kind, explicit): (RootKind, bool),
    world: RuleEnv<'_>,
    chosen: Chosen<'_>,
    before: &Settled,
) -> (Vec<Finding>, Settled) {
    let unprefixed = Unprefixed::of(expansion);
    let explained = |problem: &Problem| unprefixed.explains(expansion, problem);
    let mut findings = problems::findings(expansion, explained, world);
    let mut settled = Settled::default();
    let Some(first) = all().next() else {
        return (findings, settled);
    };
    let mut sink = Sink::new(expansion, first);
    let complete = is_whole(expansion);
    let whole = expansion
        .tree
        .root()
        .map(|root| (root, kind, robot.map(Cow::Borrowed)));
    // what a macro gives that nothing calls is looked at like a library
    let probes = expansion
        .index
        .probes
        .iter()
        .map(|probe| {
            (
                probe.content,
                Cow::Owned(Robot::below(&expansion.tree, probe.content)),
            )
        })
        .map(|(content, robot)| (content, RootKind::Library, Some(robot)));
    let places = whole
        .into_iter()
        .map(|whole| (whole, false))
        .chain(probes.map(|probe| (probe, true)));
    for ((element, kind, robot), is_probe) in places {
        sink.set_probed(is_probe);
        let document = DocumentCx::new(
            expansion,
            element,
            (kind, explicit),
            robot.as_deref(),
            world,
            complete,
        );
        chosen.run(&mut sink, |rule, sink| match rule.check {
            Check::Document(check) => check(&document, sink),
            Check::WholeDocument(check) if complete => check(&document, sink),
            _ => {}
        });
        let now = visit(&document, chosen, before, &mut sink);
        if !is_probe {
            settled = now;
        }
        if let Some(place) = chosen.tally.filter(|_| kind == RootKind::Robot) {
            place.get_or_init(|| tally(&document));
        }
    }
    sink.set_probed(false);
    if let Some(robot) = robot.filter(|_| kind == RootKind::Robot) {
        let is_there = complete && !unprefixed.structure;
        let whole = is_there && robot.names_are_known();
        let cx = RobotCx {
            expansion,
            robot,
            kinematics: robot.kinematics(),
            world,
            whole,
        };
        chosen.run(&mut sink, |rule, sink| match rule.check {
            Check::Robot(check) => check(&cx, sink),
            Check::Whole(check) if whole => check(&cx, sink),
            Check::Named(check) if is_there => check(&cx, sink),
            _ => {}
        });
    }
    // what the recovered tree of a broken file seems to say is not trusted
    let broken = |file: &&FileUse| !file.source.document.errors().is_empty();
    let broken: Vec<FileId> = expansion
        .files
        .iter()
        .filter(broken)
        .map(|file| file.source.id)
        .collect();
    findings.extend(
        sink.finish()
            .into_iter()
            .filter(|finding| !broken.contains(&finding.span.file)),
    );
    if kind == RootKind::Robot && !world.has_ros {
        warn_once(&mut findings, expansion, world);
    }
    (findings, settled)
}

/// What can be said of undefined names in files that are not well-formed, while somebody types in them: those
/// that no text of the expansion gives, in items that are whole themselves.
pub fn check_recovered(expansion: &Expansion, vfs: &Vfs) -> Vec<Finding> {
    if expansion.untrusted.is_empty() {
        return Vec::new();
    }
    let documents = expansion.files.iter().map(|file| &file.source.document);
    let given: FastSet<EcoString> = documents
        .flat_map(|document| document.parts().flat_map(|(_, item)| item.all_nodes()))
        .flat_map(|node| {
            let name = node.attr("name").map(|name| name.raw().to_owned());
            let params = node
                .attr("params")
                .map(|params| params.raw().to_owned())
                .unwrap_or_default();
            let params: Vec<EcoString> = params
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .map(EcoString::from)
                .collect();
            name.map(EcoString::from).into_iter().chain(params)
        })
        .collect();
    let sure = |problem: &&Problem| {
        let Some(file) = expansion.files.get(problem.place.file) else {
            return false;
        };
        let document = &file.source.document;
        let place = document.item_at(problem.place.range.start);
        let own = TextRange::new(place.start, place.start + place.item.len());
        matches!(
            problem.kind,
            ProblemKind::UndefinedProperty | ProblemKind::UndefinedArg
        ) && !given.contains(document.slice(problem.place.range).as_str())
            && !document
                .errors()
                .iter()
                .any(|error| own.touches(error.range.start))
    };
    let sure = expansion.untrusted.iter().filter(sure);
    sure.filter_map(|problem| problems::finding(expansion, problem, vfs))
        .collect()
}

/// What rules say about the source files of an expansion. Of a file that is not well-formed, only that
/// is said.
pub fn check_files(expansion: &Expansion, world: RuleEnv<'_>, chosen: Chosen<'_>) -> Vec<Finding> {
    let Some(first) = all().next() else {
        return Vec::new();
    };
    let mut sink = Sink::new(expansion, first);
    let macros = OnceCell::new();
    for (file, used) in expansion.files.iter_ids() {
        let packages = OnceCell::new();
        let cx = FileCx {
            expansion,
            file,
            source: &used.source,
            macros: &macros,
            world,
            packages,
        };
        let well_formed = used.source.document.errors().is_empty();
        chosen.run(&mut sink, |rule, sink| match rule.check {
            Check::File(check) if well_formed => check(&cx, sink),
            _ => {}
        });
    }
    sink.finish()
}

/// Whether tags without their prefix would give the robot more links and joints: what is missing has its cause there.
pub fn has_ignored_tags(expansion: &Expansion) -> bool {
    Unprefixed::of(expansion).structure
}

/// What tags without their prefix would have defined: that it is missing has its cause there.
#[derive(Default)]
struct Unprefixed {
    names: FastSet<String>,
    /// Whole files or macros are missing.
    structure: bool,
}

impl Unprefixed {
    fn of(expansion: &Expansion) -> Self {
        let structure = lacks_calls(expansion) || has_other_prefix(expansion);
        let mut found = Self {
            structure,
            ..Self::default()
        };
        for file in &expansion.files {
            let document = &file.source.document;
            let elements = outside_free_zones(other_elements(document)).map(|(_, node)| node);
            for node in elements.filter(|&node| is_unprefixed(expansion, document, node)) {
                found.structure |= node.name() != "property" && node.name() != "arg";
                found
                    .names
                    .extend(node.attr("name").map(|name| name.raw().to_owned()));
            }
        }
        found
    }

    fn explains(&self, expansion: &Expansion, problem: &Problem) -> bool {
        if !problem.kind.is_undefined_name() || self.names.is_empty() && !self.structure {
            return false;
        }
        let Some(file) = expansion.files.get(problem.place.file) else {
            return false;
        };
        let text = file.source.document.slice(problem.place.range);
        let name = text.trim_start_matches("<xacro:");
        self.names.contains(name) || self.structure
    }
}

/// Whether tags have another prefix that stands for xacro: nothing of what they say is there.
fn has_other_prefix(expansion: &Expansion) -> bool {
    expansion.files.iter().any(|file| {
        let document = &file.source.document;
        let attrs = document.root().into_iter().flat_map(|root| root.attrs());
        let prefixes = attrs.filter(|attr| is_xacro_uri(attr.raw()));
        let mut prefixes = prefixes
            .filter_map(|attr| attr.name().strip_prefix("xmlns:"))
            .filter(|&prefix| prefix != "xacro");
        let has = |prefix: &str| {
            let mut names = elements(document).map(|(_, node)| node.name());
            names.any(|name| {
                name.strip_prefix(prefix)
                    .is_some_and(|rest| rest.starts_with(':'))
            })
        };
        prefixes.any(has)
    })
}

/// Whether a macro is called without its prefix: what it gives is missing.
fn lacks_calls(expansion: &Expansion) -> bool {
    // most robots have no such tag
    if unknown_tags(expansion).next().is_none() {
        return false;
    }
    let macros = named_macros(expansion);
    unknown_tags(expansion).any(|name| macros.contains(name))
}

/// The names of tags without a prefix that URDF does not know.
fn unknown_tags(expansion: &Expansion) -> impl Iterator<Item = &str> {
    let documents = expansion.files.iter().map(|file| &file.source.document);
    documents
        .flat_map(|document| outside_free_zones(other_elements(document)))
        .map(|(_, node)| node.name())
        .filter(|name| !name.contains(':') && !is_urdf_element(name))
}
