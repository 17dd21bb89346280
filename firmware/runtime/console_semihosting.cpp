#include <runtime/console.hpp>
#include <runtime/semihosting.hpp>

namespace shade16::console {

void print(const char* text) { semihosting::write(text); }
void exit(int status) { semihosting::exit(status); }

}  // namespace shade16::console
