// The terminal as a screen: two pixels a character. A preview, also over ssh.
#pragma once

#include <optional>

#include "host_sim/cli/terminal.hpp"
#include "host_sim/screen/screen.hpp"

namespace shade16::host {

class TerminalScreen final : public Screen {
public:
    Viewport size() const override { return pixels_of_terminal(); }
    const char* format() const override { return nullptr; }
    std::size_t send(const Image& frame) override;

private:
    std::optional<TerminalHeld> held_{};  // from the first frame on
    int shown_width_ = 0, shown_height_ = 0;
};

}  // namespace shade16::host
