//! Geometry, meshes and materials.

pub(super) mod absolute_mesh_path;
pub(super) mod ascii_stl;
pub(super) mod binary_stl_solid_header;
mod bodies;
mod collision_left_out;
pub(super) mod collision_mesh_too_detailed;
pub(super) mod collision_origin_mismatch;
mod collision_same_as_visual;
mod collision_smaller_than_visual;
mod color_out_of_range;
mod corrupt_mesh;
mod dae_unit;
mod dae_up_axis;
pub(super) mod duplicate_material;
mod empty_geometry;
mod invisible_material;
mod malformed_resource_uri;
mod material_redefinition;
mod material_without_color;
mod mesh_case_mismatch;
mod mesh_far_from_link;
pub(super) mod mesh_inconsistent_normals;
mod mesh_inverted_normals;
mod mesh_missing_dependency;
pub(super) mod mesh_not_found;
mod mesh_not_watertight;
pub(super) mod mesh_path_without_scheme;
mod mesh_scale_suspicious;
mod missing;
mod missing_collision;
mod multiple_geometries;
mod negative_mesh_scale;
pub(super) mod non_positive_dimension;
mod once_per_file;
mod relative_mesh_path;
mod resources;
mod shapes;
mod target;
mod texture_not_found;
pub(super) mod undefined_material;
pub(super) mod unknown_geometry_type;
mod unsupported_mesh_format;
pub(super) mod unused_material;
mod uri;
mod visual_collision_apart;
mod zero_mesh_scale;

use super::rule::Rule;

pub use bodies::link_bounds;
pub use resources::{factors, resolve as resolve_file};
pub use target::FileLookup as FileTarget;

pub(super) use bodies::{Extent, extent, extent_of, shapes_of, volume};
pub(super) use mesh_scale_suspicious::is_scaled_wrong;
pub(super) use resources::{MeshReference, MeshUse};
pub(super) use shapes::{
    color, is_defined, is_read_last, is_replaceable, is_taken_out, visual_materials,
};
pub(super) use target::Resources;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &mesh_not_found::RULE,
    &mesh_case_mismatch::RULE,
    &unsupported_mesh_format::RULE,
    &ascii_stl::RULE,
    &binary_stl_solid_header::RULE,
    &corrupt_mesh::RULE,
    &mesh_scale_suspicious::RULE,
    &mesh_inverted_normals::RULE,
    &mesh_inconsistent_normals::RULE,
    &mesh_not_watertight::RULE,
    &collision_mesh_too_detailed::RULE,
    &collision_same_as_visual::RULE,
    &non_positive_dimension::RULE,
    &empty_geometry::RULE,
    &multiple_geometries::RULE,
    &unknown_geometry_type::RULE,
    &negative_mesh_scale::RULE,
    &zero_mesh_scale::RULE,
    &absolute_mesh_path::RULE,
    &relative_mesh_path::RULE,
    &malformed_resource_uri::RULE,
    &mesh_missing_dependency::RULE,
    &dae_up_axis::RULE,
    &dae_unit::RULE,
    &color_out_of_range::RULE,
    &undefined_material::RULE,
    &duplicate_material::RULE,
    &material_redefinition::RULE,
    &unused_material::RULE,
    &texture_not_found::RULE,
    &material_without_color::RULE,
    &missing_collision::RULE,
    &collision_smaller_than_visual::RULE,
    &mesh_far_from_link::RULE,
    &visual_collision_apart::RULE,
    &collision_left_out::RULE,
    &mesh_path_without_scheme::RULE,
    &collision_origin_mismatch::RULE,
    &invisible_material::RULE,
];
