#include "host_sim/screen/lasting_screen.hpp"

#include "boards/linux_spi/device_gone.hpp"

namespace shade16::host {

bool LastingScreen::show(const Image& frame) {
    const bool was_away = screen_ == nullptr;
    try {
        if (was_away) screen_ = open_();
        screen_->show(frame);
        return true;
    } catch (const linux_spi::DeviceGone& gone) {
        lose(gone.what());
    } catch (const Error& error) {
        if (!was_away) throw;
        lose(error.what());  // not back yet, or not whole
    }
    return false;
}

void LastingScreen::close() {
    sum_ = figures();
    screen_.reset();
}

void LastingScreen::lose(const std::string& reason) {
    close();
    ++lost_;
    reason_ = reason;
}

}  // namespace shade16::host
