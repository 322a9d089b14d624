// The rope and the curtain of consumer.c, by the C++ header.
#include <contdyn/contdyn.hpp>

#include <cstdio>

using contdyn::field;

static double curtain() {
    contdyn::membrane membrane(8, 12, 1, contdyn::precision::float64);
    membrane.set_mass(2.0);
    membrane.set_stiffness(1.0, 9.81);
    membrane.set_gravity({-9.81});
    membrane.set_edge(contdyn::edge::v_first, contdyn::node::pinned);
    membrane.set_lambda(1.0);
    membrane.step(100.0, 20);
    return membrane.view(field::position)(8, 12, 0);
}

int main() {
    const std::size_t springs = 16;
    contdyn::chain chain(1, springs, 2, contdyn::precision::float64);
    chain.set_mass(2.0);
    chain.set_stiffness(9.81);
    chain.set_gravity({0.0, -9.81});
    chain.set_end(contdyn::end::first, contdyn::node::pinned);
    chain.set_lambda(1.0);
    chain.step(100.0, 20);

    double last[2];
    chain.read_f64(field::position, 0, 1, springs, 1, last);
    std::printf("contdyn %s: rope down to %.6f %.6f, curtain down to %.6f\n", contdyn::version_string(), last[0] + 0.0,
                last[1], curtain());
}
