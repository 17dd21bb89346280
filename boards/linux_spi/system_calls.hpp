// The system calls of a device file, and time that passes, so that a test can be the kernel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace shade16::linux_spi {

/// Each returns what the system's does, with errno as a negative number in place of -1.
class SystemCalls {
public:
    SystemCalls() = default;
    SystemCalls(const SystemCalls&) = delete;
    SystemCalls& operator=(const SystemCalls&) = delete;
    virtual ~SystemCalls() = default;

    virtual int open(const std::string& path) = 0;  // to read and write
    virtual void close(int file) = 0;
    virtual int ioctl(int file, unsigned long request, void* argument) = 0;
    /// How many bytes were written, maybe fewer than were to be.
    virtual long write_at(int file, const void* bytes, std::size_t count, long at) = 0;
    virtual void sleep_ms(uint32_t ms) = 0;
    /// A small text file of the system's, or nothing.
    virtual std::optional<std::string> text_of(const std::string& path) = 0;
};

/// This computer's.
SystemCalls& system_calls();

}  // namespace shade16::linux_spi
