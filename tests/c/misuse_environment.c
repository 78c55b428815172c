/* Wrong tasks, picks, actions and states of the built-in environment. */
#include "expect.h"

static uint64_t other[8];

static void wrong_tasks_and_picks(void)
{
    critreg_outcome outcome = 77;
    uint32_t options = CRITREG_STICK_BUTTON_ANGLES, unknown = 2;
    double instance[13], mu = 0.5, nan = (double)NAN;

    EXPECT_TRUE(critreg_stick_button_state_len(1) == 13);
    EXPECT(CRITREG_NULL_POINTER, critreg_stick_button_task(1, 0, 1, NULL, 13));
    EXPECT(CRITREG_MISALIGNED, critreg_stick_button_task(1, 0, 1, ASKEW(double, other), 13));
    EXPECT(CRITREG_TOO_SMALL, critreg_stick_button_task(1, 0, 1, instance, 12));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_stick_button_task(1, 2, 1, instance, 13));
    OK(critreg_stick_button_task(1, options, 1, instance, 13));
    OK(critreg_stick_button_pick(&options, instance, &mu, &outcome));
    OK(critreg_stick_button_task(1, 0, 1, instance, 13));
    OK(critreg_stick_button_pick(NULL, instance, &mu, &outcome));
    EXPECT_TRUE(outcome == CRITREG_FEASIBLE || outcome == CRITREG_INFEASIBLE);
    outcome = 77;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_stick_button_pick(&unknown, instance, &mu, &outcome));
    EXPECT(CRITREG_MISALIGNED,
           critreg_stick_button_pick(ASKEW(void *, other), instance, &mu, &outcome));
    EXPECT(CRITREG_NULL_POINTER, critreg_stick_button_pick(NULL, NULL, &mu, &outcome));
    EXPECT(CRITREG_NULL_POINTER, critreg_stick_button_pick(NULL, instance, NULL, &outcome));
    EXPECT(CRITREG_NULL_POINTER, critreg_stick_button_pick(NULL, instance, &mu, NULL));
    EXPECT(CRITREG_NOT_FINITE, critreg_stick_button_pick(NULL, instance, &nan, &outcome));
    instance[7] = (double)INFINITY;
    EXPECT(CRITREG_NOT_FINITE, critreg_stick_button_pick(NULL, instance, &mu, &outcome));
    EXPECT_TRUE(outcome == 77);
}

static void wrong_actions_and_states(void)
{
    static const critreg_ground pick = {"picksTICKfromnothing", {"robby", "stick"}, 0, 2, {0}};
    static const critreg_ground grasped = {"Grasped", {"robby", "Stick"}, 0, 2, {0}};
    critreg_ground wrong[6];
    const double mu[] = {0.1, (double)NAN};
    double state[16], after[16];
    uint32_t actions = 77, options = 2;
    int32_t holds = 77;
    size_t i;

    EXPECT_TRUE(critreg_stick_button_state_len(2) == 16);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_stick_button_task(1, 0, 0, state, 16));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_stick_button_task(1, 0, 11, state, 16));
    EXPECT(CRITREG_TOO_SMALL, critreg_stick_button_task(1, 0, 2, state, 15));
    OK(critreg_stick_button_task(1, 0, 2, state, 16));
    for (i = 0; i < 6; i++)
        wrong[i] = pick;
    wrong[0].name = "Grasped";
    wrong[1].name = NULL;
    wrong[2].object_names[1] = "button2";
    wrong[3].object_names[0] = "stick";
    wrong[4].object_count = 1;
    wrong[5].object_count = CRITREG_MAX_ARGUMENTS + 1;
    for (i = 0; i < 6; i++)
        EXPECT(i == 1 ? CRITREG_NULL_POINTER : CRITREG_INVALID_ARGUMENT,
               critreg_stick_button_execute(NULL, &wrong[i], mu, state, after, 16, &actions));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_stick_button_execute(&options, &pick, mu, state, after, 16, &actions));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_stick_button_execute(NULL, &pick, mu, state, after, 15, &actions));
    EXPECT(CRITREG_NOT_FINITE,
           critreg_stick_button_execute(NULL, &pick, mu + 1, state, after, 16, &actions));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_stick_button_execute(NULL, NULL, mu, state, after, 16, &actions));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_stick_button_execute(NULL, &pick, NULL, state, after, 16, &actions));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_stick_button_execute(NULL, &pick, mu, NULL, after, 16, &actions));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_stick_button_execute(NULL, &pick, mu, state, NULL, 16, &actions));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_stick_button_execute(NULL, &pick, mu, state, after, 16, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_stick_button_holds(NULL, &pick, state, 16, &holds));
    EXPECT(CRITREG_NULL_POINTER, critreg_stick_button_holds(NULL, &grasped, state, 16, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_stick_button_holds(NULL, &grasped, state, 14, &holds));
    EXPECT_TRUE(actions == 77 && holds == 77);
    OK(critreg_stick_button_execute(NULL, &pick, mu, state, after, 16, &actions));
    OK(critreg_stick_button_holds(NULL, &grasped, state, 16, &holds));
    EXPECT_TRUE(holds == 0);
    OK(critreg_stick_button_holds(NULL, &grasped, after, 16, &holds));
    EXPECT_TRUE(holds == (actions > 0));
    state[3] = (double)NAN;
    EXPECT(CRITREG_NOT_FINITE, critreg_stick_button_holds(NULL, &grasped, state, 16, &holds));
}

int main(void)
{
    wrong_tasks_and_picks();
    wrong_actions_and_states();
    return summary();
}
