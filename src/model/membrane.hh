// The membrane: what it consists of, and what is done with it. The equations are those of contdyn/membrane.h.
#pragma once

#include "contdyn/membrane.h"
#include "model/draw.hh"
#include "model/sleep.hh"

namespace cd {

// The two directions of a sheet, as indices.
enum Direction { kU = 0, kV = 1 };

// What the lines of a sheet have in common: nothing; a factorization for each direction; but for the edges, all
// numbers. See membrane_held.cpp.
enum Likeness { kDiffer, kSeparate, kUniform };

constexpr uint64_t kMostNewton = 1000, kMostGradient = 10000; // see cd_membrane_set_effort

// Of membranes whose springs have a length: see membrane_cloth.cpp.
struct ClothSettings : AirSettings {
    double length[2] = {};              // [m], of the sheet; 0: springs have none
    double shear = 0, compression = 80; // [N/m], [1/s^2]
    uint64_t newton = 3, gradient = 0;  // 0: as many as bring enough
    double thickness = 0;               // [m]
    double breaking_strain = INFINITY;
};

struct MembraneSettings {
    cd_solver solver;
    int32_t ring[2];
    cd_node edge[4]; // by cd_edge: what was set last
    double tolerance;
    size_t most_iterations;
    double stiffness[2], bend, pressure;
    ClothSettings cloth;
};

struct Membrane : Body, MembraneSettings {
    const MembraneKernels* kernels;

    // shape. A number of component k at node (u, v) lies at k * plane + v * pitch + u of its array; fields of doubles
    // and bytes lie densely, at v * columns + u.
    size_t springs[2]; // nu, nv
    size_t columns, rows, pitch, plane;

    // fields of its own: a number per node (0 at the last node of a line without a ring); mask per node. pin is empty
    // where only edges hold nodes.
    Array<double> spring_stiffness[2], spring_length[2], breaking_strain[2];
    Array<uint8_t> mask;
    // of cloth: what its last step added to the velocities [m/s], from which the next one starts
    Array<char> change;

    // what the last call of step did: see cd_membrane_get_convergence and cd_membrane_get_broken
    size_t iterations, broken;
    double residual;

    // what steps need, none of it state: see membrane_step.cpp
    cd_solver taken;       // by the last step that found it awake; CD_SOLVER_AUTO: none
    Array<double> pressed; // the force of the pressure, laid out like the positions
    double stiffest;       // the largest diagonal entry of the system, where there is one
    bool whole;            // see membrane_step.cpp
    Likeness likeness;     // see membrane_held.cpp
    bool mean_apart;       // see membrane_step.cpp
    bool stiff_rod;        // likewise
    size_t held;           // single nodes that are held or tied: see membrane_held.cpp
    size_t parts;          // see membrane_parts.cpp

