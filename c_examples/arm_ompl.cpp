// Motion planning with OMPL to a learned goal: a planar arm of two links and a hand grasps
// a stick that a holder stands on.
//
// Where on the stick a grasp can work is learned from a few sticks. RRT-Connect then plans
// to other sticks, with goals drawn from the learned region and, for comparison, from all
// of the stick. Only the hand is at the height of the things on the table.
//
// Needs OMPL (Debian: libompl-dev); `make ompl` builds and runs it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include "critreg.hpp"
#include "critreg_ompl.hpp"

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double PI = 3.14159265358979323846;
constexpr double UPPER = 1.0, FORE = 0.8, HAND = 0.3;   // lengths
constexpr double HAND_RADIUS = 0.05, HOLDER_RADIUS = 0.15, STICK = 1.2;
constexpr int LEARNED_FROM = 6, TASKS = 50, CALLS = 100;

// The hand stands at right angles on the stick; the wrist is at its other end.
static const char DOMAIN_TEXT[] =
    "object stick  { x: length, y: length, theta: angle }\n"
    "object holder { x: length, y: length }\n"
    "constant upper.length = 1.0: length\n"
    "constant fore.length = 0.8: length\n"
    "constant hand.length = 0.3: length\n"
    "constant hand.radius = 0.05: length\n"
    "constant holder.radius = 0.15: length\n"
    "constant stick.width = 1.2: length\n"
    "parameter mu in [0, 1]\n"
    "point base  = world\n"
    "point grasp = stick + (mu * stick.width, 0)\n"
    "point wrist = stick + (mu * stick.width, -hand.length)\n";

struct Place {
    double x, y;
};

static double distance(Place a, Place b) { return std::hypot(a.x - b.x, a.y - b.y); }

static double wrapped(double angle) { return std::remainder(angle, 2 * PI); }

// A stick with its holder; an instance of the domain.
struct Task {
    double x, y, theta;
    Place holder;

    explicit Task(critreg::Rng &rng) {
        x = 1.5 * rng.uniform() - 1.0;
        y = 0.7 + 1.6 * rng.uniform();
        theta = PI * (rng.uniform() - 0.5);
        holder = on_stick(rng.uniform());
    }

    Task(const double *instance)
        : x(instance[0]), y(instance[1]), theta(instance[2]), holder{instance[3], instance[4]} {}

    std::vector<double> instance() const { return {x, y, theta, holder.x, holder.y}; }

    Place on_stick(double mu) const {
        return {x + mu * STICK * std::cos(theta), y + mu * STICK * std::sin(theta)};
    }

    // The joints with which the hand grasps the stick; false if that is too far or too near.
    bool reach(double mu, double *joints) const {
        const Place grasp = on_stick(mu);
        const double heading = theta + PI / 2;      // of the hand
        const Place wrist = {grasp.x - HAND * std::cos(heading), grasp.y - HAND * std::sin(heading)};
        const double far = std::hypot(wrist.x, wrist.y);
        const double cosine = (far * far - UPPER * UPPER - FORE * FORE) / (2 * UPPER * FORE);
        if (!(std::fabs(cosine) <= 1)) return false;
        joints[1] = std::acos(cosine);
        joints[0] = wrapped(std::atan2(wrist.y, wrist.x)
                            - std::atan2(FORE * std::sin(joints[1]), UPPER + FORE * cosine));
        joints[2] = wrapped(heading - joints[0] - joints[1]);
        return true;
    }

    // Whether the hand keeps clear of the holder.
    bool is_free(const double *joints) const {
        const double fore = joints[0] + joints[1], hand = fore + joints[2];
        const Place wrist = {UPPER * std::cos(joints[0]) + FORE * std::cos(fore),
                             UPPER * std::sin(joints[0]) + FORE * std::sin(fore)};
        const Place along = {std::cos(hand), std::sin(hand)};
        const double foot = (holder.x - wrist.x) * along.x + (holder.y - wrist.y) * along.y;
        const double nearest = std::min(std::max(foot, 0.0), HAND);
        const Place point = {wrist.x + nearest * along.x, wrist.y + nearest * along.y};
        return distance(point, holder) >= HAND_RADIUS + HOLDER_RADIUS;
    }

