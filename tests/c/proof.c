/* Regions that are proven to satisfy a specification, refuted, or neither. */
#include "expect.h"

static const char ROOM[] =
    "object post[3] { x: length, y: length, radius: length }\n"
    "object door { x: length }\n"
    "constant robot.radius = 0.1: length\n"
    "parameter px in [0, 2]: length\n"
    "parameter py in [0, 2]: length\n"
    "point robot = world + (px, py)\n"
    "shape robot = circle(robot.radius)\n"
    "shape post = circle(post.radius)\n";
static const double RANGES[20] = {0, 2, 0, 2, 0.05, 0.3, 0, 2, 0, 2,
                                  0.05, 0.3, 0, 2, 0, 2, 0.05, 0.3, 0, 2};
static uint64_t memory[3][CRITREG_REGION_WORDS];

static critreg_region *parsed(int place, const char *domain, const char *text)
{
    critreg_region *region = NULL;
    OK(critreg_region_parse(memory[place], sizeof memory[place], domain, text, &region));
    return region;
}

static critreg_proof fresh(void)
{
    critreg_proof proof;
    OK(critreg_proof_init(&proof, sizeof proof));
    return proof;
}

/* From one wall a learner cannot tell what depends on the wall; counterexamples show it. */
static void challenge(void)
{
    static uint64_t words[CRITREG_LEARNER_WORDS(1024, 256)];
    static const double ranges[4] = {0.5, 3.0, 0.0, 0.0};
    const critreg_region *specification = parsed(2, DOMAIN, "hand.x + hand.radius <= wall.x");
    const critreg_region *region;
    critreg_config config = reach_config();
    critreg_learner *learner;
    critreg_proof proof = fresh();
    critreg_outcome outcome;
    double walls[2 * 16] = {1.0, 0.0}, theta[1];
    size_t count = 1;
    OK(critreg_learner_init(words, sizeof words, DOMAIN, &config, &learner));
    EXPECT(CRITREG_NO_REGION, critreg_learner_challenge(learner, specification, ranges, &proof,
                                                        &walls[2], theta));
    OK(critreg_learn_region(learner, walls, count, reach, NULL, &region));
    while (critreg_learner_challenge(learner, specification, ranges, &proof, &walls[2 * count],
                                     theta) == CRITREG_OK &&
           proof.verdict == CRITREG_REFUTED && count < 15) {
        OK(reach(NULL, &walls[2 * count], theta, &outcome));
        OK(critreg_observe(learner, walls, count + 1, count, theta, outcome));
        count++;
        OK(critreg_conclude(learner, walls, count));
    }
    EXPECT_TRUE(proof.verdict == CRITREG_PROVEN && count > 1 && count < 8);
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_challenge(learner, NULL, ranges, &proof, &walls[2], theta));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_learner_challenge(NULL, specification, ranges, &proof, &walls[2], theta));
}

int main(void)
{
    const critreg_region *safe = parsed(0, ROOM, "min(clear(robot, post)) >= 0.02 and px <= door.x");
    const critreg_region *clear =
        parsed(1, ROOM, "px + robot.radius <= door.x + 0.1 and min(clear(robot, post)) >= 0");
    const critreg_region *other = parsed(2, DOMAIN, "reach <= 1");
    critreg_proof proof = fresh();
    double instance[10], theta[2], ranges[20];
    static char text[16384];
    size_t count, number, needed;
    int32_t inside;
    OK(critreg_region_implies(safe, clear, RANGES, &proof, instance, theta));
    EXPECT_TRUE(proof.verdict == CRITREG_PROVEN && proof.boxes >= 4);

    OK(critreg_region_implies(clear, safe, RANGES, &proof, instance, theta));
    EXPECT_TRUE(proof.verdict == CRITREG_REFUTED && proof.statement == 0);
    OK(critreg_region_contains(clear, instance, theta, &inside));
    EXPECT_TRUE(inside == 1);
    OK(critreg_region_contains(safe, instance, theta, &inside));
    EXPECT_TRUE(inside == 0);

    OK(critreg_region_question_count(clear, &count));
    EXPECT_TRUE(count == 4);
    for (number = 0; number < count; number++) {
        OK(critreg_region_to_smt2(safe, clear, RANGES, NULL, number, text, sizeof text, &needed));
        EXPECT_TRUE(strlen(text) + 1 == needed && strstr(text, "(check-sat)"));
    }
    EXPECT_TRUE(strstr(text, "|post[2].x|") != NULL);
    EXPECT(CRITREG_TOO_SMALL,
           critreg_region_to_smt2(safe, clear, RANGES, &proof, 0, text, 100, &needed));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_to_smt2(safe, clear, RANGES, &proof, 4, text, sizeof text, &needed));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_question_count(clear, NULL));
    EXPECT(CRITREG_NULL_POINTER,
           critreg_region_to_smt2(safe, clear, NULL, &proof, 0, text, sizeof text, &needed));

    proof.max_boxes = 0;
    OK(critreg_region_implies(clear, safe, RANGES, &proof, instance, theta));
    EXPECT_TRUE(proof.verdict == CRITREG_UNDECIDED && proof.open == 1.0 && !proof.too_fine);

    proof = fresh();
    EXPECT(CRITREG_MISMATCH, critreg_region_implies(safe, other, RANGES, &proof, instance, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(safe, clear, NULL, &proof, instance, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(safe, clear, RANGES, NULL, instance, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(safe, clear, RANGES, &proof, NULL, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(safe, clear, RANGES, &proof, instance, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(safe, NULL, RANGES, &proof, instance, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_implies(NULL, safe, RANGES, &proof, instance, theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_proof_init(NULL, sizeof proof));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_proof_init(&proof, 3));
    memcpy(ranges, RANGES, sizeof ranges);
    ranges[18] = NAN;
    EXPECT(CRITREG_NOT_FINITE, critreg_region_implies(safe, clear, ranges, &proof, instance, theta));
    ranges[18] = 3.0;
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_implies(safe, clear, ranges, &proof, instance, theta));
    proof.tolerance = 0.0;
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_implies(safe, clear, RANGES, &proof, instance, theta));
    challenge();
    return summary();
}
