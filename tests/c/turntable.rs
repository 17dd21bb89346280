//! firmware/apps/turntable.cpp in Rust, at 320x240: the same frames. Before it draws, its structs are held against those of C.
#[path = "../../firmware/c/shade16.rs"]
mod shade16;

use shade16::*;
use std::ffi::CStr;
use std::mem::{size_of, MaybeUninit};
use std::process::exit;
use std::ptr::{addr_of, null, null_mut};

const WIDTH: usize = 320;
const HEIGHT: usize = 240;
const BAND_ROWS: usize = 40;

extern "C" {
    static c_teapot: *const Mesh;
    static c_layout_count: u32;
    static c_layouts: [[u32; 2]; 17];
}

/// A struct's size and where its last member lies.
macro_rules! layout {
    ($type:ty, $last:ident) => {{
        let place = MaybeUninit::<$type>::uninit();
        let base = place.as_ptr();
        let last = unsafe { addr_of!((*base).$last) } as usize;
        (stringify!($type), [size_of::<$type>() as u32, (last - base as usize) as u32])
    }};
}

fn check_layouts() {
    let ours = [
        layout!(Vec3, z), layout!(Mat3, row), layout!(Color, b), layout!(Scaled, exponent), layout!(Position, z), layout!(Normal, z),
        layout!(Triangle, c), layout!(Mesh, convex), layout!(Material, unlit), layout!(Attenuation, power), layout!(Spot, exponent),
        layout!(Light, spot), layout!(Camera, far_distance), layout!(Pose, translation), layout!(Object, pose), layout!(Scene, height_px),
        layout!(Frame, component),
    ];
    assert_eq!(ours.len(), unsafe { c_layout_count } as usize, "structs in Rust and in C");
    for ((name, ours), theirs) in ours.iter().zip(unsafe { c_layouts }) {
        assert_eq!(*ours, theirs, "{}: its bytes, and where its last member lies, in Rust and in C", name);
    }
}

fn expect_ok(status: Status) {
    if status != OK {
        println!("{}", unsafe { CStr::from_ptr(shade16_status_text(status).cast()) }.to_str().unwrap());
        exit(1);
    }
}

fn draw_frame(renderer: *mut Renderer, step: u32, pixels: &mut [u16], depth: &mut [u16]) {
    let mut hash = 2166136261u32;
    unsafe {
        let turn = shade16_multiply(shade16_rotate_y(degrees(45).wrapping_mul(step)), shade16_rotate_x(degrees(20)));
        let pose = shade16_centred_pose((*c_teapot).centre, turn, 65536 / 12);
        let frame = Frame { camera: null(), lights: null(), poses: &pose, materials: null(), light_count: 0, pose_count: 1, material_count: 0, component: COMPONENT_ALL };
        expect_ok(shade16_begin(renderer, &frame));
        for row in (0..HEIGHT).step_by(BAND_ROWS) {
            expect_ok(shade16_draw_rgb565(renderer, pixels.as_mut_ptr(), depth.as_mut_ptr(), row as i32, BAND_ROWS as i32));
            for byte in pixels.iter().flat_map(|pixel| pixel.to_ne_bytes()) {
                hash = (hash ^ byte as u32).wrapping_mul(16777619);
            }
        }
    }
    println!("frame {} {:08x}", step, hash);
}

fn main() {
    check_layouts();
    let white = rgb(0xFFFFFF);
    let lights = unsafe {
        [
            shade16_ambient_light(rgb(0x484848)),
            shade16_directional_light(Vec3 { x: q16(-5), y: q16(5), z: q16(9) }, white, intensity(7, 10)),
            shade16_point_light(Vec3 { x: q16(4), y: q16(1), z: q16(3) }, rgb(0x9FB8FF), intensity(1, 4)),
        ]
    };
    let brass = unsafe { *shade16_find_material("brass\0".as_ptr()) };
    let object = Object { mesh: unsafe { c_teapot }, material: brass, pose: unsafe { shade16_default_pose() } };
    let mut camera = unsafe { shade16_default_camera() };
    camera.eye = Vec3 { x: 0, y: q16(2), z: q16(5) };
    camera.viewer = VIEWER_LOCAL;
    camera.fov_y = degrees(36);
    camera.near_distance = q16(2);
    camera.far_distance = q16(9);
    let scene = Scene {
        camera, lights: lights.as_ptr(), objects: &object, light_count: 3, object_count: 1, background: rgb(0x101820),
        width_px: WIDTH as i32, height_px: HEIGHT as i32,
    };

    let mut memory = vec![0u64; (unsafe { shade16_workspace_bytes(&scene) } + 7) / 8];
    let mut renderer = null_mut();
    expect_ok(unsafe { shade16_init(memory.as_mut_ptr().cast(), memory.len() * 8, &scene, &mut renderer) });
    let (mut pixels, mut depth) = (vec![0u16; WIDTH * BAND_ROWS], vec![0u16; WIDTH * BAND_ROWS]);
    for step in 0..8 {
        draw_frame(renderer, step, &mut pixels, &mut depth);
    }
}
