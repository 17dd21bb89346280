// Whatever bytes a panel's text has, it is read as a panel that a driver can use, or refused with a sentence.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "host_sim/screen/panel_file.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::displays {
namespace {

using Texts = std::map<std::string, std::string>;

Texts panel_texts() {
    Texts texts;
    for (const auto& entry : std::filesystem::directory_iterator(host::source_directory() / "boards/panels")) {
        std::ifstream file(entry.path(), std::ios::binary);
        texts[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return texts;
}

class Mutator {
public:
    Mutator(const Texts& texts, unsigned seed) : engine_(seed) {
        for (const auto& [name, text] : texts) words_.push_back(std::filesystem::path(name).stem().string());
        for (const char* word : {"command", "delay", "#:", "as", "glass", "memory", "offset", "0x36", "0x3A", "0x11", "0x00", "255", "256",
                                 "0xFFFFFFFFFF", "65535", "-1", "\n", "\r", "#", " ", "\t", "\xFF"})
            words_.emplace_back(word);
        words_.emplace_back(1, '\0');
    }
    std::size_t below(std::size_t end) { return end == 0 ? 0 : engine_() % end; }

    void mutate(std::string& text) {
        const std::size_t at = below(text.size() + 1), count = below(40);
        switch (below(6)) {
            case 0: text.erase(at, count); break;
            case 1: text.insert(at, words_[below(words_.size())]); break;
            case 2: text.insert(at, text.substr(below(text.size()), count)); break;
            case 3: text.replace(at, count, " " + words_[below(words_.size())] + " "); break;
            case 4:
                if (at < text.size()) text[at] = static_cast<char>(engine_());
                break;
            default: text.resize(text.size() - below(text.size() / 4 + 1)); break;
        }
    }

private:
    std::mt19937 engine_;
    std::vector<std::string> words_{};
};

/// Steps as run_commands does, and never past the end.
bool is_a_list(const std::vector<uint8_t>& list) {
    std::size_t at = 0;
    while (at + 2 <= list.size()) at += 2 + (list[at + 1] & (then_wait - 1u)) + (list[at + 1] >= then_wait ? 1 : 0);
    return at == list.size();
}

void expect_usable(const host::PanelFile& file) {
    const DcsPanel panel = file.panel();
    EXPECT_TRUE(is_a_list(file.beginning));
    EXPECT_TRUE(panel.width_px > 0 && panel.height_px > 0 && panel.first_column >= 0 && panel.first_row >= 0);
    EXPECT_LE(panel.first_column + panel.width_px, panel.memory_width_px);
    EXPECT_LE(panel.first_row + panel.height_px, panel.memory_height_px);
}

void expect_a_sentence(const std::string& sentence) {
    EXPECT_EQ(sentence.find("boards/panels/"), 0u) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    EXPECT_LT(sentence.size(), 300u) << sentence;
}

TEST(PanelMutations, AnyTextIsAPanelOrIsRefused) {
    const Texts texts = panel_texts();
    ASSERT_GE(texts.size(), 10u);
    Mutator mutator(texts, 16);
    int panels = 0, refusals = 0;
    for (int i = 0; i < 20000; ++i) {
        Texts changed = texts;
        const auto chosen = std::next(changed.begin(), static_cast<std::ptrdiff_t>(mutator.below(changed.size())));
        for (std::size_t count = 1 + mutator.below(4); count != 0; --count) mutator.mutate(chosen->second);
        if (i % 2 != 0) mutator.mutate(std::next(changed.begin(), static_cast<std::ptrdiff_t>(mutator.below(changed.size())))->second);
        const auto read = [&changed](const std::string& path) {
            const auto found = changed.find(std::filesystem::path(path).filename().string());
            if (found == changed.end()) throw host::input_error("{}: cannot be opened.", path);
            return found->second;
        };
        try {
            expect_usable(host::read_panel_text(chosen->second, "boards/panels/" + chosen->first, read));
            ++panels;
        } catch (const host::Error& refusal) {
            expect_a_sentence(refusal.what());
            ++refusals;
        }
        if (HasFailure()) FAIL() << "mutation " << i << ":\n" << chosen->second;
    }
    EXPECT_GT(panels, 2000);  // neither end is rare
    EXPECT_GT(refusals, 2000);
}

}  // namespace
}  // namespace shade16::displays
