/* Skills are refused what is wrong, and learn the same however often they are stopped. */
#include "expect.h"

/* A hand reaches towards a wall, and must stop close before it. */
static const char PDDL[] =
    "(define (domain walls) (:types wall - object)\n"
    "  (:predicates (Touched ?w - wall) (High ?w - wall))\n"
    "  (:action Reach :parameters (?w - wall) :effect (Touched ?w))\n"
    "  (:action Paint :parameters (?w - wall) :precondition (Touched ?w) :effect (High ?w)))\n";
static const char OTHER_PDDL[] =
    "(define (domain walls) (:types wall - object)\n"
    "  (:predicates (Touched ?w - wall) (High ?w - wall))\n"
    "  (:action Reach :parameters (?w - wall) :effect (Touched ?w))\n"
    "  (:action Scrub :parameters (?w - wall) :precondition (Touched ?w) :effect (High ?w)))\n";
static const char PROBLEM[] =
    "(define (problem paint) (:domain walls) (:objects w - wall) (:init) (:goal (High w)))";
static const char LAYOUT[] =
    "type wall { x: length, touched: flag, high: flag }\nobject walls[2]: wall\n";
static const char REACH[] =
    "object wall { x: length }\nconstant hand.radius = 0.1: length\n"
    "parameter reach in [0, 4]: length\n"
    "point hand = world + (reach, 0)\npoint plate = world + (wall.x, 0)\n";
static const double RANGE[2] = {0.0, 4.0};

#define NUMBERS 3
#define TASKS 24

/* What the callbacks do beside what they are for. */
static struct {
    int runs;                   /* of execute */
    int stop_at;                /* the run at which it returns a status of its own */
    int nan, odd_holds;         /* wrong answers */
    critreg_skills *busy;       /* skills to call from inside */
} world;

#define STOPPED (CRITREG_USER_STATUS + 7)

static critreg_status execute(void *user_data, const critreg_ground *ground, const double *theta,
                              const double *before, double *after, size_t len, uint32_t *actions)
{
    (void)user_data, (void)before, (void)len;
    world.runs++;
    if (world.runs == world.stop_at)
        return STOPPED;
    if (world.busy != NULL) {
        critreg_skill_report report;
        OK(critreg_skill_report_init(&report, sizeof report));
        EXPECT(CRITREG_BUSY, critreg_skills_report(world.busy, 0, &report));
    }
    if (ground->index == 0) {
        if (theta[0] > after[0] - 0.1)
            return CRITREG_OK;
        after[1] = 1.0;
    } else {
        after[2] = after[0] < 2.5;      /* a far wall cannot be painted */
    }
    if (world.nan)
        after[1] = NAN;
    *actions = 1;
    return CRITREG_OK;
}

static critreg_status holds(void *user_data, const critreg_ground *ground, const double *state,
                            size_t len, int32_t *holds)
{
    (void)user_data, (void)len;
    *holds = world.odd_holds ? 2 : state[1 + ground->index] > 0.5;
    return CRITREG_OK;
}

/* Stops after every so many runs. */
static int runs_left;

static critreg_status progress(void *data, const critreg_training *training)
{
    EXPECT_TRUE(data == &runs_left);
    EXPECT_TRUE(training->skill < training->skills && training->runs > 0);
    return --runs_left == 0 ? CRITREG_CANCELLED : CRITREG_OK;
}

