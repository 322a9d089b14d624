// One elimination along the strand solves a Newton iteration. With C the mobility of all that hangs on the left of a
// node (velocity per impulse) and y where that would go by itself, a spring passes both on: see eliminate().
#include "kernel/rope_step.hh"

#include <math.h>

#include "contdyn/base.h"
#include "kernel/lines.hh"
#include "kernel/vectors.hh"

namespace cd {
namespace CD_ISA {

namespace {

// A spring shorter than this, over its rest length, has no direction of its own.
constexpr double kNoDirection = 1e-12;
// The least cosine between a spring's direction after the step and that in which it acts, for Newton's guess to hold.
constexpr double kLeastTurn = 0.1;
// The least length of a spring, over its rest length, by which its transverse stiffness is reckoned.
constexpr double kLeastLever = 0.1;
// The most of a spring's axial stiffness that its transverse stiffness may be.
constexpr double kMostTransverse = 0.9;
// How much softer than they are springs count where velocities settle, over what their nodes yield. Where a rope is all
// but straight between heavy nodes, light ones would have to leap to keep lengths exactly.
constexpr double kSettleSoftly = 1e-6;
constexpr double kMostError = 1e300; // of lengths, over rest lengths: beyond it, no iteration helps
constexpr size_t kMostNewton = 8;    // iterations before a safer step is tried
// Of the interior point.
constexpr double kLeastForce = 1e-30; // [N]
constexpr double kShrink = 0.9;       // what a spring longer than it may be shortens to in a step, over its length
constexpr double kFirstGap = 0.1;     // the least gap to start with, over the rest length
constexpr double kBarrierFall = 0.1;  // the barrier of an iteration over that of the one before
constexpr double kInside = 0.95;      // how much of the way to a tension or gap of 0 a step goes

// N strands.
template <int N> struct Bundle {
    using L = Lanes<N>;
    using V = Vector<N>;
    using M = Matrix<N>;

    struct Node {
        L ground, mobility; // and 1 / ground, of what is held 0
        V b, w, next;       // next: what the last elimination gave
        V y;
        M c;
    };
    // Of spring i from node i to node i + 1.
    struct Spring {
        V before;                  // D0
        V along, acting;           // unit vectors along D1 and z
        V wish;                    // e, what dw would be if the spring had its length
        L wished;                  // along . e
        L taut, transverse, axial; // 1 or 0; s and the axial compliance, of impulses
        L tension, next, pushed;   // pushed: the tension that would be below 0
        V impulse;                 // phi of the last elimination
        L length, per_length;
        L long_before, gap; // |D0|, and of the interior point what is left to L
    };

    const Ropes& ropes;
    const RopeCoefficients& c;
    const RopeStage& stage;
    Node* const nodes;
    Spring* const springs;
    size_t first, count;        // strands
    L lambda, per_lambda, open; // open: 1 where a strand is still to be solved
    L iterations{}, reached{}, failed{};
    L apart{}; // the error of springs between held nodes

    static L one() { return L::splat(1); }
    // Springs that no node moves by: those that are cut, or between two held nodes.
    bool is_idle(size_t i) const { return isinf(c.compliance[i]) || (held(i) && held(i + 1)); }
    bool held(size_t i) const { return c.pin[i] == CD_NODE_PINNED || c.pin[i] == CD_NODE_DRIVEN; }

    // Strands beyond the last are the last one again.
    size_t place(size_t i, int lane) const {
        const size_t own = size_t(lane) < count ? size_t(lane) : count - 1;
        return i * ropes.pitch + (first + own) * ropes.components;
    }
    V load(StateNumbers numbers, size_t i) const {
        double lane[3][N] = {};
        for (int j = 0; j < N; ++j)
            for (size_t k = 0; k < ropes.components; ++k) lane[k][j] = numbers[place(i, j) + k];
        return {L::load(lane[0]), L::load(lane[1]), L::load(lane[2])};
    }
    void store(V a, StateNumbers numbers, size_t i) const {
        const double least = numbers.is_float64 ? Limits<double>::least : double(Limits<float>::least);
        double lane[3][N];
        settled(a.x, least).store(lane[0]), settled(a.y, least).store(lane[1]), settled(a.z, least).store(lane[2]);
        for (int j = 0; j < N && size_t(j) < count; ++j)
            for (size_t k = 0; k < ropes.components; ++k) numbers.put(place(i, j) + k, lane[k][j]);
    }
    size_t tension_place(size_t i, int lane) const {
        return i * ropes.strands + first + (size_t(lane) < count ? size_t(lane) : count - 1);
    }
    L load_tension(size_t i) const {
        double lane[N];
        for (int j = 0; j < N; ++j) lane[j] = ropes.tension[tension_place(i, j)];
        return L::load(lane);
    }
    V gravity() const { return {L::splat(stage.gravity[0]), L::splat(stage.gravity[1]), L::splat(stage.gravity[2])}; }

    // ---- the start of a step ----------------------------------------------------------------------------------------

    // What nodes would do alone; and for what is open the guess that they go on as they are.
    void begin() {
        const L h = stage.dt * lambda;
        per_lambda = one() / lambda;
        for (size_t i = 0; i < ropes.nodes; ++i) {
            const V v = load(ropes.velocity, i);
            Node& n = nodes[i];
            n.w = select(open, v, n.w);
            n.mobility = L{};
            if (held(i)) {
                n.b = v;
                continue;
            }
            const L m = L::splat(c.mass[i]);
            n.ground = m + h * (L::splat(c.drag[i]) + h * L::splat(c.tie[i]));
            V push = m * gravity();
            if (ropes.force.data) push = push + load(ropes.force, i);
            if (ropes.target.data) push = push + L::splat(c.tie[i]) * (load(ropes.target, i) - load(ropes.position, i));
            n.mobility = one() / n.ground;
            n.b = n.mobility * (m * v + h * push);
        }
        V left = load(ropes.position, 0);
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            const V right = load(ropes.position, i + 1);
            springs[i].before = right - left;
            springs[i].long_before = root(dot(springs[i].before, springs[i].before));
            springs[i].impulse = select(open, V{}, springs[i].impulse);
            springs[i].pushed = L{};
            springs[i].tension = is_idle(i) ? L{} : select(open, load_tension(i), springs[i].tension);
            springs[i].length = L::splat(c.length[i]), springs[i].per_length = L::splat(c.per_length[i]);
            left = right;
        }
    }

