/* Wrong handles and instances; damaged saved runs. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t other[CRITREG_LEARNER_WORDS(1024, 256)];

/* Every function refuses what is no learner. */
static void no_handle(critreg_learner *learner, critreg_status expected)
{
    const critreg_region *region;
    critreg_report report;
    size_t instance, number, needed;
    double theta = 0.0;
    uint64_t id = 0;
    int32_t finished;
    uint8_t bytes[64];
    char text[64];

    OK(critreg_report_init(&report, sizeof report));
    EXPECT(expected, critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
    EXPECT(expected, critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    EXPECT(expected, critreg_tell(learner, WALLS, INSTANCES, CRITREG_FEASIBLE));
    EXPECT(expected,
           critreg_observe(learner, WALLS, INSTANCES, 0, &theta, CRITREG_FEASIBLE));
    EXPECT(expected, critreg_conclude(learner, WALLS, INSTANCES));
    EXPECT(expected, critreg_ask_many(learner, WALLS, INSTANCES, 1, &id, &instance, &theta,
                                      &number));
    EXPECT(expected, critreg_tell_id(learner, WALLS, INSTANCES, id, CRITREG_FEASIBLE));
    EXPECT(expected, critreg_forget(learner, id));
    EXPECT(expected, critreg_open_questions(learner, 1, &id, &instance, &theta, &number));
    EXPECT(expected, critreg_is_finished(learner, &finished));
    EXPECT(expected, critreg_learner_region(learner, &region));
    EXPECT(expected, critreg_learner_report(learner, &report));
    EXPECT(expected, critreg_learner_message(learner, text, sizeof text, &needed));
    EXPECT(expected, critreg_learner_instance_len(learner, &number));
    EXPECT(expected, critreg_learner_parameter_count(learner, &number));
    EXPECT(expected, critreg_learner_save(learner, WALLS, INSTANCES, bytes, 64, &needed));
    EXPECT(expected, critreg_learner_resume(learner, WALLS, INSTANCES, bytes, 64));
    EXPECT(expected, critreg_learner_journal(learner, WALLS, INSTANCES, 0, bytes, 64, &needed));
    EXPECT(expected,
           critreg_learner_resume_journal(learner, WALLS, INSTANCES, bytes, 64, &needed));
}

static void wrong_handles(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    const critreg_region *region;

    no_handle(NULL, CRITREG_NULL_POINTER);
    no_handle(ASKEW(critreg_learner, memory), CRITREG_MISALIGNED);
    memset(other, 0, sizeof other);
    no_handle((critreg_learner *)(void *)other, CRITREG_NOT_A_HANDLE);
    memset(other, 0xA5, sizeof other);
    no_handle((critreg_learner *)(void *)other, CRITREG_NOT_A_HANDLE);
    memcpy(other, memory, sizeof memory);   /* a copy is no handle */
    no_handle((critreg_learner *)(void *)other, CRITREG_NOT_A_HANDLE);
    expect_usable(learner);
    OK(critreg_learner_region(learner, &region));
    no_handle((critreg_learner *)(uintptr_t)region, CRITREG_NOT_A_HANDLE);
    expect_usable(learner);
}

static void wrong_outputs(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    critreg_report report;
    size_t instance, needed = 0;
    double theta;
    char text[4] = "abc", why[128];

    EXPECT(CRITREG_NULL_POINTER, critreg_ask(learner, WALLS, INSTANCES, NULL, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_ask(learner, WALLS, INSTANCES, &instance, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_ask(learner, WALLS, INSTANCES, ASKEW(size_t, other), &theta));
    EXPECT(CRITREG_MISALIGNED,
           critreg_ask(learner, WALLS, INSTANCES, &instance, ASKEW(double, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_is_finished(learner, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_is_finished(learner, ASKEW(int32_t, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_region(learner, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_learner_region(learner, ASKEW(const critreg_region *, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_report(learner, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_report(learner, ASKEW(critreg_report, other)));
    memset(&report, 0, sizeof report);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_learner_report(learner, &report));
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_instance_len(learner, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_instance_len(learner, ASKEW(size_t, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_parameter_count(learner, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_parameter_count(learner, ASKEW(size_t, other)));

    EXPECT(CRITREG_NULL_POINTER, critreg_learner_message(learner, NULL, 4, &needed));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_message(learner, text, 4, ASKEW(size_t, other)));
    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_tell(learner, WALLS, INSTANCES, CRITREG_FEASIBLE));
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_message(learner, text, sizeof text, &needed));
    EXPECT_TRUE(strcmp(text, "abc") == 0 && needed > sizeof text);
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_message(learner, NULL, 0, NULL));
    OK(critreg_learner_message(learner, why, needed, &needed));
    EXPECT_TRUE(strcmp(why, "ask for a sample before telling") == 0);
    expect_usable(learner);
}

static void wrong_instances(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    double bad[INSTANCES * 2], theta = 7.0, again;
    const critreg_region *region;
    size_t instance = 77, needed;
    uint8_t bytes[64];
    int i;
    const double values[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};

    EXPECT(CRITREG_NULL_POINTER, critreg_ask(learner, NULL, INSTANCES, &instance, &theta));
    EXPECT(CRITREG_MISALIGNED,
           critreg_ask(learner, ASKEW(double, other), INSTANCES, &instance, &theta));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_ask(learner, WALLS, 0, &instance, &theta));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_ask(learner, WALLS, SIZE_MAX, &instance, &theta));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_ask(learner, WALLS, SIZE_MAX / 2, &instance, &theta));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_ask(learner, WALLS, SIZE_MAX / 8, &instance, &theta));
    for (i = 0; i < 3; i++) {
        memcpy(bad, WALLS, sizeof WALLS);
        bad[5] = values[i];
        EXPECT(CRITREG_NOT_FINITE, critreg_ask(learner, bad, INSTANCES, &instance, &theta));
        EXPECT(CRITREG_NOT_FINITE,
               critreg_learn_region(learner, bad, INSTANCES, reach, NULL, &region));
        EXPECT(CRITREG_NOT_FINITE,
               critreg_learner_save(learner, bad, INSTANCES, bytes, 64, &needed));
        EXPECT(CRITREG_NOT_FINITE, critreg_learner_resume(learner, bad, INSTANCES, bytes, 64));
    }
    EXPECT_TRUE(instance == 77 && theta == 7.0);

    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_tell(learner, WALLS, INSTANCES, CRITREG_FEASIBLE));
    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_tell(learner, NULL, INSTANCES, CRITREG_FEASIBLE));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_tell(learner, WALLS, INSTANCES, 3));
    EXPECT(CRITREG_MISMATCH, critreg_tell(learner, WALLS, INSTANCES - 1, CRITREG_FEASIBLE));
    memcpy(bad, WALLS, sizeof WALLS);
    bad[0] = 1.0625;
    EXPECT(CRITREG_MISMATCH, critreg_tell(learner, bad, INSTANCES, CRITREG_FEASIBLE));
    EXPECT(CRITREG_MISMATCH, critreg_ask(learner, bad, INSTANCES, &instance, &theta));
    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &again));
    EXPECT_TRUE(again == theta);
    expect_usable(learner);
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_tell(learner, WALLS, INSTANCES, CRITREG_FEASIBLE));
    expect_usable(learner);
}

/* A learner with room for three samples says when they are used up. */
static void full_of_observations(void)
{
    critreg_config config = reach_config();
    critreg_learner *learner;
    const critreg_region *region = NULL;
    critreg_report report;
    uint32_t quality;

    config.observations = 3;
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &region));
    EXPECT_TRUE(region == NULL);
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == 3);
    /* What three outcomes say may be chance. */
    OK(critreg_learner_region(learner, &region));
    OK(critreg_region_quality(region, &quality));
    EXPECT_TRUE(quality == (kind == CRITREG_ALGORITHM1 ? CRITREG_NO_QUALITY : CRITREG_PROVISIONAL));
}

