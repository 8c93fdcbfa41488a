//! Launch files in XML, those of ROS 1 and those of ROS 2.

use std::path::Path;

use base::TextRange;
use base::limits::{LAUNCH_DEPTH, MANIFEST_NODES};
use roxmltree::{Attribute, Document, Node, ParsingOptions};

use super::command::is_xacro_program;
use super::element;
use super::text::Text;
use super::{
    CONTROL_NODE, CommandForm, DeclaredArgument, LaunchCommand, LaunchFile, LaunchInclude, SPAWNER,
    TRANSFORM_PUBLISHER,
};

/// What a launch file calls; nothing of text that is no XML.
pub(super) fn read(path: &Path, text: &str) -> LaunchFile {
    let mut file = LaunchFile::of(path);
    let options = ParsingOptions {
        nodes_limit: MANIFEST_NODES,
        ..ParsingOptions::default()
    };
    let Ok(document) = Document::parse_with_options(text, options) else {
        return file;
    };
    if document.root_element().tag_name().name() != "launch" {
        return file;
    }
    // only ROS 1 has these
    let old = ["$(find ", "$(arg ", "<rosparam"];
    file.shares = !old.iter().any(|word| text.contains(word)) || text.contains("$(var ");
    let folder = vfs::slashed(path.parent().unwrap_or(path));
    let mut reader = LaunchXmlReader {
        file,
        folder,
        assumed: Vec::new(),
    };
    reader.children(document.root_element(), 0);
    reader.file
}

struct LaunchXmlReader {
    file: LaunchFile,
    folder: String,
    /// Arguments that the conditions around read.
    assumed: Vec<String>,
}

impl LaunchXmlReader {
    fn children(&mut self, node: Node<'_, '_>, depth: usize) {
        for child in node.children().filter(Node::is_element) {
            let assumed = self.assumed.len();
            self.condition(child);
            self.element(child);
            if depth < LAUNCH_DEPTH && child.tag_name().name() != "include" {
                self.children(child, depth + 1);
            }
            self.assumed.truncate(assumed);
        }
    }

    /// What an element is under: the arguments that its condition reads.
    fn condition(&mut self, node: Node<'_, '_>) {
        for attribute in ["if", "unless"] {
            if let Some(value) = node.attribute(attribute) {
                let text = self.text(value, None);
                text.arguments(&mut |name| self.assumed.push(name.to_owned()));
                // an expression may name them in its own way: `$(eval arg('name'))`, `$(eval name == 1)`
                if value.contains("eval") {
                    let words = value.split(|c: char| !(c.is_alphanumeric() || c == '_'));
                    self.assumed
                        .extend(words.filter(|word| !word.is_empty()).map(str::to_owned));
                }
            }
        }
    }

    fn element(&mut self, node: Node<'_, '_>) {
        match node.tag_name().name() {
            "arg" | "let" => self.argument(node),
            "include" => self.include(node),
            _ => {}
        }
        for attribute in node.attributes() {
            self.attribute(node, attribute);
        }
    }

    fn attribute(&mut self, node: Node<'_, '_>, attribute: Attribute<'_, '_>) {
        let range = range(attribute.range_value());
        let text = |reader: &Self| reader.text(attribute.value(), Some(range));
        match (node.tag_name().name(), attribute.name()) {
            (_, "exec") if attribute.value() == CONTROL_NODE => {
                let words = CommandForm::Words(Vec::new());
                let command = LaunchCommand::at(range, words, self.assumed.clone());
                command.add_to(&mut self.file.control_nodes);
            }
            ("param", "command") => self.command(range, text(self), false),
            ("param", "textfile") => self.load(range, CommandForm::Words(vec![text(self)])),
            ("param", "from") | ("include", "file") => {
                self.file(range, CommandForm::Words(vec![text(self)]));
            }
            ("rosparam", "file") if is_loaded(node) => {
                self.file(range, CommandForm::Words(vec![text(self)]));
            }
            ("node", "args") => self.words(node, range, text(self)),
            _ if attribute.value().contains("$(command") => {
                let mut lines = Vec::new();
                element::text(attribute.value(), Some(range), &self.folder, &mut lines);
                // of a parameter whose type is given, launch takes the text as it is
                let is_untyped = node.has_tag_name("param")
                    && attribute.name() == "value"
                    && !node.has_attribute("type");
                lines
                    .into_iter()
                    .for_each(|line| self.command(range, line, is_untyped));
            }
            _ => {}
        }
    }

