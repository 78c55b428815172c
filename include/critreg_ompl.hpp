/**
 * @file critreg_ompl.hpp
 * Regions for planners of OMPL, the Open Motion Planning Library, 1.5 or newer; C++14.
 *
 * A critreg::RegionGoal is a goal from which tree planners draw: every state in which the
 * parameters of an action, such as where to grasp, lie in a region. What
 * critreg::region_sampler() makes draws the states on the way, where the state space is
 * that of the parameters. Both take a region (handle() of a critreg::Region) and the
 * instance to ground it in.
 *
 *     auto goal = std::make_shared<critreg::RegionGoal>(si, region.handle(), instance,
 *         [&](const double *theta, ompl::base::State *state) { return reach(theta, state); },
 *         [&](const ompl::base::State *state, double *theta) { grasped_at(state, theta); });
 *     problem->setGoal(goal);
 *
 * The region must live as long as what is made of it; the instance is copied.
 */
#ifndef CRITREG_OMPL_HPP
#define CRITREG_OMPL_HPP

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/Exception.h>

#include "critreg.h"

namespace critreg {

/** A region in an instance, and random numbers to draw from it. */
class GroundedRegion {
public:
    GroundedRegion(const critreg_region *region, std::vector<double> instance,
                   std::uint64_t seed)
        : region_(region), instance_(std::move(instance)), rng_(critreg_rng_seed(seed)) {
        std::size_t len = 0, count = 0;
        check(critreg_region_instance_len(region, &len));
        check(critreg_region_parameter_count(region, &count));
        if (len != instance_.size())
            throw ompl::Exception("critreg", "the instance has " + std::to_string(instance_.size())
                                                 + " numbers, and the region speaks of "
                                                 + std::to_string(len));
        theta_.resize(count);
    }

    /** How many parameters the action has. */
    std::size_t parameter_count() const { return theta_.size(); }

    /** Whether it is proven that no parameters are in the region. */
    bool is_empty() const {
        std::int32_t empty = 0;
        check(critreg_region_is_empty(region_, instance_.data(), &empty));
        return empty != 0;
    }

    bool contains(const std::vector<double> &theta) const {
        std::int32_t inside = 0;
        check(critreg_region_contains(region_, instance_.data(), theta.data(), &inside));
        return inside != 0;
    }

    /** Parameters from the region, valid until the next draw; NULL if none were found. */
    const std::vector<double> *draw() {
        const critreg_status status =
            critreg_sample_region(region_, instance_.data(), &rng_, theta_.data());
        if (status == CRITREG_EMPTY_REGION || status == CRITREG_NO_SAMPLE) return nullptr;
        check(status);
        return &theta_;
    }

private:
    static void check(critreg_status status) {
        if (status != CRITREG_OK) throw ompl::Exception("critreg", critreg_strerror(status));
    }

    const critreg_region *region_;
    std::vector<double> instance_, theta_;
    critreg_rng rng_;
};

/** A goal: the states in which an action has parameters that lie in a region. */
class RegionGoal : public ompl::base::GoalSampleableRegion {
public:
    /** Makes a state in which the action has these parameters (inverse kinematics); false
     *  if there is none. */
    using ToState = std::function<bool(const double *theta, ompl::base::State *state)>;
    /** The parameters that the action has in a state (forward kinematics); false if it has
     *  none there. */
    using ToParameters = std::function<bool(const ompl::base::State *state, double *theta)>;

    RegionGoal(const ompl::base::SpaceInformationPtr &si, const critreg_region *region,
               std::vector<double> instance, ToState to_state, ToParameters to_parameters,
               std::uint64_t seed = 1)
        : GoalSampleableRegion(si), region_(region, std::move(instance), seed),
          to_state_(std::move(to_state)), to_parameters_(std::move(to_parameters)) {}

    ~RegionGoal() override {
        for (ompl::base::State *state : drawn_) si_->freeState(state);
    }

