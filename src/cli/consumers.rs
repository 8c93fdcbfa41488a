//! `xacro-lint consumers`.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use super::args::{ConsumersArgs, Plain};
use super::io::Io;
use super::render::{shown_path, visible};
use super::text::counted;
use super::tree::{ExpandedRobot, explain, fails};
use analysis::{Report, Session};
use base::Encoding;
use expand::{Expansion, Origin};
use model::Robot;
use rules::consumers::{CONSUMERS, Consumer, Met, Outcome, Row, constructs, is_readable, rows};
use vfs::Environment;

/// Places of a construct that are printed.
const MOST_PLACES: usize = 3;

/// The matrix of a robot.
struct Matrix<'a> {
    consumers: Vec<&'static Consumer>,
    rows: Vec<Row<'a>>,
    /// Whether constructs that all of these consumers accept are shown too.
    all: bool,
    expansion: &'a Expansion,
    env: &'a Environment,
}

/// Run `consumers`.
pub(super) fn run(args: &ConsumersArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    if args.list {
        list(args.format, io);
        return 0;
    }
    let expanded = ExpandedRobot::of(&args.file, &args.package_path, env, io);
    let ExpandedRobot {
        file,
        arguments,
        session,
        expansion,
    } = match expanded {
        Ok(expanded) => expanded,
        Err(message) => return fails(io, &message),
    };
    if !is_readable(&expansion) {
        explain(&session, &file, arguments, env, io);
        io.line("error: cannot compare: programs are not given a file with the errors above");
        return 1;
    }
    let met = met(&session, &expansion, &file);
    let matrix = Matrix {
        consumers: wanted(&args.consumers),
        rows: rows(&met, args.all),
        all: args.all,
        expansion: &expansion,
        env,
    };
    match args.format {
        Plain::Text => io.out(&visible(&matrix.text())),
        Plain::Json => io.out(&format!("{:#}\n", matrix.json())),
    }
    0
}

/// The constructs of a robot.
fn met(session: &Session, expansion: &Expansion, file: &str) -> Vec<Met> {
    let settings = session.settings(&session.vfs.absolute(file.as_ref()));
    constructs(
        expansion,
        Robot::of(expansion).as_ref(),
        session.rule_env(&settings.config),
    )
}

fn wanted(names: &[String]) -> Vec<&'static Consumer> {
    let is_wanted =
        |consumer: &&Consumer| names.is_empty() || names.iter().any(|name| name == consumer.name);
    CONSUMERS.iter().filter(is_wanted).collect()
}

impl Matrix<'_> {
    /// The worst that a consumer does with the robot.
    fn verdict(&self, consumer: &Consumer) -> Outcome {
        self.rows
            .iter()
            .map(|row| row.construct.outcome(consumer))
            .max()
            .unwrap_or(Outcome::Accepts)
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for outcome in [Outcome::Rejects, Outcome::Changes, Outcome::Accepts] {
            let who = self
                .consumers
                .iter()
                .filter(|consumer| self.verdict(consumer) == outcome);
            let who: Vec<&str> = who.map(|consumer| consumer.title).collect();
            if !who.is_empty() {
                text.push_str(&format!("{:8}  {}\n", past(outcome), who.join(", ")));
            }
        }
        let judged = |consumer: &&&Consumer| self.verdict(consumer) > Outcome::Accepts;
        let columns: Vec<&&Consumer> = self.consumers.iter().filter(judged).collect();
        let rows: Vec<_> = self
            .rows
            .iter()
            .filter(|row| self.all || is_judged(row, &columns))
            .collect();
        if !columns.is_empty() && !rows.is_empty() {
            let names: Vec<&str> = columns.iter().map(|consumer| consumer.name).collect();
            text.push_str("\nx rejects, ~ changes or ignores, - accepts\n\n");
            text.push_str(&format!("{}\n", names.join("  ")));
        }
        for row in rows {
            text.push_str(&self.line(row, &columns));
        }
        text
    }

    /// A row: a mark below each consumer, the construct, and where it is.
    fn line(&self, row: &Row<'_>, columns: &[&&Consumer]) -> String {
        let marks = columns
            .iter()
            .map(|consumer| (mark(row.construct.outcome(consumer)), consumer.name.len()))
            .map(|(mark, width)| format!("{mark:width$}"));
        let marks: Vec<String> = marks.collect();
        let places: Vec<String> = row
            .met
            .iter()
            .take(MOST_PLACES)
            .map(|met| self.place(met))
            .collect();
        let more = row.met.len().saturating_sub(MOST_PLACES);
        let more = if more > 0 {
            format!(" and {}", counted(more, "more place"))
        } else {
            String::new()
        };
        format!(
            "{}  {}: {}{more}\n",
            marks.join("  "),
            row.construct.title,
            places.join(", ")
        )
    }

    /// `arm.urdf:12:5 (joint `elbow`)`
    fn place(&self, met: &Met) -> String {
        let (path, line, column) = self.position(met.origin);
        format!("{path}:{line}:{column} ({})", met.owner)
    }

    fn position(&self, origin: Origin) -> (String, u32, u32) {
        let place = self.expansion.place(origin);
        let file = place.and_then(|place| self.expansion.files.get(place.file));
        let (Some(place), Some(file)) = (place, file) else {
            return (String::new(), 1, 1);
        };
        let at = file
            .source
            .document
            .line_col(place.range.start, Encoding::Utf32);
        (
            shown_path(&file.source.path, &self.env.cwd),
            at.line + 1,
            at.col + 1,
        )
    }

    fn json(&self) -> Value {
        let verdicts = self.consumers.iter().map(|consumer| {
            (
                consumer.name.to_owned(),
                json!(self.verdict(consumer).name()),
            )
        });
        let rows = self.rows.iter().map(|row| {
            let outcomes = self.consumers.iter().map(|consumer| {
                (
                    consumer.name.to_owned(),
                    json!(row.construct.outcome(consumer).name()),
                )
            });
            let places = row.met.iter().map(|met| {
                let (path, line, column) = self.position(met.origin);
                json!({"file": path, "line": line, "column": column, "of": met.owner})
            });
            json!({
                "construct": row.construct.name,
                "title": row.construct.title,
                "help": row.construct.help,
                "outcomes": Value::Object(outcomes.collect()),
                "places": places.collect::<Vec<_>>(),
            })
        });
        json!({
            "consumers": Value::Object(verdicts.collect()),
            "constructs": rows.collect::<Vec<_>>(),
        })
    }
}

