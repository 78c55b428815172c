/*
 * The main job: learn where a robot can grasp a stick, and draw grasps.
 *
 * PickStickFromNothing of the built-in stick-button environment is learned by
 * Algorithm 1 from 4 tasks with 20 000 hypotheses, z- = 0.95, z+ = 0.5 and
 * K = 100. Grasps drawn from the region are then tried on 50 other tasks, beside
 * those of the action's original sampler, which is uniform. As Algorithm 1 depends
 * on luck it is repeated with other seeds, and with K = 0 to show what the manual
 * samples alone tell. Usage: pick_stick [number of seeds]
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "critreg.h"

#define NUMBERS 13              /* numbers of an instance; checked in main */
#define HYPOTHESES 20000
#define TRAINING 4              /* tasks to learn from */
#define TASKS 50                /* tasks to try, */
#define DRAWS 200               /* and draws in each of them */
#define FIRST_TASK 1u           /* seeds of the tasks to try, */
#define FIRST_TRAINING 1000u    /* and behind them of those to learn from */
#define MOST_SEEDS 1000

static uint64_t memory[CRITREG_LEARNER_WORDS(HYPOTHESES, 256)];
static double tasks[TASKS][NUMBERS];
static double original[TASKS][DRAWS];       /* draws of the original sampler */
static int works[TASKS][DRAWS];             /* whether they pick the stick */

#define CHECK(call) check((call), #call)

static void check(critreg_status status, const char *call)
{
    if (status != CRITREG_OK) {
        fprintf(stderr, "%s: %s\n", call, critreg_strerror(status));
        exit(EXIT_FAILURE);
    }
}

static int picks(const double *instance, double mu)
{
    critreg_outcome outcome;
    CHECK(critreg_stick_button_pick(NULL, instance, &mu, &outcome));
    return outcome == CRITREG_FEASIBLE;
}

/* Prepares the tasks to try and returns the rate of the original sampler. */
static double try_original_sampler(void)
{
    critreg_rng rng = critreg_rng_seed(1);
    int feasible = 0, t, d;
    for (t = 0; t < TASKS; t++) {
        CHECK(critreg_stick_button_task(FIRST_TASK + (uint64_t)t, 0, tasks[t], NUMBERS));
        for (d = 0; d < DRAWS; d++) {
            CHECK(critreg_rng_uniform(&rng, &original[t][d]));
            works[t][d] = picks(tasks[t], original[t][d]);
            feasible += works[t][d];
        }
    }
    return feasible / (double)(TASKS * DRAWS);
}

/* How good a region is, on the tasks to try. */
typedef struct {
    int draws;          /* less than wanted where the region is empty */
    double rate;        /* share of the draws that pick the stick */
    double coverage;    /* share of all grasps that work that it contains */
} quality;

static quality judge(const critreg_region *region)
{
    critreg_rng rng = critreg_rng_seed(2);
    int feasible = 0, working = 0, covered = 0, t, d;
    quality found = {0, 0.0, 0.0};
    for (t = 0; t < TASKS; t++) {
        for (d = 0; d < DRAWS; d++) {
            double mu;
            int32_t inside;
            critreg_status status = critreg_sample_region(region, tasks[t], &rng, &mu);
            if (status == CRITREG_OK) {
                found.draws++;
                feasible += picks(tasks[t], mu);
            } else if (status != CRITREG_EMPTY_REGION && status != CRITREG_NO_SAMPLE) {
                CHECK(status);
            }
            CHECK(critreg_region_contains(region, tasks[t], &original[t][d], &inside));
            working += works[t][d];
            covered += works[t][d] && inside;
        }
    }
    found.rate = found.draws > 0 ? feasible / (double)found.draws : 0.0;
    found.coverage = covered / (double)working;
    return found;
}

