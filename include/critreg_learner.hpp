/**
 * @file critreg_learner.hpp
 * Learners for C++17; see critreg.hpp.
 */
#ifndef CRITREG_LEARNER_HPP
#define CRITREG_LEARNER_HPP

#include <algorithm>

#include "critreg_region.hpp"

namespace critreg {

/** What a learner wants to know. */
struct Query {
    std::size_t instance;       /**< Index of the instance. */
    std::vector<double> theta;  /**< The parameters to try. */
};

/** One of several questions that are open. */
struct Question {
    std::uint64_t id;           /**< By which tell_id() knows it. */
    std::size_t instance;       /**< Index of the instance. */
    std::vector<double> theta;  /**< The parameters to try. */
};

/** Why there is no region or no plan: a code of critreg.h, and a sentence. */
struct Why {
    std::uint32_t code = 0;
    std::string text = {};
};

/** Sees how learning goes: Status::ok to go on, Status::cancelled to stop. */
struct NoProgress {
    Status operator()(const critreg_report &) const noexcept { return Status::ok; }
};

/** A learner with memory of its own. It can be moved. */
template <class Errors> class BasicLearner {
    template <class T> using Returned = typename Errors::template Returned<T>;

public:
    using Region = BasicRegion<Errors>;

    /** The default configuration, to change: learner, calls, noise, steps, ... */
    [[nodiscard]] static critreg_config default_config() noexcept {
        critreg_config config;
        critreg_config_init(&config, sizeof config);    // Cannot fail with these.
        return config;
    }

    /** What is wrong with a domain text, if anything is, with line and column. */
    static Returned<void> check_domain(const std::string &domain) {
        return Errors::give(complaint(domain), [] {});
    }

    /** What is wrong with a configuration, if anything is. */
    static Returned<void> check_config(const critreg_config &config) {
        const Failure failure =
            detail::complaint([&](char *words, std::size_t len, std::size_t *needed) {
                return critreg_check_config(&config, words, len, needed);
            });
        return Errors::give(failure, [] {});
    }

    /** How many bytes a learner takes; 0 for a wrong configuration. */
    [[nodiscard]] static std::size_t size(const critreg_config &config) noexcept {
        return critreg_learner_size(&config);
    }

    /** A learner about a domain. A config without forms gets the default number. */
    [[nodiscard]] static Returned<BasicLearner> make(const std::string &domain,
                                                     critreg_config config = default_config()) {
        BasicLearner learner;
        if (config.forms == 0) config.forms = CRITREG_DEFAULT_FORMS;
        learner.listener_ = std::make_unique<Listener>(Listener{config.progress,
                                                                config.progress_data, nullptr,
                                                                nullptr});
        config.progress = &Listener::hear;
        config.progress_data = learner.listener_.get();
        // A wrong configuration has no size; then init tells what is wrong.
        const std::size_t bytes = critreg_learner_size(&config);
        learner.memory_ = detail::memory(bytes);
        const Failure failure = detail::first(
            complaint(domain),
            [&] {
                critreg_learner *made = nullptr;
                return critreg_learner_init(learner.memory_.get(), bytes, domain.c_str(), &config,
                                            &made);
            },
            [&] { return critreg_learner_instance_len(learner.handle(), &learner.instance_len_); },
            [&] {
                return critreg_learner_parameter_count(learner.handle(),
                                                       &learner.parameter_count_);
            });
        return Errors::give(failure, [&] { return std::move(learner); });
    }

    /** The same; what fails is thrown. */
    explicit BasicLearner(const std::string &domain, critreg_config config = default_config())
        : BasicLearner(make(domain, config)) {}

    /** How many numbers an instance has. */
    [[nodiscard]] std::size_t instance_len() const noexcept { return instance_len_; }

    /** How many parameters the action has. */
    [[nodiscard]] std::size_t parameter_count() const noexcept { return parameter_count_; }

    /**
     * Chooses instances of a source that can make so many: make(std::size_t number, double
     * *instance) writes one, and what it throws is thrown on. Returns those that differ most, one
     * behind the other, as many as there is room for and no more than that; before anything is
     * asked or told.
     */
    template <class Make>
    Returned<std::vector<double>> choose_instances(std::size_t offered, Make &&make,
                                                   std::size_t room) {
        struct Call {
            std::remove_reference_t<Make> &make;
            detail::Caught caught;
        } call{make, {}};
        auto made = [](void *user_data, std::size_t number, double *instance) -> critreg_status {
            Call &own = *static_cast<Call *>(user_data);
            return own.caught.run([&]() -> critreg_status {
                own.make(number, instance);
                return CRITREG_OK;
            });
        };
        std::vector<double> instances(room * instance_len());
        std::size_t count = 0;
        const Failure failure = explained(critreg_choose_instances(
            handle(), offered, made, &call, instances.data(), room, &count));
        call.caught.rethrow();
        instances.resize(count * instance_len());
        return Errors::give(failure, [&] { return std::move(instances); });
    }

    /**
     * Learns with a simulator: simulate(const double *instance, const double *theta)
     * returns a bool, whether the action works, or a critreg_outcome. After each sample
     * progress(const critreg_report &) returns a Status. What they throw ends learning and
     * is thrown on; learning can go on afterwards.
     */
    template <class Simulate, class Progress = NoProgress>
    Returned<Region> learn(Numbers instances, Simulate &&simulate, Progress &&progress = {}) {
        using Answer = std::invoke_result_t<Simulate &, const double *, const double *>;
        static_assert(std::is_convertible_v<Answer, Outcome>,
                      "simulate returns a bool or a critreg_outcome");
        static_assert(
            std::is_same_v<std::invoke_result_t<Progress &, const critreg_report &>, Status>,
            "progress returns a critreg::Status");
        struct Call {
            std::remove_reference_t<Simulate> &simulate;
            std::remove_reference_t<Progress> &progress;
            detail::Caught caught;
        } call{simulate, progress, {}};
        auto simulated = [](void *user_data, const double *instance, const double *theta,
                            critreg_outcome *outcome) -> critreg_status {
            Call &own = *static_cast<Call *>(user_data);
            return own.caught.run([&]() -> critreg_status {
                *outcome = Outcome(own.simulate(instance, theta)).number();
                return CRITREG_OK;
            });
        };
        auto progressed = [](void *user_data, const critreg_report *report) -> critreg_status {
            Call &own = *static_cast<Call *>(user_data);
            return own.caught.run([&] { return code(own.progress(*report)); });
        };
        listener_->call = progressed;
        listener_->data = &call;
        const critreg_region *region = nullptr;
        const Failure failure = with(instances, [&](std::size_t count) {
            return critreg_learn_region(handle(), instances.data(), count, simulated, &call,
                                        &region);
        });
        listener_->call = nullptr;
        call.caught.rethrow();
        return Region::copy(failure, region);
    }

    /** The sample to try next. */
    [[nodiscard]] Returned<Query> ask(Numbers instances) {
        Query query{0, std::vector<double>(parameter_count_)};
        const Failure failure = ask_into(instances, query.instance, query.theta);
        return Errors::give(failure, [&] { return std::move(query); });
    }

    /** Writes the sample to try next; the index of its instance. Does not allocate. */
    [[nodiscard]] Returned<std::size_t> ask(Numbers instances, Room theta) {
        std::size_t instance = 0;
        const Failure failure = ask_into(instances, instance, theta);
        return Errors::give(failure, [&] { return instance; });
    }

    /** What came of it. */
    Returned<void> tell(Numbers instances, Outcome outcome) {
        return told(with(instances, [&](std::size_t count) {
            return critreg_tell(handle(), instances.data(), count, outcome.number());
        }));
    }

    /** Up to so many samples to try at once, by several workers; none if none is worth it. */
    [[nodiscard]] Returned<std::vector<Question>> ask_many(Numbers instances, std::size_t wanted) {
        Questions questions(wanted, parameter_count_);
        const Failure failure = with(instances, [&](std::size_t count) {
            return critreg_ask_many(handle(), instances.data(), count, questions.wanted,
                                    questions.ids.data(), questions.numbers.data(),
                                    questions.thetas.data(), &questions.given);
        });
        return Errors::give(failure, [&] { return questions.list(parameter_count_); });
    }

    /** What came of a question, in any order. */
    Returned<void> tell_id(Numbers instances, std::uint64_t id, Outcome outcome) {
        return told(with(instances, [&](std::size_t count) {
            return critreg_tell_id(handle(), instances.data(), count, id, outcome.number());
        }));
    }

    /** Waits no longer for the answer to a question. */
    Returned<void> forget(std::uint64_t id) { return told(explained(critreg_forget(handle(), id))); }

    /** The questions that wait for an answer, also of a run that was resumed. */
    [[nodiscard]] Returned<std::vector<Question>> open_questions() {
        Questions questions(CRITREG_MAX_QUESTIONS, parameter_count_);
        const Failure failure = explained(critreg_open_questions(
            handle(), questions.wanted, questions.ids.data(), questions.numbers.data(),
            questions.thetas.data(), &questions.given));
        return Errors::give(failure, [&] { return questions.list(parameter_count_); });
    }

    /** What came of a sample that was not asked for: of a log, or a demonstration. */
    Returned<void> observe(Numbers instances, std::size_t instance, Numbers theta,
                           Outcome outcome) {
        const Failure failure = detail::first(fits(theta.size()), [&] {
            return with(instances, [&](std::size_t count) {
                return critreg_observe(handle(), instances.data(), count, instance, theta.data(),
                                       outcome.number());
            });
        });
        return told(failure);
    }

    /** The same of a query. */
    Returned<void> observe(Numbers instances, const Query &query, Outcome outcome) {
        return observe(instances, query.instance, query.theta, outcome);
    }

    /** Brings the region up to date with everything that was told, before it is asked for. */
    Returned<void> conclude(Numbers instances) {
        return told(with(instances, [&](std::size_t count) {
            return critreg_conclude(handle(), instances.data(), count);
        }));
    }

    /** Whether there is nothing more to ask. */
    [[nodiscard]] Returned<bool> is_finished() const {
        std::int32_t finished = 0;
        const critreg_status status = critreg_is_finished(handle(), &finished);
        return Errors::give(Failure(status), [&] { return finished != 0; });
    }

    /** A copy of what is learned so far, with what supports it. */
    [[nodiscard]] Returned<Region> region() {
        const critreg_region *region = nullptr;
        const Failure failure = explained(critreg_learner_region(handle(), &region));
        return Region::copy(failure, region);
    }

    /** Whether the region satisfies a specification; if not, what to try next, see
     *  critreg_learner_challenge(). */
    [[nodiscard]] Returned<critreg_proof> challenge(const Region &specification, Numbers ranges,
                                                    critreg_proof proof, Room instance,
                                                    Room theta) {
        const Failure failure = detail::first(
            detail::fits(ranges.size(), 2 * specification.instance_len(), "ranges"),
            [&] {
                return detail::fits(instance.size(), specification.instance_len(), "instance");
            },
            [&] { return detail::fits(theta.size(), specification.parameter_count(), "theta"); },
            [&] {
                return explained(critreg_learner_challenge(handle(), specification.handle(),
                                                           ranges.data(), &proof,
                                                           instance.data(), theta.data()));
            });
        return Errors::give(failure, [&] { return proof; });
    }

    /** Why there is no region, or none that is exact: CRITREG_WHY_UNEXPLAINED and its like. */
    [[nodiscard]] Returned<Why> why() {
        Why why;
        const critreg_status status =
            detail::fill_text(why.text, [&](char *text, std::size_t len, std::size_t *needed) {
                return critreg_learner_why(handle(), &why.code, text, len, needed);
            });
        return Errors::give(explained(status), [&] { return std::move(why); });
    }

    /** How learning went so far. */
    [[nodiscard]] Returned<critreg_report> report() const {
        critreg_report report;
        const Failure failure =
            detail::first(Failure(critreg_report_init(&report, sizeof report)),
                          [&] { return critreg_learner_report(handle(), &report); });
        return Errors::give(failure, [&] { return report; });
    }

    /** A picture of what is learned and was told so far of one of the instances, as SVG. */
    [[nodiscard]] Returned<std::string> to_svg(Numbers instances, std::size_t index) {
        std::string text;
        const Failure failure = with(instances, [&](std::size_t count) {
            return detail::fill_text(text, [&](char *into, std::size_t len, std::size_t *needed) {
                return critreg_learner_to_svg(handle(), instances.data(), count, index, into, len,
                                              needed);
            });
        });
        return Errors::give(failure, [&] { return std::move(text); });
    }

    /** What was told so far, as bytes. */
    [[nodiscard]] Returned<std::vector<std::uint8_t>> save(Numbers instances) {
        std::vector<std::uint8_t> bytes;
        const Failure failure = with(instances, [&](std::size_t count) {
            return detail::fill(bytes, [&](std::uint8_t *into, std::size_t len, std::size_t *need) {
                return critreg_learner_save(handle(), instances.data(), count, into, len, need);
            });
        });
        return Errors::give(failure, [&] { return std::move(bytes); });
    }

    /** Brings a fresh learner to the state that save() wrote. */
    Returned<void> resume(Numbers instances, Bytes bytes) {
        return told(with(instances, [&](std::size_t count) {
            return critreg_learner_resume(handle(), instances.data(), count, bytes.data(),
                                          bytes.size());
        }));
    }

    /** What is to be appended to a journal that has the first so many observations. */
    [[nodiscard]] Returned<std::vector<std::uint8_t>> journal(Numbers instances,
                                                              std::size_t from) {
        std::vector<std::uint8_t> bytes;
        const Failure failure = with(instances, [&](std::size_t count) {
            return detail::fill(bytes, [&](std::uint8_t *into, std::size_t len, std::size_t *need) {
                return critreg_learner_journal(handle(), instances.data(), count, from, into, len,
                                               need);
            });
        });
        return Errors::give(failure, [&] { return std::move(bytes); });
    }

    /** Brings a fresh learner to the state that a journal tells of. Returns how many of its
     *  bytes stand; what is behind was torn. */
    Returned<std::size_t> resume_journal(Numbers instances, Bytes bytes) {
        std::size_t stands = 0;
        const Failure failure = with(instances, [&](std::size_t count) {
            return critreg_learner_resume_journal(handle(), instances.data(), count, bytes.data(),
                                                  bytes.size(), &stands);
        });
        return Errors::give(failure, [&] { return stands; });
    }

    /** For functions of critreg.h; NULL if the learner was moved away. */
    [[nodiscard]] critreg_learner *handle() const noexcept {
        return reinterpret_cast<critreg_learner *>(memory_.get());
    }

private:
    /** The progress callback of the configuration, and that of learn() while it runs. */
    struct Listener {
        critreg_progress configured;
        void *configured_data;
        critreg_progress call;
        void *data;

        static critreg_status hear(void *own, const critreg_report *report) {
            const Listener &listener = *static_cast<Listener *>(own);
            const critreg_status status =
                listener.configured == nullptr
                    ? CRITREG_OK
                    : listener.configured(listener.configured_data, report);
            if (status != CRITREG_OK || listener.call == nullptr) return status;
            return listener.call(listener.data, report);
        }
    };

    /** Room for questions, as critreg.h writes them. */
    struct Questions {
        std::size_t wanted, given = 0;
        std::vector<std::uint64_t> ids;
        std::vector<std::size_t> numbers;
        std::vector<double> thetas;

        Questions(std::size_t most, std::size_t parameters)
            : wanted(std::min<std::size_t>(most, CRITREG_MAX_QUESTIONS)), ids(wanted),
              numbers(wanted), thetas(wanted * parameters) {}

        std::vector<Question> list(std::size_t parameters) const {
            std::vector<Question> all;
            for (std::size_t i = 0; i < given; i++) {
                const double *theta = thetas.data() + i * parameters;
                all.push_back({ids[i], numbers[i], {theta, theta + parameters}});
            }
            return all;
        }
    };

    BasicLearner() = default;

    static Failure complaint(const std::string &domain) {
        return detail::complaint([&](char *words, std::size_t len, std::size_t *needed) {
            return critreg_check_domain(domain.c_str(), words, len, needed);
        });
    }

    static Returned<void> told(const Failure &failure) {
        return Errors::give(failure, [] {});
    }

    /** A failure in the words of the learner. */
    Failure explained(critreg_status status) const {
        return detail::explained(
            status, [this](char *text, std::size_t len, std::size_t *needed) {
                return critreg_learner_message(handle(), text, len, needed);
            });
    }

    /** Calls a function with the number of instances. */
    template <class Call> Failure with(Numbers instances, Call call) const {
        // Where a domain has no objects there is one instance, without numbers.
        const std::size_t len = std::max<std::size_t>(instance_len_, 1);
        if (instances.size() % len != 0 || (instance_len_ == 0 && instances.size() != 0))
            return {Status::invalid_argument,
                    "the instances have " + std::to_string(instances.size()) +
                        " numbers, which is no multiple of " + std::to_string(instance_len_)};
        return explained(call(instance_len_ == 0 ? 1 : instances.size() / len));
    }

    Failure fits(std::size_t given) const {
        return detail::fits(given, parameter_count_, "theta");
    }

    Failure ask_into(Numbers instances, std::size_t &instance, Room theta) {
        return detail::first(fits(theta.size()), [&] {
            return with(instances, [&](std::size_t count) {
                return critreg_ask(handle(), instances.data(), count, &instance, theta.data());
            });
        });
    }

    std::unique_ptr<Listener> listener_;
    detail::Memory memory_;     // the handle lies at its start
    std::size_t instance_len_ = 0;
    std::size_t parameter_count_ = 0;
};

namespace nothrow {
using Learner = BasicLearner<Returning>;
} // namespace nothrow

#if CRITREG_EXCEPTIONS
using Learner = BasicLearner<Throwing>;
#endif

} // namespace critreg

#endif
