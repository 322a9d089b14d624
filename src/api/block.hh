// Whole blocks of the state's numbers, between memory and a caller's buffer.
#pragma once

#include "model/body.hh"

namespace cd {

// Numbers in a buffer's order, [outer][middle][inner], as they lie in memory: strides in numbers. Without an array:
// what is asked for lies otherwise.
struct Block {
    const Array<char>* array;
    size_t first, count[3], stride[3];
};

// S: float or double
template <class S> void read_block(const Object& o, const Block& block, S* values);
template <class S> void write_block(const Object& o, const Block& block, const S* values);

// The first that is not finite, or larger than the object's precision holds; SIZE_MAX if there is none.
template <class S> size_t find_beyond(const Object& o, const S* values, size_t count);

} // namespace cd
