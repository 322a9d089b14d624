#include "model/keep.hh"

#include "base/whole.hh"

namespace cd {

constexpr uint64_t kMagic = 0x006e7964746e6f63; // "contdyn"
constexpr uint32_t kFormat = 1;

static uint64_t checksum(const unsigned char* bytes, size_t size) {
    Hasher hasher;
    hasher.word(size, 8);
    for (size_t i = 0; i < size; i += 8) {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < size; ++k) word |= uint64_t(bytes[i + k]) << (8 * k);
        hasher.word(word, 8);
    }
    return hasher.state;
}

void walk_shape(AnyWalker w, Shape& s) {
    walk(w, s.sizes[0]), walk(w, s.sizes[1]), walk(w, s.components), walk(w, s.precision);
}
void walk_air(AnyWalker& w, AirSettings& s) {
    walk(w, s.along), walk(w, s.across), walk(w, s.wind[0]), walk(w, s.wind[1]), walk(w, s.wind[2]);
}

void write_header(const Kind& kind, unsigned char* bytes, size_t size) {
    Writer header{bytes};
    walk(header, kMagic), walk(header, kFormat), walk(header, kind.number);
    walk(header, checksum(bytes + kHeader, size - kHeader));
}

static cd_status read_number(const char* function, Reader& reader, size_t size, uint32_t& number) {
    uint64_t magic = 0, sum = 0;
    uint32_t format = 0;
    walk(reader, magic), walk(reader, format), walk(reader, number), walk(reader, sum);
    if (!reader.whole || magic != kMagic)
        return fail(CD_ERROR_FORMAT, function, "bytes are no saved state: %zu of them", size);
    if (format != kFormat)
        return fail(CD_ERROR_FORMAT, function, "bytes have the format version %u, this library reads %u", format,
                    kFormat);
    if (checksum(reader.from, size - kHeader) != sum)
        return fail(CD_ERROR_FORMAT, function,
                    "the checksum of %zu bytes does not fit: damaged, cut short or followed by others", size);
    return CD_OK;
}

cd_status read_header(const char* function, const Kind& kind, Reader& reader, size_t size) {
    uint32_t number = 0;
    if (const cd_status status = read_number(function, reader, size, number)) return status;
    if (number == kind.number) return CD_OK;
    static constexpr char names[][sizeof "membrane"] = {"none", "chain", "membrane", "water"}; // by cd_kind
    const char* saved = names[number > CD_KIND_WATER ? 0 : number];
    return fail(CD_ERROR_FORMAT, function, "bytes are of the kind of object %u, %s, and a %s is of the kind %u", number,
                saved, kind.name, kind.number);
}

cd_status read_shape(const char* function, const unsigned char* bytes, size_t size, uint32_t& number, Shape& shape) {
    Reader reader{bytes, bytes + size};
    if (const cd_status status = read_number(function, reader, size, number)) return status;
    walk_shape(AnyWalker(reader), shape);
    bool good = reader.whole && number >= CD_KIND_CHAIN && number <= CD_KIND_WATER;
    good &= shape.precision == CD_FLOAT32 || shape.precision == CD_FLOAT64;
    good &= shape.sizes[0] <= SIZE_MAX && shape.sizes[1] <= SIZE_MAX && shape.components <= SIZE_MAX;
    return good ? CD_OK : fail(CD_ERROR_FORMAT, function, "a number in these %zu bytes is not valid", size);
}

cd_status shapes_differ(const char* function, const Kind& kind, const char* source, const Shape& from,
                        const Shape& here) {
    return fail(CD_ERROR_MISMATCH, function,
                "%s has %zu %s, %zu %s, %zu components, precision %d; this %s has %zu, %zu, %zu, %d", source,
                size_t(from.sizes[0]), kind.sizes[0], size_t(from.sizes[1]), kind.sizes[1], size_t(from.components),
                int(from.precision), kind.name, size_t(here.sizes[0]), size_t(here.sizes[1]), size_t(here.components),
                int(here.precision));
}

