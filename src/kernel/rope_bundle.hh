// A bundle of strands, and one Newton iteration for it: springs are linearized about a guess, and one elimination along
// the strand solves the linear system. With C the mobility of all that hangs on the left of a node (velocity per
// impulse) and y where that would go by itself, a spring passes both on: see rope_elimination.hh, and rope_rod.hh where
// the rope bends. What is done with iterations is in rope_step.cpp.
#pragma once

#include <math.h>

#include <initializer_list>

#include "base/node.hh"
#include "kernel/lines.hh"
#include "kernel/rope_step.hh"
#include "kernel/vectors.hh"

namespace cd {
namespace CD_ISA {

// A spring shorter than this, over its rest length, has no direction of its own.
constexpr double kNoDirection = 1e-12;
constexpr double kMostCompliance = 0x1.fffffffffffffp1023; // of what is not cut

// Tensions this small, over the mean force on the nodes, are rounding.
constexpr double kRounding = 1e-14;

// N strands.
template <int N> struct RopeBundle {
    using L = Lanes<N>;
    using V = Vector<N>;
    using M = Matrix<N>;

    // What hangs on the left of a node: y + c phi is the node's velocity under the impulse phi. Of a rod, phi acts on
    // the node and psi on its link, the spring on its left: the node's velocity is y + c phi + across psi, and that of
    // the link, the difference of its nodes', is link_y + back phi + link psi.
    struct Hung {
        M c;
        V y;
        M across, back, link;
        V link_y;
    };
    struct Impulses {
        V phi, psi;
    };
    // An impulse of what resists: wished - by . phi, and of a rod less by_link . psi.
    struct Resisted {
        L wished;
        V by;
    };
    struct Node {
        L ground, mobility; // and 1 / ground, of what is held 0
        V b, w, next, best; // next: what the last elimination gave; best: w of the least error
        V y;
        M c;
    };
    // Of a node in air: the rope's way, and what the air does along it, and across.
    struct InAir {
        V way;
        Resisted along, side, normal;
    };
    // Of a node and a collider: see rope_contact.hh.
    struct Contact {
        V acting, normal; // n0 and n1
        V slip;           // the velocity along the surface about which friction is linearized
        L before, gap;    // how far outside it is when the step begins, and by the guess when it ends [m]
        L on, push;       // 1 where it touches; the impulse that keeps it out
        L grip;           // the push that friction is of
        // Friction, linearized: against the slip as much per push, and a resistance [kg] to what is not a wished speed;
        // across the slip a resistance.
        L follows, along, wished, across;
        Resisted pressed, rubbed[2];
    };
    // Of a rod's node i, its link, and the joint at the node before.
    struct Joint {
        L stiffness, ratio; // of the joint, per velocity; rest length of the link over that of the one before
        M stiff, reach;     // the joint's impulse is wished - stiff (phi / m + reach psi)
        V wished, impulse;  // impulse: of the last elimination
        M across;
        Resisted pulled[4]; // by the link: its transverse stiffness along x, y, z, and along itself
        V by_link[4];
    };
    // What a callback tells of a node: the way out, and how far outside it is where the guess ends.
    struct Answer {
        V normal;
        L gap;
    };
    // Of spring i from node i to node i + 1.
    struct Spring {
        L length, per_length, compliance;
        L moves;                   // 1 where a node moves by it: not where it is cut or joins two held nodes
        V before;                  // D0
        V along, acting;           // unit vectors along D1 and z
        V wish;                    // e, what dw would be if the spring had its length
        L wished;                  // along . e
        L taut, transverse, axial; // 1 or 0; s and the axial compliance, of impulses
        L tension, next, best;
        L pushed;           // the tension that would be below 0
        V impulse;          // phi of the last elimination
        L long_before, gap; // |D0|, and of the interior point what is left to L
    };

    const Ropes& ropes;
    const RopeParameters& c;
    const RopeStage& stage;
    Node* const nodes;
    Spring* const springs;
    InAir* const in_air;         // if there is air
    Contact* const contacts;     // of node after node, with each collider
    Joint* const joints;         // of rods
    V* const by_link;            // of rods: three of each node for the air, then three of each contact
    Answer* const answers;       // of callback after callback, for each node
    double* const question;      // room for places of nodes and what is told of them
    const size_t* const strands; // of its lanes; those beyond the last are the last one again
    size_t count;                // of strands
    L lambda, per_lambda, open;  // open: 1 where a strand is still to be solved
    L iterations{}, reached{}, failed{};
    L best = L::splat(INFINITY), best_lambda{}; // the least error that was reached, and its lambda
    L heavy{};                                  // the mass of the strand, if it may touch something
    bool newtonian = true;                      // while Newton's method is at work
    L apart{};                                  // the error of springs between held nodes
    L least_worth{};                            // what tensions times lengths are at least, as errors count
    BadAnswer bad_answer{};

    static L one() { return L::splat(1); }
    // 1 for 0, and 0 for what is positive.
    static L opposite(L a) { return select(a, L{}, one()); }
    L held(size_t i) const { return opposite(nodes[i].mobility); }
    static L uncut(const Spring& s) { return select(L::splat(kMostCompliance) - s.compliance, one(), L{}); }

    size_t place(size_t i, int lane) const { return i * ropes.pitch + strands[lane] * ropes.components; }
    // The numbers of node or spring i.
    template <class T> L of(const RopeNumbers<T>& numbers, size_t i) const {
        return numbers.of_strand == 0 ? L::splat(numbers.at(i, 0)) : gathered(numbers, i);
    }
    template <class T> __attribute__((noinline)) L gathered(const RopeNumbers<T>& numbers, size_t i) const {
        double lane[N];
        for (int j = 0; j < N; ++j) lane[j] = numbers.at(i, strands[j]);
        return L::load(lane);
    }
    // 1 where a node is held, as holds() has it.
    L is_held(size_t i) const {
        const L pin = of(c.pin, i);
        L off = one();
        for (const cd_node kind : {CD_NODE_PINNED, CD_NODE_DRIVEN, CD_NODE_POSED}) off = off * (pin - L::splat(kind));
        return opposite(off * off);
    }
    __attribute__((noinline)) V load(StateNumbers numbers, size_t i) const {
        double lane[3][N] = {};
        for (int j = 0; j < N; ++j)
            for (size_t k = 0; k < ropes.components; ++k) lane[k][j] = numbers[place(i, j) + k];
        return {L::load(lane[0]), L::load(lane[1]), L::load(lane[2])};
    }
    void store(V a, StateNumbers numbers, size_t i) const {
        const double least = numbers.range().least;
        double lane[3][N];
        settled(a.x, least).store(lane[0]), settled(a.y, least).store(lane[1]), settled(a.z, least).store(lane[2]);
        for (int j = 0; j < N && size_t(j) < count; ++j)
            for (size_t k = 0; k < ropes.components; ++k) numbers.put(place(i, j) + k, lane[k][j]);
    }
    size_t tension_place(size_t i, int lane) const { return i * ropes.strands + strands[lane]; }
    L load_tension(size_t i) const {
        double lane[N];
        for (int j = 0; j < N; ++j) lane[j] = ropes.tension[tension_place(i, j)];
        return L::load(lane);
    }
    V gravity() const { return {L::splat(stage.gravity[0]), L::splat(stage.gravity[1]), L::splat(stage.gravity[2])}; }

    // ---- the air ----------------------------------------------------------------------------------------------------

    bool has_air() const { return stage.has_air(); }
    // The way of the rope at node i, by the guess that its neighbours go on as they are.
    V way_at(size_t i) const {
        V left = nodes[i].w, right = left, before{}, after{};
        if (i > 0) {
            const L there = uncut(springs[i - 1]);
            left = select(there, nodes[i - 1].w, left), before = select(there, springs[i - 1].before, V{});
        }
        if (i + 1 < ropes.nodes) {
            const L there = uncut(springs[i]);
            right = select(there, nodes[i + 1].w, right), after = select(there, springs[i].before, V{});
        }
        const V chord = ((stage.dt * lambda) * (right - left) + before) + after;
        const L size = root(dot(chord, chord));
        return direction(chord, size - kNoDirection * share_of(i), one() / size, V{one(), L{}, L{}});
    }
    // Along and across the rope.
    struct Axes {
        V way, side, normal;
    };
    static Axes axes(V way) {
        const V x{one(), L{}, L{}}, y{L{}, one(), L{}}; // one of them is 45 degrees off at least
        const V off = cross(way, select(size_of(way.x) - L::splat(0.7), y, x));
        const V side = (one() / root(dot(off, off))) * off;
        return {way, side, cross(way, side)};
    }
    // Takes from what hangs on a node what resists it, along the unit vector n as it moves and along `acting` as it
    // pushes back, by an impulse k (n . u - n . w), which is resisted.wished - resisted.by . phi.
    template <bool rod>
    CD_INLINED static void resist(L k, V n, V acting, V u, Hung& hung, Resisted& resisted, V* by_link) {
        const V right = hung.c * acting, left = transposed_times(hung.c, n);
        const L share = k / (one() + k * dot(n, right)), wished = share * dot(n, u - hung.y);
        if constexpr (rod) {
            const V link_left = transposed_times(hung.across, n);
            take(hung, {right, hung.back * acting}, {wished, share * left}, share * link_left, resisted, *by_link);
        } else {
            resisted = {wished, share * left};
            hung.y = hung.y + wished * right;
            take_from(hung.c, right, resisted.by);
        }
    }
    // Of a rod: how the node and its link move by an impulse of 1, and the impulse that resists.
    struct Column {
        V node, link;
    };
    __attribute__((noinline)) static void take(Hung& hung, Column moves, Resisted by, V by_link, Resisted& resisted,
                                               V& resisted_link) {
        resisted = by, resisted_link = by_link;
        hung.y = hung.y + by.wished * moves.node, hung.link_y = hung.link_y + by.wished * moves.link;
        take_from(hung.c, moves.node, by.by), take_from(hung.across, moves.node, by_link);
        take_from(hung.back, moves.link, by.by), take_from(hung.link, moves.link, by_link);
    }
    static void take_from(M& a, V column, V row) {
        a.x = a.x - column.x * row;
        a.y = a.y - column.y * row;
        a.z = a.z - column.z * row;
    }
    template <bool rod> static L impulse_of(const Resisted& resisted, const V* by_link, const Impulses& from_right) {
        const L impulse = resisted.wished - dot(resisted.by, from_right.phi);
        if constexpr (rod) return impulse - dot(*by_link, from_right.psi);
        return impulse;
    }
    // The length of the rope that feels the air at node i [m].
    L share_of(size_t i) const {
        const auto half = [&](size_t k) {
            return k + 1 < ropes.nodes ? uncut(springs[k]) * (0.5 * springs[k].length) : L{};
        };
        return i > 0 ? half(i) + half(i - 1) : half(i);
    }
    // The air's resistance at node i [kg], of a coefficient of it, and its velocity there.
    L resistance(size_t i, double coefficient) const { return ((coefficient * stage.dt) * share_of(i)) * lambda; }
    V wind(size_t i) const {
        if (ropes.wind.data) return load(ropes.wind, i);
        return {L::splat(stage.wind[0]), L::splat(stage.wind[1]), L::splat(stage.wind[2])};
    }
    V* links_of_air(size_t i) const { return by_link + 3 * i; }
    template <bool rod> void resist(size_t i, Hung& hung) {
        InAir& n = in_air[i];
        const L free = opposite(held(i));
        const L along = free * resistance(i, stage.along), across = free * resistance(i, stage.across);
        const V u = wind(i);
        const Axes to = axes(n.way);
        resist<rod>(along, to.way, to.way, u, hung, n.along, links_of_air(i));
        resist<rod>(across, to.side, to.side, u, hung, n.side, links_of_air(i) + 1);
        resist<rod>(across, to.normal, to.normal, u, hung, n.normal, links_of_air(i) + 2);
    }
    // What is left of the impulses from the right, at node i.
    template <bool rod> void resisted(size_t i, Impulses& left) const {
        const InAir& n = in_air[i];
        const Axes to = axes(n.way);
        left.phi = left.phi + impulse_of<rod>(n.normal, links_of_air(i) + 2, left) * to.normal;
        left.phi = left.phi + impulse_of<rod>(n.side, links_of_air(i) + 1, left) * to.side;
        left.phi = left.phi + impulse_of<rod>(n.along, links_of_air(i), left) * to.way;
    }

    // ---- what it touches, in rope_contact.hh ------------------------------------------------------------------------

    bool has_contacts() const { return CD_WITH_CONTACT && stage.collider_count > 0; }
    bool has_callbacks() const { return CD_WITH_CONTACT && stage.callback_count > 0; }
    static V velocity_of(const Collider& c) {
        return {L::splat(c.velocity[0]), L::splat(c.velocity[1]), L::splat(c.velocity[2])};
    }
    L length_at(size_t i) const;
    void look_at_gap(const Obstacle& to, V x, double time, V& normal, L& gap) const;
    __attribute__((noinline)) void look_at_bed(const Obstacle& to, V x, double time, V& normal, L& gap) const;
    __attribute__((noinline)) void ask_all(bool at_start);
    void look_at_end(size_t k, size_t i, V before, V x, Contact& c) const;
    L leaving(size_t i, const Contact& c) const;
    V slip_at(const Collider& to, size_t i, const Contact& c) const;
    static Axes surface_axes(V normal, V slip);
    void set_friction(double friction, L slip, Contact& c) const;
    __attribute__((noinline)) L touch(size_t i, size_t iteration);
    L touches() const;
    V* links_of_contact(size_t at) const { return by_link + 3 * ((has_air() ? ropes.nodes : 0) + at); }
    template <bool rod> __attribute__((noinline)) void press(size_t i, Hung& hung);
    template <bool rod> __attribute__((noinline)) void pressed(size_t i, Impulses& left);
    void forget_overlaps();

    // ---- the start of a step ----------------------------------------------------------------------------------------

    // What the springs are, and which nodes are free: mobility is 1, until a stage has a better one.
    void prepare() {
        for (size_t i = 0; i < ropes.nodes; ++i) nodes[i].mobility = opposite(is_held(i));
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            Spring& s = springs[i];
            s.length = of(c.length, i), s.per_length = one() / s.length;
            s.compliance = one() / size_of(of(c.stiffness, i)); // which may be -0
            s.moves = uncut(s) * opposite(held(i) * held(i + 1));
        }
    }
    // What nodes would do alone.
    void begin_alone() {
        const L h = stage.dt * lambda;
        per_lambda = one() / lambda;
        for (size_t i = 0; i < ropes.nodes; ++i) {
            const V v = load(ropes.velocity, i);
            Node& n = nodes[i];
            const L m = of(c.mass, i), tie = of(c.tie, i), free = n.mobility;
            const L ground = m + h * ((c.drag * m + of(c.tie_damping, i)) + h * tie);
            V push = m * gravity();
            if (ropes.force.data) push = push + load(ropes.force, i);
            if (ropes.target.data) push = push + tie * (load(ropes.target, i) - load(ropes.position, i));
            n.ground = select(free, ground, L{});
            n.mobility = select(free, one() / ground, L{});
            n.b = select(free, n.mobility * (m * v + h * push), v);
        }
    }
    // What holds free node i where it is: against what it does alone, and against the wind.
    L impulse_on(size_t i) const {
        const Node& n = nodes[i];
        const L own = n.ground * root(dot(n.b, n.b));
        if (!has_air()) return own;
        const V u = wind(i);
        return own + (resistance(i, stage.along) + resistance(i, stage.across)) * root(dot(u, u));
    }
    // And for what is open the guess that they go on as they are.
    void begin() {
        begin_alone();
        for (size_t i = 0; i < ropes.nodes; ++i) nodes[i].w = select(open, load(ropes.velocity, i), nodes[i].w);
        heavy = L{};
        for (size_t i = 0; i < ropes.nodes && has_contacts(); ++i) heavy = heavy + nodes[i].ground;
        L forces{}, lengths{}; // on the nodes, and of the springs
        for (size_t i = 0; i < ropes.nodes; ++i) forces = forces + impulse_on(i);
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) lengths = lengths + springs[i].length;
        least_worth = (kRounding / (stage.tolerance * stage.dt * double(ropes.nodes))) * (forces * lengths);
        V left = load(ropes.position, 0);
        for (size_t i = 0; i + 1 < ropes.nodes; ++i) {
            const V right = load(ropes.position, i + 1);
            springs[i].before = right - left;
            springs[i].long_before = root(dot(springs[i].before, springs[i].before));
            springs[i].impulse = select(open, V{}, springs[i].impulse);
            springs[i].pushed = L{};
            springs[i].tension = springs[i].moves * select(open, load_tension(i), springs[i].tension);
            left = right;
        }
        for (size_t i = 0; i < ropes.nodes && has_air(); ++i) in_air[i].way = way_at(i);
        if (is_rod()) begin_joints();
    }

