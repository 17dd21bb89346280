// MapTexts: the pictures of a header's materials, each written once however many materials show it.
#pragma once

#include <map>
#include <type_traits>

#include <fmt/format.h>

#include "host_sim/model/header_text.hpp"
#include "host_sim/model/identifier.hpp"

namespace shade16::host {

class MapTexts {
public:
    explicit MapTexts(UniqueNames& names) : names_(names) {}

    /// The names of these pictures. What is not written yet is added to `text`.
    MapNames names_of(const MaterialMaps& maps, std::string& text) {
        MapNames result;
        if (maps.texture) result.texture = name_of(*maps.texture, texture_suffixes, text, texture_text);
        if (maps.bump) result.bump = name_of(*maps.bump, relief_suffixes, text, relief_text);
        return result;
    }

private:
    inline static const std::string texture_suffixes[] = {"", "_texels"};
    inline static const std::string relief_suffixes[] = {"", "_slopes"};

    static std::string key_of(const TextureFile& file) { return file.path; }
    static std::string key_of(const ReliefFile& file) { return fmt::format("{}*{}*{}", file.path, file.strength, static_cast<int>(file.kind)); }

    template <class File, std::size_t N>
    std::string name_of(const File& file, const std::string (&suffixes)[N], std::string& text, std::string (*write)(const File&, const std::string&)) {
        constexpr const char* kind = std::is_same_v<File, TextureFile> ? "_texture" : "_relief";
        const auto [entry, is_new] = known_.try_emplace(key_of(file) + kind);
        if (is_new) {
            entry->second = names_.claim(identifier(file.name + kind), suffixes);
            text += write(file, entry->second);
        }
        return entry->second;
    }

    UniqueNames& names_;
    std::map<std::string, std::string> known_{};
};

}  // namespace shade16::host
