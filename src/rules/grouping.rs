//! Which findings of a rule are one defect.
use ecow::EcoString;

/// What several findings of one rule and severity share when they are one defect.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// Nothing: each place needs a repair of its own.
    Place,
    /// The text that is reported, in one file: a misspelled name that is used again and again.
    Text,
    /// The file: a habit of its author, or of the program that wrote it.
    File,
    /// The file, where many names in it resemble none of the robot: it is for another one.
    OtherRobot,
    /// A name, in one file.
    Name(EcoString),
    /// A value, in any file: a tensor that was copied, a package that is not declared.
    Value(EcoString),
    /// Something outside of the descriptions that has the defect itself, such as a mesh.
    Thing(EcoString),
}

impl Group {
    /// How many places make a group. Of two, both are shown, unless what is wrong is neither of them.
    pub fn least(&self) -> usize {
        match self {
            Group::Thing(_) => 2,
            // a few names may each be wrong for a reason of its own
            Group::OtherRobot => 5,
            _ => 3,
        }
    }
}
