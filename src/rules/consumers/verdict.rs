//! What the consumers that the user names make of the robot.

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::consumer::Consumer;
use super::facts::Met;
use super::table::Outcome;

pub(super) const REJECTS: Rule = Rule {
    code: "CSM001",
    name: "consumer-rejects",
    category: Category::Consumers,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("consumer-rejects"),
    check: Check::Document(rejects),
};

pub(super) const CHANGES: Rule = Rule {
    code: "CSM002",
    name: "consumer-changes",
    category: Category::Consumers,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("consumer-changes"),
    check: Check::Document(changes),
};

fn rejects(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    report(cx, Outcome::Rejects, out);
}

fn changes(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    report(cx, Outcome::Changes, out);
}

fn report(cx: &DocumentCx<'_>, outcome: Outcome, out: &mut Sink<'_>) {
    let config = cx.world.config;
    // nobody asked: nothing is looked for
    if config.consumers.is_empty() && config.oldest_reader.is_none() {
        return;
    }
    let wanted: Vec<&Consumer> = config.consumers.iter().filter_map(|name| Consumer::named(name)).collect();
    for met in super::met(cx) {
        let worst = wanted.iter().map(|consumer| met.construct.outcome(consumer)).max();
        let mut who: Vec<String> = wanted
            .iter()
            .filter(|consumer| met.construct.outcome(consumer) == outcome)
            .map(|consumer| consumer.title.to_owned())
            .collect();
        let old = config.oldest_reader.as_ref().filter(|oldest| is_newer(&met, oldest));
        who.extend(old.filter(|_| outcome == Outcome::Rejects).map(|oldest| format!("urdfdom {oldest}")));
        // what is rejected by one is said once, with those that change it
        let is_said = outcome == Outcome::Changes && (worst == Some(Outcome::Rejects) || old.is_some());
        if !who.is_empty() && !is_said {
            say(&met, outcome, &who, out);
        }
    }
}

/// Whether a construct needs a newer urdfdom than the oldest one that has to load the robot.
fn is_newer(met: &Met, oldest: &str) -> bool {
    met.construct.oldest.as_ref().is_some_and(|needed| version(needed) > version(oldest))
}

/// The numbers of a version; `6` is `6.0`.
fn version(text: &str) -> Vec<u32> {
    let mut parts: Vec<u32> = text.split('.').map(|part| part.parse().unwrap_or(0)).collect();
    parts.truncate(parts.iter().rposition(|&part| part > 0).map_or(0, |last| last + 1));
    parts
}

fn say(met: &Met, outcome: Outcome, who: &[String], out: &mut Sink<'_>) {
    let verb = match (outcome, who.len()) {
        (Outcome::Rejects, 1) => "rejects",
        (Outcome::Rejects, _) => "reject",
        (_, 1) => "changes or ignores",
        (_, _) => "change or ignore",
    };
    let message = format!("{} {verb} {}: {}", listed(who), met.owner, met.construct.title);
    let others = |outcome: Outcome, verb: &str| {
        let others: Vec<String> = met
            .construct
            .who(outcome)
            .into_iter()
            .filter(|title| !who.iter().any(|own| own == title))
            .map(str::to_owned)
            .collect();
        (!others.is_empty()).then(|| format!("{verb} by {}", listed(&others)))
    };
    let also: Vec<String> = [
        others(Outcome::Rejects, "rejected"),
        others(Outcome::Changes, "changed or ignored"),
        others(Outcome::Accepts, "accepted"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let help = met.construct.help.clone().unwrap_or_else(|| "check what the consumer makes of it".to_owned());
    out.report(met.origin, message)
        .group(Group::Name(met.construct.name.as_str().into()))
        .help(format!("{help}; {}", also.join("; ")))
        .done();
}

/// "Drake, MuJoCo and urdfdom"
fn listed(names: &[String]) -> String {
    match names {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => names.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::version;

    #[test]
    fn versions() {
        assert_eq!(version("6"), version("6.0.0"));
        assert!(version("6.0") > version("5.1") && version("3.10") > version("3.9"));
        assert!(version("6.0.1") > version("6"));
    }
}
