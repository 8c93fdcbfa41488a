//! The kinds of problems: one for each rule about what expansion finds.

/// What kind of problem it is. The rule about it (`rules`) has the name of the variant in kebab case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ProblemKind {
    /// The text is not well-formed XML, or uses what expansion does not support.
    XmlSyntaxError,
    /// The prefix `xacro` is not declared.
    MissingXacroNamespace,
    /// The declared encoding is not that of the bytes.
    XmlEncodingMismatch,
    /// A name in an expression, or a key of a YAML file, that is not defined.
    UndefinedProperty,
    /// A call of a macro that is not defined.
    UndefinedMacro,
    /// `$(arg ...)` of an argument that is neither declared nor given.
    UndefinedArg,
    /// A block parameter that is not given, or `insert_block` of a name that is none.
    UndefinedBlock,
    /// A call without a parameter that has no default.
    MissingMacroParam,
    /// An attribute of a call that is no parameter of the macro.
    UnknownMacroParam,
    /// More elements in a call than the macro has block parameters, or fewer.
    MacroBlockMismatch,
    /// An include of a file that cannot be read.
    IncludeNotFound,
    /// A file that includes itself, directly or through others.
    IncludeCycle,
    /// A macro that was defined where it was meant to be called.
    RedefinedMacro,
    /// A property with the name of a built-in symbol.
    ShadowedBuiltin,
    /// A name of a property or parameter that no expression can read.
    InvalidPropertyName,
    /// A property that is defined by itself.
    PropertyCycle,
    /// An expression that does not parse.
    InvalidExpression,
    /// An expression whose evaluation fails.
    ExpressionError,
    /// `${` or `$(` without its end.
    UnclosedExpression,
    /// A condition that is neither true nor false.
    InvalidCondition,
    /// A built-in function that newer xacro has in a namespace only.
    DeprecatedBuiltinCall,
    /// A macro that is defined with the prefix `xacro:` in its name.
    MacroNameWithPrefix,
    /// An attribute that the xacro element does not have.
    UnknownXacroAttribute,
    /// A xacro element without an attribute that it needs, or with a misspelled one.
    MissingXacroAttribute,
    /// Elements inside an include.
    IncludeChildrenIgnored,
    /// A macro that calls itself without end, or another limit that is exceeded.
    InfiniteMacroRecursion,
    /// A pattern of an include that no file matches.
    GlobIncludeNoMatch,
    /// A property with two sources for its value.
    ConflictingPropertyAttributes,
    /// A name that is used before it is defined.
    UseBeforeDefinition,
    /// `scope="parent"` outside of a macro.
    ParentScopeAtTop,
    /// `default` of a property together with `scope`.
    DefaultWithScope,
    /// A name that no macro can have.
    InvalidMacroName,
    /// An include that binds a prefix to another namespace.
    InconsistentNamespaceRedefinition,
    /// `$(find ...)` of a package that is not found.
    PackageNotFound,
}

impl ProblemKind {
    /// Whether the text of a file is wrong, before anything in it is evaluated.
    pub fn is_about_text(self) -> bool {
        matches!(
            self,
            Self::XmlSyntaxError | Self::MissingXacroNamespace | Self::XmlEncodingMismatch
        )
    }

    /// Whether it is a name that nothing defines.
    pub fn is_undefined_name(self) -> bool {
        matches!(
            self,
            Self::UndefinedProperty
                | Self::UndefinedMacro
                | Self::UndefinedArg
                | Self::UndefinedBlock
        )
    }

    /// Whether elements may be missing from the expansion because of it.
    pub fn loses_content(self) -> bool {
        self.is_about_elements()
            || matches!(self, Self::XmlSyntaxError | Self::MissingXacroNamespace)
    }

    fn is_about_elements(self) -> bool {
        matches!(
            self,
            Self::UndefinedMacro
                | Self::UndefinedBlock
                | Self::IncludeCycle
                | Self::MissingXacroAttribute
                | Self::InfiniteMacroRecursion
                | Self::InvalidMacroName
        )
    }
}
