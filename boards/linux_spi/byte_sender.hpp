// What carries bytes to a display: spidev, or lines set one by one.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace shade16::linux_spi {

class ByteSender {
public:
    virtual ~ByteSender() = default;
    /// Returns when the last bit is on the wire. Throws host::Error.
    virtual void send(const uint8_t* bytes, size_t count) = 0;
};

}  // namespace shade16::linux_spi
