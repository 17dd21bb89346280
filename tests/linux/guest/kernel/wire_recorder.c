// GPIO lines that remember: a chip of outputs, and /dev/wire_recorder, which gives every change of a level once and in order. gpio-sim
// tells what a line is now, but a driver in the kernel sets thousands of bits between two looks of a program.
// Source: the kernel's Documentation/driver-api/gpio/driver.rst, include/linux/kfifo.h and include/linux/miscdevice.h.
#include <linux/gpio/driver.h>
#include <linux/kfifo.h>
#include <linux/ktime.h>
#include <linux/miscdevice.h>
#include <linux/module.h>
#include <linux/spinlock.h>
#include <linux/vmalloc.h>

#include "wire_record.h"

enum { most_bytes = 8 << 20 };  // between two reads: a million changes, about two frames of a small panel

static DEFINE_SPINLOCK(lock);  // of all that follows, but for the end of the queue that is read
static DECLARE_KFIFO_PTR(changes, struct wire_change);
static void *memory;  // of the queue: more than kfifo_alloc would give
static u32 levels;
static bool is_open, lost_some;

static void record_levels(void)
{
    const struct wire_change change = {.at_us = (u32)ktime_to_us(ktime_get()), .levels = levels};

    if (!kfifo_put(&changes, change))
        lost_some = true;
}

static void set_line(struct gpio_chip *chip, unsigned int line, int high)
{
    unsigned long flags;

    spin_lock_irqsave(&lock, flags);
    if (!!(levels & BIT(line)) != !!high) {
        levels ^= BIT(line);
        if (is_open)
            record_levels();
    }
    spin_unlock_irqrestore(&lock, flags);
}

static int get_line(struct gpio_chip *chip, unsigned int line)
{
    return !!(READ_ONCE(levels) & BIT(line));
}

static int make_output(struct gpio_chip *chip, unsigned int line, int high)
{
    set_line(chip, line, high);
    return 0;
}

static int direction_of(struct gpio_chip *chip, unsigned int line)
{
    return GPIO_LINE_DIRECTION_OUT;
}

static const char *const names[wire_count] = {
    [wire_clock] = "panel-clock",     [wire_data] = "panel-data",   [wire_select] = "panel-select",
    [wire_command] = "panel-command", [wire_reset] = "panel-reset", [wire_light] = "panel-light",
};

static struct gpio_chip chip = {
    .label = "wire_recorder",
    .owner = THIS_MODULE,
    .base = -1,
    .ngpio = wire_count,
    .names = names,
    .get = get_line,
    .set = set_line,
    .get_direction = direction_of,
    .direction_output = make_output,
};

// A record begins with the levels that there are.
static int begin(struct inode *inode, struct file *file)
{
    unsigned long flags;
    int error = 0;

    spin_lock_irqsave(&lock, flags);
    if (is_open) {
        error = -EBUSY;
    } else {
        is_open = true;
        lost_some = false;
        kfifo_reset(&changes);
        record_levels();
    }
    spin_unlock_irqrestore(&lock, flags);
    return error;
}

static int end(struct inode *inode, struct file *file)
{
    WRITE_ONCE(is_open, false);
    return 0;
}

// A record with a gap is none.
static ssize_t take(struct file *file, char __user *to, size_t bytes, loff_t *at)
{
    unsigned int taken = 0;
    int error;

    if (READ_ONCE(lost_some))
        return -EOVERFLOW;
    error = kfifo_to_user(&changes, to, bytes, &taken);
    return error ? error : taken;
}

static const struct file_operations operations = {.owner = THIS_MODULE, .open = begin, .release = end, .read = take};
static struct miscdevice device = {.minor = MISC_DYNAMIC_MINOR, .name = "wire_recorder", .fops = &operations};

static int register_all(void)
{
    int error = gpiochip_add_data(&chip, NULL);

    if (error)
        return error;
    error = misc_register(&device);
    if (error)
        gpiochip_remove(&chip);
    return error;
}

static int __init load(void)
{
    int error;

    memory = vmalloc(most_bytes);
    if (!memory)
        return -ENOMEM;
    error = kfifo_init(&changes, memory, most_bytes);
    if (!error)
        error = register_all();
    if (error)
        vfree(memory);
    return error;
}

static void __exit unload(void)
{
    misc_deregister(&device);
    gpiochip_remove(&chip);
    vfree(memory);
}

module_init(load);
module_exit(unload);
MODULE_DESCRIPTION("GPIO lines that remember");
MODULE_LICENSE("Dual MIT/GPL");
