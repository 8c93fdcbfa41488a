//! What the consumers that the user names make of the robot.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::consumer::Consumer;
use super::fix::Remedy;
use super::met::Met;
use super::remedy::remedy;
use super::table::{Construct, Outcome};
use base::FastMap;
use expand::Origin;

pub(super) static REJECTS: Rule = Rule {
    code: "CSM001",
    name: "consumer-rejects",
    category: Category::Consumers,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("consumer-rejects"),
    check: Check::Document(rejects),
};

pub(super) static CHANGES: Rule = Rule {
    code: "CSM002",
    name: "consumer-changes",
    category: Category::Consumers,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
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
    let wanted: Vec<&'static Consumer> = config
        .consumers
        .iter()
        .filter_map(|name| Consumer::named(name))
        .collect();
    let all = super::detect::met(cx);
    let mut places: FastMap<Origin, usize> = FastMap::default();
    let mut found: Vec<Vec<Verdict<'_>>> = Vec::new();
    for met in all {
        let worst = wanted
            .iter()
            .map(|consumer| met.construct.outcome(consumer))
            .max();
        let mut who: Vec<String> = wanted
            .iter()
            .filter(|consumer| met.construct.outcome(consumer) == outcome)
            .map(|consumer| consumer.title.to_owned())
            .collect();
        let old = config
            .oldest_reader
            .as_ref()
            .filter(|oldest| is_newer(met, oldest));
        who.extend(
            old.filter(|_| outcome == Outcome::Rejects)
                .map(|oldest| format!("urdfdom {oldest}")),
        );
        // what is rejected by one is said once, with those that change it
        let is_said =
            outcome == Outcome::Changes && (worst == Some(Outcome::Rejects) || old.is_some());
        if who.is_empty() || is_said {
            continue;
        }
        // a place has one finding of a rule: several constructs there share it
        let place = *places.entry(met.origin).or_insert(found.len());
        found.resize_with(found.len().max(place + 1), Vec::new);
        found.get_mut(place).into_iter().for_each(|here| {
            here.push(Verdict {
                met,
                who: who.clone(),
            })
        });
    }
    for here in &found {
        let remedy = here
            .iter()
            .find_map(|verdict| remedy(cx, all, verdict.met, &wanted));
        say(here, outcome, remedy, out);
    }
}

/// A construct, and who of those that were named does the same with it.
struct Verdict<'a> {
    met: &'a Met,
    who: Vec<String>,
}

/// Whether a construct needs a newer urdfdom than the oldest one that has to load the robot.
fn is_newer(met: &Met, oldest: &str) -> bool {
    met.construct
        .oldest
        .as_ref()
        .is_some_and(|needed| version(needed) > version(oldest))
}

/// The numbers of a version; `6` is `6.0`.
fn version(text: &str) -> Vec<u32> {
    let mut parts: Vec<u32> = text
        .split('.')
        .map(|part| part.parse().unwrap_or(0))
        .collect();
    parts.truncate(
        parts
            .iter()
            .rposition(|&part| part > 0)
            .map_or(0, |last| last + 1),
    );
    parts
}

/// Report the constructs at a place.
fn say(here: &[Verdict<'_>], outcome: Outcome, remedy: Option<Remedy>, out: &mut Sink<'_>) {
    let [first, others @ ..] = here else { return };
    let verb = match (outcome, first.who.len()) {
        (Outcome::Rejects, 1) => "rejects",
        (Outcome::Rejects, _) => "reject",
        (_, 1) => "changes or ignores",
        (_, _) => "change or ignore",
    };
    let Met {
        construct,
        owner,
        origin,
    } = first.met;
    let mut message = format!("{} {verb} {owner}: {}", listed(&first.who), construct.title);
    let mut names = vec![construct.name.as_str()];
    let mut helps = vec![help(construct)];
    for Verdict { met, who } in others {
        message.push_str(&format!("; {}: {}", listed(who), met.construct.title));
        names.push(&met.construct.name);
        helps.push(help(met.construct));
    }
    helps.dedup();
    if others.is_empty() {
        helps.extend(also(first));
    }
    let group = Group::Name(names.join(" ").into());
    let report = out
        .report(*origin, message)
        .group(group)
        .help(helps.join("; "));
    match remedy {
        Some(Remedy {
            safety,
            message,
            edits,
        }) => report.edits(safety, message, edits).done(),
        None => report.done(),
    }
}

fn help(construct: &Construct) -> String {
    construct
        .help
        .clone()
        .unwrap_or_else(|| "check what the consumer makes of it".to_owned())
}

/// What the other consumers do with a construct.
fn also(verdict: &Verdict<'_>) -> Vec<String> {
    let others = |(outcome, verb): (Outcome, &str)| {
        let others: Vec<String> = verdict
            .met
            .construct
            .who(outcome)
            .into_iter()
            .filter(|title| !verdict.who.iter().any(|own| own == title))
            .map(str::to_owned)
            .collect();
        (!others.is_empty()).then(|| format!("{verb} by {}", listed(&others)))
    };
    let outcomes = [
        (Outcome::Rejects, "rejected"),
        (Outcome::Changes, "changed or ignored"),
        (Outcome::Accepts, "accepted"),
    ];
    outcomes.into_iter().filter_map(others).collect()
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