    // f(array, array of another membrane...) for each field, in the order in which they are kept; and for every array.
    template <class F, class... M> static void each_field(F f, M&... m) {
        f(m.pin...), f(m.mask...), f(m.node_mass...), f(m.spring_stiffness[kU]...), f(m.spring_stiffness[kV]...);
        f(m.spring_length[kU]...), f(m.spring_length[kV]...), f(m.breaking_strain[kU]...), f(m.breaking_strain[kV]...);
        f(m.attach_stiffness...), f(m.attach_damping...), f(m.position...), f(m.velocity...), f(m.force...);
        f(m.target...), f(m.wind...), f(m.colliders...), f(m.beds...), f(m.calm...), f(m.loads...);
        f(m.change...); // last: bytes of older versions end before it, and read as 0
    }
    template <class F> static void each_array(F f, Membrane& m) {
        each_field(f, m);
        f(m.coefficients), f(m.scratch), f(m.pressed), f(m.callbacks);
    }
};

constexpr uint64_t kMembraneTag = 0x314272626d4d6443; // "CdMmbrB1"

struct MembraneFeatures : BodyFeatures {
    bool spring_stiffness[2], spring_length[2], breaking_strain[2], pin, mask, ring[2], pressure, cloth;
    cd_solver solver;
    cd_node edge[4];
    Likeness likeness; // that steps may count on
};

// ---- shape and parameters (membrane.cpp) ----------------------------------------------------------------------------

inline Direction other(Direction d) { return d == kU ? kV : kU; }
inline Direction direction_of(cd_edge edge) { return edge < CD_EDGE_V_FIRST ? kU : kV; }
inline cd_edge edge_of(Direction d, bool at_last) { return cd_edge(2 * d + (at_last ? 1 : 0)); }

inline Layout layout_of(const Membrane& m) { return {m.components * m.rows, m.columns, m.pitch}; }
inline size_t place(const Membrane& m, size_t u, size_t v, size_t component) {
    return component * m.plane + v * m.pitch + u;
}
inline size_t node_at(const Membrane& m, size_t u, size_t v) { return v * m.columns + u; }
inline size_t nodes_along(const Membrane& m, Direction d) { return d == kU ? m.columns : m.rows; }
// springs of one line along d: a ring has one more
inline size_t springs_along(const Membrane& m, Direction d) { return m.springs[d] + size_t(m.ring[d]); }
// The node after number i of a line along d, round a ring; where there is none, that node itself. The one before it,
// where there is none the last one, at which no spring, bend or cell starts.
inline size_t after(const Membrane& m, Direction d, size_t i) { return i < m.springs[d] ? i + 1 : m.ring[d] ? 0 : i; }
inline size_t before(const Membrane& m, Direction d, size_t i) { return i > 0 ? i - 1 : m.springs[d]; }
// The neighbour of node i of a line along d if i is a matched end of it, else i itself.
size_t inside_matched(const Membrane& m, Direction d, size_t i);

// The weight of an edge line: 1/2 at the two ends of direction d under CD_MASS_HALF_ENDS, 1 elsewhere.
double line_weight(const Membrane& m, Direction d, size_t i);
inline bool can_have_lengths(const Membrane& m) { return m.components == 3 && m.springs[kU] > 0 && m.springs[kV] > 0; }
inline bool has_bend(const Membrane& m) { return CD_WITH_BEND && m.bend > 0; }
inline bool has_lengths(const Membrane& m) { return CD_WITH_CLOTH && m.cloth.length[kU] > 0; }

// The uniform values for weight 1: mass of a node, stiffness of a spring and bend at a node along d, twist of a cell.
double uniform_mass(const Membrane& m);
double uniform_stiffness(const Membrane& m, Direction d);
double per_spring(const Membrane& m, Direction d, double stiffness); // of any other total
double uniform_bend(const Membrane& m, Direction d);
double uniform_twist(const Membrane& m);
inline double uniform_length(const Membrane& m, Direction d) { return m.cloth.length[d] / double(springs_along(m, d)); }

// What node (u, v) is, what it weighs, and how stiff the spring is that starts there along d: with every weight, mask
// and field; 0 where there is no spring.
cd_node kind_of(const Membrane& m, size_t u, size_t v);                             // not CD_NODE_MATCHED
cd_node kind_by_edges(const Membrane& m, const cd_node* edges, size_t u, size_t v); // what edges make of it, by cd_edge
inline bool held(const Membrane& m, size_t u, size_t v) { return kind_of(m, u, v) != CD_NODE_FREE; }
inline bool present(const Membrane& m, size_t u, size_t v) { return !m.mask || m.mask[node_at(m, u, v)] != 0; }
double mass_of(const Membrane& m, size_t u, size_t v);
double stiffness_of(const Membrane& m, Direction d, size_t u, size_t v);
// The rest length of that spring, in cloth; that of any other where there is none.
double length_of(const Membrane& m, Direction d, size_t u, size_t v);
// The strain at which that spring tears; and whether any along d may.
double breaking_strain_of(const Membrane& m, Direction d, size_t u, size_t v);
inline bool can_tear(const Membrane& m, Direction d) {
    return m.breaking_strain[d] || m.cloth.breaking_strain < INFINITY;
}
// Whether the cell of four nodes that starts at a node is torn open: of cloth, if two of its springs or more are cut.
bool lacks_two_springs(const Membrane& m, size_t u, size_t v);
inline bool may_open(const Membrane& m) { return (m.spring_stiffness[kU] || m.spring_stiffness[kV]) && has_lengths(m); }
inline bool is_open(const Membrane& m, size_t u, size_t v) { return may_open(m) && lacks_two_springs(m, u, v); }
// The bend along d at a node, 0 unless it and its two neighbours along d are there; the twist of the cell that starts
// at a node, 0 unless its four nodes are there.
double bend_of(const Membrane& m, Direction d, size_t u, size_t v);
double twist_of(const Membrane& m, size_t u, size_t v);
// What drags a node back beside the springs' damping [N s/m]: drag, matched edges, an attachment. What ties it [N/m].
double drag_of(const Membrane& m, size_t u, size_t v);
inline double tie_of(const Membrane& m, size_t u, size_t v) { return tie_of(m, node_at(m, u, v)); }

// ---- life and features (membrane.cpp) -------------------------------------------------------------------------------

cd_status create_membrane(const char* function, size_t nu, size_t nv, size_t components, cd_precision precision,
                          const cd_allocator& allocator, Membrane*& out);
MembraneFeatures features(const Membrane& m);
inline const char* left_out(const MembraneFeatures& f) {
    if (!CD_WITH_CLOTH && f.cloth) return "cloth is";
    if (!CD_WITH_BEND && (f.ring[kU] || f.ring[kV])) return "rings are";
    if (!CD_WITH_COUPLED && f.solver != CD_SOLVER_ALTERNATING) return "the coupled solver is";
    return left_out(static_cast<const BodyFeatures&>(f));
}
// Takes the memory that the features need and releases what they do not; new fields are filled with uniform values.
// False for want of memory: nothing has changed.
bool set_features(Membrane& m, const MembraneFeatures& wanted);
// Positions, velocities and time back to 0.
void clear_state(Membrane& m);
// Fills a field that is switched on with the uniform values of the totals.
void fill_uniform(Membrane& m, cd_field field);
// Stops the nodes that have become pinned or absent.
void stop_nodes(Membrane& m);
// False for want of memory: nothing has changed.
bool set_edge(Membrane& m, cd_edge edge, cd_node kind);
bool set_ring(Membrane& m, bool along_u, bool along_v);

// ---- fields (membrane_fields.cpp) -----------------------------------------------------------------------------------

// Whether a number may stand in a field: finite, and in the ranges of membrane.h.
bool valid_number(const Membrane& m, cd_field field, size_t u, size_t v, double value);

// A component of the sheet's position between nodes, bilinear.
double position_at(const Membrane& m, double u, double v, size_t component);

// ---- time (membrane_step.cpp) ---------------------------------------------------------------------------------------

// Numbers that steps with these features need beside the fields.
struct MembraneNeeds {
    size_t coefficients, scratch;
};
bool needs_of(const Membrane& m, const MembraneFeatures& f, MembraneNeeds& out); // false if too many to count

struct MembraneOutcome {
    uint64_t diverged_at; // number of the first step at which a number left the finite range, or 0
    bool converged;       // of all coupled solves
};
MembraneOutcome step_membrane(Membrane& m, double dt, size_t count);
// Tells CD_SOLVER_AUTO that steps from here on differ from those before in what factored lines' energy depends on.
inline void make_unlike(Membrane& m) {
    if (m.solver == CD_SOLVER_AUTO) m.clock.make_unlike();
}
double stable_dt(const Membrane& m); // membrane_limit.cpp
// Likewise: what a step of springs takes; CD_SOLVER_AUTO: none. kinks, and whether its lines separate: see
// membrane_held.cpp.
cd_solver solver_for(const Membrane& m, double dt, double kinks, bool separates);

inline size_t awake_nodes(const Membrane& m) { return sleeping_parts(m) > 0 ? 0 : m.nodes; }

// ---- cloth (membrane_cloth.cpp, which a build without it leaves out) ------------------------------------------------

// Why such a membrane can't make its next step, or null.
const char* what_cloth_lacks(const Membrane& m);
// As needs_of, with lengths.
bool cloth_needs_of(const Membrane& m, const MembraneFeatures& f, MembraneNeeds& out);
// As step_membrane, but for the clock; leaves `iterations`, `residual` and `broken`.
MembraneOutcome step_cloth(Membrane& m, double dt, size_t count);
// What pushes the spring that starts at a node towards its length [N/m]; the bend there, 0 beside a cut spring.
double compression_of(const Membrane& m, Direction d, size_t u, size_t v);
double cloth_bend_of(const Membrane& m, Direction d, size_t u, size_t v);
// Whether the cell that starts at a node has its four springs, and so shear and twist; how long its diagonals are.
bool whole_cell(const Membrane& m, size_t u, size_t v);
double diagonal_length(const Membrane& m, size_t u, size_t v);

// ---- forces (membrane_force.cpp) ------------------------------------------------------------------------------------

// The force on a node of springs, shear and bend, one number per component.
void reaction(const Membrane& m, size_t u, size_t v, double* out);
// Of cloth: the energy of these; and what the spring that starts at a node along d bears.
double cloth_elastic(const Membrane& m);
double tension_of(const Membrane& m, Direction d, size_t u, size_t v);
double strain_of(const Membrane& m, Direction d, size_t u, size_t v);

// ---- measuring (membrane_measure.cpp) -------------------------------------------------------------------------------

void energy(const Membrane& m, double& kinetic, double& elastic, double& gravity);
void momentum(const Membrane& m, double* out);
double volume(const Membrane& m); // of 3 components

// ---- drawing (membrane_draw.cpp) ------------------------------------------------------------------------------------

void write_vertices(const Membrane& m, unsigned char* out, const VertexFormat& format);
size_t index_count(const Membrane& m);
void write_indices(const Membrane& m, unsigned char* out, size_t index_size); // 2 or 4

// ---- keeping (membrane_keep.cpp) ------------------------------------------------------------------------------------

uint64_t hash(const Membrane& m);
size_t save_size(const Membrane& m);
void save(const Membrane& m, unsigned char* out);
cd_status load(const char* function, Membrane& m, const unsigned char* bytes, size_t size);
cd_status copy(const char* function, Membrane& m, const Membrane& source);

} // namespace cd
