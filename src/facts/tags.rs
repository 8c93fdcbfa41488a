//! The tags of xacro itself.

/// A tag of xacro.
pub struct XacroTag {
    /// Its name without `xacro:`.
    pub name: &'static str,
    /// Whether elements of other languages often have this name.
    pub is_common_word: bool,
    /// What it does, as hover shows it.
    pub docs: &'static str,
    /// What it does, as completion shows it: shorter, in the imperative.
    pub summary: &'static str,
    /// Its attributes.
    pub attributes: &'static [XacroAttribute],
}

/// An attribute of a tag of xacro.
pub struct XacroAttribute {
    /// Its name.
    pub name: &'static str,
    /// Whether the tag means nothing without it.
    pub required: bool,
    /// What it says.
    pub docs: &'static str,
    /// The words that can be its value; none where it can be anything.
    pub words: &'static [&'static str],
}

const fn at(name: &'static str, docs: &'static str) -> XacroAttribute {
    XacroAttribute {
        name,
        required: false,
        docs,
        words: &[],
    }
}

const fn required(name: &'static str, docs: &'static str) -> XacroAttribute {
    XacroAttribute {
        name,
        required: true,
        docs,
        words: &[],
    }
}

const fn flag(name: &'static str, docs: &'static str) -> XacroAttribute {
    XacroAttribute {
        name,
        required: false,
        docs,
        words: &["true", "false"],
    }
}

/// All of them, in the order in which editors offer them.
pub static XACRO_TAGS: &[XacroTag] = &[
    XacroTag {
        name: "property",
        is_common_word: false,
        docs: "Defines a property: a named value or block of XML",
        summary: "Define a property: a named value or block",
        attributes: &[
            required("name", "The name used in expressions"),
            at("value", "The value; evaluated on first use"),
            at(
                "default",
                "The value, unless the property is already defined",
            ),
            XacroAttribute {
                name: "scope",
                required: false,
                docs: "Define the property in an outer scope",
                words: &["parent", "global"],
            },
            flag(
                "lazy_eval",
                "Whether the value is evaluated on first use instead of immediately",
            ),
            flag("remove", "Remove the property"),
        ],
    },
    XacroTag {
        name: "arg",
        is_common_word: false,
        docs: "A substitution argument, passed as `name:=value` and read as `$(arg name)`",
        summary: "Declare a substitution argument with its default",
        attributes: &[
            required("name", "The name used in `$(arg name)`"),
            at("default", "The value if none is passed"),
        ],
    },
    XacroTag {
        name: "include",
        is_common_word: false,
        docs: "Includes another file; `ns` puts its names in a namespace",
        summary: "Include another file",
        attributes: &[
            required(
                "filename",
                "The file, relative to this file or with `$(find package)`",
            ),
            at("ns", "Namespace for the macros and properties of the file"),
            flag("optional", "Whether the file may be missing"),
        ],
    },
    XacroTag {
        name: "macro",
        is_common_word: false,
        docs: "Defines a macro that is called as `<xacro:NAME …/>`",
        summary: "Define a macro: XML with parameters",
        attributes: &[
            required("name", "The name used to call the macro"),
            at(
                "params",
                "Parameters: `name`, `name:=default`, `*block`, `**blocks`",
            ),
        ],
    },
    XacroTag {
        name: "if",
        is_common_word: false,
        docs: "Keeps its content if `value` is true",
        summary: "Keep the content if the condition is true",
        attributes: &[required("value", "The condition")],
    },
    XacroTag {
        name: "unless",
        is_common_word: false,
        docs: "Keeps its content if `value` is false",
        summary: "Keep the content if the condition is false",
        attributes: &[required("value", "The condition")],
    },
    XacroTag {
        name: "insert_block",
        is_common_word: false,
        docs: "Inserts a block: an element passed by the call, or the content of a property",
        summary: "Insert a block parameter or a block property",
        attributes: &[required("name", "The name of the block")],
    },
    XacroTag {
        name: "call",
        is_common_word: true,
        docs: "Calls a macro with a computed name",
        summary: "Call a macro with a computed name",
        attributes: &[required("macro", "The name of the macro")],
    },
    XacroTag {
        name: "element",
        is_common_word: true,
        docs: "Creates an element with a computed name",
        summary: "Create an element with a computed name",
        attributes: &[required("xacro:name", "The name of the element")],
    },
    XacroTag {
        name: "attribute",
        is_common_word: true,
        docs: "Adds an attribute with a computed name to the parent element",
        summary: "Add an attribute with a computed name to the parent element",
        attributes: &[
            required("name", "The name of the attribute"),
            required("value", "Its value"),
        ],
    },
];

/// The tag `xacro:name`; none for a macro call.
pub fn xacro_tag(name: &str) -> Option<&'static XacroTag> {
    XACRO_TAGS.iter().find(|tag| tag.name == name)
}

/// Whether `xacro:name` is xacro's own and calls no macro.
pub fn is_keyword(name: &str) -> bool {
    // said in comments: `<!-- xacro:eval-comments -->`
    name == "eval-comments" || xacro_tag(name).is_some()
}
