#include "sequence.hpp"

#include <stdlib.h>
#include <string.h>

#include <memory>

#include "arguments.hpp"
#include "chain.hpp"
#include "membrane.hpp"
#include "random.hpp"
#include "water.hpp"

namespace fuzz {

using Objects = std::vector<std::unique_ptr<AnyObject>>;

static bool is_wanted(const char* kind) {
    const char* const only = getenv("FUZZ_ONLY");
    return !only || strstr(only, kind);
}

static std::unique_ptr<AnyObject> pick_object() {
    for (;;) switch (below(5)) {
        case 0:
            if (is_wanted("chain")) return std::make_unique<Chain>();
            break;
        case 1:
        case 2:
            if (is_wanted("membrane")) return std::make_unique<Membrane>();
            break;
        default:
            if (is_wanted("water")) return std::make_unique<Water>();
        }
}

// ---- calls that concern no object of the sequence ------------------------------------------------------------------

struct Shape {
    size_t first, second, components;
    cd_precision precision;
    double dx, dy;
};

static cd_status create(const Shape& s, const cd_allocator* a, cd_chain** out) {
    return cd_chain_create(s.first, s.second, s.components, s.precision, a, out);
}
static cd_status create(const Shape& s, const cd_allocator* a, cd_membrane** out) {
    return cd_membrane_create(s.first, s.second, s.components, s.precision, a, out);
}
static cd_status create(const Shape& s, const cd_allocator* a, cd_water** out) {
    return cd_water_create(s.first, s.second, s.dx, s.dy, s.precision, a, out);
}

template <class Api> static void create_by_chance() {
    const size_t first = chance(0.5) ? wild_size(3) : below(5), second = chance(0.7) ? wild_size(3) : below(5);
    const Shape shape = {first,
                         second,
                         chance(0.3) ? wild_size(4) : 1 + below(4),
                         chance(0.3) ? wild_enum(1) : cd_precision(below(2)),
                         chance(0.3) ? wild_number() : 1,
                         chance(0.3) ? wild_number() : 1};
    trace(text("%s_create %zu %zu, components %zu, precision %d, %.17g %.17g", Api::name, first, second,
               shape.components, int(shape.precision), shape.dx, shape.dy));
    Heap heap;
    heap.fail_in = chance(0.3) ? 1 + below(6) : 0;
    cd_allocator allocator = heap.table();
    if (chance(0.1)) allocator.allocate = nullptr;
    if (chance(0.1)) allocator.release = nullptr;
    const bool no_table = heap.fail_in == 0 && first < 5 && second < 5 && chance(0.1), no_output = chance(0.03);
    typename Api::Handle* out = nullptr;
    ++totals->calls;
    const cd_status status = create(shape, no_table ? nullptr : &allocator, no_output ? nullptr : &out);
    if ((status == CD_OK) != (out != nullptr))
        problem("create: %s, and the output is written: %d", cd_status_name(status), out != nullptr);
    if (no_output && status == CD_OK) problem("create takes null for its output");
    if (status == CD_ERROR_MEMORY && !heap.has_failed && first < 100 && second < 100)
        problem("create: out of memory, but no allocation failed");
    if (out) Api::step(out, 0.1, 1);
    Api::destroy(out);
    if (heap.bytes) problem("create: %s, leaks %zu bytes", cd_status_name(status), heap.bytes);
    if (heap.called_wrongly) problem("create: calls the allocator wrongly");
}

static void read_constants() {
    const cd_status status = wild_enum(CD_ERROR_CALLBACK);
    const cd_kernels kernels = wild_enum(CD_KERNELS_AVX512);
    const bool known = status >= CD_OK && status <= CD_ERROR_CALLBACK;
    if ((strcmp(cd_status_name(status), "CD_ERROR_UNKNOWN") != 0) != known) problem("cd_status_name(%d)", int(status));
    if (!*cd_kernels_name(kernels)) problem("cd_kernels_name(%d)", int(kernels));
    if (!*cd_version_string() || !*cd_build_info() || cd_version() == 0) problem("no version or build is told");
    if (!(cd_runnable_kernels() & 1)) problem("the plain kernels do not run");
}

// ---- a sequence ----------------------------------------------------------------------------------------------------

// What is done beside an object's own calls.
static void act_beside(Objects& objects, AnyObject& object) {
    if (chance(0.003)) create_by_chance<ChainApi>();
    if (chance(0.003)) create_by_chance<MembraneApi>();
    if (chance(0.003)) create_by_chance<WaterApi>();
    if (chance(0.01)) read_constants();
    if (chance(0.01)) object.misuse(nullptr);
    if (chance(0.05) && objects.size() > 1) {
        AnyObject& other = *objects[below(objects.size())];
        if (&other != &object && !object.take(other)) object.misuse(other.handle());
    }
    if (chance(0.01) && objects.size() > 1) objects.erase(objects.begin() + ptrdiff_t(below(objects.size())));
}

void run_sequence(uint64_t sequence, const std::vector<bool>& left_out) {
    run.sequence = sequence;
    run.broken = false;
    forget_trace();
    seed_random(run.seed, sequence, 0);
    run.sane = chance(0.6);
    run.bad = run.sane ? 0.03 : 0.06;
    Objects objects;
    for (size_t k = 1 + below(chance(0.3) ? 4 : 1); k > 0; --k) objects.push_back(pick_object());
    const size_t calls = 20 + below(kMostCalls - 20);
    for (size_t k = 0; k < calls && !run.broken; ++k) {
        if (k < left_out.size() && left_out[k]) continue;
        seed_random(run.seed, sequence, k + 1);
        AnyObject& object = *objects[below(objects.size())];
        object.act();
        if (!run.broken) act_beside(objects, object);
    }
    objects.clear();
    ++totals->sequences;
}

} // namespace fuzz
