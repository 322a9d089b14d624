#include "kept.hpp"

#include <string.h>

#include "random.hpp"

namespace fuzz {

// Saved bytes begin with 24 bytes of header, of which the last 8 are the checksum of all that follows.
constexpr size_t kHeader = 24, kChecksum = 16;

static uint64_t checksum(const Bytes& bytes) { // as src/model/keep.cpp has it
    uint64_t sum = 0xcbf29ce484222325;
    const auto add = [&](uint64_t word) {
        sum = (sum ^ word) * 0x9e3779b97f4a7c15;
        sum ^= sum >> 29;
    };
    add(bytes.size() - kHeader);
    for (size_t i = kHeader; i < bytes.size(); i += 8) {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < bytes.size(); ++k) word |= uint64_t(bytes[i + k]) << (8 * k);
        add(word);
    }
    return sum;
}

static void put_checksum_right(Bytes& bytes) {
    if (bytes.size() < kHeader) return;
    const uint64_t sum = checksum(bytes);
    for (size_t k = 0; k < 8; ++k) bytes[kChecksum + k] = static_cast<unsigned char>(sum >> (8 * k));
}

template <class Api> Bytes Kept<Api>::saved() {
    size_t size = 0, written = 0;
    Api::save_size(this->first(), &size);
    Bytes bytes(size);
    this->both("save", kReads | kNoTwin,
               [&](Handle* handle, int) { return Api::save(handle, bytes.data(), size, &written); });
    if (run.broken) return bytes;
    if (written != size || size <= kHeader) problem("save wrote %zu bytes of %zu", written, size);
    Bytes again = bytes;
    put_checksum_right(again);
    if (again != bytes) problem("the checksum of saved bytes is not the one that this fuzzer computes");
    return bytes;
}

template <class Api> void Kept<Api>::save_into_too_little() {
    size_t size = 0, written = 77;
    Api::save_size(this->first(), &size);
    const size_t little = below(size);
    Bytes buffer(size, 0x77);
    const Bytes before = buffer;
    const cd_status status = this->both("save into too little", kReads, [&](Handle* handle, int) {
        return Api::save(handle, buffer.data(), little, &written);
    });
    if (!run.broken && (status != CD_ERROR_RANGE || written != 77 || buffer != before))
        problem("save into %zu bytes of %zu: %s, wrote %zu", little, size, cd_status_name(status), written);
}

template <class Api> void Kept<Api>::remake_twin() {
    const bool fresh = chance(0.6), by_bytes = chance(0.6);
    trace(text("%s: the twin is made again%s, by %s", Api::name, fresh ? ", in a new object" : "",
               by_bytes ? "save and load" : "copy_state"));
    if (fresh) this->remake_twin_empty();
    if (run.broken) return;
    this->pick_kernels(this->twin());
    if (chance(0.5)) { // something else was in it before
        Api::enable_field(this->twin(), pick_field());
        Api::set_method(this->twin(), cd_method(below(4)));
    }
    const Bytes bytes = by_bytes ? saved() : Bytes();
    if (run.broken) return;
    const cd_status status =
        by_bytes ? Api::load(this->twin(), bytes.data(), bytes.size()) : Api::copy_state(this->twin(), this->first());
    if (status != CD_OK)
        return problem("the twin is made again%s: %s", this->past.diverged ? ", of a state that diverged" : "",
                       cd_error_message());
    uint64_t twin_hash = 0;
    Api::hash(this->twin(), &twin_hash);
    if (twin_hash == this->hash()) return;
    if (run.tracing) this->print_difference();
    problem("the twin is made again by %s: another hash", by_bytes ? "save and load" : "copy_state");
}

template <class Api> void Kept<Api>::keep() {
    const State state = {saved(), this->hash(), this->past};
    if (states.size() < 3) states.push_back(state);
    else states[below(3)] = state;
}

template <class Api> void Kept<Api>::go_back() {
    if (states.empty() || run.broken) return;
    const State& state = states[below(states.size())];
    cd_status status;
    if (chance(0.5)) {
        status = this->both("load of an earlier state", 0, [&](Handle* handle, int) {
            return Api::load(handle, state.bytes.data(), state.bytes.size());
        });
    } else {
        Heap heap;
        const cd_allocator allocator = heap.table();
        Handle* source = nullptr;
        if (this->make(&allocator, &source) != CD_OK) return problem("create: %s", cd_error_message());
        if (Api::load(source, state.bytes.data(), state.bytes.size()) != CD_OK)
            problem("load of an earlier state into a new object: %s", cd_error_message());
        status = this->both("copy_state of an earlier state", 0,
                            [&](Handle* handle, int) { return Api::copy_state(handle, source); });
        Api::destroy(source);
    }
    if (status == CD_ERROR_MEMORY || run.broken) return;
    if (status != CD_OK) return problem("an earlier state does not come back: %s", cd_error_message());
    if (this->hash() != state.hash) problem("an earlier state comes back with another hash");
    this->past = state.past;
}

