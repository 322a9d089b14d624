// How objects are kept: as bytes, as a hash, and as a copy of another. What an object consists of is listed once, in a
// struct K that belongs to it (ChainKeep in model/chain_keep.cpp), and here is what is made of that list.
//
//   header   "contdyn" and a zero, format version, kind of object, checksum of the rest and its size
//   shape    two sizes, components, precision
//   settings parameters, clock, which fields follow
//   fields   per node or spring in double, then per node and component in the object's precision
//
// K::Object and K::Settings, and beside them
//   kind                          the kind of object
//   shape_of(x), settings_of(x)
//   walk_settings(walker, s)      shows each setting
//   valid(x, s)                   whether an object of this shape may have them
//   check_fields(reader, x, s)    whether what follows them in the bytes is what the fields need, each number valid
//   features_of(s), apply(x, s)
// and Object::each_field(f, x...), which makes f(x.field...) for each field in the order of the bytes; those per node
// and component are Array<char>.
#pragma once

#include "base/archive.hh"
#include "base/status.hh"
#include "model/body.hh"

namespace cd {

struct Kind {
    uint32_t number;             // a cd_kind
    const char *name, *sizes[2]; // for messages
};

struct Shape {
    uint64_t sizes[2], components;
    int32_t precision;

    bool operator==(const Shape& o) const {
        return sizes[0] == o.sizes[0] && sizes[1] == o.sizes[1] && components == o.components &&
               precision == o.precision;
    }
};

constexpr size_t kHeader = 8 + 4 + 4 + 8;

// Writes the header of saved bytes, of which all but the header is there; and reads it.
void write_header(const Kind& kind, unsigned char* bytes, size_t size);
cd_status read_header(const char* function, const Kind& kind, Reader& reader, size_t size);

// The number of the kind of object that bytes were saved of, and its shape.
cd_status read_shape(const char* function, const unsigned char* bytes, size_t size, uint32_t& number, Shape& shape);

// Fails because the shape that comes from `source` is not the one here.
cd_status shapes_differ(const char* function, const Kind& kind, const char* source, const Shape& from,
                        const Shape& here);

void walk_shape(AnyWalker w, Shape& s);

// One field: its numbers, without the padding of the state's rows, and the bytes they take.
template <class W, class X, class T> void walk_field(W& w, const X&, const Array<T>& array) {
    for (size_t i = 0; i < array.count; ++i) walk(w, array[i]);
}
template <class W, class X> void walk_field(W& w, const X& x, const Array<char>& array) {
    each_number(x, layout_of(x), array, [&](auto& number) { walk(w, number); });
}
template <class X, class T> size_t field_size(const X&, const Array<T>& array) { return array.bytes(); }
template <class X> size_t field_size(const X& x, const Array<char>& array) {
    return array ? layout_of(x).rows * layout_of(x).width * number_size(x) : 0;
}

template <class K> void walk_head(AnyWalker w, const typename K::Object& x) {
    Shape shape = K::shape_of(x);
    typename K::Settings settings = K::settings_of(x);
    walk_shape(w, shape);
    K::walk_settings(w, settings);
}
template <class W, class X> void walk_fields(W& w, const X& x) {
    X::each_field([&](const auto& array) { walk_field(w, x, array); }, x);
}

template <class K> uint64_t hash_object(const typename K::Object& x) {
    Hasher hasher;
    walk_head<K>(AnyWalker(hasher), x);
    walk_fields(hasher, x);
    return hasher.state;
}

template <class K> size_t saved_size(const typename K::Object& x) {
    Counter head;
    walk_head<K>(AnyWalker(head), x);
    size_t fields = 0;
    K::Object::each_field([&](const auto& array) { fields += field_size(x, array); }, x);
    return kHeader + head.size + fields;
}

template <class K> void save_object(const typename K::Object& x, unsigned char* out) {
    Writer body{out + kHeader};
    walk_head<K>(AnyWalker(body), x);
    walk_fields(body, x);
    write_header(K::kind, out, size_t(body.to - out));
}

// The features that an object takes over; what is no part of the state stays as it is here.
template <class X, class F> F taken_over(const X&, const F& features) { return features; }

template <class K>
cd_status load_object(const char* function, typename K::Object& x, const unsigned char* bytes, size_t size) {
    Reader reader{bytes, bytes + size};
    if (const cd_status status = read_header(function, K::kind, reader, size)) return status;
    Shape shape{};
    typename K::Settings settings{};
    AnyWalker head(reader);
    walk_shape(head, shape);
    if (!reader.whole) return fail(CD_ERROR_FORMAT, function, "size is %zu, too few for a saved state", size);
    if (!(shape == K::shape_of(x)))
        return shapes_differ(function, K::kind, "the object in bytes", shape, K::shape_of(x));
    K::walk_settings(head, settings);
    bool valid = reader.whole && K::valid(x, settings);
    const auto wanted = taken_over(x, K::features_of(settings));
    const char* const part = valid ? left_out(wanted) : nullptr;
    if (part) return fail(CD_ERROR_UNSUPPORTED, function, "%s in these bytes, but left out of this build", part);
    valid = valid && K::check_fields(reader, x, settings);
    if (!valid) return fail(CD_ERROR_FORMAT, function, "a number in these %zu bytes is not valid", size);
    if (!set_features(x, wanted)) return fail(CD_ERROR_MEMORY, function, "no memory for the saved fields");
    K::apply(x, settings);
    walk_fields(reader, x);
    forget_callbacks(x);
    x.prepared_dt = 0;
    x.diverged = !all_finite(x);
    return CD_OK;
}

template <class K>
cd_status copy_object(const char* function, typename K::Object& x, const typename K::Object& source) {
    const Shape from = K::shape_of(source), here = K::shape_of(x);
    if (!(from == here)) return shapes_differ(function, K::kind, "source", from, here);
    if (!set_features(x, taken_over(x, features(source))))
        return fail(CD_ERROR_MEMORY, function, "no memory for the source's fields");
    K::apply(x, K::settings_of(source));
    const auto copy = [](auto& to, const auto& from_array) {
        if (from_array) memcpy(to.data, from_array.data, from_array.bytes());
    };
    K::Object::each_field(copy, x, source);
    forget_callbacks(x);
    x.prepared_dt = 0;
    x.diverged = source.diverged;
    return CD_OK;
}

// Reads one number of so many bytes: an unsigned byte, a float or a double.
double read_number(Reader& reader, size_t size);

// Numbers that lie one after the other in saved bytes, all of which are there.
struct SavedNumbers {
    const unsigned char* from = nullptr; // null: none are saved
    size_t size = 1;                     // bytes of one

