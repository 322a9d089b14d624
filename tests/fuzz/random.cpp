#include "random.hpp"

#include <math.h>

namespace fuzz {

static uint64_t state;

uint64_t random_bits() { // splitmix64
    uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

void seed_random(uint64_t seed, uint64_t sequence, uint64_t call) {
    state = seed * 0x2545f4914f6cdd1d + sequence * 0x9e3779b97f4a7c15 + call * 0xd1342543de82ef95;
    state = random_bits();
}

static double share() { return double(random_bits() >> 11) * 0x1p-53; }

size_t below(size_t n) { return n ? size_t(random_bits() % n) : 0; }
bool chance(double probability) { return share() < probability; }
double uniform(double from, double to) { return from + (to - from) * share(); }
double decades(double from, double to) { return pow(10, uniform(from, to)); }

template <class T, size_t n> static T any_of(const T (&all)[n]) { return all[below(n)]; }

double wild_number() {
    static const double all[] = {
        0,      -0.0,   1,      -1,     0.5,    2,      3,       NAN,          INFINITY,    -INFINITY, 1e300,
        -1e300, 1e308,  -1e308, 1e-300, 1e-310, 5e-324, 1e60,    1.0000001e60, 1e-60,       9e-61,     1e-61,
        1e30,   1.1e30, 1e-30,  9e-31,  1e38,   3.5e38, -3.5e38, 1e39,         1e-46,       1e-38,     1e6,
        1e7,    1e-6,   1e-7,   1e3,    1.1e3,  1e19,   1e-14,   1e-15,        4294967296.0};
    return any_of(all);
}

size_t wild_size(size_t n) {
    const size_t all[] = {0,
                          1,
                          7,
                          n,
                          n + 1,
                          n - 1,
                          n / 2,
                          SIZE_MAX,
                          SIZE_MAX / 2,
                          SIZE_MAX / 8,
                          SIZE_MAX - n + 1,
                          size_t(1) << 32,
                          size_t(1) << 61};
    return any_of(all);
}

int32_t wild_enum(int32_t last) {
    const int32_t all[] = {-1, 0, last, last + 1, 31, 32, 64, INT32_MAX, INT32_MIN};
    return any_of(all);
}

} // namespace fuzz
