/* Wrong planners: memory, texts, configurations, handles, ranges. */
#include "walk.h"

static uint64_t memory[CRITREG_PLANNER_WORDS(STATE)];
static uint64_t other[CRITREG_PLANNER_WORDS(STATE)];
static critreg_planner *const sentinel = (critreg_planner *)(void *)other;

static critreg_status init(const char *domain, const char *problem,
                           const critreg_planner_config *config)
{
    critreg_planner *planner = sentinel;
    critreg_status status =
        critreg_planner_init(memory, sizeof memory, domain, problem, config, &planner);
    EXPECT_TRUE((status == CRITREG_OK) == (planner != sentinel));
    return status;
}

static void wrong_memory(void)
{
    critreg_planner_config config = walk_config();
    critreg_planner *planner = sentinel;
    size_t size = critreg_planner_size(&config);

    EXPECT_TRUE(size > 0 && size <= sizeof memory);
    EXPECT_TRUE(critreg_planner_align() == sizeof(uint64_t));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_init(NULL, size, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_MISALIGNED,
           critreg_planner_init(ASKEW(void *, memory), size, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_TOO_SMALL,
           critreg_planner_init(memory, size - 1, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_TOO_SMALL, critreg_planner_init(memory, 0, WALK, TO_B, &config, &planner));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_init(memory, size, WALK, TO_B, &config, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_planner_init(memory, size, WALK, TO_B, &config,
                                                    ASKEW(critreg_planner *, other)));
    EXPECT_TRUE(planner == sentinel);
    OK(critreg_planner_init(memory, size, WALK, TO_B, &config, &planner));
}

static void enough_words(void)
{
    static const uint32_t texts[] = {256, 8192, 65536}, operators[] = {1, 17, 4096};
    static const uint32_t nodes[] = {1, 1000, 100000}, lengths[] = {1, 7, 128};
    static const uint32_t numbers[] = {1, 22, 1000};
    size_t t, o, n, l, s;
    for (t = 0; t < 3; t++)
        for (o = 0; o < 3; o++)
            for (n = 0; n < 3; n++)
                for (l = 0; l < 3; l++)
                    for (s = 0; s < 3; s++) {
                        critreg_planner_config config = walk_config();
                        size_t words = CRITREG_PLANNER_WORDS_FOR(texts[t], operators[o], nodes[n],
                                                                 lengths[l], numbers[s]);
                        config.pddl_bytes = texts[t];
                        config.operators = operators[o];
                        config.nodes = nodes[n];
                        config.max_length = lengths[l];
                        config.state_len = numbers[s];
                        EXPECT_TRUE(critreg_planner_size(&config) <= 8 * words);
                        EXPECT_TRUE(critreg_planner_size(&config) > 0);
                    }
}

static void wrong_configurations(void)
{
    critreg_planner_config config = walk_config(), wrong;
    size_t i;

    EXPECT(CRITREG_NULL_POINTER, critreg_planner_config_init(NULL, sizeof config));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_config_init(&wrong, sizeof wrong + 1));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_config_init(&wrong, 4));
    EXPECT(CRITREG_MISALIGNED, critreg_planner_config_init(ASKEW(critreg_planner_config, other),
                                                           sizeof config));
    EXPECT(CRITREG_NULL_POINTER, init(WALK, TO_B, NULL));
    EXPECT(CRITREG_MISALIGNED, init(WALK, TO_B, ASKEW(critreg_planner_config, other)));
    EXPECT_TRUE(critreg_planner_size(NULL) == 0);
    for (i = 0; i < 7; i++) {
        wrong = config;
        *(i == 0 ? &wrong.struct_size : i == 1 ? &wrong.heuristic : i == 2 ? &wrong.state_len
          : i == 3 ? &wrong.max_length : &wrong.max_tries) = 0;
        if (i == 5)
            wrong.heuristic = 5;
        if (i == 6)
            wrong.max_length = CRITREG_MAX_PLAN_LENGTH + 1;
        EXPECT(CRITREG_INVALID_ARGUMENT, init(WALK, TO_B, &wrong));
        /* A heuristic needs no memory. */
        EXPECT_TRUE((critreg_planner_size(&wrong) == 0) == (i != 1));
    }
    wrong = config;
    wrong.operators = UINT32_MAX;
    wrong.nodes = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(WALK, TO_B, &wrong));
    /* The texts, the ground operators: two walks and two lights at each place. */
    wrong = config;
    wrong.pddl_bytes = sizeof WALK + sizeof TO_B - 1;
    EXPECT(CRITREG_CAPACITY_EXCEEDED, init(WALK, TO_B, &wrong));
    wrong.pddl_bytes++;
    OK(init(WALK, TO_B, &wrong));
    wrong = config;
    wrong.operators = 5;
    EXPECT(CRITREG_CAPACITY_EXCEEDED, init(WALK, TO_B, &wrong));
    wrong.operators++;
    OK(init(WALK, TO_B, &wrong));
}

