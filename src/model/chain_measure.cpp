// Energy and momentum of a chain. (model.md, 2)
#include <math.h>

#include "base/sum.hh"
#include "model/chain.hh"

namespace cd {

namespace {

struct Measure {
    const Chain& c;
    StateNumbers x = state_of(c, c.position), v = state_of(c, c.velocity), target = state_of(c, c.target);

    size_t after(size_t i) const { return i + 1 < c.nodes ? i + 1 : 0; }
    double at(const StateNumbers& of, size_t node, size_t line) const { return of[node * c.pitch + line]; }

    // The lines of strands that share their numbers: all, or in ropes one strand's.
    struct Part {
        size_t first, end;
    };
    // f(node or spring, where its numbers are, the lines that they are for), of each of `items`.
    template <class F> void each(size_t items, F f) const {
        const size_t own = own_strands(c), width = c.lines / own;
        for (size_t i = 0; i < items; ++i)
            for (size_t s = 0; s < own; ++s) f(i, own_place(c, s, i), Part{s * width, (s + 1) * width});
    }

    // sum over lines of term(line)^2
    template <class Term> static double squares(Part part, Term term) {
        double sum = 0;
        for (size_t line = part.first; line < part.end; ++line) sum += term(line) * term(line);
        return sum;
    }

    // The square of what spring i is longer than its length, or, if it pushes, shorter.
    double stretches(size_t i, size_t own, Part part) const {
        const double square = squares(part, [&](size_t l) { return at(x, after(i), l) - at(x, i, l); });
        if (!has_lengths(c)) return square;
        const double stretch = sqrt(square) - length_of(c, own);
        return stretch > 0 || c.rope.push ? stretch * stretch : 0;
    }

    void energy(Sum& kinetic, Sum& elastic, Sum& gravity) const {
        each(springs_in_all(c), [&](size_t i, size_t own, Part part) {
            const double k = stiffness_of(c, own);
            if (k > 0 && !is_rigid(c, own)) elastic.add(0.5 * k * stretches(i, own, part));
        });
        each(c.nodes, [&](size_t i, size_t own, Part part) {
            const Joint joint = joint_of(c, part.first / c.components, i);
            if (CD_WITH_BEND && joint.stiffness > 0) {
                const size_t left = i > 0 ? i - 1 : c.nodes - 1, right = after(i);
                const auto before = [&](size_t k) { return at(x, i, part.first + k) - at(x, left, part.first + k); };
                elastic.add(0.5 * joint.stiffness * squares(part, [&](size_t l) {
                                return joint.right * (at(x, right, l) - at(x, i, l)) -
                                       joint.left * joint.turned(l - part.first, before);
                            }));
            }
            if (c.target && c.attach_stiffness[own] > 0)
                elastic.add(0.5 * c.attach_stiffness[own] *
                            squares(part, [&](size_t l) { return at(x, i, l) - at(target, i, l); }));
            if (held(c, own)) return;
            const double mass = mass_of(c, own);
            kinetic.add(0.5 * mass * squares(part, [&](size_t l) { return at(v, i, l); }));
            double fall = 0;
            for (size_t l = part.first; l < part.end; ++l) fall += c.gravity[l % c.components] * at(x, i, l);
            gravity.add(-mass * fall);
        });
    }

    void momentum(double* out) const {
        Sum sums[4];
        each(c.nodes, [&](size_t i, size_t own, Part part) {
            if (held(c, own)) return;
            const double mass = mass_of(c, own);
            for (size_t l = part.first; l < part.end; ++l) sums[l % c.components].add(mass * at(v, i, l));
        });
        for (size_t k = 0; k < c.components; ++k) out[k] = sums[k].value();
    }
};

} // namespace

void energy(const Chain& c, double& kinetic, double& elastic, double& gravity) {
    Sum sums[3];
    Measure{c}.energy(sums[0], sums[1], sums[2]);
    kinetic = sums[0].value();
    elastic = sums[1].value();
    gravity = sums[2].value();
}

void momentum(const Chain& c, double* out) { Measure{c}.momentum(out); }

// A spring of a rope: its vector, and how long that is, also where squares overflow.
static double vector_of(const Chain& c, size_t strand, size_t spring, double* out) {
    double largest = 0, square = 0;
    for (size_t k = 0; k < c.components; ++k) {
        out[k] = get_number(c, c.position, place(c, strand, spring + 1 < c.nodes ? spring + 1 : 0, k)) -
                 get_number(c, c.position, place(c, strand, spring, k));
        if (fabs(out[k]) > largest) largest = fabs(out[k]);
    }
    for (size_t k = 0; k < c.components && largest > 0; ++k) square += (out[k] / largest) * (out[k] / largest);
    return largest * sqrt(square);
}

double strain_of(const Chain& c, size_t strand, size_t spring) {
    double vector[4];
    return vector_of(c, strand, spring, vector) / length_of(c, own_place(c, strand, spring)) - 1;
}

void reaction(const Chain& c, size_t strand, size_t node, double* out) {
    for (size_t k = 0; k < c.components; ++k) out[k] = 0;
    const auto pull = [&](size_t spring, double sign) {
        double vector[4];
        const double length = vector_of(c, strand, spring, vector);
        const double tension = sign * c.tension[own_place(c, strand, spring)];
        for (size_t k = 0; k < c.components && length > 0; ++k) out[k] += tension * (vector[k] / length);
    };
    if (node > 0 || c.ring) pull(node > 0 ? node - 1 : c.springs, -1);
    if (node < springs_in_all(c)) pull(node, 1);
    for (size_t i = node > 0 ? node - 1 : 0; i <= node + 1 && has_bend(c); ++i) { // of joints beside it
        const Joint joint = i < c.nodes ? joint_of(c, strand, i) : Joint{};
        if (!(joint.stiffness > 0)) continue;
        double left[4], right[4];
        vector_of(c, strand, i > 0 ? i - 1 : c.springs, left), vector_of(c, strand, i, right);
        const auto bent = [&](size_t k) {
            return joint.right * right[k] - joint.left * joint.turned(k, [&](size_t j) { return left[j]; });
        };
        for (size_t k = 0; k < c.components; ++k) {
            const double next = joint.right * bent(k), before = joint.left * joint.turned(k, bent, true);
            out[k] += joint.stiffness * (i == node ? before + next : i < node ? -next : -before);
        }
    }
}

} // namespace cd
