// Guarded: memory between two margins that nobody may write to. The sanitizer sees what goes beside an array; this sees what goes
// beside a band that is part of one, and also without a sanitizer.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

namespace shade16::fuzz {

template <class T>
class Guarded {
public:
    Guarded(std::size_t count, std::size_t margin) : size_(count), elements_(margin + count + margin), first_(elements_.data() + margin) {
        std::memset(static_cast<void*>(elements_.data()), pattern, elements_.size() * sizeof(T));
    }

    T* begin() { return first_; }
    std::size_t size() const { return size_; }

    bool is_whole() const { return holds_pattern(elements_.data(), first_) && holds_pattern(first_ + size_, elements_.data() + elements_.size()); }

private:
    static constexpr unsigned char pattern = 0xA5;

    static bool holds_pattern(const T* from, const T* to) {
        const auto *first = reinterpret_cast<const unsigned char*>(from), *last = reinterpret_cast<const unsigned char*>(to);
        return std::all_of(first, last, [](unsigned char byte) { return byte == pattern; });
    }

    std::size_t size_;
    std::vector<T> elements_;
    T* first_;
};

}  // namespace shade16::fuzz
