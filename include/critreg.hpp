/**
 * @file critreg.hpp
 * critreg.h for C++17: owners of memory, exceptions, vectors.
 *
 * A critreg::Learner owns the memory of a learner, a critreg::Region that of a
 * region, a critreg::Planner that of a planner, critreg::Skills that of skills. What can
 * fail throws critreg::Error.
 * Nothing here is linked: the header only calls the functions of critreg.h, which
 * remains the manual.
 *
 *     critreg::Learner learner(DOMAIN);
 *     critreg::Region region = learner.learn(instances, [](const double *instance,
 *                                                          const double *theta) {
 *         return try_grasp(instance, theta);      // a bool: whether it works
 *     });
 *     critreg::Rng rng(7);
 *     if (auto theta = region.sample(instance, rng)) try_it(*theta);
 */
#ifndef CRITREG_HPP
#define CRITREG_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "critreg.h"

namespace critreg {

/** A call that failed: its status, and in what() why. */
class Error : public std::runtime_error {
public:
    Error(critreg_status status, const std::string &why)
        : std::runtime_error(why.empty() ? critreg_strerror(status) : why), status_(status) {}

    /** The status of the call. */
    critreg_status status() const noexcept { return status_; }

private:
    critreg_status status_;
};

namespace detail {

inline void check(critreg_status status, const std::string &why = {}) {
    if (status != CRITREG_OK) throw Error(status, why);
}

/** Calls a function that fills a buffer, first for the length it needs. */
template <class Buffer, class Fill> Buffer filled(Fill fill) {
    std::size_t needed = 0;
    critreg_status status = fill(nullptr, 0, &needed);
    if (status != CRITREG_TOO_SMALL) check(status);
    Buffer buffer(needed, 0);
    check(fill(buffer.data(), buffer.size(), &needed));
    return buffer;
}

template <class Fill> std::string text(Fill fill) {
    std::string text = filled<std::string>(fill);
    if (!text.empty()) text.pop_back();     // the NUL
    return text;
}

} // namespace detail

/** A generator of random numbers; copies go on with the same numbers. */
class Rng {
public:
    explicit Rng(std::uint64_t seed) : state(critreg_rng_seed(seed)) {}
    explicit Rng(critreg_rng own) : state(own) {}

    /** A number uniform in [0, 1). */
    double uniform() {
        double number;
        detail::check(critreg_rng_uniform(&state, &number));
        return number;
    }

    /** For functions of critreg.h. */
    critreg_rng state;
};

/** A constraint of a region: its text, the name of its bound, what supports it. */
struct Constraint {
    std::string text;               /**< As in the text of the region. */
    std::string name;               /**< Empty if the bound has none. */
    critreg_constraint evidence;    /**< has_evidence is 0 if none is known. */
};

/** The constraints of a region, from left to right. */
inline std::vector<Constraint> constraints(const critreg_region *region) {
    std::size_t count;
    detail::check(critreg_region_constraint_count(region, &count));
    std::vector<Constraint> all(count);
    for (std::size_t i = 0; i < count; i++) {
        all[i].text = detail::text([=](char *text, std::size_t len, std::size_t *needed) {
            return critreg_region_constraint_format(region, i, text, len, needed);
        });
        all[i].name = detail::text([=](char *text, std::size_t len, std::size_t *needed) {
            return critreg_region_constraint_name(region, i, text, len, needed);
        });
        detail::check(critreg_constraint_init(&all[i].evidence, sizeof all[i].evidence));
        detail::check(critreg_region_constraint(region, i, &all[i].evidence));
    }
    return all;
}

/** A region in memory of its own. It can be moved, and shared between threads. */
class Region {
public:
    /** Reads a region text; the error tells line and column. */
    static Region parse(const std::string &domain, const std::string &text) {
        std::array<char, 128> why{};
        const critreg_status status = critreg_check_region(domain.c_str(), text.c_str(),
                                                           why.data(), why.size(), nullptr);
        detail::check(status, why.data());
        Region region;
        critreg_region *handle;
        detail::check(critreg_region_parse(region.memory_.get(), BYTES, domain.c_str(),
                                           text.c_str(), &handle));
        return region;
    }

