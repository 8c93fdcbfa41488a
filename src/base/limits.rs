//! Every limit that keeps hostile input from taking time, memory or the screen without end, in one place.
//!
//! `docs/limits.md` is made from this table by `UPDATE=1 cargo test --test limits`; a test holds that each limit names
//! a test that reaches it. Lengths of what is shown in one hover, hint or title are no limits and stand where they
//! are used.

/// A limit as the documentation lists it.
#[derive(Clone, Copy, Debug)]
pub struct DocumentedLimit {
    /// The part of the program it belongs to.
    pub group: &'static str,
    /// The name of its constant.
    pub name: &'static str,
    /// Its value.
    pub value: u64,
    /// What is counted.
    pub what: &'static str,
    /// What one sees when it is reached.
    pub then: &'static str,
    /// Its key under `[limits]` in the configuration, where it can be raised.
    pub key: Option<&'static str>,
}

macro_rules! limits {
    ($($group:literal { $(#[doc = $what:literal] $name:ident: $type:ty = $value:expr, $then:literal $(, $key:literal)?;)+ })+) => {
        $($(#[doc = $what] pub const $name: $type = $value;)+)+

        /// All of them.
        pub const ALL: &[DocumentedLimit] = &[$($(DocumentedLimit {
            group: $group,
            name: stringify!($name),
            value: $name as u64,
            what: $what,
            then: $then,
            key: [$(Some($key),)? None][0],
        },)+)+];
    };
}

limits! {
    "Files" {
        /// Megabytes (10^6 bytes) of a description, YAML file or configuration that is read.
        FILE_MB: u64 = 20, "an error where the file is used, or on the command line", "file-mb";
        /// Megabytes that `file-mb` may be set to.
        FILE_MB_MOST: u64 = 1_000, "a warning in the configuration";
        /// Bytes of standard input.
        STDIN_BYTES: u64 = 20_000_000, "the command ends with an error";
        /// Bytes of a mesh.
        MESH_BYTES: u64 = 100_000_000, "`corrupt-mesh` at the mesh";
        /// Bytes of a material library of a mesh.
        MATERIAL_BYTES: u64 = 10_000_000, "its textures are not checked";
        /// Bytes of a mesh that the server rewrites.
        REWRITTEN_MESH_BYTES: u64 = 100 << 20, "the action is disabled, with the reason";
    }
    "XML" {
        /// Bytes of a document; edits beyond this size are ignored.
        XML_BYTES: usize = 1 << 30, "cannot occur: files and messages have lower limits";
        /// Bytes of one entity after expansion.
        ENTITY_BYTES: usize = 8 << 20, "an error at the reference";
        /// Bytes of all entities of a document after expansion.
        ENTITIES_BYTES: usize = 32 << 20, "an error at the reference";
        /// Nesting depth of entities.
        ENTITY_DEPTH: u32 = 256, "an error at the reference";
        /// Bytes that references may add before their ratio to the document is checked, as in expat.
        ENTITY_GROWTH: u64 = 8 << 20, "an error at the reference";
        /// Ratio of the bytes that references add to the size of the document, as in expat.
        ENTITY_FACTOR: u64 = 100, "an error at the reference";
        /// Bytes of one value after expansion of its references.
        VALUE_BYTES: usize = 8 << 20, "the value is truncated";
        /// Syntax errors in one child of the root.
        ITEM_ERRORS: usize = 200, "the first ones are shown";
        /// Syntax errors in one document.
        XML_ERRORS: usize = 1_000, "the first ones are shown";
        /// Syntax errors that are sorted before the first ones are selected.
        XML_ERRORS_SEEN: usize = 10_000, "the first ones are shown";
    }
    "Expressions" {
        /// Nesting depth of an expression.
        EXPRESSION_DEPTH: u32 = 240, "an error at the expression";
        /// Nesting depth of brackets, as in CPython.
        BRACKETS: usize = 200, "an error at the bracket";
        /// Syntax errors in one expression.
        EXPRESSION_ERRORS: usize = 20, "the first ones are shown";
        /// Steps of evaluation in one expansion.
        EVAL_STEPS: u64 = 1_000_000, "an error at the expression", "eval-steps";
        /// Nesting depth of nodes and calls in one evaluation.
        EVAL_DEPTH: u32 = 600, "an error at the expression";
        /// Bytes of one value.
        EVAL_VALUE_BYTES: u64 = 64 << 20, "an error at the expression";
        /// Bits of an integer.
        INTEGER_BITS: u64 = 1 << 20, "an error at the expression";
        /// Digits of an integer that is converted from or to text, as in CPython.
        INTEGER_DIGITS: usize = 4_300, "an error at the expression";
        /// Nesting depth of tuples in a key.
        KEY_DEPTH: u32 = 100, "an error at the expression";
        /// Values in a key.
        KEY_PARTS: u32 = 100_000, "an error at the expression";
        /// Nesting depth of containers in a value that is converted to text.
        SHOWN_DEPTH: usize = 150, "an error at the expression";
    }
    "YAML" {
        /// Nesting depth of collections.
        YAML_DEPTH: u32 = 200, "an error at the call that loads the file";
        /// Values in a document; an alias counts each time.
        YAML_NODES: usize = 500_000, "an error at the call that loads the file";
        /// Length of a chain of merge keys.
        YAML_MERGES: u32 = 100, "an error at the call that loads the file";
    }
    "Expansion" {
        /// Nodes of the expanded document.
        EXPAND_NODES: u64 = 500_000, "`infinite-macro-recursion` at the location", "expand-nodes";
        /// Milliseconds for one expansion.
        EXPAND_MS: u64 = 5_000, "`infinite-macro-recursion` at the location", "expand-ms";
        /// Bytes of text in one expansion.
        OUTPUT_BYTES: u64 = 64 << 20, "`infinite-macro-recursion` at the text";
        /// Nesting depth of macro calls.
        MACRO_DEPTH: u32 = 1_000, "an error at the call", "macro-depth";
        /// Nesting depth of includes.
        INCLUDE_DEPTH: u32 = 500, "an error at the include", "include-depth";
        /// Files that one include with wildcards matches.
        GLOB_FILES: usize = 1_000, "an error at the include";
        /// Folder entries that are searched for all includes with wildcards of one robot.
        GLOB_ENTRIES: usize = 200_000, "an error at the include";
        /// Nesting depth of elements.
        ELEMENT_DEPTH: u32 = 5_000, "`infinite-macro-recursion` at the element";
        /// Nesting depth of inserted blocks.
        BLOCK_DEPTH: u32 = 500, "`infinite-macro-recursion` at the insertion";
        /// Length of a chain of properties that use each other.
        LAZY_DEPTH: usize = 500, "an error at the property";
        /// Values of expressions for hover and inlay hints.
        EVALUATIONS: usize = 500_000, "later ones are not shown";
        /// Comparisons of undefined names with defined ones.
        COMPARED_NAMES: usize = 10_000_000, "no similar name is suggested";
    }
    "Workspace and configuration" {
        /// Length of a chain of `extend`.
        CONFIG_CHAIN: usize = 16, "a warning at `extend`";
        /// Combinations of arguments in one entry of `roots`.
        MATRIX_RUNS: usize = 1_000, "a warning in the configuration; `test` exits with an error";
        /// Alternatives in one pattern with braces.
        GLOB_ALTERNATIVES: usize = 64, "the others match nothing";
        /// Folders that are searched for files that match a pattern.
        GLOB_FOLDERS: usize = 100_000, "files in other folders are not found";
        /// Folders that are searched for packages.
        SCAN_FOLDERS: usize = 100_000, "packages in other folders are not found";
        /// Depth of folders that are searched for packages.
        SCAN_DEPTH: usize = 64, "deeper packages are not found";
        /// Descriptions in a workspace that the server reads to find robots.
        SCAN_FILES: usize = 20_000, "the others are read when you open them";
        /// Combinations of arguments from launch files with which one robot is checked.
        CALL_RUNS: usize = 20, "the robot is not checked with the others";
        /// SRDF and YAML files beside one robot that are compared with it and with each other.
        FILES_BESIDE: usize = 100, "none of them is compared with the robot";
        /// Launch files, scripts and pages in a workspace that are searched for calls of xacro.
        CALLER_FILES: usize = 5_000, "arguments in the others are unknown";
        /// Bytes of each of them.
        CALLER_BYTES: u64 = 300_000, "arguments in a larger file are unknown";
        /// Folders that are searched for them.
        CALLER_FOLDERS: usize = 5_000, "the others are not searched";
        /// Depth of folders that are searched for them.
        CALLER_DEPTH: usize = 24, "deeper folders are not searched";
        /// Calls of xacro in one launch file.
        LAUNCH_CALLS: usize = 500, "the others are unknown";
        /// Calls of xacro in one folder and its subfolders.
        CALLER_CALLS: usize = 2_000, "the others are unknown";
        /// Nesting depth of included launch files.
        LAUNCH_INCLUDES: usize = 4, "arguments in deeper files are unknown";
        /// Steps to evaluate one launch file.
        LAUNCH_STEPS: usize = 300_000, "arguments in the rest are unknown";
        /// Nesting depth of blocks or elements in a launch file.
        LAUNCH_DEPTH: usize = 50, "arguments in deeper blocks are unknown";
        /// Nesting depth of function calls in a launch file.
        LAUNCH_CALL_DEPTH: usize = 8, "arguments in deeper calls are unknown";
        /// Parts of a concatenated text in a launch file.
        LAUNCH_PIECES: usize = 1_000, "its value is unknown";
        /// Bytes of a concatenated text in a launch file.
        LAUNCH_TEXT: usize = 20_000, "its value is unknown";
        /// Files that are searched for the name of a missing file.
        NAMESAKE_FILES: usize = 100_000, "no file is suggested";
        /// Depth of folders that are searched for the name of a missing file.
        NAMESAKE_DEPTH: usize = 24, "no file is suggested";
        /// Source files with the name in the banner of a generated file.
        DRIFT_SOURCES: usize = 4, "the generated file is not compared with the others";
        /// Combinations of arguments with which a source is expanded to compare a generated file.
        DRIFT_RUNS: usize = 50, "the generated file is not compared with the others";
        /// Nodes in a `package.xml`.
        MANIFEST_NODES: u32 = 100_000, "its dependencies are unknown";
        /// Bytes of arguments in the build files of a package, counted in each iteration of a loop.
        BUILD_BYTES: u32 = 200_000, "files that the rest installs are unknown";
        /// Nesting depth of folders and loops in the build files of a package.
        BUILD_DEPTH: u32 = 16, "files that deeper folders install are unknown";
    }
    "Meshes" {
        /// Triangles of a mesh, including instances.
        MESH_TRIANGLES: usize = 2_500_000, "`corrupt-mesh` at the mesh";
        /// Nodes of a Collada file.
        MESH_NODES: u32 = 4_000_000, "`corrupt-mesh` at the mesh";
        /// Nodes of a scene, including instances.
        MESH_VISITS: usize = 1_000_000, "`corrupt-mesh` at the mesh";
        /// Elements in glTF accessors.
        MESH_ELEMENTS: usize = 50_000_000, "`corrupt-mesh` at the mesh";
        /// Files that a mesh refers to.
        MESH_FILES: usize = 1_000, "the others are not searched";
    }
    "Findings and fixes" {
        /// Rounds of fixing and checking again.
        FIX_ROUNDS: usize = 50, "the rest is reported as usual";
        /// Expansions to prove one group of fixes.
        PROOF_EXPANSIONS: usize = 2_000, "the fixes count as unsafe";
        /// The same for one action of an editor.
        QUICK_PROOF_EXPANSIONS: usize = 16, "the action is offered as an unsafe one";
        /// Findings of one rule in one robot.
        FINDINGS_OF_A_RULE: usize = 50_000, "the others are omitted";
        /// Bytes of one message, which can contain long names.
        MESSAGE_LETTERS: usize = 1_000, "the message is truncated";
        /// Bytes of a source line that is printed.
        DRAWN_LINE: usize = 20_000, "the location is printed without the line";
        /// Findings of one rule and severity in one file that the text formats print, without `--show all`.
        DRAWN_OF_A_RULE: usize = 5, "the others are counted";
        /// The same in all files.
        DRAWN_IN_ALL: usize = 10, "the others are counted";
        /// Problems of one expansion that `expand` prints.
        DRAWN_PROBLEMS: usize = 100, "the others are counted";
    }
    "Language server" {
        /// Bytes of one protocol message.
        MESSAGE_BYTES: u64 = 256 << 20, "the message is ignored";
        /// Bytes of a protocol header line.
        HEADER_BYTES: u64 = 8 << 10, "the line is ignored";
        /// Diagnostics in one file.
        DIAGNOSTICS: usize = 1_000, "the last one contains the number of the others";
        /// Lines of the log that are kept for a report of a defect.
        LOG_LINES: usize = 50, "the oldest are removed";
        /// Related locations of one diagnostic.
        RELATED: usize = 100, "the others are omitted";
        /// Top-level symbols, and folding ranges, of a file.
        SYMBOLS: usize = 20_000, "the others are omitted";
        /// Nesting depth of symbols; some clients cannot parse deeper responses.
        SYMBOL_DEPTH: usize = 50, "deeper levels are flattened";
        /// Ranges of an expanding selection.
        SELECTIONS: usize = 100, "the next range is the whole file";
        /// Symbols in a workspace symbol response.
        WORKSPACE_SYMBOLS: usize = 1_000, "the others are omitted";
        /// Items in one completion list.
        COMPLETIONS: usize = 200, "the list is marked as incomplete";
        /// Robots that are searched for uses of a name.
        RENAME_ROBOTS: usize = 50, "uses in other robots keep the old name";
        /// Bytes of a new name.
        NAME_LETTERS: usize = 200, "the rename is rejected, with the reason";
        /// Open previews.
        VIEWS: usize = 32, "another one is rejected, with the reason";
    }
    "Preview in a browser" {
        /// Bytes of a mesh or texture.
        SENT_BYTES: u64 = 256_000_000, "the viewer shows an error";
        /// Errors of a robot.
        SENT_ERRORS: usize = 100, "the others are omitted";
        /// Connections with an incomplete request.
        CONNECTIONS: usize = 128, "the oldest connection is closed";
        /// WebSockets that have not sent the token.
        UNAUTHENTICATED: usize = 32, "the oldest connection is closed";
        /// Open pages.
        PAGES: usize = 32, "the oldest connection is closed";
        /// Bytes of the headers of a request.
        REQUEST_HEAD: usize = 16 << 10, "the connection is closed";
        /// Bytes of a message from the viewer.
        SOCKET_MESSAGE: usize = 64 << 10, "the socket is closed";
    }
}
