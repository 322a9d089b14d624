// A bundle of strands, and one Newton iteration for it: springs are linearized about a guess, and one elimination along
// the strand solves the linear system. With C the mobility of all that hangs on the left of a node (velocity per
// impulse) and y where that would go by itself, a spring passes both on: see rope_elimination.hh, and rope_rod.hh where
// the rope bends. What is done with iterations is in rope_step.cpp.
#pragma once

#include <math.h>

#include <initializer_list>
#include <type_traits>

#include "base/node.hh"
#include "kernel/lines.hh"
#include "kernel/rope_step.hh"
#include "kernel/vectors.hh"

namespace cd {
namespace CD_ISA {

// A spring shorter than this, over its rest length, has no direction of its own.
constexpr double kNoDirection = 1e-12;
// In the first iterations springs that are as long as their length, to this part of the tolerance, count as taut unless
// they pushed: of straight ropes at rest rounding would tell, and then one spring after the other becomes taut.
constexpr double kAsLong = 0.5;
constexpr size_t kFirstIterations = 5;
constexpr double kMostCompliance = 0x1.fffffffffffffp1023; // of what is not cut
constexpr double kRounding = 1e-14;                        // of tensions, over the mean force on the nodes

// N lanes: pairs of halves of strands, or whole ones.
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
        V x0, v0;           // where it is when the step begins, and how it moves
        L mass;             // [kg]
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
        V slip, side;     // the velocity along the surface about which friction is linearized, and its way
        L before, gap;    // how far outside it is when the step begins, and by the guess when it ends [m]
        L on, push;       // 1 where it touches; the impulse that keeps it out
        L grip;           // the push that friction is of
        // Friction, linearized: against the slip as much per push, and a resistance [kg] to what is not a wished speed;
        // across the slip a resistance. had: what the last elimination had of it along the guess's slip, over the most.
        L follows, along, wished, across, had;
        Resisted pressed, rubbed[2];
    };
    // Of a rod's node i, its link, and the joint at the node before.
    struct Joint {
        L stiffness, ratio; // of the joint, per velocity; rest length of the link over that of the one before
        Turn<N> turn;       // from the link before to the link, at rest
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
        L long_before, gap; // |D0|, and of the interior point what is left to L; then what settle() adds to tension
        L reeled;           // by how much its length fell since the last step
    };

    const Ropes& ropes;
    const RopeParameters& c;
    const RopeStage& stage;
    Node* const nodes;
    Spring* const springs;
    InAir* const in_air;     // if there is air
    Contact* const contacts; // of node after node, with each collider
    Joint* const joints;     // of rods
    V* const by_link;        // of rods: three of each node for the air, then three of each contact
    Answer* const answers;   // of callback after callback, for each node
    V* const pushes;         // of contact after contact: on its node by the guess, and by the last elimination; or null
    double* const question;  // room for places of nodes and what is told of them
    const size_t* const strands; // of its lanes; those beyond the last are the last one again
    size_t count;                // of strands
    L lambda, per_lambda, open;  // open: 1 where a strand is still to be solved
    L iterations{}, reached{}, failed{}, by_change{}, lengths_right{}; // by_change: see eliminate_change()
    L best = L::splat(INFINITY), best_lambda{}; // the least error that was reached, and its lambda
    L heavy{};                                  // the mass of the strand, if it may touch something
    bool newtonian = true;                      // while Newton's method is at work
    double as_long = 0;                         // see kAsLong
    L apart{};                                  // the error of springs between held nodes
    L least_worth{};                            // what tensions times lengths are at least, as errors count
    BadAnswer bad_answer{};
    // Of a lane. The last spring joins its halves; where a node lacks, one begins that is held, still, on a cut spring.
    const bool halved = stage.has_halves();
    const size_t node_count = rope_lane_nodes(ropes.nodes, halved);
    const size_t spring_count = halved ? node_count : node_count - 1;
    bool comes_back[N] = {}; // which lanes go from their strand's last node

    static L one() { return L::splat(1); }
    // 1 for 0, and 0 for what is positive.
    static L opposite(L a) { return select(a, L{}, one()); }
    L held(size_t i) const { return opposite(nodes[i].mobility); }
    static L uncut(const Spring& s) { return select(L::splat(kMostCompliance) - s.compliance, one(), L{}); }