static critreg_callbacks world_callbacks(void)
{
    critreg_callbacks callbacks;
    OK(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = execute;
    callbacks.holds = holds;
    return callbacks;
}

static critreg_config learner_config(void)
{
    critreg_config config;
    OK(critreg_config_init(&config, sizeof config));
    config.calls = 40;
    config.forms = 1024;
    return config;
}

static critreg_skills_config small(const critreg_config *learner)
{
    critreg_skills_config config;
    OK(critreg_skills_config_init(&config, sizeof config));
    config.state_len = NUMBERS;
    config.learner = learner;
    config.chained = 40;
    config.situations = 8;
    config.states = TASKS;
    config.tasks = TASKS;
    config.controllers = 4;
    config.skills = 4;
    config.texts = 16384;
    config.nodes = 64;
    config.facts = 16;
    config.runs = 64;
    return config;
}

static critreg_skills *fresh(const critreg_skills_config *config)
{
    size_t bytes = critreg_skills_size(config);
    critreg_skills *skills = NULL;
    EXPECT_TRUE(bytes > 0);
    OK(critreg_skills_init(malloc(bytes), bytes, PDDL, LAYOUT, config, &skills));
    return skills;
}

static critreg_skills *make(const critreg_skills_config *config)
{
    critreg_skills *skills = fresh(config);
    int i;
    OK(critreg_skills_add_controller(skills, "Reach", NULL, NULL, RANGE, 1));
    OK(critreg_skills_add(skills, "Reach", NULL, NULL, REACH));
    OK(critreg_skills_add(skills, "Paint", NULL, NULL, NULL));
    for (i = 0; i < TASKS; i++) {
        const double state[NUMBERS] = {1.0 + 0.125 * i, 0.0, 0.0};
        OK(critreg_skills_add_task(skills, PROBLEM, state, NUMBERS));
    }
    return skills;
}

/* All that was learned, as text. */
static void describe(critreg_skills *skills, char *text, size_t len)
{
    size_t used = 0, i;
    for (i = 0; i < 2; i++) {
        critreg_skill_report report;
        char region[1024] = "";
        (void)critreg_skills_format(skills, i, region, sizeof region, NULL);
        OK(critreg_skill_report_init(&report, sizeof report));
        OK(critreg_skills_report(skills, i, &report));
        EXPECT_TRUE(report.finished == 1 && report.has_region == 1);
        used += (size_t)snprintf(text + used, len - used, "%s; %u %u %u %u %u %g\n", region,
                                 report.quality, report.tasks, report.situations, report.runs,
                                 report.calls, report.certificate_lower_bound);
    }
}

static void expect_words(critreg_skills *skills, const char *part)
{
    char words[256] = "";
    OK(critreg_skills_message(skills, words, sizeof words, NULL));
    if (strstr(words, part) == NULL)
        fprintf(stderr, "no \"%s\" in \"%s\"\n", part, words);
    EXPECT_TRUE(strstr(words, part) != NULL);
}

static char undisturbed[4096];
static int undisturbed_runs;

static void learn_undisturbed(void)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills = make(&config);
    memset(&world, 0, sizeof world);
    OK(critreg_skills_learn(skills, &callbacks, NULL));
    describe(skills, undisturbed, sizeof undisturbed);
    undisturbed_runs = world.runs;
    EXPECT_TRUE(strstr(undisturbed, "-0.1 (-hand.radius)") != NULL);
    EXPECT_TRUE(strstr(undisturbed, "wall.x <= ") != NULL);
    OK(critreg_skills_learn(skills, &callbacks, NULL));
    EXPECT_TRUE(world.runs == undisturbed_runs);
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_skills_add(skills, "Reach", NULL, NULL, REACH));
    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_skills_add_controller(skills, "More", "Paint", NULL, NULL, 0));
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_skills_add_task(skills, PROBLEM, RANGE, 2));
    free(skills);
}

/* Stops every few runs, and goes on: in the same memory, or from saved bytes. */
static void stopped_and_resumed(int every, int saving, uint32_t kept)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills;
    critreg_status status;
    static uint8_t bytes[65536];
    char found[4096];
    int stops = 0;
    memset(&world, 0, sizeof world);
    config.runs = kept;
    config.progress = progress;
    config.progress_data = &runs_left;
    skills = make(&config);
    for (;;) {
        size_t needed = 0;
        runs_left = every;
        status = critreg_skills_learn(skills, &callbacks, NULL);
        if (status == CRITREG_OK)
            break;
        EXPECT(CRITREG_CANCELLED, status);
        stops++;
        if (!saving)
            continue;
        EXPECT(CRITREG_TOO_SMALL, critreg_skills_save(skills, NULL, 0, &needed));
        EXPECT(CRITREG_TOO_SMALL, critreg_skills_save(skills, bytes, needed - 1, NULL));
        OK(critreg_skills_save(skills, bytes, sizeof bytes, &needed));
        free(skills);
        skills = make(&config);
        bytes[needed / 2] ^= 1;
        EXPECT(CRITREG_CORRUPT, critreg_skills_resume(skills, bytes, needed));
        bytes[needed / 2] ^= 1;
        EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_skills_resume(skills, bytes, needed));
        free(skills);
        skills = make(&config);
        OK(critreg_skills_resume(skills, bytes, needed));
    }
    EXPECT_TRUE(stops > 0);
    describe(skills, found, sizeof found);
    EXPECT_TRUE(strcmp(found, undisturbed) == 0);
    /* What was kept is not run again. */
    EXPECT_TRUE(kept < 256 || world.runs == undisturbed_runs);
    free(skills);
}

