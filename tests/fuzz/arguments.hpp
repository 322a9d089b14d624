// Arguments for calls: mostly good, sometimes bad. How often they are bad is up to the sequence, see Run.
#ifndef FUZZ_ARGUMENTS_HPP
#define FUZZ_ARGUMENTS_HPP

#include <contdyn/base.h>

#include <vector>

#include "api.hpp"

namespace fuzz {

using Doubles = std::vector<double>;

double pick_number(double from, double to); // from 10^from to 10^to
double pick_between(double from, double to);
int32_t pick_enum(int32_t last); // from 0 to last
size_t pick_index(size_t count); // below count
size_t pick_count(size_t count); // just count
bool pick_null();                // whether a pointer is to be null
cd_field pick_field();           // of any object
Part pick_part(const Extent& whole);

// Numbers for a field. `moderate` becomes false where wild ones are among them.
Doubles pick_values(cd_field field, size_t count, bool& moderate);

constexpr cd_field kLastField = CD_BREAKING_STRAIN_V;
const double kHuge = 1e300; // where a number may be as large as it likes

} // namespace fuzz

#endif
