// An explicit step of lines whose springs are alike, and whose nodes are but for the ends: see plain_step.hh.
#pragma once

#include <initializer_list>

#include "kernel/explicit_sweep.hh"
#include "kernel/plain_step.hh"

namespace cd {
namespace CD_ISA {

namespace {

template <class T> struct PlainLines {
    static constexpr size_t kWide = size_t(kCountOf<Wide<T>, T>), kMost = 4; // kMost: lines that go along their nodes

    const Lines& lines;
    T *const position, *const velocity;
    const ExplicitCoefficients& c;
    const double* gravity;
    PlainTime<T> time;
    Rate<T> inside, ends[2];
    PlainProbe<T> probe{};

    PlainLines(const Lines& l, const ExplicitCoefficients& coefficients, double dt, const double* g)
        : lines(l),
          position(static_cast<T*>(l.position.data)),
          velocity(static_cast<T*>(l.velocity.data)),
          c(coefficients),
          gravity(g),
          time(dt),
          inside(time.exact * rate(c, l.nodes > 2)),
          ends{Rate<T>(time.exact * rate(c, 0)), Rate<T>(time.exact * rate(c, l.nodes - 1))} {}

    static double rate(const ExplicitCoefficients& c, size_t node) { return c.stiffness[0] * c.inertia[node]; }

    static bool takes(const Lines& lines, const ExplicitCoefficients& c, double dt, const double* gravity) {
        bool all = c.uniform && lines.nodes > 1 && in_plain_range<T>(dt);
        for (size_t k = 0; k < lines.components; ++k) all = all && in_plain_range<T>(__builtin_fabs(gravity[k]));
        for (size_t i : {size_t(0), size_t(lines.nodes > 2), lines.nodes - 1})
            all = all && in_plain_range<T>(rate(c, i)) && (c.gains.gravity[i] == 0 || c.gains.gravity[i] == 1);
        return all;
    }

    // What a node's numbers fall, from any component on; components take turns.
    struct Falls {
        T all[kWide + kMost];

        Falls(const PlainLines& of, size_t node) {
            size_t component = 0;
            for (T& number : all) {
                number = T(of.time.exact * of.c.gains.gravity[node] * of.gravity[component]);
                if (++component == of.lines.components) component = 0;
            }
        }
    };
    template <class V, class G>
    void move(const Rate<T>& by, G falling, V x, V v, V pull, T* to_x, T* to_v, V& seen) const {
        move_plainly(by.head * pull, by.tail * pull, falling, time.dt, x, v, to_x, to_v, seen);
    }

    // ---- many lines side by side ----

    // As many of them from `line` on as fill whole bundles before `end`.
    template <class V> void beside(const Falls* falls, size_t& line, size_t end) {
        constexpr size_t n = size_t(kCountOf<V, T>), kLater = 3 * 64 / sizeof(T);
        const size_t z = lines.nodes - 1;
        for (; line + n <= end; line += n) {
            T *x = position + line, *v = velocity + line;
            V here = get<V>(x), left{}, seen{};
            const auto node = [&](const Rate<T>& by, const Falls& all, V next) {
                const V right = next - here;
                __builtin_prefetch(x + kLater); // for bundles to come, see fetch_next_bundle
                __builtin_prefetch(v + kLater);
                move(by, get<V>(all.all + line % lines.components), here, get<V>(v), right - left, x, v, seen);
                x += lines.pitch, v += lines.pitch;
                left = right, here = next;
            };
            node(ends[0], falls[0], get<V>(x + lines.pitch));
            for (size_t i = 1; i < z; ++i) node(inside, falls[1], get<V>(x + lines.pitch));
            node(ends[1], falls[2], here);
            probe.add(seen);
        }
    }
    void step_beside(size_t line, size_t end) {
        const Falls falls[3] = {{*this, 0}, {*this, 1}, {*this, lines.nodes - 1}};
        beside<Wide<T>>(falls, line, end);
        if (sizeof(Wide<T>) > sizeof(Narrow<T>)) beside<Narrow<T>>(falls, line, end);
        beside<T>(falls, line, end);
    }

    // ---- a few lines with no gaps between nodes: along the numbers of all, whose neighbours are `pitch` away ----

    T old[2 * kMost]; // the left neighbours of the numbers that come next

    // Numbers from m on, as many as fill whole bundles before `end`. The left neighbours of as many bundles as reach over
    // kMost numbers are read before the numbers there are stored.
    template <class V> void along(const Falls& falls, size_t& m, size_t end) {
        constexpr size_t n = size_t(kCountOf<V, T>), kAhead = n < kMost ? kMost / n : 1, kReach = kAhead * n;
        if (m + n > end) return;
        const size_t p = lines.pitch, stored = end + p;
        T *const x = position, *const v = velocity;
        V left[kAhead], seen{};
        T begin[kReach] = {};
        memcpy(begin, old, p * sizeof(T));
        for (size_t k = p; k < kReach && m + k - p < stored; ++k) begin[k] = x[m + k - p];
        for (size_t k = 0; k < kAhead; ++k) left[k] = get<V>(begin + k * n);
        const auto bundle = [&](V next) {
            const V here = get<V>(x + m), pull = (get<V>(x + m + p) - here) - (here - left[0]);
            move(inside, get<V>(falls.all + m % p), here, get<V>(v + m), pull, x + m, v + m, seen);
            for (size_t k = 0; k + 1 < kAhead; ++k) left[k] = left[k + 1];
            left[kAhead - 1] = next;
            m += n;
        };
        while (m + kReach + n <= end) bundle(get<V>(x + m + kReach - p));
        while (m + n <= end) {
            T next[n] = {};
            for (size_t k = 0, from = m + kReach - p; k < n && from + k < stored; ++k) next[k] = x[from + k];
            bundle(get<V>(next));
        }
        for (size_t k = 0; k < kAhead; ++k) put(left[k], begin + k * n);
        memcpy(old, begin, p * sizeof(T));
        probe.add(seen);
    }

    // The ends are found first and put down last.
    void step_along() {
        const size_t p = lines.pitch, z = lines.nodes - 1, last = z * p;
        T *const x = position, *const v = velocity;
        T new_x[2][kMost], new_v[2][kMost], seen = 0;
        const Falls falls[3] = {{*this, 0}, {*this, 1}, {*this, z}};
        for (size_t l = 0; l < p; ++l) {
            move(ends[0], falls[0].all[l], x[l], v[l], x[p + l] - x[l] - T(0), &new_x[0][l], &new_v[0][l], seen);
            const size_t e = last + l;
            move(ends[1], falls[2].all[l], x[e], v[e], T(0) - (x[e] - x[e - p]), &new_x[1][l], &new_v[1][l], seen);
            old[l] = x[l];
        }
        probe.add(seen);
        size_t m = p;
        if (last > 16 * kWide) along<T>(falls[1], m, kWide); // up to where registers are aligned
        along<Wide<T>>(falls[1], m, last);
        if (sizeof(Wide<T>) > sizeof(Narrow<T>)) along<Narrow<T>>(falls[1], m, last);
        along<T>(falls[1], m, last);
        for (size_t e : {0, 1}) {
            memcpy(x + e * last, new_x[e], p * sizeof(T));
            memcpy(v + e * last, new_v[e], p * sizeof(T));
        }
    }

    // False if a number left the finite range.
    bool step(size_t first, size_t count) {
        if (count == lines.pitch && count <= kMost) step_along();
        else step_beside(first, first + count);
        return probe.finite();
    }
};

} // namespace

} // namespace CD_ISA
} // namespace cd
