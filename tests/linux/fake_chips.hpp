// The chips that the tests of lines find: a Pi's header and an expander, with devices in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include "tests/linux/fake_gpio.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::linux_spi {

class FakeChips : public testing::Test {
protected:
    FakeChips() {
        fake = {};
        FakeChip header{.label = "pinctrl-bcm2711"};
        for (int i = 0; i < 28; ++i) header.lines.push_back({.name = "GPIO" + std::to_string(i)});
        header.lines.push_back({});
        add("gpiochip0", header);
        add("gpiochip10", {.label = "expander", .lines = {{.name = "TWIN"}, {.name = "GPIO250"}, {.name = "TWIN"}}});
    }
    /// Every line and everything else of the library's is given back.
    ~FakeChips() override {
        EXPECT_EQ(fake.things, 0);
        for (const auto& [name, chip] : fake.chips)
            for (const FakeLine& line : chip.lines) EXPECT_EQ(line.requested, line.released) << name << " " << line.name;
    }
    FakeChips(const FakeChips&) = delete;
    FakeChips& operator=(const FakeChips&) = delete;

    void add(const std::string& name, const FakeChip& chip) {
        fake.chips[name] = chip;
        devices_.write(name, "");
    }
    std::string folder() const { return devices_.path("."); }
    std::string device(const std::string& name) const { return folder() + "/" + name; }
    FakeLine& line(unsigned offset) { return fake.chips.at("gpiochip0").lines.at(offset); }

    host::ScratchDirectory devices_{};
};

}  // namespace shade16::linux_spi
