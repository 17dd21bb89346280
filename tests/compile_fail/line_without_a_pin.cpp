// EXPECT: the package has the lines 0 to 5, 9 to 13 and 16 to 23
#include <mcu/fe310/chip.hpp>

void switch_on() { shade16::fe310::Output<7>::begin(true); }