static void failing_callbacks(void)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills = make(&config);
    char words[256], found[4096];
    memset(&world, 0, sizeof world);
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_learn(skills, NULL, NULL));
    callbacks.execute = NULL;
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_learn(skills, &callbacks, NULL));
    callbacks = world_callbacks();
    callbacks.holds = NULL;
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_learn(skills, &callbacks, NULL));
    OK(critreg_skills_message(skills, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "holds is NULL") == 0);
    callbacks = world_callbacks();
    world.stop_at = 5;
    EXPECT(STOPPED, critreg_skills_learn(skills, &callbacks, NULL));
    OK(critreg_skills_message(skills, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "execute returned status 1007") == 0);
    EXPECT(CRITREG_NO_REGION, critreg_skills_format(skills, 0, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "it was not learned yet") == 0);
    world.nan = 1;
    EXPECT(CRITREG_NOT_FINITE, critreg_skills_learn(skills, &callbacks, NULL));
    expect_words(skills, "a number of the state that execute wrote");
    world.nan = 0;
    world.odd_holds = 1;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_learn(skills, &callbacks, NULL));
    OK(critreg_skills_message(skills, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "holds wrote neither 0 nor 1") == 0);
    world.odd_holds = 0;
    world.busy = skills;
    OK(critreg_skills_learn(skills, &callbacks, NULL));
    describe(skills, found, sizeof found);
    EXPECT_TRUE(strcmp(found, undisturbed) == 0);
    free(skills);
}

static void wrong_configurations(void)
{
    critreg_skills_config config = small(NULL);
    critreg_skills *skills = NULL;
    size_t bytes = critreg_skills_size(&config);
    uint64_t *memory = (uint64_t *)malloc(bytes);
    char words[256];
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_config_init(NULL, sizeof config));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_config_init(&config, sizeof config + 8));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_skills_init(NULL, bytes, PDDL, LAYOUT, &config, &skills));
    EXPECT(CRITREG_MISALIGNED,
           critreg_skills_init(ASKEW(void, memory), bytes, PDDL, LAYOUT, &config, &skills));
    EXPECT(CRITREG_TOO_SMALL,
           critreg_skills_init(memory, bytes - 1, PDDL, LAYOUT, &config, &skills));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_skills_init(memory, bytes, NULL, LAYOUT, &config, &skills));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_init(memory, bytes, PDDL, NULL, &config, &skills));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_init(memory, bytes, PDDL, LAYOUT, NULL, &skills));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_init(memory, bytes, PDDL, LAYOUT, &config, NULL));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_skills_init(memory, bytes, "(domain", LAYOUT, &config, &skills));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_skills_init(memory, bytes, PDDL, "object", &config, &skills));
    config.texts = 64;
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_skills_init(memory, bytes, PDDL, LAYOUT, &config, &skills));
    config.state_len = 0;
    EXPECT_TRUE(critreg_skills_size(&config) == 0);
    config.state_len = 1 + CRITREG_MAX_STATE_NUMBERS;
    EXPECT_TRUE(critreg_skills_size(&config) == 0);
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_init(memory, bytes, PDDL, LAYOUT, &config, &skills));
    EXPECT_TRUE(critreg_skills_size(NULL) == 0);
    memset(memory, 0, bytes);
    EXPECT(CRITREG_NOT_A_HANDLE,
           critreg_skills_message((critreg_skills *)memory, words, sizeof words, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_message(NULL, words, sizeof words, NULL));
    free(memory);
}

