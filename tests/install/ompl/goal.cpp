// What a goal of OMPL promises that is made of a region.
#include <cstdio>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include "critreg.hpp"
#include "critreg_ompl.hpp"

namespace ob = ompl::base;
using Real = ob::RealVectorStateSpace;

static int failures;

static void expect(bool holds, const char *what) {
    if (!holds) std::fprintf(stderr, "not so: %s\n", what), failures++;
}

int main() {
    const auto region = critreg::Region::parse(
        "object table { width: length }\n"
        "parameter p in [0, 1]: length\npoint place = world + (p, 0)",
        "place.x <= table.width");
    const auto space = std::make_shared<Real>(1);
    space->setBounds(0, 2);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    // The state is twice the parameter, where there is one.
    const auto goal = [&](double width, bool reachable) {
        return critreg::RegionGoal(
            si, region.handle(), {width},
            [=](const double *theta, ob::State *state) {
                state->as<Real::StateType>()->values[0] = 2 * theta[0];
                return reachable;
            },
            [](const ob::State *state, double *theta) {
                theta[0] = state->as<Real::StateType>()->values[0] / 2;
                return true;
            });
    };
    ob::ScopedState<Real> state(space);

    const auto possible = goal(0.25, true);
    state[0] = 1.0;
    expect(!possible.isSatisfied(state.get()), "far away is outside");
    for (int i = 0; i < 1000; i++) {
        possible.sampleGoal(state.get());
        expect(possible.isSatisfied(state.get()) && state[0] <= 0.5, "what is drawn is a goal");
    }
    state[0] = 1.0;
    const double far = possible.distanceGoal(state.get());
    expect(far >= 0.5 && far < 0.6, "the distance is that to the nearest goal");

    const auto unreachable = goal(0.25, false);
    unreachable.sampleGoal(state.get());
    expect(unreachable.canSample(), "it may be reached later");
    expect(!si->satisfiesBounds(state.get()), "nothing is drawn that cannot be reached");

    expect(!goal(-1.0, true).canSample(), "an empty region has no goals");
    try {
        critreg::region_sampler(region.handle(), {0.25, 0.5})(space.get());
        expect(false, "an instance has as many numbers as the region speaks of");
    } catch (const ompl::Exception &) {
    }
    return failures != 0;
}
