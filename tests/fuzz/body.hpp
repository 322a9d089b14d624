// What chain and membrane share: nodes with masses joined by springs, whose energy is bounded.
#ifndef FUZZ_BODY_HPP
#define FUZZ_BODY_HPP

#include "object.hpp"

namespace fuzz {

template <class Api> class Body : public Object<Api> {
protected:
    using Handle = typename Api::Handle;

    size_t components = 1, nodes = 1;

    virtual double energy() const = 0;
    virtual double stiffest() const = 0; // the largest stiffness of a spring, of bend or of a tie
    virtual double heaviest() const = 0; // the largest mass of a node, or more
    virtual double gravity() const = 0;  // the largest of its components
    virtual bool is_ring() const = 0;    // along one axis at least
    virtual bool falls_astray() const { return is_ring(); }
    virtual bool keeps_its_energy() const = 0;       // an implicit step adds none to what energy() tells
    virtual double room_for_energy(double dt) const; // by how much rounding may change it in a step
    // By how much the step just made may have changed the energy beyond rounding.
    virtual double room_of_kind() const { return 0; }

    double state_size() const override { return this->largest_of({CD_POSITION, CD_VELOCITY}); }
    void before_step(double dt) override;
    void after_step(const Step& step) override;

    // Of ropes and cloth, and what those touch: colliders.cpp.
    virtual bool has_lengths() const = 0;
    struct Thing { // a collider, as it is told
        cd_shape shape;
        double first[4], second[4], velocity[4], radius, friction;
    };
    std::vector<Thing> things() const;
    static bool moves(const Thing& thing);
    static bool same(const Thing& a, const Thing& b);
    // Whether it is a bed or a callback, which nodes may end in the hollows of: what such do is not checked by numbers.
    static bool has_hollows(const Thing& thing);
    double depth_in(const Thing& thing, const double* x) const; // less than 0 outside, and where it has hollows
    void set_callbacks_again();                                 // which loads and copies leave out
    void set_colliders();
    void set_plane();
    void set_capsule();
    void set_bed();
    void get_bed();
    void set_callback();
    void remove_collider();
    void set_collider_velocity();
    void set_thickness();
    void get_collider();
    void set_loads();
    void get_collider_load();

    virtual bool sleeps() const = 0; // some part
    size_t awake_nodes(cd_status (*getter)(const Handle*, size_t*)) const;
    void set_sleep(cd_status (*setter)(Handle*, double, double));
    void get_sleep(cd_status (*getter)(const Handle*, double*, double*));
    void set_gravity(cd_status (*setter)(Handle*, const double*, size_t));
    void get_gravity(cd_status (*getter)(const Handle*, double*, size_t));
    void get_energy(cd_status (*getter)(const Handle*, double*, double*, double*));
    void get_momentum(cd_status (*getter)(const Handle*, double*, size_t));
    // What to attach a node with. has_tied is to be called once that is done.
    struct Tie {
        double stiffness, damping, target[4];
        bool null;
        size_t count;
        const double* at() const { return null ? nullptr : target; }
    };
    Tie pick_tie() const;
    void has_tied(const Tie& tie, cd_status status);
    struct Impulse {
        double size[4];
        size_t count;
    };
    Impulse pick_impulse() const;
    // Where to teleport to: without a turn, or turned from one component towards the next.
    struct Move {
        double offset[4], rotation[16];
        bool turns, moderate; // moderate: no offset beyond 1
        size_t count;
        const double* turn() const { return turns ? rotation : nullptr; }
    };
    Move pick_move() const;

private:
    double energy_before = 0, room_before = 0;

    struct Place {
        double at[4];
        bool moderate;
        size_t count;
    };
    Place pick_place(double size) const;
    size_t pick_collider() const;
};

} // namespace fuzz

#endif
