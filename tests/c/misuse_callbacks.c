/* Callbacks that are missing, fail, cancel or call back. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];

/* Fails once, in call number at. */
typedef struct {
    int calls, at;
    critreg_status status;
    double theta;       /* what was to be tried then */
} failing;

static critreg_status fail_once(void *user_data, const double *instance, const double *theta,
                                critreg_outcome *outcome)
{
    failing *state = (failing *)user_data;
    if (state->calls++ == state->at) {
        state->theta = theta[0];
        return state->status;
    }
    return reach(NULL, instance, theta, outcome);
}

static void failing_simulators(void)
{
    static const critreg_status statuses[] = {CRITREG_USER_STATUS, CRITREG_USER_STATUS + 42,
                                              CRITREG_CANCELLED, CRITREG_BUSY, -1, INT32_MIN};
    size_t s;
    int at;
    for (s = 0; s < sizeof statuses / sizeof *statuses; s++) {
        for (at = 0; at < SAMPLES; at++) {
            critreg_learner *learner = reach_learner(memory, sizeof memory);
            const critreg_region *region = NULL;
            failing state = {0, at, statuses[s], 0.0};
            double theta;
            size_t instance;
            char why[128], expected[128];
            critreg_report report;

            EXPECT(statuses[s], critreg_learn_region(learner, WALLS, INSTANCES, fail_once, &state,
                                                     &region));
            EXPECT_TRUE(region == NULL);
            sprintf(expected, "simulate returned status %d", (int)statuses[s]);
            OK(critreg_learner_message(learner, why, sizeof why, NULL));
            EXPECT_TRUE(strcmp(why, expected) == 0);
            OK(critreg_report_init(&report, sizeof report));
            OK(critreg_learner_report(learner, &report));
            EXPECT_TRUE(report.calls == (uint64_t)at);
            OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
            EXPECT_TRUE(theta == state.theta);
            expect_usable(learner);
        }
    }
}

static void wrong_pointers(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    const critreg_region *region;

    EXPECT(CRITREG_NULL_POINTER,
           critreg_learn_region(learner, WALLS, INSTANCES, NULL, NULL, &region));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learn_region(learner, NULL, INSTANCES, reach, NULL, &region));
    EXPECT(CRITREG_MISALIGNED, critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL,
                                                    ASKEW(const critreg_region *, memory)));
    expect_usable(learner);
}

/* Calls everything on its own learner. */
static critreg_status call_back(void *user_data, const double *instance, const double *theta,
                                critreg_outcome *outcome)
{
    critreg_learner *learner = *(critreg_learner **)user_data;
    const critreg_region *region;
    critreg_report report;
    size_t index, needed;
    double other;
    int32_t finished;
    uint8_t bytes[64];
    char text[128];

    EXPECT(CRITREG_BUSY, critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
    EXPECT(CRITREG_BUSY, critreg_ask(learner, WALLS, INSTANCES, &index, &other));
    EXPECT(CRITREG_BUSY, critreg_tell(learner, WALLS, INSTANCES, CRITREG_FEASIBLE));
    EXPECT(CRITREG_BUSY, critreg_learner_region(learner, &region));
    EXPECT(CRITREG_BUSY, critreg_learner_save(learner, WALLS, INSTANCES, bytes, 64, &needed));
    EXPECT(CRITREG_BUSY, critreg_learner_resume(learner, WALLS, INSTANCES, bytes, 64));
    /* What only reads is allowed. */
    OK(critreg_is_finished(learner, &finished));
    EXPECT_TRUE(finished == 0);
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    OK(critreg_learner_message(learner, text, sizeof text, NULL));
    OK(critreg_learner_instance_len(learner, &index));
    EXPECT_TRUE(index == 2);
    OK(critreg_learner_parameter_count(learner, &index));
    EXPECT_TRUE(index == 1);
    return reach(NULL, instance, theta, outcome);
}

static void re_entry(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);

    OK(critreg_learn_region(learner, WALLS, INSTANCES, call_back, &learner, NULL));
    expect_usable(learner);
}

/* Cancels once, after a number of samples. */
typedef struct {
    uint64_t after, calls;
    int32_t cancelled;
} cancelling;

/* Only one learner tries manual samples. */
static uint64_t never(uint64_t call)
{
    return kind == CRITREG_ALGORITHM1 ? call : UINT64_MAX;
}

static critreg_status cancel(void *progress_data, const critreg_report *report)
{
    cancelling *state = (cancelling *)progress_data;
    EXPECT_TRUE(report->struct_size == sizeof *report);
    EXPECT_TRUE(report->calls == ++state->calls);
    EXPECT_TRUE(report->feasible + report->infeasible == report->calls && report->unknown == 0);
    EXPECT_TRUE(report->certificate_feasible <= report->certificate_draws);
    EXPECT_TRUE((report->after_negative == CRITREG_NOT_RUN) == (report->calls < never(1)));
    EXPECT_TRUE((report->after_positive == CRITREG_NOT_RUN) == (report->calls < never(2)));
    if (state->calls != state->after || state->cancelled)
        return CRITREG_OK;
    state->cancelled = 1;
    return CRITREG_CANCELLED;
}

static void cancellation(void)
{
    uint64_t after;
    for (after = 1; after <= (uint64_t)SAMPLES; after++) {
        cancelling state = {after, 0, 0};
        critreg_config config = reach_config();
        critreg_learner *learner;
        const critreg_region *region = NULL;
        char why[128];

        config.progress = cancel;
        config.progress_data = &state;
        OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
        EXPECT(CRITREG_CANCELLED,
               critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
        EXPECT_TRUE(region == NULL);
        OK(critreg_learner_message(learner, why, sizeof why, NULL));
        EXPECT_TRUE(strcmp(why, "progress returned status 15") == 0);
        expect_usable(learner);
        EXPECT_TRUE(state.calls == (uint64_t)SAMPLES);
    }
}

static void tests(void)
{
    failing_simulators();
    wrong_pointers();
    re_entry();
    cancellation();
}

int main(void)
{
    with_each_learner(tests);
    return summary();
}
