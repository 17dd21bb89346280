// EXPECT: two of the display's wires are on one line of the chip
#include <display/four_wire.hpp>
#include <mcu/rp2040/spi.hpp>

using namespace shade16;
using Bus = FourWire<rp2040::Spi0<18, 19, 1'000'000>, rp2040::Output<17>, rp2040::Output<20>, rp2040::Output<20>, rp2040::Output<22>>;

void reset(Bus& bus) { bus.reset(); }
