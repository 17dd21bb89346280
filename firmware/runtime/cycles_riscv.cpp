#include <runtime/allow_csr.hpp>
#include <runtime/cycles.hpp>

namespace shade16::cycles {

void begin() {}
uint32_t now() {
    uint32_t cycles;
    asm volatile(".option push\n" ALLOW_CSR "csrr %0, mcycle\n.option pop" : "=r"(cycles));
    return cycles;
}
uint32_t between(uint32_t from, uint32_t to) { return to - from; }
void spin(uint32_t turns) { asm volatile("1: addi %0, %0, -1\nbnez %0, 1b" : "+r"(turns)); }

}  // namespace shade16::cycles
