/*
 * Learning on a cluster: rank 0 learns, all others simulate.
 *
 *     mpiexec -disable-auto-cleanup -n 17 build/bin/mpi JOURNAL
 *
 * Every answer is appended to JOURNAL. If rank 0 is killed, the same command goes on where it
 * was, with nothing lost that was told. A worker that is killed, or hangs, costs its question
 * only: it is forgotten after a while, and asked again; an answer that comes late all the same
 * is taken. So MPI must not end the others when one ends: of MPICH that is the option above, of
 * Open MPI --enable-recovery. The program does not ask MPI who is alive, as not every MPI knows,
 * but measures time: rank 0 that of a trial, a worker that of silence.
 *
 * With a JOURNAL that is complete it only prints the region, and needs no others.
 *
 * The action is that of thread_pool.c: reach(r) moves a hand r metres forward, a wall stands
 * somewhere ahead, and a trial takes TRIAL_MS milliseconds or so.
 */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <inttypes.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "critreg.h"

enum { INSTANCES = 4, CALLS = 64, TRIAL_MS = 20, MOST_WORKERS = CRITREG_MAX_QUESTIONS };
enum { LEARNING = 0 };
enum { QUESTION, WAIT, ANSWER };    /* kinds of messages */
/* In seconds: when a trial is given up, how often a worker hears of rank 0, and when it believes
 * that this is dead. */
static const double TRIAL_MOST = 1.0, BEAT = 0.2, SILENCE_MOST = 2.0;

static const char domain[] =
    "object wall { x: length, y: length }\n"
    "constant hand.radius = 0.1: length\n"
    "parameter reach in [0, 4]: length\n"
    "point hand = world + (reach, 0)\n";

/* Where the wall stands: x and y. */
static const double instances[INSTANCES][2] = {{1.0, 0.0}, {1.5, 0.0}, {2.5, 0.0}, {3.0, 0.0}};
static const double *const all = &instances[0][0];

/* What is sent: a question, and the answer to it. */
typedef struct {
    uint64_t id, instance;
    double reach;
    int64_t outcome;
} trial;

/* What rank 0 knows of a worker. */
typedef struct {
    int busy, lost;
    trial asked;
    double since, heard;    /* when it was asked, and when it heard of rank 0 last */
} worker;

static critreg_learner *learner;
static FILE *journal;
static size_t written;      /* observations in the journal */
static worker workers[MOST_WORKERS + 1];
static int lost;

static void stop(const char *what, const char *why)
{
    fprintf(stderr, "mpi: %s: %s\n", what, why);
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    exit(EXIT_FAILURE);
}

static void check(critreg_status status, const char *call)
{
    char why[128] = "";
    if (status == CRITREG_OK)
        return;
    if (learner != NULL)
        (void)critreg_learner_message(learner, why, sizeof why, NULL);
    fprintf(stderr, "mpi: %s\n", call);
    stop(critreg_strerror(status), why);
}
#define CHECK(call) check((call), #call)

static void pause_for(int milliseconds)
{
    struct timespec time = {0, 1000000L * milliseconds};
    (void)nanosleep(&time, NULL);
}

/* Receives a message if there is one. It waits for none, because its sender may be dead. */
static int receive(trial *own, MPI_Status *about)
{
    int there = 0;
    if (MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, about) != MPI_SUCCESS)
        return 0;
    return there && MPI_Recv(own, (int)sizeof *own, MPI_BYTE, about->MPI_SOURCE, about->MPI_TAG,
                             MPI_COMM_WORLD, about) == MPI_SUCCESS;
}

/* Sends a message, short enough not to wait for who receives it. */
static void send(int to, int kind, const trial *own)
{
    MPI_Request request;
    if (MPI_Isend(own, (int)sizeof *own, MPI_BYTE, to, kind, MPI_COMM_WORLD, &request)
        == MPI_SUCCESS)
        MPI_Request_free(&request);
}

/* A worker: tries what it is asked for, until it hears nothing more. */
static void work(void)
{
    double heard = MPI_Wtime();
    MPI_Status about;
    trial own;
    while (MPI_Wtime() - heard < SILENCE_MOST) {
        if (!receive(&own, &about)) {
            pause_for(1);
            continue;
        }
        heard = MPI_Wtime();
        if (about.MPI_TAG == QUESTION) {
            pause_for(TRIAL_MS / 2 + (int)(own.id % (TRIAL_MS + 1)));
            own.outcome = own.reach <= instances[own.instance][0] - 0.1;
            send(LEARNING, ANSWER, &own);
            heard = MPI_Wtime();
        }
    }
}

