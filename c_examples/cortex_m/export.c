/* Writes the region of a learned pick as C that needs no library; see export.py. */
#include <stdio.h>

#include "critreg.h"

static const char DOMAIN_TEXT[] =
    "object stick  { x: length, y: length, theta: angle }\n"
    "object holder { x: length, y: length, theta: angle }\n"
    "constant zone.top     = 3.0: length\n"
    "constant stick.width  = 3.0: length\n"
    "constant holder.width = 0.3: length\n"
    "constant robot.radius = 0.1: length\n"
    "parameter mu in [0, 1]\n"
    "point grasp         = stick  + (mu * stick.width, 0)\n"
    "point holder.centre = holder + (0.5 * holder.width, 0)\n";

static const char REGION[] =
    "grasp.y <= 2.9 (zone.top - robot.radius) and dist(grasp, holder.centre) >= 0.25";

static uint64_t memory[CRITREG_REGION_WORDS];
static char text[32768];

int main(void)
{
    critreg_region *region;
    critreg_status status =
        critreg_region_parse(memory, sizeof memory, DOMAIN_TEXT, REGION, &region);
    if (status == CRITREG_OK)
        status = critreg_region_to_c(region, "pick", text, sizeof text, NULL);
    if (status != CRITREG_OK) {
        fprintf(stderr, "%s\n", critreg_strerror(status));
        return 1;
    }
    fputs(text, stdout);
    return 0;
}
