// Remarks: what is worth saying about several materials, said once.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace shade16::host {

class Remarks {
public:
    void add(const std::string& what, const std::string& material) {
        const auto same =
            std::find_if(remarks_.begin(), remarks_.end(), [&](const auto& r) { return r.first == what; });
        if (same != remarks_.end()) {
            same->second.push_back(material);
        } else {
            remarks_.push_back({what, {material}});
        }
    }

    /// "Ns 0 is drawn as Ns 1 (materials wall, roof)."
    std::vector<std::string> sentences() const {
        std::vector<std::string> all;
        for (const auto& [what, names] : remarks_)
            all.push_back(
                fmt::format("{} (material{} {}).", what, names.size() == 1 ? "" : "s", fmt::join(names, ", ")));
        return all;
    }

private:
    std::vector<std::pair<std::string, std::vector<std::string>>> remarks_{};
};

}  // namespace shade16::host
