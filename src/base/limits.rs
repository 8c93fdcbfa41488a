//! Every limit that keeps hostile input from taking time, memory or the screen without end, in one place.
//!
//! `docs/limits.md` is made from this table by `UPDATE=1 cargo test --test limits`; a test holds that each limit names
//! a test that reaches it. Lengths of what is shown in one hover, hint or title are no limits and stand where they
//! are used.

/// A limit as the documentation lists it.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
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
        pub const ALL: &[Limit] = &[$($(Limit {
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
        FILE_MB: u64 = 20, "an error at what names the file, or at the command line", "file-mb";
        /// Megabytes that `file-mb` may be set to.
        FILE_MB_MOST: u64 = 1_000, "a warning in the configuration";
        /// Bytes of standard input.
        STDIN_BYTES: u64 = 20_000_000, "the command ends with an error";
        /// Bytes of a mesh.
        MESH_BYTES: u64 = 100_000_000, "`mesh-too-large` or a note at the mesh";
        /// Bytes of a material library of a mesh.
        MATERIAL_BYTES: u64 = 10_000_000, "its textures are not checked";
        /// Bytes of a mesh that the server rewrites.
        REWRITTEN_MESH_BYTES: u64 = 100 << 20, "the action is disabled, with the reason";
    }
    "XML" {
        /// Bytes of a document; edits that would make it longer do nothing.
        XML_BYTES: usize = 1 << 30, "no file and no message can be as long";
        /// Bytes that one entity may grow to.
        ENTITY_BYTES: usize = 8 << 20, "an error at the reference";
        /// Bytes that all entities of a document may grow to.
        ENTITIES_BYTES: usize = 32 << 20, "an error at the reference";
        /// Entities inside entities.
        ENTITY_DEPTH: u32 = 256, "an error at the reference";
        /// Bytes that references may add before their share is looked at, as in expat.
        ENTITY_GROWTH: u64 = 8 << 20, "an error at the reference";
        /// How many times the size of the document references may add after that, as in expat.
        ENTITY_FACTOR: u64 = 100, "an error at the reference";
        /// Bytes that one value may grow to through its references.
        VALUE_BYTES: usize = 8 << 20, "the value is cut";
        /// Syntax errors kept of one child of the root.
        ITEM_ERRORS: usize = 200, "the first ones are shown";
        /// Syntax errors of one document.
        XML_ERRORS: usize = 1_000, "the first ones are shown";
        /// Syntax errors that the first ones are chosen from.
        XML_ERRORS_SEEN: usize = 10_000, "the first ones are shown";
    }
    "Expressions" {
        /// Levels of the tree of an expression.
        EXPRESSION_DEPTH: u32 = 240, "an error at the expression";
        /// Brackets inside brackets, as in CPython.
        BRACKETS: usize = 200, "an error at the bracket";
        /// Syntax errors of one expression.
        EXPRESSION_ERRORS: usize = 20, "the first ones are shown";
        /// Steps of evaluation in one expansion.
        EVAL_STEPS: u64 = 1_000_000, "an error at the expression", "eval-steps";
        /// Nodes and calls inside each other in one evaluation.
        EVAL_DEPTH: u32 = 600, "an error at the expression";
        /// Bytes of one value.
        EVAL_VALUE_BYTES: u64 = 64 << 20, "an error at the expression";
        /// Bits of an integer.
        INTEGER_BITS: u64 = 1 << 20, "an error at the expression";
        /// Digits of an integer that is read from or written as text, as in CPython.
        INTEGER_DIGITS: usize = 4_300, "an error at the expression";
        /// Tuples inside tuples in a key.
        KEY_DEPTH: u32 = 100, "an error at the expression";
        /// Values that a key consists of.
        KEY_PARTS: u32 = 100_000, "an error at the expression";
        /// Containers inside containers in a value that is written as text.
        SHOWN_DEPTH: usize = 150, "an error at the expression";
    }
    "YAML" {
        /// Collections inside collections.
        YAML_DEPTH: u32 = 200, "an error at the call that loads the file";
        /// Values of a document, those of aliases counted each time.
        YAML_NODES: usize = 500_000, "an error at the call that loads the file";
        /// Merge keys followed from one mapping to the next.
        YAML_MERGES: u32 = 100, "an error at the call that loads the file";
    }
    "Expansion" {
        /// Nodes of the expanded document.
        EXPAND_NODES: u64 = 500_000, "`limit-reached` at the location", "expand-nodes";
        /// Milliseconds for one expansion.
        EXPAND_MS: u64 = 5_000, "`limit-reached` at the location", "expand-ms";
        /// Bytes of text that one expansion makes.
        OUTPUT_BYTES: u64 = 64 << 20, "`limit-reached` at the text";
        /// Macro calls inside macro calls.
        MACRO_DEPTH: u32 = 1_000, "an error at the call", "macro-depth";
        /// Files included from each other.
        INCLUDE_DEPTH: u32 = 500, "an error at the include", "include-depth";
        /// Files that one include with stars may name.
        GLOB_FILES: usize = 1_000, "an error at the include";
        /// Entries of folders that are looked at for all includes with stars of one robot.
        GLOB_ENTRIES: usize = 200_000, "an error at the include";
        /// Elements inside elements.
        ELEMENT_DEPTH: u32 = 5_000, "`limit-reached` at the element";
        /// Blocks inserted inside blocks.
        BLOCK_DEPTH: u32 = 500, "`limit-reached` at the insertion";
        /// Properties whose values need each other.
        LAZY_DEPTH: usize = 500, "an error at the property";
        /// Values of expressions that are kept for hovers and hints.
        EVALUATIONS: usize = 500_000, "later ones are not shown";
        /// Names that were compared with names that are not defined.
        COMPARED_NAMES: usize = 10_000_000, "no similar name is suggested";
    }
    "Workspace and configuration" {
        /// Configuration files that extend each other.
        CONFIG_CHAIN: usize = 16, "a warning at `extend`";
        /// Alternatives of one pattern with braces.
        GLOB_ALTERNATIVES: usize = 64, "further ones match nothing";
        /// Folders that are searched for the files of a pattern.
        GLOB_FOLDERS: usize = 100_000, "files in further folders are not found";
        /// Folders that are searched for packages.
        SCAN_FOLDERS: usize = 100_000, "packages in further folders are not found";
        /// Levels of folders that are searched for packages.
        SCAN_DEPTH: usize = 64, "packages further down are not found";
        /// Descriptions of a workspace that the server looks at for robots.
        SCAN_FILES: usize = 20_000, "further ones are read when they are opened";
        /// Launch files, scripts and pages of a workspace that are searched for calls of a robot.
        CALLER_FILES: usize = 5_000, "arguments that further ones give are not known";
        /// Bytes of each of them.
        CALLER_BYTES: u64 = 300_000, "what it gives is not known";
        /// Folders that are searched for them.
        CALLER_FOLDERS: usize = 5_000, "further ones are not searched";
        /// Levels of folders that are searched for them.
        CALLER_DEPTH: usize = 24, "deeper ones are not searched";
        /// Calls of xacro that are read in one launch file.
        LAUNCH_CALLS: usize = 500, "further ones are not known";
        /// Calls of xacro below one folder.
        CALLER_CALLS: usize = 2_000, "further ones are not known";
        /// Launch files that include each other.
        LAUNCH_INCLUDES: usize = 4, "what deeper ones pass on is not known";
        /// Steps that are taken to read one launch file.
        LAUNCH_STEPS: usize = 300_000, "what the rest gives is not known";
        /// Blocks inside blocks, or elements inside elements, of a launch file.
        LAUNCH_DEPTH: usize = 50, "what deeper ones give is not known";
        /// Functions of a launch file that call each other.
        LAUNCH_CALL_DEPTH: usize = 8, "what deeper ones give is not known";
        /// Pieces that a text of a launch file is put together from.
        LAUNCH_PIECES: usize = 1_000, "its value is not known";
        /// Bytes of a text that a launch file puts together.
        LAUNCH_TEXT: usize = 20_000, "its value is not known";
        /// Files that are looked at for the name of a missing one.
        NAMESAKE_FILES: usize = 100_000, "no file is suggested";
        /// Levels of folders that are looked at for the name of a missing file.
        NAMESAKE_DEPTH: usize = 24, "no file is suggested";
        /// Nodes of a `package.xml`.
        MANIFEST_NODES: u32 = 100_000, "its name is searched as plain text, its dependencies are unknown";
        /// Bytes of arguments that are read of the build files of a package, each time a loop runs.
        BUILD_BYTES: u32 = 200_000, "what the rest installs is not known";
        /// Levels of folders and loops in the build files of a package.
        BUILD_DEPTH: u32 = 16, "what deeper ones install is not known";
    }
    "Meshes" {
        /// Triangles of a mesh, instances counted.
        MESH_TRIANGLES: usize = 2_500_000, "a note at the mesh";
        /// Nodes of a Collada file.
        MESH_NODES: u32 = 4_000_000, "a note at the mesh";
        /// Nodes of a scene that are visited, instances counted.
        MESH_VISITS: usize = 1_000_000, "a note at the mesh";
        /// Elements of glTF accessors that are read.
        MESH_ELEMENTS: usize = 50_000_000, "a note at the mesh";
        /// Further files that a mesh names.
        MESH_FILES: usize = 1_000, "further ones are not searched";
    }
    "Findings and fixes" {
        /// How often findings are fixed and checked again.
        FIX_ROUNDS: usize = 50, "the rest is reported as usual";
        /// Expansions that are made to prove one group of fixes.
        PROOF_EXPANSIONS: usize = 2_000, "the fixes count as unsafe";
        /// The same for one action of an editor.
        QUICK_PROOF_EXPANSIONS: usize = 16, "the action is offered as one that may change the robot";
        /// Findings of one rule in one robot.
        FINDINGS_OF_A_RULE: usize = 50_000, "further ones are omitted";
        /// Bytes of one message; names can be as long as files.
        MESSAGE_LETTERS: usize = 1_000, "the message is cut";
        /// Bytes of a source line that is drawn on the terminal.
        DRAWN_LINE: usize = 20_000, "the location is printed without the line";
        /// Findings of one rule and severity in one file that are printed for people, unless all are asked for.
        DRAWN_OF_A_RULE: usize = 5, "the others are counted";
        /// The same in all files.
        DRAWN_IN_ALL: usize = 10, "the others are counted";
        /// Problems of one expansion that `expand` draws.
        DRAWN_PROBLEMS: usize = 100, "the others are counted";
    }
    "Language server" {
        /// Bytes of one message of the protocol.
        MESSAGE_BYTES: u64 = 256 << 20, "the message is ignored";
        /// Bytes of a header line of the protocol.
        HEADER_BYTES: u64 = 8 << 10, "the line is ignored";
        /// Diagnostics of one file.
        DIAGNOSTICS: usize = 1_000, "the last one gives the number of the others";
        /// Related places of one diagnostic.
        RELATED: usize = 100, "further ones are omitted";
        /// Symbols at the top of a file, and folds.
        SYMBOLS: usize = 20_000, "further ones are omitted";
        /// Symbols inside symbols; some clients read no answers that are nested much deeper.
        SYMBOL_DEPTH: usize = 50, "deeper levels are flattened";
        /// Ranges of one growing selection.
        SELECTIONS: usize = 100, "the whole file comes next";
        /// Symbols of an answer about the workspace.
        WORKSPACE_SYMBOLS: usize = 1_000, "further ones are omitted";
        /// Items of one completion.
        COMPLETIONS: usize = 200, "the list is marked as incomplete";
        /// Robots that are looked at for uses of a name.
        RENAME_ROBOTS: usize = 50, "uses in further robots keep the old name";
        /// Bytes of a new name.
        NAME_LETTERS: usize = 200, "the rename is rejected, with the reason";
        /// Previews that are open.
        VIEWS: usize = 32, "a further one is rejected, with the reason";
    }
    "Preview in a browser" {
        /// Bytes of a mesh or texture that is sent.
        SENT_BYTES: u64 = 256_000_000, "the viewer shows that it cannot be read";
        /// Errors that are sent with a robot.
        SENT_ERRORS: usize = 100, "further ones are omitted";
        /// Connections that have not sent a whole request yet.
        CONNECTIONS: usize = 128, "the oldest connection is closed";
        /// Sockets that have not named the token yet.
        STRANGERS: usize = 32, "the oldest connection is closed";
        /// Pages that are open.
        PAGES: usize = 32, "the oldest connection is closed";
        /// Bytes of the head of a request.
        REQUEST_HEAD: usize = 16 << 10, "the connection is closed";
        /// Bytes of a message of the viewer.
        SOCKET_MESSAGE: usize = 64 << 10, "the socket is closed";
    }
}
