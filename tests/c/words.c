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

int main(void)
{
    configurations();
    texts();
    return summary();
}
