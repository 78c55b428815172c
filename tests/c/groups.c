/* Groups: instances with different numbers of objects, and absent ones. */
#include "expect.h"

static const char POSTS[] =
    "object post[3] { x: length, y: length }\n"
    "parameter reach in [0, 10]: length\n"
    "point hand = world + (reach, 0)\n";

static uint64_t memory[CRITREG_REGION_WORDS];

static double nowhere(void)
{
    return (double)NAN;
}

static void any_number_of_posts(const critreg_region *region)
{
    const double none = nowhere();
    double posts[6] = {4.0, 0.0, 8.0, 0.0, 0.0, 0.0}, ends[6], theta;
    critreg_rng rng = critreg_rng_seed(1);
    size_t numbers = 0, count = 0, i;
    int32_t inside = 0;

    posts[4] = posts[5] = none;
    OK(critreg_region_instance_len(region, &numbers));
    EXPECT_TRUE(numbers == 6);
    OK(critreg_region_intervals(region, posts, ends, 3, &count));
    EXPECT_TRUE(count == 3 && ends[1] == 3.5 && ends[2] == 4.5 && ends[3] == 7.5);
    for (i = 0; i < 100; i++) {
        OK(critreg_sample_region(region, posts, &rng, &theta));
        EXPECT_TRUE(fabs(theta - 4.0) >= 0.5 && fabs(theta - 8.0) >= 0.5);
        OK(critreg_region_contains(region, posts, &theta, &inside));
        EXPECT_TRUE(inside == 1);
    }
    posts[0] = posts[1] = posts[2] = posts[3] = none;
    OK(critreg_region_intervals(region, posts, ends, 3, &count));
    EXPECT_TRUE(count == 1 && ends[0] == 0.0 && ends[1] == 10.0);
}

static void members_that_are_partly_there(const critreg_region *region)
{
    critreg_rng rng = critreg_rng_seed(1);
    int32_t answer = 77;
    double theta = 0.5;
    size_t i;

    for (i = 0; i < 6; i++) {
        double posts[6] = {4.0, 0.0, 8.0, 0.0, 9.0, 0.0};
        posts[i] = nowhere();
        EXPECT(CRITREG_NOT_FINITE, critreg_sample_region(region, posts, &rng, &theta));
        EXPECT(CRITREG_NOT_FINITE, critreg_region_contains(region, posts, &theta, &answer));
        posts[i] = (double)INFINITY;
        EXPECT(CRITREG_NOT_FINITE, critreg_sample_region(region, posts, &rng, &theta));
        EXPECT_TRUE(theta == 0.5 && answer == 77);
    }
}

int main(void)
{
    critreg_region *region = NULL;
    char why[128];

    OK(critreg_region_parse(memory, sizeof memory, POSTS, "min(dist(hand, post)) >= 0.5", &region));
    any_number_of_posts(region);
    members_that_are_partly_there(region);
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_check_region(POSTS, "dist(hand, post) >= 0.5", why, sizeof why, NULL));
    EXPECT_TRUE(strcmp(why, "line 1, column 1: only min(...) or max(...) can be about a group") == 0);
    return summary();
}
