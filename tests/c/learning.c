/* What the version space tells a C program: chains, noise, the certificate. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS_FOR(1024, 512, INSTANCES, 2)];

static critreg_learner *learner_for(uint32_t steps, uint32_t calls, double noise)
{
    critreg_config config = reach_config();
    critreg_learner *learner = NULL;
    config.steps = steps;
    config.calls = calls;
    config.observations = 512;
    config.instances = INSTANCES;
    config.noise = noise;
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
    return learner;
}

/* First the hand must not touch the wall, then it must be beyond 0.5. */
static critreg_status reach_then_lift(void *user_data, const double *instance,
                                      const double *theta, critreg_outcome *outcome)
{
    (void)user_data;
    if (theta[0] > instance[0] - 0.1)
        *outcome = CRITREG_FAILED_STEP(1);
    else
        *outcome = theta[0] >= 0.5 ? CRITREG_FEASIBLE : CRITREG_FAILED_STEP(2);
    return CRITREG_OK;
}

static void chain(void)
{
    critreg_learner *learner = learner_for(2, 100, 0.0);
    const critreg_region *region = NULL;
    size_t count = 0, i;
    int32_t inside;
    int seen[3] = {0, 0, 0};
    const double samples[] = {0.55, 0.89, 0.45, 0.95}, wall[] = {1.0, 0.0};

    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach_then_lift, NULL, &region));
    OK(critreg_region_constraint_count(region, &count));
    for (i = 0; i < count; i++) {
        critreg_constraint constraint;
        OK(critreg_constraint_init(&constraint, sizeof constraint));
        OK(critreg_region_constraint(region, i, &constraint));
        EXPECT_TRUE(constraint.step == 1 || constraint.step == 2);
        EXPECT_TRUE(constraint.support > 0);
        seen[constraint.step % 3]++;
    }
    EXPECT_TRUE(seen[1] > 0 && seen[2] > 0);
    for (i = 0; i < 4; i++) {
        OK(critreg_region_contains(region, wall, &samples[i], &inside));
        EXPECT_TRUE(inside == (i < 2));
    }
}

/* A source of a hundred walls, of which one is far away from all others. */
static critreg_status make_wall(void *user_data, size_t number, double *instance)
{
    if (user_data != NULL && number == 50)
        return *(critreg_status *)user_data;
    instance[0] = 1.0 + 0.02 * (double)number;
    instance[1] = number == 77 ? 9.0 : 0.0;
    return CRITREG_OK;
}

static void source(void)
{
    critreg_learner *learner = learner_for(1, 40, 0.0);
    const critreg_region *region = NULL;
    critreg_status stop = CRITREG_CANCELLED;
    double walls[2 * 8], again[2 * 8];
    size_t count = 0, i, far = 0;
    char text[64] = "";

    EXPECT(CRITREG_CANCELLED,
           critreg_choose_instances(learner, 100, make_wall, &stop, walls, 8, &count));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_choose_instances(learner, 0, make_wall, NULL, walls, 8, &count));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_choose_instances(learner, 100, make_wall, NULL, walls, 0, &count));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_choose_instances(learner, 100, NULL, NULL, walls, 8, &count));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_choose_instances(learner, 100, make_wall, NULL, NULL, 8, &count));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_choose_instances(learner, 100, make_wall, NULL, walls, 8, NULL));
    EXPECT_TRUE(count == 0);
    OK(critreg_choose_instances(learner, 100, make_wall, NULL, walls, 8, &count));
    /* The configuration has room for no more. */
    EXPECT_TRUE(count == INSTANCES);
    OK(critreg_choose_instances(learner, 100, make_wall, NULL, again, 8, &count));
    for (i = 0; i < count; i++) {
        EXPECT_TRUE(again[2 * i] == walls[2 * i] && again[2 * i + 1] == walls[2 * i + 1]);
        far += walls[2 * i + 1] == 9.0;
    }
    EXPECT_TRUE(far == 1);
    OK(critreg_learn_region(learner, walls, count, reach, NULL, &region));
    OK(critreg_region_format(region, text, sizeof text, NULL));
    EXPECT_TRUE(strcmp(text, "reach - wall.x <= -0.1 (-hand.radius)") == 0);
    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_choose_instances(learner, 100, make_wall, NULL, walls, 8, &count));
}

