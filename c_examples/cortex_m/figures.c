/*
 * What learning and drawing cost on a Cortex-M4, as "key number" lines for figures.py.
 *
 * Instructions are counted by the SysTick timer: with -icount, QEMU lets a fixed time
 * pass for each instruction. A loop of known length tells how many there are to a tick.
 */
#include "critreg.h"
#include "machine.h"
#include "print.h"

#define FORMS 1024
#define OBSERVATIONS 128
#define NUMBERS 13
#define TRAINING 4
#define DRAWS 100

#define SYST_CSR (*(volatile uint32_t *)0xe000e010)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018)
#define LONGEST 0xffffffu       /* ticks; the timer counts down from here */

static uint64_t memory[CRITREG_LEARNER_WORDS_FOR(FORMS, OBSERVATIONS, TRAINING, 1)];
static double instances[TRAINING][NUMBERS];
static double per_tick;

static void start_timer(void)
{
    SYST_RVR = LONGEST;
    SYST_CVR = 0;
    SYST_CSR = 5;               /* the processor's clock, no interrupt */
}

static double ticks(void)
{
    return LONGEST - SYST_CVR;
}

static void calibrate(void)
{
    uint32_t left = 500000;     /* rounds of two instructions */
    start_timer();
    __asm__ volatile("1: subs %0, %0, #1\n bne 1b" : "+r"(left) : : "cc");
    per_tick = 1e6 / ticks();
}

static void print(const char *key, double number)
{
    machine_print(key);
    machine_print(" ");
    print_whole((uint64_t)(number + 0.5));
    machine_print("\n");
}

/* Asks and tells until nothing is left to ask. */
static critreg_status learn(critreg_learner *learner)
{
    double telling = 0.0, longest = 0.0, asking = 0.0, told = 0.0;
    int32_t finished = 0;
    while (!finished) {
        size_t instance = 0;
        double mu = 0.0, spent;
        critreg_outcome outcome = CRITREG_INFEASIBLE;
        critreg_status status;
        start_timer();
        status = critreg_ask(learner, &instances[0][0], TRAINING, &instance, &mu);
        asking += ticks();
        if (status == CRITREG_OK)
            status = critreg_stick_button_pick(NULL, instances[instance], &mu, &outcome);
        start_timer();
        if (status == CRITREG_OK)
            status = critreg_tell(learner, &instances[0][0], TRAINING, outcome);
        spent = ticks();
        telling += spent;
        longest = spent > longest ? spent : longest;
        told++;
        if (status == CRITREG_OK)
            status = critreg_is_finished(learner, &finished);
        if (status != CRITREG_OK)
            return status;
    }
    print("ask_mean", asking / told * per_tick);
    print("tell_mean", telling / told * per_tick);
    print("tell_max", longest * per_tick);
    return CRITREG_OK;
}

static critreg_status draw(const critreg_region *region)
{
    critreg_rng rng = critreg_rng_seed(1);
    critreg_status status = CRITREG_OK;
    double mu;
    int i;
    start_timer();
    for (i = 0; i < DRAWS && status == CRITREG_OK; i++)
        status = critreg_sample_region(region, instances[i % TRAINING], &rng, &mu);
    print("sample", ticks() / DRAWS * per_tick);
    return status;
}

static critreg_status run(void)
{
    static critreg_config config;
    critreg_learner *learner = NULL;
    const critreg_region *region = NULL;
    critreg_status status = critreg_config_init(&config, sizeof config);
    uint64_t i;
    config.forms = FORMS;
    config.observations = OBSERVATIONS;
    config.instances = TRAINING;
    for (i = 0; i < TRAINING && status == CRITREG_OK; i++)
        status = critreg_stick_button_task(i, 0, 1, instances[i], NUMBERS);
    if (status == CRITREG_OK)
        status = critreg_learner_init(memory, sizeof memory, critreg_stick_button_domain(),
                                      &config, &learner);
    if (status == CRITREG_OK)
        status = learn(learner);
    if (status == CRITREG_OK)
        status = critreg_learner_region(learner, &region);
    return status == CRITREG_OK ? draw(region) : status;
}

/* How much memory a learner takes, by its capacity. */
static void print_sizes(void)
{
    static const struct {
        const char *key;
        uint32_t forms, observations, tracked;
    } sizes[] = {
        {"ram_256_64", 256, 64, UINT32_MAX},
        {"ram_1024_128", 1024, 128, UINT32_MAX},
        {"ram_1024_128_untracked", 1024, 128, 0},
        {"ram_4096_256", 4096, 256, UINT32_MAX},
    };
    size_t i;
    for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        static critreg_config config;
        (void)critreg_config_init(&config, sizeof config);
        config.forms = sizes[i].forms;
        config.observations = sizes[i].observations;
        config.tracked = sizes[i].tracked;
        config.sums = 0;
        config.questions = 1;
        config.instances = TRAINING;
        print(sizes[i].key, (double)critreg_learner_size(&config));
    }
}

int main(void)
{
    calibrate();
    critreg_status status = run();
    print_sizes();
    print("stack", (double)machine_stack_used());
    if (status != CRITREG_OK)
        machine_print(critreg_strerror(status));
    return status != CRITREG_OK;
}
