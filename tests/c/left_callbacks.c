/* Callbacks that are left by longjmp(), which the manual forbids: the handle is found busy,
 * recovered, and as good as before. */
#include <setjmp.h>

#include "expect.h"
#include "walk.h"

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t planner_memory[CRITREG_PLANNER_WORDS(STATE)];
static jmp_buf out;
static int left_in;

static critreg_status leave_once(void *user_data, const double *instance, const double *theta,
                                 critreg_outcome *outcome)
{
    if (left_in-- == 0)
        longjmp(out, 1);
    return reach(user_data, instance, theta, outcome);
}

static critreg_status leave_progress(void *progress_data, const critreg_report *report)
{
    (void)progress_data, (void)report;
    if (left_in-- == 0)
        longjmp(out, 1);
    return CRITREG_OK;
}

/* The volatile keeps them over a longjmp(). */
static void leave_learner(int at, int in_progress)
{
    critreg_config config = reach_config();
    critreg_learner *volatile learner;
    critreg_learner *made;
    const critreg_region *region;
    size_t instance;
    double theta;

    config.progress = in_progress ? leave_progress : NULL;
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &made));
    learner = made;
    left_in = at;
    if (setjmp(out) == 0) {
        critreg_learn_region(made, WALLS, INSTANCES, in_progress ? reach : leave_once, NULL,
                             &region);
        EXPECT_TRUE(!"it was left");
    }
    EXPECT(CRITREG_BUSY, critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    OK(critreg_learner_recover(learner));
    expect_usable(learner);
    OK(critreg_learner_recover(learner));
    left_in = -1;
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
}

static void leave_learners(void)
{
    int at;
    for (at = 0; at < SAMPLES; at++) {
        leave_learner(at, 0);
        leave_learner(at, 1);
    }
}

static critreg_status leave_planner(void *user_data, const critreg_ground *ground,
                                    const double *parameters, const double *before,
                                    double *after, size_t len, uint32_t *actions)
{
    if (left_in-- == 0)
        longjmp(out, 1);
    return all_callbacks().execute(user_data, ground, parameters, before, after, len, actions);
}

static void leave_planners(void)
{
    static critreg_planner *planner;
    static size_t expected, length;
    static int at;
    walker own = CALM;
    critreg_callbacks callbacks = all_callbacks();

    planner = walk_planner(planner_memory, sizeof planner_memory);
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, &expected));
    for (at = 0; at < (int)expected; at++) {
        walker one = CALM, other = CALM;
        callbacks.execute = leave_planner;
        left_in = at;
        if (setjmp(out) == 0) {
            critreg_plan(planner, &callbacks, DARK, 1, &one, &length);
            EXPECT_TRUE(!"it was left");
        }
        EXPECT(CRITREG_BUSY, critreg_plan(planner, &callbacks, DARK, 1, &other, &length));
        OK(critreg_planner_recover(planner));
        left_in = -1;
        OK(critreg_plan(planner, &callbacks, DARK, 1, &other, &length));
        EXPECT_TRUE(length == expected);
    }
}

static void wrong_handles(void)
{
    static uint64_t nothing[8];
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_recover(NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_recover(NULL));
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_learner_recover((critreg_learner *)nothing));
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_planner_recover((critreg_planner *)nothing));
}

int main(void)
{
    with_each_learner(leave_learners);
    leave_planners();
    wrong_handles();
    return summary();
}
