#include "critreg.h"

uint32_t other_abi_version(void);
size_t other_words(void);

uint32_t other_abi_version(void)
{
    return critreg_abi_version();
}

size_t other_words(void)
{
    return CRITREG_LEARNER_WORDS(4096, 256);
}
