/* Wrong regions, texts, bytes, instances; the generator, and words for every status. */
#include "expect.h"

static const char REGION[] = "dist(hand, wall) >= 0.15 (1.5*hand.radius) and reach <= 2";
static uint64_t memory[CRITREG_REGION_WORDS];
static uint64_t other[CRITREG_REGION_WORDS];

static critreg_region *parsed(void)
{
    critreg_region *region = NULL;
    OK(critreg_region_parse(memory, sizeof memory, DOMAIN, REGION, &region));
    return region;
}

/* Every function refuses what is no region. */
static void no_handle(const critreg_region *region, critreg_status expected)
{
    critreg_constraint constraint;
    critreg_rng rng = critreg_rng_seed(1);
    double theta = 0.5, ends[2];
    const double *instance = WALLS;
    size_t number;
    int32_t answer;
    uint8_t bytes[64];
    char text[64];

    EXPECT(expected, critreg_region_save(region, bytes, sizeof bytes, &number));
    EXPECT(expected, critreg_region_format(region, text, sizeof text, &number));
    EXPECT(expected, critreg_region_instance_len(region, &number));
    EXPECT(expected, critreg_region_parameter_count(region, &number));
    EXPECT(expected, critreg_region_contains(region, WALLS, &theta, &answer));
    EXPECT(expected, critreg_region_intervals(region, WALLS, ends, 1, &number));
    EXPECT(expected, critreg_region_is_empty(region, WALLS, &answer));
    EXPECT(expected, critreg_sample_region(region, WALLS, &rng, &theta));
    EXPECT(expected, critreg_sample_regions(&region, &instance, 1, &rng, &theta));
    EXPECT(expected, critreg_regions_are_empty(&region, &instance, 1, &answer));
    OK(critreg_constraint_init(&constraint, sizeof constraint));
    EXPECT(expected, critreg_region_constraint_count(region, &number));
    EXPECT(expected, critreg_region_constraint(region, 0, &constraint));
    EXPECT(expected, critreg_region_constraint_format(region, 0, text, sizeof text, &number));
    EXPECT(expected, critreg_region_constraint_name(region, 0, text, sizeof text, &number));
}

/* Tells the truth about the next sample. */
static void tell_one(critreg_learner *learner)
{
    critreg_outcome outcome;
    size_t instance;
    double theta;
    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    OK(reach(NULL, WALLS + 2 * instance, &theta, &outcome));
    OK(critreg_tell(learner, WALLS, INSTANCES, outcome));
}

static void wrong_handles(void)
{
    static uint64_t learner_memory[CRITREG_LEARNER_WORDS(1024, 256)];
    critreg_learner *learner = reach_learner(learner_memory, sizeof learner_memory);
    const critreg_region *learned;
    size_t instance;
    double theta;

    no_handle(NULL, CRITREG_NULL_POINTER);
    no_handle(ASKEW(critreg_region, memory), CRITREG_MISALIGNED);
    memset(other, 0xA5, sizeof other);
    no_handle((critreg_region *)(void *)other, CRITREG_NOT_A_HANDLE);
    parsed();
    memcpy(other, memory, sizeof memory);
    no_handle((critreg_region *)(void *)other, CRITREG_NOT_A_HANDLE);
    no_handle((critreg_region *)(void *)learner, CRITREG_NOT_A_HANDLE);

    /* The learner's region is valid until the learner goes on. */
    EXPECT(CRITREG_NO_REGION, critreg_learner_region(learner, &learned));
    do
        tell_one(learner);
    while (critreg_learner_region(learner, &learned) == CRITREG_NO_REGION);
    OK(critreg_ask(learner, WALLS, INSTANCES, &instance, &theta));
    OK(critreg_region_instance_len(learned, &instance));
    tell_one(learner);
    no_handle(learned, CRITREG_NOT_A_HANDLE);
}

