//! Rules whose findings come from expansion as they are: message, place and replacement.
use super::super::rule::Category::Xacro;
use super::super::rule::Safety::{Safe, Unsafe};
use super::super::rule::Severity::{Error, Info, Warning};
use super::super::rule::{Rule, page};

pub(in super::super) static UNDEFINED_PROPERTY: Rule = Rule::found(
    "XAC001",
    "undefined-property",
    Xacro,
    Error,
    page("undefined-property"),
)
.fixed(Unsafe);
pub(in super::super) static UNDEFINED_MACRO: Rule = Rule::found(
    "XAC002",
    "undefined-macro",
    Xacro,
    Error,
    page("undefined-macro"),
)
.fixed(Unsafe);
pub(in super::super) static UNDEFINED_ARG: Rule = Rule::found(
    "XAC003",
    "undefined-arg",
    Xacro,
    Error,
    page("undefined-arg"),
)
.fixed(Unsafe);
pub(in super::super) static UNDEFINED_BLOCK: Rule = Rule::found(
    "XAC004",
    "undefined-block",
    Xacro,
    Error,
    page("undefined-block"),
)
.fixed(Unsafe);
pub(in super::super) static MACRO_BLOCK_MISMATCH: Rule = Rule::found(
    "XAC007",
    "macro-block-mismatch",
    Xacro,
    Error,
    page("macro-block-mismatch"),
);
pub(in super::super) static INCLUDE_CYCLE: Rule = Rule::found(
    "XAC009",
    "include-cycle",
    Xacro,
    Error,
    page("include-cycle"),
);
pub(in super::super) static PROPERTY_CYCLE: Rule = Rule::found(
    "XAC023",
    "property-cycle",
    Xacro,
    Error,
    page("property-cycle"),
);
pub(in super::super) static INVALID_EXPRESSION: Rule = Rule::found(
    "XAC024",
    "invalid-expression",
    Xacro,
    Error,
    page("invalid-expression"),
)
.fixed(Safe);
pub(in super::super) static EXPRESSION_ERROR: Rule = Rule::found(
    "XAC025",
    "expression-error",
    Xacro,
    Error,
    page("expression-error"),
)
.fixed(Unsafe);
pub(in super::super) static UNCLOSED_EXPRESSION: Rule = Rule::found(
    "XAC026",
    "unclosed-expression",
    Xacro,
    Error,
    page("unclosed-expression"),
);
pub(in super::super) static INVALID_CONDITION: Rule = Rule::found(
    "XAC027",
    "invalid-condition",
    Xacro,
    Error,
    page("invalid-condition"),
);
pub(in super::super) static DEPRECATED_BUILTIN_CALL: Rule = Rule::found(
    "XAC029",
    "deprecated-builtin-call",
    Xacro,
    Info,
    page("deprecated-builtin-call"),
)
.fixed(Safe);
pub(in super::super) static MACRO_NAME_WITH_PREFIX: Rule = Rule::found(
    "XAC030",
    "macro-name-with-prefix",
    Xacro,
    Warning,
    page("macro-name-with-prefix"),
)
.fixed(Safe);
pub(in super::super) static MISSING_XACRO_ATTRIBUTE: Rule = Rule::found(
    "XAC032",
    "missing-xacro-attribute",
    Xacro,
    Error,
    page("missing-xacro-attribute"),
)
.fixed(Unsafe);
pub(in super::super) static INFINITE_MACRO_RECURSION: Rule = Rule::found(
    "XAC034",
    "infinite-macro-recursion",
    Xacro,
    Error,
    page("infinite-macro-recursion"),
);
pub(in super::super) static GLOB_INCLUDE_NO_MATCH: Rule = Rule::found(
    "XAC035",
    "glob-include-no-match",
    Xacro,
    Warning,
    page("glob-include-no-match"),
);
pub(in super::super) static CONFLICTING_PROPERTY_ATTRIBUTES: Rule = Rule::found(
    "XAC036",
    "conflicting-property-attributes",
    Xacro,
    Error,
    page("conflicting-property-attributes"),
);
pub(in super::super) static USE_BEFORE_DEFINITION: Rule = Rule::found(
    "XAC037",
    "use-before-definition",
    Xacro,
    Error,
    page("use-before-definition"),
);
pub(in super::super) static PARENT_SCOPE_AT_TOP: Rule = Rule::found(
    "XAC039",
    "parent-scope-at-top",
    Xacro,
    Warning,
    page("parent-scope-at-top"),
);
pub(in super::super) static DEFAULT_WITH_SCOPE: Rule = Rule::found(
    "XAC040",
    "default-with-scope",
    Xacro,
    Warning,
    page("default-with-scope"),
);
pub(in super::super) static INVALID_MACRO_NAME: Rule = Rule::found(
    "XAC041",
    "invalid-macro-name",
    Xacro,
    Error,
    page("invalid-macro-name"),
);
pub(in super::super) static INCONSISTENT_NAMESPACE_REDEFINITION: Rule = Rule::found(
    "XAC042",
    "inconsistent-namespace-redefinition",
    Xacro,
    Info,
    page("inconsistent-namespace-redefinition"),
);
