// Marks around the drawing of a frame: two functions that do nothing. A tool that counts instructions finds them by
// name and counts what is between them.
#pragma once

extern "C" {
__attribute__((noinline, used)) inline void frame_begin() { asm volatile("" ::: "memory"); }
__attribute__((noinline, used)) inline void frame_end() { asm volatile("" ::: "memory"); }
}
