// What nodes of ropes touch. A node that would be inside a collider at the end of the step is kept out by an impulse
// that only pushes, and friction resists its motion along the surface. Both are stiff resistances within the
// elimination, as the air's are; which nodes touch, and how friction depends on push and speed, the iterations find.
// (model.md, 27)
//
// The push acts along the normal n0 that the collider has where the step finds the node. From there all of a convex
// body lies behind n0, so that n0 . (x1 - x0) <= 0: what does not move takes energy and gives none. Along the normal n1
// at the end of the step, which tells what keeps the node out, it would give some wherever a node slides round a body.
//
// Friction is f = -mu p s / (|s| + e), of the push p and the slip s, the velocity along the surface. Newton's method
// takes it as f (|s| + e) = -mu p s, with all derivatives, about the slip of the guess and the friction that the last
// elimination had, which is near what it has to be where its slip is not: for the law alone is flat beyond e and steep
// below, and with its derivative the slip goes to and fro. The interior point, whose steps are parts of steps, takes it
// as a resistance mu p / (|s| + e) by the guess, which needs more iterations and no luck.
#pragma once

#include "kernel/rope_air.hh"

namespace cd {
namespace CD_ISA {

// How stiff contacts are, over the mass of the strand: the push that is known already makes up for the rest.
constexpr double kContactStiffness = 1e4;
// At the speed v friction is that of Coulomb times v / (v + this) [m/s]: e above.
constexpr double kStickSpeed = 1e-4;
// How far friction may be off, over mu p; from this iteration of the interior point on p is the push found by then.
constexpr double kFrictionError = 1e-2;
constexpr size_t kGripIterations = 50;
// How near a node is to what it touches by the first guess, over the springs' length, or nearer by the tolerance:
// pushes that two colliders further apart would have against each other throw it from where it lies.
constexpr double kNear = 1e-3;
// Of a place x and a collider at this time: the way out of it, and how far outside x lies.
template <int N> void RopeBundle<N>::look_at_gap(const Obstacle& to, V x, double time, V& normal, L& gap) const {
    if (to.shape == CD_SHAPE_BED) return look_at_bed(to, x, time, normal, gap);
    const auto at = [&](int k) { return L::splat(to.place(k, time)); };
    const V way{L::splat(to.way[0]), L::splat(to.way[1]), L::splat(to.way[2])}, from = x - V{at(0), at(1), at(2)};
    const L radius = L::splat(to.radius);
    if (to.shape == CD_SHAPE_PLANE) {
        normal = way, gap = dot(way, from) - radius;
        return;
    }
    const double square = (to.way[0] * to.way[0] + to.way[1] * to.way[1]) + to.way[2] * to.way[2];
    const L along = square > 0 ? smaller(positive((1 / square) * dot(way, from)), one()) : L{};
    const V off = from - along * way;
    const L distance = root(dot(off, off));
    const L off_line = distance - kNoDirection * radius;
    normal = (one() / distance) * off, gap = distance - radius;
    if (off_line.all_positive()) return;
    double out[3] = {};
    way_off_line(to.way, ropes.components, out);
    normal = select(off_line, normal, V{L::splat(out[0]), L::splat(out[1]), L::splat(out[2])});
}

template <int N> void RopeBundle<N>::look_at_bed(const Obstacle& to, V x, double time, V& normal, L& gap) const {
    double place[3][N], out[3][N], gaps[N];
    x.x.store(place[0]), x.y.store(place[1]), x.z.store(place[2]);
    for (int j = 0; j < N; ++j) {
        const double at[3] = {place[0][j], place[1][j], place[2][j]};
        double way[3];
        gaps[j] = gap_to_bed(to, at, time, way);
        for (int k = 0; k < 3; ++k) out[k][j] = way[k];
    }
    normal = {L::load(out[0]), L::load(out[1]), L::load(out[2])}, gap = L::load(gaps);
}

// Asks all callbacks about the nodes of the strands that are open, one strand after the other: where the step begins,
// for their contacts, or where the guess ends.
template <int N> void RopeBundle<N>::ask_all(bool at_start) {
    const size_t n = ropes.nodes, components = ropes.components;
    double is_open[N];
    open.store(is_open);
    double *const places = question, *const gaps = places + 3 * count * n, *const normals = gaps + count * n;
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const Obstacle& to = stage.colliders[k];
        if (!to.callback) continue;
        const auto place_of = [&](size_t i, int j) { // of a lane's node in the strands that are asked about
            return (is_used(j) ? slot_of(j) : count - 1) * n + node_at(i, j);
        };
        for (size_t i = 0; i < node_count; ++i) {
            const V before = nodes[i].x0, x = at_start ? before : before + L::splat(stage.dt) * nodes[i].w;
            double lane[3][N];
            x.x.store(lane[0]), x.y.store(lane[1]), x.z.store(lane[2]);
            for (int j = 0; j < N; ++j)
                for (size_t c = 0; c < components && has_node(i, j); ++c)
                    places[place_of(i, j) * components + c] = lane[c][j];
        }
        for (int j = 0; j < N && is_used(j); ++j) {
            const size_t at = slot_of(j) * n;
            if (is_open[j] > 0 && !(halved && comes_back[j]))
                ask(to, at_start ? stage.time_before : stage.time_after, n, components, places + at * components,
                    gaps + at, normals + at * components, bad_answer);
        }
        for (size_t i = 0; i < node_count; ++i) {
            double lane[4][N] = {};
            for (int j = 0; j < N; ++j) {
                lane[0][j] = 1; // a way, where nothing is asked
                if (!(is_open[j] > 0) || !has_node(i, j)) continue;
                const size_t at = place_of(i, j);
                for (size_t c = 0; c < components; ++c) lane[c][j] = normals[at * components + c];
                lane[3][j] = gaps[at];
            }
            const V normal{L::load(lane[0]), L::load(lane[1]), L::load(lane[2])};
            Answer& told = answers[to.question * node_count + i];
            Contact& contact = contacts[i * stage.collider_count + k];
            V& out = at_start ? contact.acting : told.normal;
            L& gap = at_start ? contact.before : told.gap;
            out = select(open, normal, out), gap = select(open, L::load(lane[3]), gap);
        }
    }
}

// Looks at collider k where the guess ends.
//
// Pushes along n0 give energy where a node gets in front of n0's plane, as it would have to in a hollow whose surface
// rises before it. So no node has to come further out than to that plane, and the next step takes it out of what it
// went into. Behind it lies all that is convex: a callback's ball or box is met at its surface. Beds are met at the
// plane alone: where their slope turns often, what keeps to both finds no end.
template <int N> void RopeBundle<N>::look_at_end(size_t k, size_t i, V before, V x, Contact& c) const {
    const Obstacle& to = stage.colliders[k];
    if (to.is_convex()) return look_at_gap(to, x, stage.time_after, c.normal, c.gap);
    const L plane = c.before + dot(c.acting, (x - before) - L::splat(stage.dt) * velocity_of(to));
    c.normal = c.acting, c.gap = plane;
    if (!to.callback) return;
    const Answer& told = answers[to.question * node_count + i];
    const L outside = plane - told.gap;
    c.normal = select(outside, c.normal, told.normal), c.gap = select(outside, plane, told.gap);
}

// The longer of the springs at node i, by which the tolerance is counted.
template <int N> Lanes<N> RopeBundle<N>::length_at(size_t i) const {
    const L left = i > 0 ? springs[i - 1].length : L{}, right = i < spring_count ? springs[i].length : L{};
    return larger(left, right);
}

// The speed at which node i would leave the collider, if nothing but the guess's gap made it.
template <int N> Lanes<N> RopeBundle<N>::leaving(size_t i, const Contact& c) const {
    return dot(c.normal, nodes[i].w) - (1 / stage.dt) * c.gap;
}

// The velocity of node i along the surface, by the guess.
template <int N> Vector<N> RopeBundle<N>::slip_at(const Collider& to, size_t i, const Contact& c) const {
    const V u = nodes[i].w - velocity_of(to);
    return u - dot(c.normal, u) * c.normal;
}

// Friction over the largest that it may be, at this slip.
template <int N> Lanes<N> share_by_law(Vector<N> slip) {
    const Lanes<N> speed = root(dot(slip, slip));
    return speed / (speed + Lanes<N>::splat(kStickSpeed));
}

// The normal, the way of the slip and what is across both.
template <int N> typename RopeBundle<N>::Axes RopeBundle<N>::surface_axes(V normal, V slip) {
    const L speed = root(dot(slip, slip));
    const L slips = speed - L::splat(kNoDirection * kStickSpeed);
    V side = (one() / speed) * slip;
    if (!slips.all_positive()) side = select(slips, side, axes(normal).side);
    return {normal, side, cross(normal, side)};
}

// Looks at what node i touches by the guess; tells its error, 1 where other contacts or frictions are to be solved for.
// iteration: how many came before, 0 where nothing has been solved yet.
template <int N> Lanes<N> RopeBundle<N>::touch(size_t i, size_t iteration) {
    const V before = nodes[i].x0, x = before + L::splat(stage.dt) * nodes[i].w;
    const double at_first = stage.tolerance < kNear ? stage.tolerance : kNear;
    const L length = length_at(i), room = stage.tolerance * length, near = at_first * length;
    const L free = opposite(held(i));
    L error{};
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const Obstacle& to = stage.colliders[k];
        const size_t at = i * stage.collider_count + k;
        Contact& c = contacts[at];
        if (iteration == 0) {
            if (pushes) pushes[2 * at] = select(open, V{}, pushes[2 * at]);
            if (!to.callback) look_at_gap(to, before, stage.time_before, c.acting, c.before);
            look_at_end(k, i, before, x, c);
            const L alone = nodes[i].ground * positive(leaving(i, c) - dot(c.normal, nodes[i].b));
            c.on = select(open, free * select(near - c.gap, one(), L{}), c.on);
            c.grip = c.push = select(open, c.on * alone, c.push);
            c.slip = select(open, slip_at(to, i, c), c.slip);
            c.had = select(open, share_by_law(c.slip), c.had);
            c.follows = c.along = c.wished = c.across = L{};
            c.side = V{};
            continue;
        }
        look_at_end(k, i, before, x, c);
        const L was = c.on, inside = free * select(room + c.gap, L{}, one()); // deeper than the tolerance
        // How far it is inside, or off the surface where it is pushed.
        const L off = select(free, select(was, size_of(c.gap), positive(L{} - c.gap)), L{});
        if (!any_positive(larger(off, larger(was, inside)))) continue; // if off is no number, the others count
        c.on = select(open, larger(was * select(c.push, one(), L{}), inside), c.on);
        c.push = select(open, was * c.push, c.push);
        c.grip = newtonian || iteration < kGripIterations ? c.push : was * c.grip;
        const L changed = larger(inside * opposite(was), was * opposite(c.on));
        const V slip = slip_at(to, i, c), side = c.side;
        const L most = to.friction * positive(c.grip), along = dot(side, slip);
        const L solved_for = c.follows * c.push + c.along * (along - c.wished);
        const L speed = root(dot(slip, slip)), law = share_by_law(slip);
        const V had = solved_for * side + c.across * (slip - along * side);
        const V wrong = (most / (speed + L::splat(kStickSpeed))) * slip - had;
        const L other = c.on * select(root(dot(wrong, wrong)) - kFrictionError * most, one(), L{});
        const L share = smaller(positive(dot(had, slip) / (speed * most)), one());
        c.had = select(open, select(was * (speed * most), share, law), c.had);
        c.slip = select(open, slip, c.slip);
        error = larger(error, larger(larger(changed, other), off / length));
    }
    return error;
}

