/* Parameters reach execute as they were drawn: doubles, within their ranges. */
#include "expect.h"

static const char DOMAIN_TEXT[] =
    "(define (domain site)\n"
    "  (:types rover)\n"
    "  (:predicates (AtMark ?r - rover))\n"
    "  (:action Drive :parameters (?r - rover) :effect (AtMark ?r)))";
static const char PROBLEM_TEXT[] =
    "(define (problem reach) (:domain site) (:objects rover - rover)\n"
    "  (:init) (:goal (AtMark rover)))";

static uint64_t memory[CRITREG_PLANNER_WORDS(1)];

/* Makes a planner with these ranges of Drive, for plans of one step. */
static critreg_planner *planner_for(const double *ranges, size_t count)
{
    critreg_planner_config config;
    critreg_planner *planner = NULL;
    OK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = 1;
    config.max_length = 1;
    config.max_tries = 1000;
    OK(critreg_planner_init(memory, sizeof memory, DOMAIN_TEXT, PROBLEM_TEXT, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Drive", ranges, count));
    return planner;
}

/* A rover on a survey grid (UTM): its northing in metres. A float of that size knows
 * quarters of a metre. */
static const double MARK = 3948996.125, TOLERANCE = 0.1;

static critreg_status drive(void *user_data, const critreg_ground *ground,
                            const double *parameters, const double *before, double *after,
                            size_t len, uint32_t *actions)
{
    (void)user_data, (void)ground, (void)before, (void)len;
    after[0] = parameters[0];
    *actions = 1;
    return CRITREG_OK;
}

static critreg_status is_at_mark(void *user_data, const critreg_ground *ground,
                                 const double *state, size_t len, int32_t *holds)
{
    (void)user_data, (void)ground, (void)len;
    *holds = fabs(state[0] - MARK) <= TOLERANCE;
    return CRITREG_OK;
}

static void reaches_the_mark(void)
{
    static const double metres[2] = {3948990.0, 3949000.0}, start = 3948000.0;
    critreg_planner *planner = planner_for(metres, 1);
    critreg_callbacks callbacks;
    uint32_t seed;
    EXPECT_TRUE(fabs((float)MARK - MARK) > TOLERANCE);
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = drive;
    callbacks.holds = is_at_mark;
    for (seed = 0; seed < 10; seed++) {
        critreg_step step;
        size_t length = 0;
        OK(critreg_plan(planner, &callbacks, &start, seed, NULL, &length));
        EXPECT_TRUE(length == 1);
        OK(critreg_step_init(&step, sizeof step));
        OK(critreg_planner_step(planner, 0, &step));
        EXPECT_TRUE(step.parameter_count == 1 && step.parameters[0] == step.state[0]);
        EXPECT_TRUE(fabs(step.state[0] - MARK) <= TOLERANCE);
    }
}

static const double PI = 3.14159265358979323846;

/* What was drawn last, and how often. */
typedef struct {
    double ranges[2][2], drawn[2];
    uint32_t draws;
} dial;

/* The corners of the parameter space first, then anything in it. */
static critreg_status corners_first(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                                    critreg_drawn *drawn)
{
    dial *own = (dial *)user_data;
    size_t i;
    EXPECT_TRUE(draw->parameter_count == 2);
    for (i = 0; i < 2; i++) {
        const double *range = own->ranges[i];
        double share = own->draws >> i & 1;
        if (own->draws >= 4)
            OK(critreg_rng_uniform(rng, &share));
        own->drawn[i] = share == 1.0 ? range[1] : range[0] + share * (range[1] - range[0]);
        drawn->parameters[i] = own->drawn[i];
    }
    own->draws++;
    return CRITREG_OK;
}

/* Never arrives, and looks at its parameters. */
static critreg_status turn(void *user_data, const critreg_ground *ground,
                           const double *parameters, const double *before, double *after,
                           size_t len, uint32_t *actions)
{
    const dial *own = (const dial *)user_data;
    size_t i;
    (void)ground, (void)before, (void)after, (void)len;
    for (i = 0; i < 2; i++) {
        EXPECT_TRUE(own->ranges[i][0] <= parameters[i] && parameters[i] <= own->ranges[i][1]);
        EXPECT_TRUE(own->draws == 0
                    || memcmp(&parameters[i], &own->drawn[i], sizeof *parameters) == 0);
    }
    *actions = 1;
    return CRITREG_OK;
}

static critreg_status never(void *user_data, const critreg_ground *ground, const double *state,
                            size_t len, int32_t *holds)
{
    (void)user_data, (void)ground, (void)state, (void)len;
    *holds = 0;
    return CRITREG_OK;
}

static void stays_within_its_range(critreg_sample sample)
{
    dial own = {{{-PI, PI}, {0.0, 0.1}}, {0.0, 0.0}, 0};
    critreg_planner *planner = planner_for(own.ranges[0], 2);
    critreg_callbacks callbacks;
    critreg_metrics metrics;
    const double start = 0.0;
    size_t length = 0;
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = turn;
    callbacks.holds = never;
    callbacks.sample = sample;
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, &start, 1, &own, &length));
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    OK(critreg_planner_metrics(planner, &metrics));
    EXPECT_TRUE(metrics.samples == 1000 && own.draws == (sample == NULL ? 0 : 1000));
}

int main(void)
{
    reaches_the_mark();
    stays_within_its_range(corners_first);
    stays_within_its_range(NULL);
    return summary();
}
