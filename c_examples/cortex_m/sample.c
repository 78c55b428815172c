/*
 * What a robot needs that only draws: a region from its text, and parameters from it. The
 * library for it is built without learners and planner. Prints "key number" lines for
 * figures.py.
 */
#include "critreg.h"
#include "machine.h"
#include "print.h"

#define DRAWS 100

static const char domain_text[] =
    "object stick  { x: length, y: length, theta: angle }\n"
    "object holder { x: length, y: length, theta: angle }\n"
    "constant stick.width  = 3.0: length\n"
    "constant holder.width = 0.3: length\n"
    "parameter mu in [0, 1]\n"
    "point grasp         = stick  + (mu * stick.width, 0)\n"
    "point holder.centre = holder + (0.5 * holder.width, 0)\n";
static const char region_text[] = "grasp.y <= 2.9 and dist(grasp, holder.centre) >= 0.25";
static const double instance[6] = {2.0, 0.7, 1.57, 2.0, 1.0, 1.57};

static uint64_t memory[CRITREG_REGION_WORDS];

static void print(const char *key, size_t number)
{
    machine_print(key);
    machine_print(" ");
    print_whole(number);
    machine_print("\n");
}

int main(void)
{
    critreg_region *region = NULL;
    critreg_rng rng = critreg_rng_seed(1);
    critreg_status status =
        critreg_region_parse(memory, sizeof memory, domain_text, region_text, &region);
    double mu = 0.0;
    int32_t inside = 1;
    int i;
    for (i = 0; i < DRAWS && status == CRITREG_OK && inside; i++) {
        status = critreg_sample_region(region, instance, &rng, &mu);
        if (status == CRITREG_OK)
            status = critreg_region_contains(region, instance, &mu, &inside);
    }
    print("sampling_ram", critreg_region_size());
    print("sampling_stack", machine_stack_used());
    if (status != CRITREG_OK)
        machine_print(critreg_strerror(status));
    return status != CRITREG_OK || !inside;
}