    // ---- one iteration ----------------------------------------------------------------------------------------------

    // Unit vectors; of a spring without a direction, that of `other`.
    // The unit vector along `a`, given one over its length; `other` where it is too short to have one.
    static V direction(V a, L longer, L inverse, V other) { return select(longer, inverse * a, other); }

    // What a look at all springs sees of the guess.
    struct Seen {
        L error{}, probe{};  // its largest error of length, over the rest length; NaN if a number is
        L pushed{};          // the sum of the pushes of springs that only pull, times lengths
        L gained{}, worth{}; // the energy that springs give from nothing, and the sum of tensions times lengths
        L slack{};           // the sum of tensions times what their springs are too short for them
    };

    // Linearizes spring i about the guess (w, T). barrier > 0: T gap = barrier instead of "slack or taut".
    void linearize(size_t i, L barrier, bool interior, Seen& seen) {
        Spring& s = springs[i];
        const double compliance = c.compliance[i];
        const L length = s.length, per_length = s.per_length;
        const V dw = nodes[i + 1].w - nodes[i].w;
        const L t = s.tension, dt = L::splat(stage.dt);
        const L theta = by_sign(t, L::splat(0.5), lambda);
        const V after = s.before + dt * dw, z = s.before + (theta * dt) * dw;
        const L long_after = root(dot(after, after)), long_z = root(dot(z, z));
        const L per_z = one() / long_z, least = kNoDirection * length;
        const V z_way = direction(z, long_z - least, per_z, V{one(), L{}, L{}});
        s.along = direction(after, long_after - least, one() / long_after, z_way);
        const V acting = direction(z, long_z - least, per_z, s.along);
        const L turn = dot(s.along, acting), turns = turn - L::splat(kLeastTurn);
        s.acting = select(turns, acting, s.along);
        const L cosine = select(turns, turn, one());
        L over = long_after - length;

        if (is_idle(i)) {
            if (compliance > 0) s.tension = (1 / compliance) * (stage.push ? over : positive(over));
            else apart = larger(apart, per_length * over);
            s.taut = s.transverse = s.axial = L{};
            s.wish = dw, s.wished = L{};
            return;
        }
        const L missing = over - compliance * t;
        // The work that its impulse did on the nodes, beyond what a spring of this tension can give.
        const L stretch = long_after - s.long_before;
        seen.probe = seen.probe + 0.0 * missing;
        seen.gained = seen.gained + (t * stretch - dot(s.impulse, dw) * per_lambda);
        seen.worth = seen.worth + (size_of(t) + s.pushed) * length;
        seen.pushed = seen.pushed + s.pushed * length;
        L yields = L::splat(compliance);
        if (interior) {
            over = over + (s.gap + barrier / t);
            yields = yields + s.gap / t;
            s.taut = one();
            seen.error = larger(seen.error, per_length * missing);
            seen.slack = seen.slack + t * positive(L{} - missing);
        } else {
            const L give = (stage.dt * stage.dt) * (nodes[i].mobility + nodes[i + 1].mobility) + L::splat(compliance);
            s.taut = stage.push ? one() : select(give * t + over, one(), L{});
            seen.error = larger(seen.error, s.taut * (per_length * size_of(missing)));
        }
        const L impulse = (stage.dt * stage.dt) * lambda; // of a unit of stiffness, per velocity
        const L lever = smaller(per_z, (1 / kLeastLever) * per_length);
        s.transverse = s.taut * ((theta * impulse) * (positive(t) * lever));
        s.axial = L{};
        if (interior || compliance > 0) {
            const L a = yields / impulse, stiff = s.transverse;
            s.transverse = select(a * stiff - L::splat(kMostTransverse), L::splat(kMostTransverse) / a, stiff);
            s.axial = a / (one() - a * s.transverse);
        }
        const double rate = 1 / stage.dt;
        s.wish = dw - ((rate * over) / cosine) * s.acting;
        s.wished = dot(s.along, dw) - rate * over;
    }