/// What programs reject or change of the robots that were checked, when nobody named any, and how to see it.
pub(super) fn counted_line(
    report: &Report,
    args: &[(String, String)],
    cwd: &Path,
) -> Option<String> {
    let (first, _) = report.consumers.first_key_value()?;
    let constructs: BTreeMap<_, _> = report.consumers.values().flatten().collect();
    let (mut rejected, mut changed) = (0, 0);
    for worst in constructs.values() {
        match worst {
            Outcome::Rejects => rejected += 1,
            Outcome::Changes => changed += 1,
            Outcome::Accepts => {}
        }
    }
    let what = match (rejected, changed) {
        (rejected, 0) => format!("reject {}", counted(rejected, "construct")),
        (0, changed) => format!("change or ignore {}", counted(changed, "construct")),
        (rejected, changed) => {
            format!(
                "reject {} and change or ignore {changed}",
                counted(rejected, "construct")
            )
        }
    };
    let (of, command) = match report.consumers.len() {
        1 => {
            let args: Vec<String> = args
                .iter()
                .map(|(name, value)| format!(" {name}:={value}"))
                .collect();
            (
                String::new(),
                format!("{}{}", shown_path(first, cwd), args.concat()),
            )
        }
        robots => (
            format!(" in {}", counted(robots, "robot")),
            "FILE".to_owned(),
        ),
    };
    Some(visible(&format!(
        "some programs {what}{of}: run `xacro-lint consumers {command}`"
    )))
}

/// Whether one of the consumers does not take what a row is about.
fn is_judged(row: &Row<'_>, consumers: &[&&Consumer]) -> bool {
    consumers
        .iter()
        .any(|consumer| row.construct.outcome(consumer) > Outcome::Accepts)
}

/// How an outcome is shown in the table.
fn mark(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Rejects => "x",
        Outcome::Changes => "~",
        Outcome::Accepts => "-",
    }
}

fn past(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Rejects => "rejected",
        Outcome::Changes => "changed",
        Outcome::Accepts => "accepted",
    }
}

/// The consumers that the table knows.
fn list(format: Plain, io: &mut Io<'_>) {
    match format {
        Plain::Text => {
            for consumer in CONSUMERS {
                io.out(&format!("{:14}  {}\n", consumer.name, consumer.measured));
            }
        }
        Plain::Json => {
            let all = CONSUMERS.iter().map(|consumer| {
                json!({"name": consumer.name, "title": consumer.title, "aliases": consumer.aliases, "measured": consumer.measured})
            });
            io.out(&format!("{:#}\n", Value::Array(all.collect())));
        }
    }
}
