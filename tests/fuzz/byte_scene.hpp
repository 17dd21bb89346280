// ByteScene: bytes as a scene, a frame of it, and how that frame is drawn.
#pragma once

#include <deque>
#include <vector>

#include "tests/fuzz/byte_maps.hpp"
#include "tests/fuzz/byte_mesh.hpp"
#include "tests/fuzz/drawing.hpp"

namespace shade16::fuzz {

class ByteScene {
public:
    explicit ByteScene(Bytes bytes);
    ByteScene(const ByteScene&) = delete;
    ByteScene& operator=(const ByteScene&) = delete;

    const Drawing& drawing() const { return drawing_; }

private:
    void choose_target();
    Camera camera();
    Light light();
    std::vector<Light> lights(std::size_t count);
    Object object();
    Material material();
    void choose_maps(Material& m);
    Pose pose();
    void choose_frame();

    ByteFields f_;
    std::vector<Light> lights_{};
    std::vector<Object> objects_{};
    std::deque<ByteMesh> meshes_{};  // deques: the scene points into them
    std::deque<ByteMaps> maps_{};

    // What a frame says in place of the scene.
    Camera other_camera_{};
    std::vector<Light> other_lights_{};
    std::vector<Pose> other_poses_{};
    std::vector<Material> other_materials_{};

    Scene scene_{};
    Frame frame_{};
    Drawing drawing_{};
};

}  // namespace shade16::fuzz
