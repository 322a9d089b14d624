// A chain as bytes, as a hash, and as a copy of another. walk_* below list what a chain consists of, once for all.
//
//   header   "contdyn" and a zero, format version, kind of object, checksum of the rest
//   shape    strands, springs, components, precision
//   settings method, mass rule, ring, parameters, clock, which fields follow
//   fields   per node or spring in double, then per node, strand and component in the chain's precision
#include <math.h>

#include "base/archive.hh"
#include "base/status.hh"
#include "model/chain.hh"

namespace cd {

namespace {

constexpr uint64_t kMagic = 0x006e7964746e6f63; // "contdyn"
constexpr uint32_t kFormat = 1, kKindChain = 1;
constexpr size_t kHeader = 8 + 4 + 4 + 8;

struct Shape {
    uint64_t strands, springs, components;
    int32_t precision;

    bool operator==(const Shape& o) const {
        return strands == o.strands && springs == o.springs && components == o.components && precision == o.precision;
    }
};

struct Settings {
    int32_t method, mass_rule, ring;
    uint32_t fields; // a bit per optional field, by cd_field
    double lambda, mass, stiffness, bend, drag, damping, gravity[4], clock_start, clock_dt;
    uint64_t clock_steps, steps;
};

Shape shape_of(const Chain& c) { return {c.strands, c.springs, c.components, c.precision}; }

Settings settings_of(const Chain& c) {
    uint32_t fields = 0;
    if (c.node_mass) fields |= 1u << CD_MASS;
    if (c.spring_stiffness) fields |= 1u << CD_STIFFNESS;
    if (c.node_bend) fields |= 1u << CD_BEND;
    if (c.force) fields |= 1u << CD_FORCE;
    if (c.target) fields |= 1u << CD_TARGET;
    Settings s{c.method, c.mass_rule, c.ring, fields,        c.lambda,   c.mass,        c.stiffness, c.bend,
               c.drag,   c.damping,   {},     c.clock_start, c.clock_dt, c.clock_steps, c.steps};
    memcpy(s.gravity, c.gravity, sizeof s.gravity);
    return s;
}

void apply(Chain& c, const Settings& s) {
    c.mass_rule = s.mass_rule;
    c.lambda = s.lambda;
    c.mass = s.mass;
    c.stiffness = s.stiffness;
    c.bend = s.bend;
    c.drag = s.drag;
    c.damping = s.damping;
    memcpy(c.gravity, s.gravity, sizeof c.gravity);
    c.clock_start = s.clock_start;
    c.clock_dt = s.clock_dt;
    c.clock_steps = s.clock_steps;
    c.steps = s.steps;
    c.prepared_dt = 0;
}

Features features_of(const Settings& s) {
    const auto on = [&](cd_field field) { return (s.fields >> field & 1) != 0; };
    return {on(CD_MASS), on(CD_STIFFNESS), on(CD_BEND), on(CD_FORCE), on(CD_TARGET), s.ring != 0, s.bend > 0, s.method};
}

bool valid(const Chain& c, const Settings& s) {
    const uint32_t optional = 1u << CD_MASS | 1u << CD_STIFFNESS | 1u << CD_BEND | 1u << CD_FORCE | 1u << CD_TARGET;
    bool good = s.method >= CD_METHOD_IMPLICIT && s.method <= CD_METHOD_STIFF_SECOND;
    good &= s.mass_rule == CD_MASS_EQUAL || s.mass_rule == CD_MASS_HALF_ENDS;
    good &= s.ring == 0 || (s.ring == 1 && c.nodes >= 3);
    good &= (s.fields & ~optional) == 0 && s.lambda >= 0 && s.lambda <= 1 && valid_mass(s.mass);
    for (double parameter : {s.stiffness, s.bend, s.drag, s.damping}) good &= valid_parameter(parameter);
    for (double g : s.gravity) good &= fabs(g) <= kMost;
    return good && isfinite(s.clock_start) && isfinite(s.clock_dt);
}

template <class W> void walk_shape(W& w, Shape& s) {
    walk(w, s.strands), walk(w, s.springs), walk(w, s.components), walk(w, s.precision);
}

template <class W> void walk_settings(W& w, Settings& s) {
    walk(w, s.method), walk(w, s.mass_rule), walk(w, s.ring), walk(w, s.fields), walk(w, s.lambda), walk(w, s.mass);
    walk(w, s.stiffness), walk(w, s.bend), walk(w, s.drag), walk(w, s.damping);
    for (double& g : s.gravity) walk(w, g);
    walk(w, s.clock_start), walk(w, s.clock_dt), walk(w, s.clock_steps), walk(w, s.steps);
}

// Every number of every field, without the padding of the rows. For fields that are off, nothing.
template <class W, class T> void walk_lines(W& w, const Chain& c, T* data) {
    for (size_t node = 0; data && node < c.nodes; ++node)
        for (size_t line = 0; line < c.lines; ++line) walk(w, data[node * c.pitch + line]);
}
template <class W> void walk_fields(W& w, const Chain& c) {
    for (size_t i = 0; i < c.pin.count; ++i) walk(w, c.pin[i]);
    for (const Array<double>* a :
         {&c.node_mass, &c.spring_stiffness, &c.node_bend, &c.attach_stiffness, &c.attach_damping})
        for (size_t i = 0; i < a->count; ++i) walk(w, (*a)[i]);
    for (const Array<char>* a : {&c.position, &c.velocity, &c.force, &c.target}) {
        if (c.precision == CD_FLOAT64) walk_lines(w, c, numbers<double>(*a));
        else walk_lines(w, c, numbers<float>(*a));
    }
}

template <class W> void walk_chain(W& w, const Chain& c) {
    Shape shape = shape_of(c);
    Settings settings = settings_of(c);
    walk_shape(w, shape);
    walk_settings(w, settings);
    walk_fields(w, c);
}

uint64_t checksum(const unsigned char* bytes, size_t size) {
    Hasher hasher;
    for (size_t i = 0; i < size; i += 8) {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < size; ++k) word |= uint64_t(bytes[i + k]) << (8 * k);
        hasher.word(word, 8);
    }
    return hasher.state;
}

// What follows the settings in the bytes: as many numbers as the fields need, all valid. Uniform values may reach
// beyond what may be written, since totals are shared out among the nodes.
bool check_fields(Reader reader, const Chain& c, const Settings& s) {
    const auto on = [&](cd_field field) { return (s.fields >> field & 1) != 0; };
    bool good = true;
    const auto numbers = [&](auto number, size_t count, auto valid) {
        for (size_t i = 0; i < count; ++i) {
            walk(reader, number);
            good &= valid(double(number));
        }
    };
    const auto shared = [](double value) { return value >= 0 && (value <= 1e100 || isinf(value)); };
    for (size_t i = 0; i < c.nodes; ++i) {
        uint8_t pin = 0;
        walk(reader, pin);
        good &= pin <= CD_NODE_MATCHED && (pin != CD_NODE_MATCHED || (!s.ring && (i == 0 || i + 1 == c.nodes)));
    }
    if (on(CD_MASS)) numbers(0.0, c.nodes, [](double mass) { return mass >= 1e-100 && mass <= 1e100; });
    if (on(CD_STIFFNESS)) numbers(0.0, c.springs + size_t(s.ring), shared);
    if (on(CD_BEND)) numbers(0.0, c.nodes, [&](double bend) { return shared(bend) && isfinite(bend); });
    if (on(CD_TARGET)) numbers(0.0, 2 * c.nodes, valid_parameter);
    const auto per_line = [&](auto zero) {
        numbers(zero, 2 * c.nodes * c.lines, [](double) { return true; }); // a state that diverged can be saved too
        numbers(zero, size_t(on(CD_FORCE) + on(CD_TARGET)) * c.nodes * c.lines,
                [](double value) { return isfinite(value); });
    };
    if (c.precision == CD_FLOAT64) per_line(0.0);
    else per_line(0.0f);
    return good && reader.whole && reader.from == reader.end;
}

} // namespace

