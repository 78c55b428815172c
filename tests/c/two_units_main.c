/* The header in two translation units that are linked together. */
#include <stdio.h>

#include "critreg.h"
#include "critreg.h"

/* From two_units_other.c, which includes the header too. */
uint32_t other_abi_version(void);
size_t other_words(void);

static uint64_t memory[CRITREG_LEARNER_WORDS(4096, 256)];

int main(void)
{
    critreg_learner *learner;
    critreg_status status;

    if (critreg_abi_version() != CRITREG_ABI_VERSION
        || other_abi_version() != CRITREG_ABI_VERSION || other_words() != sizeof memory / 8) {
        fprintf(stderr, "header and library are not of one version\n");
        return 1;
    }
    status = critreg_learner_init(memory, sizeof memory, critreg_stick_button_domain(), NULL,
                                  &learner);
    puts(critreg_strerror(status));
    return status;
}
