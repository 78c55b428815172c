/* A callback that says with a bool whether the action worked teaches what works, and not
 * the complement. */
#include "expect.h"

#include <stdbool.h>

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];

static critreg_status try_to_reach(void *user_data, const double *instance, const double *theta,
                                   critreg_outcome *outcome)
{
    bool works = theta[0] <= instance[0] - 0.1;
    (void)user_data;
    *outcome = works;
    return CRITREG_OK;
}

static void learns_what_works(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    const critreg_region *region = NULL;
    int wrong = 0, i, w;

    OK(critreg_learn_region(learner, WALLS, INSTANCES, try_to_reach, NULL, &region));
    for (w = 0; w < INSTANCES; w++)
        for (i = 0; i <= 400; i++) {
            double theta = 0.01 * i;
            int32_t inside = 77;
            OK(critreg_region_contains(region, WALLS + 2 * w, &theta, &inside));
            wrong += inside != (theta <= WALLS[2 * w] - 0.1);
        }
    /* Of 1604. Algorithm 1 is coarse, but far from the complement. */
    EXPECT_TRUE(wrong < (kind == CRITREG_ALGORITHM1 ? 500 : 8));
    expect_usable(learner);
}

int main(void)
{
    with_each_learner(learns_what_works);
    return summary();
}
