//! The pieces of tags: names of elements, names that attributes give and use.

use super::super::expressions::ExprText;
use super::{Collector, Modifiers, TokenKind};
use base::TextRange;
use expand::parse_params;
use facts::is_keyword;
use xml::{Attr, Node};

const PLAIN: Modifiers = Modifiers(0);
const GIVEN: Modifiers = Modifiers::DECLARATION;

impl Collector<'_, '_> {
    /// The two tags of an element.
    pub fn element(&mut self, base: u32, node: Node<'_>) {
        let called = node.name().strip_prefix("xacro:");
        let is_call = called.is_some_and(|called| !is_keyword(called));
        if let Some(called) = called {
            for name in [Some(node.name_range()), node.end_name_range()]
                .into_iter()
                .flatten()
            {
                let (start, kind) = if is_call {
                    (
                        name.end.saturating_sub(called.len() as u32).max(name.start),
                        TokenKind::Macro,
                    )
                } else {
                    (name.start, TokenKind::Keyword)
                };
                self.add(TextRange::new(start, name.end).shift(base), kind, PLAIN);
            }
        }
        for attr in node
            .attrs()
            .filter(|attr| !attr.name().starts_with("xmlns"))
        {
            if is_call {
                self.add(attr.name_range().shift(base), TokenKind::Parameter, PLAIN);
            }
            self.attribute(base, node, attr);
        }
    }

    /// The expressions in character data.
    pub fn text(&mut self, base: u32, node: Node<'_>) {
        let document = &self.cx.source.document;
        self.template(
            &ExprText::of_text(document, base, node),
            node.parent(),
            None,
        );
    }

    fn attribute(&mut self, base: u32, node: Node<'_>, attr: Attr<'_>) {
        let document = &self.cx.source.document;
        let plain = self.value_kind(node, attr);
        let is_params = (node.name(), attr.name()) == ("xacro:macro", "params");
        let has_parts = attr.has_dollar() || attr.raw().contains("://");
        if plain.is_none() && !has_parts && !is_params {
            return;
        }
        let text = ExprText::of_attr(document, base, attr);
        self.template(&text, Some(node), plain);
        if is_params {
            self.parameters(&text);
        }
        if let Some(rest) = text.text.strip_prefix("package://") {
            let start = "package://".len();
            let end = start + rest.find('/').unwrap_or(rest.len());
            if !rest.starts_with('$') {
                let package = TextRange::new(start as u32, end as u32);
                self.add(text.range(package), TokenKind::Namespace, PLAIN);
            }
        }
    }

    /// What the value of an attribute names.
    fn value_kind(&self, node: Node<'_>, attr: Attr<'_>) -> Option<(TokenKind, Modifiers)> {
        Some(match (node.name(), attr.name()) {
            ("xacro:macro", "name") => (TokenKind::Macro, GIVEN),
            ("xacro:property", "name") => {
                let literal = node.attr("value").is_some_and(|value| !value.has_dollar());
                (
                    TokenKind::Variable,
                    if literal {
                        GIVEN.and(Modifiers::READONLY)
                    } else {
                        GIVEN
                    },
                )
            }
            ("xacro:arg", "name") => (TokenKind::Parameter, GIVEN),
            ("xacro:include", "ns") => (TokenKind::Namespace, GIVEN),
            ("xacro:insert_block", "name") => (TokenKind::Parameter, PLAIN),
            ("link", "name") => (TokenKind::Class, GIVEN),
            ("parent" | "child", "link") => (TokenKind::Class, PLAIN),
            ("gazebo", "reference") if self.is_joint(attr.raw()) => (TokenKind::Event, PLAIN),
            ("gazebo", "reference") => (TokenKind::Class, PLAIN),
            ("joint", "name") if is_in_hardware(node) => (TokenKind::Event, PLAIN),
            ("joint", "name") => (TokenKind::Event, GIVEN),
            ("mimic", "joint") => (TokenKind::Event, PLAIN),
            ("joint", "type") => (TokenKind::EnumMember, PLAIN),
            ("material", "name") if node.child_elements().next().is_some() => {
                (TokenKind::EnumMember, GIVEN)
            }
            ("material", "name") => (TokenKind::EnumMember, PLAIN),
            _ => return None,
        })
    }

    /// Whether the robot has a joint of the name.
    fn is_joint(&self, name: &str) -> bool {
        self.rests_on_robot.set(true);
        self.cx
            .robot
            .is_some_and(|robot| robot.joint(name).is_some())
    }

    /// The names in the list of parameters of a macro.
    fn parameters(&mut self, text: &ExprText<'_>) {
        for param in parse_params(&text.text).unwrap_or_default() {
            let name = param.name.trim_start_matches('*');
            let stars = (param.name.len() - name.len()) as u32;
            let range = TextRange::new(param.range.start + stars, param.range.end);
            self.add(text.range(range), TokenKind::Parameter, GIVEN);
        }
    }
}

/// Whether an element tells `ros2_control` or a transmission about a joint.
fn is_in_hardware(node: Node<'_>) -> bool {
    let parent = node.parent().map_or("", Node::name);
    matches!(parent, "ros2_control" | "transmission")
}
