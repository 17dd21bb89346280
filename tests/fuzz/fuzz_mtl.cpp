// Bytes as an MTL file: every material of it as the engine has it, with its pictures.
#include "host_sim/model/mtl_import.hpp"
#include "shade16/num/shininess_window.hpp"
#include "tests/fuzz/contract.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::fuzz {
namespace {

/// Beside the library, so that its materials can have pictures.
struct Directory : host::ScratchDirectory {
    Directory() {
        for (const std::string name : {"crate.png", "bricks.png"}) std::filesystem::copy_file(SHADE16_ASSETS "/" + name, path(name));
    }
};

void expect_in_range(const Material& m) {
    if (m.shininess < min_shininess || m.shininess > max_shininess) break_contract("A material has an exponent that is out of range.");
}

}  // namespace
}  // namespace shade16::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace shade16;
    static const fuzz::Directory scratch;
    scratch.write("library.mtl", fuzz::as_text(data, size));
    fuzz::is_accepted("library.mtl", [&] {
        std::vector<std::string> warnings;
        std::vector<tinyobj::material_t> materials;
        std::map<std::string, int> names;
        std::string warning, error;
        host::MtlReader(scratch.path(""), {"library.mtl"}, warnings)("", &materials, &names, &warning, &error);
        host::Remarks remarks;
        host::Pictures pictures(warnings);
        for (const tinyobj::material_t& mtl : materials)
            fuzz::expect_in_range(host::to_part(mtl, scratch.path(""), remarks, pictures, warnings).material);
        remarks.sentences();
    });
    return 0;
}
