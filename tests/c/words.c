/* What is wrong with a configuration or a text is told in words that name it. */
#include "expect.h"

static char words[256];

/* Checks a configuration that init changed, and what is said of it. */
static void config_says(void (*change)(critreg_config *), critreg_status status,
                        const char *said)
{
    critreg_config config;
    OK(critreg_config_init(&config, sizeof config));
    change(&config);
    EXPECT(status, critreg_check_config(&config, words, sizeof words, NULL));
    EXPECT_TRUE(strstr(words, said) != NULL);
    if (strstr(words, said) == NULL)
        fprintf(stderr, "%s instead of %s\n", words, said);
}

static void nothing(critreg_config *config) { (void)config; }
static void noise(critreg_config *config) { config->noise = 0.5; }
static void nan_slack(critreg_config *config) { config->slack = NAN; }
static void steps(critreg_config *config) { config->steps = 7; }
static void observations(critreg_config *config) { config->observations = 5000; }
static void size(critreg_config *config) { config->struct_size = 3; }
static void number(critreg_config *config) { config->learner = 9; }
static void forms(critreg_config *config) { config->forms = 2; }
static void questions(critreg_config *config) { config->questions = 65; }

static void configurations(void)
{
    config_says(nothing, CRITREG_OK, "");
    EXPECT_TRUE(words[0] == 0);
    config_says(noise, CRITREG_INVALID_ARGUMENT, "config.noise is from 0 to 0.2, not 0.5");
    config_says(nan_slack, CRITREG_NOT_FINITE, "config.slack is from 0 to 0.2, and not NaN");
    config_says(steps, CRITREG_INVALID_ARGUMENT, "config.steps is from 1 to 4, not 7");
    config_says(observations, CRITREG_INVALID_ARGUMENT, "is up to 2048, not 5000");
    config_says(size, CRITREG_INVALID_ARGUMENT, "struct_size");
    config_says(number, CRITREG_INVALID_ARGUMENT, "no learner with this number");
    config_says(forms, CRITREG_INVALID_ARGUMENT, "at least four forms");
    config_says(questions, CRITREG_INVALID_ARGUMENT, "config.questions");
    OK(critreg_check_config(NULL, words, sizeof words, NULL));
}

static void texts(void)
{
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_check_domain("parameter a in [0, 1]: length\n"
                                "point p1 = world + (a, 0) point p2 = world + (a, 1)\n"
                                "point p3 = world + (a, 2) point p4 = world + (a, 3)\n"
                                "point p5 = world + (a, 4) point p6 = world + (a, 5)\n"
                                "point p7 = world + (a, 6) point p8 = world + (a, 7)\n"
                                "point p9 = world + (a, 8)",
                                words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "9 points move with a parameter, 8 fit") == 0);
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_check_region(DOMAIN, "reach <= wall.x ^ 2", words, sizeof words, NULL));
    EXPECT_TRUE(strstr(words, "line 1, column 17: there are no powers") == words);
}

/* Of a name that is not there, which one was meant, if one is like it. */
static void region_says(const char *region, const char *end)
{
    size_t length = strlen(end), said;
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_region(DOMAIN, region, words, sizeof words, NULL));
    said = strlen(words);
    EXPECT_TRUE(said >= length && strcmp(words + said - length, end) == 0);
    if (said < length || strcmp(words + said - length, end) != 0)
        fprintf(stderr, "%s does not end with %s\n", words, end);
}

static void names(void)
{
    region_says("reahc <= 1", "; did you mean reach?");
    region_says("\n  reach <= 1 and hand.y <=\n wal.x", "; did you mean wall.x?");
    region_says("hand.xx <= 1", "; did you mean hand.x?");
    region_says("reach <= hand.radus", "; did you mean hand.radius?");
    region_says("dist(hnd, wall) <= 1", "; did you mean hand?");
    region_says("banana <= 1", "coordinate of a point");
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_check_domain("constant size = 1: length\nparameter a in [0, sise]: length",
                                words, sizeof words, NULL));
    EXPECT_TRUE(strstr(words, "; did you mean size?") != NULL);
}

/* Which number of which instance is wrong. */
static void numbers(void)
{
    static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    double walls[INSTANCES * 2], theta;
    size_t instance;
    memcpy(walls, WALLS, sizeof walls);
    walls[5] = NAN;
    EXPECT(CRITREG_NOT_FINITE, critreg_ask(learner, walls, INSTANCES, &instance, &theta));
    OK(critreg_learner_message(learner, words, sizeof words, NULL));
    EXPECT_TRUE(strcmp(words, "instance 2: wall.y, its number 1, is NaN or infinite") == 0);
    expect_usable(learner);
}

int main(void)
{
    configurations();
    texts();
    names();
    numbers();
    return summary();
}
