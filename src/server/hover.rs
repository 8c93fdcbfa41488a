//! F4: what is shown under the pointer.

use lsp_types::{HoverContents, HoverParams, TextDocumentPositionParams};

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use super::navigation::Asked;
use base::CancelFlag;
use ide::{self, Cx, Hover};
use vfs::SourceFile;

impl Engine {
    pub fn hover(
        &mut self,
        params: HoverParams,
        cancel: &CancelFlag,
    ) -> Result<Option<lsp_types::Hover>, Failure> {
        if let Some(found) = self.hover_while_typing(&params.text_document_position_params)? {
            return Ok(Some(found));
        }
        let asked = self.asked(&params.text_document_position_params, cancel)?;
        Ok(self.hover_at(&asked, asked.offset).map(|hover| self.hover_answer(&asked.source, hover)))
    }

    /// What can be said of a name in a large robot that was edited, without expanding it anew.
    fn hover_while_typing(
        &mut self,
        at: &TextDocumentPositionParams,
    ) -> Result<Option<lsp_types::Hover>, Failure> {
        let (path, source) = self.source(&at.text_document.uri)?;
        let Some(before) = self.world.before_typing(&path) else { return Ok(None) };
        let cx = Cx {
            source: &source,
            expansion: &before.expansion,
            robot: before.robot.as_ref(),
            kinematics: before.kinematics.as_ref(),
            pinned: None,
        };
        let offset = convert::offset(&source.document, at.position, self.encoding);
        let found = ide::hover_while_typing(&cx, offset, |path| self.world.document(path));
        Ok(found.map(|hover| self.hover_answer(&source, hover)))
    }

    fn hover_answer(&self, source: &SourceFile, hover: Hover) -> lsp_types::Hover {
        lsp_types::Hover {
            range: Some(convert::range(&source.document, hover.range, self.encoding)),
            contents: HoverContents::Markup(self.client.hover.contents(hover.markdown)),
        }
    }

    /// What there is to say about an offset of a file.
    pub fn hover_at(&self, asked: &Asked, offset: u32) -> Option<Hover> {
        let session = self.world.session();
        let settings = session.settings(&asked.source.path);
        ide::hover(&asked.cx(), session.surroundings(&settings.config), offset)
    }
}
