#include "kernel/row_sum.hh"
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

// (right - here) - (here - left)
template <class L> inline L turn(L left, L here, L right) { return (right - here) - (here - left); }
template <int N> inline Lanes<N> turn_u(const Rows& x, size_t u) {
    return turn(before<N>(x.here, u), at<N>(x.here, u), after<N>(x.here, u));
}
template <int N> inline Lanes<N> turn_v(const Rows& x, size_t u) {
    return turn(at<N>(x.above, u), at<N>(x.here, u), at<N>(x.below, u));
}
// Of the cell that starts at a node.
template <int N> inline Lanes<N> twist(const Rows& x, size_t u) {
    return (after<N>(x.below, u) - at<N>(x.below, u)) - (after<N>(x.here, u) - at<N>(x.here, u));
}

struct General {
    const GeneralSheet& sheet;
    Rows x, spring_u, spring_v;
    size_t row; // where it starts

    // The pull of the springs at the bundle's nodes.
    template <int N> Lanes<N> springs(size_t u) const {
        const Lanes<N> here = at<N>(x.here, u);
        const Lanes<N> along_u = at<N>(spring_u.here, u) * (after<N>(x.here, u) - here) -
                                 before<N>(spring_u.here, u) * (here - before<N>(x.here, u));
        const Lanes<N> along_v = at<N>(spring_v.here, u) * (at<N>(x.below, u) - here) -
                                 at<N>(spring_v.above, u) * (here - at<N>(x.above, u));
        return along_u + along_v;
    }
    // That of the bends, from their moments.
    template <int N> Lanes<N> bends(const Grid& grid, size_t r, size_t u) const {
        const Rows m_u(grid, sheet.moment[0], r), m_v(grid, sheet.moment[1], r), m_t(grid, sheet.moment[2], r);
        const Lanes<N> twisted =
            (at<N>(m_t.here, u) - before<N>(m_t.here, u)) - (at<N>(m_t.above, u) - before<N>(m_t.above, u));
        return Lanes<N>{} - ((turn_u<N>(m_u, u) + turn_v<N>(m_v, u)) + twisted);
    }
};

struct Puller {
    const Grid& grid;
    General general;
    double* out;
    size_t r;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t here = general.row + u;
        L sum = L::load(out + here) + general.springs<N>(u);
        if (general.sheet.bends()) sum = sum + general.bends<N>(grid, r, u);
        select(L::load(general.sheet.mass + here), sum, L{}).store(out + here);
    }
};

struct Applier {
    const Grid& grid;
    General general;
    double* out;
    size_t r;

    template <int N> Lanes<N> operator()(size_t u) const {
        using L = Lanes<N>;
        const GeneralSheet& sheet = general.sheet;
        const Rows& x = general.x;
        const size_t here = general.row + u;
        const L z = at<N>(x.here, u), mass = L::load(sheet.mass + here), own = L::load(sheet.ground + here) * z;
        const L right = after<N>(x.here, u) - z, below = at<N>(x.below, u) - z;
        L sum = own - general.springs<N>(u);
        L energy = select(mass, own * z, L{}) + (L::load(sheet.spring[0] + here) * (right * right) +
                                                 L::load(sheet.spring[1] + here) * (below * below));
        if (sheet.bends()) {
            sum = sum - general.bends<N>(grid, r, u);
            energy = energy + (L::load(sheet.moment[0] + here) * turn_u<N>(x, u) +
                               L::load(sheet.moment[1] + here) * turn_v<N>(x, u) +
                               L::load(sheet.moment[2] + here) * twist<N>(x, u));
        }
        select(mass, sum, L{}).store(out + here);
        return energy;
    }
};

struct Bender {
    const GeneralSheet& sheet;
    Rows x;
    size_t row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        (L::load(sheet.bend[0] + row + u) * turn_u<N>(x, u)).store(sheet.moment[0] + row + u);
        (L::load(sheet.bend[1] + row + u) * turn_v<N>(x, u)).store(sheet.moment[1] + row + u);
        (L::load(sheet.twist + row + u) * twist<N>(x, u)).store(sheet.moment[2] + row + u);
    }
};

