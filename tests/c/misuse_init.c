/* Wrong memory, texts and configurations; sizes. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static critreg_learner *learner;

static critreg_status init(const char *domain, const critreg_config *config)
{
    return critreg_learner_init(memory, sizeof memory, domain, config, &learner);
}

static void wrong_arguments(void)
{
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_init(NULL, sizeof memory, DOMAIN, NULL, &learner));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_init(ASKEW(void *, memory), sizeof memory - 8,
                                                    DOMAIN, NULL, &learner));
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_init(memory, 0, DOMAIN, NULL, &learner));
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_init(memory, 1000, DOMAIN, NULL, &learner));
    EXPECT(CRITREG_NULL_POINTER, init(NULL, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_init(memory, sizeof memory, DOMAIN, NULL, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_init(memory, sizeof memory, DOMAIN, NULL,
                                                    ASKEW(critreg_learner *, memory)));
}

/* There must be something to learn about. */
static void empty_domains(void)
{
    static const char *const texts[] = {"", " \n", "# nothing", "constant a = 1: length",
                                        "type block { x: length }", "object wall { }"};
    static uint64_t room[CRITREG_REGION_WORDS];
    critreg_region *region;
    char why[128];
    size_t i;

    for (i = 0; i < sizeof texts / sizeof *texts; i++) {
        EXPECT(CRITREG_SYNTAX_ERROR, init(texts[i], NULL));
        EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_domain(texts[i], why, sizeof why, NULL));
        EXPECT_TRUE(strstr(why, ": expected an object with an attribute, or a parameter") != NULL);
        EXPECT(CRITREG_SYNTAX_ERROR,
               critreg_region_parse(room, sizeof room, texts[i], "true", &region));
    }
    OK(init("object wall { x: length }", NULL));
    OK(init("parameter reach in [0, 4]", NULL));
}

static void wrong_texts(void)
{
    static char long_text[CRITREG_DOMAIN_TEXT_MAX + 1];
    static char many[1024];
    char why[128] = "";
    critreg_config thesis;
    size_t needed = 0;
    int i;

    EXPECT(CRITREG_SYNTAX_ERROR, init("object wall { x: lenght }", NULL));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_check_domain("object wall {\n  x: lenght }", why, sizeof why, &needed));
    EXPECT_TRUE(strncmp(why, "line 2, column 6: ", 18) == 0);
    EXPECT_TRUE(needed == strlen(why) + 1);
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_domain("banana", why, 8, &needed));
    EXPECT_TRUE(strcmp(why, "line 1,") == 0 && needed > 8);
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_domain("banana", NULL, 0, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_check_domain("banana", NULL, 8, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_check_domain(NULL, why, sizeof why, NULL));
    EXPECT_TRUE(strcmp(why, "domain is NULL") == 0);
    EXPECT(CRITREG_MISALIGNED,
           critreg_check_domain(DOMAIN, why, sizeof why, ASKEW(size_t, memory)));
    OK(critreg_check_domain(DOMAIN, why, sizeof why, &needed));
    EXPECT_TRUE(why[0] == '\0' && needed == 1);

    EXPECT(CRITREG_INVALID_ARGUMENT, init("object \xff", NULL));
    /* Only one learner learns about actions without parameters. */
    OK(critreg_config_init(&thesis, sizeof thesis));
    thesis.learner = CRITREG_ALGORITHM1;
    EXPECT(CRITREG_INVALID_ARGUMENT, init("object wall { x: length }", &thesis));
    OK(init("object wall { x: length }", NULL));

    memset(long_text, ' ', CRITREG_DOMAIN_TEXT_MAX);
    memcpy(long_text, DOMAIN, sizeof DOMAIN - 1);
    EXPECT(CRITREG_CAPACITY_EXCEEDED, init(long_text, NULL));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_check_domain(long_text, NULL, 0, NULL));
    long_text[CRITREG_DOMAIN_TEXT_MAX - 1] = '\0';
    OK(init(long_text, NULL));

    for (i = 0; i < 7; i++)
        sprintf(many + strlen(many), "parameter p%d in [0, 1]\n", i);
    EXPECT(CRITREG_CAPACITY_EXCEEDED, init(many, NULL));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_check_domain(many, why, sizeof why, NULL));
}

