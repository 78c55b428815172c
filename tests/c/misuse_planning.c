/* Wrong calls of critreg_plan(), callbacks that fail or answer nonsense, what the
 * metrics tell. */
#include "walk.h"

static uint64_t memory[CRITREG_PLANNER_WORDS(STATE)];
static const double UNIT[2] = {0.0, 1.0};

static critreg_metrics metrics_of(const critreg_planner *planner)
{
    critreg_metrics metrics;
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    OK(critreg_planner_metrics(planner, &metrics));
    return metrics;
}

static void expect_message(const critreg_planner *planner, const char *expected)
{
    char words[128] = "";
    OK(critreg_planner_message(planner, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, expected) == 0);
}

static void wrong_arguments(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks(), wrong;
    const double at_b[STATE] = {1.0, 0.0, 0.0}, lit[STATE] = {0.0, 0.0, 1.0};
    size_t length = 77;
    walker own = CALM;

    EXPECT(CRITREG_NULL_POINTER, critreg_plan(planner, NULL, DARK, 1, &own, &length));
    EXPECT(CRITREG_MISALIGNED, critreg_plan(planner, ASKEW(critreg_callbacks, memory), DARK, 1,
                                            &own, &length));
    EXPECT(CRITREG_NULL_POINTER, critreg_plan(planner, &callbacks, NULL, 1, &own, &length));
    EXPECT(CRITREG_MISALIGNED,
           critreg_plan(planner, &callbacks, ASKEW(double, DARK), 1, &own, &length));
    EXPECT(CRITREG_MISALIGNED,
           critreg_plan(planner, &callbacks, DARK, 1, &own, ASKEW(size_t, &length)));
    wrong = callbacks;
    wrong.struct_size = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_plan(planner, &wrong, DARK, 1, &own, &length));
    wrong = callbacks;
    wrong.execute = NULL;
    EXPECT(CRITREG_NULL_POINTER, critreg_plan(planner, &wrong, DARK, 1, &own, &length));
    expect_message(planner, "execute is NULL");
    wrong = callbacks;
    wrong.holds = NULL;
    EXPECT(CRITREG_NULL_POINTER, critreg_plan(planner, &wrong, DARK, 1, &own, &length));
    EXPECT_TRUE(own.executes == 0 && length == 77);
    EXPECT(CRITREG_MISMATCH, critreg_plan(planner, &callbacks, at_b, 1, &own, &length));
    expect_message(planner, "initial state and :init do not agree about an atom: (At a)");
    EXPECT(CRITREG_MISMATCH, critreg_plan(planner, &callbacks, lit, 1, &own, &length));
    expect_message(planner, "initial state and :init do not agree about an atom: (Lit b)");
    EXPECT_TRUE(metrics_of(planner).conclusion == CRITREG_NOT_PLANNED);
    EXPECT(CRITREG_NULL_POINTER, critreg_plan(planner, NULL, DARK, 1, &own, &length));
    expect_message(planner, "callbacks is NULL");
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_callbacks_init(&wrong, sizeof wrong - 1));
    EXPECT(CRITREG_NULL_POINTER, critreg_callbacks_init(NULL, sizeof wrong));
    EXPECT_TRUE(length == 77);
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    expect_plan(planner);
}

static void wrong_readers(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_metrics metrics;
    critreg_step step;
    uint32_t count = 77;
    char words[4];
    size_t needed = 0;

    OK(critreg_step_init(&step, sizeof step));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_step(planner, 0, &step));
    EXPECT_TRUE(metrics_of(planner).conclusion == CRITREG_NOT_PLANNED);
    expect_plan(planner);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_step(planner, 2, &step));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_step(planner, SIZE_MAX, &step));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_step(planner, 0, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_planner_step(planner, 0, ASKEW(critreg_step, memory)));
    step.struct_size = 1;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_step(planner, 0, &step));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_step_init(&step, 0));
    EXPECT(CRITREG_NULL_POINTER, critreg_step_init(NULL, sizeof step));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_metrics_init(&metrics, sizeof metrics + 8));
    EXPECT(CRITREG_NULL_POINTER, critreg_metrics_init(NULL, sizeof metrics));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_metrics(planner, NULL));
    metrics.struct_size = 1;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_metrics(planner, &metrics));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_failures(planner, NULL, &count));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_failures(planner, "Walk", NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_failures(planner, "Run", &count));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_planner_reasons(planner, CRITREG_MAX_REASONS, &count));
    EXPECT(CRITREG_MISALIGNED, critreg_planner_reasons(planner, 0, ASKEW(uint32_t, memory)));
    EXPECT_TRUE(count == 77);
    EXPECT(CRITREG_TOO_SMALL, critreg_planner_message(planner, words, sizeof words, &needed));
    EXPECT_TRUE(needed > sizeof words);
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_message(planner, NULL, 4, NULL));
}

