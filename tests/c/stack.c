/* How much stack each function takes, by painting the stack of a thread; the manual's bounds
 * are held, in a release build on a machine with pointers of 64 bits. */
#define _DEFAULT_SOURCE 1
#include <pthread.h>

#include "expect.h"
#include "walk.h"

#define KIB 1024
#define STACK_BYTES (1024 * KIB)
#define PAINT 0xA5

static unsigned char stack[STACK_BYTES] __attribute__((aligned(4096)));
static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t other_memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t planner_memory[CRITREG_PLANNER_WORDS(STATE)];
static uint64_t region_memory[CRITREG_REGION_WORDS];
static uint8_t bytes[65536];
static char text[4096];
static size_t len;
static critreg_learner *learner;
static critreg_planner *planner;
static const critreg_region *learned;
static critreg_region *region;

/* Everything that a domain text can say, nested as deep as it can be. */
static const char RICH[] =
    "object item { x: length, y: length, theta: angle, width: length, depth: length }\n"
    "object tray { x: length, y: length, theta: angle, width: length, depth: length }\n"
    "object can[6] { x: length, y: length, radius: length }\n"
    "parameter u in [-1, 1]: length\n"
    "parameter v in [-1, 1]: length\n"
    "point place = tray turned (0.1 * (1 + (1 + (1 + (1 + (1 + 1)))))) + (u, v)\n"
    "shape item = rectangle(item.width, item.depth) centred\n"
    "shape tray = rectangle(tray.width, tray.depth) centred\n"
    "shape can = circle(can.radius)\n"
    "shape place = rectangle(item.width, item.depth) centred\n";
static const char NESTED[] =
    "(((((((((((inside(place, tray) >= ((((((((((0.01)))))))))))))))))))))"
    " and min(clear(place, can)) >= 0 and not (u > 0.9 or v > 0.9)";
static const double RICH_INSTANCE[28] = {0, 0, 0, 0.2, 0.1, 1, 1, 0.3, 3, 3, 2, 2, 0.1,
                                         0.2, 1.1, 0.1, 1.6, 1.6, 0.1, 0, 2, 0.2, 2, 0, 0.1,
                                         3, 3, 0.1};

static void learner_init(void)
{
    critreg_config config = reach_config();
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
}

static void rich_learner_init(void)
{
    critreg_learner *rich;
    OK(critreg_learner_init(other_memory, sizeof other_memory, RICH, NULL, &rich));
}

static void learn(void)
{
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &learned));
}

static void ask_and_tell(void)
{
    double theta;
    size_t instance;
    critreg_learner *own;
    critreg_config config = reach_config();
    OK(critreg_learner_init(other_memory, sizeof other_memory, DOMAIN, &config, &own));
    OK(critreg_ask(own, WALLS, INSTANCES, &instance, &theta));
    OK(critreg_tell(own, WALLS, INSTANCES, CRITREG_UNKNOWN));
}

static void save_learner(void)
{
    OK(critreg_learner_save(learner, WALLS, INSTANCES, bytes, sizeof bytes, &len));
}

static void resume(void)
{
    critreg_learner *own;
    critreg_config config = reach_config();
    OK(critreg_learner_init(other_memory, sizeof other_memory, DOMAIN, &config, &own));
    OK(critreg_learner_resume(own, WALLS, INSTANCES, bytes, len));
}

static void parse(void)
{
    OK(critreg_region_parse(region_memory, sizeof region_memory, RICH, NESTED, &region));
}

static void save(void) { OK(critreg_region_save(region, bytes, sizeof bytes, &len)); }

static void load(void)
{
    OK(critreg_region_load(region_memory, sizeof region_memory, bytes, len, &region));
}

static void format(void) { OK(critreg_region_format(region, text, sizeof text, NULL)); }

static void draw(void)
{
    critreg_rng rng = critreg_rng_seed(7);
    double theta[2];
    OK(critreg_sample_region(learned, WALLS, &rng, theta));
    critreg_sample_region(region, RICH_INSTANCE, &rng, theta);
}

static void draw_from_several(void)
{
    critreg_rng rng = critreg_rng_seed(7);
    const critreg_region *regions[2] = {region, region};
    const double *instances[2] = {RICH_INSTANCE, RICH_INSTANCE};
    double theta[2];
    critreg_sample_regions(regions, instances, 2, &rng, theta);
}

