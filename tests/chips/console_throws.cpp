// In these tests a driver that gives up can be caught.
#include <runtime/console.hpp>

#include "tests/chips/chip.hpp"

namespace shade16::console {

void print(const char*) {}
void exit(int) { throw chips::Stopped("the program ended"); }
void fail(const char* sentence) { throw chips::Stopped(sentence); }

}  // namespace shade16::console
