// The text cursor of the kernel's console, which would blink in the picture.
#pragma once

#include <fstream>
#include <string>

namespace shade16::host {

/// Hidden as long as this lives, where the console lets this user write to it; else it blinks on.
class HiddenCursor {
public:
    explicit HiddenCursor(const std::string& console) : console_(console, std::ios::in | std::ios::out) { console_ << "\033[?25l" << std::flush; }
    HiddenCursor(const HiddenCursor&) = delete;
    HiddenCursor& operator=(const HiddenCursor&) = delete;
    ~HiddenCursor() { console_ << "\033[?25h" << std::flush; }

private:
    std::fstream console_;
};

}  // namespace shade16::host
