// EXPECT: SPI runs at half its clock of 84 MHz at most
#include <mcu/stm32f4/spi.hpp>

using namespace shade16::stm32f4;

void begin() { Spi1<Pin{'A', 5}, Pin{'A', 7}, 50'000'000>::begin(); }