    // Solves the linear system: phi_i = s (dw - e) + u tau, c . (dw - e) = axial tau, into `next`.
    void eliminate() {
        M mobility = M::diagonal(nodes[0].mobility);
        V y = nodes[0].b;
        nodes[0].c = mobility, nodes[0].y = y;
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            const Spring& s = springs[i];
            Node& node = nodes[i + 1];
            if (held(i + 1)) {
                mobility = M::diagonal(L{});
                y = node.b;
            } else {
                const L m = node.ground, stiff = s.transverse, ms = m * stiff, diagonal = m + stiff;
                M a{ms * mobility.x, ms * mobility.y, ms * mobility.z};
                a.x.x = a.x.x + diagonal, a.y.y = a.y.y + diagonal, a.z.z = a.z.z + diagonal;
                const M share = inverse(a);
                const V right = share * s.acting, left = transposed_times(share, s.along);
                const L yields = s.axial + dot(s.along, right + m * (mobility * right));
                const L pull = s.taut / yields;
                const V q = stiff * (share * ((y - node.b) + s.wish));
                const L tau = (dot(s.along, (q + m * (mobility * q)) + (node.b - y)) - s.wished) * pull;
                y = (node.b + q) - tau * right;
                const V l = pull * left;
                const V sx = stiff * share.x, sy = stiff * share.y, sz = stiff * share.z;
                const auto row = [&](V own, V scaled, L r) {
                    return (own + transposed_times(mobility, scaled)) - r * l;
                };
                mobility = {row(share.x, sx, right.x), row(share.y, sy, right.y), row(share.z, sz, right.z)};
            }
            node.c = mobility;
            node.y = y;
        }
        V phi{};
        for (size_t i = ropes.nodes; i-- > 0;) {
            Node& node = nodes[i];
            node.next = node.y + node.c * phi;
            if (i == 0) break;
            Spring& s = springs[i - 1];
            phi = held(i) ? into_held(i) : phi - node.ground * (node.next - node.b);
            s.impulse = phi;
            const L next = s.taut * (dot(phi, s.acting) / (stage.dt * lambda));
            s.next = stage.push ? next : positive(next);
            s.pushed = s.next - next;
        }
    }

