// A line of water (water_line.hh): how deep faces are, and velocities where it is dry.
#pragma once

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// The mean of two wet cells, else the gate; of a film no more than lets it run dry in the step. Returns the range of
// those inside.
template <int N> typename WaterLine<N>::FaceRange WaterLine<N>::measure_faces(const double* depths, double* out) const {
    const double share = wave() * axis.lambda;
    const L most_wetting = L::splat(kLongStep / wave());
    L films{}, shallowest = L::splat(1e300), deepest{};
    const auto faces = [&](size_t i) {
        const size_t l = left_of(i);
        return between_cells<N>(at(bed, l), at(bed, i), at(depths, l), at(depths, i), most_wetting);
    };
    for (size_t i = first_inside(); i < n; ++i) {
        const FaceLanes<N> f = faces(i);
        put(out, i, opening(i) * f.mean);
        shallowest = smaller(f.mean, shallowest), deepest = larger(f.mean, deepest);
        films = larger(films, select(f.film, share * f.drop * f.mean - f.gate, L{}));
    }
    const bool has_films = any_positive(films);
    for (size_t i = first_inside(); i < n && has_films; ++i) {
        const FaceLanes<N> f = faces(i);
        const L most = f.gate * larger(L::splat(1), L::splat(1) / (share * f.drop));
        put(out, i, opening(i) * select(f.film, smaller(f.mean, most), f.mean));
    }
    for (size_t i : {size_t(0), n})
        if (!ring) put(out, i, end_depth(i, depths));
    close(out);
    return {shallowest, deepest};
}

// What kind of step it is for the line. Where waves cross more than two and a half cells, a shore moves so far that the
// surface has to be solved for with the cells that run dry: without, the limiter fires all along it, and energy comes
// out of nothing, 20 times what there was at Courant numbers of 100. Large steps do so from a third of a cell on. Not
// in shorter ones: a cell that runs dry sucks, films rush after it the faster the shorter the step is, and at Courant
// numbers of 0.01 40 times the energy came of it.
template <int N> void WaterLine<N>::size_up(FaceRange depths) {
    const L one = L::splat(1);
    long_step = select(wave() * depths.most - L::splat(kLongStep), one, L{});
    even = even_depths(depths.least, depths.most);
    const L large_step = select(wave() * depths.most - L::splat(kShortStep), one, L{});
    if (alone) thins = axis.corrections > 0 ? large_step : long_step;
    ahead = one;
    if (axis.corrections == 0) return;
    ebbs = L::splat(kVeryLongStep) - wave() * depths.most;
    L fastest{};
    for (size_t i = first_inside(); i < n; ++i) fastest = larger(size_of(at(velocity, i)), fastest);
    const L swift = select(even, axis.courant * fastest - L::splat(0.25), L{});
    ahead = axis.corrections > 1 ? swift : one;
}

// Of a face on a side: the mean of the cell and of a column outside that stands on the cell's bed, but that of the cell
// where a stream rushes out.
template <int N> Lanes<N> WaterLine<N>::end_depth(size_t i, const double* depths) const {
    const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
    if (end.kind != End::kOpen) return L{};
    const size_t cell = i == 0 ? 0 : n - 1;
    const L d = at(depths, cell);
    return opening(i) * select(rushes_out(i), d, 0.5 * (d + outside(end, cell)));
}

// > 0: a stream leaves an open side for less deep water, faster than its waves: nothing outside can tell it to stop.
template <int N> Lanes<N> WaterLine<N>::rushes_out(size_t i) const {
    if (!axis.advected) return L{};
    const size_t cell = i == 0 ? 0 : n - 1;
    const L d = at(depth, cell), inside = inside_end(i), out = positive(i == 0 ? -inside : inside);
    return smaller(out * out - axis.gravity * d, d - outside(axis.end[i == 0 ? 0 : 1], cell));
}

