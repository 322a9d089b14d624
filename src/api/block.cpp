#include "api/block.hh"

#include <float.h>
#include <math.h>
#include <stdint.h>

#include <type_traits>

namespace cd {

namespace {

// f(index in the buffer, number) for each number of a block.
template <class F> void each_number(const Object& o, const Block& b, F f) {
    constexpr size_t kTile = 64; // of the middle, which stays in the cache for all that lie side by side
    by_precision(o, [&](auto zero) {
        auto* const data = numbers<decltype(zero)>(*b.array) + b.first;
        for (size_t i = 0; i < b.count[0]; ++i)
            for (size_t from = 0; from < b.count[1]; from += kTile) {
                const size_t n = from + kTile < b.count[1] ? kTile : b.count[1] - from;
                for (size_t k = 0; k < b.count[2]; ++k) {
                    size_t at = (i * b.count[1] + from) * b.count[2] + k;
                    auto* number = data + i * b.stride[0] + from * b.stride[1] + k * b.stride[2];
                    for (size_t j = 0; j < n; ++j, at += b.count[2], number += b.stride[1]) f(at, *number);
                }
            }
    });
}

template <class T, class S> void assign(T& number, S value) { number = T(value); }

template <class S> size_t find_in_buffer(const Object& o, const S* values, size_t count) {
    const S most = sizeof(S) < sizeof(double) ? FLT_MAX : S(most_of(o));
    // any of them at first, as wide as the numbers, in a loop that compilers turn into vector instructions
    std::conditional_t<sizeof(S) == sizeof(double), int64_t, int32_t> bad = 0;
    for (size_t at = 0; at < count; ++at) bad |= fabs(values[at]) <= most ? 0 : 1;
    for (size_t at = 0; at < count && bad; ++at)
        if (!(fabs(values[at]) <= most)) return at;
    return SIZE_MAX;
}

} // namespace

void read_block(const Object& o, const Block& block, const Values& values) {
    values.stored([&](auto* to) { each_number(o, block, [to](size_t at, auto number) { assign(to[at], number); }); });
}

void write_block(const Object& o, const Block& block, const Values& values) {
    values.stored([&](const auto* from) {
        each_number(o, block, [from](size_t at, auto& number) { assign(number, from[at]); });
    });
}

size_t find_beyond(const Object& o, const Values& values, size_t count) {
    return values.stored([&](const auto* buffer) { return find_in_buffer(o, buffer, count); });
}

} // namespace cd
