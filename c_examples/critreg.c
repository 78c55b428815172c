/*
 * A run of learning in a folder, for engines of any kind: shell scripts, GNU parallel, arrays
 * of jobs on a cluster. Every command locks the folder, does one thing, and replaces the saved
 * run in one step, so that a command that is killed has done all of it or nothing.
 *
 *     critreg new RUN DOMAIN INSTANCES [CALLS [SEED]]   makes a run of two texts: the domain,
 *                                             and the numbers of the instances, any blanks
 *     critreg ask RUN [N]                     asks for N samples, a line each: id, index of
 *                                             the instance, its numbers after "|", parameters
 *                                             after "|"
 *     critreg open RUN                        the same of all that are asked and not told
 *     critreg tell RUN ID OUTCOME             1: it worked; 0: it failed; -K: step K failed;
 *                                             2: nobody knows
 *     critreg forget RUN ID                   the worker was lost
 *     critreg observe RUN INSTANCE PARAMETERS... OUTCOME     a trial that nobody asked for
 *     critreg region RUN                      what is learned so far, and what it is worth
 *     critreg draw RUN INSTANCE               the same in one of the instances, by its index, with
 *                                             what was told of it: a picture, as SVG
 *     critreg draw DOMAIN REGION INSTANCE     such a picture of three texts: a domain, a region of
 *                                             it, and the numbers of an instance
 *
 * Exit status: 0 done; 1 refused, with the reason on stderr; 2 wrong usage; 3 there is nothing
 * to ask now (some answers are still to come); 4 learning is finished, or there is no region.
 */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "critreg.h"

enum { REFUSED = 1, USAGE = 2, NOTHING_NOW = 3, NOTHING_MORE = 4 };
enum { MOST_INSTANCES = 256, OBSERVATIONS = CRITREG_MAX_OBSERVATIONS };

static critreg_learner *learner;
static double *instances;
static size_t count, each, parameters;
static const char *folder;

static void stop(int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "critreg: ");
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\n");
    va_end(arguments);
    exit(status);
}

static void check(critreg_status status)
{
    char why[256] = "";
    if (status == CRITREG_OK)
        return;
    if (learner != NULL)
        (void)critreg_learner_message(learner, why, sizeof why, NULL);
    stop(REFUSED, "%s. %s", critreg_strerror(status), why);
}

/* What a command takes, until it ends. */
static void *taken[16];
static size_t takings;

static void release(void)
{
    while (takings > 0)
        free(taken[--takings]);
}

static void *allocate(size_t size)
{
    void *memory = calloc(size > 0 ? size : 1, 1);
    if (memory == NULL || takings == sizeof taken / sizeof *taken) {
        free(memory);
        stop(REFUSED, "there is no memory");
    }
    taken[takings++] = memory;
    return memory;
}

/* The path of a file in the folder of the run; in one of two buffers in turn. */
static const char *path(const char *name)
{
    static char paths[2][4096];
    static int turn;
    char *own = paths[turn ^= 1];
    if (snprintf(own, sizeof paths[0], "%s/%s", folder, name) >= (int)sizeof paths[0])
        stop(REFUSED, "the path of the run is too long");
    return own;
}

/* All bytes of a file, with a NUL behind. */
static char *contents(const char *file, size_t *length)
{
    FILE *opened = fopen(file, "rb");
    struct stat about;
    char *bytes;
    if (opened == NULL || fstat(fileno(opened), &about) != 0)
        stop(REFUSED, "%s: %s", file, strerror(errno));
    bytes = (char *)allocate((size_t)about.st_size + 1);
    *length = fread(bytes, 1, (size_t)about.st_size, opened);
    fclose(opened);
    return bytes;
}

/* Replaces a file of the run in one step. */
static void replace(const char *name, const void *bytes, size_t length)
{
    const char *part = path("part"), *whole = path(name);
    FILE *file = fopen(part, "wb");
    if (file == NULL || fwrite(bytes, 1, length, file) != length || fflush(file) != 0
        || fsync(fileno(file)) != 0 || fclose(file) != 0 || rename(part, whole) != 0)
        stop(REFUSED, "%s: %s", whole, strerror(errno));
}

static void lock(void)
{
    struct flock whole = {0};
    int file = open(path("lock"), O_RDWR | O_CREAT, 0666);
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    /* It is released when the program ends, however that is. */
    if (file < 0 || fcntl(file, F_SETLKW, &whole) != 0)
        stop(REFUSED, "%s: %s", folder, strerror(errno));
}

static double number(const char *text)
{
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0')
        stop(USAGE, "%s is no number", text);
    return value;
}

static long whole_number(const char *text)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end != '\0')
        stop(USAGE, "%s is no whole number", text);
    return value;
}

/* Reads the numbers of instances; how many numbers there are. */
static size_t read_instances(const char *file)
{
    size_t length, numbers;
    char *text = contents(file, &length), *end;

    /* A number takes a digit and a blank at least. */
    instances = (double *)allocate((length / 2 + 1) * sizeof *instances);
    for (numbers = 0;; numbers++, text = end) {
        double value = strtod(text, &end);
        if (end == text)
            break;
        instances[numbers] = value;
    }
    if (text[strspn(text, " \t\r\n")] != '\0')
        stop(REFUSED, "among the instances, this is no number: %.20s", text);
    return numbers;
}

