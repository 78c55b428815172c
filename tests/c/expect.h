/* What the misuse programs share: expectations, and an action to learn about. */
#ifndef EXPECT_H
#define EXPECT_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "critreg.h"

static int expectations, failures;

#define EXPECT(expected, call) expect((expected), (call), #call, __FILE__, __LINE__)
#define EXPECT_TRUE(condition) expect_true((condition), #condition, __FILE__, __LINE__)
#define OK(call) EXPECT(CRITREG_OK, call)

static inline void expect(int expected, int found, const char *what, const char *file, int line)
{
    expectations++;
    if (expected == found)
        return;
    failures++;
    fprintf(stderr, "%s:%d: %s: %s instead of %s\n", file, line, what,
            critreg_status_name(found), critreg_status_name(expected));
}

static inline void expect_true(int holds, const char *what, const char *file, int line)
{
    expectations++;
    if (holds)
        return;
    failures++;
    fprintf(stderr, "%s:%d: not so: %s\n", file, line, what);
}

static inline int summary(void)
{
    printf("expectations: %d, failures: %d\n", expectations, failures);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* A pointer that is not aligned. */
#define ASKEW(type, pointer) ((type *)((uintptr_t)(pointer) + 1))

/* A hand reaches forward, and must stop before a wall. */
static const char DOMAIN[] =
    "object wall { x: length, y: length }\n"
    "constant hand.radius = 0.1: length\n"
    "parameter reach in [0, 4]: length\n"
    "point hand = world + (reach, 0)\n";

#define INSTANCES 4
static const double WALLS[INSTANCES * 2] = {1.0, 0.0, 1.5, 0.0, 2.5, 0.0, 3.0, 0.0};

static inline critreg_status reach(void *user_data, const double *instance, const double *theta,
                                   critreg_outcome *outcome)
{
    (void)user_data;
    *outcome = theta[0] <= instance[0] - 0.1 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
    return CRITREG_OK;
}

/* The learner that is tried, and how many samples it asks for. */
static uint32_t kind = CRITREG_VERSION_SPACE;
#define SAMPLES (kind == CRITREG_ALGORITHM1 ? 42 : 40)

static inline critreg_config reach_config(void)
{
    static const double too_near = 0.95, near_enough = 0.85;
    critreg_config config;
    OK(critreg_config_init(&config, sizeof config));
    config.learner = kind;
    config.seed = 1;
    config.forms = 1024;
    config.calls = 40;
    if (kind == CRITREG_ALGORITHM1) {
        config.negative = &too_near;
        config.positive = &near_enough;
    }
    return config;
}

/* Runs tests with every learner. */
static inline void with_each_learner(void (*tests)(void))
{
    static const uint32_t kinds[] = {CRITREG_VERSION_SPACE, CRITREG_ALGORITHM1};
    size_t i;
    for (i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        kind = kinds[i];
        tests();
    }
    kind = CRITREG_VERSION_SPACE;
}

static inline critreg_learner *reach_learner(uint64_t *memory, size_t memory_len)
{
    critreg_config config = reach_config();
    critreg_learner *learner = NULL;
    OK(critreg_learner_init(memory, memory_len, DOMAIN, &config, &learner));
    return learner;
}

/* The learner finishes, and with the region that an undisturbed one finds. */
static inline void expect_usable(critreg_learner *learner)
{
    static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
    static char texts[3][4096];
    char found[4096] = "", *expected = texts[kind];
    const critreg_region *region = NULL;
    if (expected[0] == '\0') {
        critreg_learner *undisturbed = reach_learner(memory, sizeof memory);
        OK(critreg_learn_region(undisturbed, WALLS, INSTANCES, reach, NULL, &region));
        OK(critreg_region_format(region, expected, sizeof found, NULL));
    }
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
    OK(critreg_region_format(region, found, sizeof found, NULL));
    EXPECT_TRUE(strcmp(expected, found) == 0);
}

#endif