static void look(void)
{
    double ends[2 * CRITREG_MAX_INTERVALS], theta[2] = {0, 0};
    int32_t answer;
    size_t count;
    OK(critreg_region_contains(region, RICH_INSTANCE, theta, &answer));
    OK(critreg_region_is_empty(region, RICH_INSTANCE, &answer));
    OK(critreg_region_intervals(learned, WALLS, ends, CRITREG_MAX_INTERVALS, &count));
}

static void prove(void)
{
    double ranges[56], instance[28], theta[2];
    critreg_proof proof;
    size_t i;
    for (i = 0; i < 28; i++) {
        ranges[2 * i] = RICH_INSTANCE[i] - 0.05;
        ranges[2 * i + 1] = RICH_INSTANCE[i] + 0.05;
    }
    /* Sizes are above zero. */
    for (i = 0; i < 56; i++)
        ranges[i] += 1.0;
    OK(critreg_proof_init(&proof, sizeof proof));
    proof.max_boxes = 100;
    OK(critreg_region_implies(region, region, ranges, &proof, instance, theta));
}

static void check_domain(void) { OK(critreg_check_domain(RICH, text, sizeof text, NULL)); }

static void check_region(void) { OK(critreg_check_region(RICH, NESTED, text, sizeof text, NULL)); }

static void check_pddl(void) { OK(critreg_check_pddl(WALK, TO_B, text, sizeof text, NULL)); }

static void measure(void)
{
    critreg_planner_config config;
    OK(critreg_planner_config_init(&config, sizeof config));
    OK(critreg_planner_measure(WALK, TO_B, &config));
}

static void planner_init(void) { planner = walk_planner(planner_memory, sizeof planner_memory); }

static void plan(void)
{
    walker own = CALM;
    critreg_callbacks callbacks = all_callbacks();
    OK(critreg_plan(planner, &callbacks, DARK, 1, &own, NULL));
}

static void *paint_and_call(void *data)
{
    (*(void (**)(void))data)();
    return NULL;
}

static size_t stack_of(void (*call)(void))
{
    pthread_attr_t attributes;
    pthread_t thread;
    size_t untouched = 0;
    memset(stack, PAINT, sizeof stack);
    EXPECT_TRUE(pthread_attr_init(&attributes) == 0);
    EXPECT_TRUE(pthread_attr_setstack(&attributes, stack, sizeof stack) == 0);
    EXPECT_TRUE(pthread_create(&thread, &attributes, paint_and_call, &call) == 0);
    EXPECT_TRUE(pthread_join(thread, NULL) == 0);
    while (untouched < sizeof stack && stack[untouched] == PAINT)
        untouched++;
    return sizeof stack - untouched;
}

static void nothing(void) {}

int main(void)
{
    /* In an order in which each finds what it needs. */
    static const struct {
        const char *name;
        void (*call)(void);
        size_t bound;
    } calls[] = {
        {"learner_init", learner_init, 24 * KIB},     {"learner_init, rich", rich_learner_init, 24 * KIB},
        {"learn_region", learn, 16 * KIB},            {"ask, tell", ask_and_tell, 24 * KIB},
        {"learner_save", save_learner, 4 * KIB},     {"learner_resume", resume, 24 * KIB},
        {"region_parse", parse, 12 * KIB},            {"region_save", save, 4 * KIB},
        {"region_load", load, 8 * KIB},              {"region_format", format, 4 * KIB},
        {"sample_region", draw, 12 * KIB},            {"sample_regions", draw_from_several, 28 * KIB},
        {"contains, is_empty, intervals", look, 28 * KIB},
        {"region_implies", prove, 96 * KIB},
        {"check_domain", check_domain, 24 * KIB},     {"check_region", check_region, 32 * KIB},
        {"check_pddl", check_pddl, 320 * KIB},         {"planner_measure", measure, 320 * KIB},
        {"planner_init", planner_init, 192 * KIB},     {"plan", plan, 56 * KIB},
    };
    size_t i, thread = stack_of(nothing);
    for (i = 0; i < sizeof calls / sizeof *calls; i++) {
        size_t used = stack_of(calls[i].call) - thread;
        printf("%-32s %6u\n", calls[i].name, (unsigned)used);
        EXPECT_TRUE(used <= calls[i].bound);
    }
    return summary();
}
