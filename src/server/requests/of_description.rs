//! Requests about descriptions. In YAML, launch and configuration files, which other servers know better, names of the robot
//! are answered for and nothing else.
use std::path::Path;

use lsp_types::*;

use crate::failure::RequestFailure;
use crate::state::ServerState;
use analysis::{is_config, is_launch, is_settings};
use base::CancelFlag;

/// Parameters of a request about a document.
pub trait OfDocument {
    /// The document.
    fn uri(&self) -> &Url;
}

macro_rules! of_document {
    ($($params:ty: $($field:ident).+;)+) => {
        $(impl OfDocument for $params {
            fn uri(&self) -> &Url {
                &self.$($field).+
            }
        })+
    };
}

of_document! {
    SignatureHelpParams: text_document_position_params.text_document.uri;
    GotoDefinitionParams: text_document_position_params.text_document.uri;
    CallHierarchyPrepareParams: text_document_position_params.text_document.uri;
    CodeActionParams: text_document.uri;
    DocumentFormattingParams: text_document.uri;
    DocumentRangeFormattingParams: text_document.uri;
    DocumentOnTypeFormattingParams: text_document_position.text_document.uri;
    DocumentSymbolParams: text_document.uri;
    FoldingRangeParams: text_document.uri;
    SelectionRangeParams: text_document.uri;
    LinkedEditingRangeParams: text_document_position_params.text_document.uri;
    SemanticTokensParams: text_document.uri;
    SemanticTokensDeltaParams: text_document.uri;
    SemanticTokensRangeParams: text_document.uri;
    DocumentLinkParams: text_document.uri;
    InlayHintParams: text_document.uri;
    DocumentColorParams: text_document.uri;
    CodeLensParams: text_document.uri;
}

/// Whether a file is none whose text describes a robot.
pub fn is_not_described(path: &Path) -> bool {
    is_settings(path) || is_launch(path) || is_config(path)
}

/// What answers a request by `work`, unless it is about YAML, a launch file or a configuration.
pub fn of_description<P: OfDocument, R: Default>(
    work: fn(&mut ServerState, P, &CancelFlag) -> Result<R, RequestFailure>,
) -> impl FnOnce(&mut ServerState, P, &CancelFlag) -> Result<R, RequestFailure> {
    move |state, params, cancel| {
        if is_not_described(&state.path(params.uri())) {
            Ok(R::default())
        } else {
            work(state, params, cancel)
        }
    }
}