/* Each callback fails once, in each of its calls. */
static void failing_callbacks(void)
{
    static const critreg_status statuses[] = {CRITREG_CANCELLED, CRITREG_USER_STATUS + 7, -1};
    static const char *const names[] = {"execute", "holds", "sample", "advise"};
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks();
    walker calm = CALM;
    size_t s;
    int callback, at;

    OK(critreg_plan(planner, &callbacks, DARK, 1, &calm, NULL));
    for (s = 0; s < 3; s++)
        for (callback = 0; callback < 4; callback++) {
            int calls = callback == 0 ? calm.executes : callback == 1 ? calm.holds
                        : callback == 2 ? calm.samples : calm.advices;
            EXPECT_TRUE(calls > 1);
            for (at = 0; at < calls; at++) {
                walker own = CALM;
                char expected[64];
                size_t length = 77;
                *(callback == 0 ? &own.fail_execute : callback == 1 ? &own.fail_holds
                  : callback == 2 ? &own.fail_sample : &own.fail_advise) = at;
                own.status = statuses[s];
                EXPECT(statuses[s], critreg_plan(planner, &callbacks, DARK, 1, &own, &length));
                EXPECT_TRUE(length == 77);
                sprintf(expected, "%s returned status %d", names[callback], (int)statuses[s]);
                expect_message(planner, expected);
                EXPECT_TRUE(metrics_of(planner).conclusion == CRITREG_STOPPED);
                expect_plan(planner);
            }
        }
}

/* Answers that are none. */
static int32_t wrong_truth;
static double wrong_speed;
static critreg_advice wrong_advice;

static critreg_status so_to_speak(void *user_data, const critreg_ground *ground,
                                  const double *state, size_t len, int32_t *holds)
{
    critreg_status status = is_so(user_data, ground, state, len, holds);
    if (((walker *)user_data)->holds == 6)
        *holds = wrong_truth;
    return status;
}

static critreg_status wrong_draw(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                                 critreg_drawn *drawn)
{
    (void)user_data;
    (void)draw;
    (void)rng;
    drawn->parameters[0] = wrong_speed;
    return CRITREG_OK;
}

static critreg_status draw_nothing(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                                   critreg_drawn *drawn)
{
    (void)user_data;
    (void)draw;
    (void)rng;
    (void)drawn;
    return CRITREG_OK;
}

static critreg_status advise_wrongly(void *user_data, const critreg_ground *prefix,
                                     size_t length, const double *initial, size_t len,
                                     critreg_advice *advice, uint32_t *reason)
{
    (void)user_data;
    (void)prefix;
    (void)length;
    (void)initial;
    (void)len;
    (void)reason;
    *advice = wrong_advice;
    return CRITREG_OK;
}

