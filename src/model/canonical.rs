//! What a reader of URDF takes from a text: two texts with the same canonical form describe the same robot.
//!
//! Left out are comments, white space, namespace addresses, the order of attributes, the spelling of numbers, values
//! that are the defaults of urdfdom, and elements that have no effect on the joint they stand in. The same form serves
//! the source: where its values are computed, nothing is assumed about them.

use roxmltree::{Attribute, Document, Node, NodeType, ParsingOptions};

/// Attributes whose values are numbers, or several numbers with blanks between.
const NUMERIC: [&str; 24] = [
    "xyz",
    "rpy",
    "ixx",
    "ixy",
    "ixz",
    "iyy",
    "iyz",
    "izz",
    "lower",
    "upper",
    "effort",
    "velocity",
    "radius",
    "length",
    "size",
    "scale",
    "rgba",
    "damping",
    "friction",
    "multiplier",
    "offset",
    "soft_lower_limit",
    "soft_upper_limit",
    "k_velocity",
];
/// Elements whose content is not URDF: the same names mean something else there.
const FOREIGN: [&str; 7] = [
    "gazebo",
    "sdf",
    "model",
    "world",
    "plugin",
    "ros2_control",
    "transmission",
];
/// The place and the angles of an origin that moves nothing.
const ZERO: &str = "0.0 0.0 0.0";
/// Elements deeper than this are not compared.
const DEPTH: usize = 200;

/// An element, reduced to what counts.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) attrs: Vec<(String, String)>,
    /// Text that is no white space, elements, in order.
    pub(super) children: Vec<Element>,
    /// Where it begins in the text; counts for nothing.
    pub(super) start: usize,
}

impl PartialEq for Element {
    fn eq(&self, other: &Self) -> bool {
        (&self.name, &self.attrs, &self.children) == (&other.name, &other.attrs, &other.children)
    }
}

/// Whether two texts describe the same robot under every argument. `None` when one of them cannot be compared: it is
/// not well-formed, has a document type, or lacks a namespace declaration.
pub fn same_robot(one: &str, other: &str) -> Option<bool> {
    if one == other {
        return Some(true);
    }
    Some(canonical(one)? == canonical(other)?)
}

/// The same, whatever the formats of collision meshes are: their file names may differ by what follows the last dot.
pub fn same_but_for_mesh_formats(one: &str, other: &str) -> Option<bool> {
    Some(without_mesh_formats(one)? == without_mesh_formats(other)?)
}

fn without_mesh_formats(text: &str) -> Option<Element> {
    let mut root = canonical(text)?;
    drop_mesh_formats(&mut root, false);
    Some(root)
}

/// The root element of a text; none when the text cannot be compared.
pub(super) fn canonical(text: &str) -> Option<Element> {
    let mut element = read(parsed(text)?.root_element(), text, 0)?;
    reduce(&mut element, false);
    Some(element)
}

/// The document of a text; none when it is not well-formed or has a document type.
pub(super) fn parsed(text: &str) -> Option<Document<'_>> {
    let options = ParsingOptions {
        allow_dtd: false,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).ok()
}

fn read(node: Node<'_, '_>, text: &str, depth: usize) -> Option<Element> {
    if depth > DEPTH {
        return None;
    }
    let name = text.get(node.range())?.trim_start_matches('<');
    let end = name.find(|c: char| c.is_ascii_whitespace() || matches!(c, '/' | '>'))?;
    let name = name.get(..end)?.to_owned();
    let attrs = node
        .attributes()
        .map(|attr| (written_name(&attr, text), value(&attr, &name)));
    let mut attrs: Vec<(String, String)> = attrs.collect();
    attrs.sort();
    let mut children = Vec::new();
    for child in node.children() {
        match child.node_type() {
            NodeType::Element => children.push(read(child, text, depth + 1)?),
            NodeType::Text => {
                children.extend(content(
                    child.text().unwrap_or_default(),
                    child.range().start,
                ));
            }
            _ => {}
        }
    }
    Some(Element {
        name,
        attrs,
        children,
        start: node.range().start,
    })
}

