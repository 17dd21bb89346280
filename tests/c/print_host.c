#include "print.h"

#include <stdio.h>

void print_text(const char *text) { fputs(text, stdout); }