static void nonsense(void)
{
    static const int32_t truths[] = {-1, 2, INT32_MAX};
    static const double speeds[] = {-0.001, 1.001};
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks();
    walker own;
    size_t i;

    callbacks.holds = so_to_speak;
    for (i = 0; i < 3; i++) {
        own = CALM;
        wrong_truth = truths[i];
        EXPECT(CRITREG_INVALID_ARGUMENT, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
        expect_message(planner, "holds wrote neither 0 nor 1");
    }
    callbacks = all_callbacks();
    callbacks.sample = wrong_draw;
    for (i = 0; i < 2; i++) {
        own = CALM;
        wrong_speed = speeds[i];
        EXPECT(CRITREG_INVALID_ARGUMENT, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
        expect_message(planner, "sample drew a parameter outside of its range");
    }
    callbacks.sample = draw_nothing;
    EXPECT(CRITREG_NOT_FINITE, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    callbacks = all_callbacks();
    callbacks.advise = advise_wrongly;
    for (wrong_advice = -1; wrong_advice < 4; wrong_advice += 4) {
        own = CALM;
        EXPECT(CRITREG_INVALID_ARGUMENT, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
        expect_message(planner, "advise wrote no advice that there is");
    }
    expect_plan(planner);
}

/* Calls everything on the planner that is planning. */
static critreg_planner *planning;

static critreg_status call_back(void *user_data, const critreg_ground *ground,
                                const double *parameters, const double *before, double *after,
                                size_t len, uint32_t *actions)
{
    critreg_callbacks callbacks = all_callbacks();
    critreg_step step;
    uint32_t count;
    char words[128];

    EXPECT(CRITREG_BUSY, critreg_plan(planning, &callbacks, DARK, 1, user_data, NULL));
    EXPECT(CRITREG_BUSY, critreg_planner_set_ranges(planning, "Walk", NULL, 0));
    EXPECT(CRITREG_BUSY, critreg_planner_failures(planning, "Walk", &count));
    EXPECT(CRITREG_BUSY, critreg_planner_reasons(planning, 0, &count));
    OK(critreg_step_init(&step, sizeof step));
    EXPECT(CRITREG_BUSY, critreg_planner_step(planning, 0, &step));
    /* What only reads is allowed. */
    EXPECT_TRUE(metrics_of(planning).conclusion == CRITREG_NOT_PLANNED);
    OK(critreg_planner_message(planning, words, sizeof words, NULL));
    return walk(user_data, ground, parameters, before, after, len, actions);
}

static void re_entry(void)
{
    critreg_callbacks callbacks = all_callbacks();
    walker own = CALM;
    size_t length = 0;

    planning = walk_planner(memory, sizeof memory);
    callbacks.execute = call_back;
    OK(critreg_plan(planning, &callbacks, DARK, 1, &own, &length));
    EXPECT_TRUE(length == 2);
    expect_plan(planning);
}

static uint32_t failures_of(critreg_planner *planner, const char *name)
{
    uint32_t count = 77;
    OK(critreg_planner_failures(planner, name, &count));
    return count;
}

static uint32_t given(critreg_planner *planner, uint32_t reason)
{
    uint32_t count = 77;
    OK(critreg_planner_reasons(planner, reason, &count));
    return count;
}

/* Walks are too slow to work. */
static void no_plan(void)
{
    static const double slow[2] = {0.0, 0.4};
    critreg_planner *planner;
    critreg_planner_config config = walk_config();
    critreg_callbacks callbacks = all_callbacks();
    critreg_metrics metrics;
    critreg_step step;
    walker own = CALM;
    size_t length = 77;

    config.max_skeletons = 3;
    config.max_tries = 4;
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Walk", slow, 1));
    callbacks.sample = NULL;
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, DARK, 1, &own, &length));
    expect_message(planner, "no plan: max_skeletons were refined in vain");
    EXPECT_TRUE(length == 77);
    metrics = metrics_of(planner);
    EXPECT_TRUE(metrics.conclusion == CRITREG_SKELETONS_SPENT && metrics.skeletons == 3);
    EXPECT_TRUE(metrics.plan_length == 0 && metrics.samples == (uint32_t)own.executes);
    EXPECT_TRUE(metrics.most_failed != NULL && strcmp(metrics.most_failed, "Walk") == 0);
    EXPECT_TRUE(failures_of(planner, "walk") == metrics.samples - metrics.actions);
    EXPECT_TRUE(failures_of(planner, "Light") == 0);
    EXPECT_TRUE(metrics.pruned > 0 && metrics.main_reason == 3);
    EXPECT_TRUE(given(planner, 3) == metrics.pruned && given(planner, 2) == 0);
    OK(critreg_step_init(&step, sizeof step));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_step(planner, 0, &step));
    OK(critreg_planner_set_ranges(planner, "Walk", NULL, 0));

    /* Full memory, spent samples. */
    config.nodes = 2;
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    EXPECT_TRUE(metrics_of(planner).conclusion == CRITREG_MEMORY_FULL);
    expect_message(planner, "no room left: nodes of the search");
    config = walk_config();
    config.max_samples = 5;
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Walk", slow, 1));
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    metrics = metrics_of(planner);
    EXPECT_TRUE(metrics.conclusion == CRITREG_SAMPLES_SPENT && metrics.samples == 5);
    config = walk_config();
    config.max_length = 1;
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    EXPECT_TRUE(metrics_of(planner).conclusion == CRITREG_LENGTH_SPENT);
}

/* Wrong knowledge, with a reason: it costs effort, but no plan. */
static critreg_status nowhere(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                              critreg_drawn *drawn)
{
    if (draw->advised && draw->parameter_count > 0) {
        drawn->reason = 5;
        return CRITREG_EMPTY_REGION;
    }
    return any_speed(user_data, draw, rng, drawn);
}

static critreg_status against_walks(void *user_data, const critreg_ground *prefix,
                                    size_t length, const double *initial, size_t len,
                                    critreg_advice *advice, uint32_t *reason)
{
    (void)user_data;
    (void)initial;
    (void)len;
    if (prefix[length - 1].index == 0) {
        *advice = CRITREG_POSTPONE;
        *reason = 70;   /* beyond those that are counted */
    }
    return CRITREG_OK;
}

static critreg_status fast(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                           critreg_drawn *drawn)
{
    drawn->informed = 1;
    drawn->parameters[0] = 0.75;
    (void)user_data;
    (void)draw;
    (void)rng;
    return CRITREG_OK;
}

/* As critreg_sample_region() may: nothing was found in the first try of a step. */
static critreg_status at_second_try(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                                    critreg_drawn *drawn)
{
    if (draw->parameter_count > 0 && draw->attempt == 1)
        return CRITREG_NO_SAMPLE;
    return fast(user_data, draw, rng, drawn);
}

static critreg_status never(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                            critreg_drawn *drawn)
{
    (void)user_data;
    (void)draw;
    (void)rng;
    (void)drawn;
    return CRITREG_NO_SAMPLE;
}

static void nothing_found(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks();
    critreg_metrics metrics;
    walker own = CALM;

    callbacks.sample = at_second_try;
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    EXPECT_TRUE(metrics_of(planner).samples == 3 && own.executes == 2);
    callbacks.sample = never;
    own = CALM;
    EXPECT_TRUE(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL) != CRITREG_OK);
    metrics = metrics_of(planner);
    EXPECT_TRUE(metrics.samples > 0 && metrics.empty_draws == 0 && own.executes == 0);
}

