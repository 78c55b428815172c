/*
 * Learns where a stick can be grasped, in static memory, on a computer or on a bare
 * Cortex-M4: region, certificate, samples, and what it took.
 *
 * What is learned is saved, too, byte by byte: everything that the learner was told,
 * the region, and the samples. "make cortex-m" compares these files, and what is
 * printed, between a computer and the board.
 */
#include "critreg.h"
#include "machine.h"
#include "print.h"

#define OBSERVATIONS 128
#define NUMBERS 13              /* numbers of an instance; checked in main */
#define TRAINING 4              /* instances to learn from */
#define SEEDS 3
#define DRAWS 5

/* What is computed with, how much is kept, and where; the Makefile has another choice. */
#ifndef FORMS
#define FORMS 1024
#endif
#ifndef PRECISION
#define PRECISION CRITREG_F64
#define TRACKED UINT32_MAX
#endif
#ifndef MEMORY_BYTES
#define MEMORY_BYTES (8 * CRITREG_LEARNER_WORDS_FOR(FORMS, OBSERVATIONS, TRAINING, 1))
#endif

static uint64_t memory[MEMORY_BYTES / 8];
static double instances[TRAINING][NUMBERS];

/* Leaves the function with a failure. */
#define TRY(call)                                                                      \
    do {                                                                               \
        critreg_status status_ = (call);                                               \
        if (status_ != CRITREG_OK)                                                     \
            return status_;                                                            \
    } while (0)

static critreg_status learn(uint64_t seed, critreg_learner **learner,
                            const critreg_region **region)
{
    static critreg_config config;
    uint64_t i;
    for (i = 0; i < TRAINING; i++)
        TRY(critreg_stick_button_task(TRAINING * seed + i, 0, 1, instances[i], NUMBERS));
    TRY(critreg_config_init(&config, sizeof config));
    config.seed = seed;
    config.forms = FORMS;
    config.observations = OBSERVATIONS;
    config.instances = TRAINING;
    config.precision = PRECISION;
    config.tracked = TRACKED;
    /* The simple forms say it all. */
    config.sums = 0;
    config.questions = 1;
    TRY(critreg_learner_init(memory, sizeof memory, critreg_stick_button_domain(), &config,
                             learner));
    return critreg_learn_region(*learner, &instances[0][0], TRAINING,
                                critreg_stick_button_pick, NULL, region);
}

static critreg_status print_region(const critreg_learner *learner,
                                   const critreg_region *region)
{
    static char text[2048];
    static critreg_report report;
    TRY(critreg_region_format(region, text, sizeof text, NULL));
    TRY(critreg_report_init(&report, sizeof report));
    TRY(critreg_learner_report(learner, &report));
    machine_print("region: ");
    machine_print(text);
    machine_print("\ncertificate: ");
    print_whole(report.certificate_feasible);
    machine_print(" of ");
    print_whole(report.certificate_draws);
    machine_print(" draws worked, so at least ");
    print_number(report.certificate_lower_bound);
    machine_print(" of the region does\n");
    return CRITREG_OK;
}

static critreg_status draw(uint64_t seed, const critreg_region *region, double *samples)
{
    critreg_rng rng = critreg_rng_seed(seed);
    int i;
    machine_print("samples:");
    for (i = 0; i < DRAWS; i++) {
        TRY(critreg_sample_region(region, instances[i % TRAINING], &rng, &samples[i]));
        machine_print(" ");
        print_number(samples[i]);
    }
    machine_print("\n");
    return CRITREG_OK;
}

/* Everything that came of it, to the last bit. */
static critreg_status save(critreg_learner *learner, const critreg_region *region,
                           const double *samples)
{
    static uint8_t bytes[8192];
    size_t len;
    int saved;
    TRY(critreg_learner_save(learner, &instances[0][0], TRAINING, bytes, sizeof bytes, &len));
    saved = machine_append("observations.bin", bytes, len);
    TRY(critreg_region_save(region, bytes, sizeof bytes, &len));
    saved = saved && machine_append("regions.bin", bytes, len);
    saved = saved && machine_append("samples.bin", samples, DRAWS * sizeof *samples);
    return saved ? CRITREG_OK : CRITREG_USER_STATUS;
}

static critreg_status run(uint64_t seed)
{
    critreg_learner *learner;
    const critreg_region *region;
    static double samples[DRAWS];
    machine_print("seed: ");
    print_whole(seed);
    machine_print("\n");
    TRY(learn(seed, &learner, &region));
    TRY(print_region(learner, region));
    TRY(draw(seed, region, samples));
    return save(learner, region, samples);
}

/* Differs from machine to machine: pointers have a size. */
static void print_memory(void)
{
    machine_print("RAM: ");
    print_whole(sizeof memory);
    machine_print(" bytes for the learner");
    if (machine_stack_used() > 0) {
        machine_print(", ");
        print_whole(machine_stack_used());
        machine_print(" bytes of stack at most");
    }
    machine_print("\n");
}

int main(void)
{
    uint64_t seed;
    if (critreg_stick_button_state_len(1) != NUMBERS)
        return 1;
    for (seed = 0; seed < SEEDS; seed++) {
        critreg_status status = run(seed);
        if (status != CRITREG_OK) {
            machine_print(critreg_strerror(status));
            machine_print("\n");
            return 1;
        }
    }
    print_memory();
    return 0;
}
