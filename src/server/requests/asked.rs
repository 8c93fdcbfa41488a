//! A position that the client asks about.
use std::sync::Arc;

use crate::state::ServerState;
use analysis::RootAnalysis;
use expand::FrameId;
use ide::{BesideName, Cx, TextNames};
use vfs::SourceFile;

/// A place in a file under its active root.
pub(crate) struct Asked {
    pub source: Arc<SourceFile>,
    pub analyzed: Arc<RootAnalysis>,
    /// Bytes from the start of the file.
    pub offset: u32,
    /// The active root of the file, whether its expansion came by the file or not.
    pub around: Arc<RootAnalysis>,
    /// The names in files beside the robot.
    pub beside: Vec<BesideName>,
    /// The call that the user selected under this root.
    pub selected_frame: Option<FrameId>,
}

impl Asked {
    /// What is asked about at the `<` or the prefix of a tag is its name.
    #[must_use]
    pub fn on_name(mut self) -> Self {
        self.offset = ide::on_name_of_tag(&self.source.document, self.offset);
        self
    }

    /// The file in the expansion of its root.
    pub fn cx(&self) -> Cx<'_> {
        Cx {
            source: &self.source,
            expansion: &self.analyzed.expansion,
            robot: self.analyzed.robot.as_ref(),
            kinematics: self.analyzed.kinematics(),
            beside: &self.beside,
            selected_frame: self.selected_frame,
        }
    }

    /// What names mean by the texts of the robot.
    pub fn names(&self, state: &ServerState) -> TextNames {
        let session = state.host.session();
        let settings = session.settings(&self.source.path);
        let rule_env = session.rule_env(&settings.config);
        let around = TextNames::of(&self.around.expansion, rule_env);
        if around.knows(self.source.id) {
            around
        } else {
            TextNames::of(&self.analyzed.expansion, rule_env)
        }
    }
}