/* Every tenth answer is wrong, as it happens. */
static critreg_status reach_mostly(void *user_data, const double *instance, const double *theta,
                                   critreg_outcome *outcome)
{
    critreg_rng *rng = (critreg_rng *)user_data;
    double share;
    OK(critreg_rng_uniform(rng, &share));
    OK(reach(NULL, instance, theta, outcome));
    if (share < 0.1)
        *outcome = *outcome == CRITREG_FEASIBLE ? CRITREG_INFEASIBLE : CRITREG_FEASIBLE;
    return CRITREG_OK;
}

static void noise(void)
{
    critreg_learner *learner = learner_for(1, 500, 0.1);
    const critreg_region *region = NULL;
    critreg_rng rng = critreg_rng_seed(3);
    critreg_report report;
    int32_t inside;
    double theta;
    int wrong = 0, i;

    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach_mostly, &rng, &region));
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == 500);
    EXPECT_TRUE(report.feasible + report.infeasible < 200);
    for (i = 0; i < 400; i++) {
        critreg_outcome outcome;
        theta = 0.01 * i;
        OK(critreg_region_contains(region, WALLS + 4, &theta, &inside));
        OK(reach(NULL, WALLS + 4, &theta, &outcome));
        wrong += inside != (outcome == CRITREG_FEASIBLE);
    }
    EXPECT_TRUE(wrong < 8);
}

static void certificate(void)
{
    critreg_learner *learner = learner_for(1, 100, 0.0);
    critreg_report report;

    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.certificate_draws == 0 && report.certificate_lower_bound == 0.0);
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, NULL));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == 100 && report.kept > 0 && report.remaining == report.kept);
    EXPECT_TRUE(report.certificate_draws > 0 && report.certificate_draws <= 10);
    EXPECT_TRUE(report.certificate_feasible == report.certificate_draws);
    EXPECT_TRUE(report.certificate_lower_bound > 0.0 && report.certificate_lower_bound < 1.0);
}

/* Answers that are all alike make a region of everything, a coin makes none. */
static critreg_status toss(void *user_data, const double *instance, const double *theta,
                           critreg_outcome *outcome)
{
    critreg_rng *rng = (critreg_rng *)user_data;
    double share = 0.0;
    (void)instance;
    (void)theta;
    if (rng != NULL)
        OK(critreg_rng_uniform(rng, &share));
    *outcome = share < 0.5 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
    return CRITREG_OK;
}

static void no_region(void)
{
    const critreg_region *region = NULL;
    critreg_learner *learner;
    critreg_rng rng = critreg_rng_seed(5);
    uint32_t quality, why;
    char words[CRITREG_WHY_MAX];
    size_t needed;

    learner = learner_for(1, 100, 0.0);
    OK(critreg_learner_why(learner, &why, words, sizeof words, &needed));
    EXPECT_TRUE(why == CRITREG_WHY_NOTHING_TOLD && needed == strlen(words) + 1);
    OK(critreg_learn_region(learner, WALLS, INSTANCES, toss, NULL, &region));
    OK(critreg_region_quality(region, &quality));
    EXPECT_TRUE(quality == CRITREG_EXACT);
    OK(critreg_learner_why(learner, &why, NULL, 0, NULL));
    EXPECT_TRUE(why == CRITREG_WHY_ALL_WORKED);

    region = NULL;
    learner = learner_for(1, 100, 0.0);
    EXPECT(CRITREG_NO_REGION,
           critreg_learn_region(learner, WALLS, INSTANCES, toss, &rng, &region));
    EXPECT_TRUE(region == NULL);
    OK(critreg_learner_why(learner, &why, words, sizeof words, NULL));
    EXPECT_TRUE(why == CRITREG_WHY_UNEXPLAINED || why == CRITREG_WHY_TOO_FEW);
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_why(learner, NULL, words, 4, NULL));
}

/* An action without parameters works where the wall is not too near. */
static critreg_status pass(void *user_data, const double *instance, const double *theta,
                           critreg_outcome *outcome)
{
    (void)user_data;
    (void)theta;
    *outcome = instance[0] >= 0.5 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
    return CRITREG_OK;
}

