/*
 * The main job: learn where a robot can grasp a stick, and draw grasps.
 *
 * PickStickFromNothing of the built-in stick-button environment is learned from 4
 * tasks and 100 calls of its simulator. The program prints the region, what
 * supports each constraint and what the last calls prove about it, and tries
 * grasps drawn from it on 50 other tasks. Then it learns again with other seeds
 * and training tasks, with each learner: the default one; the thesis's Algorithm 1
 * with 20 000 hypotheses, z- = 0.95, z+ = 0.5 and K = 100; and the same with K = 0,
 * to show what the manual samples alone tell.
 *
 * Usage: pick_stick [number of seeds]
 */
#include <inttypes.h>

#include "trial.h"

#define FORMS 4096
#define HYPOTHESES 20000
#define TRAINING 4              /* tasks to learn from, */
#define FIRST_TRAINING 1000u    /* whose seeds lie behind those of the tasks to try */
#define MOST_SEEDS 1000

/* Enough for HYPOTHESES of Algorithm 1, too, which are smaller; init checks it. */
static uint64_t memory[CRITREG_LEARNER_WORDS(FORMS, 256)];

/* Learns with a seed, from tasks of its own. No region is an answer, too. */
static const critreg_region *learn(uint32_t kind, uint64_t seed, uint32_t calls,
                                   critreg_report *report)
{
    double negative = 0.95, positive = 0.5, instances[TRAINING][NUMBERS];
    critreg_config config;
    critreg_learner *learner;
    const critreg_region *region = NULL;
    critreg_status status;
    uint64_t i;
    for (i = 0; i < TRAINING; i++)
        CHECK(critreg_stick_button_task(FIRST_TRAINING + TRAINING * seed + i, 0, 1, instances[i],
                                        NUMBERS));
    CHECK(critreg_config_init(&config, sizeof config));
    config.learner = kind;
    config.seed = seed;
    config.calls = calls;
    config.forms = FORMS;
    if (kind == CRITREG_ALGORITHM1) {
        config.forms = HYPOTHESES;
        config.negative = &negative;
        config.positive = &positive;
    }
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

/* Everything that is known of each constraint: S and G are what its bound has to
 * lie between. */
static void print_constraints(const critreg_region *region)
{
    size_t count, i;
    CHECK(critreg_region_constraint_count(region, &count));
    for (i = 0; i < count; i++) {
        critreg_constraint constraint;
        char text[512], name[256];
        CHECK(critreg_constraint_init(&constraint, sizeof constraint));
        CHECK(critreg_region_constraint(region, i, &constraint));
        CHECK(critreg_region_constraint_format(region, i, text, sizeof text, NULL));
        CHECK(critreg_region_constraint_name(region, i, name, sizeof name, NULL));
        printf("constraint %lu: %s\n", (unsigned long)i + 1, text);
        if (constraint.has_evidence)
            printf("    feasible to S = %.6g, infeasible from G = %.6g, failures excluded: %"
                   PRIu32 ", name: %s\n", constraint.feasible, constraint.infeasible,
                   constraint.support, name[0] != '\0' ? name : "none");
    }
}

static void print_run(uint32_t kind, long seed, const critreg_report *report,
                      const critreg_region *region, quality found)
{
    char text[8192] = "none";
    if (region != NULL)
        CHECK(critreg_region_format(region, text, sizeof text, NULL));
    printf("seed: %ld\nregion: %s\n", seed, text);
    printf("simulator calls: %" PRIu64 ", feasible %" PRIu64 ", infeasible %" PRIu64 "\n",
           report->calls, report->feasible, report->infeasible);
    printf("hypotheses: enumerated %" PRIu64 ", kept %" PRIu64 ", left out %" PRIu64 "\n",
           report->enumerated, report->kept, report->left_out);
    if (kind == CRITREG_ALGORITHM1) {
        printf("hypotheses left: after z- %" PRIu64 ", after z+ %" PRIu64 ", at the end %" PRIu64
               "\n", report->after_negative, report->after_positive, report->remaining);
    } else if (region != NULL) {
        print_constraints(region);
        printf("certificate: %" PRIu64 " of %" PRIu64 " draws worked, so at least %.3f of the "
               "region does (confidence 0.95)\n", report->certificate_feasible,
               report->certificate_draws, report->certificate_lower_bound);
    }
    printf("draws: %d of %d\n", found.draws, TASKS * DRAWS);
    if (found.draws > 0)
        printf("feasibility rate: %.3f\ncoverage: %.3f\n", found.rate, found.coverage);
}

/* The first seed in full, unless K is 0, and all in numbers. */
static void run(const char *title, uint32_t kind, uint32_t calls, long seeds)
{
    static double rates[MOST_SEEDS], coverages[MOST_SEEDS];
    int learned = 0, useful = 0;
    long seed;
    printf("\nlearner: %s\n", title);
    for (seed = 0; seed < seeds; seed++) {
        critreg_report report;
        const critreg_region *region = learn(kind, (uint64_t)seed, calls, &report);
        quality found = {0, 0.0, 0.0};
        if (region != NULL) {
            found = judge(region);
            learned++;
        }
        if (seed == 0 && calls > 0)
            print_run(kind, seed, &report, region, found);
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
    if (seeds < 1 || seeds > MOST_SEEDS || critreg_stick_button_state_len(1) != NUMBERS)
        return fprintf(stderr, "usage: pick_stick [1 to %d seeds]\n", MOST_SEEDS), EXIT_FAILURE;
    printf("tasks to try: %d, draws: %d\nfeasibility rate of the original sampler: %.3f\n",
           TASKS, TASKS * DRAWS, try_original_sampler());
    run("version space", CRITREG_VERSION_SPACE, 100, seeds);
    run("Algorithm 1, K = 100", CRITREG_ALGORITHM1, 100, seeds);
    run("Algorithm 1, K = 0", CRITREG_ALGORITHM1, 0, seeds);
    return EXIT_SUCCESS;
}
