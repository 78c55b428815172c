/*
 * A world of one's own: boxes on two tables, and a shelf with a low board above it. A hand
 * grips a box at some height and puts it down somewhere; a box that is gripped too high cannot
 * be pushed into the shelf, as the palm hits the board. The simulator is in this file.
 *
 * Skills are learned in 60 tasks, and 50 others are planned with and without them. Of the
 * sequence "pick, then push in" nothing is said by hand: it follows from the texts of the two.
 *
 * Usage: own_world [number of tasks [number of training tasks]]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "critreg.h"

#define BOXES 5                 /* most boxes of a task */
#define FINGER 0.06             /* how long the fingers are, */
#define HAND 0.11               /* how high the hand is, fingers included, */
#define GAP 0.02                /* and how far boxes have to be apart */

/* A state: an array of these numbers. */
typedef struct {
    double left[2], right[2], shelf[3];     /* x, width, and the room below the board */
    double grip;                            /* how high the last box was gripped */
    struct { double x, y, width, height, held; } boxes[BOXES];
} state;

#define NUMBERS(boxes) (8 + 5 * (size_t)(boxes))

static const char LAYOUT[] =
    "type table { x: length, width: length }\n"
    "type shelf { x: length, width: length, room: length }\n"
    "type hand { grip: length }\n"
    "type box { x: length, y: length, width: length, height: length, held: flag }\n"
    "object left: table  object right: table  object shelf: shelf  object hand: hand\n"
    "object boxes[5]: box\n";

static const char DOMAIN[] =
    "(define (domain boxes) (:types table shelf - place place box - object)\n"
    "  (:predicates (On ?b - box ?p - place) (Held ?b - box) (Standing ?b - box) (HandEmpty))\n"
    "  (:action Pick :parameters (?b - box ?p - place)\n"
    "    :precondition (and (On ?b ?p) (HandEmpty))\n"
    "    :effect (and (Held ?b) (not (On ?b ?p)) (not (Standing ?b)) (not (HandEmpty))))\n"
    "  (:action PutDown :parameters (?b - box ?t - table) :precondition (Held ?b)\n"
    "    :effect (and (On ?b ?t) (Standing ?b) (HandEmpty) (not (Held ?b))))\n"
    "  (:action PushIn :parameters (?b - box ?s - shelf) :precondition (Held ?b)\n"
    "    :effect (and (On ?b ?s) (Standing ?b) (HandEmpty) (not (Held ?b)))))\n";

/* What can be said of the controllers: what there is, and what moves with the parameters. */
static const char PICK[] =
    "constant finger.length = 0.06: length  constant hand.height = 0.11: length\n"
    "object box { x: length, y: length, width: length, height: length }\n"
    "parameter grip in [0, 0.4]: length\n"
    "point tips = world + (box.x, grip)  point box.top = world + (box.x, box.height)\n";
static const char PUT_DOWN[] =
    "constant gap = 0.02: length\n"
    "object table { x: length, width: length }  object box { width: length }\n"
    "object other_box[4] { x: length, y: length, width: length }\n"
    "parameter along in [0, 1]\n"
    "point surface = world + (table.x + 0.5 * table.width, 0)\n"
    "point spot = world + (table.x + along * table.width, 0)\n"
    "shape surface = rectangle(table.width, 0.2) centred\n"
    "shape spot = rectangle(box.width, 0.1) centred\n"
    "shape other_box = rectangle(other_box.width, 0.1) centred\n";
static const char PUSH_IN[] =
    "constant gap = 0.02: length\n"
    "constant finger.length = 0.06: length  constant hand.height = 0.11: length\n"
    "object shelf { x: length, width: length, room: length }  object hand { grip: length }\n"
    "object box { width: length }\n"
    "object other_box[4] { x: length, y: length, width: length }\n"
    "parameter along in [0, 1]\n"
    "point surface = world + (shelf.x + 0.5 * shelf.width, 0)\n"
    "point spot = world + (shelf.x + along * shelf.width, 0)\n"
    "shape surface = rectangle(shelf.width, 0.2) centred\n"
    "shape spot = rectangle(box.width, 0.1) centred\n"
    "shape other_box = rectangle(other_box.width, 0.1) centred\n";

#define CHECK(call) check((call), #call)

static void check(critreg_status status, const char *call)
{
    if (status != CRITREG_OK)
        exit(fprintf(stderr, "%s: %s\n", call, critreg_strerror(status)));
}

/* ---- The world. ---- */

/* The x and width of a place. */
static const double *place(const state *now, const char *name)
{
    return name[0] == 'l' ? now->left : name[0] == 'r' ? now->right : now->shelf;
}

