/*
 * What skills are worth to a planner: they are learned by trying, and 50 tasks with one
 * button and 50 with three or four are planned with the original samplers and with them.
 * Operators and problems are PDDL (stick_button.h), the world is behind two callbacks.
 *
 * Usage: plan_tasks [number of tasks [number of training tasks]]
 */
#include <stdlib.h>
#include <time.h>

#include "critreg.h"
#include "stick_button.h"

#define NUMBERS 22              /* of a state with four buttons */

#define CHECK(call) check((call), #call)
static const double along[2] = {0.0, 1.0}, across[2] = {-1.0, 1.0};
static const char *const names[] = {"picking the stick", "pressing by hand", "placing the stick",
                                    "picking it and pressing with it"};

static void check(critreg_status status, const char *call)
{
    if (status != CRITREG_OK)
        exit(fprintf(stderr, "%s: %s\n", call, critreg_strerror(status)));
}

/* Learns in so many tasks with one or two buttons. */
static critreg_skills *learn(uint32_t tasks, const critreg_callbacks *callbacks)
{
    critreg_skills_config config;
    critreg_skills *skills;
    void *memory;
    char text[4096];
    uint32_t i;
    CHECK(critreg_skills_config_init(&config, sizeof config));
    config.state_len = NUMBERS;
    config.tasks = config.states = tasks;
    memory = malloc(critreg_skills_size(&config));
    CHECK(critreg_skills_init(memory, critreg_skills_size(&config), STICK_BUTTON, LAYOUT, &config,
                              &skills));
    CHECK(critreg_skills_add_controller(skills, "PickStick",
        "PickStickFromNothing PickStickFromButton", "?r ?s", along, 1));
    CHECK(critreg_skills_add_controller(skills, "PlaceStick",
        "PlaceStickFromNothing PlaceStickFromButton", "?r ?s", across, 1));
    CHECK(critreg_skills_add_controller(skills, "RobotPress",
        "RobotPressButtonFromNothing RobotPressButtonFromButton", "?r ?b ?s", NULL, 0));
    CHECK(critreg_skills_add_controller(skills, "StickPress",
        "StickPressButtonFromNothing StickPressButtonFromButton", "?r ?s ?b", NULL, 0));
    CHECK(critreg_skills_add(skills, "PickStick", NULL, NULL, PICK));
    CHECK(critreg_skills_add(skills, "RobotPress", NULL, NULL, PRESS));
    CHECK(critreg_skills_add(skills, "PlaceStick", NULL, NULL, PLACE));
    CHECK(critreg_skills_add(skills, "PickStick", "StickPress", NULL, NULL));
    for (i = 0; i < tasks; i++) {
        uint32_t buttons = 1 + i % 2;
        double state[NUMBERS];
        write_problem(buttons, text, sizeof text);
        CHECK(critreg_stick_button_task(1000 + i, 0, buttons, state, NUMBERS));
        CHECK(critreg_skills_add_task(skills, text, state,
                                      critreg_stick_button_state_len(buttons)));
    }
    CHECK(critreg_skills_learn(skills, callbacks, NULL));
    for (i = 0; i < sizeof names / sizeof *names; i++) {
        (void)critreg_skills_format(skills, i, text, sizeof text, NULL);  /* or why none */
        printf("region of %s: %s\n", names[i], text);
    }
    return skills;
}

/* Plans tasks with so many buttons, or one more, and prints a row of the table. */
static void plan(int tasks, uint32_t least, uint32_t most, const critreg_callbacks *callbacks)
{
    static uint64_t memory[CRITREG_PLANNER_WORDS(NUMBERS)];
    double samples = 0.0, operators = 0.0, initial[NUMBERS];
    clock_t begin = clock();
    int task, solved = 0;
    for (task = 0; task < tasks; task++) {
        uint32_t buttons = least + (uint32_t)task % (most - least + 1);
        critreg_planner_config config;
        critreg_planner *planner;
        critreg_metrics metrics;
        char text[512];
        write_problem(buttons, text, sizeof text);
        CHECK(critreg_planner_config_init(&config, sizeof config));
        config.state_len = (uint32_t)critreg_stick_button_state_len(buttons);
        CHECK(critreg_planner_init(memory, sizeof memory, STICK_BUTTON, text, &config, &planner));
        CHECK(critreg_planner_set_ranges(planner, "PickStickFromNothing", along, 1));
        CHECK(critreg_planner_set_ranges(planner, "PickStickFromButton", along, 1));
        CHECK(critreg_planner_set_ranges(planner, "PlaceStickFromNothing", across, 1));
        CHECK(critreg_planner_set_ranges(planner, "PlaceStickFromButton", across, 1));
        CHECK(critreg_stick_button_task(1 + (uint64_t)task, 0, buttons, initial, NUMBERS));
        solved += critreg_plan(planner, callbacks, initial, 1 + (uint64_t)task, NULL, NULL)
            == CRITREG_OK;
        CHECK(critreg_metrics_init(&metrics, sizeof metrics));
        CHECK(critreg_planner_metrics(planner, &metrics));
        samples += metrics.conclusion == CRITREG_SOLVED ? metrics.samples : 0;
        operators += metrics.plan_length;
    }
    printf("tests: %s, sampler: %s, solved: %d/%d, samples_mean: %.2f, "
           "plan_length_mean: %.2f, time_us_mean: %.1f\n", most > 1 ? "3 or 4 buttons" : "1 button",
           callbacks->skills != NULL ? "learned" : "original", solved, tasks,
           samples / (solved + !solved), operators / (solved + !solved),
           1e6 * (double)(clock() - begin) / CLOCKS_PER_SEC / tasks);
}

int main(int argc, char **argv)
{
    int tasks = argc > 1 ? atoi(argv[1]) : 50;
    critreg_callbacks original, learned;
    CHECK(critreg_callbacks_init(&original, sizeof original));
    original.execute = critreg_stick_button_execute;
    original.holds = critreg_stick_button_holds;
    learned = original;
    learned.skills = learn(argc > 2 ? (uint32_t)atoi(argv[2]) : 150, &original);
    plan(tasks, 1, 1, &original);
    plan(tasks, 1, 1, &learned);
    plan(tasks, 3, 4, &original);
    plan(tasks, 3, 4, &learned);
    free(learned.skills);       /* which lie at the start of their memory */
    return EXIT_SUCCESS;
}
