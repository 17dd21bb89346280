// Which rows of a frame are other than those of the frame before.
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
    /// The runs of rows to be sent, from the top; all of them at first. The frame is then the one before.
    std::vector<RowRun> of(const std::vector<uint8_t>& frame, int rows) {
        const std::size_t row_bytes = frame.size() / static_cast<std::size_t>(rows);
        std::vector<RowRun> runs;
        for (int y = 0; y < rows; ++y) {
            const std::size_t at = static_cast<std::size_t>(y) * row_bytes;
            if (before_.size() == frame.size() && std::memcmp(before_.data() + at, frame.data() + at, row_bytes) == 0) continue;
            if (runs.empty() || runs.back().first + runs.back().count != y) runs.push_back({y, 0});
            ++runs.back().count;
        }
        before_ = frame;
        return runs;
    }
    /// Everything is sent again.
    void forget() { before_.clear(); }

private:
    std::vector<uint8_t> before_{};
};

}  // namespace shade16::host
