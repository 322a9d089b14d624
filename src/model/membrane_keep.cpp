// What a membrane consists of, for model/keep.hh. The bytes hold pins and mask, numbers per node or spring, the state.
#include "model/keep.hh"
#include "model/membrane.hh"

namespace cd {

namespace {

struct MembraneKeep {
    using Object = Membrane;
    using Settings = KeptSettings<MembraneSettings>;
    // Among the bits of fields: the settings of cloth follow, how much of what it touches are beds and callbacks, and
    // the strain at which it tears.
    static constexpr uint32_t kOfCloth = 1u << 31, kOfShapes = 1u << 30, kOfBreaking = 1u << 29;
    // CD_BREAKING_STRAIN_U and _V are beyond the bits, and stand where fields of ropes alone would, as does what the
    // last step of cloth changed, which older bytes lack.
    static constexpr uint32_t kBreaking[2] = {1u << CD_STRENGTH, 1u << CD_STRAIN};
    static constexpr uint32_t kOfChange = 1u << CD_TENSION;
    static constexpr Kind kind = {CD_KIND_MEMBRANE, "membrane", {"springs along u", "along v"}};

    static Shape shape_of(const Membrane& m) { return {{m.springs[kU], m.springs[kV]}, m.components, m.precision}; }

    static Settings settings_of(const Membrane& m) {
        Settings s{keep_body(m), m};
        if (m.spring_stiffness[kU]) s.fields |= 1u << CD_STIFFNESS_U;
        if (m.spring_stiffness[kV]) s.fields |= 1u << CD_STIFFNESS_V;
        if (m.pin) s.fields |= 1u << CD_PIN;
        if (m.mask) s.fields |= 1u << CD_MASK;
        if (m.spring_length[kU]) s.fields |= 1u << CD_REST_LENGTH_U;
        if (m.spring_length[kV]) s.fields |= 1u << CD_REST_LENGTH_V;
        for (Direction d : {kU, kV})
            if (m.breaking_strain[d]) s.fields |= kBreaking[d];
        if (has_lengths(m)) s.fields |= kOfCloth | kOfChange;
        if (m.cloth.breaking_strain < INFINITY) s.fields |= kOfBreaking;
        if (s.has_shapes()) s.fields |= kOfShapes;
        return s;
    }

    static bool tears(const Settings& s, Direction d) { return (s.fields & kBreaking[d]) != 0; }

    static void apply(Membrane& m, const Settings& s) {
        static_cast<BodySettings&>(m) = s.body;
        static_cast<MembraneSettings&>(m) = s.own;
    }

    static MembraneFeatures features_of(const Settings& s) {
        MembraneFeatures f{};
        static_cast<BodyFeatures&>(f) = features_of_body(s, s.own.bend > 0, s.own.cloth);
        f.spring_stiffness[kU] = s.on(CD_STIFFNESS_U);
        f.spring_stiffness[kV] = s.on(CD_STIFFNESS_V);
        f.pin = s.on(CD_PIN);
        f.mask = s.on(CD_MASK);
        f.spring_length[kU] = s.on(CD_REST_LENGTH_U);
        f.spring_length[kV] = s.on(CD_REST_LENGTH_V);
        f.cloth = (s.fields & kOfCloth) != 0;
        for (Direction d : {kU, kV}) f.ring[d] = s.own.ring[d] != 0, f.breaking_strain[d] = tears(s, d);
        f.pressure = s.own.pressure != 0;
        f.solver = s.own.solver;
        memcpy(f.edge, s.own.edge, sizeof f.edge);
        return f;
    }

    static void walk_settings(AnyWalker& w, Settings& s) {
        walk_body<MembraneKeep>(w, s);
        if (!(s.fields & kOfCloth)) return;
        ClothSettings& cloth = s.own.cloth;
        walk(w, cloth.length[kU]), walk(w, cloth.length[kV]), walk(w, cloth.shear), walk(w, cloth.compression);
        walk(w, cloth.newton), walk(w, cloth.gradient), walk_air(w, cloth);
        walk(w, s.colliders), walk(w, cloth.thickness);
        if (s.fields & kOfShapes) walk(w, s.beds), walk(w, s.callbacks);
        if (s.fields & kOfBreaking) walk(w, cloth.breaking_strain);
    }
    static void walk_choices(AnyWalker& w, MembraneSettings& s) {
        walk(w, s.solver), walk(w, s.ring[kU]), walk(w, s.ring[kV]);
        for (cd_node& kind : s.edge) walk(w, kind);
    }
    static void walk_numbers(AnyWalker& w, MembraneSettings& s) {
        walk(w, s.stiffness[kU]), walk(w, s.stiffness[kV]), walk(w, s.bend), walk(w, s.pressure), walk(w, s.tolerance);
        uint64_t most = s.most_iterations;
        walk(w, most);
        s.most_iterations = most < SIZE_MAX ? size_t(most) : SIZE_MAX;
    }

    static bool valid_cloth(const Membrane& m, const Settings& s) {
        const ClothSettings& cloth = s.own.cloth;
        return can_have_lengths(m) && valid_mass(cloth.length[kU]) && valid_mass(cloth.length[kV]) &&
               valid_parameter(cloth.shear) && valid_parameter(cloth.compression) && cloth.newton >= 1 &&
               cloth.newton <= kMostNewton && cloth.gradient <= kMostGradient && valid_air(m, cloth) &&
               valid_contacts(s, cloth.thickness) && s.has_shapes() == ((s.fields & kOfShapes) != 0) &&
               valid_breaking(s);
    }
    // What may tear has stiffnesses of its own.
    static bool valid_breaking(const Settings& s) {
        const double strain = s.own.cloth.breaking_strain;
        const bool told = (s.fields & kOfBreaking) != 0;
        return (told ? valid_mass(strain) : isinf(strain) && strain > 0) &&
               (!(told || tears(s, kU)) || s.on(CD_STIFFNESS_U)) && (!(told || tears(s, kV)) || s.on(CD_STIFFNESS_V));
    }

