-- Every method with arguments with which it succeeds, and what getters say after setters.
-- Made by generate.py from ../api.json: do not edit.
local ffi = require("ffi")
return {
  {class = "Chain", sizes = {2, 4, 2}, calls = {
    {name = "cd_chain_get_shape", call = function(o, other, saved)
      return o:get_shape()
    end},
    {name = "cd_chain_set_method", call = function(o, other, saved)
      return o:set_method("implicit")
    end, told = function(o)
      return {o:get_method()}, {"implicit"}
    end},
    {name = "cd_chain_get_method", call = function(o, other, saved)
      return o:get_method()
    end},
    {name = "cd_chain_set_lambda", call = function(o, other, saved)
      return o:set_lambda(0.5)
    end, told = function(o)
      return {o:get_lambda()}, {0.5}
    end},
    {name = "cd_chain_get_lambda", call = function(o, other, saved)
      return o:get_lambda()
    end},
    {name = "cd_chain_set_parallel", call = function(o, other, saved)
      return o:set_parallel(nil)
    end},
    {name = "cd_chain_set_kernels", call = function(o, other, saved)
      return o:set_kernels("plain")
    end, told = function(o)
      return {o:get_kernels()}, {"plain"}
    end},
    {name = "cd_chain_get_kernels", call = function(o, other, saved)
      return o:get_kernels()
    end},
    {name = "cd_chain_set_mass", call = function(o, other, saved)
      return o:set_mass(1)
    end, told = function(o)
      return {o:get_mass()}, {1}
    end},
    {name = "cd_chain_get_mass", call = function(o, other, saved)
      return o:get_mass()
    end},
    {name = "cd_chain_set_mass_rule", call = function(o, other, saved)
      return o:set_mass_rule("equal")
    end, told = function(o)
      return {o:get_mass_rule()}, {"equal"}
    end},
    {name = "cd_chain_get_mass_rule", call = function(o, other, saved)
      return o:get_mass_rule()
    end},
    {name = "cd_chain_set_stiffness", call = function(o, other, saved)
      return o:set_stiffness(1)
    end, told = function(o)
      return {o:get_stiffness()}, {1}
    end},
    {name = "cd_chain_get_stiffness", call = function(o, other, saved)
      return o:get_stiffness()
    end},
    {name = "cd_chain_set_bend", call = function(o, other, saved)
      return o:set_bend(1)
    end, told = function(o)
      return {o:get_bend()}, {1}
    end},
    {name = "cd_chain_get_bend", call = function(o, other, saved)
      return o:get_bend()
    end},
    {name = "cd_chain_set_drag", call = function(o, other, saved)
      return o:set_drag(1)
    end, told = function(o)
      return {o:get_drag()}, {1}
    end},
    {name = "cd_chain_get_drag", call = function(o, other, saved)
      return o:get_drag()
    end},
    {name = "cd_chain_set_stiffness_damping", call = function(o, other, saved)
      return o:set_stiffness_damping(1)
    end, told = function(o)
      return {o:get_stiffness_damping()}, {1}
    end},
    {name = "cd_chain_get_stiffness_damping", call = function(o, other, saved)
      return o:get_stiffness_damping()
    end},
    {name = "cd_chain_set_gravity", call = function(o, other, saved)
      return o:set_gravity({0.0, 0.0})
    end},
    {name = "cd_chain_get_gravity", call = function(o, other, saved)
      return o:get_gravity(nil)
    end},
    {name = "cd_chain_set_end", call = function(o, other, saved)
      return o:set_end("first", "free")
    end, told = function(o)
      return {o:get_end("first")}, {"free"}
    end},
    {name = "cd_chain_get_end", call = function(o, other, saved)
      return o:get_end("first")
    end},
    {name = "cd_chain_set_ring", call = function(o, other, saved)
      return o:set_ring(true)
    end, told = function(o)
      return {o:get_ring()}, {true}
    end},
    {name = "cd_chain_get_ring", call = function(o, other, saved)
      return o:get_ring()
    end},
    {name = "cd_chain_set_sleep", call = function(o, other, saved)
      return o:set_sleep(1, 1)
    end, told = function(o)
      return {o:get_sleep()}, {1, 1}
    end},
    {name = "cd_chain_get_sleep", call = function(o, other, saved)
      return o:get_sleep()
    end},
    {name = "cd_chain_get_awake", call = function(o, other, saved)
      return o:get_awake()
    end},
    {name = "cd_chain_set_rest_length", call = function(o, other, saved)
      return o:set_rest_length(1)
    end, told = function(o)
      return {o:get_rest_length()}, {1}
    end},
    {name = "cd_chain_get_rest_length", call = function(o, other, saved)
      return o:get_rest_length()
    end},
    {name = "cd_chain_set_rest_angle", call = function(o, other, saved)
      return o:set_rest_angle(1)
    end, told = function(o)
      return {o:get_rest_angle()}, {1}
    end},
    {name = "cd_chain_get_rest_angle", call = function(o, other, saved)
      return o:get_rest_angle()
    end},
    {name = "cd_chain_set_push", call = function(o, other, saved)
      return o:set_push(true)
    end, told = function(o)
      return {o:get_push()}, {true}
    end},
    {name = "cd_chain_get_push", call = function(o, other, saved)
      return o:get_push()
    end},
    {name = "cd_chain_set_strength", call = function(o, other, saved)
      return o:set_strength(1)
    end, told = function(o)
      return {o:get_strength()}, {1}
    end},
    {name = "cd_chain_get_strength", call = function(o, other, saved)
      return o:get_strength()
    end},
    {name = "cd_chain_get_broken", call = function(o, other, saved)
      return o:get_broken()
    end},
    {name = "cd_chain_get_reaction", call = function(o, other, saved)
      return o:get_reaction(0, 1, nil)
    end},
    {name = "cd_chain_set_air", call = function(o, other, saved)
      return o:set_air(1, 1)
    end, told = function(o)
      return {o:get_air()}, {1, 1}
    end},
    {name = "cd_chain_get_air", call = function(o, other, saved)
      return o:get_air()
    end},
    {name = "cd_chain_set_wind", call = function(o, other, saved)
      return o:set_wind({0.0, 0.0})
    end},
    {name = "cd_chain_get_wind", call = function(o, other, saved)
      return o:get_wind(nil)
    end},
    {name = "cd_chain_set_tolerance", call = function(o, other, saved)
      return o:set_tolerance(0.01, 1)
    end, told = function(o)
      return {o:get_tolerance()}, {0.01, 1}
    end},
    {name = "cd_chain_get_tolerance", call = function(o, other, saved)
      return o:get_tolerance()
    end},
    {name = "cd_chain_get_convergence", call = function(o, other, saved)
      return o:get_convergence()
    end},
    {name = "cd_chain_set_colliders", call = function(o, other, saved)
      return o:set_colliders(1)
    end, told = function(o)
      return {o:get_colliders()}, {1}
    end},
    {name = "cd_chain_get_colliders", call = function(o, other, saved)
      return o:get_colliders()
    end},
    {name = "cd_chain_set_plane", call = function(o, other, saved)
      return o:set_plane(0, {0.0, 0.0}, {1.0, 0.0}, 1)
    end},
    {name = "cd_chain_set_capsule", call = function(o, other, saved)
      return o:set_capsule(0, {0.0, 0.0}, {0.0, 0.0}, 1, 1)
    end},
    {name = "cd_chain_set_bed", call = function(o, other, saved)
      return o:set_bed(0, {0.0, 0.0}, 4, 1, 1, 1, {0.0, 0.0, 0.0, 0.0}, 1)
    end},
    {name = "cd_chain_get_bed", call = function(o, other, saved)
      return o:get_bed(0, ffi.new("double[?]", 0))
    end},
    {name = "cd_chain_set_callback", may_fail = true, call = function(o, other, saved)
      return o:set_callback(0, nil, {0.0, 0.0}, 1)
    end},
    {name = "cd_chain_remove_collider", call = function(o, other, saved)
      return o:remove_collider(0)
    end},
    {name = "cd_chain_set_collider_velocity", call = function(o, other, saved)
      return o:set_collider_velocity(0, {0.0, 0.0})
    end},
    {name = "cd_chain_get_collider", call = function(o, other, saved)
      return o:get_collider(0, nil, nil, nil)
    end},
    {name = "cd_chain_set_loads", call = function(o, other, saved)
      return o:set_loads(true)
    end, told = function(o)
      return {o:get_loads()}, {true}
    end},
    {name = "cd_chain_get_loads", call = function(o, other, saved)
      return o:get_loads()
    end},
    {name = "cd_chain_get_collider_load", call = function(o, other, saved)
      return o:get_collider_load(0, nil)
    end},
    {name = "cd_chain_set_thickness", call = function(o, other, saved)
      return o:set_thickness(1)
    end, told = function(o)
      return {o:get_thickness()}, {1}
    end},
    {name = "cd_chain_get_thickness", call = function(o, other, saved)
      return o:get_thickness()
    end},
    {name = "cd_chain_enable_field", call = function(o, other, saved)
      return o:enable_field("position")
    end},
    {name = "cd_chain_disable_field", may_fail = true, call = function(o, other, saved)
      return o:disable_field("position")
    end},
    {name = "cd_chain_write_f32", call = function(o, other, saved)
      return o:write_f32("position", 0, 1, 0, 1, {0.0, 0.0})
    end},
    {name = "cd_chain_write_f64", call = function(o, other, saved)
      return o:write_f64("position", 0, 1, 0, 1, {0.0, 0.0})
    end},
    {name = "cd_chain_read_f32", call = function(o, other, saved)
      return o:read_f32("position", 0, 1, 0, 1, nil)
    end},
    {name = "cd_chain_read_f64", call = function(o, other, saved)
      return o:read_f64("position", 0, 1, 0, 1, nil)
    end},
    {name = "cd_chain_view", call = function(o, other, saved)
      return o:view("position")
    end},
    {name = "cd_chain_impulse", call = function(o, other, saved)
      return o:impulse(0, 1, {0.0, 0.0})
    end},
    {name = "cd_chain_teleport", call = function(o, other, saved)
      return o:teleport(0, {1.0, 0.0, 0.0, 1.0}, {0.0, 0.0})
    end},
    {name = "cd_chain_attach", call = function(o, other, saved)
      return o:attach(0, 1, 1, 1, {0.0, 0.0})
    end},
    {name = "cd_chain_detach", call = function(o, other, saved)
      return o:detach(0, 1)
    end},
    {name = "cd_chain_get_attachment", call = function(o, other, saved)
      return o:get_attachment(0, 1)
    end},
    {name = "cd_chain_cut", call = function(o, other, saved)
      return o:cut(0, 1)
    end},
    {name = "cd_chain_weld", call = function(o, other, saved)
      return o:weld(0, 1)
    end},
    {name = "cd_chain_step", call = function(o, other, saved)
      return o:step(0.01, 1)
    end},
    {name = "cd_chain_stable_dt", call = function(o, other, saved)
      return o:stable_dt()
    end},
    {name = "cd_chain_get_time", call = function(o, other, saved)
      return o:get_time()
    end},
    {name = "cd_chain_get_steps", call = function(o, other, saved)
      return o:get_steps()
    end},
    {name = "cd_chain_get_factorizations", call = function(o, other, saved)
      return o:get_factorizations()
    end},
    {name = "cd_chain_get_energy", call = function(o, other, saved)
      return o:get_energy()
    end},
    {name = "cd_chain_get_momentum", call = function(o, other, saved)
      return o:get_momentum(nil)
    end},
    {name = "cd_chain_sample", call = function(o, other, saved)
      return o:sample(0, {0.0}, "refused", nil)
    end},
    {name = "cd_chain_get_memory", call = function(o, other, saved)
      return o:get_memory()
    end},
    {name = "cd_chain_hash", call = function(o, other, saved)
      return o:hash()
    end},
    {name = "cd_chain_save_size", call = function(o, other, saved)
      return o:save_size()
    end},
    {name = "cd_chain_save", call = function(o, other, saved)
      return o:save(ffi.new("uint8_t[?]", 65536))
    end},
    {name = "cd_chain_load", call = function(o, other, saved)
      return o:load(saved)
    end},
    {name = "cd_chain_copy_state", call = function(o, other, saved)
      return o:copy_state(other)
    end},
    {name = "cd_chain_reset", call = function(o, other, saved)
      return o:reset()
    end},
  }},
  {class = "Membrane", sizes = {4, 5, 3}, calls = {
    {name = "cd_membrane_get_shape", call = function(o, other, saved)
      return o:get_shape()
    end},
    {name = "cd_membrane_set_method", call = function(o, other, saved)
      return o:set_method("implicit")
    end, told = function(o)
      return {o:get_method()}, {"implicit"}
    end},
    {name = "cd_membrane_get_method", call = function(o, other, saved)
      return o:get_method()
    end},
    {name = "cd_membrane_set_lambda", call = function(o, other, saved)
      return o:set_lambda(0.5)
    end, told = function(o)
      return {o:get_lambda()}, {0.5}
    end},
    {name = "cd_membrane_get_lambda", call = function(o, other, saved)
      return o:get_lambda()
    end},
    {name = "cd_membrane_set_solver", call = function(o, other, saved)
      return o:set_solver("alternating")
    end, told = function(o)
      return {o:get_solver()}, {"alternating"}
    end},
    {name = "cd_membrane_get_solver", call = function(o, other, saved)
      return o:get_solver()
    end},
    {name = "cd_membrane_get_solver_taken", call = function(o, other, saved)
      return o:get_solver_taken()
    end},
    {name = "cd_membrane_set_tolerance", call = function(o, other, saved)
      return o:set_tolerance(0.01, 1)
    end, told = function(o)
      return {o:get_tolerance()}, {0.01, 1}
    end},
    {name = "cd_membrane_get_tolerance", call = function(o, other, saved)
      return o:get_tolerance()
    end},
    {name = "cd_membrane_get_convergence", call = function(o, other, saved)
      return o:get_convergence()
    end},
    {name = "cd_membrane_set_parallel", call = function(o, other, saved)
      return o:set_parallel(nil)
    end},
    {name = "cd_membrane_set_kernels", call = function(o, other, saved)
      return o:set_kernels("plain")
    end, told = function(o)
      return {o:get_kernels()}, {"plain"}
    end},
    {name = "cd_membrane_get_kernels", call = function(o, other, saved)
      return o:get_kernels()
    end},
    {name = "cd_membrane_set_mass", call = function(o, other, saved)
      return o:set_mass(1)
    end, told = function(o)
      return {o:get_mass()}, {1}
    end},
    {name = "cd_membrane_get_mass", call = function(o, other, saved)
      return o:get_mass()
    end},
    {name = "cd_membrane_set_mass_rule", call = function(o, other, saved)
      return o:set_mass_rule("equal")
    end, told = function(o)
      return {o:get_mass_rule()}, {"equal"}
    end},
    {name = "cd_membrane_get_mass_rule", call = function(o, other, saved)
      return o:get_mass_rule()
    end},
    {name = "cd_membrane_set_stiffness", call = function(o, other, saved)
      return o:set_stiffness(1, 1)
    end, told = function(o)
      return {o:get_stiffness()}, {1, 1}
    end},
    {name = "cd_membrane_get_stiffness", call = function(o, other, saved)
      return o:get_stiffness()
    end},
    {name = "cd_membrane_set_bend", call = function(o, other, saved)
      return o:set_bend(1)
    end, told = function(o)
      return {o:get_bend()}, {1}
    end},
    {name = "cd_membrane_get_bend", call = function(o, other, saved)
      return o:get_bend()
    end},
    {name = "cd_membrane_set_drag", call = function(o, other, saved)
      return o:set_drag(1)
    end, told = function(o)
      return {o:get_drag()}, {1}
    end},
    {name = "cd_membrane_get_drag", call = function(o, other, saved)
      return o:get_drag()
    end},
    {name = "cd_membrane_set_stiffness_damping", call = function(o, other, saved)
      return o:set_stiffness_damping(1)
    end, told = function(o)
      return {o:get_stiffness_damping()}, {1}
    end},
    {name = "cd_membrane_get_stiffness_damping", call = function(o, other, saved)
      return o:get_stiffness_damping()
    end},
    {name = "cd_membrane_set_gravity", call = function(o, other, saved)
      return o:set_gravity({0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_get_gravity", call = function(o, other, saved)
      return o:get_gravity(nil)
    end},
    {name = "cd_membrane_set_pressure", call = function(o, other, saved)
      return o:set_pressure(1)
    end, told = function(o)
      return {o:get_pressure()}, {1}
    end},
    {name = "cd_membrane_get_pressure", call = function(o, other, saved)
      return o:get_pressure()
    end},
    {name = "cd_membrane_set_edge", call = function(o, other, saved)
      return o:set_edge("u_first", "free")
    end, told = function(o)
      return {o:get_edge("u_first")}, {"free"}
    end},
    {name = "cd_membrane_get_edge", call = function(o, other, saved)
      return o:get_edge("u_first")
    end},
    {name = "cd_membrane_set_ring", call = function(o, other, saved)
      return o:set_ring(true, true)
    end, told = function(o)
      return {o:get_ring()}, {true, true}
    end},
    {name = "cd_membrane_get_ring", call = function(o, other, saved)
      return o:get_ring()
    end},
    {name = "cd_membrane_set_sleep", call = function(o, other, saved)
      return o:set_sleep(1, 1)
    end, told = function(o)
      return {o:get_sleep()}, {1, 1}
    end},
    {name = "cd_membrane_get_sleep", call = function(o, other, saved)
      return o:get_sleep()
    end},
    {name = "cd_membrane_get_awake", call = function(o, other, saved)
      return o:get_awake()
    end},
    {name = "cd_membrane_set_rest_length", call = function(o, other, saved)
      return o:set_rest_length(1, 1)
    end, told = function(o)
      return {o:get_rest_length()}, {1, 1}
    end},
    {name = "cd_membrane_get_rest_length", call = function(o, other, saved)
      return o:get_rest_length()
    end},
    {name = "cd_membrane_set_shear", call = function(o, other, saved)
      return o:set_shear(1)
    end, told = function(o)
      return {o:get_shear()}, {1}
    end},
    {name = "cd_membrane_get_shear", call = function(o, other, saved)
      return o:get_shear()
    end},
    {name = "cd_membrane_set_compression", call = function(o, other, saved)
      return o:set_compression(1)
    end, told = function(o)
      return {o:get_compression()}, {1}
    end},
    {name = "cd_membrane_get_compression", call = function(o, other, saved)
      return o:get_compression()
    end},
    {name = "cd_membrane_set_breaking_strain", call = function(o, other, saved)
      return o:set_breaking_strain(1)
    end, told = function(o)
      return {o:get_breaking_strain()}, {1}
    end},
    {name = "cd_membrane_get_breaking_strain", call = function(o, other, saved)
      return o:get_breaking_strain()
    end},
    {name = "cd_membrane_get_broken", call = function(o, other, saved)
      return o:get_broken()
    end},
    {name = "cd_membrane_set_effort", call = function(o, other, saved)
      return o:set_effort(1, 1)
    end, told = function(o)
      return {o:get_effort()}, {1, 1}
    end},
    {name = "cd_membrane_get_effort", call = function(o, other, saved)
      return o:get_effort()
    end},
    {name = "cd_membrane_set_air", call = function(o, other, saved)
      return o:set_air(1, 1)
    end, told = function(o)
      return {o:get_air()}, {1, 1}
    end},
    {name = "cd_membrane_get_air", call = function(o, other, saved)
      return o:get_air()
    end},
    {name = "cd_membrane_set_wind", call = function(o, other, saved)
      return o:set_wind({0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_get_wind", call = function(o, other, saved)
      return o:get_wind(nil)
    end},
    {name = "cd_membrane_set_colliders", call = function(o, other, saved)
      return o:set_colliders(1)
    end, told = function(o)
      return {o:get_colliders()}, {1}
    end},
    {name = "cd_membrane_get_colliders", call = function(o, other, saved)
      return o:get_colliders()
    end},
    {name = "cd_membrane_set_plane", call = function(o, other, saved)
      return o:set_plane(0, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1)
    end},
    {name = "cd_membrane_set_capsule", call = function(o, other, saved)
      return o:set_capsule(0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1, 1)
    end},
    {name = "cd_membrane_set_bed", call = function(o, other, saved)
      return o:set_bed(0, {0.0, 0.0, 0.0}, 2, 2, 1, 1, {0.0, 0.0, 0.0, 0.0}, 1)
    end},
    {name = "cd_membrane_get_bed", call = function(o, other, saved)
      return o:get_bed(0, ffi.new("double[?]", 0))
    end},
    {name = "cd_membrane_set_callback", may_fail = true, call = function(o, other, saved)
      return o:set_callback(0, nil, {0.0, 0.0, 0.0}, 1)
    end},
    {name = "cd_membrane_remove_collider", call = function(o, other, saved)
      return o:remove_collider(0)
    end},
    {name = "cd_membrane_set_collider_velocity", call = function(o, other, saved)
      return o:set_collider_velocity(0, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_get_collider", call = function(o, other, saved)
      return o:get_collider(0, nil, nil, nil)
    end},
    {name = "cd_membrane_set_loads", call = function(o, other, saved)
      return o:set_loads(true)
    end, told = function(o)
      return {o:get_loads()}, {true}
    end},
    {name = "cd_membrane_get_loads", call = function(o, other, saved)
      return o:get_loads()
    end},
    {name = "cd_membrane_get_collider_load", call = function(o, other, saved)
      return o:get_collider_load(0, nil)
    end},
    {name = "cd_membrane_set_thickness", call = function(o, other, saved)
      return o:set_thickness(1)
    end, told = function(o)
      return {o:get_thickness()}, {1}
    end},
    {name = "cd_membrane_get_thickness", call = function(o, other, saved)
      return o:get_thickness()
    end},
    {name = "cd_membrane_enable_field", call = function(o, other, saved)
      return o:enable_field("position")
    end},
    {name = "cd_membrane_disable_field", may_fail = true, call = function(o, other, saved)
      return o:disable_field("position")
    end},
    {name = "cd_membrane_write_f32", call = function(o, other, saved)
      return o:write_f32("position", 0, 0, 1, 1, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_write_f64", call = function(o, other, saved)
      return o:write_f64("position", 0, 0, 1, 1, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_read_f32", call = function(o, other, saved)
      return o:read_f32("position", 0, 0, 1, 1, nil)
    end},
    {name = "cd_membrane_read_f64", call = function(o, other, saved)
      return o:read_f64("position", 0, 0, 1, 1, nil)
    end},
    {name = "cd_membrane_view", call = function(o, other, saved)
      return o:view("position")
    end},
    {name = "cd_membrane_impulse", call = function(o, other, saved)
      return o:impulse(1, 1, 1, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_teleport", call = function(o, other, saved)
      return o:teleport({1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_attach", call = function(o, other, saved)
      return o:attach(1, 1, 1, 1, {0.0, 0.0, 0.0})
    end},
    {name = "cd_membrane_detach", call = function(o, other, saved)
      return o:detach(1, 1)
    end},
    {name = "cd_membrane_get_attachment", call = function(o, other, saved)
      return o:get_attachment(1, 1)
    end},
    {name = "cd_membrane_step", call = function(o, other, saved)
      return o:step(0.01, 1)
    end},
    {name = "cd_membrane_stable_dt", call = function(o, other, saved)
      return o:stable_dt()
    end},
    {name = "cd_membrane_get_time", call = function(o, other, saved)
      return o:get_time()
    end},
    {name = "cd_membrane_get_steps", call = function(o, other, saved)
      return o:get_steps()
    end},
    {name = "cd_membrane_get_factorizations", call = function(o, other, saved)
      return o:get_factorizations()
    end},
    {name = "cd_membrane_get_energy", call = function(o, other, saved)
      return o:get_energy()
    end},
    {name = "cd_membrane_get_momentum", call = function(o, other, saved)
      return o:get_momentum(nil)
    end},
    {name = "cd_membrane_get_reaction", call = function(o, other, saved)
      return o:get_reaction(1, 1, nil)
    end},
    {name = "cd_membrane_get_volume", may_fail = true, call = function(o, other, saved)
      return o:get_volume()
    end},
    {name = "cd_membrane_sample", call = function(o, other, saved)
      return o:sample({0.0, 0.0}, "refused", nil)
    end},
    {name = "cd_membrane_get_memory", call = function(o, other, saved)
      return o:get_memory()
    end},
    {name = "cd_membrane_hash", call = function(o, other, saved)
      return o:hash()
    end},
    {name = "cd_membrane_write_vertices", call = function(o, other, saved)
      return o:write_vertices(ffi.new("uint8_t[?]", 65536), 64, 0, 12)
    end},
    {name = "cd_membrane_get_index_count", call = function(o, other, saved)
      return o:get_index_count()
    end},
    {name = "cd_membrane_write_indices", call = function(o, other, saved)
      return o:write_indices(ffi.new("uint8_t[?]", 65536), 4)
    end},
    {name = "cd_membrane_save_size", call = function(o, other, saved)
      return o:save_size()
    end},
    {name = "cd_membrane_save", call = function(o, other, saved)
      return o:save(ffi.new("uint8_t[?]", 65536))
    end},
    {name = "cd_membrane_load", call = function(o, other, saved)
      return o:load(saved)
    end},
    {name = "cd_membrane_copy_state", call = function(o, other, saved)
      return o:copy_state(other)
    end},
    {name = "cd_membrane_reset", call = function(o, other, saved)
      return o:reset()
    end},
  }},
  {class = "Water", sizes = {5, 4, 1.0, 2.0}, calls = {
    {name = "cd_water_get_shape", call = function(o, other, saved)
      return o:get_shape()
    end},
    {name = "cd_water_set_method", call = function(o, other, saved)
      return o:set_method("implicit")
    end, told = function(o)
      return {o:get_method()}, {"implicit"}
    end},
    {name = "cd_water_get_method", call = function(o, other, saved)
      return o:get_method()
    end},
    {name = "cd_water_set_lambda", call = function(o, other, saved)
      return o:set_lambda(0.5)
    end, told = function(o)
      return {o:get_lambda()}, {0.5}
    end},
    {name = "cd_water_get_lambda", call = function(o, other, saved)
      return o:get_lambda()
    end},
    {name = "cd_water_set_momentum", call = function(o, other, saved)
      return o:set_momentum("linear")
    end, told = function(o)
      return {o:get_momentum()}, {"linear"}
    end},
    {name = "cd_water_get_momentum", call = function(o, other, saved)
      return o:get_momentum()
    end},
    {name = "cd_water_set_first", call = function(o, other, saved)
      return o:set_first(true)
    end, told = function(o)
      return {o:get_first()}, {true}
    end},
    {name = "cd_water_get_first", call = function(o, other, saved)
      return o:get_first()
    end},
    {name = "cd_water_set_parallel", call = function(o, other, saved)
      return o:set_parallel(nil)
    end},
    {name = "cd_water_set_kernels", call = function(o, other, saved)
      return o:set_kernels("plain")
    end, told = function(o)
      return {o:get_kernels()}, {"plain"}
    end},
    {name = "cd_water_get_kernels", call = function(o, other, saved)
      return o:get_kernels()
    end},
    {name = "cd_water_set_gravity", call = function(o, other, saved)
      return o:set_gravity(1)
    end, told = function(o)
      return {o:get_gravity()}, {1}
    end},
    {name = "cd_water_get_gravity", call = function(o, other, saved)
      return o:get_gravity()
    end},
    {name = "cd_water_set_density", call = function(o, other, saved)
      return o:set_density(1)
    end, told = function(o)
      return {o:get_density()}, {1}
    end},
    {name = "cd_water_get_density", call = function(o, other, saved)
      return o:get_density()
    end},
    {name = "cd_water_set_drag", call = function(o, other, saved)
      return o:set_drag(1)
    end, told = function(o)
      return {o:get_drag()}, {1}
    end},
    {name = "cd_water_get_drag", call = function(o, other, saved)
      return o:get_drag()
    end},
    {name = "cd_water_set_manning", call = function(o, other, saved)
      return o:set_manning(1)
    end, told = function(o)
      return {o:get_manning()}, {1}
    end},
    {name = "cd_water_get_manning", call = function(o, other, saved)
      return o:get_manning()
    end},
    {name = "cd_water_set_side", call = function(o, other, saved)
      return o:set_side("x_first", "wall", 1, 1)
    end},
    {name = "cd_water_get_side", call = function(o, other, saved)
      return o:get_side("x_first")
    end},
    {name = "cd_water_set_inflow_depth", call = function(o, other, saved)
      return o:set_inflow_depth("x_first", 1)
    end, told = function(o)
      return {o:get_inflow_depth("x_first")}, {1}
    end},
    {name = "cd_water_get_inflow_depth", call = function(o, other, saved)
      return o:get_inflow_depth("x_first")
    end},
    {name = "cd_water_set_bed_rule", call = function(o, other, saved)
      return o:set_bed_rule("lifts_water")
    end, told = function(o)
      return {o:get_bed_rule()}, {"lifts_water"}
    end},
    {name = "cd_water_get_bed_rule", call = function(o, other, saved)
      return o:get_bed_rule()
    end},
    {name = "cd_water_enable_field", call = function(o, other, saved)
      return o:enable_field("depth")
    end},
    {name = "cd_water_disable_field", may_fail = true, call = function(o, other, saved)
      return o:disable_field("depth")
    end},
    {name = "cd_water_write_f32", call = function(o, other, saved)
      return o:write_f32("depth", 0, 0, 1, 1, {0.0})
    end},
    {name = "cd_water_write_f64", call = function(o, other, saved)
      return o:write_f64("depth", 0, 0, 1, 1, {0.0})
    end},
    {name = "cd_water_read_f32", call = function(o, other, saved)
      return o:read_f32("depth", 0, 0, 1, 1, nil)
    end},
    {name = "cd_water_read_f64", call = function(o, other, saved)
      return o:read_f64("depth", 0, 0, 1, 1, nil)
    end},
    {name = "cd_water_view", call = function(o, other, saved)
      return o:view("depth")
    end},
    {name = "cd_water_add_volume", call = function(o, other, saved)
      return o:add_volume(1, 1, 1, 1)
    end},
    {name = "cd_water_add_volume_rectangle", call = function(o, other, saved)
      return o:add_volume_rectangle(0, 0, 1, 1, 1)
    end},
    {name = "cd_water_add_source", call = function(o, other, saved)
      return o:add_source(1, 1, 1, 1)
    end},
    {name = "cd_water_add_source_rectangle", call = function(o, other, saved)
      return o:add_source_rectangle(0, 0, 1, 1, 1)
    end},
    {name = "cd_water_splash", call = function(o, other, saved)
      return o:splash(1, 1, 1, 0.1)
    end},
    {name = "cd_water_impulse", call = function(o, other, saved)
      return o:impulse(1, 1, 1, 1, 1)
    end},
    {name = "cd_water_set_hulls", call = function(o, other, saved)
      return o:set_hulls(1, 1, 1)
    end, told = function(o)
      return {o:get_hulls()}, {1, 1, 1}
    end},
    {name = "cd_water_get_hulls", call = function(o, other, saved)
      return o:get_hulls()
    end},
    {name = "cd_water_set_hull", call = function(o, other, saved)
      return o:set_hull(0, 1, 1, 1, {0.0})
    end},
    {name = "cd_water_set_disc", call = function(o, other, saved)
      return o:set_disc(0, 1, 1)
    end},
    {name = "cd_water_get_hull", call = function(o, other, saved)
      return o:get_hull(0, ffi.new("double[?]", 1))
    end},
    {name = "cd_water_remove_hull", call = function(o, other, saved)
      return o:remove_hull(0)
    end},
    {name = "cd_water_launch_hull", call = function(o, other, saved)
      return o:launch_hull(0, 1, 1, 1, 1)
    end},
    {name = "cd_water_set_hull_pose", call = function(o, other, saved)
      return o:set_hull_pose(0, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0})
    end},
    {name = "cd_water_get_hull_pose", call = function(o, other, saved)
      return o:get_hull_pose(0, ffi.new("double[?]", 7))
    end},
    {name = "cd_water_set_hull_velocity", call = function(o, other, saved)
      return o:set_hull_velocity(0, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0})
    end},
    {name = "cd_water_get_hull_velocity", call = function(o, other, saved)
      return o:get_hull_velocity(0, ffi.new("double[?]", 6))
    end},
    {name = "cd_water_get_hull_floor", call = function(o, other, saved)
      return o:get_hull_floor(0, ffi.new("double[?]", 7))
    end},
    {name = "cd_water_set_hull_force", call = function(o, other, saved)
      return o:set_hull_force(0, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0})
    end},
    {name = "cd_water_get_hull_force", call = function(o, other, saved)
      return o:get_hull_force(0, ffi.new("double[?]", 6))
    end},
    {name = "cd_water_set_hull_drag", call = function(o, other, saved)
      return o:set_hull_drag(0, 1, 1, 1)
    end, told = function(o)
      return {o:get_hull_drag(0)}, {1, 1, 1}
    end},
    {name = "cd_water_get_hull_drag", call = function(o, other, saved)
      return o:get_hull_drag(0)
    end},
    {name = "cd_water_get_hull_load", call = function(o, other, saved)
      return o:get_hull_load(0, ffi.new("double[?]", 6))
    end},
    {name = "cd_water_get_hull_energy", call = function(o, other, saved)
      return o:get_hull_energy()
    end},
    {name = "cd_water_sample_heads", call = function(o, other, saved)
      return o:sample_heads({0.0, 0.0}, "refused", nil)
    end},
    {name = "cd_water_step", call = function(o, other, saved)
      return o:step(0.01, 1)
    end},
    {name = "cd_water_stable_dt", call = function(o, other, saved)
      return o:stable_dt()
    end},
    {name = "cd_water_get_time", call = function(o, other, saved)
      return o:get_time()
    end},
    {name = "cd_water_get_steps", call = function(o, other, saved)
      return o:get_steps()
    end},
    {name = "cd_water_get_factorizations", call = function(o, other, saved)
      return o:get_factorizations()
    end},
    {name = "cd_water_get_limited", call = function(o, other, saved)
      return o:get_limited()
    end},
    {name = "cd_water_set_sleep", call = function(o, other, saved)
      return o:set_sleep(0.1)
    end, told = function(o)
      return {o:get_sleep()}, {0.1}
    end},
    {name = "cd_water_get_sleep", call = function(o, other, saved)
      return o:get_sleep()
    end},
    {name = "cd_water_get_awake", call = function(o, other, saved)
      return o:get_awake()
    end},
    {name = "cd_water_get_volume", may_fail = true, call = function(o, other, saved)
      return o:get_volume()
    end},
    {name = "cd_water_get_account", call = function(o, other, saved)
      return o:get_account()
    end},
    {name = "cd_water_restart_account", call = function(o, other, saved)
      return o:restart_account()
    end},
    {name = "cd_water_get_energy", call = function(o, other, saved)
      return o:get_energy()
    end},
    {name = "cd_water_get_wet_area", call = function(o, other, saved)
      return o:get_wet_area()
    end},
    {name = "cd_water_get_courant", call = function(o, other, saved)
      return o:get_courant(0.01)
    end},
    {name = "cd_water_sample", call = function(o, other, saved)
      return o:sample({0.0, 0.0}, "refused", nil, nil, nil, nil)
    end},
    {name = "cd_water_get_memory", call = function(o, other, saved)
      return o:get_memory()
    end},
    {name = "cd_water_hash", call = function(o, other, saved)
      return o:hash()
    end},
    {name = "cd_water_write_vertices", call = function(o, other, saved)
      return o:write_vertices(ffi.new("uint8_t[?]", 65536), 64, 0, 12, 24)
    end},
    {name = "cd_water_get_index_count", call = function(o, other, saved)
      return o:get_index_count(false)
    end},
    {name = "cd_water_write_indices", call = function(o, other, saved)
      return o:write_indices(false, ffi.new("uint8_t[?]", 65536), 4)
    end},
    {name = "cd_water_save_size", call = function(o, other, saved)
      return o:save_size()
    end},
    {name = "cd_water_save", call = function(o, other, saved)
      return o:save(ffi.new("uint8_t[?]", 65536))
    end},
    {name = "cd_water_load", call = function(o, other, saved)
      return o:load(saved)
    end},
    {name = "cd_water_copy_state", call = function(o, other, saved)
      return o:copy_state(other)
    end},
    {name = "cd_water_reset", call = function(o, other, saved)
      return o:reset()
    end},
  }},
}
