/**
 * @file critreg_stick_button.hpp
 * The built-in environment for C++17; see critreg.hpp. As callbacks of critreg.h there are
 * critreg_stick_button_pick() and its like.
 */
#ifndef CRITREG_STICK_BUTTON_HPP
#define CRITREG_STICK_BUTTON_HPP

#include "critreg_support.hpp"

namespace critreg {

/** The stick-button environment. Options are 0 or CRITREG_STICK_BUTTON_ANGLES. */
template <class Errors> struct BasicStickButton {
    template <class T> using Returned = typename Errors::template Returned<T>;

    /** The domain text of picking the stick with one button on the table. */
    [[nodiscard]] static const char *domain() noexcept { return critreg_stick_button_domain(); }

    /** How many numbers a state has. */
    [[nodiscard]] static std::size_t state_len(std::uint32_t buttons) noexcept {
        return critreg_stick_button_state_len(buttons);
    }

    /** The initial state of a random task. */
    [[nodiscard]] static Returned<std::vector<double>>
    task(std::uint64_t seed, std::uint32_t options, std::uint32_t buttons) {
        std::vector<double> state(state_len(buttons));
        const critreg_status status =
            critreg_stick_button_task(seed, options, buttons, state.data(), state.size());
        return Errors::give(Failure(status), [&] { return std::move(state); });
    }

    /** Tries to pick the stick, in a state with one button. */
    [[nodiscard]] static Returned<Outcome> pick(Numbers state, double mu,
                                                std::uint32_t options = 0) {
        critreg_outcome outcome = CRITREG_NO_OUTCOME;
        const Failure failure =
            detail::first(detail::fits(state.size(), state_len(1), "the state"), [&] {
                return critreg_stick_button_pick(&options, state.data(), &mu, &outcome);
            });
        return Errors::give(failure, [&] { return Outcome(outcome); });
    }

    /** Runs an operator; how many steps of the environment it took, 0 if it failed. */
    [[nodiscard]] static Returned<std::uint32_t> execute(const critreg_ground &ground,
                                                         const double *parameters, Room state,
                                                         std::uint32_t options = 0) {
        const std::vector<double> before(state.begin(), state.end());
        std::uint32_t actions = 0;
        const critreg_status status = critreg_stick_button_execute(
            &options, &ground, parameters, before.data(), state.data(), state.size(), &actions);
        return Errors::give(Failure(status), [&] { return actions; });
    }

    /** Whether an atom holds. */
    [[nodiscard]] static Returned<bool> holds(const critreg_ground &ground, Numbers state,
                                              std::uint32_t options = 0) {
        std::int32_t holds = 0;
        const critreg_status status = critreg_stick_button_holds(&options, &ground, state.data(),
                                                                 state.size(), &holds);
        return Errors::give(Failure(status), [&] { return holds != 0; });
    }
};

namespace nothrow {
using StickButton = BasicStickButton<Returning>;
} // namespace nothrow

#if CRITREG_EXCEPTIONS
using StickButton = BasicStickButton<Throwing>;
#endif

} // namespace critreg

#endif