    /** Reads what save() wrote. */
    static Region load(const std::vector<std::uint8_t> &bytes) {
        Region region;
        critreg_region *handle;
        detail::check(critreg_region_load(region.memory_.get(), BYTES, bytes.data(), bytes.size(),
                                          &handle));
        return region;
    }

    /** The region and its domain as bytes. */
    std::vector<std::uint8_t> save() const { return save(handle()); }

    /** The region as text. */
    std::string text() const {
        return detail::text([this](char *text, std::size_t len, std::size_t *needed) {
            return critreg_region_format(handle(), text, len, needed);
        });
    }

    /**
     * Its constraints. What supports them is known to the learner only; see
     * Learner::constraints().
     */
    std::vector<Constraint> constraints() const { return critreg::constraints(handle()); }

    /** How many numbers an instance has. */
    std::size_t instance_len() const {
        std::size_t len;
        detail::check(critreg_region_instance_len(handle(), &len));
        return len;
    }

    /** How many parameters the action has. */
    std::size_t parameter_count() const {
        std::size_t count;
        detail::check(critreg_region_parameter_count(handle(), &count));
        return count;
    }

    /** Whether an action with these parameters is expected to work. */
    bool contains(const std::vector<double> &instance, const std::vector<double> &theta) const {
        expect(instance.size() == instance_len() && theta.size() == parameter_count());
        std::int32_t inside;
        detail::check(critreg_region_contains(handle(), instance.data(), theta.data(), &inside));
        return inside != 0;
    }

    /** The admitted intervals of the action's only parameter. */
    std::vector<std::pair<double, double>> intervals(const std::vector<double> &instance) const {
        expect(instance.size() == instance_len());
        std::array<double, 2 * CRITREG_MAX_INTERVALS> ends{};
        std::size_t count;
        detail::check(critreg_region_intervals(handle(), instance.data(), ends.data(),
                                               CRITREG_MAX_INTERVALS, &count));
        std::vector<std::pair<double, double>> intervals;
        for (std::size_t i = 0; i < 2 * count; i += 2) intervals.emplace_back(ends[i], ends[i + 1]);
        return intervals;
    }

    /** Parameters from the region; none if it is empty or none were found. */
    std::optional<std::vector<double>> sample(const std::vector<double> &instance, Rng &rng) const {
        expect(instance.size() == instance_len());
        std::vector<double> theta(parameter_count() + 1);   // data() is never NULL
        critreg_status status =
            critreg_sample_region(handle(), instance.data(), &rng.state, theta.data());
        if (status == CRITREG_EMPTY_REGION || status == CRITREG_NO_SAMPLE) return std::nullopt;
        detail::check(status);
        theta.pop_back();
        return theta;
    }

    /** For functions of critreg.h; NULL if the region was moved away. */
    const critreg_region *handle() const noexcept {
        return reinterpret_cast<const critreg_region *>(memory_.get());
    }

private:
    friend class Learner;

    static constexpr std::size_t BYTES = CRITREG_REGION_WORDS * sizeof(std::uint64_t);

    Region() : memory_(new std::uint64_t[CRITREG_REGION_WORDS]) {}

    static std::vector<std::uint8_t> save(const critreg_region *handle) {
        return detail::filled<std::vector<std::uint8_t>>(
            [handle](std::uint8_t *bytes, std::size_t len, std::size_t *needed) {
                return critreg_region_save(handle, bytes, len, needed);
            });
    }

    static void expect(bool fits) {
        if (!fits) throw Error(CRITREG_INVALID_ARGUMENT, "a vector has the wrong length");
    }

