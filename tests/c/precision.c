/* Learning with float: nearly as good as with double, and as reproducible. */
#include "expect.h"

#define TRAINING 4
#define TASKS 10
#define DRAWS 20
#define SEEDS 20
#define CALLS 100
#define NUMBERS 13

static uint64_t memory[CRITREG_LEARNER_WORDS_FOR(1024, 128, TRAINING, 1)];

static void tasks(uint64_t first, uint64_t count, double (*instances)[NUMBERS])
{
    uint64_t i;
    for (i = 0; i < count; i++)
        OK(critreg_stick_button_task(first + i, 0, 1, instances[i], NUMBERS));
}

static critreg_learner *learner_for(uint32_t precision, uint64_t seed)
{
    critreg_config config;
    critreg_learner *learner = NULL;
    OK(critreg_config_init(&config, sizeof config));
    config.seed = seed;
    config.forms = 1024;
    config.observations = 128;
    config.instances = TRAINING;
    config.calls = CALLS;
    config.precision = precision;
    EXPECT_TRUE(critreg_learner_size(&config) <= sizeof memory);
    OK(critreg_learner_init(memory, sizeof memory, critreg_stick_button_domain(), &config,
                            &learner));
    return learner;
}

/* How many grasps of 200 work, that are drawn from a region for tasks not seen before. */
static int working(const critreg_region *region, uint64_t seed)
{
    critreg_rng rng = critreg_rng_seed(seed);
    double instances[TASKS][NUMBERS], theta;
    int working = 0, i, j;
    tasks(1000 * seed, TASKS, instances);
    for (i = 0; i < TASKS; i++)
        for (j = 0; j < DRAWS; j++) {
            critreg_outcome outcome = CRITREG_NO_OUTCOME;
            int32_t inside = 0;
            OK(critreg_sample_region(region, instances[i], &rng, &theta));
            OK(critreg_region_contains(region, instances[i], &theta, &inside));
            EXPECT_TRUE(inside == 1);
            OK(critreg_stick_button_pick(NULL, instances[i], &theta, &outcome));
            working += outcome == CRITREG_FEASIBLE;
        }
    return working;
}

/* With how many seeds nearly all grasps work. */
static int good_seeds(uint32_t precision)
{
    double instances[TRAINING][NUMBERS];
    int good = 0;
    uint64_t seed;
    for (seed = 1; seed <= SEEDS; seed++) {
        const critreg_region *region = NULL;
        critreg_learner *learner = learner_for(precision, seed);
        tasks(100000 + TRAINING * seed, TRAINING, instances);
        if (critreg_learn_region(learner, instances[0], TRAINING, critreg_stick_button_pick,
                                 NULL, &region) == CRITREG_OK)
            good += working(region, seed) >= TASKS * DRAWS * 98 / 100;
    }
    return good;
}

/* A run goes on in the precision that it was saved in, and in no other. */
static void saving(void)
{
    static uint8_t bytes[4096], again[4096];
    double instances[TRAINING][NUMBERS];
    const critreg_region *region = NULL;
    critreg_learner *learner = learner_for(CRITREG_F32, 1);
    size_t len = 0, len_again = 0;
    tasks(100000, TRAINING, instances);
    OK(critreg_learn_region(learner, instances[0], TRAINING, critreg_stick_button_pick, NULL,
                            &region));
    OK(critreg_learner_save(learner, instances[0], TRAINING, bytes, sizeof bytes, &len));
    learner = learner_for(CRITREG_F64, 1);
    EXPECT(CRITREG_MISMATCH,
           critreg_learner_resume(learner, instances[0], TRAINING, bytes, len));
    learner = learner_for(CRITREG_F32, 1);
    OK(critreg_learner_resume(learner, instances[0], TRAINING, bytes, len));
    OK(critreg_learner_save(learner, instances[0], TRAINING, again, sizeof again, &len_again));
    EXPECT_TRUE(len == len_again && memcmp(bytes, again, len) == 0);
}

/* A region that was saved computes with what its learner did. */
static void saving_regions(void)
{
    static uint8_t bytes[8192], again[8192];
    static uint64_t other[CRITREG_REGION_WORDS];
    double instances[TRAINING][NUMBERS], one[1], two[1];
    const critreg_region *region = NULL;
    critreg_region *loaded = NULL;
    critreg_learner *learner = learner_for(CRITREG_F32, 1);
    critreg_rng rng = critreg_rng_seed(1), same = rng;
    size_t len = 0, len_again = 0;
    int i;
    tasks(100000, TRAINING, instances);
    OK(critreg_learn_region(learner, instances[0], TRAINING, critreg_stick_button_pick, NULL,
                            &region));
    OK(critreg_region_save(region, bytes, sizeof bytes, &len));
    OK(critreg_region_load(other, sizeof other, bytes, len, &loaded));
    for (i = 0; i < 100; i++) {
        OK(critreg_sample_region(region, instances[i % TRAINING], &rng, one));
        OK(critreg_sample_region(loaded, instances[i % TRAINING], &same, two));
        EXPECT_TRUE(memcmp(one, two, sizeof one) == 0);
    }
    OK(critreg_region_save(loaded, again, sizeof again, &len_again));
    EXPECT_TRUE(len == len_again && memcmp(bytes, again, len) == 0);
}

/* A number that no float is near is refused, wherever it comes in. */
static void too_large(void)
{
    static const char *const HUGE_DOMAINS[] = {
        "object cup { x: length } parameter p in [0, 1e39]: length",
        "object cup { x: length } constant far = 1e39: length parameter p in [0, 4]: length",
    };
    static const char *const PLAIN = "object cup { x: length } parameter p in [0, 4]: length";
    critreg_config config;
    critreg_learner *learner;
    double far[1] = {1e39}, near[1] = {1.0}, theta;
    size_t instance, i;
    OK(critreg_config_init(&config, sizeof config));
    for (i = 0; i < 2; i++) {
        config.precision = CRITREG_F32;
        EXPECT(CRITREG_NOT_FINITE,
               critreg_learner_init(memory, sizeof memory, HUGE_DOMAINS[i], &config, &learner));
        config.precision = CRITREG_F64;
        OK(critreg_learner_init(memory, sizeof memory, HUGE_DOMAINS[i], &config, &learner));
    }
    config.precision = CRITREG_F32;
    OK(critreg_learner_init(memory, sizeof memory, PLAIN, &config, &learner));
    EXPECT(CRITREG_NOT_FINITE, critreg_ask(learner, far, 1, &instance, &theta));
    EXPECT(CRITREG_NOT_FINITE, critreg_observe(learner, near, 1, 0, far, CRITREG_FEASIBLE));
    OK(critreg_ask(learner, near, 1, &instance, &theta));
}

int main(void)
{
    critreg_config config;
    critreg_learner *learner;
    int single = good_seeds(CRITREG_F32), twice = good_seeds(CRITREG_F64);
    printf("float: %d, double: %d of %d\n", single, twice, SEEDS);
    EXPECT_TRUE(twice >= 18 && single >= 18);
    saving();
    saving_regions();
    too_large();
    OK(critreg_config_init(&config, sizeof config));
    config.precision = 16;
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
    return summary();
}
