/**
 * @file critreg_region.hpp
 * Regions for C++17; see critreg.hpp.
 */
#ifndef CRITREG_REGION_HPP
#define CRITREG_REGION_HPP

#include <array>

#include "critreg_support.hpp"

namespace critreg {

/** A constraint of a region: its text, the name of its bound, what supports it. */
struct Constraint {
    std::string text;               /**< As in the text of the region. */
    std::string name;               /**< Empty if the bound has none. */
    critreg_constraint evidence;    /**< has_evidence is 0 if none is known. */
};

/** Parameters that were drawn; or none, and status() says why. */
class Sample : public std::optional<std::vector<double>> {
public:
    explicit Sample(std::vector<double> theta) : optional(std::move(theta)) {}
    explicit Sample(Status none) : status_(none) {}

    /** Status::ok; Status::empty_region: proven that there are none; Status::no_sample:
     *  none were found. */
    [[nodiscard]] Status status() const noexcept { return status_; }

private:
    Status status_ = Status::ok;
};

namespace detail {

inline Failure constraint(const critreg_region *region, std::size_t index, Constraint &into) {
    return first(
        Failure(critreg_constraint_init(&into.evidence, sizeof into.evidence)),
        [&] { return critreg_region_constraint(region, index, &into.evidence); },
        [&] {
            return fill_text(into.text, [=](char *text, std::size_t len, std::size_t *needed) {
                return critreg_region_constraint_format(region, index, text, len, needed);
            });
        },
        [&] {
            return fill_text(into.name, [=](char *text, std::size_t len, std::size_t *needed) {
                return critreg_region_constraint_name(region, index, text, len, needed);
            });
        });
}

inline Failure constraints(const critreg_region *region, std::vector<Constraint> &into) {
    std::size_t count = 0;
    Failure failure(critreg_region_constraint_count(region, &count));
    into.resize(count);
    for (std::size_t i = 0; i < count && !failure; i++) failure = constraint(region, i, into[i]);
    return failure;
}

inline critreg_status save(const critreg_region *region, std::vector<std::uint8_t> &bytes) {
    return fill(bytes, [=](std::uint8_t *into, std::size_t len, std::size_t *needed) {
        return critreg_region_save(region, into, len, needed);
    });
}

inline bool found_none(critreg_status status) {
    return status == CRITREG_EMPTY_REGION || status == CRITREG_NO_SAMPLE;
}

} // namespace detail

/**
 * A region. Copies share its memory, which nothing changes, and it may be used by several
 * threads at once.
 */
template <class Errors> class BasicRegion {
    template <class T> using Returned = typename Errors::template Returned<T>;

public:
    /** Reads a region text; the error tells line and column. */
    [[nodiscard]] static Returned<BasicRegion> parse(const std::string &domain,
                                                     const std::string &text) {
        BasicRegion region;
        const Failure failure = detail::first(
            detail::complaint([&](char *words, std::size_t len, std::size_t *needed) {
                return critreg_check_region(domain.c_str(), text.c_str(), words, len, needed);
            }),
            [&] {
                return region.make([&](void *memory, std::size_t len, critreg_region **handle) {
                    return critreg_region_parse(memory, len, domain.c_str(), text.c_str(), handle);
                });
            });
        return Errors::give(failure, [&] { return region; });
    }

    /** Reads what save() wrote. */
    [[nodiscard]] static Returned<BasicRegion> load(Bytes bytes) {
        BasicRegion region;
        const Failure failure = region.load_into(bytes);
        return Errors::give(failure, [&] { return region; });
    }

    /** A copy of a region of critreg.h, such as one of a learner, with what supports it. */
    [[nodiscard]] static Returned<BasicRegion> copy(const critreg_region *own) {
        return copy({}, own);
    }

    /** The same, unless getting that region failed. */
    [[nodiscard]] static Returned<BasicRegion> copy(const Failure &before,
                                                    const critreg_region *own) {
        BasicRegion region;
        std::vector<std::uint8_t> bytes;
        const Failure failure = detail::first(
            before, [&] { return detail::save(own, bytes); },
            [&] { return region.load_into(bytes); },
            [&] { return critreg_region_quality(own, &region.made_->quality); },
            [&] { return detail::constraints(own, region.made_->constraints); });
        return Errors::give(failure, [&] { return region; });
    }

    /** The region and its domain as bytes. */
    [[nodiscard]] Returned<std::vector<std::uint8_t>> save() const {
        std::vector<std::uint8_t> bytes;
        const critreg_status status = detail::save(handle(), bytes);
        return Errors::give(Failure(status), [&] { return std::move(bytes); });
    }

    /** The region as text. */
    [[nodiscard]] Returned<std::string> text() const {
        std::string text;
        const critreg_status status =
            detail::fill_text(text, [this](char *into, std::size_t len, std::size_t *needed) {
                return critreg_region_format(handle(), into, len, needed);
            });
        return Errors::give(Failure(status), [&] { return std::move(text); });
    }

    /** Its constraints, from left to right; a learned region knows what supports them. */
    [[nodiscard]] const std::vector<Constraint> &constraints() const noexcept {
        return made_->constraints;
    }

    /** CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL; CRITREG_NO_QUALITY if it was
     *  not learned by this program. */
    [[nodiscard]] std::uint32_t quality() const noexcept { return made_->quality; }

    /** How many numbers an instance has. */
    [[nodiscard]] std::size_t instance_len() const noexcept { return made_->instance_len; }

    /** How many parameters the action has. */
    [[nodiscard]] std::size_t parameter_count() const noexcept { return made_->parameter_count; }

    /** Whether an action with these parameters is expected to work. Does not allocate. */
    [[nodiscard]] Returned<bool> contains(Numbers instance, Numbers theta) const {
        std::int32_t inside = 0;
        const Failure failure = detail::first(
            fits(instance), [&] { return fits_theta(theta.size()); },
            [&] {
                return critreg_region_contains(handle(), instance.data(), theta.data(), &inside);
            });
        return Errors::give(failure, [&] { return inside != 0; });
    }

    /** The same of many samples, one behind the other: writes 1 or 0 for each. Does not
     *  allocate. */
    Returned<void> contains(Numbers instance, Numbers thetas, Span<std::uint8_t> inside) const {
        const Failure failure = detail::first(
            fits(instance),
            [&] {
                return detail::fits(thetas.size(), inside.size() * parameter_count(), "thetas");
            },
            [&] {
                return critreg_region_contains_many(handle(), instance.data(), thetas.data(),
                                                    inside.size(), inside.data());
            });
        return Errors::give(failure, [] {});
    }

    /** For optimisers: writes for each constraint a value that is at most 0 where it holds, and
     *  its gradient by the parameters, one behind the other. Does not allocate. */
    Returned<void> margins(Numbers instance, Numbers theta, Room values, Room gradients) const {
        const std::size_t count = constraints().size();
        const Failure failure = detail::first(
            fits(instance), [&] { return fits_theta(theta.size()); },
            [&] { return detail::fits(values.size(), count, "values"); },
            [&] {
                return detail::fits(gradients.size(), count * parameter_count(), "gradients");
            },
            [&] {
                return critreg_region_margins(handle(), instance.data(), theta.data(),
                                              values.data(), gradients.data());
            });
        return Errors::give(failure, [] {});
    }

    /** Whether all that it admits satisfies a specification, in every instance whose numbers
     *  are in ranges, a lower and an upper end for each; proof tells what it may cost, from
     *  default_proof(). A counterexample is written to instance and theta. Does not
     *  allocate. */
    [[nodiscard]] Returned<critreg_proof> implies(const BasicRegion &specification,
                                                  Numbers ranges, critreg_proof proof,
                                                  Room instance, Room theta) const {
        const Failure failure = detail::first(
            detail::fits(ranges.size(), 2 * instance_len(), "ranges"),
            [&] { return detail::fits(instance.size(), instance_len(), "instance"); },
            [&] { return fits_theta(theta.size()); },
            [&] {
                return critreg_region_implies(handle(), specification.handle(), ranges.data(),
                                              &proof, instance.data(), theta.data());
            });
        return Errors::give(failure, [&] { return proof; });
    }

    /** What a proof may cost by default. */
    [[nodiscard]] static critreg_proof default_proof() noexcept {
        critreg_proof proof;
        (void)critreg_proof_init(&proof, sizeof proof);
        return proof;
    }

    /** The questions of implies() as SMT-LIB 2, for another prover: one for each statement of
     *  the specification, and for each member of a group that this is about. */
    [[nodiscard]] Returned<std::vector<std::string>>
    to_smt2(const BasicRegion &specification, Numbers ranges,
            critreg_proof proof = default_proof()) const {
        std::vector<std::string> questions;
        std::size_t count = 0;
        Failure failure = detail::first(
            detail::fits(ranges.size(), 2 * instance_len(), "ranges"),
            [&] { return critreg_region_question_count(specification.handle(), &count); });
        questions.resize(failure ? 0 : count);
        for (std::size_t number = 0; !failure && number < count; number++)
            failure = Failure(detail::fill_text(
                questions[number], [&](char *into, std::size_t len, std::size_t *needed) {
                    return critreg_region_to_smt2(handle(), specification.handle(),
                                                  ranges.data(), &proof, number, into, len,
                                                  needed);
                }));
        return Errors::give(failure, [&] { return std::move(questions); });
    }

    /** The region as C that needs no library, in functions whose names begin with name. */
    [[nodiscard]] Returned<std::string> to_c(const std::string &name) const {
        std::string text;
        const critreg_status status =
            detail::fill_text(text, [&](char *into, std::size_t len, std::size_t *needed) {
                return critreg_region_to_c(handle(), name.c_str(), into, len, needed);
            });
        return Errors::give(Failure(status), [&] { return std::move(text); });
    }

    /** The region as a module of Rust, which computes with CRITREG_F64 or CRITREG_F32. */
    [[nodiscard]] Returned<std::string> to_rust(std::uint32_t precision = CRITREG_F64) const {
        std::string text;
        const critreg_status status =
            detail::fill_text(text, [&](char *into, std::size_t len, std::size_t *needed) {
                return critreg_region_to_rust(handle(), precision, into, len, needed);
            });
        return Errors::give(Failure(status), [&] { return std::move(text); });
    }

    /** A picture of the region in an instance, as SVG. */
    [[nodiscard]] Returned<std::string> to_svg(Numbers instance) const {
        std::string text;
        const Failure failure = detail::first(fits(instance), [&] {
            return detail::fill_text(text, [&](char *into, std::size_t len, std::size_t *needed) {
                return critreg_region_to_svg(handle(), instance.data(), into, len, needed);
            });
        });
        return Errors::give(failure, [&] { return std::move(text); });
    }

    /** Whether it is proven that it has no parameters in an instance. Does not allocate. */
    [[nodiscard]] Returned<bool> is_empty(Numbers instance) const {
        std::int32_t empty = 0;
        const Failure failure = detail::first(fits(instance), [&] {
            return critreg_region_is_empty(handle(), instance.data(), &empty);
        });
        return Errors::give(failure, [&] { return empty != 0; });
    }

    /** Writes the admitted intervals of the action's only parameter, the ends of each, where
     *  there is room for 2 * CRITREG_MAX_INTERVALS numbers; how many. Does not allocate. */
    [[nodiscard]] Returned<std::size_t> intervals(Numbers instance, Room ends) const {
        std::size_t count = 0;
        const Failure failure = detail::first(fits(instance), [&] {
            return critreg_region_intervals(handle(), instance.data(), ends.data(),
                                            ends.size() / 2, &count);
        });
        return Errors::give(failure, [&] { return count; });
    }

    /** The admitted intervals of the action's only parameter. */
    [[nodiscard]] Returned<std::vector<std::pair<double, double>>>
    intervals(Numbers instance) const {
        std::array<double, 2 * CRITREG_MAX_INTERVALS> ends{};
        std::size_t count = 0;
        const Failure failure = detail::first(fits(instance), [&] {
            return critreg_region_intervals(handle(), instance.data(), ends.data(),
                                            CRITREG_MAX_INTERVALS, &count);
        });
        return Errors::give(failure, [&] {
            std::vector<std::pair<double, double>> intervals;
            for (std::size_t i = 0; i < 2 * count; i += 2)
                intervals.emplace_back(ends[i], ends[i + 1]);
            return intervals;
        });
    }

    /** Parameters from the region. */
    [[nodiscard]] Returned<Sample> sample(Numbers instance, Rng &rng) const {
        std::vector<double> theta(parameter_count());
        critreg_status status = CRITREG_OK;
        const Failure failure = draw(instance, rng, theta, status);
        return Errors::give(failure, [&] {
            return detail::found_none(status) ? Sample(static_cast<Status>(status))
                                              : Sample(std::move(theta));
        });
    }

    /** Writes parameters from the region; Status::ok, Status::empty_region or
     *  Status::no_sample. Does not allocate. */
    [[nodiscard]] Returned<Status> sample(Numbers instance, Rng &rng, Room theta) const {
        critreg_status status = CRITREG_OK;
        const Failure failure = draw(instance, rng, theta, status);
        return Errors::give(failure, [&] { return static_cast<Status>(status); });
    }

    /** Writes as many samples as find room, one behind the other; how many were drawn before
     *  one was not found. Does not allocate. */
    [[nodiscard]] Returned<std::size_t> sample_many(Numbers instance, Rng &rng,
                                                    Room thetas) const {
        const std::size_t numbers = parameter_count();
        std::size_t drawn = 0;
        critreg_status status = CRITREG_OK;
        const Failure failure = detail::first(fits(instance), [&] {
            status = critreg_sample_region_many(handle(), instance.data(),
                                                numbers == 0 ? 0 : thetas.size() / numbers,
                                                &rng.state, thetas.data(), &drawn);
            return detail::found_none(status) ? CRITREG_OK : status;
        });
        return Errors::give(failure, [&] { return drawn; });
    }

    /** For functions of critreg.h. */
    [[nodiscard]] const critreg_region *handle() const noexcept {
        return reinterpret_cast<const critreg_region *>(made_->memory.get());
    }

private:
    struct Made {
        detail::Memory memory;
        std::vector<Constraint> constraints;
        std::uint32_t quality = CRITREG_NO_QUALITY;
        std::size_t instance_len = 0, parameter_count = 0;
    };

    BasicRegion() : made_(std::make_shared<Made>()) {}

    /** Makes the handle, and asks it what does not change. */
    template <class Make> Failure make(Make make_handle) {
        const std::size_t bytes = critreg_region_size();
        made_->memory = detail::memory(bytes);
        critreg_region *own = nullptr;
        return detail::first(
            Failure(make_handle(made_->memory.get(), bytes, &own)),
            [&] { return critreg_region_instance_len(own, &made_->instance_len); },
            [&] { return critreg_region_parameter_count(own, &made_->parameter_count); },
            [&] { return detail::constraints(own, made_->constraints); });
    }

    Failure load_into(Bytes bytes) {
        return make([&](void *memory, std::size_t len, critreg_region **own) {
            return critreg_region_load(memory, len, bytes.data(), bytes.size(), own);
        });
    }

    Failure fits(Numbers instance) const {
        return detail::fits(instance.size(), instance_len(), "the instance");
    }

    Failure fits_theta(std::size_t given) const {
        return detail::fits(given, parameter_count(), "theta");
    }

    Failure draw(Numbers instance, Rng &rng, Room theta, critreg_status &status) const {
        return detail::first(
            fits(instance), [&] { return fits_theta(theta.size()); },
            [&] {
                status = critreg_sample_region(handle(), instance.data(), &rng.state, theta.data());
                return detail::found_none(status) ? CRITREG_OK : status;
            });
    }

    std::shared_ptr<Made> made_;
};

/** A region, and the instance to ground it in. */
template <class Errors> struct BasicPart {
    BasicRegion<Errors> region;
    std::vector<double> instance;
};

namespace detail {

/** What critreg.h takes of several regions. */
template <class Errors> struct Parts {
    std::array<const critreg_region *, CRITREG_MAX_REGIONS> regions{};
    std::array<const double *, CRITREG_MAX_REGIONS> instances{};
    std::size_t count;
    std::size_t parameter_count = 0;
    Failure failure = {};

    explicit Parts(Span<const BasicPart<Errors>> parts) : count(parts.size()) {
        if (count > CRITREG_MAX_REGIONS) failure = Failure(CRITREG_CAPACITY_EXCEEDED);
        std::size_t at = 0;
        for (const BasicPart<Errors> &part : parts) {
            if (failure) return;
            failure = fits(part.instance.size(), part.region.instance_len(), "an instance");
            regions[at] = part.region.handle();
            instances[at++] = part.instance.data();
            parameter_count = part.region.parameter_count();
        }
    }

    typename Errors::template Returned<Sample> sample(Rng &rng) const {
        std::vector<double> theta(parameter_count);
        critreg_status status = CRITREG_OK;
        const Failure drawn = first(failure, [&] {
            status = critreg_sample_regions(regions.data(), instances.data(), count, &rng.state,
                                            theta.data());
            return found_none(status) ? CRITREG_OK : status;
        });
        return Errors::give(drawn, [&] {
            return found_none(status) ? Sample(static_cast<Status>(status))
                                      : Sample(std::move(theta));
        });
    }

    typename Errors::template Returned<bool> are_empty() const {
        std::int32_t empty = 0;
        const Failure asked = first(failure, [&] {
            return critreg_regions_are_empty(regions.data(), instances.data(), count, &empty);
        });
        return Errors::give(asked, [&] { return empty != 0; });
    }
};

} // namespace detail

namespace nothrow {

using Region = BasicRegion<Returning>;
using Part = BasicPart<Returning>;

/** Parameters that several regions admit, each in an instance of its own. */
[[nodiscard]] inline Result<Sample> sample(Span<const Part> parts, Rng &rng) {
    return detail::Parts<Returning>(parts).sample(rng);
}

/** Whether it is proven that they admit none together. */
[[nodiscard]] inline Result<bool> are_empty(Span<const Part> parts) {
    return detail::Parts<Returning>(parts).are_empty();
}

} // namespace nothrow

#if CRITREG_EXCEPTIONS

using Region = BasicRegion<Throwing>;
using Part = BasicPart<Throwing>;

/** Parameters that several regions admit, each in an instance of its own. */
[[nodiscard]] inline Sample sample(Span<const Part> parts, Rng &rng) {
    return detail::Parts<Throwing>(parts).sample(rng);
}

/** Whether it is proven that they admit none together. */
[[nodiscard]] inline bool are_empty(Span<const Part> parts) {
    return detail::Parts<Throwing>(parts).are_empty();
}

#endif

} // namespace critreg

#endif