    // ---- halves -----------------------------------------------------------------------------------------------------

    bool is_middle(size_t spring) const { return halved && spring + 1 == spring_count; }
    // Where in its strand a lane has its node i, and spring i, from there to node i + 1. Beyond the strand's last one
    // is what is none.
    size_t first_back() const { return (halved ? 2 * node_count : node_count) - 1; } // of a lane that comes back
    size_t node_at(size_t i, int lane) const { return comes_back[lane] ? first_back() - i : i; }
    size_t spring_at(size_t i, int lane) const { return comes_back[lane] ? first_back() - 1 - i : i; }
    bool has_node(size_t i, int lane) const { return node_at(i, lane) < ropes.nodes; }
    bool has_spring(size_t i, int lane) const { return spring_at(i, lane) + 1 < ropes.nodes; }
    // 1, and -1 in lanes that come back: so that both lanes of a middle spring have the same one.
    L forth() const { return halved ? select(first_halves(), one(), L{} - one()) : one(); }
    bool lacks_node() const { return !has_node(0, 1); } // whether second halves begin with a node that is none
    static L first_halves() {                           // 1 in their lanes
        double lane[N];
        for (int j = 0; j < N; ++j) lane[j] = j % 2 == 0;
        return L::load(lane);
    }
    // Of the lanes' numbers those of their strands: the sum of both halves', and the largest.
    L sum(L a) const { return halved ? a + pairs_exchanged(a) : a; }
    L most(L a) const { return halved ? larger(a, pairs_exchanged(a)) : a; }
    // Tells each half where the other's last node is, and how it moves.
    void meet() {
        if (!halved) return;
        Node& beyond = nodes[node_count];
        const Node& last = nodes[node_count - 1];
        beyond.mobility = pairs_exchanged(last.mobility);
        beyond.w = pairs_exchanged(last.w), beyond.next = pairs_exchanged(last.next);
    }

    size_t place(size_t i, int lane) const { return node_at(i, lane) * ropes.pitch + strands[lane] * ropes.components; }
    // The numbers of node i, or of spring i; of what is none those of the last one.
    template <class T> L of_node(const RopeNumbers<T>& numbers, size_t i) const {
        if (numbers.of_strand == 0 && numbers.of_item == 0) return L::splat(numbers.at(0, 0));
        return gathered(numbers, i, first_back(), ropes.nodes - 1);
    }
    L of_spring(const RopeNumbers<double>& numbers, size_t i) const {
        if (numbers.of_strand == 0 && numbers.of_item == 0) return L::splat(numbers.at(0, 0));
        return gathered(numbers, i, first_back() - 1, ropes.nodes - 2);
    }
    // last: the first number of a lane that comes back, at most `end`.
    template <class T>
    __attribute__((noinline)) L gathered(const RopeNumbers<T>& numbers, size_t i, size_t last, size_t end) const {
        double lane[N];
        for (int j = 0; j < N; ++j) {
            const size_t at = comes_back[j] ? last - i : i;
            lane[j] = numbers.at(at < end ? at : end, strands[j]);
        }
        return L::load(lane);
    }
    // 1 where a node is held, as holds() has it.
    L is_held(size_t i) const {
        const L pin = of_node(c.pin, i);
        L off = one();
        for (const cd_node kind : {CD_NODE_PINNED, CD_NODE_DRIVEN, CD_NODE_POSED}) off = off * (pin - L::splat(kind));
        return opposite(off * off);
    }
    // Of what is no node that of the strand's first one.
    __attribute__((noinline)) V load(StateNumbers numbers, size_t i) const {
        double lane[3][N] = {};
        numbers.stored_state([&](const auto* from) {
#pragma GCC unroll 1
            for (int j = 0; j < N; ++j) {
                const auto* const at = from + place(i, has_node(i, j) ? j : j - 1);
                for (size_t k = 0; k < ropes.components; ++k) lane[k][j] = double(at[k]);
            }
        });
        return {L::load(lane[0]), L::load(lane[1]), L::load(lane[2])};
    }
    __attribute__((noinline)) void store(V a, StateNumbers numbers, size_t i) const {
        const double least = numbers.range().least;
        double lane[3][N];
        settled(a.x, least).store(lane[0]), settled(a.y, least).store(lane[1]), settled(a.z, least).store(lane[2]);
        numbers.stored_state([&](auto* to) {
            for (size_t j = 0, most = halved ? 2 * count : count; j < most; ++j) {
                using Stored = std::remove_pointer_t<decltype(to)>;
                const size_t some = has_node(i, int(j)) ? ropes.components : 0, at = place(i, int(j));
                for (size_t k = 0; k < some; ++k) to[at + k] = Stored(lane[k][j]);
            }
        });
    }
    size_t slot_of(int lane) const { return size_t(halved ? lane / 2 : lane); } // which strand of the bundle
    bool is_used(int lane) const { return slot_of(lane) < count; }
    size_t tension_place(size_t i, int lane) const { return spring_at(i, lane) * ropes.strands + strands[lane]; }
    L load_tension(size_t i) const {
        double lane[N];
        for (int j = 0; j < N; ++j) lane[j] = has_spring(i, j) ? ropes.tension[tension_place(i, j)] : 0;
        return L::load(lane);
    }
    V gravity() const { return {L::splat(stage.gravity[0]), L::splat(stage.gravity[1]), L::splat(stage.gravity[2])}; }

