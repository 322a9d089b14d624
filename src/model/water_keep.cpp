// What a water consists of, for model/keep.hh. The bytes hold mask and walls, then the state and the other fields.
#include "model/keep.hh"
#include "model/water_hull.hh"

namespace cd {

// Threads are no part of the state.
static WaterFeatures taken_over(const Water& w, WaterFeatures features) {
    features.parallel = w.parallel.run != nullptr;
    return features;
}

namespace {

constexpr uint32_t bit(cd_field field) { return 1u << field; }
constexpr uint32_t kHullBit = 1u << 31;  // the hulls' number and shape follow, and their numbers come last
constexpr uint32_t kSleepBit = 1u << 30; // the height of what lets it sleep follows
constexpr uint32_t kDepthBit = 1u << 29; // the depths of inflows follow

struct KeptWater {
    WaterSettings own;
    uint32_t fields; // a bit per optional field, by cd_field; kHullBit, kSleepBit, kDepthBit
    HullShape hulls;

    bool on(cd_field field) const { return (fields & bit(field)) != 0; }
    bool periodic(Axis a) const { return own.side[2 * a].kind == CD_BORDER_PERIODIC; }
};

// Goes through the fields in the bytes, in their order, number by number.
struct WaterCheck {
    const Water& w;
    const KeptWater& s;
    FieldCheck check;
    const unsigned char *mask = nullptr, *wall[2] = {};

    // Every number, of so many bytes, those of the spare row and column too: valid(i, j, value).
    template <class Valid> void numbers(size_t size, Valid valid) {
        const size_t columns = w.cells[kX] + 1;
        check.numbers(size, columns * (w.cells[kY] + 1),
                      [&](double value, size_t at) { return valid(at % columns, at / columns, value); });
    }
    template <class Valid> void cells(size_t size, double spare, Valid valid) {
        numbers(size, [&](size_t i, size_t j, double value) {
            return i < w.cells[kX] && j < w.cells[kY] ? valid(i, j, value) : value == spare;
        });
    }
    // Along a periodic direction the last face of a line is the first.
    template <class Valid> void faces(size_t size, Axis a, Valid valid) {
        const size_t columns = w.cells[kX] + 1;
        const unsigned char* const start = check.reader.from;
        numbers(size, [&](size_t i, size_t j, double value) {
            if (i >= faces_along(w, a, kX) || j >= faces_along(w, a, kY)) return value == 0;
            if (!valid(i, j, value)) return false;
            if (!s.periodic(a) || (a == kX ? i : j) < w.cells[a]) return true;
            Reader first{start + (a == kX ? j * columns : i) * size, check.reader.end};
            const double same = read_number(first, size);
            return same == value || (isnan(same) && isnan(value));
        });
    }
    // One that diverged need not be finite where steps have written.
    void hulls() {
        double numbers[kHullNumbers];
        const size_t all = s.hulls.numbers();
        Hull h{};
        size_t plates = 0;
        check.numbers(sizeof(double), s.hulls.count * all, [&](double value, size_t at) {
            const size_t k = at % all;
            if (k >= kHullNumbers) {
                plates += value >= 0 ? 1 : 0;
                const bool good = value <= kMost && value >= -1;
                return good && (k + 1 < all || is_off(h) || plates > 0);
            }
            numbers[k] = value;
            if (k + 1 < kHullNumbers) return true;
            memcpy(&h, numbers, sizeof h);
            plates = 0;
            return valid_hull(h, s.own.size, w.cells);
        });
    }
    bool there(size_t i, size_t j) const { return !mask || mask[byte_place(w, i, j)] != 0; }
    bool can_cross(Axis a, size_t i, size_t j) const {
        return crossable(
            w.cells, s.own.side, a, i, j, [&](size_t x, size_t y) { return there(x, y); },
            [&](Axis axis, size_t x, size_t y) { return wall[axis] && wall[axis][byte_place(w, x, y)] != 0; });
    }

    // A state that diverged can be saved too, so that depths and velocities need not be finite.
    bool all_good() {
        const auto finite = [](size_t, size_t, double value) { return isfinite(value) != 0; };
        const auto is_bit = [](size_t, size_t, double value) { return value <= 1; };
        if (s.on(CD_MASK)) mask = check.reader.from, cells(1, 1, is_bit);
        for (Axis a : {kX, kY})
            if (s.on(a == kX ? CD_WALL_X : CD_WALL_Y)) wall[a] = check.reader.from, faces(1, a, is_bit);
        if (!check.reader.whole) return false; // below, mask and walls are read
        const size_t size = number_size(w);
        cells(size, 0, [&](size_t i, size_t j, double d) { return there(i, j) ? !(d < 0) : d == 0; });
        cells(size, 0, finite);
        for (Axis a : {kX, kY})
            faces(size, a, [&](size_t i, size_t j, double u) { return u == 0 || can_cross(a, i, j); });
        if (s.on(CD_SOURCE)) cells(size, 0, finite);
        if (s.on(CD_PRESSURE)) cells(size, 0, finite);
        for (Axis a : {kX, kY})
            if (s.on(a == kX ? CD_FORCE_X : CD_FORCE_Y)) faces(size, a, finite);
        if (s.fields & kHullBit) hulls();
        return check.all_good();
    }
};

struct WaterKeep {
    using Object = Water;
    using Settings = KeptWater;
    static constexpr Kind kind = {CD_KIND_WATER, "water", {"cells along x", "along y"}};

    static Shape shape_of(const Water& w) { return {{w.cells[kX], w.cells[kY]}, 1, w.precision}; }

