// What a chain consists of, for model/keep.hh. The bytes hold pins, then numbers per node or spring, then the state.
#include <math.h>

#include "model/chain.hh"
#include "model/keep.hh"

namespace cd {

namespace {

struct ChainKeep {
    using Object = Chain;
    using Settings = KeptSettings<ChainSettings>;
    // Among the bits of fields: the settings of ropes follow, those of air, the strength, what ropes touch, and how
    // much of that are beds and callbacks.
    static constexpr uint32_t kOfRopes = 1u << 31, kOfAir = 1u << 30, kOfStrength = 1u << 29, kOfContacts = 1u << 28;
    static constexpr uint32_t kOfShapes = 1u << 27;
    // The rest angle follows, and the field of them, which has no bit of its own: in the place of fields never kept so.
    static constexpr uint32_t kOfAngle = 1u << CD_STRAIN, kAngles = 1u << CD_TENSION;
    static constexpr Kind kind = {CD_KIND_CHAIN, "chain", {"strands", "springs"}};

    static Shape shape_of(const Chain& c) { return {{c.strands, c.springs}, c.components, c.precision}; }

    static Settings settings_of(const Chain& c) {
        Settings s{keep_body(c), c};
        if (c.spring_stiffness) s.fields |= 1u << CD_STIFFNESS;
        if (c.node_bend) s.fields |= 1u << CD_BEND;
        if (c.spring_length) s.fields |= 1u << CD_REST_LENGTH;
        if (c.spring_strength) s.fields |= 1u << CD_STRENGTH;
        if (c.node_angle) s.fields |= kAngles;
        if (c.rope.angle != 0) s.fields |= kOfAngle;
        if (!(c.rope == RopeSettings())) s.fields |= kOfRopes;
        if (!(c.air == AirSettings())) s.fields |= kOfAir;
        if (c.rope.breaks()) s.fields |= kOfStrength;
        if (s.colliders > 0 || c.rope.thickness > 0) s.fields |= kOfContacts;
        if (s.has_shapes()) s.fields |= kOfShapes;
        return s;
    }

    static void apply(Chain& c, const Settings& s) {
        static_cast<BodySettings&>(c) = s.body;
        static_cast<ChainSettings&>(c) = s.own;
    }

    static Features features_of(const Settings& s) {
        return {features_of_body(s, s.own.bend > 0, s.own.air),
                s.on(CD_STIFFNESS),
                s.on(CD_BEND),
                s.own.ring != 0,
                s.own.rope.length > 0,
                s.on(CD_REST_LENGTH),
                s.on(CD_STRENGTH),
                s.own.rope.angle != 0,
                (s.fields & kAngles) != 0};
    }

    static void walk_settings(AnyWalker& w, Settings& s) {
        walk_body<ChainKeep>(w, s);
        RopeSettings& rope = s.own.rope;
        if (s.fields & kOfRopes)
            walk(w, rope.length), walk(w, rope.push), walk(w, rope.tolerance), walk(w, rope.most_iterations);
        if (s.fields & kOfAir) walk_air(w, s.own.air);
        if (s.fields & kOfStrength) walk(w, rope.strength);
        if (s.fields & kOfContacts) walk(w, s.colliders), walk(w, rope.thickness);
        if (s.fields & kOfShapes) walk(w, s.beds), walk(w, s.callbacks);
        if (s.fields & kOfAngle) walk(w, rope.angle);
    }
    static void walk_choices(AnyWalker& w, ChainSettings& s) { walk(w, s.ring); }
    static void walk_numbers(AnyWalker& w, ChainSettings& s) { walk(w, s.stiffness), walk(w, s.bend); }

    static bool valid(const Chain& c, const Settings& s) {
        const uint32_t optional =
            1u << CD_MASS | 1u << CD_STIFFNESS | 1u << CD_BEND | 1u << CD_FORCE | 1u << CD_TARGET | KeptBody::kOfSleep;
        const uint32_t of_ropes =
            s.fields & (kOfRopes | kOfAir | kOfStrength | kOfContacts | kOfShapes | kOfAngle | kAngles |
                        1u << CD_REST_LENGTH | 1u << CD_WIND | 1u << CD_STRENGTH | KeptBody::kOfLoads);
        return valid_body(s) && (s.fields & ~(optional | of_ropes)) == 0 &&
               (s.own.ring == 0 || (s.own.ring == 1 && c.nodes >= 3)) && valid_parameter(s.own.bend) &&
               valid_rope(c, s.own.rope, of_ropes) && valid_air(c, s.own.air) && valid_strength(s) &&
               valid_angle(c, s) && valid_contacts(s, s.own.rope.thickness) && are_told(s) &&
               (valid_parameter(s.own.stiffness) || valid_infinite(s.own.stiffness, s.own.rope.length));
    }

    static bool valid_infinite(double stiffness, double length) {
        return isinf(stiffness) && stiffness > 0 && length > 0;
    }
    static bool valid_rope(const Chain& c, const RopeSettings& rope, uint32_t fields) {
        if (rope == RopeSettings()) return fields == 0;
        const bool has_length = can_have_lengths(c) && valid_mass(rope.length);
        return (has_length || (rope.length == 0 && fields == kOfRopes)) && (rope.push == 0 || rope.push == 1) &&
               rope.tolerance >= kLeastTolerance && rope.tolerance <= kMostTolerance && rope.most_iterations >= 1 &&
               rope.most_iterations <= kMostIterations;
    }

