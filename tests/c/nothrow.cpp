// critreg.hpp in a program without exceptions: what can fail says so in what it returns.
#include "expect.h"

#include <vector>

#include "critreg.hpp"

#if CRITREG_EXCEPTIONS
#error "to be compiled without exceptions"
#endif

using namespace critreg::nothrow;
using critreg::Status;

static const std::vector<double> walls(WALLS, WALLS + 2 * INSTANCES);

static bool works(const double *instance, const double *theta) {
    return theta[0] <= instance[0] - 0.1;
}

static void learning() {
    auto learner = Learner::make(DOMAIN);
    EXPECT_TRUE(learner && learner.status() == Status::ok && learner.message().empty());
    EXPECT_TRUE(learner->tell(walls, true).status() == Status::out_of_sequence);
    const auto region = learner->learn(walls, works);
    EXPECT_TRUE(region && region->quality() == CRITREG_EXACT);
    critreg::Rng rng(7);
    const auto sample = region->sample({1.0, 0.0}, rng);
    EXPECT_TRUE(sample && *sample && works(WALLS, (*sample)->data()));
    const auto none = region->sample({-1.0, 0.0}, rng);
    EXPECT_TRUE(none && !*none && none->status() == Status::empty_region);
    const auto wrong = region->contains({1.0}, {0.5});
    EXPECT_TRUE(!wrong && wrong.status() == Status::invalid_argument);
    EXPECT_TRUE(wrong.message() == "the instance has 1 numbers, where 2 are wanted");
    const auto both = critreg::nothrow::sample({{*region, {1.0, 0.0}}, {*region, {2.0, 0.0}}}, rng);
    EXPECT_TRUE(both && (*both)->at(0) <= 0.91);
}

static void nothing_learned() {
    critreg_config config = Learner::default_config();
    config.calls = 20;
    auto learner = Learner::make(DOMAIN, config);
    const auto fails = [](const double *, const double *) { return false; };
    EXPECT_TRUE(learner->learn(walls, fails).status() == Status::no_region);
    EXPECT_TRUE(learner->region().status() == Status::no_region);
    EXPECT_TRUE(learner->why()->code == CRITREG_WHY_NONE_WORKED);
}

static void wrong_texts() {
    const auto learner = Learner::make("object a { x: length }\nshape a = potato(1)\n");
    EXPECT_TRUE(learner.status() == Status::syntax_error);
    EXPECT_TRUE(learner.message().find("line 2, column") == 0);
    EXPECT_TRUE(Region::parse(DOMAIN, "hand.w <= 1").status() == Status::syntax_error);
    EXPECT_TRUE(Region::load({}).status() == Status::corrupt);
    EXPECT_TRUE(Planner::make("(", "(", Planner::default_config()).status() ==
                Status::syntax_error);
}

int main() {
    learning();
    nothing_learned();
    wrong_texts();
    return summary();
}
