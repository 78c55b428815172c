/*
 * Learning without a callback: the program asks what to try, tries it wherever it
 * likes, and tells what came of it. Half-way the run is saved to a file and
 * resumed in another learner, as if the program had been stopped in between. Both
 * end with the same region.
 *
 * The action: reach(r) moves a hand r metres forward. A wall stands somewhere
 * ahead, and the hand must not touch it.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "critreg.h"

#define INSTANCES 4
#define HALF 10         /* samples before the run is saved */

static const char DOMAIN[] =
    "object wall { x: length, y: length }\n"
    "constant hand.radius = 0.1: length\n"
    "parameter reach in [0, 4]: length\n"
    "point hand = world + (reach, 0)\n";

/* Where the wall stands: x and y. */
static const double instances[INSTANCES][2] = {{1.0, 0.0}, {1.5, 0.0}, {2.5, 0.0}, {3.0, 0.0}};
static const double *const all = &instances[0][0];

#define CHECK(call) check((call), #call, NULL)
#define CHECK_LEARNER(call, learner) check((call), #call, learner)

static void check(critreg_status status, const char *call, const critreg_learner *learner)
{
    char why[128] = "";
    if (status == CRITREG_OK)
        return;
    if (learner != NULL)
        (void)critreg_learner_message(learner, why, sizeof why, NULL);
    fprintf(stderr, "%s: %s. %s\n", call, critreg_strerror(status), why);
    exit(EXIT_FAILURE);
}

/* Stands for a robot, a queue of jobs, another process. */
static critreg_outcome try_on_the_robot(size_t instance, double reach)
{
    double gap = instances[instance][0] - reach - 0.1;
    return gap >= 0.0 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
}

/* Asks and tells so many times, or until there is nothing more to ask. */
static int go_on(critreg_learner *learner, int samples)
{
    int done;
    for (done = 0; done < samples; done++) {
        size_t instance;
        double reach;
        int32_t finished;
        CHECK(critreg_is_finished(learner, &finished));
        if (finished)
            break;
        CHECK_LEARNER(critreg_ask(learner, all, INSTANCES, &instance, &reach), learner);
        CHECK_LEARNER(critreg_tell(learner, all, INSTANCES, try_on_the_robot(instance, reach)),
                      learner);
    }
    return done;
}

static critreg_learner *new_learner(uint64_t *memory, size_t memory_len)
{
    critreg_config config;
    critreg_learner *learner;

    CHECK(critreg_config_init(&config, sizeof config));
    config.seed = 1;
    config.calls = 40;
    CHECK(critreg_learner_init(memory, memory_len, DOMAIN, &config, &learner));
    return learner;
}

/* Saves a run into a temporary file. */
static FILE *save(critreg_learner *learner)
{
    size_t needed = 0;
    uint8_t *bytes;
    FILE *file = tmpfile();

    if (critreg_learner_save(learner, all, INSTANCES, NULL, 0, &needed) != CRITREG_TOO_SMALL) {
        fprintf(stderr, "the length of the saved run is not told\n");
        exit(EXIT_FAILURE);
    }
    bytes = (uint8_t *)malloc(needed);
    if (file == NULL || bytes == NULL) {
        perror("saving");
        exit(EXIT_FAILURE);
    }
    CHECK_LEARNER(critreg_learner_save(learner, all, INSTANCES, bytes, needed, &needed), learner);
    if (fwrite(bytes, 1, needed, file) != needed || fflush(file) != 0) {
        perror("saving");
        exit(EXIT_FAILURE);
    }
    printf("saved bytes: %lu\n", (unsigned long)needed);
    free(bytes);
    rewind(file);
    return file;
}

static void resume(critreg_learner *learner, FILE *file)
{
    uint8_t bytes[4096];
    size_t length = fread(bytes, 1, sizeof bytes, file);

    CHECK_LEARNER(critreg_learner_resume(learner, all, INSTANCES, bytes, length), learner);
    fclose(file);
}

static void region_text(critreg_learner *learner, char *text, size_t len)
{
    const critreg_region *region;
    critreg_status status = critreg_learner_region(learner, &region);

    if (status == CRITREG_NO_REGION) {
        snprintf(text, len, "none");
        return;
    }
    CHECK_LEARNER(status, learner);
    CHECK(critreg_region_format(region, text, len, NULL));
}

int main(void)
{
    static uint64_t first_memory[CRITREG_LEARNER_WORDS(1024, 256)];
    static uint64_t second_memory[CRITREG_LEARNER_WORDS(1024, 256)];
    critreg_learner *first, *second;
    critreg_report report;
    char first_text[4096], second_text[4096];
    FILE *saved;

    first = new_learner(first_memory, sizeof first_memory);
    printf("samples before saving: %d\n", go_on(first, HALF));
    saved = save(first);
    printf("samples of the first learner after saving: %d\n", go_on(first, 1000));

    second = new_learner(second_memory, sizeof second_memory);
    resume(second, saved);
    printf("samples of the second learner after resuming: %d\n", go_on(second, 1000));

    CHECK(critreg_report_init(&report, sizeof report));
    CHECK(critreg_learner_report(second, &report));
    printf("samples in all: %" PRIu64 ", feasible: %" PRIu64 "\n", report.calls, report.feasible);

    region_text(first, first_text, sizeof first_text);
    region_text(second, second_text, sizeof second_text);
    printf("region of the first learner:  %s\n", first_text);
    printf("region of the second learner: %s\n", second_text);
    if (strcmp(first_text, second_text) != 0) {
        fprintf(stderr, "the regions differ\n");
        return EXIT_FAILURE;
    }
    puts("the regions are identical");
    return EXIT_SUCCESS;
}
