// Work spread over the caller's threads, or done in order when there are none.
#pragma once

#include <stddef.h>

#include "contdyn/base.h"

namespace cd {

// body(i) for every i in [0, count). Results must not depend on the order.
template <class Body> void parallel_for(const cd_parallel& parallel, size_t count, Body& body) {
    if (!parallel.run || count < 2) {
        for (size_t i = 0; i < count; ++i) body(i);
        return;
    }
    parallel.run(
        parallel.user, count, [](void* context, size_t i) { (*static_cast<Body*>(context))(i); }, &body);
}

} // namespace cd
