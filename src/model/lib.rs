//! The robot of an expanded document: links, joints and what belongs to them, each with the text it came from.

mod attr_value;
mod blocks;
mod canonical;
mod difference;
mod ends;
mod joined_inertia;
mod joint;
mod kept;
mod kinematics;
mod link;
mod mesh;
mod naming;
mod pose;
mod renamed;
mod robot;
mod shared_list;
mod source;
#[cfg(test)]
mod tests;
mod version;

pub use attr_value::{AttrValue, decimal, is_decimal};
pub use blocks::{ControlJoint, Gazebo, Interface, InterfaceParam, Ros2Control, Transmission};
pub use canonical::{same_but_for_mesh_formats, same_robot};
pub use difference::{Comparison, Difference, DifferenceKind, compare};
pub use joined_inertia::joined_inertia;
pub use joint::{Axis, Dynamics, Joint, JointType, Limit, Mimic, SafetyController};
pub use kinematics::Kinematics;
pub use link::{Body, Geometry, Inertial, Link, Material, Shape, ShapeKind};
pub use mesh::{
    Bounds, Defect, DefectKind, Dependency, Edges, Mesh, MeshFormat, Meshes, MissingDependency,
    Surface, Triangles, UpAxis, plain_stl,
};
pub use naming::{NameMarks, Naming};
pub use pose::{Pose, transform};
pub use renamed::other_difference;
pub use robot::{Robot, SharedNames};
pub use shared_list::{SharedIter, SharedList};
pub use source::{attr_range, element_range, source_has_elements, source_mentions, tag_start};
pub use version::Version;
