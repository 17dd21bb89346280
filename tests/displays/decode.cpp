// What a display shows after a log of what its bus carried: decode_display PANEL TURNS LOG PICTURE.ppm
// A word an event: w<ms> time that passed, r0 and r1 the reset line, c<hex> a command, d<hex> a byte of data.
#include <cstdio>
#include <cstdlib>
#include <display/all_panels.hpp>
#include <fstream>
#include <string>

#include "tests/displays/dcs_model.hpp"
#include "tests/displays/turned.hpp"

namespace shade16::displays {
namespace {

int fail(const std::string& sentence) {
    std::fprintf(stderr, "%s.\n", sentence.c_str());
    return 1;
}

void take(DcsModel& model, const std::string& event) {
    const auto number = static_cast<unsigned>(std::strtoul(event.c_str() + 1, nullptr, event[0] == 'w' ? 10 : 16));
    switch (event[0]) {
        case 'w': return model.delay_ms(number);
        case 'r': return model.reset_line(number != 0);
        case 'c': return model.command(static_cast<uint8_t>(number));
        default: return model.data(static_cast<uint8_t>(number));
    }
}

bool write(const std::string& path, const Seen& seen) {
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << seen.width << ' ' << seen.height << " 255\n";
    for (const uint16_t p : seen.pixels)
        file << static_cast<char>(p >> 8 & 0xF8) << static_cast<char>(p >> 3 & 0xFC) << static_cast<char>(p << 3 & 0xF8);
    return static_cast<bool>(file.flush());
}

int decode(const std::string& name, int turns, const std::string& log, const std::string& picture) {
    for (const DcsPanel& panel : all_panels) {
        if (panel.name != name) continue;
        std::ifstream file(log);
        if (!file) return fail(log + " cannot be read");
        DcsModel model(panel);
        for (std::string event; file >> event;) take(model, event);
        model.end();
        if (!model.complaint().empty()) return fail(model.complaint());
        return write(picture, turned(model.seen(), {(4 - turns) & 3})) ? 0 : fail(picture + " cannot be written");
    }
    return fail("no panel is called '" + name + "'");
}

}  // namespace
}  // namespace shade16::displays

int main(int count, char** words) {
    if (count != 5) {
        std::fputs("usage: decode_display PANEL TURNS LOG PICTURE.ppm\n", stderr);
        return 2;
    }
    return shade16::displays::decode(words[1], std::atoi(words[2]), words[3], words[4]);
}