    std::unique_ptr<std::uint64_t[]> memory_;   // the handle lies at its start
};

/** A region, and the instance to ground it in. */
struct Part {
    const Region &region;
    const std::vector<double> &instance;
};

/**
 * Parameters that several regions admit, each in an instance of its own; none if they
 * are proven to admit none together, or none were found.
 */
inline std::optional<std::vector<double>> sample(const std::vector<Part> &parts, Rng &rng) {
    std::vector<const critreg_region *> regions;
    std::vector<const double *> instances;
    for (const Part &part : parts) {
        if (part.instance.size() != part.region.instance_len())
            throw Error(CRITREG_INVALID_ARGUMENT, "a vector has the wrong length");
        regions.push_back(part.region.handle());
        instances.push_back(part.instance.data());
    }
    std::vector<double> theta(CRITREG_MAX_PARAMETERS);
    const critreg_status status = critreg_sample_regions(regions.data(), instances.data(),
                                                         parts.size(), &rng.state, theta.data());
    if (status == CRITREG_EMPTY_REGION || status == CRITREG_NO_SAMPLE) return std::nullopt;
    detail::check(status);
    theta.resize(parts.front().region.parameter_count());
    return theta;
}

/** What a learner wants to know. */
struct Query {
    std::size_t instance;       /**< Index of the instance. */
    std::vector<double> theta;  /**< The parameters to try. */
};

/** A learner with memory of its own. It can be moved. */
class Learner {
public:
    /** The default configuration, to change: learner, calls, noise, steps, ... */
    static critreg_config default_config() {
        critreg_config config;
        detail::check(critreg_config_init(&config, sizeof config));
        return config;
    }

    /** A learner about a domain. A config without forms gets the default number. */
    explicit Learner(const std::string &domain, critreg_config config = default_config()) {
        std::array<char, 128> why{};
        const critreg_status status =
            critreg_check_domain(domain.c_str(), why.data(), why.size(), nullptr);
        detail::check(status, why.data());
        if (config.forms == 0) config.forms = CRITREG_DEFAULT_FORMS;
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_learner_size(&config);
        memory_.reset(new std::uint64_t[bytes / sizeof(std::uint64_t) + 1]);
        critreg_learner *made;
        detail::check(critreg_learner_init(memory_.get(), bytes, domain.c_str(), &config, &made));
        detail::check(critreg_learner_instance_len(handle(), &instance_len_));
        detail::check(critreg_learner_parameter_count(handle(), &parameter_count_));
    }

    /**
     * Learns with a simulator: simulate(const double *instance, const double *theta)
     * returns a bool, whether the action works, or a critreg_outcome. What it throws ends
     * learning and is thrown on; learning can go on afterwards.
     */
    template <class Simulate>
    Region learn(const std::vector<double> &instances, Simulate &&simulate) {
        using Answer = std::invoke_result_t<Simulate &, const double *, const double *>;
        static_assert(std::is_integral_v<Answer>,
                      "simulate returns a bool or a critreg_outcome");
        struct Call {
            Simulate &simulate;
            std::exception_ptr thrown;
        } call{simulate, nullptr};
        auto trampoline = [](void *user_data, const double *instance, const double *theta,
                             critreg_outcome *outcome) -> critreg_status {
            Call &call = *static_cast<Call *>(user_data);
            try {
                *outcome = call.simulate(instance, theta);
                return CRITREG_OK;
            } catch (...) {
                call.thrown = std::current_exception();
                return CRITREG_USER_STATUS;
            }
        };
        const critreg_region *region = nullptr;
        critreg_status status = critreg_learn_region(handle(), instances.data(), count(instances),
                                                     trampoline, &call, &region);
        if (call.thrown) std::rethrow_exception(call.thrown);
        check(status);
        return Region::load(Region::save(region));
    }

    /** The sample to try next. */
    Query ask(const std::vector<double> &instances) {
        Query query{0, std::vector<double>(parameter_count_)};
        check(critreg_ask(handle(), instances.data(), count(instances), &query.instance,
                          query.theta.data()));
        return query;
    }

    /** What came of it: a bool, whether the action worked, or a critreg_outcome. */
    void tell(const std::vector<double> &instances, critreg_outcome outcome) {
        check(critreg_tell(handle(), instances.data(), count(instances), outcome));
    }

    /** What came of a sample that was not asked for: of a log, or a demonstration. */
    void observe(const std::vector<double> &instances, const Query &query,
                 critreg_outcome outcome) {
        check(critreg_observe(handle(), instances.data(), count(instances), query.instance,
                              checked(query).theta.data(), outcome));
    }

    /** Brings the region up to date with everything that was told, before it is asked for. */
    void conclude(const std::vector<double> &instances) {
        check(critreg_conclude(handle(), instances.data(), count(instances)));
    }

