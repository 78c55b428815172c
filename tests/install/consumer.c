#include <stdio.h>
#include "critreg.h"

static uint64_t memory[CRITREG_REGION_WORDS];

int main(void) {
    const char *domain = "object table { width: length }\n"
                         "parameter p in [0, 1]: length\npoint place = world + (p, 0)";
    const double table[1] = {0.25};
    critreg_rng rng = critreg_rng_seed(7);
    critreg_region *region;
    double p;
    if (critreg_region_parse(memory, sizeof memory, domain, "place.x <= table.width", &region)
        || critreg_sample_region(region, table, &rng, &p))
        return 1;
    printf("critreg %s: %.4f\n", critreg_version(), p);
    return p > 0.25;
}
