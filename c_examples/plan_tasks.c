/*
 * What regions are worth to a planner: 50 tasks with one button and 50 with three or
 * four, planned with the original samplers and with learned regions.
 *
 * The operators are the PDDL text in stick_button.h, the world is the built-in stick-button
 * environment behind two callbacks. Three regions are learned by trying operators in
 * it: picking the stick; picking it and then pressing a button with it, where each
 * step is told from the other; and pressing a button by hand, which has no parameter,
 * so that its region is over the state. Then two more callbacks bring them in: sample
 * draws a grasp that is good for all presses that follow, advise postpones sequences
 * of operators that cannot work.
 *
 * Usage: plan_tasks [number of tasks]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "critreg.h"
#include "stick_button.h"

#define TASKS 50                /* most tasks to plan */
#define NUMBERS 22              /* of a state with so many */
#define NUMBERS_OF_ONE 13       /* of one with one button: an instance of the regions */
#define INSTANCES 60            /* most tasks to learn from */
#define CALLS 200               /* most calls of the simulator per region */
#define FORMS 4096
#define FIRST_TASK 1u           /* seeds of the tasks to plan, */
#define FIRST_TRAINING 1000u    /* and of those to learn from */

/* What is known when a button is pressed by hand: the numbers of a state with one
 * button, and no parameter. */
static const char STATE[] =
    "object robot  { x: length, y: length, theta: angle }\n"
    "object stick  { x: length, y: length, theta: angle, held: flag }\n"
    "object holder { x: length, y: length, theta: angle }\n"
    "object button { x: length, y: length, pressed: flag }\n"
    "constant zone.top      = 3.0: length\n"
    "constant robot.radius  = 0.1: length\n"
    "constant button.radius = 0.1: length\n"
    "constant table.right   = 10.0: length\n"
    "constant table.top     = 6.0: length\n";

#define CHECK(call) check((call), #call)

static void check(critreg_status status, const char *call)
{
    if (status != CRITREG_OK) {
        fprintf(stderr, "%s: %s\n", call, critreg_strerror(status));
        exit(EXIT_FAILURE);
    }
}

/* ---- Learning: what the environment says about operators with button0. ---- */

static const critreg_ground PICK = {"PickStickFromNothing", {"robby", "stick"}, 0, 2, {0}};
static const critreg_ground PRESS_WITH_STICK = {
    "StickPressButtonFromNothing", {"robby", "stick", "button0"}, 0, 3, {0}};
static const critreg_ground PRESS_BY_HAND = {
    "RobotPressButtonFromNothing", {"robby", "button0", "stick"}, 0, 3, {0}};
static const critreg_ground GRASPED = {"Grasped", {"robby", "stick"}, 0, 2, {0}};
static const critreg_ground PRESSED = {"Pressed", {"button0"}, 0, 1, {0}};

/* Whether an operator takes an action and its effect holds. */
static int works(const critreg_ground *operation, const double *theta, const double *before,
                 const critreg_ground *effect, double *after)
{
    uint32_t actions;
    int32_t holds;
    CHECK(critreg_stick_button_execute(NULL, operation, theta, before, after, NUMBERS_OF_ONE,
                                       &actions));
    CHECK(critreg_stick_button_holds(NULL, effect, after, NUMBERS_OF_ONE, &holds));
    return actions > 0 && holds;
}

static critreg_status try_chain(void *user_data, const double *instance, const double *theta,
                                critreg_outcome *outcome)
{
    double picked[NUMBERS_OF_ONE], pressed[NUMBERS_OF_ONE];
    (void)user_data;
    if (!works(&PICK, theta, instance, &GRASPED, picked))
        *outcome = CRITREG_FAILED_STEP(1);
    else if (!works(&PRESS_WITH_STICK, NULL, picked, &PRESSED, pressed))
        *outcome = CRITREG_FAILED_STEP(2);
    else
        *outcome = CRITREG_FEASIBLE;
    return CRITREG_OK;
}

static critreg_status try_hand(void *user_data, const double *instance, const double *theta,
                               critreg_outcome *outcome)
{
    double pressed[NUMBERS_OF_ONE];
    (void)user_data;
    *outcome = works(&PRESS_BY_HAND, theta, instance, &PRESSED, pressed);
    return CRITREG_OK;
}

/* Learns from tasks with one button; NULL if the answers explain no region. */
static const critreg_region *learn(const char *what, uint64_t *memory, size_t memory_len,
                                   const char *domain, uint32_t instances, uint32_t steps,
                                   critreg_simulate simulate)
{
    static double tasks[INSTANCES][NUMBERS_OF_ONE];
    const critreg_region *region = NULL;
    critreg_learner *learner;
    critreg_config config;
    critreg_status status;
    char text[4096] = "none";
    uint32_t i;
    for (i = 0; i < instances; i++)
        CHECK(critreg_stick_button_task(FIRST_TRAINING + i, 0, 1, tasks[i], NUMBERS_OF_ONE));
    CHECK(critreg_config_init(&config, sizeof config));
    config.forms = FORMS;
    config.calls = CALLS;
    config.instances = instances;
    config.steps = steps;
    CHECK(critreg_learner_init(memory, memory_len, domain, &config, &learner));
    status = critreg_learn_region(learner, &tasks[0][0], instances, simulate, NULL, &region);
    if (status != CRITREG_NO_REGION)
        CHECK(status);
    if (region != NULL)
        CHECK(critreg_region_format(region, text, sizeof text, NULL));
    printf("region of %s: %s\n", what, text);
    return region;
}

