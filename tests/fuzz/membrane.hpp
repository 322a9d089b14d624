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
    void act_by_kind() override;
    void check_state() override;
    double energy() const override;
    double stiffest() const override;
    double heaviest() const override;
    double gravity() const override;
    bool is_ring() const override { return rings().u + rings().v > 0; }
    bool is_driven() const override;
    bool keeps_its_energy() const override;

private:
    size_t nu, nv;

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
    void sample();
    void get_volume();
    void get_convergence();
    void get_shape();
    void get_parameter();
    void write_vertices();
    void write_indices();
};

} // namespace fuzz

#endif
