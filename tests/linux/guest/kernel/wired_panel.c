// A board without an SPI of its own: spi-gpio sends on the recorder's lines, and to them a display is wired that no driver knows, so that
// spidev may have it. spi-gpio is to be loaded before.
// Source: the kernel's include/linux/spi/spi_gpio.h and Documentation/driver-api/gpio/board.rst.
#include <linux/gpio/machine.h>
#include <linux/module.h>
#include <linux/platform_device.h>
#include <linux/spi/spi.h>
#include <linux/spi/spi_gpio.h>

#include "wire_record.h"

static struct gpiod_lookup_table wires = {
    .dev_id = "spi_gpio.0",
    .table = {
        GPIO_LOOKUP("wire_recorder", wire_clock, "sck", GPIO_ACTIVE_HIGH),
        GPIO_LOOKUP("wire_recorder", wire_data, "mosi", GPIO_ACTIVE_HIGH),
        GPIO_LOOKUP("wire_recorder", wire_select, "cs", GPIO_ACTIVE_HIGH),  // spi-gpio itself sets it low to select
        {},
    },
};
static const struct spi_gpio_platform_data one_select = {.num_chipselect = 1};
static struct spi_board_info panel = {.modalias = "panel", .max_speed_hz = 32000000};
static struct platform_device *bus;

static int add_panel(void)
{
    struct device *controller = device_find_any_child(&bus->dev);
    struct spi_device *added;

    if (!controller)
        return -ENODEV;
    added = spi_new_device(container_of(controller, struct spi_controller, dev), &panel);
    put_device(controller);
    return added ? 0 : -ENODEV;
}

static void remove_bus(void)
{
    platform_device_unregister(bus);  // and the panel with it
    gpiod_remove_lookup_table(&wires);
}

static int __init load(void)
{
    int error;

    gpiod_add_lookup_table(&wires);
    bus = platform_device_register_data(NULL, "spi_gpio", 0, &one_select, sizeof(one_select));
    if (IS_ERR(bus)) {
        gpiod_remove_lookup_table(&wires);
        return PTR_ERR(bus);
    }
    error = add_panel();
    if (error)
        remove_bus();
    return error;
}

module_init(load);
module_exit(remove_bus);
MODULE_DESCRIPTION("An SPI on the lines of wire_recorder, and a display on it");
MODULE_LICENSE("Dual MIT/GPL");