    // The impulse of the spring on the left of held node i.
    V into_held(size_t i) const {
        const Spring& s = springs[i - 1];
        const Node& left = nodes[i - 1];
        M a{s.transverse * left.c.x, s.transverse * left.c.y, s.transverse * left.c.z};
        a.x.x = a.x.x + one(), a.y.y = a.y.y + one(), a.z.z = a.z.z + one();
        const M share = inverse(a);
        const V way = (nodes[i].next - left.y) - s.wish, q = s.transverse * (share * way), u = share * s.acting;
        const L yields = s.axial + dot(s.along, left.c * u);
        const L pull = select(yields, s.taut / yields, L{}); // 0 between two held nodes
        const L tau = (dot(s.along, (nodes[i].next - left.y) - left.c * q) - s.wished) * pull;
        return q + tau * u;
    }

    // ---- the nonlinear system ---------------------------------------------------------------------------------------

    // Linearizes all springs; closes the strands that are solved, and those that have come to what is no number. first:
    // nothing has been solved yet. weight: what their tensions times lengths are at least, as errors count.
    void linearize_all(L barrier, bool interior, L weight, bool first) {
        Seen seen;
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) linearize(i, barrier, interior, seen);
        const L worth = larger(seen.worth, weight), wrong = larger(larger(seen.gained, seen.pushed), seen.slack);
        const L error = select(worth, larger(seen.error, wrong / worth), seen.error) + seen.probe;
        reached = select(open, error, reached);
        if (first) return;
        const L solved = select(L::splat(stage.tolerance) - error, one(), L{});
        const L lost = one() - select(L::splat(kMostError) - error, one(), L{});
        failed = failed + open * lost;
        open = open * ((one() - solved) * (one() - lost));
    }

    // Newton's method with springs that are slack or taut.
    void newton(size_t most) {
        for (size_t k = 0;; ++k) {
            linearize_all(L{}, false, L{}, k == 0);
            if (k == most || !any_positive(open)) return;
            eliminate();
            iterations = iterations + open;
            for (size_t i = 0; i < ropes.nodes; ++i) nodes[i].w = select(open, nodes[i].next, nodes[i].w);
            for (size_t i = 0; i + 1 < ropes.nodes; ++i)
                springs[i].tension = select(open, springs[i].next, springs[i].tension);
        }
    }

    // The guess that each piece of the rope moves as one: with its momentum, which the iterations keep, or, where it
    // hangs on a held node, not at all.
    void start_together() {
        for (size_t first = 0, i = 0; i < ropes.nodes; ++i) {
            if (i + 1 < ropes.nodes && !is_idle(i)) continue;
            bool hangs = false;
            L mass{};
            V momentum{};
            for (size_t k = first; k <= i; ++k) {
                hangs |= held(k);
                mass = mass + nodes[k].ground;
                momentum = momentum + nodes[k].ground * nodes[k].b;
            }
            for (size_t k = first; k <= i; ++k)
                if (!held(k)) nodes[k].w = select(open, hangs ? V{} : (one() / mass) * momentum, nodes[k].w);
            first = i + 1;
        }
    }

