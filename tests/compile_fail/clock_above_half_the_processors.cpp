// EXPECT: the interface runs at half the processor's clock at most
#include <mcu/lm3s.hpp>

void begin() { shade16::lm3s::Ssi0<50'000'000, 26'000'000>::begin(); }