/* ---- Planning with what was learned. ---- */

/* What the callbacks get. Those of the environment read its options, which therefore
 * come first; the regions may be NULL. */
typedef struct {
    uint32_t options;
    const critreg_region *pick, *chain, *hand;
} knowledge;

/* Why something cannot work; the planner counts these. */
enum { OUT_OF_REACH, NO_GRASP, REASONS };
static const char *const reasons[REASONS] = {"a button is out of reach of the hand",
                                             "no grasp is good for all presses that follow"};

static int is(const critreg_ground *operation, const char *prefix)
{
    return strncmp(operation->name, prefix, strlen(prefix)) == 0;
}

/* The state with one of its buttons only, in which the regions are grounded. Objects
 * are in the order of their names, so the buttons come first. */
static void keep_button(const double *state, uint32_t button, double *instance)
{
    memcpy(instance, state, 10 * sizeof *state);
    memcpy(instance + 10, state + 10 + 3 * button, 3 * sizeof *state);
}

/* What a grasp has to be good for: the pick, and each press until the stick is placed. */
typedef struct {
    const critreg_region *regions[CRITREG_MAX_REGIONS];
    const double *instances[CRITREG_MAX_REGIONS];
    double numbers[CRITREG_MAX_REGIONS][NUMBERS_OF_ONE];
    size_t count;
} demands;

static void demand(demands *all, const critreg_region *region, const double *state,
                   uint32_t button)
{
    size_t i = all->count;
    if (region == NULL || i == CRITREG_MAX_REGIONS)
        return;     /* less is known then, nothing wrong */
    keep_button(state, button, all->numbers[i]);
    all->regions[i] = region;
    all->instances[i] = all->numbers[i];
    all->count++;
}

static void collect(demands *all, const knowledge *known, const double *state,
                    const critreg_ground *later, size_t length)
{
    size_t i;
    all->count = 0;
    demand(all, known->pick, state, 0);
    for (i = 0; i < length && !is(&later[i], "PlaceStick"); i++)
        if (is(&later[i], "StickPress"))
            demand(all, known->chain, state, later[i].objects[2]);
}

static critreg_status draw_grasp(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                                 critreg_drawn *drawn)
{
    const critreg_ground *operation = &draw->skeleton[draw->step];
    double *parameter = &drawn->parameters[0];
    critreg_status status;
    demands all;
    if (draw->parameter_count == 0)
        return CRITREG_OK;
    if (is(operation, "PickStick") && draw->advised) {
        collect(&all, (const knowledge *)user_data, draw->state, operation + 1,
                draw->length - draw->step - 1);
        drawn->informed = 1;
        drawn->reason = NO_GRASP;
        status = critreg_sample_regions(all.regions, all.instances, all.count, rng, parameter);
        if (status != CRITREG_NO_SAMPLE && all.count > 0)
            return status;
        drawn->informed = 0;
    }
    status = critreg_rng_uniform(rng, parameter);
    if (is(operation, "PlaceStick"))
        *parameter = 2.0 * *parameter - 1.0;
    return status;
}

/* Judges the last operator of a prefix. The stick is where it was until it is picked. */
static critreg_status advise(void *user_data, const critreg_ground *prefix, size_t length,
                             const double *initial, size_t len, critreg_advice *advice,
                             uint32_t *reason)
{
    const knowledge *known = (const knowledge *)user_data;
    const critreg_ground *last = &prefix[length - 1];
    double instance[NUMBERS_OF_ONE];
    critreg_status status = CRITREG_OK;
    int32_t works_here = 1, empty = 0;
    size_t pick = length;
    demands all;
    (void)len;
    if (is(last, "RobotPress") && known->hand != NULL) {
        keep_button(initial, last->objects[1], instance);
        status = critreg_region_contains(known->hand, instance, NULL, &works_here);
    }
    while (pick > 0 && !is(&prefix[pick - 1], "PickStick"))
        pick--;
    if (is(last, "StickPress") && pick > 0) {
        collect(&all, known, initial, prefix + pick, length - pick);
        if (all.count > 0)
            status = critreg_regions_are_empty(all.regions, all.instances, all.count, &empty);
    }
    *advice = works_here && !empty ? CRITREG_KEEP : CRITREG_POSTPONE;
    *reason = works_here ? NO_GRASP : OUT_OF_REACH;
    return status;
}

