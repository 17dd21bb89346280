// Which rows of a frame are other than those that a screen shows.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace shade16::host {

/// Rows [first, first + count).
struct RowRun {
    int first = 0, count = 0;
    friend bool operator==(const RowRun&, const RowRun&) = default;
};

class ChangedRows {
public:
    /// The runs of rows to be sent, from the top; all of them until something is shown.
    std::vector<RowRun> of(const std::vector<uint8_t>& frame, int rows) const {
        const std::size_t row_bytes = frame.size() / static_cast<std::size_t>(rows);
        std::vector<RowRun> runs;
        for (int y = 0; y < rows; ++y) {
            const std::size_t at = static_cast<std::size_t>(y) * row_bytes;
            if (shown_.size() == frame.size() && std::memcmp(shown_.data() + at, frame.data() + at, row_bytes) == 0) continue;
            if (runs.empty() || runs.back().first + runs.back().count != y) runs.push_back({y, 0});
            ++runs.back().count;
        }
        return runs;
    }
    /// The frame has arrived, whole.
    void are_sent(const std::vector<uint8_t>& frame) { shown_ = frame; }

private:
    std::vector<uint8_t> shown_{};
};

}  // namespace shade16::host
