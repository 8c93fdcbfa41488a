//! F4: what is shown under the pointer.

use lsp_types::{HoverContents, HoverParams, MarkupContent, MarkupKind};

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use super::navigation::Asked;
use crate::base::CancelFlag;
use crate::ide::{self, Hover};

impl Engine {
    pub fn hover(
        &mut self,
        params: HoverParams,
        cancel: &CancelFlag,
    ) -> Result<Option<lsp_types::Hover>, Failure> {
        let asked = self.asked(&params.text_document_position_params, cancel)?;
        Ok(self.hover_at(&asked, asked.offset).map(|hover| lsp_types::Hover {
            range: Some(convert::range(&asked.source.document, hover.range, self.encoding)),
            contents: HoverContents::Markup(self.markup(hover.markdown)),
        }))
    }

    /// What there is to say about an offset of a file.
    pub fn hover_at(&self, asked: &Asked, offset: u32) -> Option<Hover> {
        let session = self.world.session();
        let settings = session.settings(&asked.source.path);
        ide::hover(&asked.cx(), session.surroundings(&settings.config), offset)
    }

    pub fn markup(&self, markdown: String) -> MarkupContent {
        MarkupContent { kind: MarkupKind::Markdown, value: markdown }
    }
}