// 1 for the strands that touch something.
template <int N> Lanes<N> RopeBundle<N>::touches() const {
    L any{};
    for (size_t k = 0; k < node_count * stage.collider_count; ++k) any = larger(any, contacts[k].on);
    return most(any);
}

// Keeps node i out of what it touches.
template <int N> void RopeBundle<N>::press(size_t i, Hung& hung) {
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const size_t at = i * stage.collider_count + k;
        Contact& c = contacts[at];
        if (!any_positive(c.on)) continue;
        V* const links = links_of_contact(at);
        const Axes to = surface_axes(c.normal, c.slip);
        c.side = to.side;
        set_friction(stage.colliders[k].friction, dot(to.side, c.slip), c);
        const V u = velocity_of(stage.colliders[k]);
        // A strand that is held altogether has no mass, and touches nothing.
        const L stiffness = kContactStiffness * heavy, out = leaving(i, c) + select(c.on, c.push / stiffness, L{});
        resist(c.on * stiffness, to.way, c.acting - c.follows * to.side, out * to.way, hung, c.pressed, links);
        resist(c.along, to.side, to.side, u + c.wished * to.side, hung, c.rubbed[0], links + 1);
        resist(c.across, to.normal, to.normal, u, hung, c.rubbed[1], links + 2);
    }
}
// Linearizes friction about a slip of this size.
template <int N> void RopeBundle<N>::set_friction(double friction, L slip, Contact& c) const {
    const L sticks = L::splat(kStickSpeed), speed = slip + sticks;
    c.across = c.along = (friction * c.on) * positive(c.grip) / speed;
    c.follows = c.wished = L{};
    if (newtonian) c.along = c.along * (one() - c.had), c.follows = friction * slip / speed, c.wished = slip;
}
// What is left of the impulses from the right, at node i.
template <int N> void RopeBundle<N>::pressed(size_t i, Impulses& left) {
    for (size_t k = stage.collider_count; k-- > 0;) {
        const size_t at = i * stage.collider_count + k;
        Contact& c = contacts[at];
        const V before = left.phi;
        if (any_positive(c.on)) {
            const V* const links = links_of_contact(at);
            left.phi = left.phi + impulse_of(c.rubbed[1], links + 2, left) * cross(c.normal, c.side);
            left.phi = left.phi + impulse_of(c.rubbed[0], links + 1, left) * c.side;
            const L push = c.on * impulse_of(c.pressed, links, left);
            c.push = select(open, push, c.push);
            left.phi = left.phi + push * (c.acting - c.follows * c.side);
        }
        if (pushes) pushes[2 * at + 1] = left.phi - before;
    }
}