    /// What a node is started with.
    fn words(&mut self, node: Node<'_, '_>, range: TextRange, words: Text) {
        let words = CommandForm::Line(words);
        let program = node.attribute("type").or_else(|| node.attribute("exec"));
        let command = LaunchCommand::at(range, words.clone(), self.assumed.clone());
        if program == Some(TRANSFORM_PUBLISHER) {
            command.add_to(&mut self.file.transforms);
        } else if node.attribute("exec") == Some(SPAWNER) {
            command.add_to(&mut self.file.spawners);
        } else if program.is_none_or(|program| !is_xacro_program(program)) {
            self.file(range, words.clone());
            self.load(range, words);
        }
    }

    fn command(&mut self, range: TextRange, line: Text, is_read_as_yaml: bool) {
        let assumed = self.assumed.clone();
        let mut command = LaunchCommand::at(range, CommandForm::Line(line), assumed);
        command.is_read_as_yaml = is_read_as_yaml;
        command.add_to(&mut self.file.commands);
    }

    fn load(&mut self, range: TextRange, what: CommandForm) {
        let assumed = self.assumed.clone();
        LaunchCommand::at(range, what, assumed).add_to(&mut self.file.loads);
    }

    fn file(&mut self, range: TextRange, what: CommandForm) {
        let assumed = self.assumed.clone();
        LaunchCommand::at(range, what, assumed).add_to(&mut self.file.files);
    }

    fn argument(&mut self, node: Node<'_, '_>) {
        let Some(name) = node.attribute("name") else {
            return;
        };
        let fixed = node.attribute("value");
        let is_conditional = node.has_attribute("if") || node.has_attribute("unless");
        let default = node
            .attribute_node("value")
            .or_else(|| node.attribute_node("default"))
            .map(|value| self.text(value.value(), Some(range(value.range_value()))));
        // of two that conditions choose from, none is certain
        let default = if is_conditional {
            Some(Text::opaque())
        } else {
            default
        };
        let choices: Vec<String> = node
            .children()
            .filter(|child| child.has_tag_name("choice"))
            .filter_map(|child| child.attribute("value").map(str::to_owned))
            .collect();
        let declared = DeclaredArgument {
            name: name.to_owned(),
            default,
            choices: (!choices.is_empty()).then_some(choices),
            range: range(node.range()),
            is_fixed: fixed.is_some(),
        };
        self.file.declared.push(declared);
    }

    fn include(&mut self, node: Node<'_, '_>) {
        let Some(file) = node.attribute("file").map(|file| self.text(file, None)) else {
            return;
        };
        let mut args = Vec::new();
        for child in node
            .children()
            .filter(|child| child.has_tag_name("arg") || child.has_tag_name("let"))
        {
            let value = child
                .attribute("value")
                .or_else(|| child.attribute("default"));
            if let (Some(name), Some(value)) = (child.attribute("name"), value) {
                let is_conditional = child.has_attribute("if") || child.has_attribute("unless");
                let at = child
                    .attribute_node("value")
                    .map(|one| range(one.range_value()));
                let value = if is_conditional {
                    Text::opaque()
                } else {
                    self.text(value, at)
                };
                if let Some(at) = at {
                    self.file(at, CommandForm::Words(vec![value.clone()]));
                }
                args.push((name.to_owned(), value.without_places()));
            }
        }
        if node
            .attribute("pass_all_args")
            .is_some_and(|all| all != "false")
        {
            let own: Vec<String> = self
                .file
                .declared
                .iter()
                .map(|own| own.name.clone())
                .collect();
            let own = own
                .into_iter()
                .filter(|name| !args.iter().any(|(known, _)| known == name));
            let own: Vec<_> = own
                .map(|name| (name.clone(), Text::argument(&name)))
                .collect();
            args.extend(own);
        }
        let (range, assumed) = (range(node.range()), self.assumed.clone());
        self.file.includes.push(LaunchInclude {
            file,
            args,
            open: false,
            range,
            assumed,
        });
    }

    fn text(&self, value: &str, at: Option<TextRange>) -> Text {
        element::text(value, at, &self.folder, &mut Vec::new())
    }
}

/// Whether parameters are read from a file, not written to one.
fn is_loaded(node: Node<'_, '_>) -> bool {
    let command = node.attribute("command");
    command.is_none_or(|command| command == "load")
}

fn range(range: std::ops::Range<usize>) -> TextRange {
    TextRange::new(range.start as u32, range.end as u32)
}
