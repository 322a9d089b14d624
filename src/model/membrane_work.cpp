// The memory and the coefficients of a membrane's steps.
#include "model/membrane_work.hh"

#include <math.h>

#include <initializer_list>

namespace cd {

namespace {

// Has springs along both directions, and so, with bend, twist.
bool is_wide(const Membrane& m) { return m.springs[kU] > 0 && m.springs[kV] > 0; }

// Whether only whole edges hold nodes, and nothing else tells one line from another: the sheet then separates.
bool edges_only(const Membrane& m, const MembraneFeatures& f) {
    const bool fields = f.node_mass || f.spring_stiffness[kU] || f.spring_stiffness[kV] || f.pin || f.mask || f.target;
    const auto holds_edge = [&](cd_edge e) { return holds(f.edge[e]); };
    const bool u = f.ring[kU] || (holds_edge(CD_EDGE_U_FIRST) && holds_edge(CD_EDGE_U_LAST));
    const bool v = f.ring[kV] || (holds_edge(CD_EDGE_V_FIRST) && holds_edge(CD_EDGE_V_LAST));
    return !fields && (!f.bend || !is_wide(m) || (u && v && !(f.ring[kU] && f.ring[kV])));
}

// What goes to a thread at a time, at the least.
constexpr size_t kBandRows = 24, kStripColumns = 128, kPart = 1 << 12;

} // namespace

Work::Work(const Membrane& m, const MembraneFeatures& f, Carver& coefficients, Carver& scratch)
    : implicit(!steps_explicitly(f.method, m.lambda)),
      coupled(CD_WITH_COUPLED && !is_explicit(f.method) && f.solver == CD_SOLVER_COUPLED),
      general(coupled || f.bend || f.likeness != kUniform),
      bends(CD_WITH_BEND && f.bend),
      uniform(!general),
      swept(uniform && !f.ring[kU] && !f.ring[kV]),
      bands(m.rows, m.columns, kBandRows, kPart),
      strips(m.columns, m.rows, kStripColumns, kPart),
      shared{SharedLines(m.columns, f.bend, f.ring[kU], coefficients),
             SharedLines(m.rows, f.bend, f.ring[kV], coefficients)},
      parts{},
      preconditioner{{}, bands, strips, {}, {}, f.bend},
      gradient{} {
    coefficients.fits &= grid_of(m.columns, m.rows, grid) && grid_of(m.rows, m.columns, turned);
    const auto plane = [&](Carver& carve, bool needed) { return needed ? carve.plane(grid) : nullptr; };
    for (Direction d : {kU, kV}) {
        const auto row = [&] { return coefficients.numbers(nodes_along(m, d)); };
        rows[d] = {row(), row(), row(), row(), row(), reinterpret_cast<uint8_t*>(row())};
    }
    // There is room for implicit steps even where lambda is so small that they are explicit ones.
    const bool solves = !is_explicit(f.method);

    mass = plane(coefficients, general);
    ground = plane(coefficients, general);
    inverse = plane(coefficients, general);
    tie = plane(coefficients, f.target);
    twist = plane(coefficients, bends);
    for (Direction d : {kU, kV}) {
        spring[d] = plane(coefficients, general);
        bend[d] = plane(coefficients, bends);
    }
    looked = nullptr;
    if (uniform) {
        size_t numbers = 0;
        scratch.fits = scratch.fits && multiply(bands.count(), kLookedRows, numbers) &&
                       multiply(numbers, grid.pitch, numbers) && add(numbers, 16, numbers);
        looked = scratch.numbers(numbers);
        if (looked) looked += 8; // what lies beyond the first row
    }
    scaled = plane(scratch, general || (solves && !swept));
    residual = solves && swept ? scratch.filtered_plane(grid) : plane(scratch, general || solves);
    const bool two_stages = f.method == CD_METHOD_STIFF_SECOND;
    kept_x = plane(scratch, two_stages);
    kept_v = plane(scratch, two_stages);

    system = {&m.kernels->sheet, &m.parallel, grid, turned, {f.ring[kU], f.ring[kV]}, {}, nullptr, inverse};
    GeneralSheet& sheet = system.sheet;
    sheet = {mass, ground, {spring[kU], spring[kV]}, {bend[kU], bend[kV]}, twist, {}};
    for (double*& moment : sheet.moment) moment = plane(scratch, bends);
    size_t energies = 0;
    scratch.fits = scratch.fits && multiply(m.rows, kEnergies, energies);
    system.sums = general ? scratch.numbers(energies) : nullptr;

    const bool lines_differ = solves && !coupled && f.likeness == kDiffer;
    one = plane(coefficients, lines_differ || coupled);
    if (lines_differ || coupled) parts = SheetParts(m, grid, coefficients, scratch);
    for (int factor = 0; factor < factors() && lines_differ; ++factor) {
        line[factor][kU] = LineRows(coefficients, turned, f.ring[kU]);
        line[factor][kV] = LineRows(coefficients, grid, f.ring[kV]);
    }
    turned_plane = solves && !coupled && !swept ? scratch.plane(turned) : nullptr;
    const bool may_separate = solves && !coupled;
    coefficients.fits &= grid_of(1, m.rows, line_of_rows);
    row_plane = may_separate ? scratch.plane(line_of_rows) : nullptr;
    row_change = may_separate ? scratch.numbers(m.rows) : nullptr;
    const bool rods = solves && !coupled && (bends || f.ring[kU] || f.ring[kV]);
    const size_t larger =
        grid.pitch * grid.rows > turned.pitch * turned.rows ? grid.pitch * grid.rows : turned.pitch * turned.rows;
    slope = rods ? scratch.numbers(larger) : nullptr;
    free_v = plane(scratch, lines_differ || coupled);
    answer[0] = plane(scratch, lines_differ || coupled);
    answer[1] = plane(scratch, lines_differ);
    answer[2] = plane(scratch, lines_differ);
    const bool may_hold = f.likeness != kDiffer && (f.pin || f.target) && solves;
    if (may_hold) held.carve(coefficients);
    held.count = may_hold ? m.held : 0;
    for (Direction d : {kU, kV}) {
        coefficients.fits &= grid_of(HeldNodes::kMost, nodes_along(m, d), across[d]);
        response[d] = may_hold && !coupled ? coefficients.plane(across[d]) : nullptr;
        grounded[d] = may_hold && !coupled ? coefficients.numbers(HeldNodes::kMost) : nullptr;
    }
    wish = may_hold && !coupled ? scratch.numbers(HeldNodes::kMost) : nullptr;
    const Grid& longer = across[m.columns > m.rows ? kU : kV];
    across_plane = may_hold && !coupled ? scratch.plane(longer) : nullptr;
    across_slope = may_hold && rods ? scratch.plane(longer) : nullptr;
    if constexpr (CD_WITH_COUPLED) {
        if (!coupled) return;
        gradient = GradientPlanes(system, scratch);
        if (f.likeness != kDiffer && !bends && !f.ring[kU] && !f.ring[kV]) {
            preconditioner.lines.carve(grid, may_hold ? &held : nullptr, coefficients, scratch);
            for (Direction d : {kU, kV}) preconditioner.lines.inverse_mass[d] = rows[d].inverse_mass;
        }
        preconditioner.first.carve(system, bends, coefficients, scratch);
        if (bends) preconditioner.second.carve(system, bends, coefficients, scratch);
    }
}

SheetParts::SheetParts(const Membrane& m, const Grid& grid, Carver& coefficients, Carver& scratch)
    : of(reinterpret_cast<size_t*>(coefficients.plane(grid))),
      pull(coefficients.plane(grid)),
      energy(coefficients.numbers(m.nodes + 1)),
      afloat(reinterpret_cast<uint8_t*>(coefficients.numbers(m.nodes / sizeof(double) + 1))),
      sums(scratch.numbers(m.nodes + 1)),
      outer(scratch.numbers(m.nodes + 1)) {}

bool needs_of(const Membrane& m, const MembraneFeatures& f, MembraneNeeds& out) {
    if constexpr (CD_WITH_CLOTH)
        if (f.cloth) return cloth_needs_of(m, f, out);
    out = {};
    for (cd_solver solver : {CD_SOLVER_ALTERNATING, CD_SOLVER_COUPLED})
        for (Likeness likeness : {kUniform, kSeparate, kDiffer}) {
            if (f.solver != solver && f.solver != CD_SOLVER_AUTO) continue;
            if (likeness != kUniform && edges_only(m, f)) continue;
            MembraneFeatures with = f;
            with.solver = solver;
            with.likeness = likeness;
            Carver coefficients{nullptr}, scratch{nullptr};
            const Work counted(m, with, coefficients, scratch);
            if (!coefficients.fits || !scratch.fits) return false;
            if (coefficients.taken > out.coefficients) out.coefficients = coefficients.taken;
            if (scratch.taken > out.scratch) out.scratch = scratch.taken;
        }
    return true;
}

// ---- coefficients ---------------------------------------------------------------------------------------------------

namespace {

// A line of a separable sheet along d, all its numbers divided by what they have in common.
struct UniformLine {
    const Membrane& m;
    Direction d;
    double h, sigma;             // sigma: h (h + damping), of an explicit step h
    const uint8_t* holds;        // per node of the line: whether the whole cross line is held
    double share = 1, shift = 0; // how much of the drag the line has, of both directions, and what else grounds it