    /** A state of the goal. If none is found it is out of bounds, so that planners drop it. */
    void sampleGoal(ompl::base::State *state) const override {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (int tries = 0; tries < TRIES; tries++) {
            const std::vector<double> *theta = region_.draw();
            if (theta == nullptr) break;
            if (!to_state_(theta->data(), state)) continue;
            if (drawn_.size() < KEPT) drawn_.push_back(si_->cloneState(state));
            return;
        }
        const auto &space = si_->getStateSpace();
        space->copyFromReals(state,
                             std::vector<double>(space->getValueLocations().size(),
                                                 std::numeric_limits<double>::infinity()));
    }

    /** 0 where it is proven that the region is empty. */
    unsigned int maxSampleCount() const override {
        return region_.is_empty() ? 0 : std::numeric_limits<unsigned int>::max();
    }

    /** 0 in the goal; outside, how far the nearest state is that was drawn from it. */
    double distanceGoal(const ompl::base::State *state) const override {
        std::vector<double> theta(region_.parameter_count());
        if (to_parameters_(state, theta.data()) && region_.contains(theta)) return 0.0;
        const std::lock_guard<std::mutex> lock(mutex_);
        double nearest = std::numeric_limits<double>::infinity();
        for (const ompl::base::State *goal : drawn_)
            nearest = std::min(nearest, si_->distance(state, goal));
        // One that was drawn is in the goal but for rounding on the way back.
        return nearest;
    }

private:
    static constexpr int TRIES = 100;           /* draws that cannot be reached, in a row */
    static constexpr std::size_t KEPT = 100;    /* states to measure distances to */

    mutable GroundedRegion region_;
    ToState to_state_;
    ToParameters to_parameters_;
    mutable std::mutex mutex_;
    mutable std::vector<ompl::base::State *> drawn_;
};

/** Draws states from a region; what is near a state is drawn as the space does it. */
class RegionSampler : public ompl::base::StateSampler {
public:
    RegionSampler(const ompl::base::StateSpace *space, GroundedRegion region, double share)
        : StateSampler(space), region_(std::move(region)), share_(share),
          uniform_(space->allocDefaultStateSampler()) {
        const std::size_t values = space->getValueLocations().size();
        if (values != region_.parameter_count())
            throw ompl::Exception("critreg", "a state has " + std::to_string(values)
                                                 + " values (none before setup()), and the action "
                                                 + std::to_string(region_.parameter_count())
                                                 + " parameters");
    }

    void sampleUniform(ompl::base::State *state) override {
        const std::vector<double> *theta =
            rng_.uniform01() < share_ ? region_.draw() : nullptr;
        if (theta == nullptr)
            uniform_->sampleUniform(state);
        else
            space_->copyFromReals(state, *theta);
    }

    void sampleUniformNear(ompl::base::State *state, const ompl::base::State *near,
                           double distance) override {
        uniform_->sampleUniformNear(state, near, distance);
    }

    void sampleGaussian(ompl::base::State *state, const ompl::base::State *mean,
                        double deviation) override {
        uniform_->sampleGaussian(state, mean, deviation);
    }

private:
    GroundedRegion region_;
    double share_;
    ompl::base::StateSamplerPtr uniform_;
};

/**
 * For StateSpace::setStateSamplerAllocator(), where the values of a state are the
 * parameters of the action. A share of the states is drawn from the region, and the rest
 * from all of the space, so that a planner stays complete where a learned region is wrong.
 */
inline ompl::base::StateSamplerAllocator region_sampler(const critreg_region *region,
                                                        std::vector<double> instance,
                                                        double share = 0.9,
                                                        std::uint64_t seed = 1) {
    // A planner may ask for several samplers, which should not draw the same.
    auto next = std::make_shared<std::uint64_t>(seed);
    return [=](const ompl::base::StateSpace *space) -> ompl::base::StateSamplerPtr {
        return std::make_shared<RegionSampler>(space, GroundedRegion(region, instance, (*next)++),
                                               share);
    };
}

} // namespace critreg

#endif
