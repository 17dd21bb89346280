// One picture of the scenes with textures, reliefs and tables of light.
#include "tests/renderer/pictures.hpp"

namespace shade16::host {
namespace {

using Scenes = testing::Types<Named<crate_scene>, Named<textured_scene>, Named<clipped_textured_scene>, Named<floor_scene>, Named<table_scene>,
                              Named<unused_table_scene>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Maps, OnePicture, Scenes);

}  // namespace
}  // namespace shade16::host
