/* How the words of a call in scenes.txt become the arguments of a function, once for the runners in C and C++. Included
 * with these macros set: CHAIN(name, ...), MEMBRANE(name, ...), WATER(name, ...), each with _0 for calls without
 * arguments; what argument k is: D(k) a double, Z(k) a size, I(k) 0 or 1, E(type, k) an enumerator, A(k) an array of
 * doubles and its length, F(k) of floats, P(k) an array of doubles whose length is not told; and OUT, an output that is
 * not looked at. */
#define EVERY_OBJECT(CALL, CALL_0)                                                                                     \
    CALL(set_method, E(method, 0))                                                                                     \
    CALL(set_lambda, D(0))                                                                                             \
    CALL(set_drag, D(0))                                                                                               \
    CALL(enable_field, E(field, 0))                                                                                    \
    CALL(disable_field, E(field, 0))                                                                                   \
    CALL(write_f32, E(field, 0), Z(1), Z(2), Z(3), Z(4), F(5))                                                         \
    CALL(write_f64, E(field, 0), Z(1), Z(2), Z(3), Z(4), A(5))                                                         \
    CALL(step, D(0), Z(1))                                                                                             \
    CALL_0(reset)

EVERY_OBJECT(CHAIN, CHAIN_0)
CHAIN(set_mass, D(0))
CHAIN(set_mass_rule, E(mass_rule, 0))
CHAIN(set_stiffness, D(0))
CHAIN(set_bend, D(0))
CHAIN(set_stiffness_damping, D(0))
CHAIN(set_gravity, A(0))
CHAIN(set_end, E(end, 0), E(node, 1))
CHAIN(set_ring, I(0))
CHAIN(set_rest_length, D(0))
CHAIN(set_rest_angle, D(0))
CHAIN(set_push, I(0))
CHAIN(set_sleep, D(0), D(1))
CHAIN(set_strength, D(0))
CHAIN(set_air, D(0), D(1))
CHAIN(set_wind, A(0))
CHAIN(set_tolerance, D(0), Z(1))
CHAIN(set_colliders, Z(0))
CHAIN(set_plane, Z(0), P(1), A(2), D(3))
CHAIN(set_capsule, Z(0), P(1), A(2), D(3), D(4))
CHAIN(set_bed, Z(0), A(1), Z(2), Z(3), D(4), D(5), A(6), D(7))
CHAIN(remove_collider, Z(0))
CHAIN(set_collider_velocity, Z(0), A(1))
CHAIN(set_thickness, D(0))
CHAIN(set_loads, I(0))
CHAIN(impulse, Z(0), Z(1), A(2))
CHAIN(teleport, Z(0), P(1), A(2))
CHAIN(attach, Z(0), Z(1), D(2), D(3), A(4))
CHAIN(detach, Z(0), Z(1))
CHAIN(cut, Z(0), Z(1))
CHAIN(weld, Z(0), Z(1))

EVERY_OBJECT(MEMBRANE, MEMBRANE_0)
MEMBRANE(set_solver, E(solver, 0))
MEMBRANE(set_tolerance, D(0), Z(1))
MEMBRANE(set_mass, D(0))
MEMBRANE(set_mass_rule, E(mass_rule, 0))
MEMBRANE(set_stiffness, D(0), D(1))
MEMBRANE(set_bend, D(0))
MEMBRANE(set_stiffness_damping, D(0))
MEMBRANE(set_gravity, A(0))
MEMBRANE(set_pressure, D(0))
MEMBRANE(set_edge, E(edge, 0), E(node, 1))
MEMBRANE(set_ring, I(0), I(1))
MEMBRANE(set_sleep, D(0), D(1))
MEMBRANE(set_rest_length, D(0), D(1))
MEMBRANE(set_shear, D(0))
MEMBRANE(set_compression, D(0))
MEMBRANE(set_breaking_strain, D(0))
MEMBRANE(set_effort, Z(0), Z(1))
MEMBRANE(set_air, D(0), D(1))
MEMBRANE(set_wind, A(0))
MEMBRANE(set_colliders, Z(0))
MEMBRANE(set_plane, Z(0), P(1), A(2), D(3))
MEMBRANE(set_capsule, Z(0), P(1), A(2), D(3), D(4))
MEMBRANE(set_bed, Z(0), A(1), Z(2), Z(3), D(4), D(5), A(6), D(7))
MEMBRANE(remove_collider, Z(0))
MEMBRANE(set_collider_velocity, Z(0), A(1))
MEMBRANE(set_thickness, D(0))
MEMBRANE(set_loads, I(0))
MEMBRANE(impulse, D(0), D(1), D(2), A(3))
MEMBRANE(teleport, P(0), A(1))
MEMBRANE(attach, Z(0), Z(1), D(2), D(3), A(4))
MEMBRANE(detach, Z(0), Z(1))

EVERY_OBJECT(WATER, WATER_0)
WATER(set_momentum, E(momentum, 0))
WATER(set_first, I(0))
WATER(set_gravity, D(0))
WATER(set_density, D(0))
WATER(set_manning, D(0))
WATER(set_side, E(side, 0), E(border, 1), D(2), D(3))
WATER(set_inflow_depth, E(side, 0), D(1))
WATER(set_bed_rule, E(bed_rule, 0))
WATER(set_sleep, D(0))
WATER(add_volume, D(0), D(1), D(2), D(3) OUT)
WATER(add_volume_rectangle, Z(0), Z(1), Z(2), Z(3), D(4) OUT)
WATER(add_source, D(0), D(1), D(2), D(3))
WATER(add_source_rectangle, Z(0), Z(1), Z(2), Z(3), D(4))
WATER(splash, D(0), D(1), D(2), D(3))
WATER(impulse, D(0), D(1), D(2), D(3), D(4))
WATER(set_hulls, Z(0), Z(1), Z(2))
WATER(set_hull, Z(0), D(1), D(2), D(3), A(4))
WATER(set_disc, Z(0), D(1), D(2))
WATER(remove_hull, Z(0))
WATER(launch_hull, Z(0), D(1), D(2), D(3), D(4))
WATER(set_hull_pose, Z(0), A(1))
WATER(set_hull_velocity, Z(0), A(1))
WATER(set_hull_force, Z(0), A(1))
WATER(set_hull_drag, Z(0), D(1), D(2), D(3))
WATER_0(restart_account)

#undef EVERY_OBJECT
#undef CHAIN
#undef CHAIN_0
#undef MEMBRANE
#undef MEMBRANE_0
#undef WATER
#undef WATER_0
