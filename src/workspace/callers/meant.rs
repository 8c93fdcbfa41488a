//! Which texts may mean a description.

use std::path::Path;

use super::read;
use packages::Packages;

/// Whether a text that names a description by its file name may mean `file`, not one of the same name elsewhere: it
/// is in the same package or names it; without a package, it is in the folder above or below that.
pub(super) fn may_mean(caller: &Path, file: &Path, packages: &Packages) -> bool {
    let Some(package) = packages.containing(file) else {
        let near = file
            .parent()
            .map(|folder| folder.parent().unwrap_or(folder));
        return near.is_some_and(|near| caller.starts_with(near));
    };
    caller.starts_with(&package.folder)
        || packages.is_text(caller, |text| read::has_name(text, &package.name))
}
