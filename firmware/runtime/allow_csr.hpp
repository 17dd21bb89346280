// GCC's assembler takes instructions for control registers only where it is told to; Clang's of version 14 takes them, and not the telling.
#pragma once

#ifdef __clang__
#define ALLOW_CSR
#else
#define ALLOW_CSR ".option arch, +zicsr\n"
#endif
