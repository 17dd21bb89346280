#include "host_sim/model/identifier.hpp"

#include <algorithm>
#include <iterator>

namespace shade16::host {

namespace {

// `linux` and `unix` are macros where GNU extensions are on; a namespace `shade16` in another one would hide the
// engine's.
// clang-format off
constexpr std::string_view keywords[] = {
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch",
    "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "decltype", "default", "delete", "do",
    "double", "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend",
    "goto", "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr",
    "operator", "or", "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires",
    "return", "short", "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template",
    "this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using",
    "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq", "linux", "unix",
    "shade16"};
// clang-format on

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

std::string identifier(std::string_view text) {
    std::string name;
    for (const char c : text) {
        if (is_letter(c) || is_digit(c)) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    while (name.ends_with('_')) name.pop_back();
    if (name.empty()) return "mesh";
    if (is_digit(name.front())) name.insert(0, "mesh_");
    if (std::find(std::begin(keywords), std::end(keywords), name) != std::end(keywords)) name += '_';
    return name;
}

}  // namespace shade16::host
