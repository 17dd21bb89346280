#include "host_sim/model/obj_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "host_sim/error.hpp"
#include "host_sim/model/text_lines.hpp"

namespace shade16::host {

namespace {

constexpr char blank_stand_in = '\x1f';       // ASCII's unit separator: in no name that a person gave
constexpr double largest_coordinate = 16384;  // the core's domain
constexpr std::size_t most_corners = 255;     // tinyobjloader counts them in a byte

struct Counts {
    long v = 0, vn = 0, vt = 0;
    long& of(std::string_view keyword) { return keyword == "v" ? v : keyword == "vn" ? vn : vt; }
};

bool is_attribute(std::string_view keyword) { return keyword == "v" || keyword == "vn" || keyword == "vt"; }

class Checker {
public:
    explicit Checker(const std::string& path) : path_(path) {}

    ObjText check(std::string_view text) {
        const std::vector<TextLine> lines = lines_of(text);
        for (const TextLine& line : lines)
            if (const auto words = words_of(line.text); !words.empty() && is_attribute(words[0])) ++total_.of(words[0]);
        for (const TextLine& line : lines) check_line(line);
        return std::move(result_);
    }

private:
    void check_line(const TextLine& line) {
        const auto words = words_of(line.text);
        if (words.empty() || words[0].starts_with('#')) return;
        number_ = line.number;
        if (is_attribute(words[0])) {
            if (words[0] == "v") check_vertex(words);
            ++so_far_.of(words[0]);
            pass_on(words.size() > 1 ? words : with_zero(words));
        } else if (words[0] == "f") {
            check_face(words);
        } else if (words[0] == "s") {
            smooth(words.size() > 1 ? words[1] : "off");
        } else if (words[0] == "usemtl") {
            use_material(after_first_word(line.text));
        } else if (words[0] == "mtllib") {
            result_.libraries.emplace_back(after_first_word(line.text));
        } else if (words[0] == "l" || words[0] == "p" || words[0] == "curv" || words[0] == "curv2" ||
                   words[0] == "surf") {
            ++result_.not_faces;
        }
    }

    /// A group's number; 'off' is group 0.
    void smooth(std::string_view group) {
        unsigned number = group == "on" ? 1 : 0;
        std::from_chars(group.data(), group.data() + group.size(), number);
        result_.has_smoothing = true;
        pass_on({"s", std::to_string(number)});
    }

    /// Rewritten with single blanks, so that tinyobjloader cannot split a line otherwise than it was checked.
    void pass_on(const std::vector<std::string_view>& words) {
        for (const std::string_view word : words) result_.lines.append(word).append(" ");
        result_.lines.back() = '\n';
    }

    /// tinyobjloader takes a bare 'vn' or 'vt' for nothing at all, and it would then count fewer than were counted here.
    static std::vector<std::string_view> with_zero(std::vector<std::string_view> words) {
        words.emplace_back("0");
        return words;
    }

    void use_material(std::string_view name) {
        if (std::find(result_.materials.begin(), result_.materials.end(), name) == result_.materials.end())
            result_.materials.emplace_back(name);
        pass_on({"usemtl", joined_name(name)});
    }

    void check_vertex(const std::vector<std::string_view>& words) const {
        if (words.size() < 4)
            throw input_error("{}, line {}: a vertex has {} coordinates; expected three.", path_, number_,
                              words.size() - 1);
        for (std::size_t i = 1; i <= 3; ++i) check_coordinate(words[i]);
    }

    void check_coordinate(std::string_view word) const {
        const std::string_view digits = word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool is_number =
            end == digits.data() + digits.size() && !std::isnan(value) && error != std::errc::invalid_argument;
        if (!is_number)
            throw input_error("{}, line {}: the coordinate '{}' is not a number; expected one such as -1.5.", path_,
                              number_, word);
        if (error != std::errc{} || std::fabs(value) > largest_coordinate)
            throw input_error(
                "{}, line {}: the coordinate '{}' is out of range; expected -16384 to 16384. Scale the model down.",
                path_, number_, word);
    }

    void check_face(std::vector<std::string_view> words) {
        const std::size_t corners = words.size() - 1;
        if (corners > most_corners)
            throw input_error("{}, line {}: a face has {} corners; expected at most {}. Triangulate the model.", path_,
                              number_, corners, most_corners);
        for (std::size_t i = 1; i < words.size(); ++i) {
            words[i] = words[i].substr(0, words[i].find_last_not_of('/') + 1);  // 7// is 7
            check_corner(words[i]);
        }
        if (corners < 3) {
            ++result_.short_faces;
        } else {
            ++result_.faces;
            pass_on(words);
        }
    }

    /// v, v/vt, v//vn or v/vt/vn.
    void check_corner(std::string_view corner) const {
        const std::size_t first = corner.find('/');
        const std::size_t second = first == corner.npos ? first : corner.find('/', first + 1);
        const auto field = [&](std::size_t slash, std::size_t end) {
            return slash == corner.npos ? std::string_view{}
                                        : corner.substr(slash + 1, end == corner.npos ? end : end - slash - 1);
        };
        check_index(corner.substr(0, first), corner, "vertex", so_far_.v, total_.v);
        if (const auto vt = field(first, second); !vt.empty())
            check_index(vt, corner, "texture coordinate", so_far_.vt, total_.vt);
        if (const auto vn = field(second, corner.npos); !vn.empty())
            check_index(vn, corner, "normal", so_far_.vn, total_.vn);
    }

    /// Positive: from 1, also to what the file defines only later. Negative: backwards from here.
    void check_index(std::string_view word, std::string_view corner, const char* what, long so_far, long total) const {
        long index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (end != word.data() + word.size() || error == std::errc::invalid_argument)
            throw input_error(
                "{}, line {}: '{}' is no corner of a face; expected a form such as 7, 7/2, 7//3 or 7/2/3.", path_,
                number_, corner);
        if (error == std::errc{} && ((0 < index && index <= total) || (index < 0 && -so_far <= index))) return;
        if (index < 0)
            throw input_error("{}, line {}: a face refers to {} {}; expected -1 to -{}, as {} precede it.", path_,
                              number_, what, word, so_far, so_far);
        throw input_error("{}, line {}: a face refers to {} {}; expected 1 to {}, as the file has {}.", path_, number_,
                          what, word, total, total);
    }

    const std::string& path_;
    Counts total_{}, so_far_{};
    std::size_t number_ = 0;
    ObjText result_{};
};

}  // namespace

ObjText check_obj_text(const std::string& path, std::string text) { return Checker(path).check(text); }

std::string joined_name(std::string_view name) {
    std::string joined;
    for (const std::string_view word : words_of(name))
        joined.append(joined.empty() ? "" : std::string(1, blank_stand_in)).append(word);
    return joined.empty() ? std::string(1, blank_stand_in) : joined;  // Blender writes materials without a name
}

std::string spaced_name(std::string_view name) {
    std::string spaced(name);
    std::replace(spaced.begin(), spaced.end(), blank_stand_in, ' ');
    return spaced;
}

}  // namespace shade16::host
