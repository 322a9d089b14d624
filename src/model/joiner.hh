// Which nodes of a sheet hang together: see membrane_parts.cpp, and membrane_cloth.cpp of cloth.
#pragma once

#include <stddef.h>

#include <initializer_list>

namespace cd {

// While the parts of a sheet are sought every node that is joined to others points to one of its part, in the end to the
// part's first one, which points to itself; pointers are places + 1, of all other nodes 0.
struct Joiner {
    size_t* points;

    size_t first_of(size_t at) const {
        while (points[at] - 1 != at) {
            const size_t next = points[at] - 1;
            points[at] = points[next];
            at = next;
        }
        return at;
    }
    void join(size_t a, size_t b) const {
        a = first_of(a), b = first_of(b);
        if (a < b) points[b] = a + 1;
        else points[a] = b + 1;
    }
    // those of them that are joined to others
    void join_all(std::initializer_list<size_t> places) const {
        size_t last = 0;
        for (size_t at : places) {
            if (points[at] == 0) continue;
            if (last > 0) join(last - 1, at);
            last = at + 1;
        }
    }
};

} // namespace cd