    static Settings settings_of(const Water& w) {
        Settings s{w, 0, w.hull_shape};
        if (w.hull_shape.count > 0) s.fields |= kHullBit;
        if (w.sleep > 0) s.fields |= kSleepBit;
        for (double depth : w.inflow_depth)
            if (depth > 0) s.fields |= kDepthBit;
        if (w.mask) s.fields |= bit(CD_MASK);
        if (w.wall[kX]) s.fields |= bit(CD_WALL_X);
        if (w.wall[kY]) s.fields |= bit(CD_WALL_Y);
        if (w.source) s.fields |= bit(CD_SOURCE);
        if (w.pressure) s.fields |= bit(CD_PRESSURE);
        if (w.force[kX]) s.fields |= bit(CD_FORCE_X);
        if (w.force[kY]) s.fields |= bit(CD_FORCE_Y);
        return s;
    }
    static void apply(Water& w, const Settings& s) { static_cast<WaterSettings&>(w) = s.own; }

    static WaterFeatures features_of(const Settings& s) {
        return {s.own.method,
                s.own.momentum,
                s.on(CD_SOURCE),
                s.on(CD_PRESSURE),
                {s.on(CD_FORCE_X), s.on(CD_FORCE_Y)},
                s.on(CD_MASK),
                {s.on(CD_WALL_X), s.on(CD_WALL_Y)},
                false,
                s.hulls,
                s.own.sleep > 0};
    }

    static void walk_settings(AnyWalker& w, Settings& s) {
        WaterSettings& o = s.own;
        walk(w, o.size[kX]), walk(w, o.size[kY]);
        walk(w, o.method), walk(w, o.momentum), walk(w, o.bed_rule), walk(w, o.first);
        for (WaterSide& side : o.side) walk(w, side.kind), walk(w, side.value), walk(w, side.rate);
        walk(w, s.fields), walk(w, o.lambda);
        walk(w, o.gravity), walk(w, o.density), walk(w, o.drag), walk(w, o.manning);
        walk(w, o.account.initial), walk(w, o.account.in), walk(w, o.account.out);
        walk(w, o.clock.start), walk(w, o.clock.dt), walk(w, o.clock.counted), walk(w, o.clock.steps);
        if ((s.fields & kSleepBit) != 0) walk(w, o.sleep);
        for (double& depth : o.inflow_depth)
            if ((s.fields & kDepthBit) != 0) walk(w, depth);
        if ((s.fields & kHullBit) == 0) return;
        for (size_t* size : {&s.hulls.count, &s.hulls.along, &s.hulls.across}) {
            uint64_t number = *size;
            walk(w, number);
            *size = size_t(number);
        }
    }

    static bool valid_hulls(const Settings& s) {
        if ((s.fields & kHullBit) == 0) return true;
        const auto within = [](size_t size, size_t most) { return size >= 1 && size <= most; };
        return within(s.hulls.count, kMostHulls) && within(s.hulls.along, kMostPlates) &&
               within(s.hulls.across, kMostPlates);
    }
    static bool valid_side(const WaterSide& side) {
        if (side.kind == CD_BORDER_WALL || side.kind == CD_BORDER_PERIODIC) return side.value == 0 && side.rate == 0;
        return has_value(side.kind) && isfinite(side.value) && fabs(side.rate) <= kMost;
    }
    static bool valid(const Water&, const Settings& s) {
        const WaterSettings& o = s.own;
        uint32_t optional = 0;
        for (cd_field field : {CD_MASK, CD_WALL_X, CD_WALL_Y, CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y})
            optional |= bit(field);
        const auto is_one_of_two = [](int32_t choice) { return choice == 0 || choice == 1; };
        bool good = (s.fields & ~(optional | kHullBit | kSleepBit | kDepthBit)) == 0 && valid_hulls(s);
        good &= (s.fields & kSleepBit) == 0 || (o.sleep > 0 && o.sleep <= kMost);
        good &= o.method >= CD_METHOD_IMPLICIT && o.method <= CD_METHOD_SYMPLECTIC_EULER;
        good &= is_one_of_two(o.momentum) && is_one_of_two(o.bed_rule) && is_one_of_two(o.first);
        for (const WaterSide& side : o.side) good &= valid_side(side);
        for (double depth : o.inflow_depth)
            good &= depth == 0 || (depth >= kLeastInflowDepth && depth <= kMostInflowDepth);
        for (Axis a : {kX, kY}) {
            good &= o.size[a] >= kLeastCell && o.size[a] <= kMostCell;
            good &= s.periodic(a) == (o.side[2 * a + 1].kind == CD_BORDER_PERIODIC);
        }
        good &= o.lambda >= 0 && o.lambda <= 1 && o.gravity >= 0 && o.gravity <= kMostGravity;
        good &= o.density >= kLeastDensity && o.density <= kMostDensity;
        good &= valid_parameter(o.drag) && o.manning >= 0 && o.manning <= kMostManning;
        good &= !(o.account.in < 0) && !(o.account.out < 0);
        return good && o.clock.is_possible();
    }

    static bool check_fields(Reader reader, const Water& w, const Settings& s) {
        return WaterCheck{w, s, {reader}}.all_good();
    }
};

} // namespace

uint64_t hash(const Water& w) { return hash_object<WaterKeep>(w); }
#if CD_WITH_SAVE
size_t save_size(const Water& w) { return saved_size<WaterKeep>(w); }
void save(const Water& w, unsigned char* out) { save_object<WaterKeep>(w, out); }
cd_status load(const char* function, Water& w, const unsigned char* bytes, size_t size) {
    return load_object<WaterKeep>(function, w, bytes, size);
}
#endif
cd_status copy(const char* function, Water& w, const Water& source) {
    return copy_object<WaterKeep>(function, w, source);
}

} // namespace cd