/* A learner with room for three instances refuses a fourth, and learns from three. */
static void too_many_instances(void)
{
    critreg_config config = reach_config();
    critreg_learner *learner;
    size_t instance;
    double theta;
    char why[128];

    config.instances = INSTANCES - 1;
    OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
    if (kind == CRITREG_ALGORITHM1) {
        OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
        return;
    }
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, NULL));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    OK(critreg_learner_message(learner, why, sizeof why, NULL));
    EXPECT_TRUE(strstr(why, "instances") != NULL);
    OK(critreg_learn_region(learner, WALLS, INSTANCES - 1, reach, NULL, NULL));
}

/* Asks, tries and tells so many times, or to the end. */
static int go_on(critreg_learner *learner, int samples)
{
    int done;
    for (done = 0; done < samples; done++) {
        critreg_outcome outcome;
        int32_t finished;
        size_t instance;
        double theta;
        OK(critreg_is_finished(learner, &finished));
        if (finished)
            break;
        OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
        OK(reach(NULL, WALLS + 2 * instance, &theta, &outcome));
        OK(critreg_tell(learner, WALLS, INSTANCES, outcome));
    }
    return done;
}

/* Resuming leads to the same end from wherever a run was saved. */
static void resumed_everywhere(double noise)
{
    static uint8_t bytes[8192], end[8192], again[8192];
    critreg_config config = reach_config();
    critreg_learner *first, *second;
    size_t length, end_length = 0, again_length;
    int told;

    config.noise = noise;
    for (told = SAMPLES; told >= 0; told--) {
        OK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &first));
        EXPECT_TRUE(go_on(first, told) == told);
        OK(critreg_learner_save(first, WALLS, INSTANCES, bytes, sizeof bytes, &length));
        if (told == SAMPLES) {
            memcpy(end, bytes, length);
            end_length = length;
        }
        OK(critreg_learner_init(other, sizeof other, DOMAIN, &config, &second));
        OK(critreg_learner_resume(second, WALLS, INSTANCES, bytes, length));
        EXPECT_TRUE(go_on(second, 1000) == SAMPLES - told);
        OK(critreg_learner_save(second, WALLS, INSTANCES, again, sizeof again, &again_length));
        EXPECT_TRUE(again_length == end_length && memcmp(again, end, end_length) == 0);
        if (noise == 0.0)
            expect_usable(second);
    }
}