/* Reads the texts of the run and makes a fresh learner. */
static void begin(void)
{
    size_t length, size;
    char *domain = contents(path("domain"), &length);
    char *settings = contents(path("settings"), &length);
    critreg_config config;
    critreg_status status;

    count = read_instances(path("instances"));
    check(critreg_config_init(&config, sizeof config));
    config.observations = OBSERVATIONS;
    config.instances = MOST_INSTANCES;
    if (sscanf(settings, "%" SCNu32 " %" SCNu64, &config.calls, &config.seed) != 2)
        stop(REFUSED, "%s/settings is damaged", folder);
    size = critreg_learner_size(&config);
    status = critreg_learner_init(allocate(size), size, domain, &config, &learner);
    if (status != CRITREG_OK) {
        char why[512] = "";
        (void)critreg_check_domain(domain, why, sizeof why, NULL);
        stop(REFUSED, "%s. %s", critreg_strerror(status), why);
    }
    check(critreg_learner_instance_len(learner, &each));
    check(critreg_learner_parameter_count(learner, &parameters));
    if (each > 0 && (count == 0 || count % each != 0))
        stop(REFUSED, "an instance has %lu numbers, and there are %lu in all",
             (unsigned long)each, (unsigned long)count);
    count = each > 0 ? count / each : 1;
}

static void load(void)
{
    size_t length;
    const char *bytes;
    begin();
    bytes = contents(path("saved"), &length);
    check(critreg_learner_resume(learner, instances, count, (const uint8_t *)bytes, length));
}

static void save(void)
{
    size_t needed = 0;
    uint8_t *bytes;
    if (critreg_learner_save(learner, instances, count, NULL, 0, &needed) != CRITREG_TOO_SMALL)
        stop(REFUSED, "the run cannot be saved");
    bytes = (uint8_t *)allocate(needed);
    check(critreg_learner_save(learner, instances, count, bytes, needed, &needed));
    replace("saved", bytes, needed);
}

static void print_questions(size_t given, const uint64_t *ids, const size_t *numbers,
                            const double *thetas)
{
    size_t i, k;
    for (i = 0; i < given; i++) {
        printf("%" PRIu64 " %lu |", ids[i], (unsigned long)numbers[i]);
        for (k = 0; k < each; k++)
            printf(" %.17g", instances[numbers[i] * each + k]);
        printf(" |");
        for (k = 0; k < parameters; k++)
            printf(" %.17g", thetas[i * parameters + k]);
        printf("\n");
    }
}

static int new_run(int argc, char **argv)
{
    char settings[64];
    size_t length;
    char *bytes;
    if (argc < 5 || argc > 7)
        return USAGE;
    if (mkdir(folder, 0777) != 0)
        stop(REFUSED, "%s: %s", folder, strerror(errno));
    lock();
    bytes = contents(argv[3], &length);
    replace("domain", bytes, length);
    bytes = contents(argv[4], &length);
    replace("instances", bytes, length);
    snprintf(settings, sizeof settings, "%ld %ld\n", argc > 5 ? whole_number(argv[5]) : 100,
             argc > 6 ? whole_number(argv[6]) : 0);
    replace("settings", settings, strlen(settings));
    begin();
    save();
    return 0;
}

static int ask(int argc, char **argv)
{
    static uint64_t ids[CRITREG_MAX_QUESTIONS];
    static size_t numbers[CRITREG_MAX_QUESTIONS];
    static double thetas[CRITREG_MAX_QUESTIONS * CRITREG_MAX_PARAMETERS];
    long wanted = argc > 3 ? whole_number(argv[3]) : 1;
    int32_t finished;
    size_t given;
    if (wanted < 1)
        return USAGE;
    load();
    check(critreg_ask_many(learner, instances, count, (size_t)wanted, ids, numbers, thetas,
                           &given));
    check(critreg_is_finished(learner, &finished));
    save();
    print_questions(given, ids, numbers, thetas);
    return given > 0 ? 0 : finished ? NOTHING_MORE : NOTHING_NOW;
}

static int open_questions(void)
{
    static uint64_t ids[CRITREG_MAX_QUESTIONS];
    static size_t numbers[CRITREG_MAX_QUESTIONS];
    static double thetas[CRITREG_MAX_QUESTIONS * CRITREG_MAX_PARAMETERS];
    size_t given;
    load();
    check(critreg_open_questions(learner, CRITREG_MAX_QUESTIONS, ids, numbers, thetas, &given));
    print_questions(given, ids, numbers, thetas);
    return 0;
}

static int tell(int argc, char **argv)
{
    if (argc != 5)
        return USAGE;
    load();
    check(critreg_tell_id(learner, instances, count, strtoull(argv[3], NULL, 10),
                          (critreg_outcome)whole_number(argv[4])));
    save();
    return 0;
}