General general_row(const Grid& grid, const GeneralSheet& sheet, const double* x, size_t r) {
    return {sheet, Rows(grid, x, r), Rows(grid, sheet.spring[0], r), Rows(grid, sheet.spring[1], r), r * grid.pitch};
}

// The energies between all planes, and their products with b. Each plane is looked at once, for all its pairs. What a
// spring's energy is made of is multiplied first: two planes that are nearly one then have nearly the same energies.
struct Energies {
    const Grid& grid;
    const GeneralSheet& sheet;
    const double* const* z;
    int n;
    const double* b;
    size_t r;

    // What the node, its springs and its bends see of a plane, in lanes.
    template <int N> struct Seen {
        Lanes<N> here, right, below, turn_u, turn_v, twist;

        void look(const Rows& x, size_t u, bool bends) {
            here = at<N>(x.here, u);
            right = after<N>(x.here, u) - here;
            below = at<N>(x.below, u) - here;
            if (!bends) return;
            turn_u = cd::CD_ISA::turn_u<N>(x, u);
            turn_v = cd::CD_ISA::turn_v<N>(x, u);
            twist = cd::CD_ISA::twist<N>(x, u);
        }
    };

    template <int N, class Add> void each(size_t u, const Add& add) const {
        using L = Lanes<N>;
        const bool bends = sheet.bends();
        const size_t row = r * grid.pitch + u;
        Seen<N> seen[kMostDirections];
        for (int k = 0; k < n; ++k) seen[k].look(Rows(grid, z[k], r), u, bends);
        const L ground = select(L::load(sheet.mass + row), L::load(sheet.ground + row), L{});
        const L spring_u = L::load(sheet.spring[0] + row), spring_v = L::load(sheet.spring[1] + row);
        int pair = 0;
        for (int k = 0; k < n; ++k) {
            const Seen<N>& p = seen[k];
            for (int j = k; j < n; ++j, ++pair) {
                const Seen<N>& q = seen[j];
                L sum = ground * (p.here * q.here);
                sum = sum + spring_u * (p.right * q.right);
                sum = sum + spring_v * (p.below * q.below);
                if (bends) {
                    sum = sum + L::load(sheet.bend[0] + row) * (p.turn_u * q.turn_u);
                    sum = sum + L::load(sheet.bend[1] + row) * (p.turn_v * q.turn_v);
                    sum = sum + L::load(sheet.twist + row) * (p.twist * q.twist);
                }
                add(pair, sum);
            }
        }
        const L right = L::load(b + row);
        for (int k = 0; k < n; ++k) add(pair + k, seen[k].here * right);
    }
};

} // namespace

void pull_separable(const Grid& grid, const SeparableSheet& sheet, const double* x, bool constant, double gravity,
                    double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Separable bundles{grid, sheet, constant, gravity, out + r * grid.pitch, Rows(grid, x, r), r};
        along_row(0, grid.columns, bundles);
    }
}

void pull_general(const Grid& grid, const GeneralSheet& sheet, const double* x, double* out, size_t first,
                  size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Puller bundles{grid, general_row(grid, sheet, x, r), out, r};
        along_row(0, grid.columns, bundles);
    }
}

void apply(const Grid& grid, const GeneralSheet& sheet, const double* z, double* out, double* energy, size_t first,
           size_t count) {
    for (size_t r = first; r < first + count; ++r)
        energy[r] = row_sum(grid.columns, Applier{grid, general_row(grid, sheet, z, r), out, r});
}

void moments(const Grid& grid, const GeneralSheet& sheet, const double* x, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Bender bundles{sheet, Rows(grid, x, r), r * grid.pitch};
        along_row(0, grid.columns, bundles);
    }
}

void energies(const Grid& grid, const GeneralSheet& sheet, const double* const* z, int n, const double* b, double* sums,
              size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r)
        row_sums<kEnergies>(grid.columns, energies_of(n), Energies{grid, sheet, z, n, b, r}, sums + r * kEnergies);
}

} // namespace CD_ISA
} // namespace cd
