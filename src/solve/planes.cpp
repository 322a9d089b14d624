#include "solve/planes.hh"

#include "base/parallel.hh"

namespace cd {

void Parts::each(const cd_parallel& parallel, const Body& body) const {
    if (!parallel.run || lines <= per_part) return body.call(body.function, 0, 0, lines);
    auto part = [&](size_t i) {
        const size_t first = i * per_part, left = lines - first;
        body.call(body.function, i, first, left < per_part ? left : per_part);
    };
    parallel_for(parallel, count(), part);
}

} // namespace cd
