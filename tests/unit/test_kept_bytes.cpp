// Saved bytes made by someone who knows the format: any number in them may be anything. What is loaded can be used, and
// says what it was loaded from.
#include <initializer_list>
#include <vector>

#include "contdyn/contdyn.h"
#include "model/keep.hh"

extern "C" {
#include "cmocka_all.h" // last: it makes a macro of the name fail
}

namespace {

void ok(cd_status status) {
    if (status != CD_OK) fail_msg("%s: %s", cd_status_name(status), cd_error_message());
}

// The two objects under one set of names.
struct ChainCalls {
    using Handle = cd_chain;
    static constexpr cd::Kind kind = {1, "", {}};
    static constexpr auto save_size = cd_chain_save_size;
    static constexpr auto save = cd_chain_save;
    static constexpr auto load = cd_chain_load;
    static constexpr auto step = cd_chain_step;
    static constexpr auto destroy = cd_chain_destroy;

    static Handle* make() {
        Handle* chain = nullptr;
        ok(cd_chain_create(2, 5, 2, CD_FLOAT32, nullptr, &chain));
        return chain;
    }
    static void fill(Handle* chain) {
        const double gravity[2] = {1, -2};
        for (cd_field field : {CD_MASS, CD_STIFFNESS, CD_BEND, CD_FORCE}) ok(cd_chain_enable_field(chain, field));
        ok(cd_chain_set_bend(chain, 0.5));
        ok(cd_chain_set_gravity(chain, gravity, 2));
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
        ok(cd_chain_attach(chain, 2, 3, 1, nullptr, 0));
        ok(cd_chain_step(chain, 0.125, 3));
    }
    static bool is_possible(const Handle*) { return true; }
};

struct MembraneCalls {
    using Handle = cd_membrane;
    static constexpr cd::Kind kind = {2, "", {}};
    static constexpr auto save_size = cd_membrane_save_size;
    static constexpr auto save = cd_membrane_save;
    static constexpr auto load = cd_membrane_load;
    static constexpr auto step = cd_membrane_step;
    static constexpr auto destroy = cd_membrane_destroy;

    static Handle* make() {
        Handle* membrane = nullptr;
        ok(cd_membrane_create(3, 1, 3, CD_FLOAT32, nullptr, &membrane));
        return membrane;
    }
    static void fill(Handle* membrane) {
        const double gravity[3] = {1, -2, 0.5};
        for (cd_field field : {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_FORCE, CD_PIN, CD_MASK})
            ok(cd_membrane_enable_field(membrane, field));
        ok(cd_membrane_set_bend(membrane, 0.5));
        ok(cd_membrane_set_pressure(membrane, 0.5));
        ok(cd_membrane_set_solver(membrane, CD_SOLVER_COUPLED));
        ok(cd_membrane_set_gravity(membrane, gravity, 3));
        ok(cd_membrane_set_edge(membrane, CD_EDGE_U_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_edge(membrane, CD_EDGE_U_LAST, CD_NODE_MATCHED));
        ok(cd_membrane_attach(membrane, 2, 1, 3, 1, nullptr, 0));
        ok(cd_membrane_step(membrane, 0.125, 3));
    }
    static bool is_possible(const Handle* membrane) { // two nodes make no ring
        int32_t ring[2];
        ok(cd_membrane_get_ring(membrane, &ring[0], &ring[1]));
        return ring[1] == 0;
    }
};

template <class C> std::vector<unsigned char> saved(const typename C::Handle* object) {
    size_t size = 0;
    ok(C::save_size(object, &size));
    std::vector<unsigned char> bytes(size);
    ok(C::save(object, bytes.data(), size, &size));
    return bytes;
}

template <class C> void any_bytes_with_a_good_checksum_are_refused_or_of_use(void**) {
    typename C::Handle* const source = C::make();
    C::fill(source);
    const std::vector<unsigned char> good = saved<C>(source);
    size_t taken = 0, refused = 0;
    for (size_t i = cd::kHeader; i < good.size(); ++i) {
        for (unsigned flip : {0x01u, 0x04u, 0x80u, 0xFFu}) {
            std::vector<unsigned char> bytes = good;
            bytes[i] = static_cast<unsigned char>(bytes[i] ^ flip);
            cd::write_header(C::kind, bytes.data(), bytes.size());
            typename C::Handle* const object = C::make();
            const std::vector<unsigned char> before = saved<C>(object);
            const cd_status status = C::load(object, bytes.data(), bytes.size());
            if (status == CD_OK) {
                ++taken;
                assert_true(saved<C>(object) == bytes && C::is_possible(object));
                const cd_status stepped = C::step(object, 0.125, 2);
                assert_true(stepped == CD_OK || stepped == CD_ERROR_DIVERGED || stepped == CD_ERROR_TOLERANCE);
            } else {
                ++refused;
                assert_true(status == CD_ERROR_FORMAT || status == CD_ERROR_MISMATCH);
                assert_true(saved<C>(object) == before);
            }
            C::destroy(object);
        }
    }
    assert_true(taken > 100 && refused > 100);
    C::destroy(source);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<ChainCalls>),
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<MembraneCalls>),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
