#include "twins.hpp"

#include "arguments.hpp"
#include "random.hpp"

namespace fuzz {

template <class Api> Twins<Api>::~Twins() {
    for (Handle* handle : handles) Api::destroy(handle);
    if (heap.bytes != 0 || twin_heap.bytes != 0)
        problem("%s: destroy leaks %zu bytes, the twin's %zu", Api::name, heap.bytes, twin_heap.bytes);
    if (heap.called_wrongly || twin_heap.called_wrongly) problem("%s: destroy calls the allocator wrongly", Api::name);
}

// ---- life ----------------------------------------------------------------------------------------------------------

template <class Api> void Twins<Api>::create() {
    const cd_allocator allocator = heap.table(), twin_allocator = twin_heap.table();
    for (int tries = 0; tries < 3 && !handles[0]; ++tries) create_while_memory_fails();
    for (int which = 0; which < 2; ++which)
        if (!handles[which] && make(which ? &twin_allocator : &allocator, &handles[which]) != CD_OK)
            return problem("create: %s", cd_error_message());
    for (Handle* handle : handles) pick_kernels(handle);
    last_hash = hash_of(handles[0]);
    if (hash_of(handles[1]) != last_hash) problem("new twins differ");
}

template <class Api> void Twins<Api>::create_while_memory_fails() {
    const cd_allocator allocator = heap.table();
    heap.fail_in = chance(0.3) ? 1 + below(8) : 0, heap.has_failed = false;
    const cd_status status = make(&allocator, &handles[0]);
    heap.fail_in = 0;
    if (heap.has_failed != (status == CD_ERROR_MEMORY) || (!heap.has_failed && status != CD_OK))
        problem("create: %s, an allocation failed: %d", cd_status_name(status), heap.has_failed);
    if (status != CD_OK && (handles[0] || heap.bytes))
        problem("create failed, but wrote its output or leaks %zu bytes", heap.bytes);
}

template <class Api> void Twins<Api>::remake_twin_empty() {
    Api::destroy(handles[1]);
    handles[1] = nullptr;
    if (twin_heap.bytes) problem("destroy of the twin leaks %zu bytes", twin_heap.bytes);
    const cd_allocator allocator = twin_heap.table();
    if (make(&allocator, &handles[1]) != CD_OK) problem("create: %s", cd_error_message());
}

template <class Api> void Twins<Api>::pick_kernels(Handle* handle) {
    cd_kernels kernels = CD_KERNELS_PLAIN;
    do kernels = cd_kernels(below(3));
    while (!(cd_runnable_kernels() >> kernels & 1));
    trace(text("%s_set_kernels of %s: %d", Api::name, handle == handles[0] ? "the first" : "the twin", int(kernels)));
    if (Api::set_kernels(handle, kernels) != CD_OK) problem("set_kernels: %s", cd_error_message());
}

// ---- a call on both ------------------------------------------------------------------------------------------------

template <class Api> uint64_t Twins<Api>::hash_of(Handle* handle) {
    uint64_t hash = 0;
    if (Api::hash(handle, &hash) != CD_OK) problem("hash: %s", cd_error_message());
    return hash;
}

template <class Api> cd_status Twins<Api>::both(const std::string& what, unsigned flags, const Call& call) {
    if (run.broken) return CD_OK;
    trace(std::string(Api::name) + "_" + what);
    ++totals->calls;
    const size_t held_before = heap.bytes;
    heap.forbidden = (flags & (kNoMemory | kReads)) != 0;
    heap.broke_the_ban = heap.has_failed = false;
    heap.fail_in = !heap.forbidden && chance(0.05) ? 1 + below(5) : 0;
    malloc_watch::begin();
    const cd_status status = call(handles[0], 0);
    if (malloc_watch::end()) problem("%s: calls malloc", what.c_str());
    heap.forbidden = false, heap.fail_in = 0;
    check_allocator(what);

    size_t held = 0;
    Api::get_memory(handles[0], &held);
    if (held != heap.bytes) problem("%s: get_memory tells %zu, held are %zu", what.c_str(), held, heap.bytes);
    const uint64_t hash = hash_of(handles[0]);
    if (run.tracing)
        trace_detail(text("    %s%s, hash %016llx, %zu bytes", cd_status_name(status),
                          heap.has_failed ? ", an allocation failed" : "", static_cast<unsigned long long>(hash),
                          held));
    if (status < CD_OK || status > CD_ERROR_CALLBACK) problem("%s: status %d", what.c_str(), int(status));
    const bool has_stepped = (flags & kSteps) && (status == CD_ERROR_DIVERGED || status == CD_ERROR_TOLERANCE ||
                                                  status == CD_ERROR_CALLBACK);
    if (status != CD_OK && !has_stepped) check_failure(what, status, hash, held, held_before);
    if (heap.has_failed != (status == CD_ERROR_MEMORY))
        problem("%s: %s, an allocation failed: %d", what.c_str(), cd_status_name(status), heap.has_failed);
    if ((flags & kReads) && hash != last_hash) problem("%s: reads, but changes the hash", what.c_str());
    last_hash = hash;
    if (status != CD_ERROR_MEMORY && !(flags & kNoTwin)) check_twin(what, status, call);
    return status;
}

template <class Api> void Twins<Api>::check_allocator(const std::string& what) {
    if (heap.broke_the_ban) problem("%s: allocates or releases", what.c_str());
    if (heap.called_wrongly) problem("%s: calls the allocator wrongly", what.c_str());
}

// A call that fails changes nothing and says why.
template <class Api> void Twins<Api>::check_failure(const std::string& what, cd_status status, uint64_t hash,
                                                    size_t held, size_t held_before) {
    ++(status == CD_ERROR_MEMORY ? totals->out_of_memory : totals->refused);
    const char* const name = cd_status_name(status);
    const std::string begin = std::string("cd_") + Api::name + "_";
    if (strncmp(cd_error_message(), begin.c_str(), begin.size()) != 0 || !strstr(cd_error_message(), ": "))
        problem("%s: %s without a message of its own: %s", what.c_str(), name, cd_error_message());
    if (hash != last_hash)
        problem("%s: failed with %s (%s), but changed the hash", what.c_str(), name, cd_error_message());
    if (held != held_before) problem("%s: failed with %s, but changed the memory held", what.c_str(), name);
}

template <class Api> void Twins<Api>::check_twin(const std::string& what, cd_status status, const Call& call) {
    const cd_status twin_status = call(handles[1], 1);
    if (twin_status != status)
        problem("%s: %s, the twin %s", what.c_str(), cd_status_name(status), cd_status_name(twin_status));
    if (hash_of(handles[1]) == last_hash || run.broken) return;
    if (status == CD_ERROR_DIVERGED) { // how far what is not finite spreads may differ: see base.h
        if (Api::copy_state(handles[1], handles[0]) != CD_OK) problem("%s: copy_state: %s", Api::name, cd_error_message());
        return;
    }
    cd_kernels kernels[2] = {};
    for (int which = 0; which < 2; ++which) Api::get_kernels(handles[which], &kernels[which]);
    if (run.tracing) print_difference();
    problem("%s: the twin's hash differs, kernels %d and %d, hook %d", what.c_str(), int(kernels[0]), int(kernels[1]),
            int(hook.order));
}

// ---- calls of a common form ----------------------------------------------------------------------------------------

template <class Api> void Twins<Api>::set_number(const char* what, cd_status (*setter)(Handle*, double), double value,
                                                 Range moderate, unsigned flags) {
    const cd_status status =
        both(text("%s %.17g", what, value), flags, [&](Handle* handle, int) { return setter(handle, value); });
    if (status == CD_OK && !(value >= moderate.least && value <= moderate.most)) past.moderate = false;
}

template <class Api>
void Twins<Api>::set_enum(const char* what, cd_status (*setter)(Handle*, int32_t), int32_t last, unsigned flags) {
    const int32_t value = pick_enum(last);
    both(text("%s %d", what, int(value)), flags, [&](Handle* handle, int) { return setter(handle, value); });
}

template <class Api> bool Twins<Api>::pick_no_output() { return pick_null(); }

template class Twins<ChainApi>;
template class Twins<MembraneApi>;
template class Twins<WaterApi>;

} // namespace fuzz
