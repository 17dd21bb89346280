// libgpiod 1 over the chips in memory. A line lives in its chip, as there.
#include <gpiod.h>

#include <memory>

#include "tests/linux/fake_gpio.hpp"

using shade16::linux_spi::fake;
using shade16::linux_spi::FakeChip;
using shade16::linux_spi::FakeLine;

struct gpiod_line {
    FakeChip* chip;
    unsigned offset;
    int removals;
    FakeLine& fake_line() const { return chip->lines.at(offset); }
};
struct gpiod_chip {
    FakeChip* chip;
    std::vector<std::unique_ptr<gpiod_line>> lines{};
};

namespace {
const char* or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }
}  // namespace

gpiod_chip* gpiod_chip_open(const char* path) {
    FakeChip* const chip = fake.open(path);
    if (chip == nullptr) return nullptr;
    ++fake.things;
    return new gpiod_chip{chip};
}
void gpiod_chip_close(gpiod_chip* chip) {
    --fake.things;
    delete chip;
}
const char* gpiod_chip_label(gpiod_chip* chip) { return chip->chip->label.c_str(); }
unsigned gpiod_chip_num_lines(gpiod_chip* chip) { return static_cast<unsigned>(chip->chip->lines.size()); }
gpiod_line* gpiod_chip_get_line(gpiod_chip* chip, unsigned offset) {
    if (offset >= chip->chip->lines.size()) return errno = EINVAL, nullptr;
    if (fake.fails()) return nullptr;
    chip->lines.push_back(std::make_unique<gpiod_line>(gpiod_line{chip->chip, offset, chip->chip->removals}));
    return chip->lines.back().get();
}

const char* gpiod_line_name(gpiod_line* line) { return or_null(line->fake_line().name); }
const char* gpiod_line_consumer(gpiod_line* line) { return or_null(line->fake_line().consumer); }
bool gpiod_line_is_used(gpiod_line* line) { return line->fake_line().used; }
int gpiod_line_request_output_flags(gpiod_line* line, const char* consumer, int flags, int value) {
    return fake.request(*line->chip, line->offset, consumer, flags == GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW, value != 0);
}
int gpiod_line_set_value(gpiod_line* line, int value) { return fake.set(*line->chip, line->offset, value != 0, line->removals); }
void gpiod_line_release(gpiod_line* line) { fake.release(line->fake_line()); }