    // Of ropes that only pull, a step of lambda = 1 minimizes a convex function: a primal-dual interior point, in which
    // T gap = barrier for every spring, finds it from anywhere.
    void interior(size_t most) {
        begin();
        L force{}, mass{}, driven{};
        for (size_t i = 0; i < ropes.nodes; ++i) {
            const Node& n = nodes[i];
            const L speed = root(dot(n.b, n.b));
            if (held(i)) driven = driven + speed;
            else mass = mass + n.ground, force = force + n.ground * speed;
        }
        const double each = 1 / double(ropes.nodes);
        force = (each / stage.dt) * (force + (each * mass) * driven);
        force = larger(force, L::splat(kLeastForce));
        start_together();
        const L tried = open;
        L longer{}, weight{}; // weight: of the nodes, times lengths
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            Spring& s = springs[i];
            if (is_idle(i)) continue;
            const L length = larger(s.length, kShrink * s.long_before - c.compliance[i] * positive(s.tension));
            longer = larger(longer, (length - s.length) / s.length);
            s.length = length, s.per_length = one() / length;
            weight = weight + force * length;
            s.gap = larger(s.length - s.long_before, kFirstGap * s.length);
            s.tension = select(open, force, s.tension);
        }
        const double share = 1 / double(ropes.nodes - 1);
        for (size_t k = 0;; ++k) {
            L sum{}; // of tensions times gaps
            for (size_t i = 0; i + 1 < ropes.nodes; ++i)
                if (!is_idle(i)) sum = sum + springs[i].tension * springs[i].gap;
            const L barrier = (kBarrierFall * share) * sum;
            linearize_all(barrier, true, weight, k == 0);
            if (k == most || !any_positive(open)) break;
            eliminate();
            iterations = iterations + open;
            step_inside(barrier);
        }
        finish_inside(tried);
        reached = select(tried, larger(longer, reached), reached); // NaN stays
    }

    // Springs that are much too short for the little tension that the barrier gives them, as tensions go, are slack.
    void finish_inside(L tried) {
        L sum{}, lengths{};
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            if (is_idle(i)) continue;
            sum = sum + springs[i].tension * springs[i].length;
            lengths = lengths + springs[i].length;
        }
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            if (is_idle(i)) continue;
            Spring& s = springs[i];
            const V after = s.before + L::splat(stage.dt) * (nodes[i + 1].w - nodes[i].w);
            const L over = root(dot(after, after)) - s.length, yields = L::splat(c.compliance[i]);
            const L slack = (yields * s.tension - over) * sum - (s.tension * s.length) * lengths;
            const L own = c.compliance[i] > 0 ? positive(over) / yields : L{};
            s.tension = select(tried * select(slack, one(), L{}), own, s.tension);
        }
    }

    // The part of a step that leaves all tensions and gaps positive.
    void step_inside(L barrier) {
        L part = one();
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            if (is_idle(i)) continue;
            const Spring& s = springs[i];
            const L change = s.next - s.tension, fall = (barrier - s.gap * s.next) / s.tension;
            part = select(L{} - change, smaller(part, kInside * (s.tension / (L{} - change))), part);
            part = select(L{} - fall, smaller(part, kInside * (s.gap / (L{} - fall))), part);
        }
        part = open * part;
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            if (is_idle(i)) continue;
            Spring& s = springs[i];
            const L fall = (barrier - s.gap * s.next) / s.tension;
            s.tension = select(open, s.tension + part * (s.next - s.tension), s.tension);
            s.gap = select(open, s.gap + part * fall, s.gap);
        }
        for (size_t i = 0; i < ropes.nodes; ++i)
            nodes[i].w = select(open, nodes[i].w + part * (nodes[i].next - nodes[i].w), nodes[i].w);
    }

    // ---- the end of a step ------------------------------------------------------------------------------------------

    void solve() {
        lambda = L::splat(stage.lambda);
        open = one();
        begin();
        newton(kMostNewton);
        if (!try_again()) return;
        if (stage.lambda < 1) {
            lambda = select(open, one(), lambda);
            begin();
            newton(kMostNewton);
            if (!try_again()) return;
        }
        if (!stage.push) {
            interior(stage.most_iterations);
            if (!try_again()) return;
        }
        calm();
    }
    // Opens the strands that failed; whether there is any to go on with.
    bool try_again() {
        open = open + failed;
        failed = L{};
        return any_positive(open);
    }

    // Of what could not be solved: its nodes move with no more energy than they would have alone.
    void calm() {
        L sum{}, by_themselves{};
        for (size_t i = 0; i < ropes.nodes; ++i) {
            const Node& n = nodes[i];
            if (held(i)) continue;
            sum = sum + n.ground * dot(n.w, n.w);
            by_themselves = by_themselves + n.ground * dot(n.b, n.b);
        }
        const L part = smaller(positive(root(by_themselves / sum)), one()); // 0 if something is no number
        for (size_t i = 0; i < ropes.nodes; ++i) {
            Node& n = nodes[i];
            if (!held(i)) n.w = select(open, select(part, part * n.w, n.b), n.w);
        }
        const L wrong = open * select(one() - part, one(), L{});
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) springs[i].tension = select(wrong, L{}, springs[i].tension);
    }

    // Takes from the velocities what would lengthen or shorten springs that are taut: less energy, and momentum as it
    // was. Without it what a step of lambda < 1 does along stiff springs alternates from step to step.
    void settle() {
        const size_t n = ropes.nodes;
        const L rate = L::splat(1 / stage.dt / stage.dt), none{};
        const L unsettled = select(one() - lambda, one(), none);
        L before_pivot = one(), before_rest{};
        for (size_t i = 0; i + 1 < n; ++i) {
            Spring& s = springs[i];
            const L left = alone(i), right = alone(i + 1);
            const L own = (1 + kSettleSoftly) * (left + right) + c.compliance[i] * rate;
            const L pulls = stage.push ? size_of(s.tension) : s.tension;
            s.taut = is_idle(i) ? none : unsettled * select(pulls, select(own, one(), none), none);
            s.wished = dot(s.along, nodes[i + 1].next - nodes[i].next);
            s.axial = i == 0 ? none : none - springs[i - 1].taut * left * dot(springs[i - 1].along, s.along);
            const L share = s.axial / before_pivot;
            s.transverse = select(s.taut, own - share * s.axial, one());
            s.wished = s.taut * (s.wished - share * before_rest);
            before_pivot = s.transverse, before_rest = s.wished;
        }
        L after{};
        for (size_t i = n - 1; i-- > 0;) {
            Spring& s = springs[i];
            const L coupling = i + 2 < n ? springs[i + 1].taut * springs[i + 1].axial : none;
            after = s.taut * ((s.wished - coupling * after) / s.transverse);
            nodes[i].next = nodes[i].next + (alone(i) * after) * s.along;
            nodes[i + 1].next = nodes[i + 1].next - (alone(i + 1) * after) * s.along;
        }
    }
    L alone(size_t i) const { return held(i) ? L{} : L::splat(1 / c.mass[i]); }

    RopeResult step() {
        solve();
        RopeResult result;
        L bad{};
        for (size_t i = 0; i < ropes.nodes; ++i) {
            Node& n = nodes[i];
            const V x = load(ropes.position, i), v = load(ropes.velocity, i);
            n.y = x + L::splat(stage.dt) * n.w;
            n.next = held(i) ? v : v + (one() / lambda) * (n.w - v);
        }
        if (stage.lambda < 1) settle();
        const bool wide = ropes.position.is_float64;
        const L to_overflow = L::splat(wide ? Limits<double>::to_overflow : Limits<float>::to_overflow);
        for (size_t i = 0; i < ropes.nodes; ++i) {
            const Node& n = nodes[i];
            const V probe = to_overflow * (n.y + n.next);
            bad = bad + 0.0 * ((probe.x + probe.y) + probe.z);
            store(n.y, ropes.position, i);
            if (!held(i)) store(n.next, ropes.velocity, i);
        }
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            double lane[N];
            springs[i].tension.store(lane);
            for (int j = 0; j < N && size_t(j) < count; ++j)
                ropes.tension[tension_place(i, j)] = isfinite(lane[j]) ? lane[j] : 0;
        }
        result.finite = !bad.any_nan();
        result.error = largest_in(larger(reached, apart));
        result.iterations = size_t(largest_in(iterations));
        return result;
    }
};

template <int N> RopeResult step_bundle(const Ropes& ropes, const RopeCoefficients& c, const RopeStage& stage,
                                        double* scratch, size_t first, size_t count) {
    using Here = Bundle<N>;
    static_assert(sizeof(typename Here::Node) + sizeof(typename Here::Spring) == kRopeScratch * N * sizeof(double));
    auto* const nodes = reinterpret_cast<typename Here::Node*>(scratch);
    auto* const springs = reinterpret_cast<typename Here::Spring*>(nodes + ropes.nodes);
    Here bundle{ropes, c, stage, nodes, springs, first, count, {}, {}, {}};
    return bundle.step();
}

} // namespace

RopeResult rope_step(const Ropes& ropes, const RopeCoefficients& c, const RopeStage& stage, double* scratch,
                     size_t first, size_t count) {
    RopeResult result;
    while (count > 0) {
        const size_t now = count < size_t(kNative) ? count : size_t(kNative);
        result.add(now == 1 ? step_bundle<1>(ropes, c, stage, scratch, first, 1)
                            : step_bundle<kNative>(ropes, c, stage, scratch, first, now));
        first += now;
        count -= now;
    }
    return result;
}

} // namespace CD_ISA
} // namespace cd
