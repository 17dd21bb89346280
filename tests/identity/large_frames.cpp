#include "tests/identity/frames.hpp"

#include "tests/identity/frame_run.hpp"
#include "tests/renderer/scenes.hpp"

namespace shade16::identity {

void say_large_frames() {
    say_frame<host::stage_scene, highp, Rgb888>("large_frame lamps_of_all_kinds.highp.rgb888");
    say_frame<host::mixed_scene, mediump, Gray8>("large_frame phong.mediump.gray8");
    say_frame<host::clipped_textured_scene, lowp, Dithered<Rgb565, bayer8>>("large_frame textured.lowp.rgb565_dithered");
    say_frame<host::table_scene, mediump, Mono1>("large_frame light_table.mediump.mono1");
}

}  // namespace shade16::identity
