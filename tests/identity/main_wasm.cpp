// In WebAssembly, where run_wasm.mjs prints.
#include <runtime/console.hpp>

#include "tests/identity/hashes.hpp"

extern "C" [[clang::import_module("console"), clang::import_name("print")]] void shade16_print(const char* text);

namespace shade16::console {

void print(const char* text) { shade16_print(text); }

}  // namespace shade16::console

extern "C" [[clang::export_name("say_hashes")]] void shade16_say_hashes() { shade16::identity::say_hashes(); }