    size_t nodes() const { return nodes_along(m, d); }
    bool held(size_t i) const { return holds[i] != 0; }
    double weight(size_t i) const { return line_weight(m, d, i); }
    double rate(double stiffness) const { return sigma * stiffness / uniform_mass(m); }

    double spring(size_t i) const { return i < springs_along(m, d) ? rate(uniform_stiffness(m, d)) : 0; }
    // The twist, where there is any, is counted as bend of both directions: see membrane_step.cpp.
    double bend(size_t i) const {
        const bool end = !m.ring[d] && (i == 0 || i + 1 >= nodes());
        return end ? 0 : rate(is_wide(m) ? 2 * uniform_bend(m, d) : uniform_bend(m, d));
    }
    // A matched end's impedance over the node's mass [1/s].
    double matched(size_t i) const {
        const size_t inside = inside_matched(m, d, i);
        return inside == i ? 0 : sqrt(uniform_stiffness(m, d) / uniform_mass(m) * weight(inside)) / weight(i);
    }
    double ground(size_t i) const {
        return held(i) ? double(INFINITY) : weight(i) * (share * (1 + h * m.drag) + h * matched(i) + shift);
    }
    bool repeats(size_t i) const { return i > 1 && i + 1 < nodes() && holds[i] == holds[i - 1]; }
};

void prepare_rows(const Membrane& m, Work& w, double h, double sigma, uint8_t* const* holds) {
    for (Direction d : {kU, kV}) {
        const UniformLine line{m, d, h, sigma, holds[d]};
        const size_t n = line.nodes();
        const double resist = 1 + h * m.drag;
        for (size_t i = 0; i < n; ++i) {
            const double weight = line.weight(i), slowed = resist + h * line.matched(i);
            const double gain = !w.implicit ? 1 : d == kU ? resist / slowed : 1 / slowed;
            w.rows[d].after[i] = line.spring(i) / weight;
            w.rows[d].before[i] = line.spring(i > 0 ? i - 1 : n - 1) / weight;
            if (i == 0 && !m.ring[d]) w.rows[d].before[i] = 0;
            w.rows[d].gain[i] = line.held(i) ? 0 : gain;
            w.rows[d].inverse_mass[i] = d == kU ? 1 / weight : 1 / (weight * uniform_mass(m));
            w.rows[d].drag[i] = h * line.matched(i);
        }
        for (double* row : {w.rows[d].before, w.rows[d].after, w.rows[d].gain, w.rows[d].inverse_mass, w.rows[d].drag})
            for (size_t i = n; i % 8 != 0; ++i) row[i] = 0; // beyond the sheet
        if (w.implicit) w.shared[d].factor(line, has_bend(m));
    }
}

void prepare_planes(const Membrane& m, Work& w, double h, double sigma) {
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            const size_t at = v * w.grid.pitch + u;
            const bool moves = present(m, u, v) && !held(m, u, v);
            const double mass = moves ? mass_of(m, u, v) : 0;
            w.mass[at] = mass;
            w.ground[at] = moves ? mass + h * drag_of(m, u, v) + (w.implicit ? h * h * tie_of(m, u, v) : 0) : 0;
            w.inverse[at] = moves ? 1 / mass : 0;
            if (w.tie) w.tie[at] = h * tie_of(m, u, v);
            if (w.twist) w.twist[at] = sigma * twist_of(m, u, v);
            for (Direction d : {kU, kV}) {
                w.spring[d][at] = sigma * stiffness_of(m, d, u, v);
                if (w.bends) w.bend[d][at] = sigma * bend_of(m, d, u, v);
            }
        }
    w.system.wrap(w.spring[kU]);
}

// With bend the system is nearly (G + p L) (G + q L), G the root of its ground, with p + q the stretch over a node's
// root mass and p q the bend. Where there are no such real numbers, both are the root of the bend. Springs of one of
// the factors; `mass` is the sheet's mean, which keeps p and q alike from node to node where the bend counts.
double factor_spring(const Membrane& m, double sigma, double mass, Direction d, int factor, size_t u, size_t v) {
    const size_t next_u = d == kU ? after(m, kU, u) : u, next_v = d == kV ? after(m, kV, v) : v;
    const bool there = (d == kU ? u : v) < springs_along(m, d) && present(m, u, v) && present(m, next_u, next_v);
    if (!there) return 0;
    const Direction o = other(d);
    const double stretch = sigma * stiffness_of(m, d, u, v) / sqrt(mass);
    const double bend = sigma * uniform_bend(m, d) * line_weight(m, o, o == kU ? u : v);
    const double square = stretch * stretch - 4 * bend;
    if (!(square > 0)) return sqrt(bend);
    const double larger = (stretch + sqrt(square)) / 2;
    return factor == 0 ? larger : bend / larger;
}
double factor_ground(const Work& w, size_t u, size_t v) {
    const double ground = w.ground[v * w.grid.pitch + u];
    return w.bends ? sqrt(ground) : ground;
}
double mean_mass(const Membrane& m, const Work& w) {
    double sum = 0;
    size_t moving = 0;
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            sum += w.mass[v * w.grid.pitch + u];
            moving += w.mass[v * w.grid.pitch + u] > 0;
        }
    return moving > 0 ? sum / double(moving) : 1;
}

