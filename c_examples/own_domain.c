/*
 * A domain and a simulator of one's own: a planar arm with two links must place
 * its hand on a table, at (px, py), without a link or the hand hitting a box.
 *
 * The planner's knowledge is the domain text below; whether a place works is told
 * by inverse kinematics and collision tests in C. A region is learned, another one
 * is written by hand, and draws from both are tried on other tables.
 *
 * Usage: own_domain [number of seeds]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "critreg.h"

#define UPPER 1.0           /* lengths of the links */
#define FORE 0.8
#define HALF_BOX 0.25       /* half of the side of the box */
#define HAND 0.05           /* radius of the hand */
#define PLACES 6            /* tables to learn from */
#define TABLES 50           /* tables to try, */
#define DRAWS 200           /* and draws on each of them */
#define CALLS 200           /* calls of the simulator */
#define SEEDS 10            /* how often learning is tried */

static const char DOMAIN[] =
    "object box { x: length, y: length }     # an instance is two numbers\n"
    "constant upper.length = 1.0: length\n"
    "constant fore.length  = 0.8: length\n"
    "constant hand.radius  = 0.05: length\n"
    "constant box.size     = 0.5: length\n"
    "shape box = rectangle(box.size, box.size) centred\n"
    "parameter px in [-2, 2]: length\n"
    "parameter py in [0, 2]: length\n"
    "point base = world\n"
    "point hand = world + (px, py)\n";

/* Within reach, and either well beside the box or before it. */
static const char BY_HAND[] =
    "dist(hand, base) <= upper.length + fore.length\n"
    "and dist(hand, base) >= upper.length - fore.length\n"
    "and (dist_x(hand, box) >= box.size\n"
    "     or hand.y <= box.y - 0.5*box.size - hand.radius)";

#define CHECK(call) check((call), #call)

static void check(critreg_status status, const char *call)
{
    if (status != CRITREG_OK) {
        fprintf(stderr, "%s: %s\n", call, critreg_strerror(status));
        exit(EXIT_FAILURE);
    }
}

/* Whether the line from a to b comes nearer to the box than a margin. */
static int hits(const double *box, double margin, const double *a, const double *b)
{
    double enter = 0.0, leave = 1.0;
    int axis;
    for (axis = 0; axis < 2; axis++) {
        double low = box[axis] - HALF_BOX - margin - a[axis];
        double high = box[axis] + HALF_BOX + margin - a[axis];
        double along = b[axis] - a[axis];
        if (along == 0.0) {
            if (low > 0.0 || high < 0.0)
                return 0;
        } else {
            enter = fmax(enter, fmin(low / along, high / along));
            leave = fmin(leave, fmax(low / along, high / along));
        }
    }
    return enter <= leave;
}

/* Whether the arm can stand with its hand at a place, its elbow on one side. */
static int can_place(const double *box, const double *hand, double side)
{
    const double base[2] = {0.0, 0.0};
    double reach = hypot(hand[0], hand[1]);
    double cosine = (UPPER * UPPER + reach * reach - FORE * FORE) / (2.0 * UPPER * reach);
    double shoulder, elbow[2];
    if (!(cosine >= -1.0 && cosine <= 1.0))
        return 0;   /* too far, or too near */
    shoulder = atan2(hand[1], hand[0]) + side * acos(cosine);
    elbow[0] = UPPER * cos(shoulder);
    elbow[1] = UPPER * sin(shoulder);
    return !hits(box, 0.0, base, elbow) && !hits(box, 0.0, elbow, hand)
        && !hits(box, HAND, hand, hand);
}

/* The simulator: a critreg_simulate. It counts its calls. */
static critreg_status try_place(void *user_data, const double *instance, const double *theta,
                                critreg_outcome *outcome)
{
    ++*(int *)user_data;
    *outcome = can_place(instance, theta, 1.0) || can_place(instance, theta, -1.0);
    return CRITREG_OK;
}

static double uniform(critreg_rng *rng, double low, double high)
{
    double share;

    CHECK(critreg_rng_uniform(rng, &share));
    return low + (high - low) * share;
}

