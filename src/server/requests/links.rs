//! Names of files as links.
use lsp_types::{DocumentLink, DocumentLinkParams};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::navigation::asked;
use crate::requests::tokens::start_of;
use crate::state::ServerState;
use base::CancelFlag;
use ide::{self, FileName, FileTarget};

pub fn links(
    state: &mut ServerState,
    params: DocumentLinkParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<DocumentLink>>, RequestFailure> {
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let session = state.host.session();
    let settings = session.settings(&asked.source.path);
    let names = ide::file_names(&asked.cx(), session.rule_env(&settings.config));
    let link = |FileName { range, target, .. }: FileName| {
        let FileTarget::Found(path) = target else {
            return None;
        };
        Some(DocumentLink {
            range: convert::range(&asked.source.document, range, state.encoding),
            target: Some(state.uri(&path)?),
            tooltip: Some(vfs::slashed(&path)),
            data: None,
        })
    };
    Ok(Some(names.into_iter().filter_map(link).collect()))
}
