// One picture of the scenes lit at their vertices, of every kind of light.
#include "tests/renderer/pictures.hpp"

namespace shade16::host {
namespace {

using Scenes = testing::Types<Named<torus_scene>, Named<flat_scene>, Named<cube_scene>, Named<egg_scene>, Named<map_scene>, Named<crowd_scene>, Named<inside_scene>,
                              Named<mirrored_scene>, Named<ending_scene>, Named<falling_scene>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Gouraud, OnePicture, Scenes);

}  // namespace
}  // namespace shade16::host
