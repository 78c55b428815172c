// Simulators that return a bool, an outcome or an int teach what works, and not the
// complement.
#include "expect.h"

#include <vector>

#include "critreg.hpp"

static const std::vector<double> walls(WALLS, WALLS + 2 * INSTANCES);

static bool works(const double *instance, const double *theta) {
    return theta[0] <= instance[0] - 0.1;
}

static critreg_outcome outcome(const double *instance, const double *theta) {
    return works(instance, theta) ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
}

static critreg::Learner new_learner() {
    critreg_config config = critreg::Learner::default_config();
    config.calls = 60;
    return critreg::Learner(DOMAIN, config);
}

static void check(const critreg::Region &region) {
    int wrong = 0;
    for (int w = 0; w < INSTANCES; w++)
        for (int i = 0; i <= 400; i++) {
            const std::vector<double> wall = {WALLS[2 * w], 0.0}, theta = {0.01 * i};
            wrong += region.contains(wall, theta) != works(wall.data(), theta.data());
        }
    EXPECT_TRUE(wrong < 8);     // of 1604
}

// Asks and tells with bools.
static critreg::Region asked_and_told() {
    critreg::Learner learner = new_learner();
    while (!learner.is_finished()) {
        const critreg::Query query = learner.ask(walls);
        learner.tell(walls, works(&walls[2 * query.instance], query.theta.data()));
    }
    return learner.region();
}

// One of several steps failed, or nobody knows.
static void other_outcomes() {
    critreg_config config = critreg::Learner::default_config();
    config.steps = 2;
    critreg::Learner learner(DOMAIN, config);
    int calls = 0;
    const critreg::Region region =
        learner.learn(walls, [&](const double *instance, const double *theta) -> critreg_outcome {
            if (++calls % 10 == 0) return CRITREG_UNKNOWN;
            return works(instance, theta) ? CRITREG_FEASIBLE : CRITREG_FAILED_STEP(2);
        });
    check(region);
    EXPECT_TRUE(learner.report().unknown == static_cast<std::uint64_t>(calls / 10));
}

int main() {
    check(new_learner().learn(walls, works));
    check(new_learner().learn(walls, outcome));
    check(new_learner().learn(walls, [](const double *instance, const double *theta) {
        return works(instance, theta);
    }));
    check(new_learner().learn(walls, [](const double *instance, const double *theta) {
        return works(instance, theta) ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
    }));
    check(asked_and_told());
    other_outcomes();
    return summary();
}