/// The name of an attribute with its prefix.
fn written_name(attr: &Attribute<'_, '_>, text: &str) -> String {
    text.get(attr.range_qname())
        .unwrap_or(attr.name())
        .to_owned()
}

/// Text as a child without name; none for white space.
fn content(text: &str, start: usize) -> Option<Element> {
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let attrs = vec![(String::new(), words.join(" "))];
    (!words.is_empty()).then(|| Element {
        name: String::new(),
        attrs,
        children: Vec::new(),
        start,
    })
}

/// The value of an attribute of `element`; numbers as one spelling of them. What tags of xacro are given may become part
/// of a name.
fn value(attr: &Attribute<'_, '_>, element: &str) -> String {
    let is_mass = attr.name() == "value" && element == "mass";
    let is_number = (NUMERIC.contains(&attr.name()) || is_mass) && !element.contains(':');
    let numbers = || {
        attr.value()
            .split_ascii_whitespace()
            .map(number)
            .collect::<Option<Vec<_>>>()
    };
    match is_number.then(numbers).flatten() {
        Some(numbers) if !numbers.is_empty() => numbers.join(" "),
        _ => without_braces(attr.value()),
    }
}

/// A text in which numbers stand as they are that were expressions of their own: `${-2.5}` is `-2.5`.
fn without_braces(text: &str) -> String {
    let mut parts = text.split("${");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        // `$${` is no expression
        match part
            .split_once('}')
            .filter(|(inner, _)| !out.ends_with('$') && prints_as_written(inner.trim()))
        {
            Some((inner, rest)) => out.extend([inner.trim(), rest]),
            None => out.extend(["${", part]),
        }
    }
    out
}

