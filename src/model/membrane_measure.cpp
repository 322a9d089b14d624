// Energy, momentum and volume of a membrane. (model.md, 28)
#include "base/sum.hh"
#include "model/membrane.hh"
#include "model/vector.hh"

namespace cd {

namespace {

struct Measure {
    const Membrane& m;
    StateNumbers x = state_of(m, m.position), v = state_of(m, m.velocity), target = state_of(m, m.target);
    double scale = 1; // of positions, in volumes

    double at(const StateNumbers& of, size_t u, size_t v_, size_t k) const { return of[place(m, u, v_, k)]; }

    // f(u, v) for every node that is there
    template <class F> void each_node(F f) const {
        for (size_t row = 0; row < m.rows; ++row)
            for (size_t column = 0; column < m.columns; ++column)
                if (present(m, column, row)) f(column, row);
    }

    // weight times the sum over components of term(component)^2: 0 of no weight, also where squares overflow
    template <class Term> double squares(double weight, Term term) const {
        double sum = 0;
        for (size_t k = 0; k < m.components && weight > 0; ++k) sum += term(k) * term(k);
        return weight * sum;
    }

    // What hangs on node (i, j): springs and twist that start there, its bend, its attachment; of cloth only that.
    double elastic(size_t i, size_t j) const {
        const size_t next_i = after(m, kU, i), next_j = after(m, kV, j);
        const auto here = [&](size_t k) { return at(x, i, j, k); };
        const auto right = [&](size_t k) { return at(x, next_i, j, k); };
        const auto below = [&](size_t k) { return at(x, i, next_j, k); };
        double sum = 0;
        if (!has_lengths(m))
            sum = squares(stiffness_of(m, kU, i, j), [&](size_t k) { return right(k) - here(k); }) +
                  squares(stiffness_of(m, kV, i, j), [&](size_t k) { return below(k) - here(k); });
        if (!has_lengths(m) && has_bend(m)) {
            const size_t last_i = before(m, kU, i), last_j = before(m, kV, j);
            const auto curve = [&](auto ahead, size_t u, size_t w, size_t k) {
                return (ahead(k) - here(k)) - (here(k) - at(x, u, w, k));
            };
            sum += squares(bend_of(m, kU, i, j), [&](size_t k) { return curve(right, last_i, j, k); }) +
                   squares(bend_of(m, kV, i, j), [&](size_t k) { return curve(below, i, last_j, k); });
            sum += squares(twist_of(m, i, j),
                           [&](size_t k) { return (at(x, next_i, next_j, k) - below(k)) - (right(k) - here(k)); });
        }
        if (m.target) sum += squares(tie_of(m, i, j), [&](size_t k) { return here(k) - at(target, i, j, k); });
        return 0.5 * sum;
    }

    void energy(Sum& kinetic, Sum& elastic_sum, Sum& gravity) const {
        each_node([&](size_t i, size_t j) {
            elastic_sum.add(elastic(i, j));
            if (held(m, i, j)) return;
            const double mass = mass_of(m, i, j);
            kinetic.add(squares(0.5 * mass, [&](size_t k) { return at(v, i, j, k); }));
            double fall = 0;
            for (size_t k = 0; k < m.components; ++k) fall += m.gravity[k] * at(x, i, j, k);
            gravity.add(-mass * fall);
        });
        if constexpr (CD_WITH_CLOTH)
            if (has_lengths(m)) elastic_sum.add(cloth_elastic(m));
    }

    void momentum(double* out) const {
        Sum sums[4];
        each_node([&](size_t i, size_t j) {
            if (held(m, i, j)) return;
            const double mass = mass_of(m, i, j);
            for (size_t k = 0; k < m.components; ++k) sums[k].add(mass * at(v, i, j, k));
        });
        for (size_t k = 0; k < m.components; ++k) out[k] = sums[k].value();
    }

    Vector node(size_t i, size_t j) const { return Vector{at(x, i, j, 0), at(x, i, j, 1), at(x, i, j, 2)} * scale; }

    // det(p, q, r): six times the volume between the triangle and the origin
    static double wedge(const Vector& p, const Vector& q, const Vector& r) { return dot(p, cross(q, r)); }

    __attribute__((noinline)) double volume() const {
        Sum sum;
        for (size_t j = 0; j < springs_along(m, kV); ++j)
            for (size_t i = 0; i < springs_along(m, kU); ++i) {
                const size_t next_i = after(m, kU, i), next_j = after(m, kV, j);
                if (!present(m, i, j) || !present(m, next_i, j) || !present(m, next_i, next_j) ||
                    !present(m, i, next_j) || is_open(m, i, j))
                    continue;
                const Vector a = node(i, j), b = node(next_i, j), c = node(next_i, next_j), d = node(i, next_j);
                sum.add((wedge(a, b, c) + wedge(a, c, d) + wedge(a, b, d) + wedge(b, c, d)) / 12);
            }
        return sum.value();
    }
};

} // namespace

void energy(const Membrane& m, double& kinetic, double& elastic, double& gravity) {
    Sum sums[3];
    Measure{m}.energy(sums[0], sums[1], sums[2]);
    kinetic = sums[0].value();
    elastic = sums[1].value();
    gravity = sums[2].value();
}

void momentum(const Membrane& m, double* out) { Measure{m}.momentum(out); }

// Products that leave double may be both infinities, whose sum is no number: they are then made smaller.
double volume(const Membrane& m) {
    Measure measure{m};
    double sum = measure.volume();
    while (!(sum - sum == 0) && measure.scale > 0x1p-800) {
        measure.scale *= 0x1p-60;
        sum = measure.volume();
    }
    return sum / measure.scale / measure.scale / measure.scale;
}

} // namespace cd
