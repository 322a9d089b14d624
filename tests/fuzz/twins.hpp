// An object and its twin. Every call is made on both with the same arguments; the first has the kernels, the parallel
// hook and the failing allocator of the day, the twin has other kernels and none of the rest.
#ifndef FUZZ_TWINS_HPP
#define FUZZ_TWINS_HPP

#include <functional>
#include <memory>
#include <string>
#include <string.h>

#include "api.hpp"
#include "heap.hpp"
#include "hooks.hpp"
#include "run.hpp"

namespace fuzz {

// What a call is known for.
enum : unsigned {
    kSteps = 1,    // may end with CD_ERROR_DIVERGED, _TOLERANCE or _CALLBACK, and has been made all the same
    kNoMemory = 2, // may neither allocate nor release
    kReads = 4,    // changes nothing, and may not allocate either
    kNoTwin = 8,   // is for the first of the two only
};

// What is known of the numbers in an object.
struct Past {
    bool moderate = true;  // nothing but moderate numbers went in
    bool crafted = false;  // it has loaded bytes that no call wrote
    bool diverged = false; // its state may hold numbers that are not finite
};

template <class Api> class Twins {
public:
    using Handle = typename Api::Handle;
    // The call to make; `which` is 0 for the first of the two and 1 for its twin.
    using Call = std::function<cd_status(Handle* handle, int which)>;

    Twins() = default;
    Twins(const Twins&) = delete;
    Twins& operator=(const Twins&) = delete;
    virtual ~Twins();

    Handle* first() const { return handles[0]; }
    Handle* twin() const { return handles[1]; }
    uint64_t hash() const { return last_hash; }

    Past past;

protected:
    cd_precision precision = CD_FLOAT64;

    virtual cd_status make(const cd_allocator* allocator, Handle** out) = 0;
    virtual void print_difference() = 0;

    void create(); // by the first constructor that can

    // Makes a call on both, with an allocation that fails now and then, and checks all that holds for every call.
    // A call whose allocation failed returns CD_ERROR_MEMORY and is not made on the twin.
    cd_status both(const std::string& what, unsigned flags, const Call& call);

    // Setters of one number, which is moderate within a range, and of an enumeration.
    struct Range {
        double least, most;
    };
    void set_number(const char* what, cd_status (*setter)(Handle*, double), double value, Range moderate,
                    unsigned flags = kNoMemory);
    void set_enum(const char* what, cd_status (*setter)(Handle*, int32_t), int32_t last, unsigned flags = 0);

    // A getter of one number, which twins must agree on unless it tells how they work.
    template <class T> void get(const char* what, cd_status (*getter)(const Handle*, T*), bool agree = true) {
        T out[2];
        memset(out, 0x5a, sizeof out);
        const bool null = pick_no_output();
        const cd_status status =
            both(what, kReads, [&](Handle* handle, int which) { return getter(handle, null ? nullptr : &out[which]); });
        if (null && status != CD_ERROR_NULL && !run.broken) problem("%s: takes null for its output", what);
        if (status == CD_OK && !null && agree) must_agree(what, &out[0], &out[1]);
    }

    // Outputs of the two must be the same bits, but for the bits of a NaN.
    template <class T> void must_agree(const char* what, const T* output, const T* twin_output, size_t count = 1) {
        for (size_t i = 0; i < count && !run.broken; ++i) {
            const bool both_nan = output[i] != output[i] && twin_output[i] != twin_output[i];
            if (!both_nan && memcmp(&output[i], &twin_output[i], sizeof(T)) != 0)
                problem("%s: outputs of twins differ at %zu", what, i);
        }
    }

    void remake_twin_empty();
    void pick_kernels(Handle* handle);

    Hook hook;

private:
    Handle* handles[2] = {};
    Heap heap, twin_heap;
    uint64_t last_hash = 0;

    static bool pick_no_output();
    uint64_t hash_of(Handle* handle);
    void check_allocator(const std::string& what);
    void check_failure(const std::string& what, cd_status status, uint64_t hash, size_t held, size_t held_before);
    void check_twin(const std::string& what, cd_status status, const Call& call);
    void create_while_memory_fails();
};

} // namespace fuzz

#endif
