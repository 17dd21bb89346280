// One picture of the scenes lit at their pixels.
#include "tests/renderer/pictures.hpp"

namespace shade16::host {
namespace {

using Scenes = testing::Types<Named<smooth_scene>, Named<lamp_scene>, Named<round_scene>, Named<mixed_scene>, Named<clipped_scene>, Named<stage_scene>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Phong, OnePicture, Scenes);

}  // namespace
}  // namespace shade16::host
