// What a backlight did: "on, off".
#pragma once

#include <string>

namespace shade16::linux_spi {

class LightLog {
public:
    void look(bool shines) {
        if (shines == shines_) return;
        shines_ = shines;
        text_ += std::string(text_.empty() ? "" : ", ") + (shines ? "on" : "off");
    }
    const std::string& text() const { return text_; }

private:
    bool shines_ = false;
    std::string text_{};
};

}  // namespace shade16::linux_spi
