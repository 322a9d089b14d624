// The parts of a sheet that neither springs nor bend join, as where it is torn. The system joins them as little: the
// motions u_p which move one part p alike and leave the others still are orthogonal to each other in energy. Where
// there are several, all of them are taken out of the planes that a step combines,
//
//      z <- z - sum over p of u_p (u_p S z) / (u_p S u_p),
//
// and what a step has to do of each follows on its own from the residual r: (u_p r) / (u_p S u_p). With one of them
// alone among the planes only the momentum of that part would be kept.
#include <string.h>

#include "model/joiner.hh"
#include "model/membrane_work.hh"

namespace cd {

namespace {

// f(place in the planes) for each node, in order
template <class F> void each_place(const Work& w, F f) {
    for (size_t v = 0; v < w.grid.rows; ++v)
        for (size_t u = 0; u < w.grid.columns; ++u) f(v * w.grid.pitch + u);
}

void join_neighbours(const Membrane& m, const Work& w, const Joiner& joiner) {
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            const auto at = [&](size_t column, size_t row) { return row * w.grid.pitch + column; };
            const size_t here = at(u, v), next_u = after(m, kU, u), next_v = after(m, kV, v);
            if (w.spring[kU][here] > 0) joiner.join_all({here, at(next_u, v)});
            if (w.spring[kV][here] > 0) joiner.join_all({here, at(u, next_v)});
            if (!w.bends) continue;
            if (w.bend[kU][here] > 0) joiner.join_all({at(before(m, kU, u), v), here, at(next_u, v)});
            if (w.bend[kV][here] > 0) joiner.join_all({at(u, before(m, kV, v)), here, at(u, next_v)});
            if (w.twist[here] > 0) joiner.join_all({here, at(next_u, v), at(u, next_v), at(next_u, next_v)});
        }
}

// f(part, place, past) for each run [place, past) of a row that is of one part, in order
template <class F> void each_run(const Work& w, F f) {
    const size_t* const of = w.parts.of;
    for (size_t v = 0; v < w.grid.rows; ++v) {
        const size_t end = v * w.grid.pitch + w.grid.columns;
        for (size_t at = v * w.grid.pitch, past; at < end; at = past) {
            past = at + 1;
            while (past < end && of[past] == of[at]) ++past;
            if (of[at] > 0) f(of[at], at, past);
        }
    }
}

// sums = for each part the sum of term(place) over its nodes.
template <class Term> void find_sums(const Membrane& m, const Work& w, double* sums, Term term) {
    for (size_t p = 0; p <= m.parts; ++p) sums[p] = 0;
    each_run(w, [&](size_t part, size_t at, size_t past) {
        double sum[4] = {}; // side by side: additions to one sum wait for each other
        for (; at + 4 <= past; at += 4)
            for (size_t k = 0; k < 4; ++k) sum[k] += term(at + k);
        for (; at < past; ++at) sum[0] += term(at);
        sums[part] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
    });
}
// parts.sums = the same over the part's energy.
template <class Term> void find_shares(const Membrane& m, const Work& w, Term term) {
    const SheetParts& parts = w.parts;
    find_sums(m, w, parts.sums, term);
    for (size_t p = 1; p <= m.parts; ++p) parts.sums[p] /= parts.energy[p];
}

} // namespace

void prepare_parts(Membrane& m, Work& w) {
    SheetParts& parts = w.parts;
    const Joiner joiner{parts.of};
    each_place(w, [&](size_t at) {
        parts.of[at] = w.mass[at] > 0 ? at + 1 : 0;
        w.one[at] = w.mass[at] > 0 ? 1 : 0;
    });
    join_neighbours(m, w, joiner);
    each_place(w, [&](size_t at) { parts.of[at] = parts.of[at] > 0 ? joiner.first_of(at) + 1 : 0; });
    m.parts = 0;
    each_place(w, [&](size_t at) {
        if (parts.of[at] > 0) parts.of[at] = parts.of[at] == at + 1 ? ++m.parts : parts.of[parts.of[at] - 1];
    });
    if (m.parts < 2 && !m.mean_apart) return;
    w.system.apply(w.one, parts.pull);
    for (size_t p = 0; p <= m.parts; ++p) parts.energy[p] = 0, parts.afloat[p] = m.mean_apart;
    each_place(w, [&](size_t at) {
        parts.energy[parts.of[at]] += parts.pull[at];
        if (parts.pull[at] != w.ground[at]) // springs that are not stretched do not pull
            parts.afloat[parts.of[at]] = 0;
    });
    m.mean_apart = memchr(parts.afloat + 1, 1, m.parts) != nullptr;
}

void find_outer(const Membrane& m, const Work& w, const double* acts) {
    find_sums(m, w, w.parts.outer, [&](size_t at) { return acts[at]; });
}

void separate_parts(const Membrane& m, const Work& w, double* const* planes, int n, double share,
                    const double* residual, double* taken) {
    const SheetParts& parts = w.parts;
    find_shares(m, w, [&](size_t at) {
        return parts.afloat[parts.of[at]] ? (share - 1) * (parts.pull[at] * planes[0][at]) : residual[at];
    });
    for (size_t p = 1; p <= m.parts; ++p)
        if (parts.afloat[p]) parts.sums[p] += parts.outer[p] / parts.energy[p];
    each_run(w, [&](size_t part, size_t at, size_t past) {
        for (; at < past; ++at) w.one[at] = parts.sums[part];
    });
    // Twice: of a plane that is little else than such motions the first time leaves mostly rounding, which is not
    // orthogonal to them.
    for (int k = 0; k < n; ++k) {
        double* const plane = planes[k];
        taken[k] = 0;
        for (int time = 0; time < 2; ++time) {
            find_shares(m, w, [&](size_t at) { return parts.pull[at] * plane[at]; });
            for (size_t p = 1; p <= m.parts; ++p) taken[k] += parts.sums[p] * parts.sums[p] * parts.energy[p];
            each_run(w, [&](size_t part, size_t at, size_t past) {
                const double out = parts.sums[part];
                for (size_t i = at; i < past; ++i) plane[i] -= out;
                for (size_t i = at; i < past && k == 0; ++i) w.one[i] -= share * out;
            });
        }
    }
}

} // namespace cd
