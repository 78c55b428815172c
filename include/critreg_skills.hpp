/**
 * @file critreg_skills.hpp
 * Skills for C++17: what a planner knows of its controllers; see critreg.hpp.
 */
#ifndef CRITREG_SKILLS_HPP
#define CRITREG_SKILLS_HPP

#include <array>

#include "critreg_world.hpp"

namespace critreg {

/** What was learned of a skill, in words: its region, or why there is none. */
struct SkillReport {
    bool has_region = false;
    std::string text = {};              /**< The region, or why there is none. */
    critreg_skill_report numbers = {};  /**< Calls, quality, certificate. */
};

/** Skills with memory of their own. They can be moved. */
template <class Errors> class BasicSkills {
    template <class T> using Returned = typename Errors::template Returned<T>;

public:
    /** The default configuration, to change; state_len is to be set. */
    [[nodiscard]] static critreg_skills_config default_config() noexcept {
        critreg_skills_config config;
        critreg_skills_config_init(&config, sizeof config);     // Cannot fail with these.
        return config;
    }

    /** How many bytes skills take; 0 for a wrong configuration. */
    [[nodiscard]] static std::size_t size(const critreg_skills_config &config) noexcept {
        return critreg_skills_size(&config);
    }

    /** Skills of which nothing is known; layout says which numbers belong to which object. */
    [[nodiscard]] static Returned<BasicSkills> make(const std::string &domain,
                                                    const std::string &layout,
                                                    const critreg_skills_config &config) {
        BasicSkills skills;
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_skills_size(&config);
        skills.memory_ = detail::memory(bytes);
        const Failure failure = detail::first(
            detail::complaint([&](char *words, std::size_t len, std::size_t *needed) {
                return critreg_check_domain(layout.c_str(), words, len, needed);
            }),
            [&] {
                critreg_skills *made = nullptr;
                return critreg_skills_init(skills.memory_.get(), bytes, domain.c_str(),
                                           layout.c_str(), &config, &made);
            });
        return Errors::give(failure, [&] { return std::move(skills); });
    }

    /** The same; what fails is thrown. */
    BasicSkills(const std::string &domain, const std::string &layout,
                const critreg_skills_config &config)
        : BasicSkills(make(domain, layout, config)) {}

    /** A controller: its actions and objects, separated by blanks; empty for the defaults. */
    Returned<void> add_controller(const std::string &name, const std::string &actions,
                                  const std::string &objects,
                                  Span<const std::array<double, 2>> ranges) {
        const double *first = ranges.size() == 0 ? nullptr : ranges.data()->data();
        return done(critreg_skills_add_controller(handle(), name.c_str(), optional(actions),
                                                  optional(objects), first, ranges.size()));
    }

    /** A skill of a controller. */
    Returned<void> add(const std::string &controller, const std::string &text,
                       const std::string &members = {}) {
        return done(critreg_skills_add(handle(), controller.c_str(), nullptr, optional(members),
                                       text.c_str()));
    }

    /** A skill of two controllers; an empty text follows from those of the two. */
    Returned<void> add_pair(const std::string &controller, const std::string &later,
                            const std::string &text = {}, const std::string &members = {}) {
        return done(critreg_skills_add(handle(), controller.c_str(), later.c_str(),
                                       optional(members), optional(text)));
    }

    /** A training task: a problem, and the state that it begins in. */
    Returned<void> add_task(const std::string &problem, Numbers initial) {
        return done(critreg_skills_add_task(handle(), problem.c_str(), initial.data(),
                                            initial.size()));
    }

    /** Learns all skills. What the world throws ends learning and is thrown on; learning can
     *  go on afterwards. */
    Returned<void> learn(const World &world) {
        detail::WorldCall call{world, {}, {}};
        critreg_callbacks callbacks;
        const Failure failure =
            detail::first(Failure(critreg_callbacks_init(&callbacks, sizeof callbacks)), [&] {
                detail::set_callbacks(callbacks, world);
                const critreg_status status = critreg_skills_learn(handle(), &callbacks, &call);
                return call.wrong ? call.wrong : explained(status);
            });
        call.caught.rethrow();
        return Errors::give(failure, [] {});
    }

    /** What was learned of a skill, by its place. */
    [[nodiscard]] Returned<SkillReport> report(std::size_t index) const {
        SkillReport report;
        critreg_skill_report &numbers = report.numbers;
        const Failure failure = detail::first(
            Failure(critreg_skill_report_init(&numbers, sizeof numbers)),
            [&] { return explained(critreg_skills_report(handle(), index, &numbers)); },
            [&] {
                const critreg_status status = detail::fill_text(
                    report.text, [&](char *text, std::size_t len, std::size_t *needed) {
                        const critreg_status own =
                            critreg_skills_format(handle(), index, text, len, needed);
                        // Then the text says why.
                        return own == CRITREG_NO_REGION ? CRITREG_OK : own;
                    });
                return explained(status);
            });
        report.has_region = numbers.has_region != 0;
        return Errors::give(failure, [&] { return std::move(report); });
    }

    /** The domain text of a skill, by its place. */
    [[nodiscard]] Returned<std::string> domain(std::size_t index) const {
        std::string domain;
        const critreg_status status =
            detail::fill_text(domain, [&](char *text, std::size_t len, std::size_t *needed) {
                return critreg_skills_domain(handle(), index, text, len, needed);
            });
        return Errors::give(explained(status), [&] { return std::move(domain); });
    }

    /** What was learned so far, as bytes. */
    [[nodiscard]] Returned<std::vector<std::uint8_t>> save() const {
        std::vector<std::uint8_t> saved;
        const critreg_status status =
            detail::fill(saved, [&](std::uint8_t *bytes, std::size_t len, std::size_t *needed) {
                return critreg_skills_save(handle(), bytes, len, needed);
            });
        return Errors::give(explained(status), [&] { return std::move(saved); });
    }

    /** Brings fresh skills to the state that save() wrote. */
    Returned<void> resume(Bytes bytes) {
        return done(critreg_skills_resume(handle(), bytes.data(), bytes.size()));
    }

    /** Why the last call failed that did fail, in words. */
    [[nodiscard]] std::string message() const {
        std::string message;
        detail::fill_text(message, [this](char *text, std::size_t len, std::size_t *needed) {
            return critreg_skills_message(handle(), text, len, needed);
        });
        return message;
    }

    /** For functions of critreg.h; NULL if the skills were moved away. */
    [[nodiscard]] critreg_skills *handle() const noexcept {
        return reinterpret_cast<critreg_skills *>(memory_.get());
    }

private:
    BasicSkills() = default;

    static const char *optional(const std::string &text) noexcept {
        return text.empty() ? nullptr : text.c_str();
    }

    /** A failure in the words of the skills. */
    Failure explained(critreg_status status) const {
        return detail::explained(
            status, [this](char *text, std::size_t len, std::size_t *needed) {
                return critreg_skills_message(handle(), text, len, needed);
            });
    }

    Returned<void> done(critreg_status status) const {
        return Errors::give(explained(status), [] {});
    }

    detail::Memory memory_;     // the handle lies at its start
};

namespace nothrow {
using Skills = BasicSkills<Returning>;
} // namespace nothrow

#if CRITREG_EXCEPTIONS
using Skills = BasicSkills<Throwing>;
#endif

} // namespace critreg

#endif
