// The frame that the guest shows and this computer hashes: the torus of benchmark S2 on a small panel, drawn in bands as a board does.
#pragma once

#include <assets/scenes/s2.hpp>
#include <display/st7735.hpp>
#include <memory>
#include <runtime/fnv1a.hpp>
#include <shade16/shade16.hpp>
#include <vector>

namespace shade16::linux_spi {

inline constexpr const DcsPanel& guest_panel = st7735_80x160;
inline constexpr Orientation guest_orientation{1};  // on its side
inline constexpr Viewport guest_screen{160, 80};
inline constexpr int guest_band_rows = 16, guest_bands = guest_screen.height / guest_band_rows;

/// Draws the frame into any sink of swapped RGB565, a band at a time.
template <class S>
void present_torus(S& sink) {
    using namespace assets;
    using Torus = Renderer<s2::scene, s2::Tier, VertexStore::keep, needs_of(s2::scene)>;
    const auto workspace = std::make_unique<Workspace<s2::scene, s2::Tier, VertexStore::keep>>();
    const auto renderer = std::make_unique<Torus>(*workspace);
    using Buffer = BandBuffer<Rgb565Swapped, guest_screen.width, guest_band_rows, needs_of(s2::scene).depth>;
    struct Buffers {
        Buffer all[1]{};
    };
    const auto buffers = std::make_unique<Buffers>();
    const Pose pose = s2::spins[0].at({});
    present(*renderer, {.poses = &pose}, guest_screen, buffers->all, sink);
}

/// A frame as RGB565 codes.
class KeptFrame {
public:
    void flush(Area, const Rgb565Swapped::Pixel* pixels, size_t bytes, bool) {
        const auto* const byte = reinterpret_cast<const uint8_t*>(pixels);
        for (size_t i = 0; i < bytes; i += 2) codes_.push_back(static_cast<uint16_t>(byte[i] << 8 | byte[i + 1]));
    }
    void wait() {}
    const std::vector<uint16_t>& codes() const { return codes_; }

private:
    std::vector<uint16_t> codes_{};
};

inline uint32_t hash_of(const std::vector<uint16_t>& codes) {
    Fnv1a hash;
    for (const uint16_t code : codes) hash.add(static_cast<uint8_t>(code >> 8)), hash.add(static_cast<uint8_t>(code));
    return hash.value;
}

inline std::vector<uint16_t> torus_codes() {
    KeptFrame frame;
    present_torus(frame);
    return frame.codes();
}

}  // namespace shade16::linux_spi
