// What the models of chips have in common: drivers reach their registers through PortTo, and a display hangs on their serial bus.
#pragma once

#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/displays/dcs_model.hpp"

namespace shade16::chips {

/// What console::fail is here.
struct Stopped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The registers of the model that a test has at the moment.
template <class Chip>
struct PortTo {
    static inline Chip* chip = nullptr;
    static uint32_t read(uint32_t address) { return chip->read(address); }
    static void write(uint32_t address, uint32_t value) { chip->write(address, value); }
    static uint32_t address_of(const void* memory) { return chip->address_of(memory); }
};

/// A display on four wires. A byte takes time, and what the data/command line says counts at its last bit.
class Wires {
public:
    explicit Wires(displays::DcsModel& model) : model_(model) {}

    bool selected = false, data = false;
    void reset(bool high) { model_.reset_line(high); }
    void delay_ms(uint32_t ms) { model_.delay_ms(ms); }

    bool busy() const { return left_ != 0; }
    void begin(uint8_t byte) { byte_ = byte, left_ = accesses_a_byte; }
    /// Time goes on with every access to a register. True when a byte ends.
    bool tick() {
        if (left_ == 0 || --left_ != 0) return false;
        if (selected) data ? model_.data(byte_) : model_.command(byte_);
        return true;
    }

private:
    static constexpr int accesses_a_byte = 5;
    displays::DcsModel& model_;
    uint8_t byte_ = 0;
    int left_ = 0;
};

/// Something that a chip's programmer would curse about; the first thing is kept.
class Complaints {
public:
    const std::string& complaint() const { return complaint_; }
    void expect(bool is_so, const char* sentence) {
        if (!is_so && complaint_.empty()) complaint_ = sentence;
    }

private:
    std::string complaint_{};
};

}  // namespace shade16::chips
