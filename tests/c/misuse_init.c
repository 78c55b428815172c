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

static void wrong_texts(void)
{
    static char long_text[CRITREG_DOMAIN_TEXT_MAX + 1];
    static char many[1024];
    char why[128] = "";
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
    EXPECT(CRITREG_INVALID_ARGUMENT, init("", NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT, init("object wall { x: length }", NULL));

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
    const double not_a_number = (double)NAN, infinite = (double)INFINITY, outside = 4.5;
    critreg_config config = reach_config();
    critreg_report report;

    EXPECT(CRITREG_NULL_POINTER, critreg_config_init(NULL, sizeof config));
    EXPECT(CRITREG_MISALIGNED, critreg_config_init(ASKEW(critreg_config, memory), sizeof config));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_config_init(&config, 0));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_config_init(&config, sizeof config - 8));
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
    config.reserved = 1;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config = reach_config();
    config.hypotheses = 3;
    EXPECT(CRITREG_INVALID_ARGUMENT, init(DOMAIN, &config));
    config.hypotheses = 100000;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config.hypotheses = UINT32_MAX;
    config.observations = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config = reach_config();
    config.hypotheses = 0;
    config.observations = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
    config.observations = 0;
    config.iterations = UINT32_MAX;
    EXPECT(CRITREG_TOO_SMALL, init(DOMAIN, &config));
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
}

/* The macros are enough; one byte less than the exact size is not. */
static void sizes(void)
{
    static const uint32_t some[] = {4, 7, 64, 1000, 1024, 4096, 20000, 65536, 1000000, 16777216};
    static const uint32_t observations[] = {1, 2, 102, 256, 4096};
    size_t i, j;

    EXPECT_TRUE(critreg_learner_align() == 8 || critreg_learner_align() == 4);
    EXPECT_TRUE(critreg_region_align() <= sizeof(uint64_t));
    EXPECT_TRUE(critreg_region_size() <= CRITREG_REGION_WORDS * sizeof(uint64_t));
    EXPECT_TRUE(critreg_region_size() > CRITREG_REGION_WORDS * sizeof(uint64_t) * 9 / 10);
    for (i = 0; i < sizeof some / sizeof *some; i++) {
        for (j = 0; j < sizeof observations / sizeof *observations; j++) {
            size_t size = critreg_learner_size(some[i], observations[j]);
            size_t bytes = CRITREG_LEARNER_WORDS(some[i], observations[j]) * sizeof(uint64_t);
            critreg_config config = reach_config();
            uint64_t *own = (uint64_t *)malloc(bytes);
            EXPECT_TRUE(size <= bytes && own != NULL);
            config.hypotheses = some[i];
            config.observations = observations[j];
            EXPECT(CRITREG_TOO_SMALL,
                   critreg_learner_init(own, size - 1, DOMAIN, &config, &learner));
            OK(critreg_learner_init(own, size, DOMAIN, &config, &learner));
            free(own);
        }
    }
}

/* Without a configuration the memory decides, and nothing behind it is touched. */
static void capacity_from_memory(void)
{
    static uint64_t large[CRITREG_LEARNER_WORDS(4096, 256)];
    unsigned char *bytes = (unsigned char *)large;
    critreg_report report;
    size_t len, i;

    OK(critreg_learner_init(large, sizeof large, critreg_stick_button_domain(), NULL, &learner));
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.kept >= 4096 && report.left_out > 0);
    EXPECT_TRUE(report.enumerated == report.kept + report.left_out);
    for (len = 0; len < sizeof large; len += 1237) {
        critreg_status status;
        int untouched = 1;
        memset(bytes, 0xA5, sizeof large);
        status = critreg_learner_init(large, len, DOMAIN, NULL, &learner);
        EXPECT_TRUE(status == CRITREG_OK || status == CRITREG_TOO_SMALL);
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

int main(void)
{
    critreg_learner *const sentinel = (critreg_learner *)(void *)&failures;

    learner = sentinel;
    wrong_arguments();
    EXPECT_TRUE(learner == sentinel);
    wrong_texts();
    learner = sentinel;
    wrong_configurations();
    EXPECT_TRUE(learner == sentinel);
    sizes();
    capacity_from_memory();
    failure_retires();
    expect_usable(reach_learner(memory, sizeof memory));
    return summary();
}