double read_number(Reader& reader, size_t size) {
    const auto read = [&](auto number) {
        walk(reader, number);
        return double(number);
    };
    if (size == sizeof(float)) return read(0.0f);
    return size == sizeof(double) ? read(0.0) : read(uint8_t(0));
}

// ---- what is the same for every body --------------------------------------------------------------------------------

KeptBody keep_body(const Body& b) {
    const auto bit = [](bool on, cd_field field) { return uint32_t(on) << field; };
    const ColliderSizes colliders = collider_sizes(b, collider_count(b));
    return {b,
            bit(bool(b.node_mass), CD_MASS) | bit(bool(b.force), CD_FORCE) | bit(bool(b.target), CD_TARGET) |
                bit(bool(b.wind), CD_WIND) | (b.sleep_speed > 0 ? KeptBody::kOfSleep : 0) |
                (b.loads ? KeptBody::kOfLoads : 0),
            colliders.count, colliders.beds, colliders.callbacks};
}

bool valid_body(const KeptBody& kept) {
    const BodySettings& s = kept.body;
    bool good = s.method >= CD_METHOD_IMPLICIT && s.method <= CD_METHOD_STIFF_SECOND;
    good &= s.mass_rule == CD_MASS_EQUAL || s.mass_rule == CD_MASS_HALF_ENDS;
    good &= s.lambda >= 0 && s.lambda <= 1 && valid_mass(s.mass);
    good &= valid_parameter(s.drag) && valid_parameter(s.damping);
    for (double g : s.gravity) good &= fabs(g) <= kMost;
    if (kept.sleeps()) good &= s.sleep_speed > 0 && s.sleep_speed <= kMost && valid_calm_time(s.sleep_seconds);
    return good && s.clock.is_possible();
}

BodyFeatures features_of_body(const KeptBody& s, bool bend, const AirSettings& air) {
    return {s.body.method,
            s.on(CD_MASS),
            s.on(CD_FORCE),
            s.on(CD_TARGET),
            bend,
            air.resists(),
            s.on(CD_WIND),
            s.sleeps(),
            s.tells_loads(),
            {size_t(s.colliders), size_t(s.beds), size_t(s.callbacks)}};
}

bool valid_air(const Body& b, const AirSettings& air) {
    bool good = valid_parameter(air.along) && valid_parameter(air.across);
    for (size_t k = 0; k < 3; ++k) good &= k < b.components ? fabs(air.wind[k]) <= most_of(b) : air.wind[k] == 0;
    return good;
}
bool valid_contacts(const KeptBody& s, double thickness) {
    return s.colliders <= kMostColliders && s.callbacks <= s.colliders && valid_parameter(thickness);
}

static bool is_finite(double number, size_t) { return isfinite(number) != 0; }

SavedNumbers check_ties_and_state(FieldCheck& check, const Body& b, const Layout& layout, const KeptBody& s,
                                  size_t ties) {
    const size_t state = layout.rows * layout.width;
    if (s.on(CD_TARGET))
        check.numbers(sizeof(double), 2 * ties, [](double tie, size_t) { return valid_parameter(tie); });
    const auto any = [](double, size_t) { return true; }; // a state that diverged can be saved too
    check.numbers(number_size(b), state, any);
    const SavedNumbers velocity = check.here(number_size(b));
    check.numbers(number_size(b), state, any);
    check.numbers(number_size(b), (s.on(CD_FORCE) + s.on(CD_TARGET)) * state, is_finite);
    return velocity;
}

static bool valid_collider_number(double number, size_t at) {
    constexpr double kFarthest = 1e200; // places and velocities: of any time the products are finite
    switch (at % kColliderNumbers) {
    case 0: return number >= CD_SHAPE_NONE && number <= CD_SHAPE_CALLBACK && number == whole_below(number);
    case offsetof(Collider, radius) / sizeof(double):
    case offsetof(Collider, friction) / sizeof(double): return valid_parameter(number);
    case offsetof(Collider, since) / sizeof(double): return number >= 0 && number <= kMost;
    default: return fabs(number) <= kFarthest;
    }
}

