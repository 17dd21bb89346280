// What an app says, in the same words on every board and on this computer, so that the two can be compared.
#pragma once

#include <stdint.h>

namespace shade16::console {

void print(const char* text);
bool is_told(const char* word);    // whether whoever runs the program told it this word
void print_hex(uint32_t value);      // eight digits, no prefix
void print_decimal(uint32_t value);  // no padding
[[noreturn]] void exit(int status);  // what returning from main() does; any status but 0 is a failure
[[noreturn]] void fail(const char* sentence);  // prints it and ends with status 1

}  // namespace shade16::console