    static bool valid(const Membrane& m, const Settings& s) {
        const MembraneSettings& own = s.own;
        uint32_t optional = KeptBody::kOfSleep;
        for (cd_field field : {CD_MASS, CD_FORCE, CD_TARGET, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_PIN, CD_MASK})
            optional |= 1u << field;
        const bool is_cloth = (s.fields & kOfCloth) != 0;
        if (is_cloth) optional |= kOfCloth | kOfChange | kOfShapes | KeptBody::kOfLoads | 1u << CD_WIND;
        if (is_cloth) optional |= 1u << CD_REST_LENGTH_U | 1u << CD_REST_LENGTH_V;
        if (is_cloth) optional |= kOfBreaking | kBreaking[kU] | kBreaking[kV];
        bool good = valid_body(s) && (s.fields & ~optional) == 0 && (!is_cloth || valid_cloth(m, s));
        good &= own.solver >= CD_SOLVER_ALTERNATING && own.solver <= CD_SOLVER_AUTO;
        good &= own.tolerance >= kLeastTolerance && own.tolerance <= kMostTolerance && own.most_iterations >= 1;
        good &= valid_parameter(own.bend) && fabs(own.pressure) <= kMost && (own.pressure == 0 || m.components == 3);
        for (Direction d : {kU, kV}) {
            good &= valid_parameter(own.stiffness[d]);
            good &= own.ring[d] == 0 || (own.ring[d] == 1 && nodes_along(m, d) >= 3);
        }
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
            const bool ring = own.ring[direction_of(edge)] != 0;
            good &= is_kind(own.edge[edge]) || (!ring && own.edge[edge] == CD_NODE_MATCHED);
        }
        return good;
    }

    // Takes it from the end of what is to be read.
    static bool check_change(Reader& reader, const Membrane& m) {
        const size_t bytes = field_size(m, m.velocity);
        if (size_t(reader.end - reader.from) < bytes) return false;
        reader.end -= bytes;
        FieldCheck check{{reader.end, reader.end + bytes}};
        check.numbers(number_size(m), m.components * m.nodes, [](double v, size_t) { return isfinite(v) != 0; });
        return check.good;
    }
    static bool check_fields(Reader reader, const Membrane& m, const Settings& s) {
        FieldCheck check{reader};
        const size_t n = m.nodes;
        if ((s.fields & kOfChange) != 0 && !check_change(check.reader, m)) return false;
        const SavedNumbers pin = s.on(CD_PIN) ? check.here(sizeof(uint8_t)) : SavedNumbers{};
        if (s.on(CD_PIN)) check.numbers(sizeof(uint8_t), n, [](double kind, size_t) { return is_kind(kind); });
        const SavedNumbers mask = s.on(CD_MASK) ? check.here(sizeof(uint8_t)) : SavedNumbers{};
        if (s.on(CD_MASK)) check.numbers(sizeof(uint8_t), n, [](double there, size_t) { return there <= 1; });
        if (s.on(CD_MASS)) check.numbers(sizeof(double), n, valid_shared_mass);
        const auto of_springs = [&](bool on, Direction d, auto is_valid) {
            if (!on) return;
            check.numbers(sizeof(double), n, [&](double k, size_t i) {
                const size_t along = d == kU ? i % m.columns : i / m.columns;
                return along < m.springs[d] + size_t(s.own.ring[d]) ? is_valid(k, i) : k == 0;
            });
        };
        of_springs(s.on(CD_STIFFNESS_U), kU, valid_shared);
        of_springs(s.on(CD_STIFFNESS_V), kV, valid_shared);
        of_springs(s.on(CD_REST_LENGTH_U), kU, valid_shared_mass);
        of_springs(s.on(CD_REST_LENGTH_V), kV, valid_shared_mass);
        for (Direction d : {kU, kV})
            of_springs(tears(s, d), d, [](double t, size_t) { return valid_mass(t) || (isinf(t) && t > 0); });
        const SavedNumbers velocity = check_ties_and_state(check, m, layout_of(m), s, m.nodes);
        if (!check_surroundings(check, m, layout_of(m), s, 1)) return false;
        bool good = true;
        for (size_t k = 0; k < m.components; ++k)
            for (size_t i = 0; i < n; ++i) {
                const size_t u = i % m.columns, v = i / m.columns;
                const cd_node kind = pin.from ? cd_node(pin[i]) : kind_by_edges(m, s.own.edge, u, v);
                const bool stopped = kind == CD_NODE_PINNED || (mask.from && mask[i] == 0);
                good &= !stopped || velocity[k * n + i] == 0;
            }
        return good;
    }
};

} // namespace

uint64_t hash(const Membrane& m) { return hash_object<MembraneKeep>(m); }
#if CD_WITH_SAVE
size_t save_size(const Membrane& m) { return saved_size<MembraneKeep>(m); }
void save(const Membrane& m, unsigned char* out) { save_object<MembraneKeep>(m, out); }
cd_status load(const char* function, Membrane& m, const unsigned char* bytes, size_t size) {
    return load_object<MembraneKeep>(function, m, bytes, size);
}
#endif
cd_status copy(const char* function, Membrane& m, const Membrane& source) {
    return copy_object<MembraneKeep>(function, m, source);
}

} // namespace cd