static void wrong_makers(void)
{
    critreg_region *const sentinel = (critreg_region *)(void *)other;
    critreg_region *region = sentinel;
    static char long_text[1 << 17];
    char why[128];

    EXPECT(CRITREG_NULL_POINTER, critreg_region_parse(NULL, sizeof memory, DOMAIN, REGION, &region));
    EXPECT(CRITREG_MISALIGNED, critreg_region_parse(ASKEW(void *, memory), sizeof memory - 8,
                                                    DOMAIN, REGION, &region));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_parse(memory, critreg_region_size() - 1, DOMAIN,
                                                   REGION, &region));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_parse(memory, 0, DOMAIN, REGION, &region));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_parse(memory, sizeof memory, NULL, REGION, &region));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_parse(memory, sizeof memory, DOMAIN, NULL, &region));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_parse(memory, sizeof memory, DOMAIN, REGION, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_region_parse(memory, sizeof memory, DOMAIN, REGION,
                                                    ASKEW(critreg_region *, other)));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_region_parse(memory, sizeof memory, "banana", REGION, &region));
    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_region_parse(memory, sizeof memory, DOMAIN, "reach <", &region));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_parse(memory, sizeof memory, DOMAIN, "\xff", &region));
    memset(long_text, ' ', sizeof long_text - 1);
    EXPECT(CRITREG_CAPACITY_EXCEEDED,
           critreg_region_parse(memory, sizeof memory, DOMAIN, long_text, &region));
    EXPECT_TRUE(region == sentinel);

    EXPECT(CRITREG_SYNTAX_ERROR,
           critreg_check_region(DOMAIN, "reach <= 1 and\n reach <= wall.height", why, sizeof why, NULL));
    EXPECT_TRUE(strncmp(why, "line 2, column 11: ", 19) == 0);
    EXPECT(CRITREG_SYNTAX_ERROR, critreg_check_region("banana", "true", NULL, 0, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_check_region(NULL, "true", why, sizeof why, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_check_region(DOMAIN, NULL, why, sizeof why, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_check_region(DOMAIN, "true", NULL, 1, NULL));
    OK(critreg_check_region(DOMAIN, "true", why, sizeof why, NULL));
    EXPECT_TRUE(why[0] == '\0');
}

static void text_and_bytes(void)
{
    critreg_region *region = parsed(), *loaded = NULL;
    uint8_t bytes[1024], damaged[1024];
    char text[256], again[256];
    size_t needed = 0, length, i;

    EXPECT(CRITREG_TOO_SMALL, critreg_region_format(region, NULL, 0, &needed));
    EXPECT_TRUE(needed == sizeof REGION);
    memset(text, 'x', sizeof text);
    EXPECT(CRITREG_TOO_SMALL, critreg_region_format(region, text, needed - 1, NULL));
    EXPECT_TRUE(text[0] == 'x');
    EXPECT(CRITREG_NULL_POINTER, critreg_region_format(region, NULL, 9, &needed));
    EXPECT(CRITREG_MISALIGNED, critreg_region_format(region, text, 9, ASKEW(size_t, other)));
    OK(critreg_region_format(region, text, needed, NULL));
    EXPECT_TRUE(strcmp(text, REGION) == 0 && text[needed] == 'x');

    EXPECT(CRITREG_TOO_SMALL, critreg_region_save(region, NULL, 0, &length));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_save(region, bytes, length - 1, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_save(region, NULL, sizeof bytes, &length));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_save(region, bytes, sizeof bytes, ASKEW(size_t, other)));
    OK(critreg_region_save(region, bytes, sizeof bytes, &length));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_load(other, sizeof other, NULL, length, &loaded));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_load(NULL, sizeof other, bytes, length, &loaded));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_load(other, sizeof other, bytes, length, NULL));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_load(other, 100, bytes, length, &loaded));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_load(other, sizeof other, bytes, SIZE_MAX, &loaded));
    for (i = 0; i < length; i++) {
        EXPECT(CRITREG_CORRUPT, critreg_region_load(other, sizeof other, bytes, i, &loaded));
        memcpy(damaged, bytes, length);
        damaged[i] ^= 0x04;
        EXPECT(CRITREG_CORRUPT,
               critreg_region_load(other, sizeof other, damaged, length, &loaded));
    }
    EXPECT_TRUE(loaded == NULL);
    OK(critreg_region_load(other, sizeof other, bytes, length, &loaded));
    OK(critreg_region_format(loaded, again, sizeof again, NULL));
    EXPECT_TRUE(strcmp(text, again) == 0);
}