    // ---- one iteration ----------------------------------------------------------------------------------------------

    // By how much a tension of 1 shortens spring i and lets it stretch, if nothing else holds its nodes.
    L give(size_t i) const {
        return (stage.dt * stage.dt) * (nodes[i].mobility + nodes[i + 1].mobility) + springs[i].compliance;
    }

    // The unit vector along `a`, given one over its length; `other` where it is too short to have one.
    static V direction(V a, L longer, L inverse, V other) { return select(longer, inverse * a, other); }

    // What a look at all springs sees of the guess.
    struct Seen {
        L error{}, probe{};   // its largest error of length, over the rest length; NaN if a number is
        L pushed{};           // the sum of the pushes of springs that only pull, times lengths
        L gained{}, worth{};  // the energy that springs give from nothing, and the sum of tensions times lengths
        L slack{}, lengths{}; // the most of a tension times how much its spring is too short for it; sum of lengths
        L rounding{};         // what the energy gained may be by rounding in the joints, over the tolerance

        void add(const Seen& o) {
            error = larger(error, o.error), slack = larger(slack, o.slack);
            probe = probe + o.probe, pushed = pushed + o.pushed, lengths = lengths + o.lengths;
            gained = gained + o.gained, worth = worth + o.worth;
        }
        Seen in(L strands) const {
            const auto there = [&](L a) { return select(strands, a, L{}); };
            return {there(error), there(probe), there(pushed),  there(gained),
                    there(worth), there(slack), there(lengths), rounding};
        }
    };

