/* The functions of libgpiod 1's C API that boards/linux_spi calls, with their signatures. Source: gpiod.h 1.6.3. */
#pragma once

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct gpiod_chip;
struct gpiod_line;

enum { GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW = 1 << 2 };

struct gpiod_chip* gpiod_chip_open(const char* path);
void gpiod_chip_close(struct gpiod_chip* chip);
const char* gpiod_chip_label(struct gpiod_chip* chip);
unsigned int gpiod_chip_num_lines(struct gpiod_chip* chip);
struct gpiod_line* gpiod_chip_get_line(struct gpiod_chip* chip, unsigned int offset);

const char* gpiod_line_name(struct gpiod_line* line);
const char* gpiod_line_consumer(struct gpiod_line* line);
bool gpiod_line_is_used(struct gpiod_line* line);
int gpiod_line_request_output_flags(struct gpiod_line* line, const char* consumer, int flags, int default_val);
int gpiod_line_set_value(struct gpiod_line* line, int value);
void gpiod_line_release(struct gpiod_line* line);

#ifdef __cplusplus
}
#endif
