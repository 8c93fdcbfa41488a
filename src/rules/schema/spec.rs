//! What the vocabulary says about an element and its attributes.
use model::Version;

/// An element below certain parents. Elements of one name below different parents have entries of their own.
#[derive(Clone, Copy, Debug)]
pub struct ElementSpec {
    /// Its name.
    pub name: &'static str,
    /// What its children call it: its name, unless an element elsewhere has the same name and other children.
    pub key: &'static str,
    /// The keys of the elements it may stand in; none for the root.
    pub parents: &'static [&'static str],
    /// What it is, in one line.
    pub docs: &'static str,
    /// Its attributes.
    pub attributes: &'static [AttributeSpec],
    /// Child elements that must be there.
    pub required: &'static [&'static str],
    /// Whether its parent may hold several.
    pub repeats: bool,
    /// Who decides about what stands inside.
    pub content: ContentModel,
}

/// What may stand inside an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContentModel {
    /// The elements that name it as a parent, and no text.
    Elements,
    /// Text.
    Text,
    /// Whatever the tool it is meant for reads: the table lists the usual elements only.
    Free,
}

/// An attribute of an element.
#[derive(Clone, Copy, Debug)]
pub struct AttributeSpec {
    /// Its name.
    pub name: &'static str,
    /// What its value is.
    pub kind: AttributeKind,
    /// Whether parsers refuse the element without it.
    pub required: bool,
    /// The unit of its numbers: rad, m, kg and so on.
    pub unit: Option<&'static str>,
    /// The value that parsers take where it is absent.
    pub default: Option<&'static str>,
    /// What it says, in one line.
    pub docs: &'static str,
    /// The version of URDF that brought it; readers pass over it in robots of an older one.
    pub since: Version,
}

/// What the value of an attribute is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AttributeKind {
    /// The name of the thing itself.
    Name,
    /// The name of a link.
    Link,
    /// The name of a joint.
    Joint,
    /// The name of a link or a joint.
    LinkOrJoint,
    /// The name of a planning group.
    Group,
    /// A number.
    Number,
    /// So many numbers, separated by blanks.
    Vector(usize),
    /// One of these words.
    Choice(&'static [&'static str]),
    /// Where a file is: `package://...`, `file://...`, a path.
    Uri,
    /// Any text.
    Text,
}

impl ElementSpec {
    pub(super) const fn new(
        name: &'static str,
        parents: &'static [&'static str],
        docs: &'static str,
    ) -> Self {
        let (attributes, required): (&[AttributeSpec], &[&str]) = (&[], &[]);
        Self {
            name,
            key: name,
            parents,
            docs,
            attributes,
            required,
            repeats: false,
            content: ContentModel::Elements,
        }
    }

    pub(super) const fn keyed(mut self, key: &'static str) -> Self {
        self.key = key;
        self
    }

    pub(super) const fn with(mut self, attributes: &'static [AttributeSpec]) -> Self {
        self.attributes = attributes;
        self
    }

    pub(super) const fn needs(mut self, children: &'static [&'static str]) -> Self {
        self.required = children;
        self
    }

    pub(super) const fn many(mut self) -> Self {
        self.repeats = true;
        self
    }

    pub(super) const fn holding(mut self, content: ContentModel) -> Self {
        self.content = content;
        self
    }

    /// The attribute of a name.
    pub fn attribute(&self, name: &str) -> Option<&'static AttributeSpec> {
        self.attributes
            .iter()
            .find(|attribute| attribute.name == name)
    }

    /// Whether it has to have the attribute of a name.
    pub fn requires(&self, name: &str) -> bool {
        self.attribute(name)
            .is_some_and(|attribute| attribute.required)
    }
}

impl AttributeSpec {
    pub(super) const fn new(name: &'static str, kind: AttributeKind, docs: &'static str) -> Self {
        Self {
            name,
            kind,
            required: false,
            unit: None,
            default: None,
            docs,
            since: Version::V1_0,
        }
    }

    pub(super) const fn required(mut self) -> Self {
        self.required = true;
        self
    }

    pub(super) const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = Some(unit);
        self
    }

    pub(super) const fn default(mut self, value: &'static str) -> Self {
        self.default = Some(value);
        self
    }

    pub(super) const fn since(mut self, version: Version) -> Self {
        self.since = version;
        self
    }

    /// How many numbers its value holds; none when it holds something else.
    pub fn numbers(&self) -> Option<usize> {
        match self.kind {
            AttributeKind::Number => Some(1),
            AttributeKind::Vector(count) => Some(count),
            _ => None,
        }
    }
}
