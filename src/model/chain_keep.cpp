// What a chain consists of, for model/keep.hh. The bytes hold pins, then numbers per node or spring, then the state.
#include "model/chain.hh"
#include "model/keep.hh"

namespace cd {

namespace {

struct ChainKeep {
    using Object = Chain;
    using Settings = KeptSettings<ChainSettings>;
    static constexpr Kind kind = {1, "chain", {"strands", "springs"}};

    static Shape shape_of(const Chain& c) { return {{c.strands, c.springs}, c.components, c.precision}; }

    static Settings settings_of(const Chain& c) {
        Settings s{keep_body(c), c};
        if (c.spring_stiffness) s.fields |= 1u << CD_STIFFNESS;
        if (c.node_bend) s.fields |= 1u << CD_BEND;
        return s;
    }

    static void apply(Chain& c, const Settings& s) {
        static_cast<BodySettings&>(c) = s.body;
        static_cast<ChainSettings&>(c) = s.own;
    }

    static Features features_of(const Settings& s) {
        return {features_of_body(s, s.own.bend > 0), s.on(CD_STIFFNESS), s.on(CD_BEND), s.own.ring != 0};
    }

    template <class W> static void walk_settings(W& w, Settings& s) { walk_body<ChainKeep>(w, s); }
    template <class W> static void walk_choices(W& w, ChainSettings& s) { walk(w, s.ring); }
    template <class W> static void walk_numbers(W& w, ChainSettings& s) { walk(w, s.stiffness), walk(w, s.bend); }

    static bool valid(const Chain& c, const Settings& s) {
        const uint32_t optional = 1u << CD_MASS | 1u << CD_STIFFNESS | 1u << CD_BEND | 1u << CD_FORCE | 1u << CD_TARGET;
        return valid_body(s) && (s.fields & ~optional) == 0 && (s.own.ring == 0 || (s.own.ring == 1 && c.nodes >= 3)) &&
               valid_parameter(s.own.stiffness) && valid_parameter(s.own.bend);
    }

    static bool check_fields(Reader reader, const Chain& c, const Settings& s) {
        FieldCheck check{reader};
        check.numbers<uint8_t>(c.nodes, [&](double pin, size_t i) {
            const bool end = !s.own.ring && (i == 0 || i + 1 == c.nodes);
            return pin <= (end ? CD_NODE_MATCHED : CD_NODE_DRIVEN);
        });
        if (s.on(CD_MASS)) check.numbers<double>(c.nodes, valid_shared_mass);
        if (s.on(CD_STIFFNESS))
            check.numbers<double>(c.springs + size_t(s.own.ring),
                                  [](double k, size_t i) { return valid_shared(k, i) || (isinf(k) && k > 0); });
        if (s.on(CD_BEND)) check.numbers<double>(c.nodes, valid_shared);
        check_ties_and_state(check, c, layout_of(c), s);
        return check.all_good();
    }
};

} // namespace

uint64_t hash(const Chain& c) { return hash_object<ChainKeep>(c); }
size_t save_size(const Chain& c) { return saved_size<ChainKeep>(c); }
void save(const Chain& c, unsigned char* out) { save_object<ChainKeep>(c, out); }
cd_status load(const char* function, Chain& c, const unsigned char* bytes, size_t size) {
    return load_object<ChainKeep>(function, c, bytes, size);
}
cd_status copy(const char* function, Chain& c, const Chain& source) {
    return copy_object<ChainKeep>(function, c, source);
}

} // namespace cd
