// A panel of the Display Command Set, known at run time, on any bus. Only rows that changed are sent.
#pragma once

#include <display/dcs.hpp>

#include "host_sim/screen/changed_rows.hpp"
#include "host_sim/screen/panel_by_name.hpp"
#include "host_sim/screen/screen.hpp"

namespace shade16::host {

template <DisplayBus Bus>
class PanelScreen final : public Screen {
public:
    /// Switches the panel on.
    PanelScreen(Bus bus, Panel panel, Orientation orientation) : bus_(std::move(bus)), panel_(std::move(panel)), orientation_(orientation) {
        dcs::begin(bus_, *panel_, orientation_);
    }

    Viewport size() const override {
        const bool turned = orientation_.quarter_turns % 2 != 0;
        return turned ? Viewport{panel_->height_px, panel_->width_px} : Viewport{panel_->width_px, panel_->height_px};
    }
    const char* format() const override { return Bus::Format::name; }
    void switch_off() override { bus_.command(dcs::display_off), bus_.wait(); }
    std::size_t send(const Image& frame) override {
        using Pixel = typename Bus::Format::Pixel;
        std::size_t sent = 0;
        const std::vector<RowRun> runs = changed_.of(frame.raw, frame.height);
        if (runs.empty()) bus_.command(dcs::no_operation), bus_.wait();  // a panel that has gone does not show a still picture
        for (const RowRun run : runs) {
            const auto first = static_cast<std::size_t>(run.first * frame.width), count = static_cast<std::size_t>(run.count * frame.width);
            pixels_.resize(count);
            std::memcpy(pixels_.data(), frame.raw.data() + first * sizeof(Pixel), count * sizeof(Pixel));
            dcs::select(bus_, dcs::gap_of(*panel_, orientation_), {0, run.first, frame.width, run.count});
            bus_.pixels(pixels_.data(), count);
            bus_.wait();
            sent += count * sizeof(Pixel);
        }
        changed_.are_sent(frame.raw);
        return sent;
    }

private:
    Bus bus_;
    Panel panel_;
    Orientation orientation_;
    ChangedRows changed_{};
    std::vector<typename Bus::Format::Pixel> pixels_{};
};

}  // namespace shade16::host
