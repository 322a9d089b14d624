// The memory of objects: taken all together or not at all, when they are made and when what they need changes.
#pragma once

#include "base/memory.hh"
#include "model/object.hh"

namespace cd {

struct Change;

// Changes that are made all together or not at all, in the order in which they were added.
struct Changes {
    Change* first = nullptr;

    Changes() = default;
    Changes(const Changes&) = delete;
    bool keep_all() const;
    bool take_all(Memory& memory); // false for want of memory: nothing has changed
    void put_all(Memory& memory);

private:
    friend struct Change;
    Change** end = &first;
};

// One array on its way from what it is to what it shall be.
struct Change {
    Change(Changes& with, AnyArray of, size_t wanted);

    bool is_new() const { return fresh && array.held().data == fresh; } // once it is put

    // Before it is put: numbers that many shared become each one's own, or those of the first are shared. Whether the
    // array holds what it did, once it is put.
    bool spread(size_t items) const;
    // Before it is put: what there is of it keeps its numbers.
    void carry_over() const;
    bool keep() const { return array.held().count == count; }

private:
    friend struct Changes;
    AnyArray array;
    size_t count;
    char* fresh = nullptr;
    Change* next = nullptr;

    bool take(Memory& memory);
};

void release_array(Memory& memory, AnyArray array);

// X: an object with features and set_features; X::each_array(f, x) makes f(array) for each array that it has.

template <class X> void release_arrays(X& x) {
    X::each_array([&](AnyArray array) { release_array(x.memory, array); }, x);
}

// An object as `start` has it, with what its features need, or null.
template <class X> X* make(X& start, uint64_t tag) {
    Array<char> place;
    if (!allocate(start.memory, sizeof(X), place) || !set_features(start, features(start))) {
        release_arrays(start);
        release(start.memory, place);
        return nullptr;
    }
    X* const made = reinterpret_cast<X*>(place.data);
    *made = start;
    made->tag = tag;
    return made;
}

template <class X> void destroy(X* x) {
    x->tag = 0;
    release_arrays(*x);
    Memory memory = x->memory;
    release(memory, x, sizeof(X));
}

} // namespace cd