static int boxes_of(size_t len)
{
    return (int)((len - NUMBERS(0)) / 5);
}

static critreg_status execute(void *user_data, const critreg_ground *action, const double *theta,
                              const double *before, double *after, size_t len, uint32_t *actions)
{
    state *now = (state *)after;
    const double *surface = place(now, action->object_names[1]);
    int own = (int)action->objects[0], other, works;     /* boxes are named b0, b1, ... */
    (void)user_data, (void)before;
    if (strcmp(action->name, "Pick") == 0) {
        works = theta[0] <= now->boxes[own].height && theta[0] >= now->boxes[own].height - FINGER;
        now->grip = theta[0];
        now->boxes[own].held = 1.0;
        now->boxes[own].x = -1.0;
    } else {
        double x = surface[0] + theta[0] * surface[1], half = 0.5 * now->boxes[own].width;
        works = x - half >= surface[0] && x + half <= surface[0] + surface[1];
        for (other = 0; other < boxes_of(len); other++)
            works = works && (other == own || now->boxes[other].held > 0.5
                || fabs(now->boxes[other].x - x) >= half + 0.5 * now->boxes[other].width + GAP);
        if (strcmp(action->name, "PushIn") == 0)
            works = works && now->grip + HAND <= now->shelf[2];
        now->boxes[own].held = 0.0;
        now->boxes[own].x = x;
    }
    *actions = works ? 1 : 0;
    return CRITREG_OK;
}

static critreg_status holds(void *user_data, const critreg_ground *atom, const double *numbers,
                            size_t len, int32_t *holds)
{
    const state *now = (const state *)numbers;
    int box = (int)atom->objects[0], held = 0, i;
    (void)user_data;
    if (strcmp(atom->name, "HandEmpty") == 0) {
        for (i = 0; i < boxes_of(len); i++)
            held = held || now->boxes[i].held > 0.5;
        *holds = !held;
    } else if (strcmp(atom->name, "On") == 0) {
        const double *surface = place(now, atom->object_names[1]);
        *holds = now->boxes[box].held < 0.5 && now->boxes[box].x >= surface[0]
            && now->boxes[box].x <= surface[0] + surface[1];
    } else {
        *holds = (now->boxes[box].held > 0.5) == (strcmp(atom->name, "Held") == 0);
    }
    return CRITREG_OK;
}

/* ---- Tasks: two or three boxes are to be moved, one of them or two into the shelf. ---- */

static double between(critreg_rng *rng, double low, double high)
{
    double number;
    CHECK(critreg_rng_uniform(rng, &number));
    return low + number * (high - low);
}

/* Writes the problem and the state of a task, and returns how many numbers it has. */
static size_t make_task(uint64_t seed, char *problem, state *initial)
{
    static const char *const goals[3] = {"shelf", "right", "shelf"};
    static const char *const places[3] = {"left", "right", "shelf"};
    critreg_rng rng = critreg_rng_seed(seed);
    int boxes = 3 + (int)(seed % 3), i;
    char names[64] = "", on[256] = "", goal[128] = "";
    memset(initial, 0, sizeof *initial);
    initial->left[1] = between(&rng, 1.6, 2.0);
    initial->right[0] = 3.0, initial->right[1] = between(&rng, 0.8, 1.2);
    initial->shelf[0] = 5.0, initial->shelf[1] = between(&rng, 1.0, 1.4);
    initial->shelf[2] = between(&rng, 0.2, 0.35);
    for (i = 0; i < boxes; i++) {
        double width = between(&rng, 0.08, 0.2);
        double highest = initial->shelf[2] - HAND + FINGER - 0.03;
        int away = i == boxes - 1 ? (int)(seed / 2 % 3) : 0;    /* on another place */
        initial->boxes[i].width = width;
        initial->boxes[i].height = between(&rng, 0.1, highest);
        initial->boxes[i].x = (away == 0 ? 0.35 * i : away == 1 ? 3.0 : 5.2) + 0.5 * width + between(&rng, 0.0, 0.12);
        sprintf(names + strlen(names), " b%d", i);
        sprintf(on + strlen(on), " (On b%d %s) (Standing b%d)", i, places[away], i);
        if (i < 2 + (int)(seed / 3 % 2) && i < boxes - 1)
            sprintf(goal + strlen(goal), " (On b%d %s)", i, goals[i]);
    }
    sprintf(problem, "(define (problem tidy) (:domain boxes)\n"
            " (:objects%s - box left right - table shelf - shelf)\n"
            " (:init%s (HandEmpty)) (:goal (and%s)))", names, on, goal);
    return NUMBERS(boxes);
}

