// Stellaris LM3S6965 and LM3S811 (Cortex-M3): GPIO outputs, the synchronous serial interface and the I2C master.
// Source: Stellaris LM3S6965 and LM3S811 microcontroller data sheets, Texas Instruments.
#pragma once

#include <mcu/registers.hpp>
#include <runtime/console.hpp>

namespace shade16::lm3s {

namespace detail {
inline constexpr uint32_t clock_gates_1 = 0x400FE104, clock_gates_2 = 0x400FE108;

constexpr uint32_t port_address(char port) {
    return port <= 'D' ? 0x40004000 + static_cast<uint32_t>(port - 'A') * 0x1000 : 0x40024000 + static_cast<uint32_t>(port - 'E') * 0x1000;
}
}  // namespace detail

/// One line as an output: Output<'C', 7>.
template <char PortName, unsigned Bit, class Port = Registers>
struct Output {
    static_assert(PortName >= 'A' && PortName <= 'G', "this chip has the ports A to G (data sheet, GPIO)");
    static_assert(Bit <= 7, "a port has the lines 0 to 7 (data sheet, GPIO)");

    static void begin() {
        set_bits<Port>(detail::clock_gates_2, uint32_t{1} << (PortName - 'A'));
        set_bits<Port>(base + direction, mask);
        set_bits<Port>(base + digital_enable, mask);
    }
    /// The data register's address says which lines a write reaches, so that no others need be read.
    static void set(bool high) { Port::write(base + (mask << 2), high ? mask : 0); }

private:
    static constexpr uint32_t base = detail::port_address(PortName), mask = uint32_t{1} << Bit;
    static constexpr uint32_t direction = 0x400, digital_enable = 0x51C;
};

/// Interface 0, a PL022: SPI mode 0, eight bits a word. Its lines are PA2 (clock) and PA5 (data).
template <uint32_t CpuHz, uint32_t Hz, class Port = Registers>
struct Ssi0 {
    static_assert(Hz > 0 && Hz <= CpuHz / 2, "the interface runs at half the processor's clock at most (data sheet, SSI, bit rate)");
    static constexpr uint32_t divisor = (CpuHz + Hz - 1) / Hz, even_divisor = (divisor + 1) & ~uint32_t{1};
    static constexpr uint32_t hz = CpuHz / even_divisor;
    static_assert(even_divisor <= 254, "the interface divides the processor's clock by 254 at most (data sheet, SSI, CPSDVSR)");

    static void begin() {
        set_bits<Port>(detail::clock_gates_1, 1u << 4);
        Port::write(control_1, 0);
        Port::write(prescale, even_divisor);
        Port::write(control_0, 7);  // eight bits, mode 0
        Port::write(control_1, 2);  // enabled, master
    }
    /// Returns when the byte is on the wire, so that the data/command line may change.
    static void send(uint8_t byte) {
        if (!wait_for<Port>(status, may_send, may_send)) console::fail("The serial interface takes no byte: is its clock on?");
        Port::write(data, byte);
        if (!wait_for<Port>(status, has_received, has_received)) console::fail("The serial interface does not send: is it enabled?");
        static_cast<void>(Port::read(data));  // what came back
    }

private:
    static constexpr uint32_t base = 0x40008000, control_0 = base, control_1 = base + 4, data = base + 8, status = base + 12, prescale = base + 16;
    static constexpr uint32_t may_send = 2, has_received = 4;
};

/// The I2C master: bytes to a device of seven address bits.
template <uint32_t CpuHz, class Port = Registers>
struct I2c {
    static constexpr uint32_t hz = 100'000;
    static_assert(CpuHz >= 20 * hz && CpuHz <= 256 * 20 * hz, "the master divides the processor's clock by 20 to 5120 for 100 kHz (data sheet, I2C, TPR)");

    static void begin() {
        set_bits<Port>(detail::clock_gates_1, 1u << 12);
        Port::write(configuration, 1u << 4);              // master
        Port::write(timer_period, CpuHz / (20 * hz) - 1);
    }
    /// A control byte and one that follows it, as displays take them.
    static void send(uint8_t device, uint8_t control, uint8_t byte) {
        Port::write(address, static_cast<uint32_t>(device) << 1);
        step(control, start | run);
        step(byte, stop | run);
    }

private:
    static constexpr uint32_t base = 0x40020000, address = base, command = base + 4, data = base + 8, timer_period = base + 12, configuration = base + 32;
    static constexpr uint32_t run = 1, start = 2, stop = 4, busy = 1, error = 2;

    static void step(uint8_t byte, uint32_t what) {
        Port::write(data, byte);
        Port::write(command, what);
        if (!wait_for<Port>(command, busy, 0)) console::fail("The I2C bus stays busy: is a line held low?");
        if ((Port::read(command) & error) != 0) console::fail("The display does not answer on the I2C bus: check its address and its wires.");
    }
};

}  // namespace shade16::lm3s
