//! The names of links and joints that a robot has with other arguments, and in another environment.
use ecow::EcoString;

use super::super::proof::{CONDITIONS, turned_over};
use super::super::root_analysis::{RootAnalysis, task_of};
use super::super::root_config::RootConfig;
use super::super::run_task;
use super::super::session::Session;
use base::CancelFlag;
use expand::{Expansion, Forced, Request, Sources, expand};
use model::Robot;
use rules::RobotNames;
use vfs::Environment;
use workspace::config::XacroArgs;

/// Arguments of a robot that are turned over.
const MOST_SWITCHES: usize = 8;
/// Values that launch files let somebody choose from for arguments of a robot, which are tried.
const MOST_CHOICES: usize = 16;
/// Calls of a robot with different arguments that are tried.
const MOST_CALLS: usize = 16;
/// What a text of xacro begins with that reads a variable of the environment.
const VARIABLES: [&str; 2] = ["$(optenv ", "$(env "];

/// The names that a robot has with its switches turned over, with the values that launch files let somebody choose
/// from, and in another environment.
pub(super) fn names_otherwise(
    session: &Session,
    analyzed: &RootAnalysis,
    cancel: &CancelFlag,
) -> RobotNames {
    let mut names = RobotNames::default();
    let turned = |(name, value): &(EcoString, EcoString)| match turned_over(value).as_slice() {
        [other] => Some((name.to_string(), (*other).to_owned())),
        _ => None,
    };
    let switches: Vec<(String, String)> = analyzed
        .expansion
        .arguments
        .iter()
        .filter_map(turned)
        .take(MOST_SWITCHES)
        .collect();
    let chosen = session.callers.choices(&analyzed.root.file).into_iter();
    let chosen = chosen
        .flat_map(|(name, values)| values.into_iter().map(move |value| (name.clone(), value)));
    let chosen: Vec<(String, String)> = chosen.take(MOST_CHOICES).collect();
    let single = switches
        .iter()
        .chain(&chosen)
        .map(|switch| vec![switch.clone()]);
    let together = (switches.len() > 1).then(|| switches.clone());
    // one package may hold the settings of several robots, which its launch files make of one description
    let called = called_otherwise(session, &analyzed.root).into_iter();
    let called = called.flat_map(|args| {
        let with_turned: XacroArgs = args.iter().chain(&switches).cloned().collect();
        [args, with_turned]
    });
    for more in single
        .chain(together)
        .chain(called)
        .take_while(|_| !cancel.is_cancelled())
    {
        let base = run_task::request(session, cancel, &task_of(&analyzed.root));
        let args = base.args.iter().cloned().chain(more).collect();
        let other = Request {
            args,
            probe: false,
            ..base
        };
        add(&mut names, &expand(run_task::sources(session), &other));
    }
    add_elsewhere(session, analyzed, cancel, &mut names);
    names
}

/// The arguments with which launch files call a description, as far as they are known, and none: what a setup assistant was
/// given is one robot of several then.
fn called_otherwise(session: &Session, root: &RootConfig) -> Vec<XacroArgs> {
    let mut found: Vec<XacroArgs> = Vec::new();
    for call in session.robot_calls(&root.file).iter() {
        let known = call.call.args.iter().filter_map(|argument| {
            let value = argument.given(&session.packages, &call.call.caller)?;
            Some((argument.name.clone(), value))
        });
        let known: XacroArgs = known.collect();
        let is_own = call.target.as_deref() == Some(&*root.file);
        if is_own && !known.is_empty() && !found.contains(&known) {
            found.push(known);
        }
    }
    found.truncate(MOST_CALLS);
    found
}

/// Add the names that a robot has where variables of the environment are set that decide on parts of it: a script of
/// the robot, or whoever starts it, may set them. A variable with a switch as its default is turned over, and the
/// conditions that read one are taken, whatever they compare it with.
fn add_elsewhere(
    session: &Session,
    analyzed: &RootAnalysis,
    cancel: &CancelFlag,
    names: &mut RobotNames,
) {
    let environment = turned(&analyzed.expansion, &session.env);
    let forced = conditions(&analyzed.expansion);
    let ways = [
        environment.map(|env| (env, Vec::new())),
        (!forced.is_empty()).then(|| (session.env.clone(), forced)),
    ];
    for (env, forced) in ways.into_iter().flatten() {
        let other = Request {
            probe: false,
            forced,
            ..run_task::request(session, cancel, &task_of(&analyzed.root))
        };
        let sources = Sources {
            env: &env,
            ..run_task::sources(session)
        };
        add(names, &expand(sources, &other));
    }
}

/// Add the names of what an expansion gives.
fn add(names: &mut RobotNames, expansion: &Expansion) {
    Robot::of(expansion)
        .iter()
        .for_each(|robot| names.add(robot));
}

/// The environment in which the variables of a robot that are switches have the other value: `$(optenv HAS_ARM false)`.
fn turned(expansion: &Expansion, env: &Environment) -> Option<Environment> {
    let mut other = env.clone();
    let mut is_other = false;
    for file in &expansion.files {
        let text = file.source.document.text();
        for read in text.split("$(optenv ").skip(1) {
            let (Some(name), Some(default)) = words(read) else {
                continue;
            };
            let now = env.var(name).unwrap_or(default);
            if let [value] = turned_over(now).as_slice() {
                other.vars.insert(name.to_owned(), (*value).to_owned());
                is_other = true;
            }
        }
    }
    is_other.then_some(other)
}

/// The name and the default of `NAME DEFAULT)`.
fn words(text: &str) -> (Option<&str>, Option<&str>) {
    let inner = text.split(')').next().unwrap_or_default();
    let mut words = inner.split_whitespace();
    (words.next(), words.next())
}

/// The conditions of a robot whose text reads a variable of the environment, as if they were met.
fn conditions(expansion: &Expansion) -> Vec<Forced> {
    let mut found = Vec::new();
    for file in &expansion.files {
        for (base, item) in file.source.document.parts() {
            let conditions = item
                .all_nodes()
                .filter(|node| CONDITIONS.contains(&node.name()));
            for node in conditions {
                let value = node.attr("value").map(|value| value.raw());
                if value.is_some_and(|value| VARIABLES.iter().any(|read| value.contains(read))) {
                    found.push(Forced {
                        file: file.source.path.to_path_buf(),
                        at: base + node.range().start,
                        taken: true,
                    });
                }
            }
        }
    }
    found
}
