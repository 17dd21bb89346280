// Breaks, on purpose, the rules that forbidden_symbols.cmake keeps.
#include <stddef.h>
#include <stdint.h>

extern "C" {
void* __dso_handle = nullptr;
#if defined(__arm__) && !defined(__clang__)  // Clang calls the other
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
#else
__attribute__((noinline)) int __cxa_atexit(void (*)(void*), void*, void*) {
    asm volatile("");
    return 0;
}
#endif
void* malloc(size_t) { return nullptr; }
#if defined(__xtensa__)  // whose compiler library leaves these to a ROM
float __addsf3(float a, float) { return a; }
int64_t __divdi3(int64_t a, int64_t) { return a; }
#endif
}

namespace {

// Volatile, so that the compiler cannot work the answers out beforehand.
volatile float fraction = 0.5f;
volatile int64_t large = int64_t{1} << 40;
void* (*volatile allocate)(size_t) = malloc;

struct WithDestructor {  // as a global, it is registered to be destroyed at exit
    ~WithDestructor() { large = 0; }
} global;

}  // namespace

int main() {
    fraction = fraction + 1.5f;
    large = large / (large >> 20);
#if defined(__xtensa__)  // whose compiler makes a list of destructors instead
    __cxa_atexit(nullptr, nullptr, nullptr);
#endif
    return allocate(4) == nullptr ? 0 : 1;
}
