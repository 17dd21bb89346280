// EXPECT: this chip has the ports A to G
#include <mcu/lm3s.hpp>

void switch_on() { shade16::lm3s::Output<'H', 7>::begin(); }