/* The constraints one by one, of a region whose learner knows what supports them
 * if evidence is not 0. Joined they are the region. */
static void constraints_of(const critreg_region *region, int evidence)
{
    critreg_constraint constraint, unset;
    char whole[2048], joined[2048] = "", text[512], name[256];
    size_t count = 0, needed, i;

    OK(critreg_region_constraint_count(region, &count));
    EXPECT_TRUE(count > 0 && count <= CRITREG_MAX_CONSTRAINTS);
    for (i = 0; i < count; i++) {
        OK(critreg_constraint_init(&constraint, sizeof constraint));
        OK(critreg_region_constraint(region, i, &constraint));
        EXPECT_TRUE(constraint.struct_size == sizeof constraint);
        EXPECT_TRUE(constraint.has_evidence == evidence);
        if (evidence) {
            EXPECT_TRUE(constraint.step == 1 && constraint.support > 0);
            EXPECT_TRUE(constraint.feasible != constraint.infeasible);
        } else {
            EXPECT_TRUE(constraint.step == 0 && constraint.support == 0);
            EXPECT_TRUE(isnan(constraint.feasible) && isnan(constraint.infeasible));
        }
        OK(critreg_region_constraint_format(region, i, text, sizeof text, &needed));
        EXPECT_TRUE(needed == strlen(text) + 1);
        OK(critreg_check_region(DOMAIN, text, NULL, 0, NULL));
        OK(critreg_region_constraint_name(region, i, name, sizeof name, NULL));
        EXPECT_TRUE((strchr(text, '(') != NULL && text[needed - 2] == ')') >= (name[0] != '\0'));
        EXPECT_TRUE(strstr(text, name) != NULL);
        sprintf(joined + strlen(joined), "%s%s", i == 0 ? "" : " and ", text);
    }
    OK(critreg_region_format(region, whole, sizeof whole, NULL));
    EXPECT_TRUE(strcmp(whole, joined) == 0);

    EXPECT(CRITREG_NULL_POINTER, critreg_region_constraint_count(region, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_region_constraint_count(region, ASKEW(size_t, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_constraint_init(NULL, sizeof constraint));
    EXPECT(CRITREG_MISALIGNED,
           critreg_constraint_init(ASKEW(critreg_constraint, other), sizeof constraint));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_constraint_init(&constraint, sizeof constraint - 1));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_constraint_init(&constraint, sizeof constraint + 1));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_constraint(region, 0, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_constraint(region, 0, ASKEW(critreg_constraint, other)));
    memset(&unset, 0, sizeof unset);
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_constraint(region, 0, &unset));
    constraint.support = 77;
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_constraint(region, count, &constraint));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_constraint(region, SIZE_MAX, &constraint));
    EXPECT_TRUE(constraint.support == 77);
    text[0] = 'x';
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_constraint_format(region, count, text, sizeof text, NULL));
    EXPECT(CRITREG_INVALID_ARGUMENT,
           critreg_region_constraint_name(region, count, text, sizeof text, NULL));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_constraint_format(region, 0, text, 3, &needed));
    EXPECT(CRITREG_TOO_SMALL, critreg_region_constraint_name(region, 0, NULL, 0, &needed));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_constraint_format(region, 0, NULL, 9, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_constraint_name(region, 0, text, 9, ASKEW(size_t, other)));
    EXPECT_TRUE(text[0] == 'x');
}