static void wrong_configurations(void)
{
    const critreg_status too_many = kind == CRITREG_ALGORITHM1 ? CRITREG_TOO_SMALL
                                                               : CRITREG_INVALID_ARGUMENT;
    critreg_config config = reach_config();
    critreg_report report;

    EXPECT(CRITREG_NULL_POINTER, critreg_config_init(NULL, sizeof config));
    EXPECT(CRITREG_MISALIGNED, critreg_config_init(ASKEW(critreg_config, memory), sizeof config));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_config_init(&config, 0));
    /* The first version of the struct ended before `tracked`. */
    OK(critreg_config_init(&config, offsetof(critreg_config, tracked)));
    EXPECT_TRUE(critreg_learner_size(&config) > 0);
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_config_init(&config, offsetof(critreg_config, tracked) - 8));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_config_init(&config, sizeof config + 8));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_config_init(&config, SIZE_MAX));
    EXPECT(CRITREG_NULL_POINTER, critreg_report_init(NULL, sizeof report));
    EXPECT(CRITREG_MISALIGNED, critreg_report_init(ASKEW(critreg_report, memory), sizeof report));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_report_init(&report, 0));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_report_init(&report, sizeof report + 8));

    EXPECT(CRITREG_MISALIGNED, init(DOMAIN, ASKEW(critreg_config, memory)));
    config = reach_config();
    config.struct_size = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.struct_size = sizeof config + 8;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config = reach_config();
    config.learner = 99;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config = reach_config();
    config.forms = 3;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.forms = 1000000;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config.forms = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config.observations = UINT32_MAX;
    EXPECT(too_many, init(DOMAIN, &config));
    config = reach_config();
    config.forms = 0;
    config.observations = UINT32_MAX;
    EXPECT(too_many, init(DOMAIN, &config));
    EXPECT_TRUE((critreg_learner_size(&config) == 0) == (too_many != CRITREG_TOO_SMALL));
    config.observations = 0;
    config.calls = UINT32_MAX;
    EXPECT(too_many, init(DOMAIN, &config));
}

static void wrong_manual_samples(void)
{
    const double not_a_number = (double)NAN, infinite = (double)INFINITY, outside = 4.5;
    critreg_config config;

    kind = CRITREG_ALGORITHM1;
    config = reach_config();
    config.negative = &not_a_number;
    EXPECT(CRITREG_NOT_FINITE, init(DOMAIN, &config));
    config.negative = &infinite;
    EXPECT(CRITREG_NOT_FINITE, init(DOMAIN, &config));
    config.negative = &outside;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.negative = ASKEW(double, memory);
    EXPECT(CRITREG_MISALIGNED, init(DOMAIN, &config));
    config = reach_config();
    config.positive = &not_a_number;
    EXPECT(CRITREG_NOT_FINITE, init(DOMAIN, &config));
    config.learner = CRITREG_VERSION_SPACE;     /* which does not read it */
    OK(init(DOMAIN, &config));
}

/* What only the version space reads. */
static void wrong_shares_and_sizes(void)
{
    static const double wrong[] = {-0.001, 1.001, 1e300, -1e300};
    static const double unfinite[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    static const uint32_t steps[] = {0, CRITREG_MAX_STEPS + 1, UINT32_MAX};
    critreg_config config;
    size_t i, field;

    kind = CRITREG_VERSION_SPACE;
    for (i = 0; i < 7; i++) {
        for (field = 0; field < 4; field++) {
            double *shares[4];
            config = reach_config();
            shares[0] = &config.noise;
            shares[1] = &config.exploring;
            shares[2] = &config.slack;
            shares[3] = &config.confidence;
            *shares[field] = i < 4 ? wrong[i] : unfinite[i - 4];
            EXPECT(i < 4 ? CRITREG_INVALID_ARGUMENT : CRITREG_NOT_FINITE, init(DOMAIN, &config));
            config.learner = CRITREG_ALGORITHM1;
            OK(init(DOMAIN, &config));
        }
    }
    config = reach_config();
    config.noise = 0.25;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    for (i = 0; i < 3; i++) {
        config = reach_config();
        config.steps = steps[i];
        EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
        EXPECT_TRUE(critreg_learner_size(&config) == 0);
    }
    config = reach_config();
    config.instances = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.instances = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config = reach_config();
    config.observations = CRITREG_MAX_OBSERVATIONS + 1;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.observations = CRITREG_MAX_OBSERVATIONS;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
}

/* What the header says about the defaults. */
static void defaults(void)
{
    critreg_config config;

    OK(critreg_config_init(&config, sizeof config));
    EXPECT_TRUE(config.struct_size == sizeof config && config.learner == CRITREG_VERSION_SPACE);
    EXPECT_TRUE(config.seed == 0 && config.forms == 0 && config.observations == 0);
    EXPECT_TRUE(config.calls == 100 && config.certifying == 10 && config.steps == 1);
    EXPECT_TRUE(config.instances == CRITREG_DEFAULT_INSTANCES);
    EXPECT_TRUE(config.noise == 0.0 && config.exploring == 0.1 && config.slack == 0.05);
    EXPECT_TRUE(config.confidence == 0.95);
    EXPECT_TRUE(config.negative == NULL && config.positive == NULL);
    EXPECT_TRUE(config.progress == NULL && config.progress_data == NULL);
}

/* The macro is enough and not much more; one byte less than the exact size is not
 * enough. */
static void size_of_one(uint32_t forms, uint32_t observations, uint32_t instances,
                        uint32_t steps)
{
    size_t bytes = CRITREG_LEARNER_WORDS_FOR(forms, observations, instances, steps)
                   * sizeof(uint64_t);
    critreg_config config = reach_config();
    uint64_t *own = (uint64_t *)malloc(bytes);
    size_t size;

    config.forms = forms;
    config.observations = observations;
    config.instances = instances;
    config.steps = steps;
    size = critreg_learner_size(&config);
    EXPECT_TRUE(size > 0 && size <= bytes && own != NULL);
    if (kind == CRITREG_VERSION_SPACE && forms < 400000)
        EXPECT_TRUE(size + 4096 > bytes * 9 / 10);
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_init(own, size - 1, DOMAIN, &config, &learner));
    OK(critreg_learner_init(own, size, DOMAIN, &config, &learner));
    free(own);
}