    // Spring i where no node moves by it. One of fixed length may be as much too long as positions are rounded.
    __attribute__((noinline)) void rest(size_t i) {
        Spring& s = springs[i];
        const L over = long_after(i) - s.length, idle = opposite(s.moves);
        const L yields = idle * select(s.compliance, one(), L{}), rigid = idle * opposite(s.compliance);
        s.tension = select(yields, (one() / s.compliance) * (stage.push ? over : positive(over)), s.tension);
        const V left = load(ropes.position, i), right = load(ropes.position, i + 1);
        const L rounded = ropes.position.range().epsilon * (root(dot(left, left)) + root(dot(right, right)));
        apart = select(rigid, larger(apart, s.per_length * (over - rounded)), apart);
        for (L* a : {&s.taut, &s.transverse, &s.axial, &s.wished}) *a = select(idle, L{}, *a);
        s.wish = select(idle, nodes[i + 1].w - nodes[i].w, s.wish);
    }

    // Linearizes spring i about the guess (w, T). barrier > 0: T gap = barrier instead of "slack or taut".
    void linearize(size_t i, L barrier, bool interior, Seen& seen) {
        Spring& s = springs[i];
        const L length = s.length;
        Seen here;
        const V dw = nodes[i + 1].w - nodes[i].w;
        const L t = s.tension, dt = L::splat(stage.dt);
        const L theta = by_sign(t, L::splat(0.5), lambda);
        const V after = s.before + dt * dw, z = s.before + (theta * dt) * dw;
        const L long_after = root(dot(after, after)), long_z = root(dot(z, z));
        const L per_z = one() / long_z, least = kNoDirection * length;
        const V z_way = direction(z, long_z - least, per_z, V{one(), L{}, L{}});
        s.along = direction(after, long_after - least, one() / long_after, z_way);
        s.acting = direction(z, long_z - least, per_z, s.along);
        L over = long_after - length;

        const L missing = over - s.compliance * t;
        // The work that its impulse did on the nodes, beyond what a spring of this tension can give.
        const L stretch = long_after - s.long_before;
        here.probe = 0.0 * missing;
        here.gained = t * stretch - dot(s.impulse, dw) * per_lambda;
        here.worth = (size_of(t) + s.pushed) * length;
        here.pushed = s.pushed * length;
        L yields = s.compliance;
        if (interior) {
            over = over + (s.gap + barrier / t);
            yields = yields + s.gap / t;
            s.taut = one();
            here.error = s.per_length * missing;
            here.slack = s.per_length * (t * positive(L{} - missing));
            here.lengths = length;
        } else {
            const L shorter = give(i) * t; // by what it pulls
            s.taut = stage.push ? one() : select(shorter + over, one(), L{});
            const L wrong = stage.push ? size_of(missing) : select(s.taut, size_of(missing), shorter);
            here.error = s.per_length * wrong;
        }
        const L impulse = (stage.dt * stage.dt) * lambda; // of a unit of stiffness, per velocity
        s.transverse = s.taut * ((theta * impulse) * (positive(t) / larger(long_z, least)));
        s.axial = L{};
        if (interior || any_positive(s.compliance)) {
            const L a = yields / impulse; // as much as 1 / (transverse + 1 / axial): axial may be negative, or infinite
            s.axial = select(interior ? one() : s.compliance, a / (one() - a * s.transverse), L{});
        }
        const double rate = 1 / stage.dt;
        s.wish = dw - ((rate * over) / dot(s.along, s.acting)) * s.acting;
        s.wished = dot(s.along, dw) - rate * over;
        if (any_positive(opposite(s.moves))) rest(i), here = here.in(s.moves);
        seen.add(here);
    }