static void constraints(void)
{
    static uint64_t learner_memory[CRITREG_LEARNER_WORDS(1024, 256)];
    critreg_learner *learner = reach_learner(learner_memory, sizeof learner_memory);
    const critreg_region *learned;
    critreg_region *loaded;
    uint8_t bytes[4096];
    char name[64];
    size_t length;

    OK(critreg_learn_region(learner, WALLS, INSTANCES, reach, NULL, &learned));
    constraints_of(learned, kind == CRITREG_VERSION_SPACE);
    OK(critreg_region_save(learned, bytes, sizeof bytes, &length));
    OK(critreg_region_load(other, sizeof other, bytes, length, &loaded));
    constraints_of(loaded, 0);
    constraints_of(parsed(), 0);
    OK(critreg_region_constraint_name(parsed(), 0, name, sizeof name, NULL));
    EXPECT_TRUE(strcmp(name, "1.5*hand.radius") == 0);
    OK(critreg_region_constraint_name(parsed(), 1, name, sizeof name, &length));
    EXPECT_TRUE(name[0] == '\0' && length == 1);
}

static void wrong_questions(void)
{
    critreg_region *region = parsed(), *plane;
    critreg_rng rng = critreg_rng_seed(1), before;
    double bad[2] = {1.0, (double)NAN}, theta = 0.5, nan = (double)NAN, ends[4] = {9, 9, 9, 9};
    double wall_at_base[2] = {0.0, 0.0};
    size_t count = 0;
    int32_t answer = 77;

    EXPECT(CRITREG_NULL_POINTER, critreg_region_instance_len(region, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_region_instance_len(region, ASKEW(size_t, other)));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_parameter_count(region, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_contains(region, NULL, &theta, &answer));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_contains(region, WALLS, NULL, &answer));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_contains(region, WALLS, &theta, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_contains(region, ASKEW(double, other), &theta, &answer));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_contains(region, WALLS, ASKEW(double, other), &answer));
    EXPECT(CRITREG_MISALIGNED,
           critreg_region_contains(region, WALLS, &theta, ASKEW(int32_t, other)));
    EXPECT(CRITREG_NOT_FINITE, critreg_region_contains(region, bad, &theta, &answer));
    EXPECT(CRITREG_NOT_FINITE, critreg_region_contains(region, WALLS, &nan, &answer));
    EXPECT(CRITREG_NOT_FINITE, critreg_region_is_empty(region, bad, &answer));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_is_empty(region, WALLS, NULL));
    EXPECT_TRUE(answer == 77);

    EXPECT(CRITREG_NULL_POINTER, critreg_region_intervals(region, WALLS, NULL, 1, &count));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_intervals(region, WALLS, ends, 1, NULL));
    EXPECT(CRITREG_NULL_POINTER, critreg_region_intervals(region, NULL, ends, 1, &count));
    EXPECT(CRITREG_NOT_FINITE, critreg_region_intervals(region, bad, ends, 1, &count));
    EXPECT_TRUE(count == 0);
    EXPECT(CRITREG_TOO_SMALL, critreg_region_intervals(region, WALLS, ends, 1, &count));
    EXPECT_TRUE(count == 2 && ends[0] == 9);
    EXPECT(CRITREG_TOO_SMALL, critreg_region_intervals(region, WALLS, NULL, 0, &count));
    OK(critreg_region_intervals(region, WALLS, ends, 2, &count));
    EXPECT_TRUE(ends[0] == 0.0 && ends[1] == 0.85 && ends[2] == 1.15 && ends[3] == 2.0);

    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region(region, NULL, &rng, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region(region, WALLS, NULL, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_region(region, WALLS, &rng, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_sample_region(region, WALLS, ASKEW(critreg_rng, other), &theta));
    EXPECT(CRITREG_NOT_FINITE, critreg_sample_region(region, bad, &rng, &theta));
    EXPECT_TRUE(theta == 0.5);
    before = rng;
    OK(critreg_sample_region(region, WALLS, &rng, &theta));
    OK(critreg_region_contains(region, WALLS, &theta, &answer));
    EXPECT_TRUE(answer == 1 && memcmp(&before, &rng, sizeof rng) != 0);

    OK(critreg_region_parse(memory, sizeof memory, DOMAIN, "reach < wall.x", &region));
    EXPECT(CRITREG_EMPTY_REGION, critreg_sample_region(region, wall_at_base, &rng, &theta));
    OK(critreg_region_is_empty(region, wall_at_base, &answer));
    EXPECT_TRUE(answer == 1);
    OK(critreg_region_intervals(region, wall_at_base, NULL, 0, &count));
    EXPECT_TRUE(count == 0);
    OK(critreg_region_parse(other, sizeof other, "parameter a in [0, 1] parameter b in [0, 1]",
                            "a < b", &plane));
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_intervals(plane, WALLS, ends, 2, &count));
}

