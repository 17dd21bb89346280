// EXPECT: the replay cache has a power of two of slots
#include "shade16/shade16.hpp"

using namespace shade16;

constexpr Object objects[] = {{cube.mesh()}};
constexpr Scene scene{.objects = objects};
Workspace<scene, mediump, VertexStore::replay, 48> workspace;