/* ---- Learning and planning. ---- */

static const double grips[2] = {0.0, 0.4}, along[2] = {0.0, 1.0};

static critreg_skills *learn(uint32_t tasks, const critreg_callbacks *callbacks)
{
    critreg_skills_config config;
    critreg_skills *skills;
    void *memory;
    char text[4096];
    state initial;
    size_t i;
    CHECK(critreg_skills_config_init(&config, sizeof config));
    config.state_len = NUMBERS(BOXES);
    config.tasks = config.states = tasks;
    memory = malloc(critreg_skills_size(&config));
    CHECK(critreg_skills_init(memory, critreg_skills_size(&config), DOMAIN, LAYOUT, &config,
                              &skills));
    CHECK(critreg_skills_add_controller(skills, "Pick", NULL, "?b", grips, 1));
    CHECK(critreg_skills_add_controller(skills, "PutDown", NULL, NULL, along, 1));
    CHECK(critreg_skills_add_controller(skills, "PushIn", NULL, NULL, along, 1));
    CHECK(critreg_skills_add(skills, "Pick", NULL, NULL, PICK));
    CHECK(critreg_skills_add(skills, "PutDown", NULL, "Standing", PUT_DOWN));
    CHECK(critreg_skills_add(skills, "PushIn", NULL, "Standing", PUSH_IN));
    CHECK(critreg_skills_add(skills, "Pick", "PushIn", "Standing", NULL));
    for (i = 0; i < tasks; i++) {
        size_t len = make_task(1000 + i, text, &initial);
        CHECK(critreg_skills_add_task(skills, text, (const double *)&initial, len));
    }
    CHECK(critreg_skills_learn(skills, callbacks, NULL));
    for (i = 0; i < 4; i++) {
        static const char *const names[] = {"Pick", "PutDown", "PushIn", "Pick, then PushIn"};
        critreg_skill_report report;
        critreg_status status = critreg_skills_format(skills, i, text, sizeof text, NULL);
        CHECK(critreg_skill_report_init(&report, sizeof report));
        CHECK(critreg_skills_report(skills, i, &report));
        printf("%s, after %u calls: %s%s\n", names[i], (unsigned)report.calls,
               status == CRITREG_NO_REGION ? "no region: " : "", text);
    }
    return skills;
}

static void plan(int tasks, const critreg_callbacks *callbacks)
{
    static uint64_t memory[CRITREG_PLANNER_WORDS(NUMBERS(BOXES))];
    double samples = 0.0, operators = 0.0;
    int task, solved = 0;
    for (task = 1; task <= tasks; task++) {
        critreg_planner_config config;
        critreg_planner *planner;
        critreg_metrics metrics;
        char text[1024];
        state initial;
        CHECK(critreg_planner_config_init(&config, sizeof config));
        config.state_len = (uint32_t)make_task((uint64_t)task, text, &initial);
        CHECK(critreg_planner_init(memory, sizeof memory, DOMAIN, text, &config, &planner));
        CHECK(critreg_planner_set_ranges(planner, "Pick", grips, 1));
        CHECK(critreg_planner_set_ranges(planner, "PutDown", along, 1));
        CHECK(critreg_planner_set_ranges(planner, "PushIn", along, 1));
        solved += critreg_plan(planner, callbacks, (const double *)&initial, (uint64_t)task, NULL,
                               NULL) == CRITREG_OK;
        CHECK(critreg_metrics_init(&metrics, sizeof metrics));
        CHECK(critreg_planner_metrics(planner, &metrics));
        samples += metrics.conclusion == CRITREG_SOLVED ? metrics.samples : 0;
        operators += metrics.plan_length;
    }
    printf("sampler: %s, solved: %d/%d, samples_mean: %.2f, plan_length_mean: %.2f\n",
           callbacks->skills != NULL ? "learned" : "original", solved, tasks,
           samples / (solved + !solved), operators / (solved + !solved));
}

int main(int argc, char **argv)
{
    int tasks = argc > 1 ? atoi(argv[1]) : 50;
    critreg_callbacks original, learned;
    CHECK(critreg_callbacks_init(&original, sizeof original));
    original.execute = execute;
    original.holds = holds;
    learned = original;
    learned.skills = learn(argc > 2 ? (uint32_t)atoi(argv[2]) : 60, &original);
    plan(tasks, &original);
    plan(tasks, &learned);
    free(learned.skills);       /* which lie at the start of their memory */
    return EXIT_SUCCESS;
}
