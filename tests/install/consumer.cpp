#include <cstdio>
#include "critreg.hpp"

int main() {
    const auto region = critreg::Region::parse(
        "object table { width: length }\n"
        "parameter p in [0, 1]: length\npoint place = world + (p, 0)",
        "place.x <= table.width");
    critreg::Rng rng(7);
    const auto p = region.sample({0.25}, rng);
    std::printf("critreg %s: %.4f\n", critreg_version(), p.value().at(0));
}
