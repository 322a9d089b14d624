// The terms that the energy of a membrane's springs, shear and bend consists of, and their forces. (model.md, 28, 42)
#include <math.h>

#include "kernel/cloth.hh"
#include "model/membrane.hh"

namespace cd {

namespace {

// stiffness / 2 |s|^2, s the sum of the nodes' positions times their weights, which add up to 0. A spring of cloth has
// a length: its energy goes by the law of kernel/cloth.hh, and as it resists crumpling.
struct Term {
    double stiffness, length, compression;
    size_t nodes, u[4], v[4];
    double weight[4];

    // s, and its size.
    double vector(const Membrane& m, double (&s)[4]) const {
        double square = 0;
        for (size_t k = 0; k < m.components; ++k) {
            const auto x = [&](size_t i) { return get_number(m, m.position, place(m, u[i], v[i], k)); };
            const double first = x(0);
            s[k] = 0;
            for (size_t i = 1; i < nodes; ++i) s[k] += weight[i] * (x(i) - first);
            square += s[k] * s[k];
        }
        return sqrt(square);
    }
    // Of a spring that is so long now.
    double tension(double now) const {
        const double soft = kSlackEnd * length, excess = now - length;
        const double pull = excess <= 0 ? 0 : excess <= 2 * soft ? excess * excess / (4 * soft) : excess - soft;
        return stiffness * pull + compression * excess;
    }
    double spring_energy(double now) const {
        const double soft = kSlackEnd * length, least = kLeastDirection * length, excess = now - length;
        double pulling = 0, crumpling = excess * excess / 2;
        if (excess > 2 * soft) pulling = 2 * soft * soft / 3 + ((excess - soft) * (excess - soft) - soft * soft) / 2;
        else if (excess > 0) pulling = excess * excess * excess / (12 * soft);
        if (now <= least)
            crumpling = now * now / 2 - length * (now * now / (2 * least) + least / 2) + length * length / 2;
        return stiffness * pulling + compression * crumpling;
    }
    double energy(const Membrane& m) const {
        double s[4];
        const double now = vector(m, s);
        return length > 0 ? spring_energy(now) : stiffness / 2 * (now * now);
    }
    // What node number i of the term is pulled by.
    void add_force(const Membrane& m, size_t i, double* out) const {
        double s[4];
        const double now = vector(m, s);
        const double rate = length > 0 ? tension(now) / fmax(now, kLeastDirection * length) : stiffness;
        for (size_t k = 0; k < m.components; ++k) out[k] -= weight[i] * rate * s[k];
    }
};

Term spring_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const size_t end_u = d == kU ? after(m, kU, u) : u, end_v = d == kV ? after(m, kV, v) : v;
    Term out{stiffness_of(m, d, u, v), 0, 0, 2, {u, end_u}, {v, end_v}, {-1, 1}};
    if constexpr (CD_WITH_CLOTH)
        if (has_lengths(m)) out.length = length_of(m, d, u, v), out.compression = compression_of(m, d, u, v);
    return out;
}

// The terms that hang on a node: springs, diagonals and twist that start there, its bend; returns how many.
constexpr size_t kMostTerms = 7;
size_t terms_of(const Membrane& m, size_t u, size_t v, Term (&out)[kMostTerms]) {
    const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
    double bend[2] = {bend_of(m, kU, u, v), bend_of(m, kV, u, v)}, twist = twist_of(m, u, v), shear = 0, diagonal = 0;
    if constexpr (CD_WITH_CLOTH)
        if (has_lengths(m)) {
            for (Direction d : {kU, kV}) bend[d] = cloth_bend_of(m, d, u, v);
            if (!whole_cell(m, u, v)) twist = 0;
            else shear = m.cloth.shear, diagonal = diagonal_length(m, u, v);
        }
    size_t count = 0;
    const auto give = [&](const Term& term) { out[count] = term, count += term.stiffness > 0; };
    for (Direction d : {kU, kV}) give(spring_of(m, d, u, v));
    give({bend[kU], 0, 0, 3, {u, before(m, kU, u), next_u}, {v, v, v}, {-2, 1, 1}});
    give({bend[kV], 0, 0, 3, {u, u, u}, {v, before(m, kV, v), next_v}, {-2, 1, 1}});
    give({twist, 0, 0, 4, {u, next_u, u, next_u}, {v, v, next_v, next_v}, {1, -1, -1, 1}});
    give({shear, diagonal, 0, 2, {u, next_u}, {v, next_v}, {-1, 1}});
    give({shear, diagonal, 0, 2, {next_u, u}, {v, next_v}, {-1, 1}});
    return count;
}

// A node of a line and those beside it, each once; returns how many.
size_t around(const Membrane& m, Direction d, size_t i, size_t (&out)[3]) {
    const size_t last = before(m, d, i), next = after(m, d, i);
    size_t count = 0;
    out[count++] = i;
    if (last != i) out[count++] = last;
    if (next != i && next != last) out[count++] = next;
    return count;
}

} // namespace

void reaction(const Membrane& m, size_t u, size_t v, double* out) {
    for (size_t k = 0; k < m.components; ++k) out[k] = 0;
    size_t columns[3], rows[3];
    const size_t all[2] = {around(m, kU, u, columns), around(m, kV, v, rows)};
    for (size_t n = 0; n < all[0] * all[1]; ++n) {
        Term term[kMostTerms];
        for (size_t t = terms_of(m, columns[n % all[0]], rows[n / all[0]], term); t-- > 0;)
            for (size_t i = 0; i < term[t].nodes; ++i)
                if (term[t].u[i] == u && term[t].v[i] == v) term[t].add_force(m, i, out);
    }
}

double cloth_elastic(const Membrane& m) {
    double sum = 0;
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            Term term[kMostTerms];
            for (size_t t = 0, count = terms_of(m, u, v, term); t < count; ++t) sum += term[t].energy(m);
        }
    return sum;
}

double tension_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const Term spring = spring_of(m, d, u, v);
    double s[4];
    return spring.stiffness > 0 ? spring.tension(spring.vector(m, s)) : 0;
}

double strain_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const Term spring = spring_of(m, d, u, v);
    double s[4];
    return spring.vector(m, s) / spring.length - 1;
}

} // namespace cd