    /** Whether there is nothing more to ask. */
    bool is_finished() const {
        std::int32_t finished;
        detail::check(critreg_is_finished(handle(), &finished));
        return finished != 0;
    }

    /** A copy of what is learned so far. */
    Region region() {
        const critreg_region *region = nullptr;
        check(critreg_learner_region(handle(), &region));
        return Region::load(Region::save(region));
    }

    /** The constraints of what is learned so far, with what supports them. */
    std::vector<Constraint> constraints() {
        const critreg_region *region = nullptr;
        check(critreg_learner_region(handle(), &region));
        return critreg::constraints(region);
    }

    /** How learning went so far. */
    critreg_report report() const {
        critreg_report report;
        detail::check(critreg_report_init(&report, sizeof report));
        detail::check(critreg_learner_report(handle(), &report));
        return report;
    }

    /** What was told so far, as bytes. */
    std::vector<std::uint8_t> save(const std::vector<double> &instances) {
        return detail::filled<std::vector<std::uint8_t>>(
            [&](std::uint8_t *bytes, std::size_t len, std::size_t *needed) {
                return critreg_learner_save(handle(), instances.data(), count(instances), bytes,
                                            len, needed);
            });
    }

    /** Brings a fresh learner to the state that save() wrote. */
    void resume(const std::vector<double> &instances, const std::vector<std::uint8_t> &bytes) {
        check(critreg_learner_resume(handle(), instances.data(), count(instances), bytes.data(),
                                     bytes.size()));
    }

    /** What is to be appended to a journal that has the first so many observations. */
    std::vector<std::uint8_t> journal(const std::vector<double> &instances, std::size_t from) {
        return detail::filled<std::vector<std::uint8_t>>(
            [&](std::uint8_t *bytes, std::size_t len, std::size_t *needed) {
                return critreg_learner_journal(handle(), instances.data(), count(instances), from,
                                               bytes, len, needed);
            });
    }

    /** Brings a fresh learner to the state that a journal tells of. Returns how many of its
     *  bytes stand; what is behind was torn. */
    std::size_t resume_journal(const std::vector<double> &instances,
                               const std::vector<std::uint8_t> &bytes) {
        std::size_t stands = 0;
        check(critreg_learner_resume_journal(handle(), instances.data(), count(instances),
                                             bytes.data(), bytes.size(), &stands));
        return stands;
    }

    /** For functions of critreg.h; NULL if the learner was moved away. */
    critreg_learner *handle() const noexcept {
        return reinterpret_cast<critreg_learner *>(memory_.get());
    }

private:
    std::size_t count(const std::vector<double> &instances) const {
        // Where a domain has no objects there is one instance, without numbers.
        const std::size_t len = std::max<std::size_t>(instance_len_, 1);
        if (instances.size() % len != 0 || (instance_len_ == 0 && !instances.empty()))
            throw Error(CRITREG_INVALID_ARGUMENT, "the instances have the wrong length");
        return instance_len_ == 0 ? 1 : instances.size() / len;
    }

    const Query &checked(const Query &query) const {
        if (query.theta.size() != parameter_count_)
            throw Error(CRITREG_INVALID_ARGUMENT, "theta has the wrong length");
        return query;
    }

    void check(critreg_status status) const {
        if (status == CRITREG_OK) return;
        throw Error(status,
                    detail::text([this](char *text, std::size_t len, std::size_t *needed) {
                        return critreg_learner_message(handle(), text, len, needed);
                    }));
    }

    std::unique_ptr<std::uint64_t[]> memory_;   // the handle lies at its start
    std::size_t instance_len_ = 0;
    std::size_t parameter_count_ = 0;
};

/** A ground atom or operator: its name, and its objects. */
struct Ground {
    std::string name;
    std::vector<std::string> objects;

    Ground(const critreg_ground &ground)
        : name(ground.name),
          objects(ground.object_names, ground.object_names + ground.object_count) {}