// Between wet cells, a face is as deep in the middle of the step as the water that comes to it by then, and as what
// spreads or closes up makes it (Lax and Wendroff 1960). Of both, since with one alone small waves on a current grow:
// at lambda 1/2 by 1% a step where they cross 0.4 cells and the current 0.08. Where water runs further than a cell, its
// face is as deep as the cell that gives, whose depth at the end of the step counts with a share that keeps this stable
// at any speed; not where depths differ much, as at shores, and of linear momentum at nothing of what spreads.
// In long steps what comes and spreads cannot be told from velocities before the step. Where depths in the line differ
// little, a face there is as deep as the mean of the cells, and counts half of their change (Crank and Nicolson 1947):
// then a step keeps the energy of small waves on a current, whatever they cross, and what carries velocities only takes
// from it. Uneven lines do not look ahead in long steps; and from 4 cells on nothing streams but advected momentum in
// even lines: it would make energy. Nor does linear momentum look ahead in lines with a shore where water ebbs from a
// cell into a much deeper one: its velocity is not that of the water behind. Large steps of two corrections and more
// look into the newest depths instead, but where an even line streams.
template <int N> void WaterLine<N>::look_ahead(const double* speeds) {
    L any{}, shore{};
    for (size_t i = 0; i < n && !axis.advected; ++i) shore = larger(shore, select(at(depth, i), L{}, L::splat(1)));
    const L calm = axis.advected ? select(even, L{}, long_step) : long_step; // > 0: waves outrun what streams
    const auto beside = [&](size_t i, size_t far) { // an end that lets water through has none that spreads
        return at(speeds, !ring && (far == 0 || far == n) && axis.end[far ? 1 : 0].kind != End::kWall ? i : far);
    };
    for (size_t i = first_inside(); i < n; ++i) {
        const size_t l = left_of(i), far_l = ring ? l : i - 1;
        const L d_l = at(depth, l), d_r = at(depth, i), h = at(face, i), mean = 0.5 * (d_l + d_r);
        L later = h - 0.5 * (within(axis.courant * at(speeds, i), -1, 1) * (d_r - d_l));
        const L spread = (0.25 * axis.courant) * (beside(i, i + 1) - beside(i, far_l));
        const L cells = axis.courant * size_of(at(speeds, i)), far = cells - L::splat(1);
        later =
            select(larger(long_step, axis.advected ? L{} : far), later, later * within(L::splat(1) - spread, 0.5, 2));
        const L is_mean = select(size_of(h - mean), L{}, smaller(smaller(d_l, d_r), ahead));
        const L ebb = smaller(shore, smaller(at(speeds, i) * (d_r - d_l), -akin(d_l, d_r)));
        const L looks = select(ebb, L{}, select(long_step, smaller(is_mean, even), is_mean));
        const L centred = alone ? smaller(smaller(is_mean, even), smaller(long_step, -far)) : L{};
        put(face, i, select(centred, h, select(looks, later, h)));
        const L alike = 2 * smaller(d_l, d_r) - larger(d_l, d_r);
        const L steady = smaller(calm, wave() * larger(d_l, d_r) - L::splat(16));
        const L streams_here = select(steady, L{}, smaller(is_mean, smaller(alike, far)));
        const L of_giver = select(streams_here, L::splat(1) - L::splat(1) / cells, L{});
        put(share, i, select(centred, L::splat(-0.5), of_giver));
        any = larger(any, larger(centred, streams_here));
    }
    for (size_t i : {size_t(0), n}) { // of the depth of an open side half is its cell's, or all where water rushes out
        if (ring || axis.end[i ? 1 : 0].kind != End::kOpen) continue;
        const L u = at(speeds, i), cells = axis.courant * (i == 0 ? -u : u), far = cells - L::splat(1);
        const L of_cell = select(rushes_out(i), L::splat(1), L::splat(0.5));
        put(share, i, select(far, of_cell * (L::splat(1) - L::splat(1) / cells), L{}));
        any = larger(any, far);
    }
    close(face);
    streams = any_positive(any);
}

template <int N> void WaterLine<N>::rest_if_dry(size_t i) const {
    put(velocity, i, select(at(face, i), at(velocity, i), L{}));
}

// A dry face inside takes the velocity of the nearest wet one that may come as far in the step, at least of a
// neighbour; of two as near, the mean. Where a step leaves films, the mean by depths, and not more than their momentum
// makes of the water beside the face: a film that has rushed down a slope does not move the lake it comes to. Uses x,
// rest and pull for what comes from the left, its distance at first.
template <int N>
void WaterLine<N>::carry_to_dry_faces(const double* depths, const double* cells, double* velocities) const {
    const L far = L::splat(kFar);
    const L courant = axis.courant * thins; // where 0, to a neighbour only
    const size_t begin = first_inside(), turns = ring ? 2 : 1;
    NearestLanes<N> left{L{}, L{}, far}, right{L{}, L{}, far};
    for (size_t turn = 0; turn < turns; ++turn)
        for (size_t i = begin; i < n; ++i) {
            left.pass(at(depths, i), at(velocities, i), opening(i));
            put(x, i, left.value);
            put(rest, i, left.depth);
            put(pull, i, left.reach(courant));
        }
    for (size_t turn = 0; turn < turns; ++turn)
        for (size_t i = n; i-- > begin;) {
            const L wet = at(depths, i), here = at(velocities, i);
            right.pass(wet, here, opening(i));
            if (turn + 1 < turns) continue;
            const L is_open = opening(i);
            put(velocities, i, is_open * here);
            if (!any_positive(select(wet, L{}, is_open))) continue;
            const L from_left = at(pull, i), from_right = right.reach(courant);
            const L comes = far - smaller(from_left, from_right), by_left = from_right - from_left;
            const L one = L::splat(1), beside = 0.5 * (at(cells, left_of(i)) + at(cells, i));
            const L h_l = select(comes, select(-by_left, L{}, select(thins, one, at(rest, i))), L{});
            const L h_r = select(comes, select(by_left, L{}, select(thins, one, right.depth)), L{});
            const L all = larger(h_l + h_r, select(thins, L{}, beside));
            const L dry = select(all, at(x, i) * (h_l / all) + right.value * (h_r / all), L{});
            put(velocities, i, is_open * select(wet, here, dry));
        }
    close(velocities);
}

} // namespace CD_ISA
} // namespace cd
