//! The messages, in the form of `docs/preview.md`.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::locations::Location;
use super::model::Model;
use super::programs::Programs;
use analysis::{RootAnalysis, RootConfig};

/// A root as messages name it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RootName {
    /// The file.
    pub uri: String,
    /// Arguments over its defaults.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, String>,
    /// The preset they come from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
}

impl RootName {
    pub(super) fn of(root: &RootConfig, uri: String) -> Self {
        Self {
            uri,
            args: root.args.iter().cloned().collect(),
            preset: root.preset.clone(),
        }
    }
}

/// Which of two robots side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The one that is always there.
    Main,
    /// The one it is compared with.
    Compare,
}

/// The state of a robot.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename = "model", rename_all = "camelCase")]
pub struct ModelMessage {
    /// The view.
    pub id: u32,
    /// Which robot of it.
    pub side: Side,
    /// Grows from message to message.
    pub revision: u64,
    /// Whether the text is without errors.
    pub ok: bool,
    /// The robot; absent when it is broken and there is a good one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<Arc<Model>>,
    /// What is wrong.
    pub errors: Vec<ModelError>,
    /// The last robot without errors, when there are errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last_good: Option<Arc<Model>>,
    /// The revision that `last_good` was sent with.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub good_revision: Option<u64>,
    /// What is shown.
    pub root: RootName,
    /// The arguments it has.
    pub args: Vec<Argument>,
    /// What else could be shown.
    pub choices: Vec<RootName>,
    /// What the programs that read URDF make of it; absent when it has errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub programs: Option<Programs>,
    /// What it was made of; stays in this process.
    #[serde(skip)]
    pub source: ModelSource,
}

/// The expansion that a model was made of.
#[derive(Clone)]
pub struct ModelSource(pub(super) Arc<RootAnalysis>);

impl ModelSource {
    /// The robot as URDF.
    ///
    /// # Errors
    /// When it has errors: what is shown then is an earlier one.
    pub fn urdf(&self) -> Result<String, String> {
        let expansion = &self.0.expansion;
        if expansion.has_errors() || expansion.root_error.is_some() {
            return Err("the robot has errors: fix them to save its URDF".to_owned());
        }
        Ok(self.0.written().text.clone())
    }
}

impl fmt::Debug for ModelSource {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Source")
    }
}

/// An argument of a root.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Argument {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: String,
}

/// An error of the text.
#[derive(Clone, Debug, Serialize)]
pub struct ModelError {
    /// One line.
    pub message: String,
    /// Name of the rule.
    pub code: String,
    /// Where.
    pub location: Location,
}

/// Links and joints that belong together with a place of the text.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(tag = "type", rename = "select")]
pub struct Selection {
    /// The view.
    pub id: u32,
    /// The link that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// The joint that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<String>,
    /// All links.
    pub links: Vec<String>,
    /// All joints.
    pub joints: Vec<String>,
    /// Where the one that was asked for stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub location: Option<Location>,
}

/// What a viewer says.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
pub enum FromViewer {
    /// It listens.
    Ready,
    /// Something was clicked, or the cursor moved.
    Select {
        /// A link.
        #[serde(default)]
        link: Option<String>,
        /// A joint.
        #[serde(default)]
        joint: Option<String>,
        /// A place.
        #[serde(default)]
        location: Option<Location>,
    },
    /// An error was clicked.
    Open {
        /// Where it is.
        location: Location,
    },
    /// Something else is to be shown.
    Root {
        /// The robot.
        root: RootName,
        /// The one beside it.
        #[serde(default)]
        compare: Option<RootName>,
    },
    /// The bytes of a file are wanted; browsers ask for them in another way.
    Mesh {
        /// Its id.
        mesh: String,
    },
}