    double operator[](size_t i) const {
        Reader reader{from + i * size, from + (i + 1) * size};
        return read_number(reader, size);
    }
};

// Reads the numbers of fields, to see whether they are all valid.
struct FieldCheck {
    Reader reader;
    bool good = true;

    // Those that come next. size: of one.
    SavedNumbers here(size_t size) const { return {reader.from, size}; }

    template <class Valid> void numbers(size_t size, size_t count, Valid valid) {
        for (size_t i = 0; i < count; ++i) good &= valid(read_number(reader, size), i);
    }
    bool all_good() const { return good && reader.whole && reader.from == reader.end; }
};

// ---- what is the same for every body --------------------------------------------------------------------------------

struct KeptBody {
    BodySettings body;
    uint32_t fields;    // a bit per optional field, by cd_field
    uint64_t colliders; // how many
    uint64_t beds;      // numbers of all beds
    uint64_t callbacks; // how many colliders are CD_SHAPE_CALLBACK

    // Among the bits, where a field of water alone would stand: when parts fall asleep, and how calm each is, follow.
    static constexpr uint32_t kOfSleep = 1u << 21;
    // What colliders bear follows.
    static constexpr uint32_t kOfLoads = 1u << 20;

    bool has_shapes() const { return beds > 0 || callbacks > 0; }

    bool sleeps() const { return (fields & kOfSleep) != 0; }
    bool tells_loads() const { return (fields & kOfLoads) != 0; }
    bool on(cd_field field) const { return (fields >> field & 1) != 0; }
};

// Own: what an object has beyond that. K::walk_choices and K::walk_numbers show it.
template <class Own> struct KeptSettings : KeptBody { Own own; };

template <class K> void walk_body(AnyWalker& w, typename K::Settings& s) {
    BodySettings& b = s.body;
    walk(w, b.method), walk(w, b.mass_rule);
    K::walk_choices(w, s.own);
    walk(w, s.fields), walk(w, b.lambda), walk(w, b.mass);
    K::walk_numbers(w, s.own);
    walk(w, b.drag), walk(w, b.damping);
    for (double& g : b.gravity) walk(w, g);
    walk(w, b.clock.start), walk(w, b.clock.dt), walk(w, b.clock.counted), walk(w, b.clock.steps);
    if (s.sleeps()) walk(w, b.sleep_speed), walk(w, b.sleep_seconds);
}

KeptBody keep_body(const Body& b);
bool valid_body(const KeptBody& s);
BodyFeatures features_of_body(const KeptBody& s, bool bend, const AirSettings& air);

void walk_air(AnyWalker& w, AirSettings& s);
// Of ropes and cloth: what is around them.
bool valid_air(const Body& b, const AirSettings& air);
bool valid_contacts(const KeptBody& s, double thickness);

// Uniform values may reach beyond what may be written, since totals are shared out among the nodes.
inline bool valid_shared(double value, size_t) { return value >= 0 && value <= 1e100; }
inline bool valid_shared_mass(double value, size_t) { return value >= 1e-100 && value <= 1e100; }

// What comes after an object's own fields: attachments, `ties` nodes', and the state. Tells where the velocities lie.
SavedNumbers check_ties_and_state(FieldCheck& check, const Body& b, const Layout& layout, const KeptBody& s,
                                  size_t ties);
// What comes last: winds, colliders, beds and how calm each part is. Whether these and all that was checked are good.
bool check_surroundings(FieldCheck& check, const Body& b, const Layout& layout, const KeptBody& s, size_t parts);

} // namespace cd
