/* Several questions at once: ids, any order, lost workers, resumed runs. */
#include "expect.h"

enum { WORKERS = 8 };

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];
static uint64_t other[CRITREG_LEARNER_WORDS(1024, 256)];
static uint8_t bytes[16384];

typedef struct {
    uint64_t ids[WORKERS];
    size_t instances[WORKERS];
    double thetas[WORKERS];
    size_t given;
} questions;

static void ask(critreg_learner *learner, size_t wanted, questions *asked)
{
    OK(critreg_ask_many(learner, WALLS, INSTANCES, wanted, asked->ids, asked->instances,
                        asked->thetas, &asked->given));
}

static void answer(critreg_learner *learner, const questions *asked, size_t at)
{
    critreg_outcome outcome;
    OK(reach(NULL, &WALLS[2 * asked->instances[at]], &asked->thetas[at], &outcome));
    OK(critreg_tell_id(learner, WALLS, INSTANCES, asked->ids[at], outcome));
}

/* The last answers come first. */
static void backwards(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    int32_t finished = 0, rounds = 0;
    critreg_report report;

    while (critreg_is_finished(learner, &finished) == CRITREG_OK && !finished) {
        questions asked;
        size_t at;
        ask(learner, WORKERS, &asked);
        EXPECT_TRUE(asked.given == (kind == CRITREG_ALGORITHM1 ? 1 : WORKERS));
        for (at = asked.given; at-- > 0;)
            answer(learner, &asked, at);
        rounds++;
    }
    EXPECT_TRUE(rounds == (kind == CRITREG_ALGORITHM1 ? SAMPLES : SAMPLES / WORKERS));
    OK(critreg_report_init(&report, sizeof report));
    OK(critreg_learner_report(learner, &report));
    EXPECT_TRUE(report.calls == (uint64_t)SAMPLES);
    {
        questions none;
        ask(learner, WORKERS, &none);
        EXPECT_TRUE(none.given == 0);
    }
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, NULL));
}

static void lost_workers(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    questions asked, open;

    ask(learner, 3, &asked);
    OK(critreg_forget(learner, asked.ids[1]));
    OK(critreg_open_questions(learner, WORKERS, open.ids, open.instances, open.thetas,
                              &open.given));
    EXPECT_TRUE(open.given == 2 && open.ids[0] == asked.ids[0] && open.ids[1] == asked.ids[2]);
    EXPECT_TRUE(open.instances[1] == asked.instances[2] && open.thetas[1] == asked.thetas[2]);
    answer(learner, &asked, 1);
    answer(learner, &asked, 0);
    EXPECT(CRITREG_OUT_OF_SEQUENCE,
           critreg_tell_id(learner, WALLS, INSTANCES, asked.ids[0], CRITREG_FEASIBLE));
    EXPECT(CRITREG_OUT_OF_SEQUENCE, critreg_forget(learner, asked.ids[0]));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_tell_id(learner, WALLS, INSTANCES, asked.ids[2], CRITREG_NO_OUTCOME));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_tell_id(learner, WALLS, INSTANCES, asked.ids[2], CRITREG_FAILED_STEP(2)));
    /* The one that is open is what ask() asks. */
    {
        size_t instance = INSTANCES;
        double theta = -1.0;
        OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
        EXPECT_TRUE(instance == asked.instances[2] && theta == asked.thetas[2]);
    }
    answer(learner, &asked, 2);
    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, NULL));
}

/* A run that is resumed knows its open questions, and the answer that waits. */
static void resumed(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory), *again;
    questions asked, open;
    size_t needed = 0, at;

    ask(learner, 5, &asked);
    answer(learner, &asked, 4);
    OK(critreg_learner_save(learner, WALLS, INSTANCES, bytes, sizeof bytes, &needed));
    again = reach_learner(other, sizeof other);
    OK(critreg_learner_resume(again, WALLS, INSTANCES, bytes, needed));
    OK(critreg_open_questions(again, WORKERS, open.ids, open.instances, open.thetas,
                              &open.given));
    EXPECT_TRUE(open.given == 4);
    for (at = 0; at < open.given; at++) {
        EXPECT_TRUE(open.ids[at] == asked.ids[at] && open.thetas[at] == asked.thetas[at]);
        answer(again, &open, at);
    }
    expect_usable(again);
}

static void misuse(void)
{
    critreg_learner *learner = reach_learner(memory, sizeof memory);
    critreg_config config = reach_config();
    questions asked;
    size_t given = 7;

    EXPECT(CRITREG_NULL_POINTER,
           critreg_ask_many(learner, WALLS, INSTANCES, 1, NULL, asked.instances, asked.thetas,
                            &given));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_ask_many(learner, WALLS, INSTANCES, 1, asked.ids, asked.instances, NULL,
                            &given));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_ask_many(learner, WALLS, INSTANCES, 1, asked.ids, asked.instances,
                            asked.thetas, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_ask_many(learner, WALLS, 0, 1, asked.ids, asked.instances, asked.thetas,
                            &given));
    EXPECT_TRUE(given == 7);
    OK(critreg_ask_many(learner, WALLS, INSTANCES, 0, NULL, NULL, NULL, &given));
    EXPECT_TRUE(given == 0);

    config.questions = 0;
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_learner_init(other, sizeof other, DOMAIN, &config, &learner));
    config.questions = CRITREG_MAX_QUESTIONS + 1;
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_learner_init(other, sizeof other, DOMAIN, &config, &learner));
}

int main(void)
{
    with_each_learner(backwards);
    lost_workers();
    resumed();
    misuse();
    return summary();
}
