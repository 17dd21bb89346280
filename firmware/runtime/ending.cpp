#include <runtime/console.hpp>
#include <runtime/ending.hpp>
#include <runtime/stack.hpp>

namespace shade16 {

namespace {

constexpr const char* stack_sentence = "The stack has run over the variables.";

void print_stack_use() {
    console::print("stack ");
    console::print_decimal(stack_bytes_used());
    console::print(" of ");
    console::print_decimal(stack_bytes());
    console::print(" bytes\n");
}

}  // namespace

void end_program(int status) {
    if (is_stack_full()) console::fail(stack_sentence);
    if (console::is_told("stack")) print_stack_use();
    if (status != 0) {
        console::print("The program ended with status ");
        console::print_decimal(static_cast<uint32_t>(status));
        console::print(".\n");
    }
    console::exit(status);
}

void end_by_fault(uint32_t address, uint32_t number, const uint32_t* stack) {
    if (stack < shade16_bss_end || is_stack_full()) console::fail(stack_sentence);
    console::print("The processor stopped at address 0x");
    console::print_hex(address);
    console::print(" with exception ");
    console::print_decimal(number);
    console::fail(".");
}

}  // namespace shade16
