//! The engine: illumination, geometry, scenes and their files, links, rendering.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod accuracy;
mod animation;
mod api;
mod camera_roll;
mod depth_cueing;
mod documents;
mod drawing;
mod export;
mod fine_meshes;
mod formulas;
mod framing;
mod geometry_normals;
mod geometry_polygons;
mod geometry_shapes;
mod geometry_surfaces;
mod geometry_teapot;
mod golden;
mod illumination_parts;
mod imports;
mod interpolation;
mod law_limits;
mod laws;
mod laws_as_formulas;
mod levels;
mod link;
mod memory;
mod model_glass;
mod model_materials;
mod obj_files;
mod obj_materials;
mod obj_memory;
mod omissions;
mod own_law;
mod own_law_reasons;
mod parameters;
mod picture;
mod random_laws;
mod rays;
mod robustness;
mod scene_format;
mod scene_round_trip;
mod slices;
mod specular;
mod stages;
mod text;
mod vertex_colors;
mod view;
