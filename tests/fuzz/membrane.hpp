// A random membrane and the calls that only membranes have.
#ifndef FUZZ_MEMBRANE_HPP
#define FUZZ_MEMBRANE_HPP

#include "body.hpp"

namespace fuzz {

class Membrane : public Body<MembraneApi> {
public:
    Membrane();

protected:
    cd_status make(const cd_allocator* allocator, cd_membrane** out) override;
    bool extent(cd_field field, Extent& out) const override;
    cd_status view(cd_membrane* handle, cd_field field, View& out) const override;
    void act() override;
    void act_by_kind() override;
    void check_state() override;
    void before_step(double dt) override;
    void after_step(const Step& step) override;
    double energy() const override;
    double room_for_energy(double dt) const override;
    double room_of_kind() const override;
    double stiffest() const override;
    double heaviest() const override;
    double gravity() const override;
    bool is_ring() const override { return rings().u + rings().v > 0; }
    bool sleeps() const override { return awake_nodes(cd_membrane_get_awake) < nodes; }
    bool is_driven() const override;
    bool keeps_its_energy() const override;
    bool has_lengths() const override;

private:
    size_t nu, nv;
    bool likes_lengths = false, likes_things = false; // is cloth most of the time, and meets colliders then

    // Of the two directions, 1 where the sheet is closed to a ring.
    struct Rings {
        size_t u, v;
    };
    Rings rings() const;
    bool is_edge(size_t u, size_t v, cd_node kind) const; // whether the node lies on an edge set to this kind
    void set_stiffness();
    void set_edge();
    void get_edge();
    void set_ring();
    void set_tolerance();
    void impulse();
    void teleport();
    void attach();
    void detach();
    void get_attachment();
    void get_reaction();
    void sample();
    void get_volume();
    void get_convergence();
    void get_shape();
    void get_solver_taken();
    void get_parameter();
    void write_vertices();
    void write_indices();

    // Of cloth: membrane_cloth.cpp and membrane_cloth_calls.cpp.
    double step_before = 1, velocity_before = 0, momentum_before[4] = {};
    Doubles position_before;
    struct Energies {
        double sum, stiffness; // of the contacts
    };
    Energies of_contacts() const;
    bool lacks_something() const; // that cloth needs to step
    bool is_free() const;         // nothing but gravity moves it from outside
    Doubles masses() const;
    double longest() const;           // length that a line of springs may have
    double push_of_crumpling() const; // at most, of all springs, as they are made up of it and what takes it back
    double work_of_air() const;
    void check_cloth(const Step& step);
    void check_held();
    void check_momentum(const Step& step);
    void get_ready(); // does away with what cloth can't have
    void set_rest_length();
    void set_shear();
    void set_compression();
    void set_breaking_strain();
    void set_effort();
    void set_air();
    void set_wind();
    void get_of_cloth();
};

} // namespace fuzz

#endif
