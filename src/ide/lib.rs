//! What editors ask: answers in plain terms, byte offsets and spans, without any protocol.
//!
//! Every feature is a file. Those that need only the text of a file take its document; those that need the
//! meaning of names take a [`Cx`]: the file in the expansion of its active root.

mod actions;
mod arguments;
mod beside;
mod calls;
mod colors;
mod completion;
mod context;
mod expand_at;
mod expressions;
mod folding;
mod format;
mod hints;
mod host;
mod hover;
mod instances;
mod locate;
mod moved;
mod names;
mod navigate;
mod new_name;
mod on_type;
mod outline;
mod paths;
mod rename;
mod rename_robot;
mod robot_names;
mod schema;
mod search;
mod selection;
mod source_map;
mod tags;
mod text_names;
mod tokens;
mod typed;
mod unseen;
mod values;

pub use actions::{
    Action, ActionKind, MacroFile, NewFile, Refused, before_use, ignored_in_config, include_macro,
    inlinable, inline_macro, move_to_file, of_mesh, other_name, quick_fixes, refactorings,
    severity_in_config, suggested,
};
pub use arguments::{arguments_behind, possible_values};
pub use beside::{BesideName, names_in_settings, names_in_srdf};
pub use calls::{
    CallEdge, CallParticipant, caller_target, calls_of, incoming, macro_at, macros_of, outgoing,
};
pub use colors::{Color, color_text, colors};
pub use completion::{
    BesideSources, Completion, CompletionScope, CompletionSources, Completions, ItemKind,
    Signature, Topic, completions, completions_in_settings, documentation, signature_help,
};
pub use context::Cx;
pub use expand_at::{ExpandedAt, expand_at};
pub use folding::{Fold, FoldKind, folds, largest};
pub use format::{Indent, format, format_range, indentation, own_indentation};
pub use hints::{Hint, HintKind, HintSettings, hints};
pub use hover::{Hover, declared_argument, hover, hover_while_typing, value_of};
pub use instances::{SelectedInstance, select_instance, selected_frame};
pub use locate::{LocatedNode, NodePart, locate, on_name_of_tag};
pub use moved::{Move, renamed_files};
pub use names::{NameOccurrence, NavigationTarget, definition_of, definitions};
pub use navigate::{
    FileLocation, declaration, file_definition, implementations, is_text, type_definition,
};
pub use on_type::{Insertion, on_type};
pub use outline::{Outline, OutlineKind, outline};
pub use paths::{FileKind, FileName, FileTarget, file_names};
pub use rename::{definition_at, kind_at, places, rename, renameable};
pub use rename_robot::{rename as rename_part, renameable as renameable_part};
pub use robot_names::{RobotThing, robot_name_at, uses_of};
pub use search::{Hit, fit, search};
pub use selection::selection;
pub use source_map::{SourceMap, TextLines, entry_at, instances, origin_of, source_map, steps};
pub use tags::{matching_tags, same_tag_names};
pub use text_names::{
    Documents, Meaning, NameText, TextDefinition, TextNames, definitions_by_text,
    definitions_elsewhere, further_places, occurrences,
};
pub use tokens::{HighlightToken, KeptTokens, Modifiers, TokenKind, tokens};
pub use unseen::unseen_name;
pub use values::cut;
