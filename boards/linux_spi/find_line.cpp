#include "boards/linux_spi/find_line.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>

#include "boards/linux_spi/permission.hpp"
#include "host_sim/error.hpp"
#include "host_sim/nearest_word.hpp"

namespace shade16::linux_spi {

namespace {

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words, const std::string& last = " and ") {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
    return text;
}

std::optional<unsigned> number_of(const std::string& text) {
    unsigned number = 0;
    const char* const end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && after == end ? std::optional(number) : std::nullopt;
}

std::string as_chip_and_offset(const Place& place) {
    return std::filesystem::path(place.chip).filename().string() + ":" + std::to_string(place.offset);
}

/// What a look at all chips found.
struct Survey {
    std::vector<Place> found{};
    std::vector<std::string> names{}, refused{}, pin_controllers{};
};

void survey_chip(Survey& survey, const std::string& path, const std::string& name) {
    const gpio::Chip chip(path);
    if (chip.label().starts_with("pinctrl-")) survey.pin_controllers.push_back(path);
    for (unsigned offset = 0; offset < chip.line_count(); ++offset) {
        const std::string called = chip.line(offset).name;
        if (called == name) survey.found.push_back({path, offset});
        if (!called.empty()) survey.names.push_back(called);
    }
}

Survey survey_of(const std::string& name, const std::string& wanted, const std::string& devices) {
    Survey survey;
    const std::vector<std::string> chips = chips_of(devices);
    if (chips.empty())
        throw host::io_error("line '{}': there is no {}/gpiochip0, nor any other chip with lines; expected a kernel with a driver for the board's GPIO.",
                             wanted, devices);
    for (const std::string& path : chips) try {
            survey_chip(survey, path, name);
        } catch (const std::system_error& error) {
            if (error.code().value() == EACCES || error.code().value() == EPERM) survey.refused.push_back(path);
            else if (error.code().value() != ENODEV && error.code().value() != ENOENT)  // unplugged meanwhile
                throw host::io_error("line '{}': {} cannot be read: {}; expected a chip with lines.", wanted, path, error.code().message());
        }
    return survey;
}

host::Error two_alike(const std::string& wanted, const std::vector<Place>& places) {
    std::vector<std::string> on, ways;
    for (const Place& place : places) {
        on.push_back(place.chip + " (line " + std::to_string(place.offset) + ")");
        ways.push_back("'" + as_chip_and_offset(place) + "'");
    }
    return host::input_error("line '{}' is on {}; say which, by {}.", wanted, listed(on), listed(ways, " or "));
}

/// Up to three names that a mistyped one may have meant, the nearest first.
std::vector<std::string> nearest(const std::string& typed, std::vector<std::string> names) {
    const auto distance = [&](const std::string& name) { return host::edit_distance(typed, name); };
    std::erase_if(names, [&](const std::string& name) { return distance(name) > std::max<std::size_t>(typed.size() / 3, 1); });
    std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
        return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
    });
    names.erase(std::unique(names.begin(), names.end()), names.end());
    names.resize(std::min<std::size_t>(names.size(), 3));
    return names;
}

host::Error not_found(const std::string& name, const Survey& survey, const std::string& devices) {
    const std::string chips = listed(chips_of(devices));
    if (survey.names.empty())
        return host::input_error("no line is called '{}', and no line of {} has a name; expected a chip and an offset, such as 'gpiochip0:25'.", name, chips);
    const std::vector<std::string> near = nearest(name, survey.names);
    if (!near.empty())
        return host::input_error("no line of {} is called '{}'; did you mean {}?", chips, name, listed(near, " or "));
    return host::input_error("no line of {} is called '{}'; expected a name such as {}, or a chip and an offset, such as 'gpiochip0:25'.", chips,
                             name, survey.names.front());
}

/// The only line of that name, or nothing.
std::optional<Place> only(const std::string& wanted, const Survey& survey) {
    if (survey.found.size() > 1) throw two_alike(wanted, survey.found);
    if (survey.found.size() == 1) return survey.found.front();
    if (!survey.refused.empty()) throw permission_denied("line '" + wanted + "'", survey.refused.front(), "gpio");
    return std::nullopt;
}

Place find_number(unsigned number, const std::string& devices) {
    const std::string wanted = std::to_string(number), name = "GPIO" + wanted;
    const Survey survey = survey_of(name, wanted, devices);
    if (const auto place = only(wanted, survey)) return *place;
    if (survey.pin_controllers.empty())
        throw host::input_error("line '{}': no line is called '{}', and no chip's label begins with 'pinctrl-'; expected a chip, too, such as 'gpiochip0:{}'.",
                                wanted, name, wanted);
    if (survey.pin_controllers.size() > 1) {
        std::vector<Place> places;
        for (const std::string& chip : survey.pin_controllers) places.push_back({chip, number});
        throw two_alike(wanted, places);
    }
    return {survey.pin_controllers.front(), number};
}

/// A line's name may have a colon, so only a chip's name or path before it and a number behind it are a chip and an offset.
std::optional<Place> chip_and_offset(const std::string& wanted, const std::string& devices) {
    const std::size_t colon = wanted.rfind(':');
    if (colon == std::string::npos || !(wanted.starts_with("gpiochip") || wanted.starts_with("/"))) return std::nullopt;
    const auto offset = number_of(wanted.substr(colon + 1));
    if (!offset) throw host::input_error("line '{}' has no number behind its colon; expected a chip and an offset, such as 'gpiochip0:25'.", wanted);
    const std::string chip = wanted.substr(0, colon);
    return Place{chip.starts_with("/") ? chip : devices + "/" + chip, *offset};
}

}  // namespace

std::vector<std::string> chips_of(const std::string& devices) {
    const std::string beginning = "gpiochip";
    std::vector<std::pair<unsigned, std::string>> chips;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(devices, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        std::error_code ignored;
        if (!name.starts_with(beginning) || entry->is_symlink(ignored)) continue;  // a Pi 5 has gpiochip4 also as gpiochip0
        if (const auto number = number_of(name.substr(beginning.size()))) chips.emplace_back(*number, entry->path().string());
    }
    std::sort(chips.begin(), chips.end());
    std::vector<std::string> paths;
    for (const auto& [number, path] : chips) paths.push_back(path);
    return paths;
}

gpio::Chip open_chip(const std::string& path, const std::string& wanted, const std::string& devices) {
    try {
        return gpio::Chip(path);
    } catch (const std::system_error& error) {
        const int number = error.code().value();
        if (number == EACCES || number == EPERM) throw permission_denied("line '" + wanted + "'", path, "gpio");
        if (number != ENOENT) throw host::io_error("line '{}': {} cannot be opened: {}; expected a chip with lines.", wanted, path, error.code().message());
        const std::vector<std::string> chips = chips_of(devices);
        throw host::input_error("line '{}': there is no {}; {}.", wanted, path,
                                chips.empty() ? "this computer has no chip with lines" : "there is " + listed(chips));
    }
}

Place find_line(const std::string& wanted, const std::string& devices) {
    if (wanted.empty()) throw host::input_error("a line's name is empty; expected a name such as 'GPIO25', or a chip and an offset, such as 'gpiochip0:25'.");
    if (const auto place = chip_and_offset(wanted, devices)) return *place;
    if (const auto number = number_of(wanted)) return find_number(*number, devices);
    const Survey survey = survey_of(wanted, wanted, devices);
    if (const auto place = only(wanted, survey)) return *place;
    throw not_found(wanted, survey, devices);
}

}  // namespace shade16::linux_spi
