// What every object has: memory, a way of stepping, a clock, and a state of numbers in a precision of its own.
#pragma once

#include <math.h>
#include <string.h>

#include "base/memory.hh"
#include "base/node.hh"
#include "contdyn/base.h"
#include "kernel/kernels.hh"

namespace cd {

// Parameters stay far enough inside double's range for products of four of them: see chain.h.
constexpr double kMost = 1e60, kLeastMass = 1e-60;
// Steps are between these [s].
constexpr double kLeastStep = 1e-30, kMostStep = 1e30;

// Time as a count of steps of one length since a start, so that it does not depend on how steps share calls.
struct Clock {
    double start, dt; // start: -0 where steps have differed in something else
    uint64_t counted; // steps of dt since start
    uint64_t steps;   // of any length since create, reset or load

    double time() const { return start + double(counted) * dt; }
    // Whether steps can have led here.
    bool is_possible() const {
        const bool of_steps = dt == 0 || (dt >= kLeastStep && dt <= kMostStep);
        return start >= 0 && start <= kMost && of_steps && counted <= steps && (dt > 0 || counted == 0);
    }
    // Whether steps have always been of this length, and alike in what else make_unlike was told of.
    bool all_alike(double step) const { return steps == 0 || (dt == step && counted == steps && !signbit(start)); }
    void make_unlike() {
        if (steps > 0 && start == 0) start = -0.0;
    }
    void advance(double step, uint64_t count) {
        if (dt != step) *this = {time(), step, 0, steps};
        counted += count;
        steps += count;
    }
};

// Of coupled solves.
constexpr double kLeastTolerance = 1e-14, kMostTolerance = 0.5;

// What is set from outside and kept with the state.
struct ObjectSettings {
    cd_method method;
    double lambda;
    Clock clock;
};

struct Object {
    uint64_t tag; // which kind of object this is, and that it lives
    Memory memory;
    cd_parallel parallel;
    cd_precision precision;
    bool diverged;

    // what steps need, none of it state
    Array<double> coefficients, scratch;
    double prepared_dt; // what those are for; 0: out of date
    uint64_t factorizations;

    // For how long each part of it has been slow [s], or kStirred: see model/sleep.hh. Empty where no part may sleep.
    Array<double> calm;
};

// Of a part that was not slow at the end of its last step, or has been woken since.
constexpr double kStirred = -1;

// Wakes `count` parts from `first`; an object that is one part has no other.
inline void wake(Object& o, size_t first, size_t count) {
    for (size_t i = first; CD_WITH_SLEEP && o.calm && i < first + count; ++i) o.calm[i % o.calm.count] = kStirred;
}
inline void wake(Object& o) { wake(o, 0, o.calm.count); }

// What steps prepare for has changed.
inline void changed(Object& o) {
    o.prepared_dt = 0;
    wake(o);
}

// What steps compute with follows from the object's settings and state alone: where its layout may be another, both
// arrays start from zeros.
inline void clear_work(Object& o) {
    for (const Array<double>& array : {o.coefficients, o.scratch})
        if (array) memset(array.data, 0, array.bytes());
}

// Whether the coefficients have to be made for steps of dt. Where more than dt has changed the layout may be another.
inline bool must_prepare(Object& o, double dt) {
    if (o.prepared_dt == dt) return false;
    if (o.prepared_dt == 0) clear_work(o);
    o.prepared_dt = dt;
    return true;
}

inline bool valid_parameter(double value) { return value >= 0 && value <= kMost; }
// Of how long a part must be slow before it sleeps [s].
inline bool valid_calm_time(double seconds) { return seconds >= kLeastStep && seconds <= kMost; }
inline bool valid_mass(double value) { return value >= kLeastMass && value <= kMost; }

inline bool is_explicit(cd_method method) {
    return method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER;
}

// ---- the state's numbers --------------------------------------------------------------------------------------------

// Whether the state's numbers are doubles; known where only one precision is built, so that the other takes no code.
inline bool is_wide(const Object& o) { return CD_WITH_FLOAT64 && (!CD_WITH_FLOAT32 || o.precision == CD_FLOAT64); }
inline size_t number_size(const Object& o) { return is_wide(o) ? sizeof(double) : sizeof(float); }

// The largest number that the object's precision holds.
inline double most_of(const Object& o) {
    return is_wide(o) ? 1.7976931348623157e308 : 3.4028234663852886e38;
}

// f(0.0) or f(0.0f), by the object's precision.
template <class F> auto by_precision(const Object& o, F f) { return is_wide(o) ? f(0.0) : f(0.0f); }

template <class T> T* numbers(const Array<char>& array) { return reinterpret_cast<T*>(array.data); }
inline StateNumbers state_of(const Object& o, const Array<char>& array) {
    return {array.data, is_wide(o)};
}

inline double get_number(const Object& o, const Array<char>& array, size_t at) {
    return is_wide(o) ? numbers<double>(array)[at] : double(numbers<float>(array)[at]);
}
inline void set_number(const Object& o, const Array<char>& array, size_t at, double value) {
    if (is_wide(o)) numbers<double>(array)[at] = value;
    else numbers<float>(array)[at] = float(value);
}

// Arrays of the state lie in rows, `pitch` numbers apart, of which the first `width` mean something.
struct Layout {
    size_t rows, width, pitch;
};

// f(number) for each of them, in their order; nothing for an array that is off.
template <class T, class F> void each_number(const Layout& layout, T* data, F f) {
    for (size_t row = 0; data && row < layout.rows; ++row)
        for (size_t i = 0; i < layout.width; ++i) f(data[row * layout.pitch + i]);
}
template <class F> void each_number(const Object& o, const Layout& layout, const Array<char>& array, F f) {
    by_precision(o, [&](auto zero) { each_number(layout, numbers<decltype(zero)>(array), f); });
}

} // namespace cd
