//! The tags of xacro itself.

/// A tag of xacro.
pub(super) struct DirectiveSpec {
    /// Its name with its prefix.
    pub name: &'static str,
    /// What it does, in a line.
    pub docs: &'static str,
    /// Its attributes.
    pub attributes: &'static [DirectiveAttribute],
    /// What to insert, behind its name.
    pub snippet: &'static str,
}

/// An attribute of a tag of xacro.
pub(super) struct DirectiveAttribute {
    pub name: &'static str,
    pub required: bool,
    pub docs: &'static str,
    /// The words that can be its value.
    pub words: &'static [&'static str],
}

const fn at(name: &'static str, docs: &'static str) -> DirectiveAttribute {
    DirectiveAttribute {
        name,
        required: false,
        docs,
        words: &[],
    }
}

const fn required(name: &'static str, docs: &'static str) -> DirectiveAttribute {
    DirectiveAttribute {
        name,
        required: true,
        docs,
        words: &[],
    }
}

const fn flag(name: &'static str, docs: &'static str) -> DirectiveAttribute {
    DirectiveAttribute {
        name,
        required: false,
        docs,
        words: &["true", "false"],
    }
}

/// All of them.
pub(super) static DIRECTIVES: &[DirectiveSpec] = &[
    DirectiveSpec {
        name: "xacro:property",
        docs: "Define a property: a named value or block",
        attributes: &[
            required("name", "The name used in expressions"),
            at("value", "The value; evaluated on first use"),
            at(
                "default",
                "The value, unless the property is already defined",
            ),
            DirectiveAttribute {
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
        snippet: " name=\"$1\" value=\"$2\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:arg",
        docs: "Declare a substitution argument with its default",
        attributes: &[
            required("name", "The name used in `$(arg name)`"),
            at("default", "The value if none is passed"),
        ],
        snippet: " name=\"$1\" default=\"$2\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:include",
        docs: "Include another file",
        attributes: &[
            required(
                "filename",
                "The file, relative to this file or with `$(find package)`",
            ),
            at("ns", "Namespace for the macros and properties of the file"),
            flag("optional", "Whether the file may be missing"),
        ],
        snippet: " filename=\"$1\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:macro",
        docs: "Define a macro: XML with parameters",
        attributes: &[
            required("name", "The name used to call the macro"),
            at(
                "params",
                "Parameters: `name`, `name:=default`, `*block`, `**blocks`",
            ),
        ],
        snippet: " name=\"$1\" params=\"$2\">\n\t$0\n</xacro:macro>",
    },
    DirectiveSpec {
        name: "xacro:if",
        docs: "Keep the content if the condition is true",
        attributes: &[required("value", "The condition")],
        snippet: " value=\"${1:\\${$2\\}}\">\n\t$0\n</xacro:if>",
    },
    DirectiveSpec {
        name: "xacro:unless",
        docs: "Keep the content if the condition is false",
        attributes: &[required("value", "The condition")],
        snippet: " value=\"${1:\\${$2\\}}\">\n\t$0\n</xacro:unless>",
    },
    DirectiveSpec {
        name: "xacro:insert_block",
        docs: "Insert a block parameter or a block property",
        attributes: &[required("name", "The name of the block")],
        snippet: " name=\"$1\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:call",
        docs: "Call a macro with a computed name",
        attributes: &[required("macro", "The name of the macro")],
        snippet: " macro=\"$1\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:element",
        docs: "Create an element with a computed name",
        attributes: &[required("xacro:name", "The name of the element")],
        snippet: " xacro:name=\"$1\"/>$0",
    },
    DirectiveSpec {
        name: "xacro:attribute",
        docs: "Add an attribute with a computed name to the parent element",
        attributes: &[
            required("name", "The name of the attribute"),
            required("value", "Its value"),
        ],
        snippet: " name=\"$1\" value=\"$2\"/>$0",
    },
];

/// The tag of a name.
pub(super) fn directive(name: &str) -> Option<&'static DirectiveSpec> {
    DIRECTIVES.iter().find(|directive| directive.name == name)
}
