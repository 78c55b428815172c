/* Outcomes that are none, that were not written, and that nobody knows. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS_FOR(1024, 256, CRITREG_DEFAULT_INSTANCES,
                                                 CRITREG_MAX_STEPS)];
static uint64_t other[CRITREG_LEARNER_WORDS(1024, 256)];

/* The sample that was asked for is refused with these words, and stays to be told. */
static void refused(critreg_learner *learner, critreg_outcome outcome, const char *words)
{
    char why[128];
    size_t instance;
    double before, after;

    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &before));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_tell(learner, WALLS, INSTANCES, outcome));
    OK(critreg_learner_message(learner, why, sizeof why, NULL));
    EXPECT_TRUE(strcmp(why, words) == 0);
    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &after));
    EXPECT_TRUE(before == after);
}

static void numbers_that_are_none(void)
{
    static const critreg_outcome numbers[] = {3, 77, 1000, INT32_MAX, -256, INT32_MIN + 1};
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    char words[128];
    size_t i;

    for (i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        sprintf(words, "an outcome is 0 (infeasible), 1 (feasible), 2 (unknown) or -k (step k "
                       "failed), not %ld", (long)numbers[i]);
        refused(learner, numbers[i], words);
    }
    refused(learner, CRITREG_NO_OUTCOME, "no outcome was written");
    expect_usable(learner);
}

/* Forgets to write an outcome in call number at. */
typedef struct {
    int calls, at;
} forgetful;

static critreg_status forget(void *user_data, const double *instance, const double *theta,
                             critreg_outcome *outcome)
{
    forgetful *state = (forgetful *)user_data;
    EXPECT_TRUE(*outcome == CRITREG_NO_OUTCOME);
    return state->calls++ == state->at ? CRITREG_OK : reach(NULL, instance, theta, outcome);
}

static void callbacks_that_write_nothing(void)
{
    int at;
    for (at = 0; at < SAMPLES; at++) {
        critreg_learner *learner = reach_learner(memory, sizeof memory);
        const critreg_region *region = NULL;
        forgetful state = {0, at};
        char why[128];

        EXPECT(CRITREG_INVALID_ARGUMENT,
               critreg_learn_region(learner, WALLS, INSTANCES, forget, &state, &region));
        EXPECT_TRUE(region == NULL && state.calls == at + 1);
        OK(critreg_learner_message(learner, why, sizeof why, NULL));
        EXPECT_TRUE(strcmp(why, "no outcome was written") == 0);
        OK(critreg_learn_region(learner, WALLS, INSTANCES, forget, &state, &region));
        expect_usable(learner);
    }
}

/* The step that failed must be one of those that the configuration has, and must be told
 * where there are several. */
static void steps(void)
{
    critreg_config config = reach_config();
    int makes_a_difference = kind == CRITREG_VERSION_SPACE;
    size_t instance;
    double theta;
    int count, step;

    for (count = 1; count <= (int)CRITREG_MAX_STEPS; count++) {
        critreg_learner *learner;
        char words[128];
        config.steps = (uint32_t)count;
        OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
        if (makes_a_difference) {
            sprintf(words, "a failed step is -k, with k from 1 to the steps of the "
                           "configuration, not %d", -count - 1);
            refused(learner, CRITREG_FAILED_STEP(count + 1), words);
        }
        if (makes_a_difference && count > 1)
            refused(learner, CRITREG_INFEASIBLE,
                    "the outcome of a sequence that failed is -k, for its step k, not 0");
        for (step = 1; step <= (makes_a_difference ? count : 255); step += 1 + step / 8 * 50) {
            OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
            OK(critreg_tell(learner, WALLS, INSTANCES, CRITREG_FAILED_STEP(step)));
        }
    }
    EXPECT_TRUE(CRITREG_FAILED_STEP(1 + 1) == -2 && 5 - CRITREG_FAILED_STEP(1) == 6);
}

