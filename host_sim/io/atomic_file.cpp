#include "host_sim/io/atomic_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

// The names of unfinished files, where a signal handler can read them: fixed storage, no allocation, no lock.
struct Unfinished {
    std::atomic<bool> taken{false}, named{false};
    std::array<char, PATH_MAX> name{};
};
static_assert(std::atomic<bool>::is_always_lock_free, "remove_unfinished_files is called by signal handlers");
std::array<Unfinished, 16> unfinished;

int remember(const std::string& name) {
    for (std::size_t i = 0; i < unfinished.size(); ++i) {
        if (unfinished[i].taken.exchange(true)) continue;
        if (name.size() >= unfinished[i].name.size()) break;
        std::memcpy(unfinished[i].name.data(), name.c_str(), name.size() + 1);
        unfinished[i].named = true;
        return static_cast<int>(i);
    }
    return -1;  // only the destructor will remove this one
}

void forget(int slot) noexcept {
    if (slot < 0) return;
    Unfinished& entry = unfinished[static_cast<std::size_t>(slot)];
    entry.named = false;
    entry.taken = false;
}

/// Holds signals back between the creation of a file and its entry in the table.
class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_{};
};

const char* reason() { return std::strerror(errno); }

void write_all(int descriptor, std::span<const uint8_t> bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            throw ClosedPipe{};
        } else if (errno != EINTR) {
            throw io_error("{}: cannot be written: {}.", name, reason());
        }
    }
}

/// mkstemp makes private files; an output is as public as the user's umask says.
void apply_umask(int descriptor) {
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
}

}  // namespace

void OutputStream::write(std::string_view text) { write({reinterpret_cast<const uint8_t*>(text.data()), text.size()}); }

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw io_error("{}: is a directory; expected the name of a file.", path);
    // A rename would replace a symbolic link; its owner wants the file behind it replaced.
    if (std::filesystem::is_symlink(path, ignored)) path_ = std::filesystem::weakly_canonical(path, ignored).string();

    temporary_ = path_ + ".tmp-XXXXXX";
    const SignalsHeld held;
    descriptor_ = mkstemp(temporary_.data());
    if (descriptor_ < 0) throw io_error("{}: cannot be created: {}.", path, reason());
    slot_ = remember(temporary_);
    apply_umask(descriptor_);
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() noexcept {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = -1;
    if (!temporary_.empty()) unlink(temporary_.c_str());
    temporary_.clear();
    forget(slot_);
    slot_ = -1;
}

void AtomicFile::write(std::span<const uint8_t> bytes) { write_all(descriptor_, bytes, path_); }

void AtomicFile::commit() {
    if (descriptor_ < 0) return;
    const int descriptor = descriptor_;
    descriptor_ = -1;
    // Some file systems report a full disk only here.
    if (close(descriptor) != 0) throw io_error("{}: cannot be written: {}.", path_, reason());
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0)
        throw io_error("{}: cannot be created: {}.", path_, reason());
    temporary_.clear();
    discard();
}

DirectStream::DirectStream(const std::string& path)
    : name_(is_standard_output(path) ? "standard output" : path),
      descriptor_(is_standard_output(path) ? dup(STDOUT_FILENO) : open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw io_error("{}: cannot be opened for writing: {}.", name_, reason());
    std::signal(SIGPIPE, SIG_IGN);  // a closed reader shall be a ClosedPipe, not a sudden death
}

DirectStream::~DirectStream() { close(descriptor_); }

void DirectStream::write(std::span<const uint8_t> bytes) { write_all(descriptor_, bytes, name_); }

bool is_standard_output(std::string_view path) { return path == "-" || path == "/dev/stdout"; }

std::unique_ptr<OutputStream> open_output(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::file_type type = fs::status(path, ignored).type();
    const bool is_device =
        type == fs::file_type::fifo || type == fs::file_type::character || type == fs::file_type::socket;
    if (is_standard_output(path) || is_device) return std::make_unique<DirectStream>(path);
    return std::make_unique<AtomicFile>(path);
}

void write_file(const std::string& path, std::string_view text) {
    const auto stream = open_output(path);
    stream->write(text);
    stream->commit();
}

void remove_unfinished_files() noexcept {
    const int before = errno;
    for (const Unfinished& entry : unfinished)
        if (entry.named) unlink(entry.name.data());
    errno = before;
}

}  // namespace shade16::host