/* A table with the box anywhere before the arm but not at its base. */
static void new_table(critreg_rng *rng, double *instance)
{
    instance[0] = uniform(rng, -0.8, 0.8);
    instance[1] = uniform(rng, 0.6, 1.4);
}

/* Prints how many draws work on other tables; without a region, uniform ones. */
static void print_rate(const char *key, const critreg_region *region)
{
    critreg_rng tables = critreg_rng_seed(100), rng = critreg_rng_seed(200);
    int drawn = 0, works = 0, calls = 0, t, d;

    for (t = 0; t < TABLES; t++) {
        double instance[2], theta[2];
        new_table(&tables, instance);
        for (d = 0; d < DRAWS; d++) {
            critreg_outcome outcome;
            if (region == NULL) {
                theta[0] = uniform(&rng, -2.0, 2.0);
                theta[1] = uniform(&rng, 0.0, 2.0);
            } else {
                critreg_status status = critreg_sample_region(region, instance, &rng, theta);
                if (status == CRITREG_EMPTY_REGION || status == CRITREG_NO_SAMPLE)
                    continue;
                CHECK(status);
            }
            CHECK(try_place(&calls, instance, theta, &outcome));
            drawn++;
            works += outcome == CRITREG_FEASIBLE;
        }
    }
    printf("%s: %d draws, feasibility rate %.3f\n", key, drawn,
           drawn > 0 ? works / (double)drawn : 0.0);
}

/* Learns from tables of its own; NULL if nothing was learned. */
static const critreg_region *learn(uint64_t seed, int *calls)
{
    static uint64_t memory[CRITREG_LEARNER_WORDS(4096, CALLS)];
    double instances[PLACES][2];
    critreg_rng rng = critreg_rng_seed(seed);
    critreg_config config;
    critreg_learner *learner;
    const critreg_region *region = NULL;
    critreg_status status;
    int i;

    for (i = 0; i < PLACES; i++)
        new_table(&rng, instances[i]);
    CHECK(critreg_config_init(&config, sizeof config));
    config.seed = seed;
    config.forms = 4096;
    config.observations = CALLS;
    config.calls = CALLS;
    config.slack = 0.05;    /* the truth is no conjunction: a constraint may miss a few */
    CHECK(critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &learner));
    status = critreg_learn_region(learner, &instances[0][0], PLACES, try_place, calls, &region);
    if (status != CRITREG_NO_REGION)
        CHECK(status);
    return region;
}

int main(int argc, char **argv)
{
    static uint64_t memory[CRITREG_REGION_WORDS];
    critreg_region *by_hand;
    char text[8192], why[128];
    int learned = 0, calls = 0, seed;
    int seeds = argc > 1 ? atoi(argv[1]) : SEEDS;
    if (seeds < 1 || seeds > SEEDS)
        return fprintf(stderr, "usage: own_domain [1 to %d seeds]\n", SEEDS), EXIT_FAILURE;
    if (critreg_check_region(DOMAIN, BY_HAND, why, sizeof why, NULL) != CRITREG_OK) {
        fprintf(stderr, "%s\n", why);
        return EXIT_FAILURE;
    }
    print_rate("uniform", NULL);
    CHECK(critreg_region_parse(memory, sizeof memory, DOMAIN, BY_HAND, &by_hand));
    CHECK(critreg_region_format(by_hand, text, sizeof text, NULL));
    printf("region by hand: %s\n", text);
    print_rate("region by hand", by_hand);

    for (seed = 0; seed < seeds; seed++) {
        const critreg_region *region = learn((uint64_t)seed, &calls);
        if (region == NULL)
            continue;
        learned++;
        CHECK(critreg_region_format(region, text, sizeof text, NULL));
        printf("region of seed %d: %s\n", seed, text);
        print_rate("learned region", region);
    }
    printf("seeds that learned a region: %d of %d, with %d calls of the simulator\n",
           learned, seeds, calls);
    return EXIT_SUCCESS;
}
