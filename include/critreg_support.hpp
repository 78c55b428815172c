/**
 * @file critreg_support.hpp
 * What the parts of critreg.hpp share: statuses, errors, views of numbers, random numbers.
 */
#ifndef CRITREG_SUPPORT_HPP
#define CRITREG_SUPPORT_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "critreg.h"

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define CRITREG_EXCEPTIONS 1
#include <stdexcept>
#else
#define CRITREG_EXCEPTIONS 0
#endif

namespace critreg {

/** What became of a call. Codes of the program begin with user. */
enum class Status : critreg_status {
    ok = CRITREG_OK,
    null_pointer = CRITREG_NULL_POINTER,
    misaligned = CRITREG_MISALIGNED,
    too_small = CRITREG_TOO_SMALL,
    invalid_argument = CRITREG_INVALID_ARGUMENT,
    not_finite = CRITREG_NOT_FINITE,
    syntax_error = CRITREG_SYNTAX_ERROR,
    capacity_exceeded = CRITREG_CAPACITY_EXCEEDED,
    empty_region = CRITREG_EMPTY_REGION,
    no_sample = CRITREG_NO_SAMPLE,
    no_region = CRITREG_NO_REGION,
    out_of_sequence = CRITREG_OUT_OF_SEQUENCE,
    mismatch = CRITREG_MISMATCH,
    corrupt = CRITREG_CORRUPT,
    busy = CRITREG_BUSY,
    cancelled = CRITREG_CANCELLED,
    not_a_handle = CRITREG_NOT_A_HANDLE,
    no_plan = CRITREG_NO_PLAN,
    user = CRITREG_USER_STATUS,
};

/** The number that critreg.h has for a status. */
[[nodiscard]] constexpr critreg_status code(Status status) noexcept {
    return static_cast<critreg_status>(status);
}

/** The name of a status as it stands in critreg.h, such as "CRITREG_BUSY". */
[[nodiscard]] inline const char *name(Status status) noexcept {
    return critreg_status_name(code(status));
}

/** What a status means, in a few words of English. */
[[nodiscard]] inline const char *words(Status status) noexcept {
    return critreg_strerror(code(status));
}

/** The version of the library that runs, such as "0.1.0". */
[[nodiscard]] inline const char *version() noexcept { return critreg_version(); }

/** Its CRITREG_ABI_VERSION. */
[[nodiscard]] inline std::uint32_t abi_version() noexcept { return critreg_abi_version(); }

/** What it was built with: CRITREG_HAS_F64 and its like. */
[[nodiscard]] inline std::uint32_t capabilities() noexcept { return critreg_capabilities(); }

/** How a call failed, if it did: the status, and why in words. */
struct Failure {
    Status status = Status::ok;
    std::string message = {};

    Failure() = default;
    /** A status of critreg.h, in its own words. */
    explicit Failure(critreg_status of)
        : status(static_cast<Status>(of)), message(of == CRITREG_OK ? "" : critreg_strerror(of)) {}
    Failure(Status of, std::string why) : status(of), message(std::move(why)) {}

    /** Whether it failed. */
    explicit operator bool() const noexcept { return status != Status::ok; }
};

/** What a call gives that does not throw: a value, or how it failed. */
template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)) {}
    Result(Failure failure) : failure_(std::move(failure)) {}

    /** Whether there is a value. */
    explicit operator bool() const noexcept { return value_.has_value(); }
    Status status() const noexcept { return failure_.status; }
    /** Why there is no value; empty if there is one. */
    const std::string &message() const noexcept { return failure_.message; }

    /** The value, which there must be. */
    T &operator*() & noexcept { return *value_; }
    const T &operator*() const & noexcept { return *value_; }
    T &&operator*() && noexcept { return std::move(*value_); }
    T *operator->() noexcept { return &*value_; }
    const T *operator->() const noexcept { return &*value_; }

private:
    Failure failure_;
    std::optional<T> value_;
};

/** Of a call that gives nothing but its status. */
template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Failure failure) : failure_(std::move(failure)) {}

    /** Whether it did what it promises. */
    explicit operator bool() const noexcept { return !failure_; }
    Status status() const noexcept { return failure_.status; }
    const std::string &message() const noexcept { return failure_.message; }

private:
    Failure failure_;
};

/** How the classes in critreg::nothrow tell what failed: everything gives a Result. */
struct Returning {
    template <class T> using Returned = Result<T>;

    template <class Make> static auto give(Failure failure, Make make) -> Result<decltype(make())> {
        if (failure) return failure;
        if constexpr (std::is_void_v<decltype(make())>) {
            make();
            return {};
        } else {
            return make();
        }
    }
};

#if CRITREG_EXCEPTIONS

/** A call that failed: its status, and in what() why. */
class Error : public std::runtime_error {
public:
    explicit Error(const Failure &failure)
        : std::runtime_error(failure.message), status_(failure.status) {}
    Error(Status status, const std::string &why) : Error(Failure(status, why)) {}

    /** The status of the call. */
    [[nodiscard]] Status status() const noexcept { return status_; }

private:
    Status status_;
};

/** How the others tell it: by an Error. */
struct Throwing {
    template <class T> using Returned = T;

    template <class Make> static auto give(const Failure &failure, Make make) -> decltype(make()) {
        if (failure) throw Error(failure);
        return make();
    }
};

#endif

/**
 * Numbers of somebody else: a pointer and a length. A vector, an array, a std::span or
 * {1.0, 2.0} is one. It must not outlive them.
 */
