//! `[[roots]]`: entry files, the arguments they are run with, and what is expected of them.

use super::ConfigLocation;
use super::apply::Applier;
use super::expect::{Expectation, ExpectedJoint};
use super::keys::{CHOICES, EXPECT, JOINT, ROOTS};
use super::roots::{Axes, Root, XacroArgs};
use super::value::{ConfigEntry, ConfigValue, ValueKind};
use base::TextRange;
use base::limits::MATRIX_RUNS;

/// Arguments with the places of their names.
type LocatedArgs = Vec<(String, ConfigLocation)>;

impl Applier {
    pub(super) fn roots(&mut self, entry: &ConfigEntry) -> Vec<Root> {
        let mut roots = Vec::new();
        for value in self.values(entry) {
            match &value.kind {
                ValueKind::Table(fields) => roots.extend(self.root(fields, value.range)),
                _ => self.wrong("roots", value, "a list of tables"),
            }
        }
        roots
    }

    fn root(&mut self, fields: &[ConfigEntry], range: TextRange) -> Option<Root> {
        let mut root = Root::new(self.folder.clone(), self.place(range));
        let mut file = None;
        let mut args_at = range;
        for field in self.known(fields, ROOTS, "roots") {
            match field.key.as_str() {
                "file" => {
                    file = self
                        .text(field)
                        .map(|text| (text.to_owned(), field.value.range))
                }
                "args" => {
                    root.args = self.axes(field, &mut root.given);
                    args_at = field.value.range;
                }
                "exclude" => root.exclude = self.excluded(field, &mut root.given),
                "choices" => {
                    root.launch_choices = self.word(&field.key, &field.value, CHOICES).is_some();
                }
                "expect" => root.expect = self.expectations(field, &mut root.given),
                _ => {
                    for preset in self.table(field) {
                        let args = self.args(preset, &mut root.given);
                        root.presets.push((preset.key.clone(), args));
                    }
                }
            }
        }
        let count = root.combinations(&Axes::new());
        if count > MATRIX_RUNS as u64 {
            self.warn(
                args_at,
                format!("{count} combinations of arguments; only {MATRIX_RUNS} are used"),
                None,
            );
        }
        let has_file_key = fields.iter().any(|field| field.key == "file");
        match file {
            Some((file, range)) => Some(Root {
                file,
                place: self.place(range),
                ..root
            }),
            None if has_file_key => None,
            None => {
                self.warn(range, "an entry of `roots` has no `file`".to_owned(), None);
                None
            }
        }
    }

    /// Arguments as they would be typed after `name:=`.
    fn args(&mut self, entry: &ConfigEntry, given: &mut LocatedArgs) -> XacroArgs {
        let mut args = XacroArgs::new();
        for field in self.table(entry) {
            let Some(value) = argument(&field.value) else {
                self.wrong(&field.key, &field.value, "a string, number or boolean");
                continue;
            };
            given.push((field.key.clone(), self.place(field.key_range)));
            args.push((field.key.clone(), value));
        }
        args
    }

    /// The same; each may have several values.
    fn axes(&mut self, entry: &ConfigEntry, given: &mut LocatedArgs) -> Axes {
        let fields = self.table(entry);
        self.axes_of(fields, given)
    }

    fn axes_of(&mut self, fields: &[ConfigEntry], given: &mut LocatedArgs) -> Axes {
        const WANTED: &str = "a string, number or boolean, or a list of these";
        let mut axes = Axes::new();
        for field in fields {
            let values = match &field.value.kind {
                ValueKind::List(items) if items.is_empty() => {
                    self.warn(
                        field.value.range,
                        format!("`{}` has no values", field.key),
                        None,
                    );
                    continue;
                }
                ValueKind::List(items) => items.iter().map(argument).collect(),
                _ => argument(&field.value).map(|value| vec![value]),
            };
            let Some(mut values): Option<Vec<String>> = values else {
                self.wrong(&field.key, &field.value, WANTED);
                continue;
            };
            // a value that is listed twice would be the same run twice
            let mut known = base::FastSet::default();
            values.retain(|value| known.insert(value.clone()));
            given.push((field.key.clone(), self.place(field.key_range)));
            axes.push((field.key.clone(), values));
        }
        axes
    }

    fn excluded(&mut self, entry: &ConfigEntry, given: &mut LocatedArgs) -> Vec<Axes> {
        let mut excluded = Vec::new();
        for value in self.values(entry) {
            match &value.kind {
                ValueKind::Table(fields) => excluded.push(self.axes_of(fields, given)),
                _ => self.wrong("exclude", value, "a list of tables"),
            }
        }
        // an empty table would leave out everything
        excluded.retain(|axes| !axes.is_empty());
        excluded
    }

    // Expectations.

    fn expectations(&mut self, entry: &ConfigEntry, given: &mut LocatedArgs) -> Vec<Expectation> {
        let mut expectations = Vec::new();
        for value in self.values(entry) {
            match &value.kind {
                ValueKind::Table(fields) => {
                    expectations.push(self.expectation(fields, value, given))
                }
                _ => self.wrong("expect", value, "a list of tables"),
            }
        }
        expectations
    }