// The velocity that node i came out of all colliders with: the least that takes it out of each and into none, to what
// errors of length within the tolerance are worth. Colliders that it left by one way have that together.
template <int N> Vector<N> RopeBundle<N>::velocity_out(size_t i) const {
    const Contact* const at = contacts + i * stage.collider_count;
    L touched{};
    V by_one{};
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const L speed = (-1 / stage.dt) * at[k].before;
        touched = touched + at[k].on, by_one = select(at[k].on * positive(speed), speed * at[k].normal, by_one);
    }
    if (!any_positive(touched - one())) return by_one;
    double error[N], out[3][N];
    ((stage.tolerance / stage.dt) * length_at(i)).store(error);
    const auto first = [](const auto& numbers) { return reinterpret_cast<const double*>(&numbers); };
    least_ways_out({first(at->normal), first(at->before), first(at->on), error, sizeof(Contact) / sizeof(double), N,
                    stage.collider_count, 1 / stage.dt},
                   out[0]);
    return {L::load(out[0]), L::load(out[1]), L::load(out[2])};
}

// What lay inside a collider before the step comes out of it, but is not thrown: it forgets the speed that it came out
// with. So does its strand what it was dragged along with: all nodes slow down in proportion. They lose what energy the
// pushes gave by taking nodes out, less what the time step dissipated and the nodes forgot, but no more than the strand
// has beyond what its nodes would have alone.
template <int N> void RopeBundle<N>::forget_overlaps() {
    L given{}, left{}, alone{}; // twice the energies; given: less what the nodes had before they forgot
    for (size_t i = 0; i < node_count; ++i) {
        Node& n = nodes[i];
        const L mass = select(held(i), L{}, n.mass);
        const V change = n.next - n.v0;
        given = given - mass * (dot(change, change) + dot(n.next, n.next));
        for (size_t k = 0; k < stage.collider_count; ++k) {
            const Contact& c = contacts[i * stage.collider_count + k];
            const L inside = c.on * positive(L{} - c.before);
            const L out = positive(dot(c.acting, n.w - velocity_of(stage.colliders[k])));
            given = given + select(inside, (2 * c.push) * out, L{});
        }
        n.next = n.next - velocity_out(i);
        left = left + mass * dot(n.next, n.next), alone = alone + mass * dot(n.b, n.b);
    }
    left = sum(left);
    const L lost = positive(smaller(left + sum(given), left - sum(alone))) / left;
    if (!any_positive(lost)) return;
    const L keeps = select(lost, root(positive(one() - lost)), one());
    for (size_t i = 0; i < node_count; ++i) nodes[i].next = keeps * nodes[i].next;
}