static void wrong_additions(void)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills = fresh(&config);
    const double upside_down[2] = {1.0, 0.0}, infinite[2] = {0.0, INFINITY};
    const double state[4] = {1.0, 0.0, NAN, 0.0};
    critreg_skill_report report;
    char text[512];
    int i;
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_skills_learn(skills, &callbacks, NULL));
    expect_words(skills, "add training tasks");
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_add_controller(skills, "Jump", NULL, NULL, NULL, 0));
    expect_words(skills, "no action of this name");
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_add_controller(skills, "Reach", NULL, "?v", RANGE, 1));
    expect_words(skills, "no variable of this name");
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_add_controller(skills, "Reach", NULL, NULL, upside_down, 1));
    EXPECT(CRITREG_NOT_FINITE,
           critreg_skills_add_controller(skills, "Reach", NULL, NULL, infinite, 1));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_skills_add_controller(skills, "Reach", NULL, NULL, NULL, 1));
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_skills_add_controller(skills, "Reach", NULL, NULL, RANGE, 7));
    OK(critreg_skills_add_controller(skills, "Reach", NULL, NULL, RANGE, 1));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_add_controller(skills, "reach", NULL, NULL, RANGE, 1));
    expect_words(skills, "added already");
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_skills_add_controller(skills, "Other", "Paint Reach", NULL, NULL, 0));
    expect_words(skills, "has a controller already");
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_add(skills, "Jump", NULL, NULL, REACH));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_add(skills, NULL, NULL, NULL, REACH));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_add(skills, "Reach", NULL, "Low", REACH));
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_skills_add(skills, "Reach", NULL, NULL, "object"));
    EXPECT(CRITREG_MISMATCH, critreg_skills_add(skills, "Paint", NULL, NULL, REACH));
    expect_words(skills, "more parameters than its controller");
    EXPECT(CRITREG_MISMATCH,
           critreg_skills_add(skills, "Reach", NULL, NULL, "object door { x: length }"));
    expect_words(skills, "is no role");
    EXPECT(CRITREG_MISMATCH, critreg_skills_add(skills, "Reach", "Paint", NULL, NULL));
    expect_words(skills, "first controller alone");
    OK(critreg_skills_add(skills, "Reach", NULL, "High", REACH));
    OK(critreg_skills_add(skills, "Reach", "Paint", NULL, NULL));
    OK(critreg_skills_domain(skills, 1, text, sizeof text, NULL));
    EXPECT_TRUE(strstr(text, "parameter reach in [0, 4]: length\n") != NULL);
    EXPECT(CRITREG_TOO_SMALL, critreg_skills_domain(skills, 1, text, 8, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_domain(skills, 2, text, sizeof text, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_format(skills, 2, text, sizeof text, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_skill_report_init(NULL, sizeof report));
    memset(&report, 0, sizeof report);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_report(skills, 0, &report));
    OK(critreg_skill_report_init(&report, sizeof report));
    OK(critreg_skills_report(skills, 0, &report));
    EXPECT_TRUE(report.finished == 0 && report.quality == CRITREG_NO_QUALITY);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_skills_report(skills, 2, &report));
    EXPECT(CRITREG_NOT_FINITE, critreg_skills_add_task(skills, PROBLEM, state, 3));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_skills_add_task(skills, PROBLEM, RANGE, 4));
    expect_words(skills, "config.state_len");
    EXPECT(CRITREG_MISMATCH, critreg_skills_add_task(skills, PROBLEM, RANGE, 2));
    expect_words(skills, "fewer numbers");
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_skills_add_task(skills, "(problem", RANGE, 2));
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_add_task(skills, PROBLEM, NULL, 3));
    /* What was refused took no room. */
    for (i = 0; i < 1000; i++)
        EXPECT(CRITREG_MISMATCH, critreg_skills_add_task(skills, PROBLEM, RANGE, 2));
    free(skills);
}

static void too_little_room(void)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    const double state[NUMBERS] = {1.0, 0.0, 0.0};
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills;
    memset(&world, 0, sizeof world);
    config.controllers = 1;
    config.skills = 1;
    config.tasks = 1;
    skills = fresh(&config);
    OK(critreg_skills_add_controller(skills, "Reach", NULL, NULL, RANGE, 1));
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_skills_add_controller(skills, "Paint", NULL, NULL, NULL, 0));
    expect_words(skills, "config.controllers");
    OK(critreg_skills_add(skills, "Reach", NULL, NULL, REACH));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_skills_add(skills, "Reach", NULL, NULL, REACH));
    expect_words(skills, "config.skills");
    OK(critreg_skills_add_task(skills, PROBLEM, state, NUMBERS));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_skills_add_task(skills, PROBLEM, state, NUMBERS));
    expect_words(skills, "config.tasks");
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_skills_learn(skills, &callbacks, NULL));
    expect_words(skills, "config.controllers");
    free(skills);
}