    // ---- what resists it: rope_air.hh -------------------------------------------------------------------------------

    // Three directions at right angles, the first one along the rope or a normal.
    struct Axes {
        V way, side, normal;
    };
    static Axes axes(V way);
    __attribute__((noinline)) void resist(L k, const V& n, const V& acting, const V& u, Hung& hung, Resisted& resisted,
                                          V* by_link) const;
    static void take_from(M& a, const V& column, const V& row);
    L impulse_of(const Resisted& resisted, const V* by_link, const Impulses& from_right) const;
    bool has_air() const { return stage.has_air(); }
    V way_at(size_t i) const;
    L share_of(size_t i) const;
    __attribute__((noinline)) L resistance(size_t i, double coefficient) const;
    V wind(size_t i) const;
    V* links_of_air(size_t i) const { return by_link + 3 * i; }
    void resist(size_t i, Hung& hung);
    void resisted(size_t i, Impulses& left) const;

    // ---- what it touches, in rope_contact.hh ------------------------------------------------------------------------

    bool has_contacts() const { return CD_WITH_CONTACT && stage.collider_count > 0; }
    bool has_callbacks() const { return CD_WITH_CONTACT && stage.callback_count > 0; }
    bool tells_loads() const { return CD_WITH_CONTACT && pushes; }
    static V velocity_of(const Collider& c) {
        return {L::splat(c.velocity[0]), L::splat(c.velocity[1]), L::splat(c.velocity[2])};
    }
    L length_at(size_t i) const;
    void look_at_gap(const Obstacle& to, V x, double time, V& normal, L& gap) const;
    __attribute__((noinline)) void look_at_bed(const Obstacle& to, V x, double time, V& normal, L& gap) const;
    __attribute__((cold, noinline)) void ask_all(bool at_start);
    void look_at_end(size_t k, size_t i, V before, V x, Contact& c) const;
    L leaving(size_t i, const Contact& c) const;
    V slip_at(const Collider& to, size_t i, const Contact& c) const;
    static Axes surface_axes(V normal, V slip);
    void set_friction(double friction, L slip, Contact& c) const;
    __attribute__((noinline)) L touch(size_t i, size_t iteration);
    L touches() const;
    V* links_of_contact(size_t at) const { return by_link + 3 * ((has_air() ? ropes.nodes : 0) + at); }
    __attribute__((noinline)) void press(size_t i, Hung& hung);
    __attribute__((noinline)) void pressed(size_t i, Impulses& left);
    __attribute__((noinline)) V velocity_out(size_t i) const;
    void forget_overlaps();
    __attribute__((cold)) void take_pushes(L part) const;
    __attribute__((cold)) void tell_loads() const;

    // ---- the start of a step ----------------------------------------------------------------------------------------