static void expect_why(const critreg_planner *planner, uint32_t expected, const char *sentence)
{
    char words[256] = "";
    uint32_t why = 77;
    size_t needed = 0;
    OK(critreg_planner_why(planner, &why, words, sizeof words, &needed));
    EXPECT_TRUE(why == expected && needed == strlen(words) + 1);
    EXPECT_TRUE(strcmp(words, sentence) == 0);
    if (strcmp(words, sentence) != 0)
        puts(words);
}

/* A code and a sentence for what stood in the way. */
static void why_no_plan(void)
{
    static const char TO_ROOF[] =
        "(define (problem p) (:domain walk) (:objects a b - place) (:init) (:goal (Lit b)))";
    critreg_planner_config config = walk_config();
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks();
    const double nowhere_at[STATE] = {-1.0, 0.0, 0.0};
    uint32_t why = 0;
    walker own = CALM;

    expect_why(planner, CRITREG_WHY_NOTHING, "");
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    expect_why(planner, CRITREG_WHY_NOTHING, "");
    own = CALM;
    own.fail_execute = 0;
    own.status = CRITREG_CANCELLED;
    EXPECT(CRITREG_CANCELLED, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    expect_why(planner, CRITREG_WHY_STOPPED, "a callback stopped planning");
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_why(NULL, &why, NULL, 0, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_why(planner, NULL, NULL, 0, NULL));

    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_ROOF, &config, &planner));
    own = CALM;
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, nowhere_at, 1, &own, NULL));
    expect_why(planner, CRITREG_WHY_UNREACHABLE,
               "the goal cannot be reached: nothing reaches (At b), as Walk needs (At ?from)");
    EXPECT(CRITREG_TOO_SMALL, critreg_planner_why(planner, &why, NULL, 0, NULL));
    EXPECT_TRUE(why == CRITREG_WHY_UNREACHABLE);

    config.max_skeletons = 3;
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Walk", UNIT, 1));
    callbacks.sample = never;
    own = CALM;
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    expect_why(planner, CRITREG_WHY_TRIES,
               "3 skeletons were given up after 10 tries of a step, most often of Walk, with 12 "
               "of 10000 samples: raise max_tries");
}

static void knowledge(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_callbacks callbacks = all_callbacks();
    critreg_metrics metrics;
    walker own = CALM;

    callbacks.sample = nowhere;
    callbacks.advise = NULL;
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    metrics = metrics_of(planner);
    EXPECT_TRUE(metrics.patience_ended && metrics.empty_draws > 0);
    EXPECT_TRUE(given(planner, 5) == metrics.empty_draws && metrics.main_reason == 5);
    callbacks = all_callbacks();
    callbacks.advise = against_walks;
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    metrics = metrics_of(planner);
    EXPECT_TRUE(metrics.patience_ended && metrics.postponed > 0);
    EXPECT_TRUE(metrics.uncounted == metrics.postponed);
    EXPECT_TRUE(metrics.main_reason == CRITREG_NO_REASON);
    callbacks = all_callbacks();
    callbacks.sample = fast;
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
    metrics = metrics_of(planner);
    EXPECT_TRUE(!metrics.patience_ended && metrics.informed_draws == 2 && metrics.samples == 2);
    EXPECT_TRUE(metrics.most_failed == NULL && metrics.actions == 3);
}

int main(void)
{
    wrong_arguments();
    wrong_readers();
    failing_callbacks();
    nonsense();
    re_entry();
    no_plan();
    nothing_found();
    why_no_plan();
    knowledge();
    return summary();
}