/* Appends what was told since to the journal, on the disk. */
static void note(void)
{
    static uint8_t bytes[64 * CALLS];
    critreg_report report;
    size_t length;
    CHECK(critreg_report_init(&report, sizeof report));
    CHECK(critreg_learner_report(learner, &report));
    if (report.calls == written)
        return;
    CHECK(critreg_learner_journal(learner, all, INSTANCES, written, bytes, sizeof bytes,
                                  &length));
    if (fwrite(bytes, 1, length, journal) != length || fflush(journal) != 0
        || fsync(fileno(journal)) != 0)
        stop("the journal", strerror(errno));
    written = (size_t)report.calls;
}

/* Reads what the journal has, and cuts off a record that was torn. */
static void resume(const char *path)
{
    static uint8_t bytes[64 * CALLS];
    critreg_report report;
    size_t length, stands;
    journal = fopen(path, "a+b");
    if (journal == NULL)
        stop(path, strerror(errno));
    rewind(journal);
    length = fread(bytes, 1, sizeof bytes, journal);
    CHECK(critreg_learner_resume_journal(learner, all, INSTANCES, bytes, length, &stands));
    if (ftruncate(fileno(journal), (off_t)stands) != 0 || fseek(journal, 0, SEEK_END) != 0)
        stop(path, strerror(errno));
    CHECK(critreg_report_init(&report, sizeof report));
    CHECK(critreg_learner_report(learner, &report));
    written = (size_t)report.calls;
}

/* Asks a worker something if there is something to ask. What was told is on the disk before. */
static void ask(int rank)
{
    worker *own = &workers[rank];
    size_t instance, given;
    CHECK(critreg_ask_many(learner, all, INSTANCES, 1, &own->asked.id, &instance,
                           &own->asked.reach, &given));
    note();
    if (given == 0)
        return;
    own->asked.instance = instance;
    own->busy = 1;
    own->since = own->heard = MPI_Wtime();
    send(rank, QUESTION, &own->asked);
}

/* Takes the answers that came. One to a question that was given up is a fact all the same, as
 * long as the learner knows the question. */
static void take_answers(void)
{
    MPI_Status about;
    trial own;
    while (receive(&own, &about)) {
        worker *from = &workers[about.MPI_SOURCE];
        critreg_status status = critreg_tell_id(learner, all, INSTANCES, own.id,
                                                (critreg_outcome)own.outcome);
        if (status != CRITREG_OUT_OF_SEQUENCE)
            CHECK(status);
        from->busy = from->lost = 0;
    }
}

static void learn(int ranks)
{
    int32_t finished = 0;
    int rank;
    for (;;) {
        take_answers();
        for (rank = 1; rank < ranks; rank++) {
            worker *own = &workers[rank];
            double now = MPI_Wtime();
            if (own->busy && !own->lost && now - own->since > TRIAL_MOST) {
                CHECK(critreg_forget(learner, own->asked.id));
                own->lost = 1;
                lost++;
            }
            if (!own->busy)
                ask(rank);
            if (!own->busy && now - own->heard > BEAT) {
                send(rank, WAIT, &own->asked);
                own->heard = now;
            }
        }
        CHECK(critreg_is_finished(learner, &finished));
        if (finished)
            break;
        if (ranks == 1)
            stop("the run is not complete", "it needs workers, so start it with mpiexec");
        pause_for(1);
    }
    note();
}

int main(int argc, char **argv)
{
    static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
    const critreg_region *region;
    critreg_config config;
    int rank, ranks;
    char text[512];

    MPI_Init(&argc, &argv);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (argc != 2 || ranks > MOST_WORKERS + 1)
        stop("usage", "mpiexec -disable-auto-cleanup -n (2 to 65) mpi JOURNAL");
    printf("rank %d is process %ld\n", rank, (long)getpid());
    fflush(stdout);
    if (rank != LEARNING) {
        work();
        /* Nobody is left to finish with. */
        _exit(EXIT_FAILURE);
    }
    CHECK(critreg_config_init(&config, sizeof config));
    config.calls = CALLS;
    config.questions = CRITREG_MAX_QUESTIONS;
    CHECK(critreg_learner_init(memory, sizeof memory, domain, &config, &learner));
    resume(argv[1]);
    printf("resumed with %lu answers\n", (unsigned long)written);
    learn(ranks);
    CHECK(critreg_learner_region(learner, &region));
    CHECK(critreg_region_format(region, text, sizeof text, NULL));
    printf("answers: %lu, questions given up: %d, region: %s\n", (unsigned long)written, lost,
           text);
    fflush(stdout);
    fclose(journal);
    /* Some workers may be dead, so that all together cannot finish. */
    if (ranks > 1)
        MPI_Abort(MPI_COMM_WORLD, EXIT_SUCCESS);
    MPI_Finalize();
    return EXIT_SUCCESS;
}
