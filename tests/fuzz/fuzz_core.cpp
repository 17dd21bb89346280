// Bytes to a scene to a frame: whatever a scene says, a frame is drawn, and nothing is undefined.
#include "tests/fuzz/byte_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace shade16::fuzz;
    const ByteScene scene(Bytes(data, size));
    check_drawing(scene.drawing());
    return 0;
}
