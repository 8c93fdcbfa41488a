//! F22: names of files as links.

use lsp_types::{DocumentLink, DocumentLinkParams};

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use super::tokens::start_of;
use base::CancelFlag;
use ide::{self, FileName, FileTarget};

impl Engine {
    pub fn links(
        &mut self,
        params: DocumentLinkParams,
        cancel: &CancelFlag,
    ) -> Result<Option<Vec<DocumentLink>>, Failure> {
        let asked = self.asked(&start_of(params.text_document), cancel)?;
        let session = self.world.session();
        let settings = session.settings(&asked.source.path);
        let names = ide::file_names(&asked.cx(), session.surroundings(&settings.config));
        let link = |FileName { range, target, .. }: FileName| {
            let FileTarget::Found(path) = target else { return None };
            Some(DocumentLink {
                range: convert::range(&asked.source.document, range, self.encoding),
                target: Some(self.uri(&path)?),
                tooltip: Some(path.to_string_lossy().into_owned()),
                data: None,
            })
        };
        Ok(Some(names.into_iter().filter_map(link).collect()))
    }
}
