//! Fixes are made of the kind of a problem and of its data, not of words for people: whoever rewords a help changes no fix.

use std::path::Path;

use xacro_lsp::base::{CancelFlag, Span};
use xacro_lsp::expand::{Expansion, Request, Sources, expand};
use xacro_lsp::model::Robot;
use xacro_lsp::rules::{self, Chosen, Finding, Fix, RootKind, Rule, Settled, check_expansion};

use super::{Session, blocks, session, write};

/// What editors and `--fix` offer for a finding.
type Offer = (&'static str, Span, Option<Fix>, Option<String>);

fn expanded(session: &Session, file: &Path) -> Expansion {
    let sources = Sources {
        vfs: &session.vfs,
        packages: &session.packages,
        env: &session.env,
    };
    let request = Request {
        file: file.display().to_string(),
        probe: true,
        ..Request::default()
    };
    expand(sources, &request)
}

fn findings(session: &Session, file: &Path, rule: &'static Rule, made: &Expansion) -> Vec<Finding> {
    let settings = session.settings(file);
    let robot = Robot::of(made);
    let chosen = Chosen {
        rules: &[rule],
        cancel: &CancelFlag::default(),
        tally: None,
    };
    let env = session.rule_env(&settings.config);
    let (kind, none) = ((RootKind::Robot, true), Settled::default());
    check_expansion(made, robot.as_ref(), kind, env, chosen, &none).0
}

fn offers(found: &[Finding]) -> Vec<Offer> {
    let of = |finding: &Finding| {
        (
            finding.rule.name,
            finding.span,
            finding.fix.clone(),
            finding.similar.clone(),
        )
    };
    found.iter().map(of).collect()
}

/// Give each problem the help of another one, with its words in another order.
fn shuffle(expansion: &mut Expansion) {
    let helps = expansion
        .problems
        .iter()
        .map(|problem| problem.help.clone());
    let mut helps: Vec<String> = helps.map(Option::unwrap_or_default).collect();
    // the expansion has a problem
    helps.rotate_left(1);
    for (problem, help) in expansion.problems.iter_mut().zip(helps) {
        let words: Vec<&str> = help.split(' ').rev().collect();
        problem.help = Some(format!("words: {}", words.join(" ")));
    }
}

#[test]
fn rewording_a_help_changes_no_fix() {
    let pages = Path::new(env!("CARGO_TARGET_TMPDIR")).join("helps");
    let (mut reworded, mut fixes) = (0, 0);
    for rule in rules::all() {
        for (number, block) in blocks(rule).iter().enumerate().filter(|(_, b)| b.bad) {
            let (file, _) = write(rule, number, block, &pages);
            let session = session(rule, &pages.join(rule.name).join(number.to_string()));
            let mut expansion = expanded(&session, &file);
            if expansion.problems.is_empty() {
                continue;
            }
            let before = findings(&session, &file, rule, &expansion);
            shuffle(&mut expansion);
            let after = findings(&session, &file, rule, &expansion);
            assert_eq!(
                offers(&after),
                offers(&before),
                "docs/rules/{}.md:{}",
                rule.name,
                block.line
            );
            let pairs = before.iter().zip(&after);
            reworded += pairs.filter(|(old, new)| old.help != new.help).count();
            let of_problems = after.iter().filter(|found| found.problem.is_some());
            fixes += of_problems.filter(|found| found.fix.is_some()).count();
        }
    }
    assert!(
        reworded > 60 && fixes > 20,
        "{reworded} helps and {fixes} fixes are too few to say anything"
    );
}
