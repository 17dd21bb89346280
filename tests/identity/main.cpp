// On this computer and on boards.
#include "tests/identity/hashes.hpp"

int main() {
    shade16::identity::say_hashes();
    return 0;
}