static void damaged_runs(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory), *second;
    critreg_config config;
    uint8_t bytes[1024], damaged[1024];
    size_t needed = 0, length, i, instance;
    double theta;

    for (i = 0; i < 9; i++) {
        critreg_outcome outcome;
        OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
        OK(reach(NULL, WALLS + 2 * instance, &theta, &outcome));
        OK(critreg_tell(learner, WALLS, INSTANCES, outcome));
    }
    EXPECT(CRITREG_TOO_SMALL, critreg_learner_save(learner, WALLS, INSTANCES, NULL, 0, &needed));
    memset(bytes, 0xA5, sizeof bytes);
    EXPECT(CRITREG_TOO_SMALL,
           critreg_learner_save(learner, WALLS, INSTANCES, bytes, needed - 1, NULL));
    EXPECT_TRUE(bytes[0] == 0xA5);
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_save(learner, WALLS, INSTANCES, NULL, sizeof bytes, &needed));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_save(learner, NULL, INSTANCES, bytes, sizeof bytes, &needed));
    EXPECT(CRITREG_MISALIGNED, critreg_learner_save(learner, WALLS, INSTANCES, bytes,
                                                    sizeof bytes, ASKEW(size_t, other)));
    OK(critreg_learner_save(learner, WALLS, INSTANCES, bytes, sizeof bytes, &length));
    EXPECT_TRUE(length == needed && bytes[length] == 0xA5);

    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_learner_resume(learner, WALLS, INSTANCES, bytes, length));
    second = reach_learner(other, sizeof other);
    EXPECT(CRITREG_NULL_POINTER, critreg_learner_resume(second, WALLS, INSTANCES, NULL, length));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_learner_resume(second, WALLS, INSTANCES, bytes, SIZE_MAX));
    EXPECT(CRITREG_MISMATCH,
           critreg_learner_resume(second, WALLS, INSTANCES - 1, bytes, length));
    for (i = 0; i < length; i++) {
        EXPECT(CRITREG_CORRUPT, critreg_learner_resume(second, WALLS, INSTANCES, bytes, i));
        memcpy(damaged, bytes, length);
        damaged[i] ^= 0x10;
        EXPECT(CRITREG_CORRUPT,
               critreg_learner_resume(second, WALLS, INSTANCES, damaged, length));
    }
    OK(critreg_learner_resume(second, WALLS, INSTANCES, bytes, length));
    expect_usable(second);
    expect_usable(learner);

    config = reach_config();
    config.seed = 2;
    OK(critreg_learner_init(other, sizeof other, DOMAIN, &config, &second));
    EXPECT(CRITREG_MISMATCH, critreg_learner_resume(second, WALLS, INSTANCES, bytes, length));
    config = reach_config();    /* the run of another learner */
    config.learner = CRITREG_ALGORITHM1 + CRITREG_VERSION_SPACE - kind;
    OK(critreg_learner_init(other, sizeof other, DOMAIN, &config, &second));
    EXPECT(CRITREG_MISMATCH, critreg_learner_resume(second, WALLS, INSTANCES, bytes, length));
}

static void tests(void)
{
    wrong_handles();
    wrong_outputs();
    wrong_instances();
    full_of_observations();
    too_many_instances();
    damaged_runs();
    resumed_everywhere(0.0);
    resumed_everywhere(0.05);
}

int main(void)
{
    with_each_learner(tests);
    return summary();
}
