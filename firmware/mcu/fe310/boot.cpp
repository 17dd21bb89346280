// The clocks, which run before anything else of the program does.
#include <mcu/fe310/chip.hpp>

namespace shade16::fe310 {

/// Constructors with a priority run first, and the display's and the console's clocks follow from these.
__attribute__((constructor(101))) static void begin() { begin_clocks(); }

}  // namespace shade16::fe310
