/* A plug-in: a shared object with the static library inside. */
#include "critreg.h"

critreg_status plug_in_learn(critreg_learner *learner, const double *instances, size_t count,
                             critreg_simulate simulate);

critreg_status plug_in_learn(critreg_learner *learner, const double *instances, size_t count,
                             critreg_simulate simulate)
{
    return critreg_learn_region(learner, instances, count, simulate, NULL, NULL);
}
