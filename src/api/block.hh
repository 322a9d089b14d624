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

// A caller's buffer, in either precision. Only what is read is put there.
class Values {
public:
    explicit Values(const float* values) : data(const_cast<float*>(values)), wide(false) {}
    explicit Values(const double* values) : data(const_cast<double*>(values)), wide(true) {}

    const void* address() const { return data; }
    // f of them as they lie there.
    template <class F> auto stored(F f) const {
        return wide ? f(static_cast<double*>(data)) : f(static_cast<float*>(data));
    }
    double operator[](size_t at) const {
        return stored([at](const auto* values) { return double(values[at]); });
    }
    void put(size_t at, double value) const {
        if (wide) static_cast<double*>(data)[at] = value;
        else static_cast<float*>(data)[at] = float(value);
    }

private:
    void* data;
    bool wide;
};

void read_block(const Object& o, const Block& block, const Values& values);
void write_block(const Object& o, const Block& block, const Values& values);

// The first that is not finite, or larger than the object's precision holds; SIZE_MAX if there is none.
size_t find_beyond(const Object& o, const Values& values, size_t count);

} // namespace cd
