// The rope and the curtain of consumer.c, from C++.
#include <contdyn/contdyn.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

static void check(cd_status status) {
    if (status != CD_OK) throw std::runtime_error(cd_error_message());
}

struct Release {
    void operator()(cd_chain* chain) const { cd_chain_destroy(chain); }
    void operator()(cd_membrane* membrane) const { cd_membrane_destroy(membrane); }
};

static double curtain() {
    cd_membrane* created = nullptr;
    check(cd_membrane_create(8, 12, 1, CD_FLOAT64, nullptr, &created));
    const std::unique_ptr<cd_membrane, Release> membrane(created);

    const double gravity = -9.81;
    check(cd_membrane_set_mass(membrane.get(), 2.0));
    check(cd_membrane_set_stiffness(membrane.get(), 1.0, 9.81));
    check(cd_membrane_set_gravity(membrane.get(), &gravity, 1));
    check(cd_membrane_set_edge(membrane.get(), CD_EDGE_V_FIRST, CD_NODE_PINNED));
    check(cd_membrane_set_lambda(membrane.get(), 1.0));
    check(cd_membrane_step(membrane.get(), 100.0, 20));

    double corner = 0;
    check(cd_membrane_read_f64(membrane.get(), CD_POSITION, 8, 12, 1, 1, &corner, 1));
    return corner;
}

int main() {
    const std::size_t springs = 16;
    cd_chain* created = nullptr;
    check(cd_chain_create(1, springs, 2, CD_FLOAT64, nullptr, &created));
    const std::unique_ptr<cd_chain, Release> chain(created);

    const std::vector<double> gravity = {0.0, -9.81};
    check(cd_chain_set_mass(chain.get(), 2.0));
    check(cd_chain_set_stiffness(chain.get(), 9.81));
    check(cd_chain_set_gravity(chain.get(), gravity.data(), gravity.size()));
    check(cd_chain_set_end(chain.get(), CD_END_FIRST, CD_NODE_PINNED));
    check(cd_chain_set_lambda(chain.get(), 1.0));
    check(cd_chain_step(chain.get(), 100.0, 20));

    std::vector<double> last(2);
    check(cd_chain_read_f64(chain.get(), CD_POSITION, 0, 1, springs, 1, last.data(), last.size()));
    std::printf("contdyn %s: rope down to %.6f %.6f, curtain down to %.6f\n", cd_version_string(), last[0] + 0.0,
                last[1], curtain());
}