    /** As in PDDL: "(Walk a b)". */
    std::string text() const {
        std::string text = "(" + name;
        for (const std::string &object : objects) text += " " + object;
        return text + ")";
    }
};

/** A step of a plan. */
struct Step {
    Ground ground;
    std::vector<double> parameters;
    std::vector<double> state;      /**< Afterwards. */
    std::uint32_t actions;          /**< How many low-level actions it takes. */
};

/** What a planner asks the program. What they throw ends planning and is thrown on. */
struct World {
    /** Runs an operator, changes the state, returns how many actions it took; 0 if it failed. */
    std::function<std::uint32_t(const Ground &, const double *parameters,
                                std::vector<double> &state)>
        execute;
    /** Whether an atom holds in a state. */
    std::function<bool(const Ground &, const std::vector<double> &state)> holds;
    /** As critreg_sample, but for its user_data; may be empty. */
    std::function<critreg_status(const critreg_draw &, Rng &, critreg_drawn &)> sample = {};
    /** As critreg_advise, but for its user_data; may be empty. */
    std::function<critreg_advice(const critreg_ground *prefix, std::size_t length,
                                 const std::vector<double> &initial, std::uint32_t &reason)>
        advise = {};
};

namespace detail {

/** A call of World's callbacks under way, and what one threw. */
struct WorldCall {
    const World &world;
    std::exception_ptr thrown;
};

/** Runs a callback; what it throws waits until planning has ended. */
template <class Body> critreg_status guarded(void *user_data, Body body) {
    WorldCall &call = *static_cast<WorldCall *>(user_data);
    try {
        return body(call.world);
    } catch (...) {
        call.thrown = std::current_exception();
        return CRITREG_USER_STATUS;
    }
}

inline critreg_callbacks callbacks_of(const World &world) {
    critreg_callbacks callbacks;
    detail::check(critreg_callbacks_init(&callbacks, sizeof callbacks));
    callbacks.execute = [](void *user_data, const critreg_ground *ground,
                           const double *parameters, const double *before, double *after,
                           std::size_t len, std::uint32_t *actions) {
        return guarded(user_data, [=](const World &world) {
            std::vector<double> state(before, before + len);
            *actions = world.execute(*ground, parameters, state);
            if (state.size() != len)
                throw Error(CRITREG_INVALID_ARGUMENT, "the state has the wrong length");
            std::copy(state.begin(), state.end(), after);
            return CRITREG_OK;
        });
    };
    callbacks.holds = [](void *user_data, const critreg_ground *ground, const double *state,
                         std::size_t len, std::int32_t *holds) {
        return guarded(user_data, [=](const World &world) {
            *holds = world.holds(*ground, std::vector<double>(state, state + len));
            return CRITREG_OK;
        });
    };
    if (world.sample)
        callbacks.sample = [](void *user_data, const critreg_draw *draw, critreg_rng *rng,
                              critreg_drawn *drawn) {
            return guarded(user_data, [=](const World &world) {
                Rng own(*rng);
                const critreg_status status = world.sample(*draw, own, *drawn);
                *rng = own.state;
                return status;
            });
        };
    if (world.advise)
        callbacks.advise = [](void *user_data, const critreg_ground *prefix,
                              std::size_t length, const double *initial, std::size_t len,
                              critreg_advice *advice, std::uint32_t *reason) {
            return guarded(user_data, [=](const World &world) {
                const std::vector<double> state(initial, initial + len);
                *advice = world.advise(prefix, length, state, *reason);
                return CRITREG_OK;
            });
        };
    return callbacks;
}

} // namespace detail

/** What was learned of a skill, in words: its region, or why there is none. */
struct SkillReport {
    bool has_region;
    std::string text;               /**< The region, or why there is none. */
    critreg_skill_report numbers;   /**< Calls, quality, certificate. */
};

/** Skills with memory of their own. They can be moved. */
class Skills {
public:
    /** The default configuration, to change; state_len is to be set. */
    static critreg_skills_config default_config() {
        critreg_skills_config config;
        detail::check(critreg_skills_config_init(&config, sizeof config));
        return config;
    }

