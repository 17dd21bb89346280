// A panel of the Display Command Set, known at run time, on any bus. Only rows that changed are sent.
#pragma once

#include <display/dcs.hpp>

#include "host_sim/screen/changed_rows.hpp"
#include "host_sim/screen/screen.hpp"

namespace shade16::host {

template <DisplayBus Bus>
class PanelScreen : public Screen {
public:
    /// Switches the panel on. `panel` outlives this.
    PanelScreen(Bus& bus, const DcsPanel& panel, Orientation orientation) : bus_(bus), panel_(panel), orientation_(orientation) {
        dcs::begin(bus_, panel_, orientation_);
    }

    Viewport size() const override {
        return orientation_.quarter_turns % 2 != 0 ? Viewport{panel_.height_px, panel_.width_px} : Viewport{panel_.width_px, panel_.height_px};
    }
    const char* format() const override { return Bus::Format::name; }
    void switch_off() override { bus_.command(dcs::display_off); }

private:
    std::size_t send(const Image& frame) override {
        using Pixel = typename Bus::Format::Pixel;
        std::size_t sent = 0;
        for (const RowRun run : changed_.of(frame.raw, frame.height)) {
            const auto first = static_cast<std::size_t>(run.first * frame.width), count = static_cast<std::size_t>(run.count * frame.width);
            pixels_.resize(count);
            std::memcpy(pixels_.data(), frame.raw.data() + first * sizeof(Pixel), count * sizeof(Pixel));
            dcs::select(bus_, dcs::gap_of(panel_, orientation_), {0, run.first, frame.width, run.count});
            bus_.pixels(pixels_.data(), count);
            bus_.wait();
            sent += count * sizeof(Pixel);
        }
        changed_.are_sent(frame.raw);
        return sent;
    }

    Bus& bus_;
    const DcsPanel& panel_;
    Orientation orientation_;
    ChangedRows changed_{};
    std::vector<typename Bus::Format::Pixel> pixels_{};
};

}  // namespace shade16::host
