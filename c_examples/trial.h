/*
 * How good a region of picking the stick is: grasps drawn from it are tried in 50
 * tasks that no learner saw, beside those of the action's original sampler, which
 * is uniform. For pick_stick.c.
 */
#ifndef TRIAL_H
#define TRIAL_H

#include <stdio.h>
#include <stdlib.h>

#include "critreg.h"

#define NUMBERS 13              /* numbers of an instance; checked in main */
#define TASKS 50                /* tasks to try, */
#define DRAWS 200               /* and draws in each of them */
#define FIRST_TASK 1u           /* seed of the first task to try */

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
        CHECK(critreg_stick_button_task(FIRST_TASK + (uint64_t)t, 0, 1, tasks[t], NUMBERS));
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

static int contains(const double *ends, size_t intervals, double mu)
{
    size_t i;
    for (i = 0; i < intervals; i++)
        if (ends[2 * i] <= mu && mu <= ends[2 * i + 1])
            return 1;
    return 0;
}

static quality judge(const critreg_region *region)
{
    critreg_rng rng = critreg_rng_seed(2);
    int feasible = 0, working = 0, covered = 0, t, d;
    quality found = {0, 0.0, 0.0};
    for (t = 0; t < TASKS; t++) {
        double ends[2 * CRITREG_MAX_INTERVALS];
        size_t intervals;
        CHECK(critreg_region_intervals(region, tasks[t], ends, CRITREG_MAX_INTERVALS,
                                       &intervals));
        for (d = 0; d < DRAWS; d++) {
            double mu;
            critreg_status status = critreg_sample_region(region, tasks[t], &rng, &mu);
            if (status == CRITREG_OK) {
                found.draws++;
                feasible += picks(tasks[t], mu);
            } else if (status != CRITREG_EMPTY_REGION && status != CRITREG_NO_SAMPLE) {
                CHECK(status);
            }
            working += works[t][d];
            covered += works[t][d] && contains(ends, intervals, original[t][d]);
        }
    }
    found.rate = found.draws > 0 ? feasible / (double)found.draws : 0.0;
    found.coverage = covered / (double)working;
    return found;
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

#endif