/* Learns with a seed, from tasks of its own. No region is an answer, too. */
static const critreg_region *learn(uint64_t seed, uint32_t iterations, critreg_report *report)
{
    double negative = 0.95, positive = 0.5, instances[TRAINING][NUMBERS];
    critreg_config config;
    critreg_learner *learner;
    const critreg_region *region = NULL;
    critreg_status status;
    uint64_t i;
    for (i = 0; i < TRAINING; i++)
        CHECK(critreg_stick_button_task(FIRST_TRAINING + TRAINING * seed + i, 0, instances[i],
                                        NUMBERS));
    CHECK(critreg_config_init(&config, sizeof config));
    config.seed = seed;
    config.hypotheses = HYPOTHESES;
    config.iterations = iterations;
    config.negative = &negative;
    config.positive = &positive;
    CHECK(critreg_learner_init(memory, sizeof memory, critreg_stick_button_domain(),
                               &config, &learner));
    status = critreg_learn_region(learner, &instances[0][0], TRAINING,
                                  critreg_stick_button_pick, NULL, &region);
    if (status != CRITREG_NO_REGION)
        CHECK(status);
    CHECK(critreg_report_init(report, sizeof *report));
    CHECK(critreg_learner_report(learner, report));
    return region;
}

static void print_run(long seed, const critreg_report *report, const critreg_region *region,
                      quality found)
{
    char text[8192] = "none";
    if (region != NULL)
        CHECK(critreg_region_format(region, text, sizeof text, NULL));
    printf("seed: %ld\nregion: %s\n", seed, text);
    printf("hypotheses: enumerated %" PRIu64 ", kept %" PRIu64 ", left out %" PRIu64 "\n",
           report->enumerated, report->kept, report->left_out);
    printf("hypotheses left: after z- %" PRIu64 ", after z+ %" PRIu64 ", at the end %" PRIu64
           "\n", report->after_negative, report->after_positive, report->remaining);
    printf("simulator calls: %" PRIu64 ", feasible %" PRIu64 "\ndraws: %d of %d\n",
           report->calls, report->feasible, found.draws, TASKS * DRAWS);
    if (found.draws > 0)
        printf("feasibility rate: %.3f\ncoverage: %.3f\n", found.rate, found.coverage);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_quantiles(const char *key, double *values, int count)
{
    int last = count - 1;
    if (count == 0)
        return;
    qsort(values, (size_t)count, sizeof *values, ascending);
    printf("%s (least, 25%%, median, 75%%, most): %.3f %.3f %.3f %.3f %.3f\n", key,
           values[0], values[last / 4], values[last / 2], values[3 * last / 4], values[last]);
}

/* The first seed in full, the first that learned something, and all in numbers. */
static void run(uint32_t iterations, long seeds)
{
    static double rates[MOST_SEEDS], coverages[MOST_SEEDS];
    int learned = 0, useful = 0;
    long seed;
    printf("\nK: %" PRIu32 "\n", iterations);
    for (seed = 0; seed < seeds; seed++) {
        critreg_report report;
        const critreg_region *region = learn((uint64_t)seed, iterations, &report);
        quality found = {0, 0.0, 0.0};
        if (region != NULL) {
            found = judge(region);
            learned++;
        }
        if (seed == 0 || (found.draws > 0 && useful == 0))
            print_run(seed, &report, region, found);
        if (found.draws > 0) {
            rates[useful] = found.rate;
            coverages[useful++] = found.coverage;
        }
    }
    printf("seeds: %ld, each with its own %d training tasks\n", seeds, TRAINING);
    printf("seeds that learned nothing: %ld\nseeds whose region is empty in all tasks: %d\n"
           "seeds whose region gives draws: %d\n", seeds - learned, learned - useful, useful);
    print_quantiles("feasibility rate", rates, useful);
    print_quantiles("coverage", coverages, useful);
}

int main(int argc, char **argv)
{
    long seeds = argc > 1 ? strtol(argv[1], NULL, 10) : 100;
    if (seeds < 1 || seeds > MOST_SEEDS || critreg_stick_button_instance_len() != NUMBERS)
        return fprintf(stderr, "usage: pick_stick [1 to %d seeds]\n", MOST_SEEDS), EXIT_FAILURE;
    printf("tasks to try: %d, draws: %d\nfeasibility rate of the original sampler: %.3f\n",
           TASKS, TASKS * DRAWS, try_original_sampler());
    run(100, seeds);
    run(0, seeds);
    return EXIT_SUCCESS;
}
