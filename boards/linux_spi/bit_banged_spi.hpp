// SPI in mode 0 over lines that are set one by one, for boards without an SPI: data changes while the clock is low, and counts when it
// rises. The kernel is asked two or three times a bit, so this is slow, and as slow as it is it needs no waiting in between.
#pragma once

#include <optional>
#include <utility>

#include "boards/linux_spi/byte_sender.hpp"
#include "boards/linux_spi/output_line.hpp"

namespace shade16::linux_spi {

/// `Line` has set(bool). `select`, where the display has one, is low from the constructor to the destructor.
template <class Line = OutputLine>
class BitBangedSpi final : public ByteSender {
public:
    BitBangedSpi(Line clock, Line data, std::optional<Line> select = std::nullopt)
        : clock_(std::move(clock)), data_(std::move(data)), select_(std::move(select)) {
        clock_.set(false), data_.set(false);
        if (select_) select_->set(false);
    }
    BitBangedSpi(const BitBangedSpi&) = delete;
    BitBangedSpi& operator=(const BitBangedSpi&) = delete;
    ~BitBangedSpi() override {
        if (select_) try {
                select_->set(true);
            } catch (...) {  // its chip is gone: whoever sent last was told
            }
    }

    void send(const uint8_t* bytes, size_t count) override {
        for (size_t i = 0; i < count; ++i)
            for (int bit = 7; bit >= 0; --bit) send_bit((bytes[i] >> bit & 1) != 0);
    }

private:
    void send_bit(bool high) {
        if (high != data_high_) data_.set(high), data_high_ = high;
        clock_.set(true), clock_.set(false);
    }
    Line clock_, data_;
    std::optional<Line> select_;
    bool data_high_ = false;
};

}  // namespace shade16::linux_spi
