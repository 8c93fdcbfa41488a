//! The preview: the robot of a root as a model to draw, kept up to date while its text is edited.
//!
//! What is here does not know who draws it. [`Views`] makes the messages, for editors and browsers alike; with the
//! feature `preview`, [`Hub`] hands them to browsers on this machine.

#[cfg(feature = "browser")]
mod browser;
mod choices;
mod files;
mod locations;
mod messages;
mod model;
mod programs;
mod select;
mod shapes;
#[cfg(test)]
mod tests;
mod views;

#[cfg(feature = "browser")]
pub use browser::{Hub, Received};
pub use files::ModelFiles;
pub use locations::{LinePosition, LineRange, Location, LocationFormat, file_uri};
pub use messages::{FromViewer, ModelError, ModelMessage, ModelSource, RootName, Selection, Side};
pub use model::{BodyModel, JointModel, LinkModel, Model, PoseModel};
pub use programs::Programs;
pub use shapes::ShapeModel;
pub use views::{MeshBytes, Views, still};

/// Whether browsers can be shown anything: a build from source holds the viewer only when it was built before.
#[cfg(feature = "browser")]
pub const HAS_VIEWER: bool = viewer::SCRIPT.is_some();