    // What the linear system has for spring s: its impulse.
    void pulls(Spring& s, V impulse) const {
        s.impulse = impulse;
        const L next = s.taut * (dot(impulse, s.acting) / (stage.dt * lambda));
        s.next = stage.push ? next : positive(next);
        s.pushed = s.next - next;
    }

    void eliminate(); // in rope_elimination.hh
    V into_held(size_t i) const;

    // ---- rods, in rope_rod.hh ---------------------------------------------------------------------------------------

    bool is_rod() const { return CD_WITH_BEND && stage.bends; }
    void begin_joints();
    void look_at_joints(Seen& seen) const;
    __attribute__((noinline)) void join(size_t i, Hung& hung);
    __attribute__((noinline)) void pull(const Spring& s, Joint& joint, Hung& hung) const;
    __attribute__((noinline)) void eliminate_rod();

    // ---- the step, in rope_step.cpp ---------------------------------------------------------------------------------

    L long_after(size_t i) const {
        const V after = springs[i].before + L::splat(stage.dt) * (nodes[i + 1].w - nodes[i].w);
        return root(dot(after, after));
    }
    L alone(size_t i) const { return select(held(i), L{}, one() / of(c.mass, i)); }
    void linearize_all(L barrier, bool interior, L weight, size_t iteration);
    void newton(size_t most);
    void start_together();
    void interior(size_t most);
    void step_inside(L barrier);
    void solve();
    bool try_again();
    void calm();
    void settle();
    RopeResult step();
};

} // namespace CD_ISA
} // namespace cd
