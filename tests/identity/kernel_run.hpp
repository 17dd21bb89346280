// Runs a kernel over many arguments and says a hash of its results, after the first thousand and then after ten times as many.
#pragma once

#include <runtime/console.hpp>

#include "tests/identity/digest.hpp"
#include "tests/identity/numbers.hpp"

namespace shade16::identity {

/// What a kernel costs: slow ones make a result bit by bit, or out of several other kernels.
enum class Pace : uint8_t { quick, slow };

/// How many arguments each kernel gets on this machine.
struct Inputs {
    uint32_t quick = 0, slow = 0;
    constexpr uint32_t of(Pace pace) const { return pace == Pace::quick ? quick : slow; }
};

/// `kernel` draws its arguments and returns what a Digest takes; every kernel begins with the same draws.
class KernelRun {
public:
    constexpr KernelRun(const char* group, Inputs inputs) : group_(group), inputs_(inputs) {}

    template <class Kernel>
    void operator()(const char* name, Kernel kernel, Pace pace = Pace::quick) const {
        Numbers numbers;
        Digest digest;
        uint32_t done = 0;
        for (uint32_t end = 1000; end <= inputs_.of(pace); end *= 10) {
            for (; done < end; ++done) digest.add(kernel(numbers));
            say(name, done, digest.value());
        }
    }

private:
    void say(const char* name, uint32_t inputs, uint32_t hash) const {
        console::print("kernel ");
        console::print(group_);
        console::print(".");
        console::print(name);
        console::print(" ");
        console::print_decimal(inputs);
        console::print(" ");
        console::print_hex(hash);
        console::print("\n");
    }

    const char* group_;
    Inputs inputs_;
};

}  // namespace shade16::identity