    /** Skills of which nothing is known; layout says which numbers belong to which object. */
    Skills(const std::string &domain, const std::string &layout,
           const critreg_skills_config &config) {
        std::array<char, 128> why{};
        const critreg_status status =
            critreg_check_domain(layout.c_str(), why.data(), why.size(), nullptr);
        detail::check(status, why.data());
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_skills_size(&config);
        memory_.reset(new std::uint64_t[bytes / sizeof(std::uint64_t) + 1]);
        critreg_skills *made;
        detail::check(critreg_skills_init(memory_.get(), bytes, domain.c_str(), layout.c_str(),
                                          &config, &made));
    }

    /** A controller: its actions and objects, separated by blanks; empty for the defaults. */
    void add_controller(const std::string &name, const std::string &actions,
                        const std::string &objects,
                        const std::vector<std::array<double, 2>> &ranges) {
        check(critreg_skills_add_controller(handle(), name.c_str(), optional(actions),
                                            optional(objects),
                                            ranges.empty() ? nullptr : ranges.front().data(),
                                            ranges.size()));
    }

    /** A skill of a controller. */
    void add(const std::string &controller, const std::string &text,
             const std::string &members = {}) {
        check(critreg_skills_add(handle(), controller.c_str(), nullptr, optional(members),
                                 text.c_str()));
    }

    /** A skill of two controllers; an empty text follows from those of the two. */
    void add_pair(const std::string &controller, const std::string &later,
                  const std::string &text = {}, const std::string &members = {}) {
        check(critreg_skills_add(handle(), controller.c_str(), later.c_str(), optional(members),
                                 optional(text)));
    }

    /** A training task: a problem, and the state that it begins in. */
    void add_task(const std::string &problem, const std::vector<double> &initial) {
        check(critreg_skills_add_task(handle(), problem.c_str(), initial.data(), initial.size()));
    }

    /** Learns all skills. What the world throws ends learning and is thrown on; learning can
     *  go on afterwards. */
    void learn(const World &world) {
        detail::WorldCall call{world, nullptr};
        const critreg_callbacks callbacks = detail::callbacks_of(world);
        const critreg_status status = critreg_skills_learn(handle(), &callbacks, &call);
        if (call.thrown) std::rethrow_exception(call.thrown);
        check(status);
    }

    /** What was learned of a skill, by its place. */
    SkillReport report(std::size_t index) {
        SkillReport report{};
        check(critreg_skill_report_init(&report.numbers, sizeof report.numbers));
        check(critreg_skills_report(handle(), index, &report.numbers));
        report.has_region = report.numbers.has_region != 0;
        std::size_t needed = 0;
        critreg_status status = critreg_skills_format(handle(), index, nullptr, 0, &needed);
        report.text.resize(needed);
        status = critreg_skills_format(handle(), index, &report.text[0], needed, nullptr);
        if (status != CRITREG_NO_REGION) check(status);
        report.text.pop_back();     // the NUL
        return report;
    }

    /** The domain text of a skill, by its place. */
    std::string domain(std::size_t index) {
        return detail::text([this, index](char *text, std::size_t len, std::size_t *needed) {
            return critreg_skills_domain(handle(), index, text, len, needed);
        });
    }

    /** What was learned so far, as bytes. */
    std::vector<std::uint8_t> save() {
        return detail::filled<std::vector<std::uint8_t>>(
            [this](std::uint8_t *bytes, std::size_t len, std::size_t *needed) {
                return critreg_skills_save(handle(), bytes, len, needed);
            });
    }

    /** Brings fresh skills to the state that save() wrote. */
    void resume(const std::vector<std::uint8_t> &bytes) {
        check(critreg_skills_resume(handle(), bytes.data(), bytes.size()));
    }

    /** For functions of critreg.h; NULL if the skills were moved away. */
    critreg_skills *handle() const noexcept {
        return reinterpret_cast<critreg_skills *>(memory_.get());
    }

private:
    static const char *optional(const std::string &text) {
        return text.empty() ? nullptr : text.c_str();
    }

    void check(critreg_status status) const {
        if (status == CRITREG_OK) return;
        throw Error(status,
                    detail::text([this](char *text, std::size_t len, std::size_t *needed) {
                        return critreg_skills_message(handle(), text, len, needed);
                    }));
    }

