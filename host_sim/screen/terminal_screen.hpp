// The terminal as a screen: two pixels a character. A preview, also over ssh.
#pragma once

#include "host_sim/screen/screen.hpp"

namespace shade16::host {

class TerminalScreen final : public Screen {
public:
    TerminalScreen();
    ~TerminalScreen() override;
    Viewport size() const override { return size_; }
    const char* format() const override { return Rgb888::name; }

private:
    std::size_t send(const Image& frame) override;
    Viewport size_;
    bool has_begun_ = false;
};

}  // namespace shade16::host