/// Whether Python prints a number the way it is written.
fn prints_as_written(number: &str) -> bool {
    let digits = number.strip_prefix('-').unwrap_or(number);
    let (whole, fraction) = digits
        .split_once('.')
        .map_or((digits, None), |(whole, rest)| (whole, Some(rest)));
    let is_whole = is_digits(whole) && (whole == "0" || !whole.starts_with('0'));
    let is_short = digits.len() <= 15 && !digits.starts_with("0.0000");
    is_whole
        && is_short
        && match fraction {
            None => number != "-0",
            Some("0") => whole != "0",
            Some(fraction) => is_digits(fraction) && !fraction.ends_with('0'),
        }
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// A number in decimal digits, as it is or as a whole expression.
fn number(word: &str) -> Option<String> {
    let inner = word
        .strip_prefix("${")
        .and_then(|rest| rest.strip_suffix('}'))
        .unwrap_or(word);
    let is_plain = inner
        .chars()
        .all(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E'));
    let number: f64 = inner.parse().ok().filter(|_| is_plain)?;
    // the sign of zero counts for nobody
    Some(format!("{:?}", number + 0.0))
}

/// Leave out what has no effect, and write out what is understood.
fn reduce(element: &mut Element, foreign: bool) {
    let foreign = foreign || FOREIGN.contains(&element.name.as_str());
    for child in &mut element.children {
        reduce(child, foreign);
    }
    if foreign {
        return;
    }
    match element.name.as_str() {
        "joint" => reduce_joint(element),
        "visual" | "collision" | "inertial" => drop_identity(element),
        _ => {}
    }
}

fn reduce_joint(joint: &mut Element) {
    drop_identity(joint);
    joint
        .children
        .retain(|child| child.name != "dynamics" || !child.is_empty());
    let kind = joint.attr("type").unwrap_or_default().to_owned();
    // conditions, calls and blocks may give any of the children
    let is_plain = joint.children.iter().all(|child| !child.name.contains(':'));
    match kind.as_str() {
        "fixed" | "floating" => joint.children.retain(|child| child.name != "axis"),
        "revolute" | "continuous" | "prismatic" | "planar" if is_plain && !joint.has("axis") => {
            let attrs = vec![("xyz".to_owned(), "1.0 0.0 0.0".to_owned())];
            let (name, start) = ("axis".to_owned(), joint.start);
            joint.children.push(Element {
                name,
                attrs,
                children: Vec::new(),
                start,
            });
        }
        _ => {}
    }
    if kind == "fixed" {
        joint
            .children
            .retain(|child| !matches!(child.name.as_str(), "limit" | "dynamics"));
    }
    if kind == "continuous" {
        for limit in joint
            .children
            .iter_mut()
            .filter(|child| child.name == "limit")
        {
            limit
                .attrs
                .retain(|(name, _)| !matches!(name.as_str(), "lower" | "upper"));
        }
    }
    if is_plain {
        joint.children.sort_by(|a, b| a.name.cmp(&b.name));
    }
}

/// Without an origin that moves nothing; of others, what they leave out is zero.
fn drop_identity(element: &mut Element) {
    for origin in element
        .children
        .iter_mut()
        .filter(|child| child.name == "origin")
    {
        for name in ["rpy", "xyz"] {
            if origin.attr(name).is_none() {
                origin.attrs.push((name.to_owned(), ZERO.to_owned()));
            }
        }
        origin.attrs.sort();
    }
    element
        .children
        .retain(|child| child.name != "origin" || child.moves());
}

/// Leave out how the file names of collision meshes end.
fn drop_mesh_formats(element: &mut Element, in_collision: bool) {
    let inside = in_collision || element.name == "collision";
    let files = element
        .attrs
        .iter_mut()
        .filter(|(name, _)| name == "filename");
    for (_, file) in files.filter(|_| inside && element.name == "mesh") {
        let stem = file
            .rsplit_once('.')
            .filter(|(_, ending)| !ending.contains('/'))
            .map(|(stem, _)| stem.len());
        file.truncate(stem.unwrap_or(file.len()));
    }
    for child in &mut element.children {
        drop_mesh_formats(child, inside);
    }
}

impl Element {
    pub(super) fn attr(&self, name: &str) -> Option<&str> {
        self.attrs
            .iter()
            .find(|(own, _)| own == name)
            .map(|(_, value)| value.as_str())
    }

    fn has(&self, name: &str) -> bool {
        self.children.iter().any(|child| child.name == name)
    }

    /// Whether it has neither attributes nor children.
    fn is_empty(&self) -> bool {
        self.attrs.is_empty() && self.children.is_empty()
    }

    /// Whether an origin is more than one that moves nothing.
    fn moves(&self) -> bool {
        let is_zero = |(name, value): &(String, String)| {
            matches!(name.as_str(), "rpy" | "xyz") && value == ZERO
        };
        !self.children.is_empty() || !self.attrs.iter().all(is_zero)
    }
}

#[cfg(test)]
mod tests {
    use super::{same_but_for_mesh_formats, same_robot};

    /// Whether two contents of a robot are the same to a reader.
    fn check_same(one: &str, other: &str, expected: bool) {
        let robot = |content: &str| format!("<robot name='r' xmlns:xacro='x'>{content}</robot>");
        assert_eq!(
            same_robot(&robot(one), &robot(other)),
            Some(expected),
            "{one}\n{other}"
        );
        assert_eq!(
            same_robot(&robot(other), &robot(one)),
            Some(expected),
            "{other}\n{one}"
        );
    }

    #[test]
    fn what_makes_no_difference() {
        for (one, other) in [
            ("<link name='a'/>", "\n <!-- x --> <link name=\"a\"></link>"),
            ("<a x='1' y='2'/>", "<a y='2' x='1'/>"),
            ("<box size='1 1.0 ${0.50}'/>", "<box size='1  1 0.5'/>"),
            (
                "<joint type='revolute'><parent/></joint>",
                "<joint type='revolute'><axis xyz='1 0 0'/><parent/></joint>",
            ),
            (
                "<joint type='fixed'/>",
                "<joint type='fixed'><axis xyz='0 0 1'/><limit lower='1'/></joint>",
            ),
            ("<visual><origin rpy='0 0 0'/></visual>", "<visual/>"),
            (
                "<visual><origin xyz='1 0 0'/></visual>",
                "<visual><origin xyz='1 0 0' rpy='0 -0.0 0'/></visual>",
            ),
            (
                "<joint type='continuous'><limit lower='1' effort='1'/></joint>",
                "<joint type='continuous'><limit effort='1'/></joint>",
            ),
            ("<xacro:a b='x${-2.5}y${3}'/>", "<xacro:a b='x-2.5y3'/>"),
            (
                "<joint type='revolute'><dynamics/></joint>",
                "<joint type='revolute'/>",
            ),
        ] {
            check_same(one, other, true);
        }
    }

    #[test]
    fn what_makes_one() {
        for (one, other) in [
            ("<link name='1'/>", "<link name='1.0'/>"),
            (
                "<link name='a'/><link name='b'/>",
                "<link name='b'/><link name='a'/>",
            ),
            ("<box size='1 1 1.57'/>", "<box size='1 1 ${pi/2}'/>"),
            (
                "<joint type='${t}'/>",
                "<joint type='${t}'><axis xyz='1 0 0'/></joint>",
            ),
            (
                "<joint type='revolute'><xacro:a/></joint>",
                "<joint type='revolute'><xacro:a/><axis xyz='1 0 0'/></joint>",
            ),
            (
                "<joint type='revolute'><axis xyz='0 0 2'/></joint>",
                "<joint type='revolute'><axis xyz='0 0 1'/></joint>",
            ),
            (
                "<gazebo><joint type='revolute'/></gazebo>",
                "<gazebo><joint type='revolute'><axis xyz='1 0 0'/></joint></gazebo>",
            ),
            ("<visual><origin xyz='0 0 ${z}'/></visual>", "<visual/>"),
            ("<a>1</a>", "<a>2</a>"),
            ("<a b='$${1}'/>", "<a b='$1'/>"),
            ("<a b='${0.50}'/>", "<a b='0.50'/>"),
            ("<a b='${-0}'/>", "<a b='-0'/>"),
            ("<a b='${010}'/>", "<a b='010'/>"),
            ("<xacro:if value='${a == 1}'/>", "<xacro:if value='${a}'/>"),
        ] {
            check_same(one, other, false);
        }
    }

    #[test]
    fn formats_of_collision_meshes() {
        for (one, other, expected) in [
            (
                "<collision><geometry><mesh filename='a/b.dae'/></geometry></collision>",
                "b.stl",
                true,
            ),
            (
                "<collision><geometry><mesh filename='a/b.dae'/></geometry></collision>",
                "c.stl",
                false,
            ),
            (
                "<visual><geometry><mesh filename='a/b.dae'/></geometry></visual>",
                "b.stl",
                false,
            ),
        ] {
            let robot =
                |content: &str| format!("<robot name='r'><link name='l'>{content}</link></robot>");
            let (one, other) = (robot(one), robot(&one.replace("b.dae", other)));
            assert_eq!(
                same_but_for_mesh_formats(&one, &other),
                Some(expected),
                "{one}\n{other}"
            );
            assert_eq!(same_robot(&one, &other), Some(false));
        }
    }

    #[test]
    fn texts_that_cannot_be_compared() {
        assert_eq!(same_robot("<robot><a></robot>", "<robot/>"), None);
        assert_eq!(
            same_robot(
                "<!DOCTYPE robot [<!ENTITY a 'b'>]><robot>&a;</robot>",
                "<robot/>"
            ),
            None
        );
        let deep = format!("{}{}", "<a>".repeat(5000), "</a>".repeat(5000));
        assert_eq!(same_robot(&deep, "<robot/>"), None);
    }
}
