// Chips and lines that exist in memory alone, behind the stubs of libgpiod 1 and 2: they count what is taken and given back, and fail
// when told.
#pragma once

#include <cerrno>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace shade16::linux_spi {

struct FakeLine {
    std::string name{}, consumer{};  // the consumer of whoever holds it
    bool used = false, value = false, active_low = false;
    int requested = 0, released = 0;
};

struct FakeChip {
    std::string label{};
    std::vector<FakeLine> lines{};
    int open_error = 0, request_error = 0;
    bool gone = false;
    int removals = 0;  // who holds something from before one has it no longer, even when the chip is back
};

struct FakeGpio {
    std::map<std::string, FakeChip> chips{};  // by the name of the device
    int things = 0;                           // of the library's that the program still has
    int step = 0, fail_at = 0, fail_with = 0;
    std::function<void(const FakeLine&)> changed{};  // told of each value that is set

    /// Every call that may fail takes a step; the one at `fail_at` fails.
    bool fails() {
        if (++step != fail_at) return false;
        errno = fail_with;
        return true;
    }
    FakeChip* open(const std::string& path) {
        const auto chip = chips.find(path.substr(path.rfind('/') + 1));
        if (chip == chips.end() || chip->second.open_error != 0) {
            errno = chip == chips.end() ? ENOENT : chip->second.open_error;
            return nullptr;
        }
        return fails() ? nullptr : &chip->second;
    }
    /// 0, or -1 and errno.
    int request(FakeChip& chip, unsigned offset, const std::string& consumer, bool active_low, bool value) {
        FakeLine& line = chip.lines.at(offset);
        errno = chip.gone ? ENODEV : line.used ? EBUSY : chip.request_error;
        if (errno != 0 || fails()) return -1;
        line.used = true, line.consumer = consumer, line.active_low = active_low, line.value = value, ++line.requested;
        tell(line);
        return 0;
    }
    static void release(FakeLine& line) { line.used = false, line.consumer.clear(), ++line.released; }
    /// `removals` as they were when the line was taken.
    int set(FakeChip& chip, unsigned offset, bool value, int removals) {
        errno = chip.gone || chip.removals != removals ? ENODEV : chip.lines.at(offset).requested == chip.lines.at(offset).released ? EPERM : 0;
        if (errno != 0 || fails()) return -1;
        chip.lines.at(offset).value = value;
        tell(chip.lines.at(offset));
        return 0;
    }
    void tell(const FakeLine& line) const {
        if (changed) changed(line);
    }
};

inline FakeGpio fake;

}  // namespace shade16::linux_spi
