// EXPECT: a target is 1 to 2048 pixels wide and high
#include "shade16/target/band.hpp"

shade16::BandBuffer<shade16::Rgb565, 2049, 1> band;
