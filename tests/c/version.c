/* The library tells which version it is, and what it was built with. */
#include "expect.h"

static uint64_t memory[CRITREG_LEARNER_WORDS(4096, 2048)];

static int can(uint32_t capability)
{
    return (critreg_capabilities() & capability) != 0;
}

/* The versions of the header and of the library, which was built with it. */
static void versions(void)
{
    char header[32];
    snprintf(header, sizeof header, "%d.%d.%d", CRITREG_VERSION_MAJOR, CRITREG_VERSION_MINOR,
             CRITREG_VERSION_PATCH);
    EXPECT_TRUE(strcmp(critreg_version(), header) == 0);
    EXPECT_TRUE(critreg_abi_version() == CRITREG_ABI_VERSION);
}

/* Whether a learner can be made that needs a capability. */
static int makes(uint32_t learner, uint32_t precision, uint32_t observations)
{
    critreg_config config;
    critreg_learner *made;
    OK(critreg_config_init(&config, sizeof config));
    config.learner = learner;
    config.precision = precision;
    config.observations = observations;
    return critreg_learner_init(memory, sizeof memory, DOMAIN, &config, &made) == CRITREG_OK;
}

static int knows_bodies(void)
{
    static const char bodies[] =
        "object can { x: length, y: length }\n"
        "object box { x: length, y: length }\n"
        "constant size = 0.1: length\n"
        "shape can = rectangle(size, size) centred\n"
        "shape box = rectangle(size, size) centred\n"
        "parameter p in [0, 1]\n";
    return critreg_check_region(bodies, "clear(can, box) >= p*size", NULL, 0, NULL) == CRITREG_OK;
}

static void capabilities(void)
{
    EXPECT_TRUE(can(CRITREG_HAS_F64) == makes(CRITREG_VERSION_SPACE, CRITREG_F64, 64));
    EXPECT_TRUE(can(CRITREG_HAS_F32) == makes(CRITREG_VERSION_SPACE, CRITREG_F32, 64));
    EXPECT_TRUE(can(CRITREG_HAS_ALGORITHM1) == makes(CRITREG_ALGORITHM1, CRITREG_F64, 64));
    EXPECT_TRUE(can(CRITREG_HAS_MANY_OBSERVATIONS)
                == makes(CRITREG_VERSION_SPACE, CRITREG_F64, 2048));
    EXPECT_TRUE(can(CRITREG_HAS_BODIES) == knows_bodies());
    /* What is built unless someone chooses otherwise. */
    EXPECT_TRUE(critreg_capabilities()
                == (CRITREG_HAS_F64 | CRITREG_HAS_F32 | CRITREG_HAS_ALGORITHM1
                    | CRITREG_HAS_MANY_OBSERVATIONS | CRITREG_HAS_BODIES
                    | CRITREG_HAS_LEARNER | CRITREG_HAS_PLANNER));
}

int main(void)
{
    versions();
    capabilities();
    return summary();
}
