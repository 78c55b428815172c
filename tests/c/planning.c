/* Plans tasks of the built-in environment with its original sampler and prints what
 * came of it: tests/tests/c_interface/abi.rs compares that with the planner of the core. */
#include "../../c_examples/stick_button.h"
#include "expect.h"

#define TASKS 40
#define NUMBERS 22

static uint64_t memory[CRITREG_PLANNER_WORDS_FOR(8192, 256, 10000, 16, NUMBERS)];

static critreg_planner *planner_for(uint32_t buttons)
{
    static const double along[2] = {0.0, 1.0}, across[2] = {-1.0, 1.0};
    critreg_planner_config config;
    critreg_planner *planner = NULL;
    char problem[512];
    write_problem(buttons, problem, sizeof problem);
    OK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = (uint32_t)critreg_stick_button_state_len(buttons);
    config.nodes = 10000;
    config.max_length = 16;
    /* The core is asked as the recorded framework plans: every sequence for itself. */
    config.skeletons_per_state = 0;
    OK(critreg_planner_init(memory, sizeof memory, STICK_BUTTON, problem, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "PickStickFromNothing", along, 1));
    OK(critreg_planner_set_ranges(planner, "pickstickfrombutton", along, 1));
    OK(critreg_planner_set_ranges(planner, "PlaceStickFromNothing", across, 1));
    OK(critreg_planner_set_ranges(planner, "PlaceStickFromButton", across, 1));
    return planner;
}

/* A step, its parameters as the environment reads them: the bits of a float. */
static void print_step(critreg_planner *planner, size_t index, const double **state)
{
    critreg_step step;
    uint32_t i;
    OK(critreg_step_init(&step, sizeof step));
    OK(critreg_planner_step(planner, index, &step));
    printf(" (%s", step.ground.name);
    for (i = 0; i < step.ground.object_count; i++)
        printf(" %s", step.ground.object_names[i]);
    printf(")");
    for (i = 0; i < step.parameter_count; i++) {
        float parameter = (float)step.parameters[i];
        uint32_t bits;
        memcpy(&bits, &parameter, sizeof bits);
        printf(" %" PRIu32, bits);
    }
    *state = step.state;
}

static void plan_task(uint32_t task)
{
    uint32_t buttons = 1 + task % BUTTONS, options = 0, i;
    double initial[NUMBERS];
    const double *state = initial;
    critreg_planner *planner = planner_for(buttons);
    critreg_callbacks callbacks;
    critreg_metrics metrics;
    critreg_status status;
    size_t length = 0, step;
    OK(critreg_stick_button_task(task, 0, buttons, initial, NUMBERS));
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = critreg_stick_button_execute;
    callbacks.holds = critreg_stick_button_holds;
    status = critreg_plan(planner, &callbacks, initial, task, &options, &length);
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    OK(critreg_planner_metrics(planner, &metrics));
    EXPECT_TRUE((status == CRITREG_OK) == (metrics.conclusion == CRITREG_SOLVED));
    EXPECT_TRUE(length == metrics.plan_length);
    printf("%" PRIu32 ": %d %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu64, task,
           status == CRITREG_OK, metrics.samples, metrics.skeletons, metrics.nodes_expanded,
           metrics.nodes_created, metrics.actions);
    for (step = 0; step < length; step++)
        print_step(planner, step, &state);
    for (i = 0; i < buttons; i++)
        EXPECT_TRUE(status != CRITREG_OK || state[12 + 3 * i] > 0.5);
    printf("\n");
}

int main(void)
{
    uint32_t task;
    for (task = 0; task < TASKS; task++)
        plan_task(task);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