/* Knows nothing of every third sample. */
static critreg_status now_and_then(void *user_data, const double *instance, const double *theta,
                                   critreg_outcome *outcome)
{
    int *calls = (int *)user_data;
    if ((*calls)++ % 3 != 2)
        return reach(NULL, instance, theta, outcome);
    *outcome = CRITREG_UNKNOWN;
    return CRITREG_OK;
}

static critreg_status crash(void *user_data, const double *instance, const double *theta,
                            critreg_outcome *outcome)
{
    (void)user_data;
    (void)instance;
    (void)theta;
    *outcome = CRITREG_UNKNOWN;
    return CRITREG_OK;
}

static critreg_report report_of(const critreg_learner *learner)
{
    critreg_report report;
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    return report;
}

static void nobody_knows(void)
{
    static uint8_t bytes[8192];
    critreg_learner *learner = reach_learner(memory, sizeof memory), *resumed;
    const critreg_region *region = NULL;
    const double near_wall = 0.95, before_wall = 0.85;
    critreg_report report;
    int32_t inside[2] = {77, 77};
    size_t length;
    int calls = 0;

    OK(critreg_learn_region(learner, WALLS, INSTANCES, now_and_then, &calls, &region));
    OK(critreg_region_contains(region, WALLS, &before_wall, &inside[0]));
    OK(critreg_region_contains(region, WALLS, &near_wall, &inside[1]));
    /* Algorithm 1 ends with a looser bound. */
    EXPECT_TRUE(inside[0] == 1 && (inside[1] == 0 || kind == CRITREG_ALGORITHM1));
    report = report_of(learner);
    EXPECT_TRUE(report.unknown == (uint64_t)calls / 3 && report.calls == (uint64_t)calls);
    EXPECT_TRUE(report.feasible + report.infeasible + report.unknown == report.calls);

    OK(critreg_learner_save(learner, WALLS, INSTANCES, bytes, sizeof bytes, &length));
    resumed = reach_learner(other, sizeof other);
    OK(critreg_learner_resume(resumed, WALLS, INSTANCES, bytes, length));
    EXPECT_TRUE(report_of(resumed).unknown == report.unknown);

    learner = reach_learner(memory, sizeof memory);
    EXPECT(CRITREG_NO_REGION,
           critreg_learn_region(learner, WALLS, INSTANCES, crash, NULL, NULL));
    report = report_of(learner);
    EXPECT_TRUE(report.unknown == report.calls && report.calls > 0);
}

/* There is a number to read, even where there are none. */
static critreg_status read_both(void *user_data, const double *instance, const double *theta,
                                critreg_outcome *outcome)
{
    double *sum = (double *)user_data;
    *sum += *instance + *theta;
    *outcome = CRITREG_UNKNOWN;
    return CRITREG_OK;
}

static void no_numbers(void)
{
    critreg_config config = reach_config();
    critreg_learner *learner;
    double sum = 0.0;

    config.negative = config.positive = NULL;
    OK(critreg_learner_init(memory, sizeof memory, "parameter a in [1, 2]", &config, &learner));
    (void)critreg_learn_region(learner, NULL, 1, read_both, &sum, NULL);
    EXPECT_TRUE(report_of(learner).calls > 0 && sum > 0.0);
    if (kind == CRITREG_ALGORITHM1)
        return;     /* It has no use for a domain without parameters. */
    OK(critreg_learner_init(memory, sizeof memory, "object a { x: length }", &config, &learner));
    (void)critreg_learn_region(learner, WALLS, INSTANCES, read_both, &sum, NULL);
    EXPECT_TRUE(report_of(learner).calls > 0);
}

static void tests(void)
{
    numbers_that_are_none();
    callbacks_that_write_nothing();
    steps();
    nobody_knows();
    no_numbers();
}

int main(void)
{
    with_each_learner(tests);
    return summary();
}
