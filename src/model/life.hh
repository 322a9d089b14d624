// The memory of objects: taken all together or not at all, when they are made and when what they need changes.
#pragma once

#include "base/memory.hh"
#include "model/object.hh"

namespace cd {

// One array on its way from what it is to what it shall be.
template <class T> struct Change {
    Array<T>& array;
    size_t count;
    Array<T> fresh{};

    bool keep() const { return array.count == count; }
    bool take(Memory& memory) { return keep() || count == 0 || allocate(memory, count, fresh); }
    void undo(Memory& memory) { release(memory, fresh); }
    void put(Memory& memory) {
        if (keep()) return;
        release(memory, array);
        array = fresh;
    }
    bool is_new() const { return fresh && array.data == fresh.data; } // once it is put

    // Before it is put: numbers that many shared become each one's own, or those of the first are shared. Whether the
    // array holds what it did, once it is put.
    bool spread(size_t items) {
        if (!fresh || !array) return keep();
        const size_t from = array.count / items, to = count / items;
        for (size_t i = 0; i < count; ++i) fresh[i] = array[i / to * from];
        return true;
    }
    // Before it is put: what there is of it keeps its numbers.
    void carry_over() const {
        for (size_t i = 0; i < fresh.count && i < array.count; ++i) fresh[i] = array[i];
    }
};

// What may be done with changes, of which all(f) makes f(change) && f(next) && ...
template <class All> bool keep_all(All all) {
    return all([](const auto& change) { return change.keep(); });
}
// False for want of memory: nothing has changed.
template <class All> bool take_all(Memory& memory, All all) {
    if (all([&](auto& change) { return change.take(memory); })) return true;
    all([&](auto& change) { return change.undo(memory), true; });
    return false;
}
template <class All> void put_all(Memory& memory, All all) {
    all([&](auto& change) { return change.put(memory), true; });
}

// X: an object with features and set_features; X::each_array(f, x) makes f(array) for each array that it has.

template <class X> void release_arrays(X& x) {
    X::each_array([&](auto& array) { release(x.memory, array); }, x);
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
