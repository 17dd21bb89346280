// Semihosting: the program asks the debugger, or the emulator, to print for it and to end it.
// Source: "Semihosting for AArch32 and AArch64", Arm; "RISC-V Semihosting", RISC-V International.
#pragma once

namespace shade16::semihosting {

void write(const char* text);
bool is_told(const char* word);  // whether the debugger passes it as the program's first argument
[[noreturn]] void exit(int status);

}  // namespace shade16::semihosting
