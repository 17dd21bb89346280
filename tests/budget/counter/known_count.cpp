// An image whose counts are known by counting its lines. Up to and with the call of frame_end() the first frame has
// 6 + 2 * 100 + 3 instructions in main() and 3 * 3 in helper(), and its deepest store is 4096 bytes below the end of
// the stack. The second frame, which nobody may count, stores deeper. What runs here also runs on a Cortex-M0.
extern "C" {

__attribute__((naked, used)) void frame_begin() { asm("nop\n bx lr"); }
__attribute__((naked, used)) void frame_end() { asm("bx lr"); }
__attribute__((naked, used)) void helper() { asm("nop\n nop\n bx lr"); }

__attribute__((naked, used)) int main() {
    asm(".syntax unified\n"
        "push {r4, lr}\n"
        "bl frame_begin\n"

        "ldr r0, =shade16_stack_end\n"  // 6
        "ldr r1, =4096\n"
        "subs r0, r0, r1\n"
        "str r1, [r0]\n"
        "movs r4, #100\n"
        "bl helper\n"
        "1: subs r4, #1\n"  // 2 * 100
        "bne 1b\n"
        "bl helper\n"  // 3
        "bl helper\n"
        "bl frame_end\n"

        "bl frame_begin\n"
        "subs r0, #64\n"
        "str r1, [r0]\n"
        "bl helper\n"
        "bl frame_end\n"
        "movs r0, #0\n"
        "pop {r4, pc}\n"
        ".ltorg\n");
}
}
