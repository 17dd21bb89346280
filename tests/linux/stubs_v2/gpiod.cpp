// libgpiod 2 over the chips in memory. Descriptions are copies, and a request may outlive its chip, as there.
#include <gpiod.h>

#include "tests/linux/fake_gpio.hpp"

using shade16::linux_spi::fake;
using shade16::linux_spi::FakeChip;
using shade16::linux_spi::FakeLine;

struct gpiod_chip {
    FakeChip* chip;
};
struct gpiod_chip_info {
    std::string label;
    size_t lines;
};
struct gpiod_line_info {
    FakeLine line;
};
struct gpiod_line_settings {
    bool output = false, active_low = false, value = false;
};
struct gpiod_line_config {
    unsigned offset = 0;
    gpiod_line_settings settings{};
};
struct gpiod_request_config {
    std::string consumer{};
};
struct gpiod_line_request {
    FakeChip* chip;
    unsigned offset;
    int removals;
};

namespace {
template <class T>
T* made(const T& thing) {
    if (fake.fails()) return nullptr;
    ++fake.things;
    return new T(thing);
}
template <class T>
void end(T* thing) {
    --fake.things;
    delete thing;
}
const char* or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }
int result() { return fake.fails() ? -1 : 0; }
}  // namespace

gpiod_chip* gpiod_chip_open(const char* path) {
    FakeChip* const chip = fake.open(path);
    return chip == nullptr ? nullptr : made(gpiod_chip{chip});
}
void gpiod_chip_close(gpiod_chip* chip) { end(chip); }
gpiod_chip_info* gpiod_chip_get_info(gpiod_chip* chip) { return made(gpiod_chip_info{chip->chip->label, chip->chip->lines.size()}); }
gpiod_line_info* gpiod_chip_get_line_info(gpiod_chip* chip, unsigned offset) {
    if (offset >= chip->chip->lines.size()) return errno = EINVAL, nullptr;
    return made(gpiod_line_info{chip->chip->lines[offset]});
}
gpiod_line_request* gpiod_chip_request_lines(gpiod_chip* chip, gpiod_request_config* config, gpiod_line_config* lines) {
    if (!lines->settings.output) return errno = EINVAL, nullptr;
    gpiod_line_request* const request = made(gpiod_line_request{chip->chip, lines->offset, chip->chip->removals});
    if (request == nullptr) return nullptr;
    if (fake.request(*chip->chip, lines->offset, config->consumer, lines->settings.active_low, lines->settings.value) == 0) return request;
    end(request);
    return nullptr;
}

void gpiod_chip_info_free(gpiod_chip_info* info) { end(info); }
const char* gpiod_chip_info_get_label(gpiod_chip_info* info) { return info->label.c_str(); }
size_t gpiod_chip_info_get_num_lines(gpiod_chip_info* info) { return info->lines; }

void gpiod_line_info_free(gpiod_line_info* info) { end(info); }
const char* gpiod_line_info_get_name(gpiod_line_info* info) { return or_null(info->line.name); }
const char* gpiod_line_info_get_consumer(gpiod_line_info* info) { return or_null(info->line.consumer); }
bool gpiod_line_info_is_used(gpiod_line_info* info) { return info->line.used; }

gpiod_line_settings* gpiod_line_settings_new() { return made(gpiod_line_settings{}); }
void gpiod_line_settings_free(gpiod_line_settings* settings) { end(settings); }
int gpiod_line_settings_set_direction(gpiod_line_settings* settings, gpiod_line_direction direction) {
    settings->output = direction == GPIOD_LINE_DIRECTION_OUTPUT;
    return result();
}
void gpiod_line_settings_set_active_low(gpiod_line_settings* settings, bool active_low) { settings->active_low = active_low; }
int gpiod_line_settings_set_output_value(gpiod_line_settings* settings, gpiod_line_value value) {
    settings->value = value == GPIOD_LINE_VALUE_ACTIVE;
    return result();
}

gpiod_line_config* gpiod_line_config_new() { return made(gpiod_line_config{}); }
void gpiod_line_config_free(gpiod_line_config* config) { end(config); }
int gpiod_line_config_add_line_settings(gpiod_line_config* config, const unsigned* offsets, size_t count, gpiod_line_settings* settings) {
    if (count != 1) return errno = EINVAL, -1;
    config->offset = offsets[0], config->settings = *settings;
    return result();
}

gpiod_request_config* gpiod_request_config_new() { return made(gpiod_request_config{}); }
void gpiod_request_config_free(gpiod_request_config* config) { end(config); }
void gpiod_request_config_set_consumer(gpiod_request_config* config, const char* consumer) { config->consumer = consumer; }

void gpiod_line_request_release(gpiod_line_request* request) {
    fake.release(request->chip->lines.at(request->offset));
    end(request);
}
int gpiod_line_request_set_value(gpiod_line_request* request, unsigned offset, gpiod_line_value value) {
    if (offset != request->offset) return errno = EINVAL, -1;
    return fake.set(*request->chip, offset, value == GPIOD_LINE_VALUE_ACTIVE, request->removals);
}