// Columns, rows and heights of a bed in so many components, which begins at this one of `all` numbers; tells how many
// they are, 0 where they are not valid.
static size_t valid_bed(size_t components, SavedNumbers numbers, size_t at, size_t all) {
    if (components < 2 || all - at < kBedHead) return 0;
    const double columns = numbers[at], rows = numbers[at + 1], most = double(all - at);
    const bool whole = columns == whole_below(columns) && rows == whole_below(rows);
    if (!whole || !(columns >= 2 && columns <= most) || !(components == 3 ? rows >= 2 && rows <= most : rows == 1))
        return 0;
    if (!(columns * rows <= double(all - at - kBedHead))) return 0;
    const size_t taken = kBedHead + size_t(columns) * size_t(rows);
    for (size_t i = kBedHead; i < taken; ++i)
        if (!(fabs(numbers[at + i]) <= kMost)) return 0;
    return taken;
}

// A plane's normal has length 1, a capsule a radius, a bed its heights, and none reaches out of the space that the
// nodes are in.
static bool colliders_are_shaped(const Body& b, const KeptBody& s, SavedNumbers numbers, SavedNumbers beds) {
    constexpr double kNormalError = 1e-12; // of its square
    bool good = true;
    size_t bed_numbers = 0, callbacks = 0;
    for (size_t i = 0; i < s.colliders && good; ++i) {
        Collider it;
        double all[kColliderNumbers];
        for (size_t k = 0; k < kColliderNumbers; ++k) all[k] = numbers[i * kColliderNumbers + k];
        memcpy(&it, all, sizeof it);
        const double square = (it.way[0] * it.way[0] + it.way[1] * it.way[1]) + it.way[2] * it.way[2];
        if (it.shape == CD_SHAPE_PLANE) good &= fabs(square - 1) < kNormalError;
        if (it.shape == CD_SHAPE_CAPSULE) good &= valid_mass(it.radius);
        if (it.shape == CD_SHAPE_CALLBACK) ++callbacks, good &= square == 0;
        if (it.shape == CD_SHAPE_BED) {
            const size_t taken = valid_bed(b.components, beds, bed_numbers, size_t(s.beds));
            good &= taken > 0;
            for (size_t k = 0; k < 3; ++k) good &= k + 1 < b.components ? valid_mass(it.way[k]) : it.way[k] == 0;
            bed_numbers += taken;
        }
        if (it.shape != CD_SHAPE_CAPSULE) good &= it.radius == 0;
        for (size_t k = b.components; k < 3; ++k) good &= it.point[k] == 0 && it.way[k] == 0 && it.velocity[k] == 0;
    }
    return good && bed_numbers == s.beds && callbacks == s.callbacks;
}

bool check_surroundings(FieldCheck& check, const Body& b, const Layout& layout, const KeptBody& s, size_t parts) {
    constexpr bool air = CD_WITH_ROPE || CD_WITH_CLOTH; // what is left out has been refused
    if (air && s.on(CD_WIND)) check.numbers(number_size(b), layout.rows * layout.width, is_finite);
    const SavedNumbers colliders = check.here(sizeof(double));
    SavedNumbers beds = colliders;
    if (air && CD_WITH_CONTACT) {
        check.numbers(sizeof(double), size_t(s.colliders) * kColliderNumbers, valid_collider_number);
        beds = check.here(sizeof(double));
        if (s.beds > size_t(check.reader.end - check.reader.from) / sizeof(double)) return false;
        check.numbers(sizeof(double), size_t(s.beds), [](double, size_t) { return true; });
    }
    if (CD_WITH_SLEEP && s.sleeps())
        check.numbers(sizeof(double), parts, [&](double calm, size_t) {
            return calm == kStirred || (calm >= 0 && calm <= s.body.sleep_seconds);
        });
    const size_t loads = air && CD_WITH_CONTACT && s.tells_loads() ? load_numbers(size_t(s.colliders), parts) : 0;
    if (loads > size_t(check.reader.end - check.reader.from) / sizeof(double)) return false;
    check.numbers(sizeof(double), loads, is_finite);
    return check.all_good() && (!(air && CD_WITH_CONTACT) || colliders_are_shaped(b, s, colliders, beds));
}

} // namespace cd