void prepare_lines(const Membrane& m, Work& w, double sigma) {
    const double mass = mean_mass(m, w);
    const auto ground = [&](size_t v, size_t u) { return factor_ground(w, u, v); };
    for (int f = 0; f < w.factors(); ++f) {
        const auto spring = [&](Direction d, size_t v, size_t u) {
            return w.bends ? factor_spring(m, sigma, mass, d, f, u, v) : w.spring[d][v * w.grid.pitch + u];
        };
        factor_lines(
            w.grid, ground, [&](size_t v, size_t u) { return spring(kV, v, u); }, w.line[f][kV]);
        factor_lines(
            w.turned, [&](size_t u, size_t v) { return ground(v, u); },
            [&](size_t u, size_t v) { return spring(kU, v, u); }, w.line[f][kU]);
    }
}

#if CD_WITH_COUPLED

void prepare_shifts(const Membrane& m, Work& w, double h, double sigma, uint8_t* const* holds) {
    ShiftedLines& lines = w.preconditioner.lines;
    const double least = (1 + h * m.drag) / 2;
    double greatest = least;
    for (Direction d : {kU, kV})
        for (size_t i = 0; i < nodes_along(m, d); ++i)
            greatest = fmax(greatest, least + w.rows[d].drag[i] + 2 * (w.rows[d].before[i] + w.rows[d].after[i]));
    lines.choose(least, greatest);
    for (Direction d : {kU, kV})
        lines.factor(d, nodes_along(m, d), [&](double shift) {
            return UniformLine{m, d, h, sigma, holds[d], 0.5, shift}; // half of the drag for each direction
        });
    if (lines.ready()) lines.hold(w.system, w.bands, w.strips, w.gradient.start, w.gradient.steep);
}