static void expect_words(const char *domain, const char *problem, critreg_status status,
                         const char *expected)
{
    critreg_planner_config config = walk_config();
    char why[128] = "";
    EXPECT(status, init(domain, problem, &config));
    EXPECT(status, critreg_check_pddl(domain, problem, why, sizeof why, NULL));
    EXPECT_TRUE(strcmp(why, expected) == 0);
}

static void wrong_texts(void)
{
    static char long_text[CRITREG_PDDL_TEXT_MAX + 1];
    char why[8];
    size_t needed = 0;

    expect_words(WALK, TO_B, CRITREG_OK, "");
    expect_words(NULL, TO_B, CRITREG_NULL_POINTER, "domain is NULL");
    expect_words(WALK, NULL, CRITREG_NULL_POINTER, "problem is NULL");
    expect_words("\xff", TO_B, CRITREG_INVALID_ARGUMENT, "the text is not UTF-8");
    expect_words("(define\n (banana walk))", TO_B, CRITREG_SYNTAX_ERROR,
                 "domain, line 2, column 3: expected `(define (domain`, a name and `)`");
    expect_words(WALK, "(define (problem p) (:domain walk) (:objects a - place)\n (:init (At b)) (:goal ()))",
                 CRITREG_SYNTAX_ERROR, "problem, line 2, column 13: unknown object");
    expect_words(WALK, "(define (problem p) (:domain talk) (:init) (:goal ()))",
                 CRITREG_SYNTAX_ERROR,
                 "problem, line 1, column 30: the problem belongs to another domain");
    memset(long_text, ' ', sizeof long_text - 1);
    expect_words(WALK, long_text, CRITREG_CAPACITY_EXCEEDED, "no room left: the text is too long");

    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_pddl("", TO_B, NULL, 0, &needed));
    EXPECT_TRUE(needed > sizeof why);
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_pddl("", TO_B, why, sizeof why, NULL));
    EXPECT_TRUE(strcmp(why, "domain,") == 0);
    EXPECT(CRITREG_NULL_POINTER, critreg_check_pddl(WALK, TO_B, NULL, 1, NULL));
}

/* Sets of atoms of every size, and what is said where they are too small. */
static void sizes_of_sets(void)
{
    static const double speed[2] = {0.0, 1.0};
    static const uint32_t atoms[] = {1, 128, 129, 512, 513, 1024};
    static uint64_t large[CRITREG_PLANNER_WORDS_OF(8192, 256, 4096, 1024, 700, 32, STATE)];
    critreg_planner_config config = walk_config();
    critreg_planner *planner = NULL;
    size_t i;

    for (i = 1; i < 6; i++) {
        config.atoms = atoms[i];
        config.facts = 700;
        EXPECT_TRUE(critreg_planner_size(&config)
                    <= 8 * CRITREG_PLANNER_WORDS_OF(8192, 256, 4096, atoms[i], 700, 32, STATE));
        OK(critreg_planner_init(large, sizeof large, WALK, TO_B, &config, &planner));
        OK(critreg_planner_set_ranges(planner, "Walk", speed, 1));
        expect_plan(planner);
    }
    config.atoms = 3;
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_planner_init(large, sizeof large, WALK, TO_B, &config, &planner));
    config.atoms = 1025;
    EXPECT_TRUE(critreg_planner_size(&config) == 0);
}

