// C++ names made of whatever a file calls its parts.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace shade16::host {

/// `text` with everything but letters, digits and single underscores replaced; never empty, reserved or a keyword.
std::string identifier(std::string_view text);

/// Names that are each given once: a second `wall` becomes `wall_2`.
class UniqueNames {
public:
    /// A stem such that `stem + suffix` is free for every suffix; they are all taken then.
    template <class Suffixes>
    std::string claim(const std::string& wish, const Suffixes& suffixes) {
        for (int attempt = 1;; ++attempt) {
            const std::string stem = attempt == 1 ? wish : wish + "_" + std::to_string(attempt);
            bool free = true;
            for (const auto& suffix : suffixes) free = free && !taken_.contains(stem + suffix);
            if (!free) continue;
            for (const auto& suffix : suffixes) taken_.insert(stem + suffix);
            return stem;
        }
    }

private:
    std::set<std::string> taken_{};
};

}  // namespace shade16::host