void prepare_multigrid(const Membrane& m, Work& w, double sigma) {
    const double mass = mean_mass(m, w);
    Multigrid* const hierarchies[2] = {&w.preconditioner.first, &w.preconditioner.second};
    for (int f = 0; f < w.factors(); ++f) {
        const MultigridLevel& first = hierarchies[f]->level[0];
        for (size_t v = 0; v < m.rows && w.bends; ++v)
            for (size_t u = 0; u < m.columns; ++u) {
                const size_t at = v * w.grid.pitch + u;
                first.ground[at] = factor_ground(w, u, v);
                for (Direction d : {kU, kV}) first.spring[d][at] = factor_spring(m, sigma, mass, d, f, u, v);
            }
        if (w.bends) w.system.wrap(first.spring[kU]);
        hierarchies[f]->build();
    }
}

void prepare_preconditioner(const Membrane& m, Work& w, double h, double sigma, uint8_t* const* holds) {
    ShiftedLines& lines = w.preconditioner.lines;
    if (lines.shift) prepare_shifts(m, w, h, sigma, holds);
    if (!lines.ready()) prepare_multigrid(m, w, sigma);
}

#endif

// Of the system at a node that moves.
double diagonal_entry(const Membrane& m, const Work& w, size_t u, size_t v) {
    const size_t left = before(m, kU, u), row = v * w.grid.pitch, above = before(m, kV, v) * w.grid.pitch;
    const size_t at = row + u, back[2] = {row + left, above + u},
                 next[2] = {row + after(m, kU, u), after(m, kV, v) * w.grid.pitch + u};
    double sum = w.ground[at];
    for (Direction d : {kU, kV}) {
        sum += w.spring[d][at] + w.spring[d][back[d]];
        if (w.bends) sum += 4 * w.bend[d][at] + w.bend[d][back[d]] + w.bend[d][next[d]];
    }
    return w.bends ? sum + w.twist[at] + w.twist[back[kU]] + w.twist[back[kV]] + w.twist[above + left] : sum;
}

