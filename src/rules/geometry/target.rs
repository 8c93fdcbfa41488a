//! Where the names of files lead, and the meshes that were read.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use base::FastMap;
use expand::XId;
use model::Mesh;

/// Where the text of a file name leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileLookup {
    /// Nothing can be said: the text is not known, or speaks of a package or machine that is not at hand.
    Unknown,
    /// To no place at all.
    Malformed,
    /// To a file.
    File(PathBuf),
    /// To a folder, or something else that is no file.
    NoFile(PathBuf),
    /// To a file whose name has other letter cases.
    OtherCase(PathBuf),
    /// To nothing: the place, and the folder of the package it names.
    Missing(PathBuf, Option<PathBuf>),
}

/// The meshes of a robot by the element that names them.
#[derive(Debug, Default)]
pub struct Resources {
    pub(super) meshes: FastMap<XId, (FileLookup, Option<Arc<Mesh>>)>,
}

impl FileLookup {
    /// The path it leads to, whatever is there.
    pub(super) fn place(&self) -> Option<&Path> {
        match self {
            FileLookup::File(path)
            | FileLookup::NoFile(path)
            | FileLookup::OtherCase(path)
            | FileLookup::Missing(path, _) => Some(path),
            FileLookup::Unknown | FileLookup::Malformed => None,
        }
    }

    /// The file it leads to.
    pub fn file(&self) -> Option<&Path> {
        match self {
            FileLookup::File(path) => Some(path),
            _ => None,
        }
    }
}
