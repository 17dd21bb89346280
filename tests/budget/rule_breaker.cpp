// Breaks, on purpose, the rules that forbidden_symbols.cmake keeps.
#include <stddef.h>
#include <stdint.h>

extern "C" {
void* __dso_handle = nullptr;
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
void* malloc(size_t) { return nullptr; }
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
    return allocate(4) == nullptr ? 0 : 1;
}
