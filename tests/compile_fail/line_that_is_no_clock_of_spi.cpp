// EXPECT: this line cannot be the clock of SPI 1
#include <mcu/stm32f4/spi.hpp>

using namespace shade16::stm32f4;

void begin() { Spi1<Pin{'A', 6}, Pin{'A', 7}, 21'000'000>::begin(); }
