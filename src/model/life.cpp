#include "model/life.hh"

namespace cd {

Change::Change(Changes& with, AnyArray of, size_t wanted) : array(of), count(wanted) {
    *with.end = this;
    with.end = &next;
}

bool Change::take(Memory& memory) {
    size_t bytes;
    if (keep() || count == 0) return true;
    return multiply(count, array.size, bytes) && (fresh = static_cast<char*>(allocate(memory, bytes))) != nullptr;
}

bool Change::spread(size_t items) const {
    const Array<char> old = array.held();
    if (!fresh || !old) return keep();
    const size_t from = old.count / items, to = count / items, size = array.size;
    for (size_t i = 0; i < count; ++i) memcpy(fresh + i * size, old.data + i / to * from * size, size);
    return true;
}

void Change::carry_over() const {
    const Array<char> old = array.held();
    if (fresh && old) memcpy(fresh, old.data, (old.count < count ? old.count : count) * array.size);
}

bool Changes::keep_all() const {
    for (const Change* it = first; it; it = it->next)
        if (!it->keep()) return false;
    return true;
}

bool Changes::take_all(Memory& memory) {
    for (Change* it = first; it; it = it->next)
        if (!it->take(memory)) {
            for (Change* taken = first; taken != it; taken = taken->next)
                release(memory, taken->fresh, taken->count * taken->array.size);
            return false;
        }
    return true;
}

void Changes::put_all(Memory& memory) {
    for (Change* it = first; it; it = it->next) {
        if (it->keep()) continue;
        release_array(memory, it->array);
        it->array.hold({it->fresh, it->count});
    }
}

void release_array(Memory& memory, AnyArray array) {
    const Array<char> old = array.held();
    release(memory, old.data, old.count * array.size);
    array.hold({});
}

} // namespace cd
