//! A joint that names a link which does not exist.
use super::super::context::RobotCx;
use super::super::finding::{Edit, Help};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::missing_links::missing_links;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR003",
    name: "undefined-link",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("undefined-link"),
    check: Check::Named(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for missing in missing_links(cx) {
        let name = &missing.name;
        let (first, others) = (&missing.uses.first, &missing.uses.others);
        let message = format!(
            "joint `{}` has undefined {} link `{name}`",
            first.joint, first.end
        );
        let argument = out.argument(first.at).filter(|_| others.is_empty());
        let mut report = out.report(first.at, message);
        for other in others {
            report = report.also(
                other.at,
                format!("joint `{}` also uses it as {} link", other.joint, other.end),
            );
        }
        match &missing.nearest {
            Some(near) if first.literal => {
                let (rename, help) = (format!("rename to `{near}`"), Help::did_you_mean(near));
                report = report
                    .help(help)
                    .replace_with(Safety::Unsafe, rename, near.as_str());
            }
            Some(near) => {
                report = report.help(Help::did_you_mean(near));
                if let Some(span) = argument {
                    let edits = vec![Edit {
                        span,
                        content: near.to_string(),
                    }];
                    report = report.edits(
                        Safety::Unsafe,
                        format!("change argument to `{near}`"),
                        edits,
                    );
                }
            }
            None => {
                report = report.help(format!(
                    "add <link name=\"{name}\"/>, or use the name of an existing link"
                ))
            }
        }
        report.done();
    }
}
