/* Two threads on the same handles, by the functions that take them as const. */
#include <pthread.h>

#include "expect.h"

#define ROUNDS 300

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t parsed_memory[CRITREG_REGION_WORDS];

static critreg_learner *learner;
static const critreg_region *learned;
static const critreg_region *parsed;

/* What a thread found. */
typedef struct {
    double sum;
    int failures;
} found;

static int reads_learner(void)
{
    critreg_report report;
    int32_t finished = 0;
    size_t length = 0;
    char text[512];
    return critreg_report_init(&report, sizeof report) != CRITREG_OK
        || critreg_learner_report(learner, &report) != CRITREG_OK
        || critreg_is_finished(learner, &finished) != CRITREG_OK || !finished
        || critreg_learner_instance_len(learner, &length) != CRITREG_OK || length != 2
        || critreg_learner_message(learner, text, sizeof text, NULL) != CRITREG_OK;
}

static int reads_region(const critreg_region *region, critreg_rng *rng, double *sum)
{
    const critreg_region *regions[2];
    const double *instances[2] = {WALLS, WALLS};
    uint8_t bytes[4096];
    char text[512];
    double theta, ends[2 * CRITREG_MAX_INTERVALS];
    int32_t inside = 0, empty = 1;
    size_t count = 0;
    int failed;
    regions[0] = regions[1] = region;
    failed = critreg_sample_region(region, WALLS, rng, &theta) != CRITREG_OK
        || critreg_region_contains(region, WALLS, &theta, &inside) != CRITREG_OK || !inside
        || critreg_region_is_empty(region, WALLS, &empty) != CRITREG_OK || empty
        || critreg_region_intervals(region, WALLS, ends, CRITREG_MAX_INTERVALS, &count) != CRITREG_OK
        || critreg_region_format(region, text, sizeof text, NULL) != CRITREG_OK
        || critreg_region_save(region, bytes, sizeof bytes, NULL) != CRITREG_OK
        || critreg_sample_regions(regions, instances, 2, rng, &theta) != CRITREG_OK;
    *sum += theta;
    return failed;
}

static void *read_all(void *data)
{
    found *own = (found *)data;
    critreg_rng rng = critreg_rng_seed(7);
    int i;
    for (i = 0; i < ROUNDS; i++) {
        own->failures += reads_learner();
        own->failures += reads_region(learned, &rng, &own->sum);
        own->failures += reads_region(parsed, &rng, &own->sum);
    }
    return NULL;
}

int main(void)
{
    found one = {0.0, 0}, two = {0.0, 0};
    critreg_region *made = NULL;
    pthread_t thread;

    learner = reach_learner(memory, sizeof memory);
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &learned));
    OK(critreg_region_parse(parsed_memory, sizeof parsed_memory, DOMAIN, "reach <= wall.x", &made));
    parsed = made;
    EXPECT_TRUE(pthread_create(&thread, NULL, read_all, &one) == 0);
    read_all(&two);
    EXPECT_TRUE(pthread_join(thread, NULL) == 0);
    EXPECT_TRUE(one.failures == 0 && two.failures == 0 && one.sum == two.sum);
    return summary();
}