    // The state, what the springs are, and which nodes are free: mobility is 1, until a stage has a better one.
    void prepare() {
        const size_t last = ropes.nodes - 1;
        const auto ends_held = [&](size_t end, int lane) { return holds(cd_node(c.pin.at(end, strands[lane]))); };
        for (int j = 0; j < N; ++j) comes_back[j] = halved ? j % 2 == 1 : ends_held(last, j) && !ends_held(0, j);
        for (size_t i = 0; i < rope_lane_room(ropes.nodes, halved); ++i) {
            Node& n = nodes[i];
            n.x0 = load(ropes.position, i), n.v0 = load(ropes.velocity, i);
            n.mass = of_node(c.mass, i), n.mobility = opposite(is_held(i));
        }
        for (size_t i = 0; i < spring_count; ++i) {
            Spring& s = springs[i];
            s.length = of_spring(c.length, i), s.per_length = one() / s.length;
            s.compliance = one() / size_of(of_spring(c.stiffness, i)); // which may be -0
        }
        if (lacks_node()) {
            nodes[0].mobility = first_halves() * nodes[0].mobility;
            nodes[0].v0 = select(first_halves(), nodes[0].v0, V{});
            springs[0].compliance = select(first_halves(), springs[0].compliance, L::splat(INFINITY));
        }
        meet();
        for (size_t i = 0; i < spring_count; ++i)
            springs[i].moves = uncut(springs[i]) * opposite(held(i) * held(i + 1));
    }
    // What nodes would do alone.
    void begin_alone() {
        const L h = stage.dt * lambda;
        per_lambda = one() / lambda;
        for (size_t i = 0; i < node_count; ++i) {
            Node& n = nodes[i];
            const L m = n.mass, tie = of_node(c.tie, i), free = n.mobility;
            const L ground = m + h * ((c.drag * m + of_node(c.tie_damping, i)) + h * tie);
            V push = m * gravity();
            if (ropes.force.data) push = push + load(ropes.force, i);
            if (ropes.target.data) push = push + tie * (load(ropes.target, i) - n.x0);
            n.ground = select(free, ground, L{});
            n.mobility = select(free, one() / ground, L{});
            n.b = select(free, n.mobility * (m * n.v0 + h * push), n.v0);
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
        for (size_t i = 0; i < node_count; ++i) nodes[i].w = select(open, nodes[i].v0, nodes[i].w);
        meet();
        heavy = L{};
        for (size_t i = 0; i < node_count && has_contacts(); ++i) heavy = heavy + nodes[i].ground;
        heavy = sum(heavy);
        L forces{}, lengths{}; // on the nodes, and of the springs
        for (size_t i = 0; i < node_count; ++i) forces = forces + impulse_on(i);
        for (size_t i = 0; i < spring_count; ++i) lengths = lengths + springs[i].length;
        least_worth = (kRounding / (stage.tolerance * stage.dt * double(ropes.nodes))) * (sum(forces) * sum(lengths));
        for (size_t i = 0; i < spring_count; ++i) {
            springs[i].before = nodes[i + 1].x0 - nodes[i].x0;
            springs[i].long_before = root(dot(springs[i].before, springs[i].before));
            springs[i].impulse = select(open, V{}, springs[i].impulse);
            springs[i].pushed = L{};
            springs[i].tension = springs[i].moves * select(open, load_tension(i), springs[i].tension);
            look_at_winch(i);
        }
        for (size_t i = 0; i < node_count && has_air(); ++i) in_air[i].way = way_at(i);
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
        // Of a spring that two lanes have. Sums that only weigh have it twice.
        Seen half() const {
            return {error, probe, 0.5 * pushed, 0.5 * gained, 0.5 * worth, slack, 0.5 * lengths, rounding};
        }
    };

    __attribute__((noinline)) void rest(size_t i); // in rope_step.cpp, with the three below
    void look_at_winch(size_t i);
    __attribute__((noinline)) L by_winch(const Spring& s, L stretch, V dw) const;
    static L by_yielding(const Spring& s, L stretch);

    // Linearizes spring i about the guess (w, T). barrier > 0: T gap = barrier length instead of "slack or taut".
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
        const V z_way = direction(z, long_z - least, per_z, V{forth(), L{}, L{}});
        s.along = direction(after, long_after - least, one() / long_after, z_way);
        s.acting = direction(z, long_z - least, per_z, s.along);
        L over = long_after - length;

        const L missing = over - s.compliance * t;
        // The work that its impulse did on the nodes, beyond what a spring of this tension can give, and its winch.
        const L stretch = long_after - s.long_before;
        here.probe = 0.0 * missing;
        here.gained = t * stretch - dot(s.impulse, dw) * per_lambda;
        if (!interior && any_positive(s.compliance)) here.gained = here.gained - by_yielding(s, stretch);
        if (any_positive(size_of(s.reeled))) here.gained = here.gained - by_winch(s, stretch, dw);
        here.worth = (size_of(t) + s.pushed) * length;
        here.pushed = s.pushed * length;
        L yields = s.compliance;
        if (interior) {
            over = over + (s.gap + barrier * length / t);
            yields = yields + s.gap / t;
            s.taut = one();
            here.error = s.per_length * missing;
            here.slack = s.per_length * (t * positive(L{} - missing));
            here.lengths = length;
        } else {
            const L shorter = give(i) * t; // by what it pulls
            const L long_enough = select(as_long * length - size_of(over), opposite(s.pushed), shorter + over);
            s.taut = stage.push ? one() : select(long_enough, one(), L{});
            const L wrong = stage.push ? size_of(missing) : select(s.taut, size_of(missing), shorter);
            here.error = s.per_length * wrong;
        }
        const L impulse = (stage.dt * stage.dt) * lambda; // of a unit of stiffness, per velocity
        s.transverse = s.taut * ((theta * impulse) * (positive(t) / larger(long_z, least)));
        const L straight = dot(s.along, s.acting);
        s.axial = L{};
        if (interior || any_positive(s.compliance)) {
            // As much as 1 / (transverse / straight + 1 / axial): axial may be negative, or infinite. Where lambda = 1,
            // as in the interior point, `along` is `acting`.
            const L a = yields / impulse, by_turning = a * s.transverse;
            const L axial = a / (one() - (interior ? by_turning : by_turning / straight));
            s.axial = select(interior ? one() : s.compliance, axial, L{});
        }
        const double rate = 1 / stage.dt;
        s.wish = dw - ((rate * over) / straight) * s.acting;
        s.wished = dot(s.along, dw) - rate * over;
        if (any_positive(opposite(s.moves))) rest(i), here = here.in(s.moves);
        seen.add(is_middle(i) ? here.half() : here);
    }

