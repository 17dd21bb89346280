#include "tests/identity/frames.hpp"

#include "tests/identity/frame_run.hpp"
#include "tests/renderer/scenes.hpp"

namespace shade16::identity {

void say_frames() {
    say_frame<host::torus_scene, lowp, Rgb565>("frame gouraud.lowp.rgb565");
    say_frame<host::map_scene, highp, Rgb565Swapped>("frame orthographic.highp.rgb565_swapped");
    say_frame<host::inside_scene, mediump, Dithered<Gray4, bayer4>>("frame flat_unlit_clipped.mediump.gray4_dithered");
}

}  // namespace shade16::identity
