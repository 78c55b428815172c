/* A program with another library in Rust, which has a heap, prints and can panic. */
#include "expect.h"

uint32_t other_sum(uint32_t count);

static uint64_t memory[CRITREG_LEARNER_WORDS(1024, 256)];

int main(void)
{
    expect_usable(reach_learner(memory, sizeof memory));
    EXPECT_TRUE(other_sum(10) == 45);
    return summary();
}
