//! shade16 for Rust: what shade16.h declares, with the same names, units and memory. `no_std`, edition 2021, Rust 1.63 and later.
//! docs/c.md says how to link; the meanings are written in shade16.h, shade16_scene.h and shade16_status.h.
#![allow(dead_code)]

use core::ffi::c_void;

pub type Status = i32;
pub const OK: Status = 0;

/// A number in units of 2^-16; an angle in units of 2^-32 turn.
pub type Q16 = i32;
pub type Angle = u32;

pub const fn q16(whole: i16) -> Q16 {
    whole as i32 * 65536
}
pub const fn degrees(whole: u16) -> Angle {
    ((((whole as u64) << 32) + 180) / 360) as Angle
}
/// An intensity of n / d, below 256.
pub const fn intensity(n: u32, d: u32) -> Scaled {
    Scaled { mantissa: ((2 * n as u64 * 16777216 + d as u64) / (2 * d as u64)) as u32, exponent: 8 }
}
pub const fn rgb(hex: u32) -> Color {
    Color { r: (hex >> 16 & 255) as u16 * 257, g: (hex >> 8 & 255) as u16 * 257, b: (hex & 255) as u16 * 257 }
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    pub x: Q16,
    pub y: Q16,
    pub z: Q16,
}
/// Rows of numbers in units of 2^-30.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mat3 {
    pub row: [[i32; 3]; 3],
}
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    pub r: u16,
    pub g: u16,
    pub b: u16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scaled {
    pub mantissa: u32,
    pub exponent: i16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Position {
    pub x: i16,
    pub y: i16,
    pub z: i16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Normal {
    pub x: i16,
    pub y: i16,
    pub z: i16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Triangle {
    pub a: u16,
    pub b: u16,
    pub c: u16,
}

#[repr(C)]
pub struct Mesh {
    pub positions: *const Position,
    pub normals: *const Normal,
    pub colors: *const Color,
    pub triangles: *const Triangle,
    pub vertex_count: u32,
    pub triangle_count: u32,
    pub centre: Vec3,
    pub fraction_bits: i8,
    pub convex: u8,
}
// Its arrays are in flash, and nobody writes them.
unsafe impl Sync for Mesh {}

pub const SHADING_FLAT: u8 = 0;
pub const SHADING_GOURAUD: u8 = 1;
pub const SHADING_PHONG: u8 = 2;
pub const NORMALS_LINEAR: u8 = 0;
pub const NORMALS_SPHERICAL: u8 = 1;
pub const REFLECTION_BLINN_PHONG: u8 = 0;
pub const REFLECTION_PHONG: u8 = 1;

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub ambient: Color,
    pub diffuse: Color,
    pub specular: Color,
    pub emissive: Color,
    pub shininess: Q16,
    pub reflection: u8,
    pub shading: u8,
    pub normal_path: u8,
    pub unlit: u8,
}

pub const LIGHT_AMBIENT: u8 = 0;
pub const LIGHT_DIRECTIONAL: u8 = 1;
pub const LIGHT_POINT: u8 = 2;
pub const LIGHT_SPOT: u8 = 3;
pub const SPACE_WORLD: u8 = 0;
pub const SPACE_VIEW: u8 = 1;
pub const SPACE_OBJECT: u8 = 2;

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation {
    pub constant: Q16,
    pub linear: Q16,
    pub quadratic: Q16,
    pub power: Q16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    pub direction: Vec3,
    pub inner: Angle,
    pub outer: Angle,
    pub exponent: Q16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    pub kind: u8,
    pub position: Vec3,
    pub diffuse: Color,
    pub specular: Color,
    pub intensity: Scaled,
    pub space: u8,
    pub attenuation: Attenuation,
    pub range: Q16,
    pub spot: Spot,
}

pub const PERSPECTIVE: u8 = 0;
pub const ORTHOGRAPHIC: u8 = 1;
pub const VIEWER_INFINITE: u8 = 0;
pub const VIEWER_LOCAL: u8 = 1;

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub eye: Vec3,
    pub target: Vec3,
    pub up: Vec3,
    pub projection: u8,
    pub viewer: u8,
    pub fov_y: Angle,
    pub view_height: Q16,
    pub near_distance: Q16,
    pub far_distance: Q16,
}
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub rotation: Mat3,
    pub scale: Vec3,
    pub translation: Vec3,
}
#[repr(C)]
pub struct Object {
    pub mesh: *const Mesh,
    pub material: Material,
    pub pose: Pose,
}
#[repr(C)]
pub struct Scene {
    pub camera: Camera,
    pub lights: *const Light,
    pub objects: *const Object,
    pub light_count: u32,
    pub object_count: u32,
    pub background: Color,
    pub width_px: i32,
    pub height_px: i32,
}

pub const COMPONENT_ALL: u8 = 0;
pub const COMPONENT_AMBIENT: u8 = 1;
pub const COMPONENT_DIFFUSE: u8 = 2;
pub const COMPONENT_SPECULAR: u8 = 3;

/// What differs from the frame before; a null pointer: nothing.
#[repr(C)]
pub struct Frame {
    pub camera: *const Camera,
    pub lights: *const Light,
    pub poses: *const Pose,
    pub materials: *const Material,
    pub light_count: u32,
    pub pose_count: u32,
    pub material_count: u32,
    pub component: u8,
}

/// Lies at the beginning of the memory that shade16_init is given.
#[repr(C)]
pub struct Renderer {
    _private: [u8; 0],
}

extern "C" {
    pub fn shade16_workspace_bytes(scene: *const Scene) -> usize;
    pub fn shade16_init(memory: *mut c_void, bytes: usize, scene: *const Scene, renderer: *mut *mut Renderer) -> Status;
    pub fn shade16_begin(renderer: *mut Renderer, frame: *const Frame) -> Status;
    pub fn shade16_draw_rgb565(renderer: *mut Renderer, pixels: *mut u16, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_rgb565_swapped(renderer: *mut Renderer, pixels: *mut u16, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_gray8(renderer: *mut Renderer, pixels: *mut u8, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_gray4(renderer: *mut Renderer, pixels: *mut u8, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_gray4_dithered(renderer: *mut Renderer, pixels: *mut u8, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_mono1(renderer: *mut Renderer, pixels: *mut u8, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    pub fn shade16_draw_mono1_dithered(renderer: *mut Renderer, pixels: *mut u8, depth: *mut u16, first_row: i32, rows: i32) -> Status;
    /// Texts and names end with a zero byte.
    pub fn shade16_status_text(status: Status) -> *const u8;

    pub fn shade16_default_camera() -> Camera;
    pub fn shade16_default_material() -> Material;
    pub fn shade16_default_pose() -> Pose;
    pub fn shade16_ambient_light(color: Color) -> Light;
    pub fn shade16_directional_light(towards: Vec3, color: Color, intensity: Scaled) -> Light;
    pub fn shade16_point_light(position: Vec3, color: Color, intensity: Scaled) -> Light;
    pub fn shade16_spot_light(position: Vec3, spot: Spot, color: Color, intensity: Scaled) -> Light;
    pub fn shade16_find_material(name: *const u8) -> *const Material;
    pub fn shade16_rotate_x(angle: Angle) -> Mat3;
    pub fn shade16_rotate_y(angle: Angle) -> Mat3;
    pub fn shade16_rotate_z(angle: Angle) -> Mat3;
    pub fn shade16_multiply(a: Mat3, b: Mat3) -> Mat3;
    pub fn shade16_centred_pose(centre: Vec3, rotation: Mat3, scale: Q16) -> Pose;
}