static void generators(void)
{
    critreg_rng rng = critreg_rng_seed(0), zero = {{0, 0}}, same;
    double first, second;

    EXPECT(CRITREG_NULL_POINTER, critreg_rng_uniform(NULL, &first));
    EXPECT(CRITREG_NULL_POINTER, critreg_rng_uniform(&rng, NULL));
    EXPECT(CRITREG_MISALIGNED, critreg_rng_uniform(ASKEW(critreg_rng, other), &first));
    same = rng;
    OK(critreg_rng_uniform(&rng, &first));
    OK(critreg_rng_uniform(&zero, &second));
    EXPECT_TRUE(first == second && first >= 0.0 && first < 1.0);
    OK(critreg_rng_uniform(&same, &second));
    EXPECT_TRUE(first == second);
}

/* Several regions at once: clear of two walls, and beyond a point of a third domain. */
static void wrong_intersections(void)
{
    static uint64_t apart[CRITREG_REGION_WORDS], longer[CRITREG_REGION_WORDS];
    critreg_region *clear = parsed(), *beyond = NULL, *elsewhere = NULL;
    const critreg_region *regions[CRITREG_MAX_REGIONS + 1];
    const double *instances[CRITREG_MAX_REGIONS + 1];
    const double unclear[2] = {(double)NAN, 0.0}, start = 0.5;
    critreg_rng rng = critreg_rng_seed(3);
    double theta = 77.0;
    int32_t empty = 77;
    size_t i;

    OK(critreg_region_parse(apart, sizeof apart,
                            "object start { x: length }\nparameter far in [0, 4]: length\n",
                            "far >= start.x + 0.5", &beyond));
    OK(critreg_region_parse(longer, sizeof longer, "parameter far in [0, 5]: length\n",
                            "far >= 0.5", &elsewhere));
    for (i = 0; i <= CRITREG_MAX_REGIONS; i++) {
        regions[i] = clear;
        instances[i] = WALLS + 2 * (i % 2);
    }
    regions[2] = beyond;
    instances[2] = &start;
    for (i = 0; i < 200; i++) {
        /* Clear of the walls at 1 and 1.5, beyond 1, and at most 2. */
        OK(critreg_sample_regions(regions, instances, 3, &rng, &theta));
        EXPECT_TRUE((theta >= 1.15 && theta <= 1.35) || (theta >= 1.65 && theta <= 2.0));
    }
    OK(critreg_regions_are_empty(regions, instances, CRITREG_MAX_REGIONS, &empty));
    EXPECT_TRUE(empty == 0);
    theta = 77.0;
    instances[2] = WALLS + 4;   /* beyond 3 */
    EXPECT(CRITREG_EMPTY_REGION, critreg_sample_regions(regions, instances, 3, &rng, &theta));
    OK(critreg_regions_are_empty(regions, instances, 3, &empty));
    EXPECT_TRUE(empty == 1);

    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_sample_regions(regions, instances, 0, &rng, &theta));
    EXPECT(CRITREG_CAPACITY_EXCEEDED, critreg_sample_regions(regions, instances,
                                                             CRITREG_MAX_REGIONS + 1, &rng, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_regions(NULL, instances, 3, &rng, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_regions(regions, NULL, 3, &rng, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_regions(regions, instances, 3, NULL, &theta));
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_regions(regions, instances, 3, &rng, NULL));
    EXPECT(CRITREG_MISALIGNED,
           critreg_sample_regions(regions, instances, 3, &rng, ASKEW(double, &theta)));
    EXPECT(CRITREG_NULL_POINTER, critreg_regions_are_empty(regions, instances, 3, NULL));
    instances[2] = NULL;
    EXPECT(CRITREG_NULL_POINTER, critreg_sample_regions(regions, instances, 3, &rng, &theta));
    instances[1] = unclear;
    EXPECT(CRITREG_NOT_FINITE, critreg_sample_regions(regions, instances, 2, &rng, &theta));
    instances[1] = WALLS;
    regions[1] = elsewhere;
    EXPECT(CRITREG_MISMATCH, critreg_sample_regions(regions, instances, 2, &rng, &theta));
    EXPECT_TRUE(theta == 77.0);
}

/* A region over the state: an action without parameters. */
static void no_parameters(void)
{
    static const char state[] = "object wall { x: length, y: length }\n";
    critreg_region *region = NULL;
    critreg_rng rng = critreg_rng_seed(3);
    double theta = 77.0;
    size_t count = 77, i;
    int32_t inside, empty;

    OK(critreg_region_parse(memory, sizeof memory, state, "wall.x <= 1.5", &region));
    OK(critreg_region_parameter_count(region, &count));
    EXPECT_TRUE(count == 0);
    for (i = 0; i < INSTANCES; i++) {
        const double *instance = WALLS + 2 * i;
        critreg_status expected = i < 2 ? CRITREG_OK : CRITREG_EMPTY_REGION;
        const critreg_region *one = region;
        OK(critreg_region_contains(region, instance, NULL, &inside));
        OK(critreg_region_is_empty(region, instance, &empty));
        EXPECT_TRUE(inside == (i < 2) && empty == !inside);
        EXPECT(expected, critreg_sample_region(region, instance, &rng, NULL));
        EXPECT(expected, critreg_sample_region(region, instance, &rng, &theta));
        EXPECT(expected, critreg_sample_regions(&one, &instance, 1, &rng, NULL));
    }
    EXPECT(CRITREG_INVALID_ARGUMENT, critreg_region_intervals(region, WALLS, NULL, 0, &count));
    EXPECT_TRUE(theta == 77.0);
}

static void words_for_every_status(void)
{
    critreg_status status;
    EXPECT_TRUE(critreg_abi_version() == CRITREG_ABI_VERSION);
    for (status = -2; status < 20; status++) {
        int known = status >= CRITREG_OK && status <= CRITREG_NO_PLAN;
        EXPECT_TRUE((strcmp(critreg_strerror(status), "unknown status") != 0) == known);
        EXPECT_TRUE((strcmp(critreg_status_name(status), "unknown") != 0) == known);
    }
    EXPECT_TRUE(strcmp(critreg_status_name(CRITREG_NOT_A_HANDLE), "CRITREG_NOT_A_HANDLE") == 0);
    EXPECT_TRUE(strcmp(critreg_status_name(CRITREG_BUSY), "CRITREG_BUSY") == 0);
    EXPECT_TRUE(strcmp(critreg_status_name(INT32_MAX), "CRITREG_USER_STATUS") == 0);
    EXPECT_TRUE(strlen(critreg_strerror(INT32_MIN)) > 0);
}

int main(void)
{
    with_each_learner(wrong_handles);
    with_each_learner(constraints);
    wrong_makers();
    text_and_bytes();
    wrong_questions();
    generators();
    wrong_intersections();
    no_parameters();
    words_for_every_status();
    return summary();
}
