// Whatever puts bytes on a serial bus.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shade16::host {

class ByteSender {
public:
    ByteSender() = default;
    ByteSender(const ByteSender&) = delete;
    ByteSender& operator=(const ByteSender&) = delete;
    virtual ~ByteSender() = default;

    /// Returns when they are on the wire, or throws.
    virtual void send(const uint8_t* bytes, std::size_t count) = 0;
};

}  // namespace shade16::host
