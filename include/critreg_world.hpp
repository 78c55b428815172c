/**
 * @file critreg_world.hpp
 * What planning and learning skills ask a C++17 program; see critreg.hpp.
 */
#ifndef CRITREG_WORLD_HPP
#define CRITREG_WORLD_HPP

#include <algorithm>
#include <functional>

#include "critreg_support.hpp"

namespace critreg {

/** A ground atom or operator: its name, and its objects. */
struct Ground {
    std::string name;
    std::vector<std::string> objects;

    Ground(const critreg_ground &ground)
        : name(ground.name),
          objects(ground.object_names, ground.object_names + ground.object_count) {}

    /** As in PDDL: "(Walk a b)". */
    [[nodiscard]] std::string text() const {
        std::string text = "(" + name;
        for (const std::string &object : objects) text += " " + object;
        return text + ")";
    }
};

/** What planning and learning ask the program. What they throw ends the call and is thrown on. */
struct World {
    /** Runs an operator, changes the state, returns how many actions it took; 0 if it failed. */
    std::function<std::uint32_t(const Ground &, const double *parameters,
                                std::vector<double> &state)>
        execute;
    /** Whether an atom holds in a state. */
    std::function<bool(const Ground &, const std::vector<double> &state)> holds;
    /** As critreg_sample, but for its user_data; may be empty. The status of a Sample may be
     *  passed on. */
    std::function<Status(const critreg_draw &, Rng &, critreg_drawn &)> sample = {};
    /** As critreg_advise, but for its user_data; may be empty. */
    std::function<critreg_advice(const critreg_ground *prefix, std::size_t length,
                                 const std::vector<double> &initial, std::uint32_t &reason)>
        advise = {};
};

namespace detail {

/** A call under way, what a callback threw, and what is wrong with its answer. */
struct WorldCall {
    const World &world;
    detail::Caught caught;
    Failure wrong;
};

/** Runs a callback with the call that it belongs to. */
template <class Body> critreg_status run(void *user_data, Body body) {
    WorldCall &call = *static_cast<WorldCall *>(user_data);
    return call.caught.run([&] { return body(call); });
}

inline critreg_status execute(void *user_data, const critreg_ground *ground,
                              const double *parameters, const double *before, double *after,
                              std::size_t len, std::uint32_t *actions) {
    return run(user_data, [=](WorldCall &call) -> critreg_status {
        std::vector<double> state(before, before + len);
        *actions = call.world.execute(*ground, parameters, state);
        call.wrong = detail::fits(state.size(), len, "the state after execute");
        if (call.wrong) return code(call.wrong.status);
        std::copy(state.begin(), state.end(), after);
        return CRITREG_OK;
    });
}

inline critreg_status holds(void *user_data, const critreg_ground *ground, const double *state,
                            std::size_t len, std::int32_t *holds) {
    return run(user_data, [=](WorldCall &call) -> critreg_status {
        *holds = call.world.holds(*ground, std::vector<double>(state, state + len));
        return CRITREG_OK;
    });
}

inline critreg_status sample(void *user_data, const critreg_draw *draw, critreg_rng *rng,
                             critreg_drawn *drawn) {
    return run(user_data, [=](WorldCall &call) {
        Rng own(*rng);
        const Status status = call.world.sample(*draw, own, *drawn);
        *rng = own.state;
        return code(status);
    });
}

inline critreg_status advise(void *user_data, const critreg_ground *prefix, std::size_t length,
                             const double *initial, std::size_t len, critreg_advice *advice,
                             std::uint32_t *reason) {
    return run(user_data, [=](WorldCall &call) -> critreg_status {
        const std::vector<double> state(initial, initial + len);
        *advice = call.world.advise(prefix, length, state, *reason);
        return CRITREG_OK;
    });
}

inline void set_callbacks(critreg_callbacks &callbacks, const World &world) {
    if (world.execute) callbacks.execute = execute;
    if (world.holds) callbacks.holds = holds;
    if (world.sample) callbacks.sample = sample;
    if (world.advise) callbacks.advise = advise;
}

} // namespace detail
} // namespace critreg

#endif