template <class Api> void Kept<Api>::take_another(Kept& other, bool by_copy) {
    const Bytes bytes = by_copy ? Bytes() : other.saved();
    if (run.broken) return;
    const cd_status status =
        this->both(by_copy ? "copy_state of another" : "load of another's bytes", 0, [&](Handle* handle, int which) {
            return by_copy ? Api::copy_state(handle, which ? other.twin() : other.first())
                           : Api::load(handle, bytes.data(), bytes.size());
        });
    if (status == CD_ERROR_MEMORY || status == CD_ERROR_MISMATCH || run.broken) return;
    if (status != CD_OK) return problem("another's state: %s", cd_error_message());
    if (this->hash() != other.hash()) problem("another's state is taken with another hash");
    this->past = other.past;
}

// ---- bytes that save did not write ---------------------------------------------------------------------------------

static void damage(Bytes& bytes) {
    const size_t contents = bytes.size() - kHeader;
    switch (below(6)) {
    case 0: bytes.resize(below(bytes.size())); break;
    case 1: bytes.resize(bytes.size() + 1 + below(40), static_cast<unsigned char>(random_bits())); break;
    case 2:
        for (size_t k = 1 + below(4); k > 0; --k)
            bytes[below(bytes.size())] ^= static_cast<unsigned char>(1 << below(8));
        break;
    case 3:
        for (size_t k = 1 + below(4); k > 0; --k)
            bytes[kHeader + below(contents)] = static_cast<unsigned char>(random_bits());
        break;
    case 4: { // a whole number
        const size_t at = kHeader + 4 * below(contents / 4);
        const double wide = wild_number();
        const float narrow = float(wide);
        if (chance(0.5) && at + sizeof wide <= bytes.size()) memcpy(&bytes[at], &wide, sizeof wide);
        else if (at + sizeof narrow <= bytes.size()) memcpy(&bytes[at], &narrow, sizeof narrow);
        break;
    }
    default: // among the settings, which come first
        bytes[kHeader + below(contents < 200 ? contents : 200)] =
            static_cast<unsigned char>(chance(0.5) ? random_bits() : below(4));
    }
}

template <class Api> void Kept<Api>::load_damaged() {
    const Bytes whole = saved();
    if (run.broken) return;
    Bytes bytes = whole;
    damage(bytes);
    const bool crafted = chance(0.5);
    if (crafted) put_checksum_right(bytes);
    // A buffer of just their size, so that AddressSanitizer sees reads beyond.
    const std::unique_ptr<unsigned char[]> exact(new unsigned char[bytes.size()]);
    if (!bytes.empty()) memcpy(exact.get(), bytes.data(), bytes.size());
    const cd_status status =
        this->both(crafted ? "load of crafted bytes" : "load of damaged bytes", 0,
                   [&](Handle* handle, int) { return Api::load(handle, exact.get(), bytes.size()); });
    const cd_status told = cd_saved_shape(exact.get(), bytes.size(), nullptr, nullptr, nullptr, nullptr, nullptr);
    if (status == CD_OK && told != CD_OK) return problem("bytes that load tell no shape: %s", cd_status_name(told));
    if (status == CD_ERROR_MEMORY || bytes == whole || run.broken) return;
    if (status != CD_OK) {
        ++totals->bytes_refused;
        if (status != CD_ERROR_FORMAT && status != CD_ERROR_MISMATCH)
            problem("load of %s bytes: %s", crafted ? "crafted" : "damaged", cd_status_name(status));
        return;
    }
    ++totals->bytes_taken;
    if (!crafted) return problem("damaged bytes are taken");
    this->past = {false, true, true};
    check_crafted(bytes);
    check_state();
}

// Bytes that were taken are those that the object saves now, or at least their like is taken again.
template <class Api> void Kept<Api>::check_crafted(const Bytes& crafted) {
    const Bytes again = saved();
    if (run.broken || again == crafted) return;
    Heap heap;
    const cd_allocator allocator = heap.table();
    Handle* other = nullptr;
    if (this->make(&allocator, &other) != CD_OK) return problem("create: %s", cd_error_message());
    uint64_t hash = 0;
    if (Api::load(other, again.data(), again.size()) != CD_OK)
        problem("crafted bytes are taken, and what is saved then is not: %s", cd_error_message());
    else if (Api::hash(other, &hash) != CD_OK || hash != this->hash())
        problem("crafted bytes are taken, and saved and loaded they give another hash");
    Api::destroy(other);
}

template class Kept<ChainApi>;
template class Kept<MembraneApi>;
template class Kept<WaterApi>;

} // namespace fuzz
