/* What a test program in C says. */
#ifndef PRINT_H
#define PRINT_H

#ifdef __cplusplus
extern "C"
#endif
void print_text(const char *text);

#endif
