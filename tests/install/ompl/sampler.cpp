#include <ompl/base/spaces/RealVectorStateSpace.h>
#include "critreg.hpp"
#include "critreg_ompl.hpp"

int main() {
    const auto region = critreg::Region::parse(
        "object table { width: length }\n"
        "parameter p in [0, 1]: length\npoint place = world + (p, 0)",
        "place.x <= table.width");
    const auto space = std::make_shared<ompl::base::RealVectorStateSpace>(1);
    space->setBounds(0, 1);
    space->setStateSamplerAllocator(critreg::region_sampler(region.handle(), {0.25}));
    space->setup();
    ompl::base::ScopedState<ompl::base::RealVectorStateSpace> state(space);
    int inside = 0;
    for (int i = 0; i < 1000; i++, state.random()) inside += state[0] <= 0.25;
    return inside > 850 && inside < 1000 ? 0 : 1;   // a tenth comes from all of the space
}