    // Where on the stick the hand grasps with these joints; false if it does not.
    bool grasped_at(const double *joints, double *mu) const {
        const double fore = joints[0] + joints[1], hand = fore + joints[2];
        const Place tip = {
            UPPER * std::cos(joints[0]) + FORE * std::cos(fore) + HAND * std::cos(hand),
            UPPER * std::sin(joints[0]) + FORE * std::sin(fore) + HAND * std::sin(hand)};
        *mu = ((tip.x - x) * std::cos(theta) + (tip.y - y) * std::sin(theta)) / STICK;
        return distance(tip, on_stick(*mu)) < 1e-9
            && std::fabs(wrapped(hand - theta - PI / 2)) < 1e-9;
    }
};

static const double *joints_of(const ob::State *state) {
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

static critreg::Region learned() {
    critreg::Rng rng(1);
    std::vector<double> instances;
    for (int i = 0; i < LEARNED_FROM; i++)
        for (double number : Task(rng).instance()) instances.push_back(number);
    critreg_config config = critreg::Learner::default_config();
    config.calls = CALLS;
    critreg::Learner learner(DOMAIN_TEXT, config);
    return learner.learn(instances, [](const double *instance, const double *mu) {
        const Task task(instance);
        double joints[3];
        return task.reach(*mu, joints) && task.is_free(joints);
    });
}

// Why a region admits nothing in an instance.
static std::string why_not(const critreg::Region &region, const std::vector<double> &instance) {
    for (const critreg::Constraint &constraint : region.constraints()) {
        const auto alone = critreg::Region::parse(DOMAIN_TEXT, constraint.text);
        if (alone.intervals(instance).empty()) return "nowhere here: " + constraint.text;
    }
    return "no place satisfies all of: " + region.text();
}

struct Counts {
    int solved = 0, tried = 0;      // tasks, and goals that were drawn for them
};

// Plans one task with goals of a region.
static void plan(const Task &task, const critreg_region *region, Counts &counts) {
    auto space = std::make_shared<ob::RealVectorStateSpace>(3);
    space->setBounds(-PI, PI);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [&](const ob::State *state) { return task.is_free(joints_of(state)); });
    ob::ScopedState<ob::RealVectorStateSpace> start(space);
    start[0] = -PI / 2, start[1] = start[2] = 0;
    setup.setStartState(start);
    const auto goal = std::make_shared<critreg::RegionGoal>(
        setup.getSpaceInformation(), region, task.instance(),
        [&](const double *mu, ob::State *state) {
            counts.tried++;
            return task.reach(*mu, state->as<ob::RealVectorStateSpace::StateType>()->values);
        },
        [&](const ob::State *state, double *mu) {
            return task.grasped_at(joints_of(state), mu);
        });
    setup.setGoal(goal);
    setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
    if (!goal->canSample() || setup.solve(1.0) != ob::PlannerStatus::EXACT_SOLUTION) return;
    // The hand ends on the stick, on a way that is free.
    double mu;
    const og::PathGeometric &path = setup.getSolutionPath();
    const double *last = joints_of(path.getState(path.getStateCount() - 1));
    counts.solved += path.check() && task.grasped_at(last, &mu);
}

int main() {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(1);
    const critreg::Region region = learned();
    const critreg::Region anywhere = critreg::Region::parse(DOMAIN_TEXT, "true");
    std::printf("learned: %s\n", region.text().c_str());

    critreg::Rng rng(2);
    Counts by_rejection, by_region;
    int possible = 0;
    for (int drawn = 0; drawn < TASKS; drawn++) {
        const Task task(rng);
        bool works = false;
        double joints[3];
        for (int i = 0; i <= 1000 && !works; i++)
            works = task.reach(i / 1000.0, joints) && task.is_free(joints);
        possible += works;
        if (region.intervals(task.instance()).empty())
            std::printf("task %d: %s\n", drawn, why_not(region, task.instance()).c_str());
        plan(task, region.handle(), by_region);
        if (works) plan(task, anywhere.handle(), by_rejection);
    }
    std::printf("tasks in which a grasp works: %d of %d\n", possible, TASKS);
    std::printf("goals drawn from all of the stick: solved %d, goals tried per task %.2f\n",
                by_rejection.solved, by_rejection.tried / static_cast<double>(possible));
    std::printf("goals drawn from the region: solved %d, goals tried per task %.2f\n",
                by_region.solved, by_region.tried / static_cast<double>(possible));
    return by_region.solved == possible && 2 * by_region.tried < by_rejection.tried ? 0 : 1;
}