static int forget(int argc, char **argv)
{
    if (argc != 4)
        return USAGE;
    load();
    check(critreg_forget(learner, strtoull(argv[3], NULL, 10)));
    save();
    return 0;
}

static int observe(int argc, char **argv)
{
    double theta[CRITREG_MAX_PARAMETERS];
    size_t i;
    load();
    if (argc != 5 + (int)parameters)
        stop(USAGE, "a sample has %lu parameters", (unsigned long)parameters);
    for (i = 0; i < parameters; i++)
        theta[i] = number(argv[4 + i]);
    check(critreg_observe(learner, instances, count, (size_t)whole_number(argv[3]), theta,
                          (critreg_outcome)whole_number(argv[argc - 1])));
    save();
    return 0;
}

static int region(void)
{
    const critreg_region *learned;
    critreg_report report;
    critreg_status status;
    char text[4096];
    uint32_t why;

    load();
    check(critreg_conclude(learner, instances, count));
    check(critreg_report_init(&report, sizeof report));
    check(critreg_learner_report(learner, &report));
    fprintf(stderr, "told: %" PRIu64 " of what was asked, %" PRIu64 " of what was not\n",
            report.calls, report.observed);
    check(critreg_learner_why(learner, &why, text, sizeof text, NULL));
    fprintf(stderr, "%s\n", text);
    status = critreg_learner_region(learner, &learned);
    if (status == CRITREG_NO_REGION)
        return NOTHING_MORE;
    check(status);
    check(critreg_region_format(learned, text, sizeof text, NULL));
    printf("%s\n", text);
    return 0;
}

static int draw_run(const char *index)
{
    long which = whole_number(index);
    critreg_status status;
    size_t needed = 0;
    char *svg;
    if (which < 0)
        return USAGE;
    lock();
    load();
    check(critreg_conclude(learner, instances, count));
    status = critreg_learner_to_svg(learner, instances, count, (size_t)which, NULL, 0, &needed);
    if (status != CRITREG_TOO_SMALL)
        check(status);
    svg = (char *)allocate(needed);
    check(critreg_learner_to_svg(learner, instances, count, (size_t)which, svg, needed, NULL));
    fputs(svg, stdout);
    return 0;
}

static int draw_texts(char **files)
{
    size_t length, needed = 0;
    const char *domain = contents(files[0], &length), *text = contents(files[1], &length);
    critreg_region *own;
    critreg_status status;
    char *svg, why[512] = "";

    status = critreg_check_region(domain, text, why, sizeof why, NULL);
    if (status != CRITREG_OK)
        stop(REFUSED, "%s. %s", critreg_strerror(status), why);
    check(critreg_region_parse(allocate(critreg_region_size()), critreg_region_size(), domain,
                               text, &own));
    count = read_instances(files[2]);
    check(critreg_region_instance_len(own, &each));
    if (count != each)
        stop(REFUSED, "an instance has %lu numbers, and there are %lu", (unsigned long)each,
             (unsigned long)count);
    status = critreg_region_to_svg(own, instances, NULL, 0, &needed);
    if (status != CRITREG_TOO_SMALL)
        check(status);
    svg = (char *)allocate(needed);
    check(critreg_region_to_svg(own, instances, svg, needed, NULL));
    fputs(svg, stdout);
    return 0;
}

static int draw(int argc, char **argv)
{
    if (argc == 4)
        return draw_run(argv[3]);
    return argc == 5 ? draw_texts(argv + 2) : USAGE;
}

static int run(const char *command, int argc, char **argv)
{
    if (strcmp(command, "draw") == 0)
        return draw(argc, argv);
    if (strcmp(command, "new") == 0)
        return new_run(argc, argv);
    lock();
    if (strcmp(command, "ask") == 0)
        return ask(argc, argv);
    if (strcmp(command, "open") == 0)
        return open_questions();
    if (strcmp(command, "tell") == 0)
        return tell(argc, argv);
    if (strcmp(command, "forget") == 0)
        return forget(argc, argv);
    if (strcmp(command, "observe") == 0)
        return observe(argc, argv);
    if (strcmp(command, "region") == 0)
        return region();
    return USAGE;
}

int main(int argc, char **argv)
{
    int status = USAGE;
    if (atexit(release) != 0)
        return REFUSED;
    if (argc > 2) {
        folder = argv[2];
        status = run(argv[1], argc, argv);
    }
    if (status == USAGE)
        fprintf(stderr, "usage: critreg new RUN DOMAIN INSTANCES [CALLS [SEED]]\n"
                        "       critreg ask RUN [N]\n"
                        "       critreg open|region RUN\n"
                        "       critreg tell RUN ID OUTCOME\n"
                        "       critreg forget RUN ID\n"
                        "       critreg observe RUN INSTANCE PARAMETERS... OUTCOME\n"
                        "       critreg draw RUN INSTANCE\n"
                        "       critreg draw DOMAIN REGION INSTANCE\n");
    return status;
}