    fn expectation(
        &mut self,
        fields: &[ConfigEntry],
        value: &ConfigValue,
        given: &mut LocatedArgs,
    ) -> Expectation {
        let mut expected = Expectation::new(self.place(value.range), value.json());
        for field in self.known(fields, EXPECT, "expect") {
            match field.key.as_str() {
                "name" => expected.name = self.text(field).map(str::to_owned),
                "when" => expected.when = self.axes(field, given),
                "root" => expected.root = self.text(field).map(str::to_owned),
                "links" => expected.links = self.texts(field),
                "no-links" => expected.no_links = self.texts(field),
                "joints" => expected.joints = self.texts(field),
                "no-joints" => expected.no_joints = self.texts(field),
                "link-count" => expected.link_count = self.whole(field),
                "joint-count" => expected.joint_count = self.whole(field),
                "moving-joint-count" => expected.moving_joint_count = self.whole(field),
                "chains" => expected.chains = self.chains(field),
                "mass" => expected.mass = self.number(field),
                "mass-tolerance" => {
                    expected.mass_tolerance =
                        self.tolerance(field).unwrap_or(expected.mass_tolerance);
                }
                "joint" => expected.joint = self.joints(field),
                "command-interfaces" => expected.command_interfaces = self.lists(field),
                "state-interfaces" => expected.state_interfaces = self.lists(field),
                _ => expected.expands_to = self.text(field).map(str::to_owned),
            }
        }
        expected
    }

    fn joints(&mut self, entry: &ConfigEntry) -> Vec<(String, ExpectedJoint)> {
        let mut joints = Vec::new();
        for field in self.table(entry) {
            let fields = self.table(field);
            let mut joint = ExpectedJoint::default();
            for field in self.known(fields, JOINT, &format!("joint.{}", field.key)) {
                match field.key.as_str() {
                    "type" => joint.kind = self.text(field).map(str::to_owned),
                    "parent" => joint.parent = self.text(field).map(str::to_owned),
                    "child" => joint.child = self.text(field).map(str::to_owned),
                    "mimic" => joint.mimic = self.text(field).map(str::to_owned),
                    "lower" => joint.lower = self.number(field),
                    "upper" => joint.upper = self.number(field),
                    "effort" => joint.effort = self.number(field),
                    "velocity" => joint.velocity = self.number(field),
                    _ => joint.tolerance = self.tolerance(field).unwrap_or(joint.tolerance),
                }
            }
            joints.push((field.key.clone(), joint));
        }
        joints
    }

    /// Lists of at least two links.
    fn chains(&mut self, entry: &ConfigEntry) -> Vec<Vec<String>> {
        let mut chains = Vec::new();
        for value in self.values(entry) {
            let names = match &value.kind {
                ValueKind::List(items) if items.len() > 1 => items.iter().map(text).collect(),
                _ => None,
            };
            match names {
                Some(names) => chains.push(names),
                None => self.wrong(&entry.key, value, "a list of lists of two or more links"),
            }
        }
        chains
    }

    fn lists(&mut self, entry: &ConfigEntry) -> Vec<(String, Vec<String>)> {
        let fields = self.table(entry).iter();
        fields
            .map(|field| (field.key.clone(), self.texts(field)))
            .collect()
    }

    fn number(&mut self, entry: &ConfigEntry) -> Option<f64> {
        let number = match entry.value.kind {
            ValueKind::Int(Some(value)) => Some(value as f64),
            ValueKind::Float(value, _) => Some(value),
            _ => None,
        };
        let number = number.filter(|number| number.is_finite());
        if number.is_none() {
            self.wrong(&entry.key, &entry.value, "a finite number");
        }
        number
    }

    fn tolerance(&mut self, entry: &ConfigEntry) -> Option<f64> {
        let number = self.number(entry)?;
        if number < 0.0 {
            self.warn(
                entry.value.range,
                format!("`{}` must not be negative", entry.key),
                None,
            );
        }
        (number >= 0.0).then_some(number)
    }

    fn whole(&mut self, entry: &ConfigEntry) -> Option<usize> {
        let ValueKind::Int(value) = entry.value.kind else {
            self.wrong(&entry.key, &entry.value, "an integer");
            return None;
        };
        let count = value.and_then(|value| usize::try_from(value).ok());
        if count.is_none() {
            self.warn(
                entry.value.range,
                format!("`{}` must not be negative", entry.key),
                None,
            );
        }
        count
    }
}

/// An argument as it would be typed after `name:=`.
fn argument(value: &ConfigValue) -> Option<String> {
    match &value.kind {
        ValueKind::Text(text) => Some(text.clone()),
        ValueKind::Int(Some(value)) => Some(value.to_string()),
        ValueKind::Float(_, text) => Some(text.clone()),
        ValueKind::Bool(value) => Some(value.to_string()),
        _ => None,
    }
}

fn text(value: &ConfigValue) -> Option<String> {
    match &value.kind {
        ValueKind::Text(text) => Some(text.clone()),
        _ => None,
    }
}
