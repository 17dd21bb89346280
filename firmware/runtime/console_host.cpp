#include <cstdio>
#include <cstdlib>
#include <runtime/console.hpp>

namespace shade16::console {

void print(const char* text) { std::fputs(text, stdout); }
void exit(int status) { std::exit(status); }

}  // namespace shade16::console