    // What the linear system has for spring s: its impulse.
    void pulls(Spring& s, V impulse) const {
        s.impulse = impulse;
        const L next = s.taut * (dot(impulse, s.acting) / (stage.dt * lambda));
        s.next = stage.push ? next : positive(next);
        s.pushed = s.next - next;
    }

    void eliminate(); // in rope_elimination.hh
    V impulse_between(const Spring& s, const M& mobility, V left, V right) const;

    // ---- rods, in rope_rod.hh ---------------------------------------------------------------------------------------

    bool is_rod() const { return CD_WITH_BEND && stage.bends; }
    void begin_joints();
    V carried(const Joint& joint, V before) const;
    __attribute__((noinline, cold)) V bends(size_t i) const;
    L bent() const;
    void look_at_joints(Seen& seen) const;
    __attribute__((noinline)) void join(size_t i, Hung& hung);
    __attribute__((noinline)) void pull(const Spring& s, Joint& joint, Hung& hung) const;
    __attribute__((noinline)) void eliminate_rod();
    __attribute__((cold)) void eliminate_change();
    void eliminate_after(size_t iterations);

    // ---- the step, in rope_step.cpp ---------------------------------------------------------------------------------

    L long_after(size_t i) const {
        const V after = springs[i].before + L::splat(stage.dt) * (nodes[i + 1].w - nodes[i].w);
        return root(dot(after, after));
    }
    L alone(size_t i) const { return select(held(i), L{}, one() / nodes[i].mass); }
    Seen of_strands(const Seen& seen) const;
    void linearize_all(L barrier, bool interior, L weight, size_t iteration);
    __attribute__((cold)) void add_mass(L added);
    void newton(size_t most);
    __attribute__((cold)) void start_together();
    __attribute__((cold)) void interior(size_t most);
    __attribute__((cold)) L step_inside(L barrier);
    void solve();
    __attribute__((cold)) bool try_again();
    __attribute__((cold)) void calm();
    __attribute__((noinline)) void take_velocities();
    __attribute__((noinline)) L settle(L follows);
    RopeResult step();
};

} // namespace CD_ISA
} // namespace cd
