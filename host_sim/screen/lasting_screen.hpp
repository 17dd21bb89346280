// A screen that may go and come back: unplugged, its driver taken down, its lines' chip removed.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "host_sim/screen/screen.hpp"

namespace shade16::host {

class LastingScreen {
public:
    using Open = std::function<std::unique_ptr<Screen>()>;

    /// Opens it; here what is missing is an error.
    explicit LastingScreen(Open open) : open_(std::move(open)), screen_(open_()) {}

    /// Whether the frame is shown. Where it is not, the device has gone; it is begun anew, from its reset, with the next frame, which
    /// is sent whole. An error that is no going and no lack of return is thrown.
    bool show(const Image& frame);

    /// Gives back all that it holds. Not to be shown on afterwards.
    void close();

    /// nullptr while it is away.
    Screen* screen() const { return screen_.get(); }
    ScreenFigures figures() const { return screen_ ? sum_ + screen_->figures() : sum_; }
    std::size_t lost() const { return lost_; }
    /// Why it is away.
    const std::string& reason() const { return reason_; }

private:
    void lose(const std::string& reason);

    Open open_;
    std::unique_ptr<Screen> screen_;
    ScreenFigures sum_{};  // of the screens before this one
    std::size_t lost_ = 0;
    std::string reason_{};
};

}  // namespace shade16::host
