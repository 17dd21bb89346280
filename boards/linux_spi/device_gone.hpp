// A device that was there and is no more. It may come back.
#pragma once

#include "host_sim/error.hpp"

namespace shade16::linux_spi {

struct DeviceGone : host::Error {
    explicit DeviceGone(const host::Error& error) : host::Error(error) {}
};

}  // namespace shade16::linux_spi
