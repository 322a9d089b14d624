// Whole numbers without libm: its versions for each processor would come along into what is linked statically.
#pragma once

#include <stdint.h>

namespace cd {

// The largest whole number that is not larger than x.
inline double whole_below(double x) {
    if (!(x > -0x1p52 && x < 0x1p52)) return x; // whole, or no number
    const double whole = double(int64_t(x));
    return whole > x ? whole - 1 : whole;
}

} // namespace cd
