// A random chain and the calls that only chains have.
#ifndef FUZZ_CHAIN_HPP
#define FUZZ_CHAIN_HPP

#include "body.hpp"

namespace fuzz {

class Chain : public Body<ChainApi> {
public:
    Chain();

protected:
    cd_status make(const cd_allocator* allocator, cd_chain** out) override;
    bool extent(cd_field field, Extent& out) const override;
    cd_status view(cd_chain* handle, cd_field field, View& out) const override;
    void act() override;
    void act_by_kind() override;
    void check_state() override;
    void before_step(double dt) override;
    void after_step(const Step& step) override;
    double energy() const override;
    double room_of_kind() const override;
    double stiffest() const override;
    double heaviest() const override;
    double gravity() const override;
    bool is_ring() const override { return springs_now() > springs; }
    bool sleeps() const override { return awake_nodes(cd_chain_get_awake) < strands * nodes; }
    bool falls_astray() const override;
    bool is_driven() const override;
    bool keeps_its_energy() const override { return !ended_short; }
    bool has_lengths() const override;

private:
    size_t strands, springs;
    bool ended_short = false; // the last step missed its tolerance
    bool likes_lengths;       // this chain is a rope most of the time
    bool likes_things;        // and meets colliders then
    Doubles stretched;        // before the step, how much too long each spring of fixed length was
    size_t cut_before;
    double momentum_before[4], velocity_before, position_before, step_before;
    double depth_before = 0;   // how deep the deepest node lay in a collider
    bool began_inside = false; // and whether that was more than a step may leave

    size_t springs_now() const; // a ring has one more
    void impulse();
    void teleport();
    void attach();
    void detach();
    void get_attachment();
    void cut_or_weld();
    void set_end();
    void get_end();
    void sample();
    void get_shape();
    void get_parameter();
    void set_stiffness();
    double stiffest_joint() const;
    double stiffest_tie() const;

    // Of ropes: chain_rope.cpp.
    bool is_rope() const { return has_lengths(); }
    size_t own_strands() const; // that have pins, masses and the like of their own
    bool has_matched() const;
    bool lacks_something() const; // that ropes need to step
    bool is_free() const;         // nothing but gravity moves it from outside
    Doubles lengths() const;
    Doubles stiffnesses() const;
    Doubles lengths_now() const; // of strand after strand
    void get_ready();            // does away with what ropes can't have
    void set_rest_length();
    void set_tolerance();
    void get_tolerance();
    void set_air();
    void get_air();
    void set_wind();
    void get_convergence();
    void set_rest_angle();
    void set_strength();
    size_t cut_springs() const;                                // of those that have a stiffness of their own
    double deepest(const std::vector<Thing>& of) const;        // of all free nodes
    double room_for_depth(const std::vector<Thing>& of) const; // that a step may leave
    double longest() const;
    void check_depth(const Step& step);
    void get_reaction();
    void check_rope(const Step& step);
    void check_lengths(double tolerance, double dt);
    double force_on_nodes(double dt) const;
    void check_momentum(const Step& step);
};

} // namespace fuzz

#endif