    // What differs from the defaults is told, and nothing else.
    static bool are_told(const Settings& s) {
        const bool contacts = s.colliders > 0 || s.own.rope.thickness > 0;
        return contacts == ((s.fields & kOfContacts) != 0) && s.has_shapes() == ((s.fields & kOfShapes) != 0) &&
               (s.own.air == AirSettings()) == ((s.fields & kOfAir) == 0);
    }

    static bool valid_angle(const Chain& c, const Settings& s) {
        const double angle = s.own.rope.angle;
        const bool told = (s.fields & kOfAngle) != 0, any = told || (s.fields & kAngles) != 0;
        return told == (angle != 0) && (!any || (can_curl(c) && s.own.rope.length > 0)) && fabs(angle) <= most_angle(c);
    }

    // What may break has stiffnesses of its own.
    static bool valid_strength(const Settings& s) {
        const double strength = s.own.rope.strength;
        const bool holds = isinf(strength) && strength > 0, told = (s.fields & kOfStrength) != 0;
        return (told ? valid_mass(strength) : holds) && ((holds && !s.on(CD_STRENGTH)) || s.on(CD_STIFFNESS));
    }

    static bool check_fields(Reader reader, const Chain& c, const Settings& s) {
        FieldCheck check{reader};
        const SavedNumbers pin = check.here(sizeof(uint8_t));
        const bool rope = CD_WITH_ROPE && s.own.rope.length > 0; // what is left out has been refused
        const size_t own = rope ? c.strands : 1, nodes = c.nodes * own,
                     springs = (c.springs + size_t(s.own.ring)) * own;
        check.numbers(sizeof(uint8_t), nodes, [&](double value, size_t i) {
            const bool end = !s.own.ring && (i < own || i >= nodes - own);
            return is_kind(value) || (end && value == CD_NODE_MATCHED);
        });
        if (s.on(CD_MASS)) check.numbers(sizeof(double), nodes, valid_shared_mass);
        const SavedNumbers stiffness = s.on(CD_STIFFNESS) ? check.here(sizeof(double)) : SavedNumbers{};
        if (s.on(CD_STIFFNESS))
            check.numbers(sizeof(double), springs,
                          [](double k, size_t i) { return valid_shared(k, i) || (isinf(k) && k > 0); });
        if (CD_WITH_BEND && s.on(CD_BEND)) check.numbers(sizeof(double), nodes, valid_shared);
        if (rope && s.on(CD_REST_LENGTH)) check.numbers(sizeof(double), springs, valid_shared_mass);
        if (rope && s.on(CD_STRENGTH))
            check.numbers(sizeof(double), springs,
                          [](double t, size_t) { return valid_mass(t) || (isinf(t) && t > 0); });
        if (rope && (s.fields & kAngles))
            check.numbers(sizeof(double), nodes, [](double angle, size_t) { return fabs(angle) <= kHalfTurn; });
        const SavedNumbers velocity = check_ties_and_state(check, c, layout_of(c), s, nodes);
        if (rope) check.numbers(sizeof(double), springs, [](double t, size_t) { return isfinite(t) != 0; });
        if (!check_surroundings(check, c, layout_of(c), s, own)) return false;
        return rope ? pinned_rest(c, pin, velocity) : nodes_are_held(c, s.own.ring != 0, pin, stiffness, velocity);
    }

    // Of a rope, whether its pinned nodes rest.
    static bool pinned_rest(const Chain& c, SavedNumbers pin, SavedNumbers velocity) {
        bool good = true;
        for (size_t i = 0; i < c.nodes * c.strands; ++i)
            for (size_t k = 0; k < c.components; ++k)
                good &= pin[i] != CD_NODE_PINNED || velocity[i * c.components + k] == 0;
        return good;
    }

    // Whether pinned nodes rest, and welded groups move as one and hold one held node at the most.
    static bool nodes_are_held(const Chain& c, bool ring, SavedNumbers pin, SavedNumbers stiffness,
                               SavedNumbers velocity) {
        const size_t springs = c.springs + size_t(ring);
        const auto is_welded = [&](size_t i) { return stiffness.from && i < springs && isinf(stiffness[i]); };
        const auto is_held = [&](size_t i) { return holds(pin[i]); };
        if (!groups_are_sound(c.nodes, ring, is_welded, is_held)) return false;
        bool good = true;
        for (size_t i = 0; i < c.nodes; ++i) {
            const size_t next = i + 1 < c.nodes ? i + 1 : 0;
            const bool pinned = pin[i] == CD_NODE_PINNED, welded = is_welded(i);
            for (size_t line = 0; line < c.lines && (pinned || welded); ++line) {
                const double v = velocity[i * c.lines + line], other = velocity[next * c.lines + line];
                good &= !pinned || v == 0;
                good &= !welded || v == other || (v != v && other != other);
            }
        }
        return good;
    }
};

} // namespace

uint64_t hash(const Chain& c) { return hash_object<ChainKeep>(c); }
#if CD_WITH_SAVE
size_t save_size(const Chain& c) { return saved_size<ChainKeep>(c); }
void save(const Chain& c, unsigned char* out) { save_object<ChainKeep>(c, out); }
cd_status load(const char* function, Chain& c, const unsigned char* bytes, size_t size) {
    return load_object<ChainKeep>(function, c, bytes, size);
}
#endif
cd_status copy(const char* function, Chain& c, const Chain& source) {
    return copy_object<ChainKeep>(function, c, source);
}

} // namespace cd
