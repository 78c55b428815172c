/**
 * @file critreg_planner.hpp
 * The planner for C++17; see critreg.hpp.
 */
#ifndef CRITREG_PLANNER_HPP
#define CRITREG_PLANNER_HPP

#include <array>

#include "critreg_learner.hpp"
#include "critreg_skills.hpp"
#include "critreg_world.hpp"

namespace critreg {

/** A step of a plan. */
struct Step {
    Ground ground;
    std::vector<double> parameters;
    std::vector<double> state;      /**< Afterwards. */
    std::uint32_t actions;          /**< How many low-level actions it takes. */
};

/** A planner with memory of its own, for one problem. It can be moved. */
template <class Errors> class BasicPlanner {
    template <class T> using Returned = typename Errors::template Returned<T>;

public:
    /** The default configuration, to change; state_len is to be set. */
    [[nodiscard]] static critreg_planner_config default_config() noexcept {
        critreg_planner_config config;
        critreg_planner_config_init(&config, sizeof config);    // Cannot fail with these.
        return config;
    }

    /** Sets the capacities of a configuration to what the texts need. */
    static Returned<void> measure(const std::string &domain, const std::string &problem,
                                  critreg_planner_config &config) {
        const Failure failure = detail::first(complaint(domain, problem), [&] {
            return critreg_planner_measure(domain.c_str(), problem.c_str(), &config);
        });
        return Errors::give(failure, [] {});
    }

    /** How many bytes a planner takes; 0 for a wrong configuration. */
    [[nodiscard]] static std::size_t size(const critreg_planner_config &config) noexcept {
        return critreg_planner_size(&config);
    }

    /** A planner for a PDDL problem; the error tells line and column. */
    [[nodiscard]] static Returned<BasicPlanner> make(const std::string &domain,
                                                     const std::string &problem,
                                                     const critreg_planner_config &config) {
        BasicPlanner planner;
        planner.state_len_ = config.state_len;
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_planner_size(&config);
        planner.memory_ = detail::memory(bytes);
        const Failure failure = detail::first(complaint(domain, problem), [&] {
            critreg_planner *made = nullptr;
            return critreg_planner_init(planner.memory_.get(), bytes, domain.c_str(),
                                        problem.c_str(), &config, &made);
        });
        return Errors::give(failure, [&] { return std::move(planner); });
    }

    /** The same; what fails is thrown. */
    BasicPlanner(const std::string &domain, const std::string &problem,
                 const critreg_planner_config &config)
        : BasicPlanner(make(domain, problem, config)) {}

    /** The continuous parameters of a PDDL action: the least and the greatest value of each. */
    Returned<void> set_ranges(const std::string &name,
                              Span<const std::array<double, 2>> ranges) {
        const double *first = ranges.size() == 0 ? nullptr : ranges.data()->data();
        const Failure failure = explained(
            critreg_planner_set_ranges(handle(), name.c_str(), first, ranges.size()));
        return Errors::give(failure, [] {});
    }

    /** The steps of a plan; none if there is no plan, see metrics() and why(). Skills are in
     *  use meanwhile. */
    Returned<std::optional<std::vector<Step>>> plan(const World &world, Numbers initial,
                                                    std::uint64_t seed,
                                                    const BasicSkills<Errors> *skills = nullptr) {
        detail::WorldCall call{world, {}, {}};
        critreg_skills *used = skills == nullptr ? nullptr : skills->handle();
        std::optional<std::vector<Step>> steps;
        const Failure failure = detail::first(
            detail::fits(initial.size(), state_len_, "the state"),
            [&] { return planned(call, used, initial, seed, steps); });
        call.caught.rethrow();
        return Errors::give(failure, [&] { return std::move(steps); });
    }

    /** What the last plan() cost, however it ended. */
    [[nodiscard]] Returned<critreg_metrics> metrics() const {
        critreg_metrics metrics;
        const Failure failure =
            detail::first(Failure(critreg_metrics_init(&metrics, sizeof metrics)),
                          [&] { return critreg_planner_metrics(handle(), &metrics); });
        return Errors::give(failure, [&] { return metrics; });
    }

    /** How often steps of a PDDL action failed in the last plan(). */
    [[nodiscard]] Returned<std::uint32_t> failures(const std::string &name) {
        std::uint32_t count = 0;
        const Failure failure =
            explained(critreg_planner_failures(handle(), name.c_str(), &count));
        return Errors::give(failure, [&] { return count; });
    }

    /** How often a reason was given in the last plan(). */
    [[nodiscard]] Returned<std::uint32_t> reasons(std::uint32_t reason) {
        std::uint32_t count = 0;
        const Failure failure = explained(critreg_planner_reasons(handle(), reason, &count));
        return Errors::give(failure, [&] { return count; });
    }

    /** Why the last plan() found none, and what to change first; no text if it did. */
    [[nodiscard]] Returned<Why> why() const {
        Why why;
        const critreg_status status =
            detail::fill_text(why.text, [&](char *text, std::size_t len, std::size_t *needed) {
                return critreg_planner_why(handle(), &why.code, text, len, needed);
            });
        return Errors::give(Failure(status), [&] { return std::move(why); });
    }

    /** What stood in the way most often, in the words of the skills. */
    [[nodiscard]] Returned<std::string> reason() const {
        std::string text;
        const critreg_status status =
            detail::fill_text(text, [&](char *words, std::size_t len, std::size_t *needed) {
                return critreg_planner_reason_text(handle(), words, len, needed);
            });
        return Errors::give(Failure(status), [&] { return std::move(text); });
    }

    /** Why the last call failed that did fail, in words. */
    [[nodiscard]] std::string message() const {
        std::string message;
        detail::fill_text(message, [this](char *text, std::size_t len, std::size_t *needed) {
            return critreg_planner_message(handle(), text, len, needed);
        });
        return message;
    }

    /** For functions of critreg.h; NULL if the planner was moved away. */
    [[nodiscard]] critreg_planner *handle() const noexcept {
        return reinterpret_cast<critreg_planner *>(memory_.get());
    }

private:
    BasicPlanner() = default;

    static Failure complaint(const std::string &domain, const std::string &problem) {
        return detail::complaint([&](char *words, std::size_t len, std::size_t *needed) {
            return critreg_check_pddl(domain.c_str(), problem.c_str(), words, len, needed);
        });
    }

    /** A failure in the words of the planner. */
    Failure explained(critreg_status status) const {
        return detail::explained(
            status, [this](char *text, std::size_t len, std::size_t *needed) {
                return critreg_planner_message(handle(), text, len, needed);
            });
    }

    Failure planned(detail::WorldCall &call, critreg_skills *skills, Numbers initial, std::uint64_t seed,
                    std::optional<std::vector<Step>> &steps) {
        critreg_callbacks callbacks;
        std::size_t length = 0;
        Failure failure(critreg_callbacks_init(&callbacks, sizeof callbacks));
        if (failure) return failure;
        detail::set_callbacks(callbacks, call.world);
        if (skills != nullptr) callbacks.skills = skills;
        const critreg_status status =
            critreg_plan(handle(), &callbacks, initial.data(), seed, &call, &length);
        if (status == CRITREG_NO_PLAN) return {};
        failure = call.wrong ? call.wrong : explained(status);
        if (failure) return failure;
        steps.emplace();
        for (std::size_t i = 0; i < length && !failure; i++) failure = add_step(i, *steps);
        return failure;
    }

    Failure add_step(std::size_t index, std::vector<Step> &steps) {
        critreg_step step;
        const Failure failure =
            detail::first(Failure(critreg_step_init(&step, sizeof step)), [&] {
                return explained(critreg_planner_step(handle(), index, &step));
            });
        if (!failure)
            steps.push_back({Ground(step.ground),
                             {step.parameters, step.parameters + step.parameter_count},
                             {step.state, step.state + state_len_},
                             step.actions});
        return failure;
    }

    detail::Memory memory_;     // the handle lies at its start
    std::size_t state_len_ = 0;
};

namespace nothrow {
using Planner = BasicPlanner<Returning>;
} // namespace nothrow

#if CRITREG_EXCEPTIONS
using Planner = BasicPlanner<Throwing>;
#endif

} // namespace critreg

#endif
