// Everything that a machine has to say.
#pragma once

namespace shade16::identity {

void say_hashes();

}  // namespace shade16::identity
