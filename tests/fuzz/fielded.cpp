#include "fielded.hpp"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "random.hpp"

namespace fuzz {

constexpr size_t kMostNumbers = 100000; // given to a call, whatever count it is told

template <class Api> bool Fielded<Api>::read_all(Handle* handle, cd_field field, Doubles& out) const {
    Extent e;
    if (!extent(field, e)) return false;
    out.assign(e.count(), 0);
    return on_part<Api>(Api::read_f64, handle, field, {0, e.outer, 0, e.inner, out.size()}, out.data()) == CD_OK;
}

template <class Api> Doubles Fielded<Api>::all_of(cd_field field) const {
    Doubles values;
    if (!read_all(field, values)) values.clear();
    return values;
}

template <class Api> double Fielded<Api>::largest_of(std::initializer_list<cd_field> fields) const {
    double largest = 0;
    for (cd_field field : fields)
        for (double value : all_of(field)) largest = isfinite(value) ? fmax(largest, fabs(value)) : INFINITY;
    return largest;
}

template <class Api> cd_field Fielded<Api>::pick_own_field() const {
    cd_field field = pick_field();
    Extent e;
    for (int tries = 0; tries < 20 && !extent(field, e) && chance(0.95); ++tries) field = pick_field();
    return field;
}

template <class Api> Part Fielded<Api>::pick_part_of(cd_field field) const {
    Extent e;
    if (!extent(field, e)) e = {1, 1, 1};
    return pick_part(e);
}

static std::string part_text(const char* what, cd_field field, const Part& p, bool null) {
    return text("%s field %d, %zu from %zu of each of %zu from %zu, count %zu%s", what, int(field), p.inner_count,
                p.inner, p.outer_count, p.outer, p.count, null ? ", null" : "");
}

// Numbers in a buffer of just their size, so that AddressSanitizer sees reads and writes beyond.
template <class Number> static std::unique_ptr<Number[]> exact_copy(const Doubles& values) {
    std::unique_ptr<Number[]> buffer(new Number[values.size()]);
    for (size_t i = 0; i < values.size(); ++i) buffer[i] = Number(values[i]);
    return buffer;
}

template <class Api> template <class Number, class Function>
void Fielded<Api>::write_as(Function function, const char* what, cd_field field) {
    const Part part = pick_part_of(field);
    bool moderate = true;
    const Doubles values = pick_values(field, part.count < kMostNumbers ? part.count : kMostNumbers, moderate);
    const bool null = pick_null();
    const std::unique_ptr<Number[]> buffer = exact_copy<Number>(values);
    const Number* const numbers = null ? nullptr : buffer.get();
    const cd_status status = this->both(part_text(what, field, part, null), kNoMemory, [&](Handle* handle, int) {
        return on_part<Api>(function, handle, field, part, numbers);
    });
    if (status != CD_OK) return;
    if (!moderate) this->past.moderate = false;
    if (run.tracing && values.size() <= 64) {
        std::string line = "    ";
        for (double value : values) line += text(" %.17g", value);
        trace_detail(line);
    }
}

template <class Api> void Fielded<Api>::write_by_chance() {
    const cd_field field = pick_own_field();
    if (chance(0.3)) write_as<float>(Api::write_f32, "write_f32", field);
    else write_as<double>(Api::write_f64, "write_f64", field);
}

template <class Api> template <class Number, class Function>
void Fielded<Api>::read_as(Function function, const char* what, cd_field field) {
    const Part part = pick_part_of(field);
    const Doubles untouched(part.count < kMostNumbers ? part.count : kMostNumbers, 123);
    const bool null = pick_null();
    const std::unique_ptr<Number[]> buffers[2] = {exact_copy<Number>(untouched), exact_copy<Number>(untouched)};
    const std::string call = part_text(what, field, part, null);
    const cd_status status = this->both(call, kReads, [&](Handle* handle, int which) {
        return on_part<Api>(function, handle, field, part, null ? nullptr : buffers[which].get());
    });
    if (status == CD_OK) return this->must_agree(call.c_str(), buffers[0].get(), buffers[1].get(), untouched.size());
    for (size_t i = 0; i < untouched.size(); ++i)
        if (buffers[0][i] != Number(untouched[i])) return problem("%s: failed, but wrote its output", call.c_str());
}

template <class Api> void Fielded<Api>::read_by_chance() {
    const cd_field field = pick_own_field();
    if (chance(0.3)) read_as<float>(Api::read_f32, "read_f32", field);
    else read_as<double>(Api::read_f64, "read_f64", field);
}

// What a view shows is what a read gives.
template <class Api> void Fielded<Api>::view_by_chance() {
    const cd_field field = pick_own_field();
    View views[2] = {};
    const cd_status status = this->both(text("view field %d", int(field)), kReads,
                                        [&](Handle* handle, int which) { return view(handle, field, views[which]); });
    Extent e;
    Doubles values;
    if (status != CD_OK || run.broken || !extent(field, e) || !read_all(field, values)) return;
    const View& v = views[0];
    const char* const data = static_cast<const char*>(v.data);
    for (size_t j = 0, n = 0; j < e.outer; ++j)
        for (size_t i = 0; i < e.inner; ++i)
            for (size_t k = 0; k < e.components; ++k, ++n) {
                const char* const at = data + j * v.outer_stride + i * v.inner_stride + k * v.component_stride;
                double seen;
                float narrow;
                if (this->precision == CD_FLOAT64) memcpy(&seen, at, sizeof seen);
                else memcpy(&narrow, at, sizeof narrow), seen = double(narrow);
                if (seen != values[n] && !(isnan(seen) && isnan(values[n])))
                    return problem("view of field %d shows %.17g, a read gives %.17g", int(field), seen, values[n]);
            }
}

template <class Api> void Fielded<Api>::enable_by_chance() {
    const cd_field field = chance(0.2) ? pick_field() : pick_own_field();
    this->both(text("enable_field %d", int(field)), 0,
               [&](Handle* handle, int) { return Api::enable_field(handle, field); });
}

template <class Api> void Fielded<Api>::disable_by_chance() {
    const cd_field field = chance(0.2) ? pick_field() : pick_own_field();
    this->both(text("disable_field %d", int(field)), 0,
               [&](Handle* handle, int) { return Api::disable_field(handle, field); });
}

template <class Api> void Fielded<Api>::print_difference() {
    for (cd_field field = 0; field <= kLastField; ++field) {
        Doubles mine, twins;
        if (!read_all(this->first(), field, mine) || !read_all(this->twin(), field, twins)) continue;
        size_t different = 0;
        for (size_t i = 0; i < mine.size(); ++i)
            if (memcmp(&mine[i], &twins[i], sizeof mine[i]) != 0 && different++ < 6)
                printf("    field %d, number %zu of %zu: %.17g, the twin %.17g\n", int(field), i, mine.size(), mine[i],
                       twins[i]);
        if (different) printf("    field %d differs in %zu numbers\n", int(field), different);
    }
}

template class Fielded<ChainApi>;
template class Fielded<MembraneApi>;
template class Fielded<WaterApi>;

} // namespace fuzz
