// Energy and momentum of a chain.
#include <math.h>

#include "base/sum.hh"
#include "model/chain.hh"

namespace cd {

namespace {

template <class T> struct Measure {
    const Chain& c;
    const T *x = numbers<T>(c.position), *v = numbers<T>(c.velocity), *target = numbers<T>(c.target);

    size_t after(size_t i) const { return i + 1 < c.nodes ? i + 1 : 0; }
    double at(const T* data, size_t node, size_t line) const { return double(data[node * c.pitch + line]); }

    // sum over lines of term(line)^2
    template <class Term> double squares(Term term) const {
        double sum = 0;
        for (size_t line = 0; line < c.lines; ++line) sum += term(line) * term(line);
        return sum;
    }

    // sum over strands of the square of what spring i is longer than its length, or, if it pushes, shorter
    double stretches(size_t i) const {
        if (!has_lengths(c)) return squares([&](size_t l) { return at(x, after(i), l) - at(x, i, l); });
        double sum = 0;
        for (size_t strand = 0; strand < c.strands; ++strand) {
            double square = 0;
            for (size_t k = 0; k < c.components; ++k) {
                const size_t line = strand * c.components + k;
                const double d = at(x, after(i), line) - at(x, i, line);
                square += d * d;
            }
            const double stretch = sqrt(square) - length_of(c, i);
            if (stretch > 0 || c.rope.push) sum += stretch * stretch;
        }
        return sum;
    }

    void energy(Sum& kinetic, Sum& elastic, Sum& gravity) const {
        for (size_t i = 0; i < springs_in_all(c); ++i)
            if (!is_rigid(c, i)) elastic.add(0.5 * stiffness_of(c, i) * stretches(i));
        for (size_t i = 0; i < c.nodes; ++i) {
            if (bend_of(c, i) > 0) {
                const size_t left = i > 0 ? i - 1 : c.nodes - 1, right = after(i);
                elastic.add(0.5 * bend_of(c, i) * squares([&](size_t l) {
                                return (at(x, right, l) - at(x, i, l)) - (at(x, i, l) - at(x, left, l));
                            }));
            }
            if (c.target)
                elastic.add(0.5 * c.attach_stiffness[i] *
                            squares([&](size_t l) { return at(x, i, l) - at(target, i, l); }));
            if (held(c, i)) continue;
            kinetic.add(0.5 * mass_of(c, i) * squares([&](size_t l) { return at(v, i, l); }));
            double fall = 0;
            for (size_t l = 0; l < c.lines; ++l) fall += c.gravity[l % c.components] * at(x, i, l);
            gravity.add(-mass_of(c, i) * fall);
        }
    }

    void momentum(double* out) const {
        Sum sums[4];
        for (size_t i = 0; i < c.nodes; ++i)
            if (!held(c, i))
                for (size_t l = 0; l < c.lines; ++l) sums[l % c.components].add(mass_of(c, i) * at(v, i, l));
        for (size_t k = 0; k < c.components; ++k) out[k] = sums[k].value();
    }
};

} // namespace

void energy(const Chain& c, double& kinetic, double& elastic, double& gravity) {
    Sum sums[3];
    by_precision(c, [&](auto zero) { Measure<decltype(zero)>{c}.energy(sums[0], sums[1], sums[2]); });
    kinetic = sums[0].value();
    elastic = sums[1].value();
    gravity = sums[2].value();
}

void momentum(const Chain& c, double* out) {
    by_precision(c, [&](auto zero) { Measure<decltype(zero)>{c}.momentum(out); });
}

} // namespace cd