template <class T> class Span {
public:
    constexpr Span() noexcept = default;
    constexpr Span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}

    template <class Container,
              class = std::enable_if_t<
                  !std::is_same_v<std::decay_t<Container>, Span> &&
                  std::is_convertible_v<
                      std::remove_pointer_t<decltype(std::data(std::declval<Container &>()))> (*)[],
                      T (*)[]>>>
    constexpr Span(Container &&container) noexcept
        : data_(std::data(container)), size_(std::size(container)) {}

    template <class U = T, class = std::enable_if_t<std::is_const_v<U>>>
    constexpr Span(std::initializer_list<std::remove_const_t<U>> list) noexcept {
        data_ = list.begin();   // As an argument it lives until the call is over.
        size_ = list.size();
    }

    [[nodiscard]] constexpr T *data() const noexcept { return data_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr T *begin() const noexcept { return data_; }
    [[nodiscard]] constexpr T *end() const noexcept { return data_ + size_; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/** Numbers that are read. */
using Numbers = Span<const double>;
/** Room for numbers that are written. */
using Room = Span<double>;
/** Bytes that are read. */
using Bytes = Span<const std::uint8_t>;

/**
 * A generator of random numbers, the same on every machine; copies go on with the same
 * numbers. It is a UniformRandomBitGenerator, for the distributions of the standard library.
 */
class Rng {
public:
    using result_type = std::uint32_t;

    explicit Rng(std::uint64_t seed) noexcept : state(critreg_rng_seed(seed)) {}
    explicit Rng(critreg_rng own) noexcept : state(own) {}

    /** A number uniform in [0, 1). */
    double uniform() noexcept {
        double number = 0.0;
        critreg_rng_uniform(&state, &number);   // Cannot fail with these.
        return number;
    }

    static constexpr result_type min() noexcept { return 0; }
    static constexpr result_type max() noexcept { return std::numeric_limits<result_type>::max(); }

    /** 32 random bits. */
    result_type operator()() noexcept { return static_cast<result_type>(uniform() * 4294967296.0); }

    /** For functions of critreg.h. */
    critreg_rng state;
};

/**
 * What came of a trial: a bool, whether the action worked, or a critreg_outcome. A number
 * that is none stays none, and is refused.
 */
class Outcome {
public:
    template <class T, class = std::enable_if_t<std::is_integral_v<T>>>
    constexpr Outcome(T told) noexcept
        : number_(static_cast<T>(static_cast<critreg_outcome>(told)) == told
                      ? static_cast<critreg_outcome>(told)
                      : CRITREG_NO_OUTCOME) {}

    /** The number that critreg.h has for it. */
    [[nodiscard]] constexpr critreg_outcome number() const noexcept { return number_; }

private:
    critreg_outcome number_;
};

namespace detail {

/** The memory of a handle, which lies at its start. */
using Memory = std::unique_ptr<std::uint64_t[]>;

inline Memory memory(std::size_t bytes) {
    return Memory(new std::uint64_t[bytes / sizeof(std::uint64_t) + 1]);
}

/** Calls a function that fills a buffer, first for the length it needs. */
template <class Buffer, class Fill> critreg_status fill(Buffer &buffer, Fill with) {
    std::size_t needed = 0;
    critreg_status status = with(nullptr, 0, &needed);
    if (status != CRITREG_OK && status != CRITREG_TOO_SMALL) return status;
    buffer.resize(needed);
    return with(buffer.data(), buffer.size(), &needed);
}

/** The same for a text, without its NUL. */
template <class Fill> critreg_status fill_text(std::string &text, Fill with) {
    const critreg_status status = fill(text, with);
    if (!text.empty()) text.pop_back();
    return status;
}

/** What a function that checks texts says of them. */
template <class Check> Failure complaint(Check check) {
    char words[256] = "";
    Failure failure(check(words, sizeof words, nullptr));
    if (failure && words[0] != '\0') failure.message = words;
    return failure;
}

/** A failure in the words of a handle, which tell about its last call that failed. */
template <class Words> Failure explained(critreg_status status, Words words) {
    Failure failure(status);
    if (!failure || status == CRITREG_BUSY || status == CRITREG_NOT_A_HANDLE) return failure;
    std::string message;
    fill_text(message, words);
    if (!message.empty()) failure.message = std::move(message);
    return failure;
}

/** Refuses a length other than the one that the library reads. */
inline Failure fits(std::size_t given, std::size_t wanted, const char *what) {
    if (given == wanted) return {};
    return {Status::invalid_argument, std::string(what) + " has " + std::to_string(given) +
                                          " numbers, where " + std::to_string(wanted) +
                                          " are wanted"};
}

/** The first failure of several checks; what comes later is not tried. */
template <class... Steps> Failure first(Failure failure, Steps... steps) {
    ((void)(failure || (failure = Failure(steps()), false)), ...);
    return failure;
}

/** What a callback threw. It must not leave it into C, so it waits until the call is over. */
class Caught {
public:
    template <class Body> critreg_status run(Body body) {
#if CRITREG_EXCEPTIONS
        try {
            return body();
        } catch (...) {
            thrown_ = std::current_exception();
            return CRITREG_USER_STATUS;
        }
#else
        return body();
#endif
    }

    void rethrow() const {
#if CRITREG_EXCEPTIONS
        if (thrown_) std::rethrow_exception(thrown_);
#endif
    }

private:
#if CRITREG_EXCEPTIONS
    std::exception_ptr thrown_;
#endif
};

} // namespace detail
} // namespace critreg

#endif
