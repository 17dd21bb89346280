// A C program's words, by the board's console.
#include "print.h"

#include <runtime/console.hpp>

extern "C" void print_text(const char* text) { shade16::console::print(text); }
