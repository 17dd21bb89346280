#include "boards/linux_spi/system_calls.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

namespace shade16::linux_spi {

namespace {

class Kernel final : public SystemCalls {
public:
    int open(const std::string& path) override {
        const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
        return file < 0 ? -errno : file;
    }
    void close(int file) override { ::close(file); }
    int ioctl(int file, unsigned long request, void* argument) override {
        const int result = ::ioctl(file, request, argument);
        return result < 0 ? -errno : result;
    }
    long write_at(int file, const void* bytes, std::size_t count, long at) override {
        const long result = ::pwrite(file, bytes, count, at);
        return result < 0 ? -errno : result;
    }
    void sleep_ms(uint32_t ms) override { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }
    std::optional<std::string> text_of(const std::string& path) override {
        std::ifstream file(path);
        if (!file) return std::nullopt;
        return std::string(std::istreambuf_iterator<char>(file), {});
    }
};

}  // namespace

SystemCalls& system_calls() {
    static Kernel kernel;
    return kernel;
}

}  // namespace shade16::linux_spi
