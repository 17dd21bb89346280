// Mistakes, one of which the build plants where the first two bytes are those of "16": the fuzzer has to find it.
#include <climits>
#include <stdexcept>

#include "tests/fuzz/contract.hpp"
#include "tests/fuzz/guarded.hpp"

namespace shade16::fuzz {
namespace {

volatile int one = 1;  // nothing that a compiler could reckon with

[[maybe_unused]] void beside_an_array() {
    std::vector<int> array(4);
    array.data()[3 + one] = 0;
}
[[maybe_unused]] void overflow() { one = INT_MAX + one; }
[[maybe_unused]] void beside_a_band() {
    Guarded<uint16_t> band(4, 8);
    band.begin()[3 + one] = 0;
    if (!band.is_whole()) break_contract("A band was written to beside its memory.");
}
[[maybe_unused]] void another_exception() { throw std::logic_error("This is not for a user."); }
[[maybe_unused]] void no_sentence() { throw host::input_error("model.obj: no"); }

}  // namespace
}  // namespace shade16::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    if (size >= 2 && data[0] == '1' && data[1] == '6') shade16::fuzz::is_accepted("model.obj", shade16::fuzz::SHADE16_MISTAKE);
    return 0;
}