// Goes a part of the way from the pushes of the guess to those of the last elimination, as the nodes do.
template <int N> void RopeBundle<N>::take_pushes(L part) const {
    for (size_t at = 0; at < node_count * stage.collider_count; ++at) {
        V& impulse = pushes[2 * at];
        impulse = select(part, impulse + part * (pushes[2 * at + 1] - impulse), impulse);
    }
}

// Tells what the nodes did to each collider, in the mean over the step. Of a step that was not solved nothing is known.
template <int N> void RopeBundle<N>::tell_loads() const {
    const size_t of_strand = halved ? 2 : 1;
    double per_impulse[N];
    select(open, L{}, L::splat(1 / stage.dt) * per_lambda).store(per_impulse);
    for (size_t j = 0; j < count * of_strand; j += of_strand) {
        const auto lane = [&](const auto& numbers) { return reinterpret_cast<const double*>(&numbers) + j; };
        const PushedStrand strand{lane(nodes->mass),
                                  lane(nodes->mobility),
                                  lane(nodes->w),
                                  lane(nodes->next),
                                  lane(nodes->y),
                                  lane(contacts->normal),
                                  lane(contacts->before),
                                  lane(contacts->on),
                                  lane(*pushes),
                                  sizeof(Node) / sizeof(double),
                                  sizeof(Contact) / sizeof(double),
                                  N,
                                  of_strand,
                                  node_count,
                                  stage.collider_count,
                                  per_impulse[j],
                                  1 / stage.dt};
        add_loads(strand, stage.colliders, ropes.loads + strands[j] * ropes.collider_count * kLoadNumbers);
    }
}

} // namespace CD_ISA
} // namespace cd