static critreg_planner *planner_of(uint64_t *memory, size_t bytes, const char *domain)
{
    critreg_planner_config config;
    critreg_planner *planner = NULL;
    OK(critreg_planner_config_init(&config, sizeof config));
    config.state_len = NUMBERS;
    OK(critreg_planner_init(memory, bytes, domain, PROBLEM, &config, &planner));
    return planner;
}

static void planning(void)
{
    static uint64_t memory[CRITREG_PLANNER_WORDS(NUMBERS)];
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_callbacks callbacks = world_callbacks();
    critreg_skills *skills = make(&config);
    critreg_planner *planner = planner_of(memory, sizeof memory, PDDL);
    double near[NUMBERS] = {2.0, 0.0, 0.0}, far[NUMBERS] = {3.0, 0.0, 0.0};
    uint64_t nothing[64] = {0};
    critreg_metrics metrics;
    char words[CRITREG_REASON_MAX], sentence[1024];
    uint32_t why = 0;
    memset(&world, 0, sizeof world);
    OK(critreg_skills_learn(skills, &callbacks, NULL));
    callbacks.skills = (critreg_skills *)nothing;
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_plan(planner, &callbacks, near, 1, NULL, NULL));
    callbacks.skills = skills;
    OK(critreg_plan(planner, &callbacks, near, 1, NULL, NULL));
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    OK(critreg_planner_metrics(planner, &metrics));
    EXPECT_TRUE(metrics.samples == 2 && metrics.informed_draws >= 1);
    OK(critreg_planner_reason_text(planner, words, sizeof words, NULL));
    EXPECT_TRUE(words[0] == '\0');
    /* A far wall cannot be painted: with pruning, nothing is run to find out. */
    callbacks.prune = 1;
    world.runs = 0;
    EXPECT(CRITREG_NO_PLAN, critreg_plan(planner, &callbacks, far, 1, NULL, NULL));
    EXPECT_TRUE(world.runs == 0);
    OK(critreg_planner_reason_text(planner, words, sizeof words, NULL));
    EXPECT_TRUE(strncmp(words, "Paint(w) needs w.x <= ", 22) == 0);
    EXPECT(CRITREG_TOO_SMALL, critreg_planner_reason_text(planner, words, 3, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_reason_text(NULL, words, 3, NULL));
    OK(critreg_planner_why(planner, &why, sentence, sizeof sentence, NULL));
    EXPECT_TRUE(why == CRITREG_WHY_PRUNED && strstr(sentence, "in the way: Paint(w)") != NULL);
    /* Skills may not be used while they are in use. */
    planner = planner_of(memory, sizeof memory, OTHER_PDDL);
    EXPECT(CRITREG_MISMATCH, critreg_plan(planner, &callbacks, near, 1, NULL, NULL));
    OK(critreg_planner_message(planner, words, sizeof words, NULL));
    EXPECT_TRUE(strstr(words, "another PDDL domain") != NULL);
    free(skills);
}

/* Saved skills of other tasks are refused. */
static void other_tasks(void)
{
    critreg_config learner = learner_config();
    critreg_skills_config config = small(&learner);
    critreg_skills *skills = make(&config);
    static uint8_t bytes[65536];
    size_t needed = 0;
    OK(critreg_skills_save(skills, bytes, sizeof bytes, &needed));
    free(skills);
    learner.seed = 5;
    skills = make(&config);
    EXPECT(CRITREG_MISMATCH, critreg_skills_resume(skills, bytes, needed));
    expect_words(skills, "other texts, tasks or settings");
    EXPECT(CRITREG_NULL_POINTER, critreg_skills_resume(skills, NULL, needed));
    free(skills);
}

int main(void)
{
    learn_undisturbed();
    stopped_and_resumed(7, 0, 256);
    stopped_and_resumed(7, 1, 256);
    stopped_and_resumed(60, 1, 10);
    failing_callbacks();
    wrong_configurations();
    wrong_additions();
    too_little_room();
    planning();
    other_tasks();
    return summary();
}