static critreg_planner *make_planner(uint32_t buttons)
{
    static uint64_t memory[CRITREG_PLANNER_WORDS(NUMBERS)];
    static const double along[2] = {0.0, 1.0}, across[2] = {-1.0, 1.0};
    critreg_planner_config config;
    critreg_planner *planner;
    char problem[512];
    write_problem(buttons, problem, sizeof problem);
    CHECK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = (uint32_t)critreg_stick_button_state_len(buttons);
    CHECK(critreg_planner_init(memory, sizeof memory, STICK_BUTTON, problem, &config, &planner));
    CHECK(critreg_planner_set_ranges(planner, "PickStickFromNothing", along, 1));
    CHECK(critreg_planner_set_ranges(planner, "PickStickFromButton", along, 1));
    CHECK(critreg_planner_set_ranges(planner, "PlaceStickFromNothing", across, 1));
    CHECK(critreg_planner_set_ranges(planner, "PlaceStickFromButton", across, 1));
    return planner;
}

static void print_why(const critreg_planner *planner, const critreg_metrics *metrics, int task)
{
    char words[128];
    CHECK(critreg_planner_message(planner, words, sizeof words, NULL));
    fprintf(stderr, "task %d: %s; failed most: %s; most frequent reason: %s\n", task, words,
            metrics->most_failed != NULL ? metrics->most_failed : "none",
            metrics->main_reason < REASONS ? reasons[metrics->main_reason] : "none");
}

/* Plans all tasks with so many buttons, or one more, and prints a row of the table. */
static void plan_tasks(int tasks, const char *tests, uint32_t least, uint32_t most,
                       const char *sampler, const knowledge *known)
{
    double samples = 0.0, longest = 0.0, operators = 0.0;
    critreg_callbacks callbacks;
    clock_t begin;
    int task, solved = 0;
    CHECK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = critreg_stick_button_execute;
    callbacks.holds = critreg_stick_button_holds;
    if (known != NULL) {
        callbacks.sample = draw_grasp;
        callbacks.advise = advise;
    }
    begin = clock();
    for (task = 0; task < tasks; task++) {
        uint32_t buttons = least + (uint32_t)task % (most - least + 1);
        double initial[NUMBERS];
        critreg_planner *planner = make_planner(buttons);
        critreg_metrics metrics;
        critreg_status status;
        CHECK(critreg_stick_button_task(FIRST_TASK + (uint64_t)task, 0, buttons, initial, NUMBERS));
        status = critreg_plan(planner, &callbacks, initial, 1 + (uint64_t)task, (void *)known,
                              NULL);
        CHECK(critreg_metrics_init(&metrics, sizeof metrics));
        CHECK(critreg_planner_metrics(planner, &metrics));
        if (status != CRITREG_OK) {
            print_why(planner, &metrics, task);
            continue;
        }
        solved++;
        samples += metrics.samples;
        operators += metrics.plan_length;
        longest = metrics.samples > longest ? metrics.samples : longest;
    }
    printf("tests: %s, sampler: %s, solved: %d/%d, samples_mean: %.2f, samples_max: %.0f, "
           "plan_length_mean: %.2f, time_us_mean: %.1f\n", tests, sampler, solved, tasks,
           samples / (solved + !solved), longest, operators / (solved + !solved),
           1e6 * (double)(clock() - begin) / CLOCKS_PER_SEC / tasks);
}

int main(int argc, char **argv)
{
    static uint64_t pick_memory[CRITREG_LEARNER_WORDS(FORMS, 256)];
    static uint64_t chain_memory[CRITREG_LEARNER_WORDS_FOR(FORMS, 256, INSTANCES, 2)];
    static uint64_t hand_memory[CRITREG_LEARNER_WORDS_FOR(FORMS, 256, INSTANCES, 1)];
    knowledge known = {0, NULL, NULL, NULL};
    int tasks = argc > 1 ? atoi(argv[1]) : TASKS;
    if (tasks < 1 || tasks > TASKS)
        return fprintf(stderr, "usage: plan_tasks [1 to %d tasks]\n", TASKS), EXIT_FAILURE;

    fprintf(stderr, "learning\n");
    known.pick = learn("picking the stick", pick_memory, sizeof pick_memory,
                       critreg_stick_button_domain(), 4, 1, critreg_stick_button_pick);
    known.chain = learn("picking it and pressing with it", chain_memory, sizeof chain_memory,
                        critreg_stick_button_domain(), 20, 2, try_chain);
    known.hand = learn("pressing by hand", hand_memory, sizeof hand_memory, STATE, INSTANCES, 1,
                       try_hand);
    fprintf(stderr, "planning\n");
    plan_tasks(tasks, "1 button", 1, 1, "original", NULL);
    plan_tasks(tasks, "1 button", 1, 1, "learned", &known);
    plan_tasks(tasks, "3 or 4 buttons", 3, 4, "original", NULL);
    plan_tasks(tasks, "3 or 4 buttons", 3, 4, "learned", &known);
    return EXIT_SUCCESS;
}
