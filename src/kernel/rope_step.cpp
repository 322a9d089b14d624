// Steps of strands whose springs have a length: Newton's method, and what stands behind it.
#include "kernel/rope_rod.hh"

namespace cd {
namespace CD_ISA {

// How much softer than they are springs count where velocities settle, over what their nodes yield: along a straight
// rope between two held nodes one of them settles by the others.
constexpr double kSettleSoftly = 1e-12;
constexpr double kMostError = 1e300; // of lengths, over rest lengths: beyond it, no iteration helps
constexpr size_t kMostNewton = 8;    // iterations before a safer step is tried
// Where it goes on, by how much the mass that is added to the nodes rises after an iteration that made the error larger,
// and falls after others: together more than 1, so that it rises where the error goes to and fro; and the most of it, over
// the nodes' own, beyond which rounding would hide what is left out of their momentum, and pass for a solution.
constexpr double kRise = 4, kFall = 0.3, kMostAdded = 1e6;
// Of the interior point.
constexpr double kFirstGap = 0.1;    // the least gap to start with, over the rest length
constexpr double kInside = 0.95;     // how much of the way to a tension or gap of 0 an iteration goes
constexpr double kBarrierFall = 0.1; // the barrier of an iteration over the mean of tensions times gaps
// Where an iteration goes less than this part of its way, some products of tension and gap are far from their mean: to
// bring them together, the next one's barrier is as far above it as others are below. From iteration kRises on it stays,
// or they may go round in a circle, but for contacts: what comes and goes needs it to rise.
constexpr double kStuck = 0.1;
constexpr size_t kRises = 100;

// ---- springs -------------------------------------------------------------------------------------------------------

// Spring i where no node moves by it. One of fixed length may be as much too long as positions are rounded.
template <int N> void RopeBundle<N>::rest(size_t i) {
    Spring& s = springs[i];
    const L over = long_after(i) - s.length, idle = opposite(s.moves);
    const L yields = idle * select(s.compliance, one(), L{}), rigid = idle * opposite(s.compliance);
    s.tension = select(yields, (one() / s.compliance) * (stage.push ? over : positive(over)), s.tension);
    const V left = nodes[i].x0, right = nodes[i + 1].x0;
    const L rounded = ropes.position.range().epsilon * (root(dot(left, left)) + root(dot(right, right)));
    apart = select(rigid, larger(apart, s.per_length * (over - rounded)), apart);
    for (L* a : {&s.taut, &s.transverse, &s.axial, &s.wished}) *a = select(idle, L{}, *a);
    s.wish = select(idle, nodes[i + 1].w - nodes[i].w, s.wish);
}

// What its length before the step is more than the length that it has now and the tension of the last step explain, but
// for the tolerance, is by how much its rest length fell.
template <int N> void RopeBundle<N>::look_at_winch(size_t i) {
    Spring& s = springs[i];
    const L over = (s.long_before - s.length) - s.compliance * load_tension(i), error = stage.tolerance * s.length;
    s.reeled = select(s.moves, over - smaller(larger(over, L{} - error), error), L{});
}

// What a winch gives beyond tension times what the spring shortens by. The impulse acts along z, and the nodes of a
// spring that turns by an angle a go 1 / cos(a / 2) times as far along z (lambda = 1/2): where the rest length fell, that
// is the winch's work; where it did not, it would be energy from nothing.
template <int N> auto RopeBundle<N>::by_winch(const Spring& s, L stretch, V dw) const -> L {
    const L further = stretch - stage.dt * dot(s.acting, dw);
    return select(L{} - s.reeled * stretch, positive(s.tension * further), L{});
}

// A spring's energy grows by its mean tension times its stretch, but the tension that counts as its work is that at the
// end of the step: half of its stretch's own tension times the stretch is no energy made. Of springs that pull, and that
// were as long as their tension made them: not those that are reeled.
template <int N> auto RopeBundle<N>::by_yielding(const Spring& s, L stretch) -> L {
    const L taken = select(s.compliance, (0.5 * stretch * stretch) / s.compliance, L{});
    return select(size_of(s.reeled), L{}, select(size_of(s.tension), taken, L{}));
}

// ---- the nonlinear system -------------------------------------------------------------------------------------------

// What is seen of both halves of strands, in both lanes; a probe of each error.
template <int N> typename RopeBundle<N>::Seen RopeBundle<N>::of_strands(const Seen& s) const {
    if (!halved) return s;
    return {most(s.error),  sum(s.probe + 0.0 * s.error),
            sum(s.pushed),  sum(s.gained),
            sum(s.worth),   most(s.slack),
            sum(s.lengths), s.rounding};
}

// Linearizes all springs; closes the strands that are solved, and those that have come to what is no number. iteration:
// how many came before. weight: what their tensions times lengths are at least, as errors count.
template <int N> void RopeBundle<N>::linearize_all(L barrier, bool interior, L weight, size_t iteration) {
    Seen seen;
    meet();
    for (size_t i = 0; i < spring_count; ++i) linearize(i, barrier, interior, seen);
    if (is_rod()) look_at_joints(seen);
    if (has_callbacks()) {
        if (iteration == 0) ask_all(true);
        ask_all(false);
    }
    for (size_t i = 0; i < node_count && has_contacts(); ++i) seen.error = larger(seen.error, touch(i, iteration));
    if (iteration > (interior ? 0 : kMostNewton)) // what is left out of the nodes' momentum gives or takes energy
        for (size_t i = 0; i < node_count; ++i)
            seen.gained = seen.gained + size_of(nodes[i].ground * dot(nodes[i].w, nodes[i].next - nodes[i].w));
    seen = of_strands(seen);
    const L worth = larger(seen.worth, larger(weight, least_worth));
    const auto share = [](L wrong, L of) { return select(of, wrong / of, L{}); };
    const L forces = share(larger(seen.pushed, seen.slack * seen.lengths), worth);
    const L energy = share(seen.gained, worth + seen.rounding);
    const L error = larger(seen.error, larger(energy, forces)) + seen.probe;
    reached = select(open, error, reached);
    lengths_right = select(L::splat(stage.tolerance) - larger(seen.error, forces), one(), L{});
    if (has_contacts() && stage.lambda < 1) { // what touches takes lambda = 1
        const L touched = open * select(one() - lambda, touches(), L{});
        failed = failed + touched, open = open - touched;
        reached = select(touched, L::splat(INFINITY), reached);
    }
    if (iteration == 0) return;
    const L solved = select(L::splat(stage.tolerance) - error, one(), L{});
    const L lost = one() - select(L::splat(kMostError) - error, one(), L{});
    failed = failed + open * lost;
    open = open * ((one() - solved) * (one() - lost));
}

// Adds so many times what they have to the nodes' masses, which move as the guess does.
template <int N> void RopeBundle<N>::add_mass(L added) {
    const L share = one() / (one() + added);
    for (size_t i = 0; i < node_count; ++i) {
        Node& n = nodes[i];
        n.b = select(held(i), n.b, share * (n.b + added * n.w));
        n.ground = (one() + added) * n.ground, n.mobility = share * n.mobility;
    }
}

// Newton's method with springs that are slack or taut. Where it goes on for long, with links that push, there is no
// convex function, and it may go to and fro: what is added to the nodes' masses then holds them near the guess, the more
// the less it helped. `next` is what would be right without.
template <int N> void RopeBundle<N>::newton(size_t most) {
    L added{}, before = L::splat(INFINITY);
    for (size_t k = 0;; ++k) {
        as_long = k < kFirstIterations ? kAsLong * stage.tolerance : 0;
        linearize_all(L{}, false, L{}, k);
        if (k == most || !any_positive(open)) return;
        if (k >= kMostNewton)
            added = open * select(reached - before, within(kRise * added, 1, kMostAdded), kFall * added);
        before = reached;
        if (k >= kMostNewton) add_mass(added);
        eliminate_after(k);
        if (k >= kMostNewton) begin_alone();
        iterations = iterations + open;
        if (tells_loads()) take_pushes(open);
        for (size_t i = 0; i < node_count; ++i) {
            Node& n = nodes[i];
            const V next = n.next;
            n.next = next + added * (next - n.w), n.w = select(open, next, n.w);
        }
        for (size_t i = 0; i < spring_count; ++i)
            springs[i].tension = select(open, springs[i].next, springs[i].tension);
    }
}

// The guess that each piece of the rope moves as one: with its momentum, which the iterations keep, or, where it
// hangs on a held node, not at all.
template <int N> void RopeBundle<N>::start_together() {
    const size_t last = node_count - 1;
    const auto joined = [&](size_t i) { return i < last ? springs[i].moves : L{}; }; // to the next node
    L mass{}, hangs{};
    V momentum{};
    for (size_t i = 0; i <= last; ++i) { // of the piece so far
        Node& n = nodes[i];
        mass = mass + n.ground, momentum = momentum + n.ground * n.b, hangs = larger(hangs, held(i));
        if (is_middle(i)) { // and of the other half's
            const L on = springs[i].moves;
            mass = mass + on * pairs_exchanged(mass), momentum = momentum + select(on, pairs_exchanged(momentum), V{});
            hangs = larger(hangs, on * pairs_exchanged(hangs));
        }
        n.next = select(hangs, V{}, (one() / mass) * momentum);
        const L on = joined(i);
        mass = on * mass, momentum = select(on, momentum, V{}), hangs = on * hangs;
    }
    V whole{};
    for (size_t i = node_count; i-- > 0;) {
        whole = select(joined(i), whole, nodes[i].next);
        nodes[i].w = select(open * opposite(held(i)), whole, nodes[i].w);
    }
}

// Of ropes that only pull, a step of lambda = 1 minimizes a convex function: a primal-dual interior point, in which
// T gap = barrier length for every spring, since errors count over lengths, finds it from anywhere.
template <int N> void RopeBundle<N>::interior(size_t most) {
    newtonian = false;
    begin();
    L force{}, mass{}, driven{}, pulled{};
    for (size_t i = 0; i < node_count; ++i) {
        const Node& n = nodes[i];
        driven = driven + select(held(i), root(dot(n.b, n.b)), L{});
        mass = mass + n.ground, force = force + select(held(i), L{}, impulse_on(i));
    }
    for (size_t i = 0; i < spring_count; ++i) {
        const L over = positive(springs[i].long_before - springs[i].length);
        pulled = pulled + select(springs[i].moves, over / give(i), L{});
    }
    const double each = 1 / double(ropes.nodes);
    force = (each / stage.dt) * (sum(force) + (each * sum(mass)) * sum(driven)) + each * sum(pulled);
    // What springs pull with at first: as much as on the nodes, and as joints do. Stiff bent rods that begin with less
    // take no end of iterations.
    const L first = force + (is_rod() ? (each / stage.dt / stage.dt) * bent() : L{});
    start_together();
    L weight{}; // of the nodes, times lengths
    for (size_t i = 0; i < spring_count; ++i) {
        Spring& s = springs[i];
        weight = weight + select(s.moves, force * s.length, L{});
        s.gap = larger(s.length - s.long_before, kFirstGap * s.length);
        s.tension = select(open * s.moves, first, s.tension);
    }
    weight = sum(weight);
    const double share = 1 / double(ropes.nodes - 1);
    L went = one(), highest{}; // the part of its way that the iteration before went; the barrier to begin with
    for (size_t k = 0;; ++k) {
        L inside{}; // the sum of tensions times gaps over lengths
        for (size_t i = 0; i < spring_count; ++i)
            inside =
                inside + select(springs[i].moves, springs[i].per_length * (springs[i].tension * springs[i].gap), L{});
        const double rise = k < kRises || has_contacts() ? 1 / kBarrierFall : 1;
        const L falls = select(went - L::splat(kStuck), L::splat(kBarrierFall), L::splat(rise));
        const L wanted = share * falls * sum(inside);
        if (k == 0) highest = wanted;
        const L barrier = smaller(wanted, highest); // what rises without a bound takes nodes out of all numbers
        linearize_all(barrier, true, weight, k);
        if (k == most || !any_positive(open)) return;
        eliminate_after(k);
        iterations = iterations + open;
        went = step_inside(barrier);
    }
}

// Goes the part of an iteration's way that leaves all tensions and gaps positive, and tells it.
template <int N> auto RopeBundle<N>::step_inside(L barrier) -> L {
    L part = one();
    for (size_t i = 0; i < spring_count; ++i) {
        const Spring& s = springs[i];
        const L change = select(s.moves, s.next - s.tension, L{});
        const L fall = select(s.moves, (barrier * s.length - s.gap * s.next) / s.tension, L{});
        part = select(L{} - change, smaller(part, kInside * (s.tension / (L{} - change))), part);
        part = select(L{} - fall, smaller(part, kInside * (s.gap / (L{} - fall))), part);
    }
    part = open * (L{} - most(L{} - part));
    for (size_t i = 0; i < spring_count; ++i) {
        Spring& s = springs[i];
        const L fall = (barrier * s.length - s.gap * s.next) / s.tension, on = open * s.moves;
        s.tension = select(on, s.tension + part * (s.next - s.tension), s.tension);
        s.gap = select(on, s.gap + part * fall, s.gap);
    }
    for (size_t i = 0; i < node_count; ++i)
        nodes[i].w = select(open, nodes[i].w + part * (nodes[i].next - nodes[i].w), nodes[i].w);
    if (tells_loads()) take_pushes(part);
    return part;
}

// ---- the end of a step ----------------------------------------------------------------------------------------------

template <int N> void RopeBundle<N>::solve() {
    lambda = L::splat(stage.lambda);
    open = one();
    prepare();
    // Links that push have no safer step: there Newton's method goes on.
    const size_t last = kMostNewton + (stage.push ? stage.most_iterations : 0);
    begin();
    newton(stage.lambda < 1 ? kMostNewton : last);
    if (!try_again()) return;
    if (stage.lambda < 1) {
        lambda = select(open, one(), lambda);
        begin();
        newton(last);
        if (!try_again()) return;
    }
    if (!stage.push) {
        interior(stage.most_iterations);
        if (!try_again()) return;
    }
    calm();
}
// Opens the strands that failed, and remembers what they reached; whether there is any to go on with.
template <int N> bool RopeBundle<N>::try_again() {
    open = larger(open, failed);
    failed = L{};
    if (!any_positive(open)) return false;
    const L better = best - reached;
    for (size_t i = 0; i < node_count; ++i) nodes[i].best = select(better, nodes[i].w, nodes[i].best);
    for (size_t i = 0; i < spring_count; ++i) springs[i].best = select(better, springs[i].tension, springs[i].best);
    best_lambda = select(better, lambda, best_lambda);
    best = select(better, reached, best);
    return true;
}

// What could not be solved takes the best that was found; its nodes move with no more energy than they would alone.
template <int N> void RopeBundle<N>::calm() {
    const L known = open * select(L::splat(kMostError) - best, one(), L{});
    for (size_t i = 0; i < node_count; ++i) nodes[i].w = select(known, nodes[i].best, nodes[i].w);
    for (size_t i = 0; i < spring_count; ++i) springs[i].tension = select(known, springs[i].best, springs[i].tension);
    lambda = select(known, best_lambda, lambda);
    reached = select(open, best, reached); // INFINITY where no error was a number
    begin_alone();
    const auto ends = [&](size_t i, V w) { // the velocity after the step
        const V v = nodes[i].v0;
        return v + per_lambda * (w - v);
    };
    L as_solved{}, by_themselves{};
    for (size_t i = 0; i < node_count; ++i) {
        const Node& n = nodes[i];
        const V together = select(held(i), V{}, ends(i, n.w)), by_itself = select(held(i), V{}, ends(i, n.b));
        as_solved = as_solved + n.ground * dot(together, together);
        by_themselves = by_themselves + n.ground * dot(by_itself, by_itself);
    }
    const L part = smaller(positive(root(sum(by_themselves) / sum(as_solved))), one()); // 0 if something is no number
    for (size_t i = 0; i < node_count; ++i) {
        Node& n = nodes[i];
        const V v = n.v0, less = v + lambda * (part * ends(i, n.w) - v);
        const L keeps = part * opposite(held(i)); // held nodes move as they are told, whatever went wrong
        n.w = select(open, select(keeps, select(one() - part, less, n.w), n.b), n.w);
    }
    // No tension is more than all that springs did to the nodes' momentum; those of another motion mean nothing.
    L done{};
    for (size_t i = 0; i < node_count; ++i) {
        const V by_springs = nodes[i].ground * (nodes[i].w - nodes[i].b);
        done = done + root(dot(by_springs, by_springs));
    }
    const L most = select(one() - part, L{}, (1 / stage.dt) * (per_lambda * sum(done)));
    for (size_t i = 0; i < spring_count; ++i) {
        L& t = springs[i].tension;
        t = select(open, larger(smaller(t, most), L{} - most), t);
    }
    meet();
    Seen seen;
    for (size_t i = 0; i < spring_count; ++i) linearize(i, L{}, false, seen); // for settle()
    if (has_callbacks()) ask_all(false);
    for (size_t at = 0; at < node_count * stage.collider_count && has_contacts(); ++at) { // for forget_overlaps()
        const size_t i = at / stage.collider_count;
        const V before = nodes[i].x0;
        Contact& c = contacts[at];
        look_at_end(at % stage.collider_count, i, before, before + L::splat(stage.dt) * nodes[i].w, c);
        // Pushes of another motion mean nothing, and what is still inside came out by no more than it went.
        const L went = stage.dt * dot(c.normal, nodes[i].w),
                came_out = smaller(positive(went), positive(L{} - c.before));
        c.before = select(open, L{} - came_out, c.before);
        c.on = select(open, select(came_out, one(), L{}), c.on), c.push = select(open, L{}, c.push);
    }
}

// Velocities along springs that are taut become those with which they lengthened in the step beyond its tolerance, or,
// where they were slack before it and none of these follow, with which they are reeled in; momentum stays. Without it
// what a step of lambda < 1 does along stiff springs alternates from step to step. Halves go to the middle spring, whose
// tension both have. Gives the energy that this makes beyond what springs that were slack took and do not hold, 0 where
// none was; what moves of held nodes do is no part of it.
template <int N> auto RopeBundle<N>::settle(L follows) -> L {
    const L rate = L::splat(1 / stage.dt / stage.dt), none{};
    const L unsettled = select(one() - lambda, one(), none);
    L before_pivot = one(), before_rest{}, left = alone(0), made{}, catches{};
    for (size_t i = 0; i < spring_count; ++i) {
        Spring& s = springs[i];
        const L right = alone(i + 1);
        const L own = (1 + kSettleSoftly) * (left + right) + s.compliance * rate;
        const L pulls = stage.push ? size_of(s.tension) : s.tension;
        s.taut = (s.moves * unsettled) * select(pulls, select(own, one(), none), none);
        const L lengthened = long_after(i) - s.long_before;
        // What yields was taut if it was long, whatever tension a state tells that was written since.
        const L before = select(s.compliance, s.long_before - s.length, load_tension(i));
        const L was = stage.push ? size_of(before) : before;
        const L caught = select(was, none, s.moves * positive(s.tension));
        const L lost = caught * positive(lengthened - (0.5 * s.compliance) * caught);
        made = made - select(caught, is_middle(i) ? 0.5 * lost : lost, none);
        catches = catches + caught;
        const L moved = select(larger(was, follows), lengthened, none - positive(s.reeled));
        const L error = (2 * stage.tolerance) * s.length; // what two lengths that are right may differ by
        const L wanted = (1 / stage.dt) * (moved - smaller(larger(moved, none - error), error));
        s.wished = select(s.taut, dot(s.along, nodes[i + 1].next - nodes[i].next) - wanted, none);
        const L both = i == 0 ? none : s.taut * springs[i - 1].taut;
        s.axial = i == 0 ? none : select(both, none - left * dot(springs[i - 1].along, s.along), none);
        const L share = s.axial / before_pivot;
        L softer = share * s.axial, moved_by = share * before_rest;
        if (is_middle(i)) softer = sum(softer), moved_by = sum(moved_by);
        s.transverse = select(s.taut, own - softer, one());
        s.wished = select(s.taut, s.wished - moved_by, none);
        before_pivot = s.transverse, before_rest = s.wished;
        left = right;
    }
    L after{}, right = alone(spring_count);
    for (size_t i = spring_count; i-- > 0;) {
        Spring& s = springs[i];
        const L coupling = i + 1 < spring_count ? springs[i + 1].axial : none;
        after = (s.wished - coupling * after) / s.transverse;
        s.gap = select(s.compliance, none, (1 / stage.dt) * after); // what yields has its tension by its stretch
        const V along = select(s.taut, s.along, V{});
        left = alone(i);
        const L work = after * (dot(along, nodes[i].next - nodes[i + 1].next) + 0.5 * ((left + right) * after));
        made = made + (is_middle(i) ? 0.5 * work : work);
        nodes[i].next = nodes[i].next + (left * after) * along;
        nodes[i + 1].next = nodes[i + 1].next - (right * after) * along;
        right = left;
    }
    return select(sum(catches), sum(made), none);
}

template <int N> void RopeBundle<N>::take_velocities() {
    for (size_t i = 0; i < node_count; ++i) {
        Node& n = nodes[i];
        n.y = n.x0 + L::splat(stage.dt) * n.w;
        n.next = n.v0 + (one() / lambda) * (n.w - n.v0);
    }
    meet();
}

template <int N> RopeResult RopeBundle<N>::step() {
    solve();
    RopeResult result;
    L bad{};
    take_velocities();
    if (stage.lambda < 1) { // what is caught while it is paid out follows the winch, unless that makes energy
        const L follows = opposite(settle(one()));
        if (any_positive(one() - follows)) take_velocities(), settle(follows);
    }
    if (has_contacts()) forget_overlaps();
    if (tells_loads()) tell_loads();
    const L to_overflow = L::splat(ropes.position.range().to_overflow);
    const auto look_at = [&](L a) { bad = bad + 0.0 * (to_overflow * a); };
    for (size_t i = 0; i < node_count; ++i) {
        Node& n = nodes[i];
        if (any_positive(held(i))) n.next = select(held(i), n.v0, n.next);
        look_at(n.y.x), look_at(n.y.y), look_at(n.y.z);
        look_at(n.next.x), look_at(n.next.y), look_at(n.next.z);
        store(n.y, ropes.position, i);
        store(n.next, ropes.velocity, i);
    }
    const L solved = stage.lambda < 1 ? L::splat(stage.tolerance) - reached : L{};
    for (size_t i = 0; i < spring_count; ++i) {
        const Spring& s = springs[i];
        // Of the interior point all springs have a tension: slack are those that it would not take to their length.
        const L slack = s.length - give(i) * s.tension - long_after(i);
        const L tension = s.tension + select(solved, s.gap, L{}); // with what it did as velocities settled
        double lane[N];
        (stage.push ? tension : select(slack, L{}, positive(tension))).store(lane);
        for (int j = 0; j < N && is_used(j); ++j)
            if (has_spring(i, j)) ropes.tension[tension_place(i, j)] = isfinite(lane[j]) ? lane[j] : 0;
    }
    double taken[N];
    iterations.store(taken);
    for (int j = 0; j < N && is_used(j); ++j) ropes.taken[strands[j]] = taken[j];
    result.finite = !bad.any_nan();
    result.error = largest_in(larger(reached, apart));
    result.iterations = size_t(largest_in(iterations));
    result.bad = bad_answer;
    return result;
}

template <int N> static RopeResult step_bundle(const Ropes& ropes, const RopeParameters& c, const RopeStage& stage,
                                               double* scratch, const size_t* strands, size_t count) {
    using Here = RopeBundle<N>;
    const size_t room = rope_lane_room(ropes.nodes, stage.has_halves()),
                 of_strand = stage.has_halves() ? 2 : 1; // lanes
    static_assert(sizeof(typename Here::Node) + sizeof(typename Here::Spring) == kRopeScratch * N * sizeof(double));
    auto* const nodes = reinterpret_cast<typename Here::Node*>(scratch);
    auto* const springs = reinterpret_cast<typename Here::Spring*>(nodes + room);
    static_assert(sizeof(typename Here::InAir) == kAirScratch * N * sizeof(double));
    auto* const in_air = reinterpret_cast<typename Here::InAir*>(springs + room);
    static_assert(sizeof(typename Here::Contact) == kContactScratch * N * sizeof(double));
    auto* const contacts = reinterpret_cast<typename Here::Contact*>(in_air + (stage.has_air() ? room : 0));
    const size_t contact_count = room * stage.collider_count;
    static_assert(sizeof(typename Here::Answer) == kAnswerScratch * N * sizeof(double));
    auto* const answers = reinterpret_cast<typename Here::Answer*>(contacts + contact_count);
    static_assert(sizeof(typename Here::Joint) == kJointScratch * N * sizeof(double));
    auto* const joints = reinterpret_cast<typename Here::Joint*>(answers + room * stage.callback_count);
    static_assert(2 * sizeof(typename Here::V) == kPushNumbers * N * sizeof(double));
    auto* const vectors = reinterpret_cast<typename Here::V*>(joints + (stage.bends ? room : 0));
    auto* const pushes = ropes.loads ? vectors : nullptr;
    auto* const by_link = vectors + (pushes ? 2 * contact_count : 0);
    const size_t link_count = stage.bends ? 3 * (contact_count + (stage.has_air() ? room : 0)) : 0;
    auto* const question = reinterpret_cast<double*>(by_link + link_count);
    size_t lanes[N];
    for (size_t j = 0; j < N; ++j) lanes[j] = strands[j / of_strand < count ? j / of_strand : count - 1];
    Here bundle{ropes,   c,      stage,    nodes, springs, in_air, contacts, joints, by_link,
                answers, pushes, question, lanes, count,   {},     {},       {}};
    return bundle.step();
}

#ifdef CD_ISA_IS_PLAIN
constexpr auto step_alone = step_bundle<kLanesAlone>;
#else
constexpr auto step_alone = plain::rope_step;
#endif

RopeResult rope_step(const Ropes& ropes, const RopeParameters& c, const RopeStage& stage, double* scratch,
                     const size_t* strands, size_t count) {
    RopeResult result;
    const size_t most = size_t(stage.has_halves() ? kNative / 2 : kNative); // strands of a bundle
    while (count > 0) {
        const size_t now = count < most ? count : most;
        result.add(now == 1 ? step_alone(ropes, c, stage, scratch, strands, 1)
                            : step_bundle<kNative>(ropes, c, stage, scratch, strands, now));
        strands += now;
        count -= now;
    }
    return result;
}

} // namespace CD_ISA
} // namespace cd
