// How deep a TOML text is by its dotted names. The parser bounds nested values, but a name such as a.a.a has a table for each part,
// and a hundred thousand of them are more than the stack holds when they are released one inside the other.
#pragma once

#include <algorithm>
#include <string_view>

namespace shade16::host {

/// Goes through a TOML text, whose strings and comments may hold any dots, until a name has more than so many parts.
class LongNames {
public:
    LongNames(std::string_view text, int most_parts) : rest_(text), most_parts_(most_parts) {}

    /// Of the first such name; 0 if there is none.
    int line() {
        int parts = 1;
        bool after_part = false;
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '"' || c == '\'') {
                skip_string(c);
                after_part = true;
            } else if (c == '#') {
                skip(rest_.find('\n'));
            } else {
                skip(1);
                if (c == ' ' || c == '\t') continue;
                if (c == '.' && after_part) ++parts;
                else if (!is_bare(c)) parts = 1;
                after_part = is_bare(c);
            }
            if (parts > most_parts_) return line_;
        }
        return 0;
    }

private:
    static bool is_bare(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '-'; }

    void skip(std::size_t count) {
        count = std::min(count, rest_.size());
        line_ += static_cast<int>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
        rest_.remove_prefix(count);
    }
    /// One that does not end is the parser's to refuse.
    void skip_string(char quote) {
        const std::string_view three = quote == '"' ? R"(""")" : "'''";
        const std::string_view end = rest_.starts_with(three) ? three : three.substr(0, 1);
        skip(end.size());
        while (!rest_.empty() && !rest_.starts_with(end)) skip(quote == '"' && rest_.front() == '\\' ? 2 : 1);
        skip(end.size());
        // Up to two quotes may stand before the closing three.
        for (int i = 0; end.size() == 3 && i < 2 && rest_.starts_with(quote); ++i) skip(1);
    }

    std::string_view rest_;
    int most_parts_, line_ = 1;
};

}  // namespace shade16::host
