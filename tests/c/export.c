/* Regions without the library, as functions, and many samples at once. */
#include "expect.h"

#define COUNT 1000

static uint64_t memory[CRITREG_REGION_WORDS], other_memory[CRITREG_REGION_WORDS];
static const double WALL[2] = {3.0, 0.0};

static critreg_region *parsed(uint64_t *place, const char *text)
{
    critreg_region *region = NULL;
    OK(critreg_region_parse(place, CRITREG_REGION_WORDS * 8, DOMAIN, text, &region));
    return region;
}

static void margins(const critreg_region *region)
{
    double theta = 2.5, nan = NAN, values[2] = {0, 0}, gradients[2] = {0, 0};
    OK(critreg_region_margins(region, WALL, &theta, values, gradients));
    EXPECT_TRUE(fabs(values[0] + 0.4) < 1e-12 && values[1] == 0.5);
    EXPECT_TRUE(gradients[0] == 1.0 && gradients[1] == 1.0);
    values[0] = 7.0;
    OK(critreg_region_margins(region, WALL, &theta, values, NULL));
    EXPECT_TRUE(fabs(values[0] + 0.4) < 1e-12);
    EXPECT(CRITREG_NOT_FINITE, critreg_region_margins(region, WALL, &nan, values, gradients));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_margins(region, NULL, &theta, values, gradients));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_margins(region, WALL, NULL, values, gradients));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_margins(region, WALL, &theta, NULL, gradients));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_margins(NULL, WALL, &theta, values, gradients));
}

static void many(const critreg_region *region)
{
    static double thetas[COUNT], one;
    static uint8_t inside[COUNT];
    critreg_rng rng = critreg_rng_seed(3), single = critreg_rng_seed(3);
    size_t i, drawn = 0, count = 0;
    OK(critreg_sample_region_many(region, WALL, COUNT, &rng, thetas, &drawn));
    EXPECT_TRUE(drawn == COUNT);
    for (i = 0; i < COUNT; i++) {
        OK(critreg_sample_region(region, WALL, &single, &one));
        EXPECT_TRUE(one == thetas[i]);
    }
    EXPECT_TRUE(memcmp(&rng, &single, sizeof rng) == 0);
    for (i = 0; i < COUNT; i++)
        thetas[i] = -0.5 + 5.0 * (double)i / COUNT;
    OK(critreg_region_contains_many(region, WALL, thetas, COUNT, inside));
    for (i = 0; i < COUNT; i++) {
        int32_t alone;
        OK(critreg_region_contains(region, WALL, &thetas[i], &alone));
        EXPECT_TRUE(alone == inside[i]);
        count += inside[i];
    }
    EXPECT_TRUE(count > COUNT / 10 && count < COUNT / 2);
    OK(critreg_region_contains_many(region, WALL, NULL, 0, NULL));
    OK(critreg_sample_region_many(region, WALL, 0, &rng, NULL, &drawn));
    EXPECT_TRUE(drawn == 0);
    EXPECT(CRITREG_NULL_POINTER, critreg_region_contains_many(region, WALL, thetas, 1, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_contains_many(region, WALL, NULL, 1, inside));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_contains_many(region, WALL, thetas, SIZE_MAX, inside));
    thetas[700] = NAN;
    EXPECT(CRITREG_NOT_FINITE, critreg_region_contains_many(region, WALL, thetas, COUNT, inside));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region_many(region, WALL, 1, NULL, thetas, &drawn));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region_many(region, WALL, 1, &rng, NULL, &drawn));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region_many(region, WALL, 1, &rng, thetas, NULL));
}

static void nothing_inside(void)
{
    const critreg_region *region = parsed(other_memory, "reach > 3 and reach < 2");
    critreg_rng rng = critreg_rng_seed(3);
    double theta = 0.0;
    size_t drawn = 7;
    EXPECT(CRITREG_EMPTY_REGION,
           critreg_sample_region_many(region, WALL, 1, &rng, &theta, &drawn));
    EXPECT_TRUE(drawn == 0);
}

static void as_c(const critreg_region *region)
{
    static char text[32768];
    size_t needed = 0;
    EXPECT(CRITREG_TOO_SMALL, critreg_region_to_c(region, "grasp", NULL, 0, &needed));
    EXPECT_TRUE(needed > 1000 && needed <= sizeof text);
    OK(critreg_region_to_c(region, "grasp", text, sizeof text, NULL));
    EXPECT_TRUE(strlen(text) + 1 == needed);
    EXPECT_TRUE(strstr(text, "static inline int grasp_contains(") != NULL);
    EXPECT_TRUE(strstr(text, "static inline int grasp_sample(") != NULL);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_to_c(region, "3", text, sizeof text, NULL));
    memset(text, 'a', 100);
    text[100] = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_to_c(region, text, NULL, 0, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_c(region, NULL, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_c(region, "grasp", NULL, 9, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_c(NULL, "grasp", text, sizeof text, NULL));
}

static void as_rust(const critreg_region *region)
{
    static char text[32768];
    size_t needed = 0;
    EXPECT(CRITREG_TOO_SMALL, critreg_region_to_rust(region, CRITREG_F64, NULL, 0, &needed));
    EXPECT_TRUE(needed > 1000 && needed <= sizeof text);
    OK(critreg_region_to_rust(region, CRITREG_F64, text, sizeof text, NULL));
    EXPECT_TRUE(strlen(text) + 1 == needed);
    EXPECT_TRUE(strstr(text, "pub type Real = f64;") != NULL);
    EXPECT_TRUE(strstr(text, "pub fn sample(") != NULL);
    OK(critreg_region_to_rust(region, CRITREG_F32, text, sizeof text, NULL));
    EXPECT_TRUE(strstr(text, "pub type Real = f32;") != NULL);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_to_rust(region, 16, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_rust(region, CRITREG_F64, NULL, 9, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_to_rust(NULL, CRITREG_F64, text, 9, NULL));
}

int main(void)
{
    const critreg_region *region =
        parsed(memory, "reach <= wall.x - hand.radius and hand.x - reach + reach <= 2");
    margins(region);
    many(region);
    nothing_inside();
    as_c(region);
    as_rust(region);
    return summary();
}