// The largest diagonal entry of the system, and whether it is larger than the least mass. For coupled solves the
// inverse of all.
void measure(Membrane& m, const Work& w) {
    double lightest = INFINITY;
    m.stiffest = 0;
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            const size_t at = v * w.grid.pitch + u;
            const bool moves = w.mass[at] > 0;
            const double entry = moves ? diagonal_entry(m, w, u, v) : 0;
            m.stiffest = fmax(m.stiffest, entry);
            if (moves) lightest = fmin(lightest, w.mass[at]);
            if (w.coupled) w.inverse[at] = moves ? 1 / entry : 0;
        }
    m.whole = m.stiffest > 2 * lightest && (m.method != CD_METHOD_IMPLICIT || m.lambda >= 0.5);
    m.mean_apart = m.whole && m.stiffest > kStiffSheet * lightest;
}

} // namespace

void prepare(Membrane& m, Work& w, double dt) {
    const double h = stage_share(m, dt), sigma = w.implicit ? h * (h + m.damping) : h;
    uint8_t* const holds[2] = {w.rows[kU].holds, w.rows[kV].holds};
    m.held = 0;
    if (m.likeness != kDiffer) {
        find_held(m, w, h);
        prepare_rows(m, w, h, sigma, holds);
    }
    if (w.general) prepare_planes(m, w, h, sigma);
    if (m.likeness != kDiffer && w.general && w.implicit)
        for (size_t v = 0; v < m.rows; ++v)
            for (size_t u = 0; u < m.columns; ++u)
                w.inverse[v * w.grid.pitch + u] *= w.rows[kU].gain[u] * w.rows[kV].gain[v];
    if (w.implicit && !w.coupled && m.likeness == kDiffer) prepare_lines(m, w, sigma);
    if (m.held > 0 && !w.coupled) prepare_held(m, w, h);
#if CD_WITH_COUPLED
    if (w.implicit && w.coupled) prepare_preconditioner(m, w, h, sigma, holds);
#endif
    m.whole = m.mean_apart = m.stiff_rod = false;
    if (w.implicit && (w.coupled || m.likeness == kDiffer)) {
        measure(m, w);
        prepare_parts(m, w);
    } else if (w.implicit) {
        const bool all_held = w.rows[m.springs[kU] > 0 ? kV : kU].holds[0] != 0; // of a single line
        m.stiff_rod = has_bend(m) && !is_wide(m) && !all_held && is_too_stiff(m, sigma);
        m.mean_apart = !m.stiff_rod && is_stiff_and_afloat(m, w);
    }
}

} // namespace cd