static void region_over_the_state(void)
{
    static const char state[] =
        "object wall { x: length, y: length }\nconstant door.width = 0.5: length\n";
    static double walls[40][2];
    static uint64_t words[CRITREG_LEARNER_WORDS_FOR(1024, 64, 40, 1)];
    const double near_wall[2] = {0.45, 0.0}, far_wall[2] = {0.55, 0.0};
    critreg_config config = reach_config();
    critreg_learner *learner = NULL;
    const critreg_region *region = NULL;
    critreg_rng rng = critreg_rng_seed(9);
    size_t count = 77, i;
    int32_t inside = 77;

    for (i = 0; i < 40; i++)
        OK(critreg_rng_uniform(&rng, &walls[i][0]));
    config.observations = 64;
    config.instances = 40;
    OK(critreg_learner_init(words, sizeof words, state, &config, &learner));
    OK(critreg_learner_parameter_count(learner, &count));
    EXPECT_TRUE(count == 0);
    OK(critreg_ask(learner, &walls[0][0], 40, &i, NULL));
    EXPECT_TRUE(i < 40);
    OK(critreg_learn_region(learner, &walls[0][0], 40, pass, NULL, &region));
    OK(critreg_region_contains(region, near_wall, NULL, &inside));
    EXPECT_TRUE(inside == 0);
    OK(critreg_region_contains(region, far_wall, NULL, &inside));
    EXPECT_TRUE(inside == 1);
}

/* A log of tries that nobody asked for. */
static void passive(void)
{
    critreg_learner *learner = learner_for(1, 0, 0.0);
    const critreg_region *region = NULL;
    critreg_report report;
    critreg_outcome outcome;
    double theta;
    size_t tried, instance;
    int32_t inside;
    const double samples[] = {0.85, 0.95}, wall[] = {1.0, 0.0};

    for (tried = 0; tried < 200; tried++) {
        instance = tried % INSTANCES;
        theta = 0.01 * (double)(tried * 37 % 100);
        outcome = theta <= WALLS[2 * instance] - 0.1;
        OK(critreg_observe(learner, WALLS, INSTANCES, instance, &theta, outcome));
    }
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_observe(learner, WALLS, INSTANCES, INSTANCES, &theta, CRITREG_FEASIBLE));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_observe(learner, WALLS, INSTANCES, 0, &theta, CRITREG_NO_OUTCOME));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_observe(learner, WALLS, INSTANCES, 0, NULL, CRITREG_FEASIBLE));
    theta = NAN;
    EXPECT(CRITREG_NOT_FINITE,
           critreg_observe(learner, WALLS, INSTANCES, 0, &theta, CRITREG_FEASIBLE));
    OK(critreg_conclude(learner, WALLS, INSTANCES));
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == 0 && report.observed == 200);
    OK(critreg_learner_region(learner, &region));
    for (tried = 0; tried < 2; tried++) {
        OK(critreg_region_contains(region, wall, &samples[tried], &inside));
        EXPECT_TRUE(inside == (tried == 0));
    }
}

/* A run whose machine stopped while the last record was written. */
static void journal(void)
{
    critreg_learner *learner = learner_for(1, 20, 0.0);
    static uint8_t bytes[20 * 42];
    critreg_report report;
    critreg_outcome outcome;
    size_t written, instance, needed, len = 0, stands = 0;
    double theta;

    for (written = 0; written < 10; written++) {
        OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
        outcome = theta <= WALLS[2 * instance] - 0.1;
        OK(critreg_tell(learner, WALLS, INSTANCES, outcome));
        OK(critreg_learner_journal(learner, WALLS, INSTANCES, written, bytes + len,
                                   sizeof bytes - len, &needed));
        EXPECT_TRUE(needed == 42);
        len += needed;
    }
    EXPECT(CRITREG_TOO_SMALL,
           critreg_learner_journal(learner, WALLS, INSTANCES, 0, bytes, len - 1, &needed));
    EXPECT_TRUE(needed == len);
    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_learner_resume_journal(learner, WALLS, INSTANCES, bytes, len, &stands));
    learner = learner_for(1, 40, 0.0);
    OK(critreg_learner_resume_journal(learner, WALLS, INSTANCES, bytes, len - 5, &stands));
    EXPECT_TRUE(stands == len - 42);
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == 9);
}

int main(void)
{
    chain();
    source();
    passive();
    journal();
    noise();
    certificate();
    no_region();
    region_over_the_state();
    return summary();
}
