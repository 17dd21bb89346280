// Output that is there completely or not at all: a file grows under a temporary name and gets its own at the end.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace shade16::host {

/// The reader of our output went away (`shade16 render -o - | head`): no error, just the end of the work.
struct ClosedPipe : std::exception {
    const char* what() const noexcept override { return "the reader of the output has closed it"; }
};

class OutputStream {
public:
    OutputStream() = default;
    OutputStream(const OutputStream&) = delete;
    OutputStream& operator=(const OutputStream&) = delete;
    virtual ~OutputStream() = default;

    virtual void write(std::span<const uint8_t> bytes) = 0;
    void write(std::string_view text);

    /// All is written: from here on the output counts. Without it a file vanishes.
    virtual void commit() = 0;
};

/// A file that appears under its name at commit(); until then it is `name.tmp-XXXXXX` in the same directory.
class AtomicFile final : public OutputStream {
public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile() override;

    using OutputStream::write;
    void write(std::span<const uint8_t> bytes) override;
    void commit() override;

private:
    void discard() noexcept;

    std::string path_, temporary_;
    int descriptor_ = -1;
    int slot_ = -1;
};

/// Bytes that cannot be taken back: standard output, a named pipe, a device.
class DirectStream final : public OutputStream {
public:
    explicit DirectStream(const std::string& path);  // "-" is standard output
    ~DirectStream() override;

    using OutputStream::write;
    void write(std::span<const uint8_t> bytes) override;
    void commit() override {}

private:
    std::string name_;
    int descriptor_;
};

bool is_standard_output(std::string_view path);

/// The right stream for a path: standard output for `-`, direct for pipes and devices, else an AtomicFile.
std::unique_ptr<OutputStream> open_output(const std::string& path);

/// A whole file in one call.
void write_file(const std::string& path, std::string_view text);

/// Unlinks every file that is not committed yet. Async-signal-safe: for the handler of SIGINT.
void remove_unfinished_files() noexcept;

}  // namespace shade16::host
