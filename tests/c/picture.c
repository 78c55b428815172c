/* Pictures of regions and of what a learner was told. */
#include "expect.h"

#define LONGEST 131072

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)], region_memory[CRITREG_REGION_WORDS];
static char text[LONGEST], other[LONGEST];

/* How often a piece of text occurs. */
static int occurrences(const char *piece)
{
    int count = 0;
    const char *found = text;
    while ((found = strstr(found, piece)) != NULL) {
        found += strlen(piece);
        count++;
    }
    return count;
}

static void of_a_region(void)
{
    critreg_region *region = NULL;
    size_t needed = 0;
    const double nan[2] = {NAN, 0.0};
    OK(critreg_region_parse(region_memory, sizeof region_memory, DOMAIN,
                            "reach <= wall.x - hand.radius", &region));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_to_svg(region, WALLS, NULL, 0, &needed));
    EXPECT_TRUE(needed > 2000 && needed <= sizeof text);
    EXPECT(CRITREG_TOO_SMALL, critreg_region_to_svg(region, WALLS, text, needed - 1, NULL));
    EXPECT_TRUE(text[0] == '\0');
    OK(critreg_region_to_svg(region, WALLS, text, needed, NULL));
    EXPECT_TRUE(strlen(text) + 1 == needed);
    EXPECT_TRUE(strncmp(text, "<svg", 4) == 0 && strstr(text, "reach in 0.00 .. 0.90") != NULL);
    OK(critreg_region_to_svg(region, WALLS + 2, other, sizeof other, NULL));
    EXPECT_TRUE(strcmp(text, other) != 0);
    EXPECT(CRITREG_NOT_FINITE, critreg_region_to_svg(region, nan, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_svg(region, NULL, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_svg(region, WALLS, NULL, 9, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_svg(NULL, WALLS, text, sizeof text, NULL));
}

static void of_a_learner(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    const critreg_region *region = NULL;
    const double near_wall = 0.5, beyond = 3.5;
    size_t needed = 0, length;
    OK(critreg_learner_to_svg(learner, WALLS, INSTANCES, 0, text, sizeof text, &needed));
    EXPECT_TRUE(occurrences("what can be chosen") == 1 && occurrences("tried, and") == 0);
    if (kind == CRITREG_VERSION_SPACE) {    /* The other one is told what it asks only. */
        OK(critreg_observe(learner, WALLS, INSTANCES, 1, &near_wall, CRITREG_FEASIBLE));
        OK(critreg_observe(learner, WALLS, INSTANCES, 1, &near_wall, CRITREG_UNKNOWN));
        OK(critreg_observe(learner, WALLS, INSTANCES, 2, &beyond, CRITREG_INFEASIBLE));
        OK(critreg_learner_to_svg(learner, WALLS, INSTANCES, 1, text, sizeof text, NULL));
        EXPECT_TRUE(occurrences("and worked") == 1 && occurrences("and failed") == 0);
        OK(critreg_learner_to_svg(learner, WALLS, INSTANCES, 2, text, sizeof text, NULL));
        EXPECT_TRUE(occurrences("and worked") == 0 && occurrences("and failed") == 1);
        learner = reach_learner(memory, sizeof memory);
    }
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
    EXPECT(CRITREG_TOO_SMALL,
           critreg_learner_to_svg(learner, WALLS, INSTANCES, 0, NULL, 0, &length));
    OK(critreg_learner_to_svg(learner, WALLS, INSTANCES, 0, text, length, NULL));
    EXPECT_TRUE(occurrences("expected to work") == 1 && occurrences("tried, and") > 0);
    /* It changes nothing. */
    OK(critreg_region_to_svg(region, WALLS, other, sizeof other, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_learner_to_svg(learner, WALLS, INSTANCES, INSTANCES, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_to_svg(learner, NULL, INSTANCES, 0, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_to_svg(learner, WALLS, INSTANCES, 0, NULL, 9, NULL));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_to_svg(NULL, WALLS, INSTANCES, 0, text, sizeof text, NULL));
}

int main(void)
{
    of_a_region();
    with_each_learner(of_a_learner);
    return summary();
}