uint64_t hash_chain(const Chain& c) {
    Hasher hasher;
    walk_chain(hasher, c);
    return hasher.state;
}

size_t saved_size(const Chain& c) {
    Counter counter;
    Shape shape = shape_of(c);
    Settings settings = settings_of(c);
    walk_shape(counter, shape);
    walk_settings(counter, settings);
    size_t arrays = 2 + (c.force ? 1 : 0) + (c.target ? 1 : 0);
    size_t doubles = c.node_mass.count + c.spring_stiffness.count + c.node_bend.count + 2 * c.attach_stiffness.count;
    return kHeader + counter.size + c.nodes + doubles * sizeof(double) + arrays * c.nodes * c.lines * number_size(c);
}

void save_chain(const Chain& c, unsigned char* out) {
    Writer body{out + kHeader};
    walk_chain(body, c);
    uint64_t magic = kMagic, sum = checksum(out + kHeader, size_t(body.to - out) - kHeader);
    uint32_t format = kFormat, kind = kKindChain;
    Writer header{out};
    walk(header, magic), walk(header, format), walk(header, kind), walk(header, sum);
}

cd_status load_chain(const char* function, Chain& c, const unsigned char* bytes, size_t size) {
    Reader reader{bytes, bytes + size};
    uint64_t magic = 0, sum = 0;
    uint32_t format = 0, kind = 0;
    walk(reader, magic), walk(reader, format), walk(reader, kind), walk(reader, sum);
    if (!reader.whole || magic != kMagic)
        return fail(CD_ERROR_FORMAT, function, "these %zu bytes are no saved state", size);
    if (format != kFormat)
        return fail(CD_ERROR_FORMAT, function, "format version is %u, this library reads %u", format, kFormat);
    if (kind != kKindChain)
        return fail(CD_ERROR_FORMAT, function, "kind of object is %u, a chain is %u", kind, kKindChain);
    if (checksum(reader.from, size - kHeader) != sum)
        return fail(CD_ERROR_FORMAT, function, "the checksum of %zu bytes does not fit: damaged or cut short", size);

    Shape shape{};
    Settings settings{};
    walk_shape(reader, shape);
    if (!reader.whole) return fail(CD_ERROR_FORMAT, function, "%zu bytes are too few", size);
    if (!(shape == shape_of(c)))
        return fail(
            CD_ERROR_MISMATCH, function,
            "saved from %zu strands, %zu springs, %zu components, precision %d; this chain has %zu, %zu, %zu, %d",
            size_t(shape.strands), size_t(shape.springs), size_t(shape.components), int(shape.precision), c.strands,
            c.springs, c.components, int(c.precision));
    walk_settings(reader, settings);
    if (!reader.whole || !valid(c, settings) || !check_fields(reader, c, settings))
        return fail(CD_ERROR_FORMAT, function, "a number in these %zu bytes is not valid", size);
    if (!set_features(c, features_of(settings)))
        return fail(CD_ERROR_MEMORY, function, "no memory for the saved fields");
    apply(c, settings);
    walk_fields(reader, c);
    c.diverged = !all_finite(c);
    return CD_OK;
}

cd_status copy_chain(const char* function, Chain& c, const Chain& source) {
    if (!(shape_of(c) == shape_of(source)))
        return fail(
            CD_ERROR_MISMATCH, function,
            "the source has %zu strands, %zu springs, %zu components, precision %d; this chain has %zu, %zu, %zu, %d",
            source.strands, source.springs, source.components, int(source.precision), c.strands, c.springs,
            c.components, int(c.precision));
    if (!set_features(c, features(source))) return fail(CD_ERROR_MEMORY, function, "no memory for the source's fields");
    apply(c, settings_of(source));
    c.diverged = source.diverged;
    const auto copy = [](auto& to, const auto& from) {
        if (from) memcpy(to.data, from.data, from.bytes());
    };
    copy(c.pin, source.pin), copy(c.node_mass, source.node_mass), copy(c.spring_stiffness, source.spring_stiffness);
    copy(c.node_bend, source.node_bend), copy(c.attach_stiffness, source.attach_stiffness);
    copy(c.attach_damping, source.attach_damping), copy(c.position, source.position);
    copy(c.velocity, source.velocity), copy(c.force, source.force), copy(c.target, source.target);
    return CD_OK;
}

} // namespace cd