    std::unique_ptr<std::uint64_t[]> memory_;   // the handle lies at its start
};

/** A planner with memory of its own, for one problem. It can be moved. */
class Planner {
public:
    /** The default configuration, to change; state_len is to be set. */
    static critreg_planner_config default_config() {
        critreg_planner_config config;
        detail::check(critreg_planner_config_init(&config, sizeof config));
        return config;
    }

    /** A planner for a PDDL problem; the error tells line and column. */
    Planner(const std::string &domain, const std::string &problem,
            const critreg_planner_config &config)
        : state_len_(config.state_len) {
        std::array<char, 256> why{};
        const critreg_status status = critreg_check_pddl(domain.c_str(), problem.c_str(),
                                                         why.data(), why.size(), nullptr);
        detail::check(status, why.data());
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_planner_size(&config);
        memory_.reset(new std::uint64_t[bytes / sizeof(std::uint64_t) + 1]);
        critreg_planner *made;
        detail::check(critreg_planner_init(memory_.get(), bytes, domain.c_str(), problem.c_str(),
                                           &config, &made));
    }

    /** The continuous parameters of a PDDL action: the least and the greatest value of each. */
    void set_ranges(const std::string &name, const std::vector<std::array<double, 2>> &ranges) {
        check(critreg_planner_set_ranges(handle(), name.c_str(),
                                         ranges.empty() ? nullptr : ranges.front().data(),
                                         ranges.size()));
    }

    /** The steps of a plan; none if there is no plan, see metrics() and why_no_plan(). Skills
     *  are in use meanwhile. */
    std::optional<std::vector<Step>> plan(const World &world, const std::vector<double> &initial,
                                          std::uint64_t seed, const Skills *skills = nullptr) {
        if (initial.size() != state_len_)
            throw Error(CRITREG_INVALID_ARGUMENT, "the state has the wrong length");
        detail::WorldCall call{world, nullptr};
        critreg_callbacks callbacks = detail::callbacks_of(world);
        if (skills != nullptr) callbacks.skills = skills->handle();
        std::size_t length = 0;
        const critreg_status status =
            critreg_plan(handle(), &callbacks, initial.data(), seed, &call, &length);
        if (call.thrown) std::rethrow_exception(call.thrown);
        if (status == CRITREG_NO_PLAN) return std::nullopt;
        check(status);
        std::vector<Step> steps;
        for (std::size_t i = 0; i < length; i++) steps.push_back(step(i));
        return steps;
    }

    /** What the last plan() cost, however it ended. */
    critreg_metrics metrics() const {
        critreg_metrics metrics;
        detail::check(critreg_metrics_init(&metrics, sizeof metrics));
        detail::check(critreg_planner_metrics(handle(), &metrics));
        return metrics;
    }

    /** Why the last plan() found none, and what to change first; empty if it did. */
    std::string why_no_plan() const {
        return detail::text([this](char *text, std::size_t len, std::size_t *needed) {
            std::uint32_t why = CRITREG_WHY_NOTHING;
            return critreg_planner_why(handle(), &why, text, len, needed);
        });
    }

    /** What stood in the way most often, in the words of the skills. */
    std::string reason() const {
        return detail::text([this](char *text, std::size_t len, std::size_t *needed) {
            return critreg_planner_reason_text(handle(), text, len, needed);
        });
    }

    /** Why the last call failed that did fail. */
    std::string why() const {
        return detail::text([this](char *text, std::size_t len, std::size_t *needed) {
            return critreg_planner_message(handle(), text, len, needed);
        });
    }

    /** For functions of critreg.h; NULL if the planner was moved away. */
    critreg_planner *handle() const noexcept {
        return reinterpret_cast<critreg_planner *>(memory_.get());
    }

private:
    Step step(std::size_t index) {
        critreg_step step;
        detail::check(critreg_step_init(&step, sizeof step));
        check(critreg_planner_step(handle(), index, &step));
        return {Ground(step.ground),
                std::vector<double>(step.parameters, step.parameters + step.parameter_count),
                std::vector<double>(step.state, step.state + state_len_), step.actions};
    }

    void check(critreg_status status) const {
        if (status != CRITREG_OK) throw Error(status, why());
    }

    std::unique_ptr<std::uint64_t[]> memory_;   // the handle lies at its start
    std::size_t state_len_;
};

} // namespace critreg

#endif