static void sizes(void)
{
    static const uint32_t some[] = {4, 7, 64, 1000, 1024, 4096, 20000, 65536, 1000000};
    static const uint32_t observations[] = {1, 2, 64, 102, 256, CRITREG_MAX_OBSERVATIONS};
    size_t i, j;

    EXPECT_TRUE(critreg_learner_align() == 8 || critreg_learner_align() == 4);
    EXPECT_TRUE(critreg_region_align() <= sizeof(uint64_t));
    EXPECT_TRUE(critreg_region_size() <= CRITREG_REGION_WORDS * sizeof(uint64_t));
    EXPECT_TRUE(critreg_region_size() > CRITREG_REGION_WORDS * sizeof(uint64_t) * 9 / 10);
    EXPECT_TRUE(critreg_learner_size(NULL) <= 8 * CRITREG_LEARNER_WORDS(4096, 256));
    EXPECT_TRUE(critreg_learner_size(ASKEW(critreg_config, memory)) == 0);
    for (i = 0; i < sizeof some / sizeof *some; i++) {
        for (j = 0; j < sizeof observations / sizeof *observations; j++) {
            /* What is large is also slow to fill. */
            if (some[i] > 65536 && j > 1)
                continue;
            size_of_one(some[i], observations[j], CRITREG_DEFAULT_INSTANCES, 1);
            size_of_one(some[i], observations[j], 1, CRITREG_MAX_STEPS);
        }
        size_of_one(some[i], 100, 64, 2);
    }
}

/* Without a number of forms the memory decides, and nothing behind it is
 * touched. */
static void capacity_from_memory(void)
{
    static uint64_t large[CRITREG_LEARNER_WORDS(4096, 256)];
    unsigned char *bytes = (unsigned char *)large;
    critreg_config config;
    critreg_report report;
    size_t len, i, instance;
    double task[13], theta;

    OK(critreg_config_init(&config, sizeof config));
    config.learner = kind;
    OK(critreg_stick_button_task(1, 0, 1, task, 13));
    OK(critreg_learner_init(large, sizeof large, critreg_stick_button_domain(), &config, &learner));
    OK(critreg_ask(learner, task, 1, &instance, &theta));
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.kept >= 4096 || report.left_out == 0);
    EXPECT_TRUE(report.enumerated == report.kept + report.left_out);
    config.forms = 4096;
    config.observations = 256;
    OK(critreg_learner_init(large, sizeof large, critreg_stick_button_domain(), &config, &learner));
    config.forms = 0;
    for (len = 0; len < sizeof large; len += 9901) {
        critreg_status status;
        int untouched = 1;
        memset(bytes, 0xA5, sizeof large);
        status = critreg_learner_init(large, len, DOMAIN, &config, &learner);
        EXPECT_TRUE(status == CRITREG_OK || status == CRITREG_TOO_SMALL);
        if (status == CRITREG_OK)
            (void)critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, NULL);
        for (i = len; i < sizeof large; i++)
            untouched &= bytes[i] == 0xA5;
        EXPECT_TRUE(untouched);
    }
}

/* A learner or region that a failed call wrote over is none any more. */
static void failure_retires(void)
{
    static uint64_t region_memory[CRITREG_REGION_WORDS];
    critreg_learner *made, *again = NULL;
    critreg_region *region, *other = NULL;
    int32_t finished;
    size_t len;
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, NULL, &made));
    OK(critreg_is_finished(made, &finished));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_learner_init(memory, sizeof memory, "object", NULL, &again));
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_is_finished(made, &finished));
    OK(critreg_region_parse(region_memory, sizeof region_memory, DOMAIN, "true", &region));
    OK(critreg_region_instance_len(region, &len));
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_region_parse(region_memory, sizeof region_memory, DOMAIN,
                                                      "nothing", &other));
    EXPECT(CRITREG_NOT_A_HANDLE, critreg_region_instance_len(region, &len));
    EXPECT_TRUE(again == NULL && other == NULL);
}

static void tests(void)
{
    critreg_learner *const sentinel = (critreg_learner *)(void *)&failures;

    learner = sentinel;
    wrong_configurations();
    EXPECT_TRUE(learner == sentinel);
    sizes();
    capacity_from_memory();
    failure_retires();
    expect_usable(reach_learner(memory, sizeof memory));
}

int main(void)
{
    critreg_learner *const sentinel = (critreg_learner *)(void *)&failures;

    learner = sentinel;
    wrong_arguments();
    EXPECT_TRUE(learner == sentinel);
    empty_domains();
    wrong_texts();
    wrong_manual_samples();
    wrong_shares_and_sizes();
    defaults();
    with_each_learner(tests);
    return summary();
}
