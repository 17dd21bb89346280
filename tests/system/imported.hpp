// A model from a few lines of text.
#pragma once

#include "host_sim/model/obj_import.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {

inline const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// `mtl` is beside it as a.mtl.
inline Model imported(const std::string& obj, const std::string& mtl = "") {
    const ScratchDirectory scratch;
    if (!mtl.empty()) scratch.write("a.mtl", mtl);
    return import_obj(scratch.write("a.obj", obj));
}

}  // namespace shade16::host
