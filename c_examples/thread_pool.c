/*
 * Learning with many simulators at once: a pool of threads, each of which runs one trial at a
 * time. The learner is locked while it is asked or told, and not while a trial runs. Every
 * tenth worker dies in its trial; that costs its question and nothing else.
 *
 * The action: reach(r) moves a hand r metres forward. A wall stands somewhere ahead, and the
 * hand must not touch it. A trial takes TRIAL_MS milliseconds or so.
 */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "critreg.h"

enum { INSTANCES = 4, CALLS = 64, WORKERS = 16, TRIAL_MS = 20 };

static const char domain[] =
    "object wall { x: length, y: length }\n"
    "constant hand.radius = 0.1: length\n"
    "parameter reach in [0, 4]: length\n"
    "point hand = world + (reach, 0)\n";

/* Where the wall stands: x and y. */
static const double instances[INSTANCES][2] = {{1.0, 0.0}, {1.5, 0.0}, {2.5, 0.0}, {3.0, 0.0}};
static const double *const all = &instances[0][0];

/* What the workers share. */
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t told = PTHREAD_COND_INITIALIZER;
static critreg_learner *learner;
static int trials, lost;

static void check(critreg_status status, const char *call)
{
    char why[128] = "";
    if (status == CRITREG_OK)
        return;
    if (learner != NULL)
        (void)critreg_learner_message(learner, why, sizeof why, NULL);
    fprintf(stderr, "%s: %s. %s\n", call, critreg_strerror(status), why);
    exit(EXIT_FAILURE);
}
#define CHECK(call) check((call), #call)

/* Stands for a simulator: from half to one and a half times its mean. */
static critreg_outcome simulate(size_t instance, double reach, int number)
{
    struct timespec time = {0, 1000000L * (TRIAL_MS / 2 + number * 7 % (TRIAL_MS + 1))};
    (void)nanosleep(&time, NULL);
    return reach <= instances[instance][0] - 0.1 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
}

/* Waits for a question, with the mutex locked. Returns 0 if learning is finished. */
static int next_question(uint64_t *id, size_t *instance, double *reach)
{
    for (;;) {
        int32_t finished;
        size_t given;
        CHECK(critreg_is_finished(learner, &finished));
        if (finished)
            return 0;
        CHECK(critreg_ask_many(learner, all, INSTANCES, 1, id, instance, reach, &given));
        if (given == 1)
            return 1;
        /* All calls are on their way: an answer may be lost, and one be left again. */
        (void)pthread_cond_wait(&told, &mutex);
    }
}

static void *work(void *unused)
{
    uint64_t id;
    size_t instance;
    double reach;

    (void)unused;
    (void)pthread_mutex_lock(&mutex);
    while (next_question(&id, &instance, &reach)) {
        int number = trials++;
        critreg_outcome outcome;
        (void)pthread_mutex_unlock(&mutex);
        outcome = simulate(instance, reach, number);
        (void)pthread_mutex_lock(&mutex);
        if (number % 10 == 9) {
            CHECK(critreg_forget(learner, id));
            lost++;
        } else {
            CHECK(critreg_tell_id(learner, all, INSTANCES, id, outcome));
        }
        (void)pthread_cond_broadcast(&told);
    }
    (void)pthread_cond_broadcast(&told);
    (void)pthread_mutex_unlock(&mutex);
    return NULL;
}

static double seconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Learns with so many workers, and returns how long it took. */
static double learn(int workers, uint64_t *memory, size_t memory_len)
{
    pthread_t threads[WORKERS];
    critreg_config config;
    const critreg_region *region;
    char text[512];
    double start = seconds(), took;
    int i;

    CHECK(critreg_config_init(&config, sizeof config));
    config.calls = CALLS;
    CHECK(critreg_learner_init(memory, memory_len, domain, &config, &learner));
    trials = lost = 0;
    for (i = 0; i < workers; i++)
        if (pthread_create(&threads[i], NULL, work, NULL) != 0)
            exit(EXIT_FAILURE);
    for (i = 0; i < workers; i++)
        (void)pthread_join(threads[i], NULL);
    took = seconds() - start;
    CHECK(critreg_learner_region(learner, &region));
    CHECK(critreg_region_format(region, text, sizeof text, NULL));
    printf("workers: %d, trials: %d, lost: %d, seconds: %.2f, region: %s\n", workers, trials,
           lost, took, text);
    return took;
}

int main(void)
{
    static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
    double one = learn(1, memory, sizeof memory);
    double many = learn(WORKERS, memory, sizeof memory);
    printf("%d workers are %.1f times as fast\n", WORKERS, one / many);
    return EXIT_SUCCESS;
}