/* What texts need is what is asked for, and enough. */
static void measured(void)
{
    critreg_planner_config config = walk_config(), wrong;
    static const double speed[2] = {0.0, 1.0};
    critreg_planner *planner = NULL;

    OK(critreg_planner_measure(WALK, TO_B, &config));
    EXPECT_TRUE(config.pddl_bytes == strlen(WALK) + strlen(TO_B) + 2);
    EXPECT_TRUE(config.operators == 6 && config.atoms == 4 && config.facts == 1);
    EXPECT_TRUE(config.state_len == STATE && config.max_tries == 10);
    OK(critreg_planner_init(memory, sizeof memory, WALK, TO_B, &config, &planner));
    OK(critreg_planner_set_ranges(planner, "Walk", speed, 1));
    expect_plan(planner);
    wrong = config;
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_planner_measure("", TO_B, &wrong));
    EXPECT_TRUE(memcmp(&wrong, &config, sizeof config) == 0);
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_measure(WALK, TO_B, NULL));
    wrong.struct_size = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_measure(WALK, TO_B, &wrong));
}

/* Every function refuses what is no planner. */
static void no_handle(critreg_planner *planner, critreg_status expected)
{
    critreg_callbacks callbacks = all_callbacks();
    critreg_metrics metrics;
    critreg_step step;
    walker own = CALM;
    size_t number;
    uint32_t count;
    char text[64];

    EXPECT(expected, critreg_planner_set_ranges(planner, "Walk", NULL, 0));
    EXPECT(expected, critreg_plan(planner, &callbacks, DARK, 1, &own, &number));
    EXPECT_TRUE(own.holds == 0);
    OK(critreg_metrics_init(&metrics, sizeof metrics));
    EXPECT(expected, critreg_planner_metrics(planner, &metrics));
    EXPECT(expected, critreg_planner_failures(planner, "Walk", &count));
    EXPECT(expected, critreg_planner_reasons(planner, 0, &count));
    OK(critreg_step_init(&step, sizeof step));
    EXPECT(expected, critreg_planner_step(planner, 0, &step));
    EXPECT(expected, critreg_planner_message(planner, text, sizeof text, &number));
}

static void wrong_handles(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    critreg_planner_config config = walk_config();

    no_handle(NULL, CRITREG_NULL_POINTER);
    no_handle(ASKEW(critreg_planner, memory), CRITREG_MISALIGNED);
    memset(other, 0xA5, sizeof other);
    no_handle((critreg_planner *)(void *)other, CRITREG_NOT_A_HANDLE);
    memcpy(other, memory, sizeof memory);
    no_handle((critreg_planner *)(void *)other, CRITREG_NOT_A_HANDLE);
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_region_save((critreg_region *)(void *)planner, NULL, 0,
                                                     NULL));
    expect_plan(planner);
    /* What could not be made anew is no longer what it was. */
    EXPECT(CRITREG_SYNTAX_ERROR, init("", TO_B, &config));
    no_handle(planner, CRITREG_NOT_A_HANDLE);
}

static void wrong_ranges(void)
{
    critreg_planner *planner = walk_planner(memory, sizeof memory);
    double ranges[14] = {0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0};
    const double wrong[][2] = {{(double)NAN, 1.0}, {0.0, (double)INFINITY}, {1.0, 0.5}};
    char words[128];

    EXPECT(CRITREG_NULL_POINTER, critreg_planner_set_ranges(planner, NULL, ranges, 1));
    EXPECT(CRITREG_NULL_POINTER, critreg_planner_set_ranges(planner, "Walk", NULL, 1));
    EXPECT(CRITREG_MISALIGNED,
           critreg_planner_set_ranges(planner, "Walk", ASKEW(double, ranges), 1));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_planner_set_ranges(planner, "Walk", ranges, 7));
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_planner_set_ranges(planner, "Walk", ranges, SIZE_MAX));
    EXPECT(CRITREG_NOT_FINITE, critreg_planner_set_ranges(planner, "Walk", wrong[0], 1));
    EXPECT(CRITREG_NOT_FINITE, critreg_planner_set_ranges(planner, "Walk", wrong[1], 1));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_set_ranges(planner, "Walk", wrong[2], 1));
    OK(critreg_planner_message(planner, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "a range ends below its beginning") == 0);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_planner_set_ranges(planner, "Run", ranges, 1));
    expect_plan(planner);
    OK(critreg_planner_set_ranges(planner, "Walk", ranges, CRITREG_MAX_PARAMETERS));
    OK(critreg_planner_set_ranges(planner, "wALK", ranges, 1));
    expect_plan(planner);
}

int main(void)
{
    wrong_memory();
    enough_words();
    wrong_configurations();
    wrong_texts();
    sizes_of_sets();
    measured();
    wrong_handles();
    wrong_ranges();
    return summary();
}
