-- contdyn's functions for LuaJIT. Made by generate.py from ../api.json: do not edit.
local ffi = require("ffi")
local support = require("contdyn.support")
local api = {}

ffi.cdef [[
typedef int32_t cd_status;
typedef int32_t cd_precision;
typedef int32_t cd_method;
typedef int32_t cd_solver;
typedef int32_t cd_mass_rule;
typedef int32_t cd_kernels;
typedef int32_t cd_node;
typedef int32_t cd_shape;
typedef int32_t cd_outside;
typedef int32_t cd_field;
typedef int32_t cd_kind;
typedef int32_t cd_end;
typedef int32_t cd_edge;
typedef int32_t cd_side;
typedef int32_t cd_border;
typedef int32_t cd_momentum;
typedef int32_t cd_bed_rule;
typedef struct cd_chain cd_chain;
typedef struct cd_membrane cd_membrane;
typedef struct cd_water cd_water;
typedef struct cd_allocator { void* user; void* (*allocate)(void* user, size_t size,
    size_t alignment); void (*release)(void* user, void* pointer, size_t size, size_t alignment); } cd_allocator;
typedef struct cd_parallel { void* user; void (*run)(void* user, size_t count, void (*task)(void* context,
    size_t index), void* context); } cd_parallel;
typedef struct cd_distance { void* user; void (*distance)(void* user, double time, size_t count, size_t components,
    const double* positions, double* out_distances, double* out_normals); } cd_distance;
const char* cd_status_name(cd_status status);
const char* cd_error_message(void);
cd_status cd_saved_shape(const void* bytes, size_t size, cd_kind* out_kind, size_t* out_first, size_t* out_second,
    size_t* out_components, cd_precision* out_precision);
uint32_t cd_runnable_kernels(void);
const char* cd_kernels_name(cd_kernels kernels);
uint32_t cd_version(void);
const char* cd_version_string(void);
const char* cd_build_info(void);
cd_status cd_chain_create(size_t strands, size_t springs, size_t components, cd_precision precision,
    const cd_allocator* allocator, cd_chain** out_chain);
void cd_chain_destroy(cd_chain* chain);
cd_status cd_chain_get_shape(const cd_chain* chain, size_t* out_strands, size_t* out_springs, size_t* out_components,
    cd_precision* out_precision);
cd_status cd_chain_set_method(cd_chain* chain, cd_method method);
cd_status cd_chain_get_method(const cd_chain* chain, cd_method* out_method);
cd_status cd_chain_set_lambda(cd_chain* chain, double lambda);
cd_status cd_chain_get_lambda(const cd_chain* chain, double* out_lambda);
cd_status cd_chain_set_parallel(cd_chain* chain, const cd_parallel* parallel);
cd_status cd_chain_set_kernels(cd_chain* chain, cd_kernels kernels);
cd_status cd_chain_get_kernels(const cd_chain* chain, cd_kernels* out_kernels);
cd_status cd_chain_set_mass(cd_chain* chain, double mass);
cd_status cd_chain_get_mass(const cd_chain* chain, double* out_mass);
cd_status cd_chain_set_mass_rule(cd_chain* chain, cd_mass_rule rule);
cd_status cd_chain_get_mass_rule(const cd_chain* chain, cd_mass_rule* out_rule);
cd_status cd_chain_set_stiffness(cd_chain* chain, double stiffness);
cd_status cd_chain_get_stiffness(const cd_chain* chain, double* out_stiffness);
cd_status cd_chain_set_bend(cd_chain* chain, double bend);
cd_status cd_chain_get_bend(const cd_chain* chain, double* out_bend);
cd_status cd_chain_set_drag(cd_chain* chain, double drag);
cd_status cd_chain_get_drag(const cd_chain* chain, double* out_drag);
cd_status cd_chain_set_stiffness_damping(cd_chain* chain, double seconds);
cd_status cd_chain_get_stiffness_damping(const cd_chain* chain, double* out_seconds);
cd_status cd_chain_set_gravity(cd_chain* chain, const double* gravity, size_t count);
cd_status cd_chain_get_gravity(const cd_chain* chain, double* out_gravity, size_t count);
cd_status cd_chain_set_end(cd_chain* chain, cd_end end_, cd_node kind);
cd_status cd_chain_get_end(const cd_chain* chain, cd_end end_, cd_node* out_kind);
cd_status cd_chain_set_ring(cd_chain* chain, int32_t ring);
cd_status cd_chain_get_ring(const cd_chain* chain, int32_t* out_ring);
cd_status cd_chain_set_sleep(cd_chain* chain, double speed, double seconds);
cd_status cd_chain_get_sleep(const cd_chain* chain, double* out_speed, double* out_seconds);
cd_status cd_chain_get_awake(const cd_chain* chain, size_t* out_nodes);
cd_status cd_chain_set_rest_length(cd_chain* chain, double length);
cd_status cd_chain_get_rest_length(const cd_chain* chain, double* out_length);
cd_status cd_chain_set_rest_angle(cd_chain* chain, double angle);
cd_status cd_chain_get_rest_angle(const cd_chain* chain, double* out_angle);
cd_status cd_chain_set_push(cd_chain* chain, int32_t push);
cd_status cd_chain_get_push(const cd_chain* chain, int32_t* out_push);
cd_status cd_chain_set_strength(cd_chain* chain, double strength);
cd_status cd_chain_get_strength(const cd_chain* chain, double* out_strength);
cd_status cd_chain_get_broken(const cd_chain* chain, size_t* out_springs);
cd_status cd_chain_get_reaction(const cd_chain* chain, size_t strand, size_t node, double* out_force, size_t count);
cd_status cd_chain_set_air(cd_chain* chain, double along, double across);
cd_status cd_chain_get_air(const cd_chain* chain, double* out_along, double* out_across);
cd_status cd_chain_set_wind(cd_chain* chain, const double* velocity, size_t count);
cd_status cd_chain_get_wind(const cd_chain* chain, double* out_velocity, size_t count);
cd_status cd_chain_set_tolerance(cd_chain* chain, double tolerance, size_t most_iterations);
cd_status cd_chain_get_tolerance(const cd_chain* chain, double* out_tolerance, size_t* out_most_iterations);
cd_status cd_chain_get_convergence(const cd_chain* chain, size_t* out_iterations, double* out_residual);
cd_status cd_chain_set_colliders(cd_chain* chain, size_t count);
cd_status cd_chain_get_colliders(const cd_chain* chain, size_t* out_count);
cd_status cd_chain_set_plane(cd_chain* chain, size_t index, const double* point, const double* normal, size_t count,
    double friction);
cd_status cd_chain_set_capsule(cd_chain* chain, size_t index, const double* first, const double* last, size_t count,
    double radius, double friction);
cd_status cd_chain_set_bed(cd_chain* chain, size_t index, const double* origin, size_t count, size_t columns,
    size_t rows, double column_spacing, double row_spacing, const double* heights, size_t height_count,
    double friction);
cd_status cd_chain_get_bed(const cd_chain* chain, size_t index, size_t* out_columns, size_t* out_rows,
    double* out_heights, size_t height_count);
cd_status cd_chain_set_callback(cd_chain* chain, size_t index, const cd_distance* distance, const double* origin,
    size_t count, double friction);
cd_status cd_chain_remove_collider(cd_chain* chain, size_t index);
cd_status cd_chain_set_collider_velocity(cd_chain* chain, size_t index, const double* velocity, size_t count);
cd_status cd_chain_get_collider(const cd_chain* chain, size_t index, cd_shape* out_shape, double* out_first,
    double* out_second, double* out_velocity, size_t count, double* out_radius, double* out_friction);
cd_status cd_chain_set_loads(cd_chain* chain, int32_t loads);
cd_status cd_chain_get_loads(const cd_chain* chain, int32_t* out_loads);
cd_status cd_chain_get_collider_load(const cd_chain* chain, size_t index, double* out_load, size_t count);
cd_status cd_chain_set_thickness(cd_chain* chain, double radius);
cd_status cd_chain_get_thickness(const cd_chain* chain, double* out_radius);
cd_status cd_chain_enable_field(cd_chain* chain, cd_field field);
cd_status cd_chain_disable_field(cd_chain* chain, cd_field field);
cd_status cd_chain_write_f32(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
    size_t n, const float* values, size_t count);
cd_status cd_chain_write_f64(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
    size_t n, const double* values, size_t count);
cd_status cd_chain_read_f32(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
    size_t n, float* out_values, size_t count);
cd_status cd_chain_read_f64(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
    size_t n, double* out_values, size_t count);
cd_status cd_chain_view(const cd_chain* chain, cd_field field, const void** out_data, size_t* out_strand_stride,
    size_t* out_node_stride, size_t* out_component_stride);
cd_status cd_chain_impulse(cd_chain* chain, size_t strand, size_t node, const double* impulse, size_t count);
cd_status cd_chain_teleport(cd_chain* chain, size_t strand, const double* rotation, const double* offset, size_t count);
cd_status cd_chain_attach(cd_chain* chain, size_t strand, size_t node, double stiffness, double damping,
    const double* target, size_t count);
cd_status cd_chain_detach(cd_chain* chain, size_t strand, size_t node);
cd_status cd_chain_get_attachment(const cd_chain* chain, size_t strand, size_t node, double* out_stiffness,
    double* out_damping);
cd_status cd_chain_cut(cd_chain* chain, size_t strand, size_t spring);
cd_status cd_chain_weld(cd_chain* chain, size_t strand, size_t spring);
cd_status cd_chain_step(cd_chain* chain, double dt, size_t count);
cd_status cd_chain_stable_dt(const cd_chain* chain, double* out_dt);
cd_status cd_chain_get_time(const cd_chain* chain, double* out_time);
cd_status cd_chain_get_steps(const cd_chain* chain, uint64_t* out_steps);
cd_status cd_chain_get_factorizations(const cd_chain* chain, uint64_t* out_count);
cd_status cd_chain_get_energy(const cd_chain* chain, double* out_kinetic, double* out_elastic, double* out_gravity);
cd_status cd_chain_get_momentum(const cd_chain* chain, double* out_momentum, size_t count);
cd_status cd_chain_sample(const cd_chain* chain, size_t strand, const double* at, size_t n, cd_outside outside,
    double* out_positions, size_t out_count);
cd_status cd_chain_get_memory(const cd_chain* chain, size_t* out_bytes);
cd_status cd_chain_hash(const cd_chain* chain, uint64_t* out_hash);
cd_status cd_chain_save_size(const cd_chain* chain, size_t* out_size);
cd_status cd_chain_save(const cd_chain* chain, void* buffer, size_t size, size_t* out_written);
cd_status cd_chain_load(cd_chain* chain, const void* bytes, size_t size);
cd_status cd_chain_copy_state(cd_chain* chain, const cd_chain* source);
cd_status cd_chain_reset(cd_chain* chain);
cd_status cd_membrane_create(size_t nu, size_t nv, size_t components, cd_precision precision,
    const cd_allocator* allocator, cd_membrane** out_membrane);
void cd_membrane_destroy(cd_membrane* membrane);
cd_status cd_membrane_get_shape(const cd_membrane* membrane, size_t* out_nu, size_t* out_nv, size_t* out_components,
    cd_precision* out_precision);
cd_status cd_membrane_set_method(cd_membrane* membrane, cd_method method);
cd_status cd_membrane_get_method(const cd_membrane* membrane, cd_method* out_method);
cd_status cd_membrane_set_lambda(cd_membrane* membrane, double lambda);
cd_status cd_membrane_get_lambda(const cd_membrane* membrane, double* out_lambda);
cd_status cd_membrane_set_solver(cd_membrane* membrane, cd_solver solver);
cd_status cd_membrane_get_solver(const cd_membrane* membrane, cd_solver* out_solver);
cd_status cd_membrane_get_solver_taken(const cd_membrane* membrane, cd_solver* out_solver);
cd_status cd_membrane_set_tolerance(cd_membrane* membrane, double tolerance, size_t most_iterations);
cd_status cd_membrane_get_tolerance(const cd_membrane* membrane, double* out_tolerance, size_t* out_most_iterations);
cd_status cd_membrane_get_convergence(const cd_membrane* membrane, size_t* out_iterations, double* out_residual);
cd_status cd_membrane_set_parallel(cd_membrane* membrane, const cd_parallel* parallel);
cd_status cd_membrane_set_kernels(cd_membrane* membrane, cd_kernels kernels);
cd_status cd_membrane_get_kernels(const cd_membrane* membrane, cd_kernels* out_kernels);
cd_status cd_membrane_set_mass(cd_membrane* membrane, double mass);
cd_status cd_membrane_get_mass(const cd_membrane* membrane, double* out_mass);
cd_status cd_membrane_set_mass_rule(cd_membrane* membrane, cd_mass_rule rule);
cd_status cd_membrane_get_mass_rule(const cd_membrane* membrane, cd_mass_rule* out_rule);
cd_status cd_membrane_set_stiffness(cd_membrane* membrane, double along_u, double along_v);
cd_status cd_membrane_get_stiffness(const cd_membrane* membrane, double* out_along_u, double* out_along_v);
cd_status cd_membrane_set_bend(cd_membrane* membrane, double bend);
cd_status cd_membrane_get_bend(const cd_membrane* membrane, double* out_bend);
cd_status cd_membrane_set_drag(cd_membrane* membrane, double drag);
cd_status cd_membrane_get_drag(const cd_membrane* membrane, double* out_drag);
cd_status cd_membrane_set_stiffness_damping(cd_membrane* membrane, double seconds);
cd_status cd_membrane_get_stiffness_damping(const cd_membrane* membrane, double* out_seconds);
cd_status cd_membrane_set_gravity(cd_membrane* membrane, const double* gravity, size_t count);
cd_status cd_membrane_get_gravity(const cd_membrane* membrane, double* out_gravity, size_t count);
cd_status cd_membrane_set_pressure(cd_membrane* membrane, double pressure);
cd_status cd_membrane_get_pressure(const cd_membrane* membrane, double* out_pressure);
cd_status cd_membrane_set_edge(cd_membrane* membrane, cd_edge edge, cd_node kind);
cd_status cd_membrane_get_edge(const cd_membrane* membrane, cd_edge edge, cd_node* out_kind);
cd_status cd_membrane_set_ring(cd_membrane* membrane, int32_t along_u, int32_t along_v);
cd_status cd_membrane_get_ring(const cd_membrane* membrane, int32_t* out_along_u, int32_t* out_along_v);
cd_status cd_membrane_set_sleep(cd_membrane* membrane, double speed, double seconds);
cd_status cd_membrane_get_sleep(const cd_membrane* membrane, double* out_speed, double* out_seconds);
cd_status cd_membrane_get_awake(const cd_membrane* membrane, size_t* out_nodes);
cd_status cd_membrane_set_rest_length(cd_membrane* membrane, double along_u, double along_v);
cd_status cd_membrane_get_rest_length(const cd_membrane* membrane, double* out_along_u, double* out_along_v);
cd_status cd_membrane_set_shear(cd_membrane* membrane, double stiffness);
cd_status cd_membrane_get_shear(const cd_membrane* membrane, double* out_stiffness);
cd_status cd_membrane_set_compression(cd_membrane* membrane, double rate);
cd_status cd_membrane_get_compression(const cd_membrane* membrane, double* out_rate);
cd_status cd_membrane_set_breaking_strain(cd_membrane* membrane, double strain);
cd_status cd_membrane_get_breaking_strain(const cd_membrane* membrane, double* out_strain);
cd_status cd_membrane_get_broken(const cd_membrane* membrane, size_t* out_springs);
cd_status cd_membrane_set_effort(cd_membrane* membrane, size_t newton, size_t gradient);
cd_status cd_membrane_get_effort(const cd_membrane* membrane, size_t* out_newton, size_t* out_gradient);
cd_status cd_membrane_set_air(cd_membrane* membrane, double along, double across);
cd_status cd_membrane_get_air(const cd_membrane* membrane, double* out_along, double* out_across);
cd_status cd_membrane_set_wind(cd_membrane* membrane, const double* velocity, size_t count);
cd_status cd_membrane_get_wind(const cd_membrane* membrane, double* out_velocity, size_t count);
cd_status cd_membrane_set_colliders(cd_membrane* membrane, size_t count);
cd_status cd_membrane_get_colliders(const cd_membrane* membrane, size_t* out_count);
cd_status cd_membrane_set_plane(cd_membrane* membrane, size_t index, const double* point, const double* normal,
    size_t count, double friction);
cd_status cd_membrane_set_capsule(cd_membrane* membrane, size_t index, const double* first, const double* last,
    size_t count, double radius, double friction);
cd_status cd_membrane_set_bed(cd_membrane* membrane, size_t index, const double* origin, size_t count, size_t columns,
    size_t rows, double column_spacing, double row_spacing, const double* heights, size_t height_count,
    double friction);
cd_status cd_membrane_get_bed(const cd_membrane* membrane, size_t index, size_t* out_columns, size_t* out_rows,
    double* out_heights, size_t height_count);
cd_status cd_membrane_set_callback(cd_membrane* membrane, size_t index, const cd_distance* distance,
    const double* origin, size_t count, double friction);
cd_status cd_membrane_remove_collider(cd_membrane* membrane, size_t index);
cd_status cd_membrane_set_collider_velocity(cd_membrane* membrane, size_t index, const double* velocity, size_t count);
cd_status cd_membrane_get_collider(const cd_membrane* membrane, size_t index, cd_shape* out_shape, double* out_first,
    double* out_second, double* out_velocity, size_t count, double* out_radius, double* out_friction);
cd_status cd_membrane_set_loads(cd_membrane* membrane, int32_t loads);
cd_status cd_membrane_get_loads(const cd_membrane* membrane, int32_t* out_loads);
cd_status cd_membrane_get_collider_load(const cd_membrane* membrane, size_t index, double* out_load, size_t count);
cd_status cd_membrane_set_thickness(cd_membrane* membrane, double distance);
cd_status cd_membrane_get_thickness(const cd_membrane* membrane, double* out_distance);
cd_status cd_membrane_enable_field(cd_membrane* membrane, cd_field field);
cd_status cd_membrane_disable_field(cd_membrane* membrane, cd_field field);
cd_status cd_membrane_write_f32(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
    size_t n_v, const float* values, size_t count);
cd_status cd_membrane_write_f64(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
    size_t n_v, const double* values, size_t count);
cd_status cd_membrane_read_f32(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
    size_t n_v, float* out_values, size_t count);
cd_status cd_membrane_read_f64(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
    size_t n_v, double* out_values, size_t count);
cd_status cd_membrane_view(const cd_membrane* membrane, cd_field field, const void** out_data, size_t* out_u_stride,
    size_t* out_v_stride, size_t* out_component_stride);
cd_status cd_membrane_impulse(cd_membrane* membrane, double u, double v, double radius, const double* impulse,
    size_t count);
cd_status cd_membrane_teleport(cd_membrane* membrane, const double* rotation, const double* offset, size_t count);
cd_status cd_membrane_attach(cd_membrane* membrane, size_t u, size_t v, double stiffness, double damping,
    const double* target, size_t count);
cd_status cd_membrane_detach(cd_membrane* membrane, size_t u, size_t v);
cd_status cd_membrane_get_attachment(const cd_membrane* membrane, size_t u, size_t v, double* out_stiffness,
    double* out_damping);
cd_status cd_membrane_step(cd_membrane* membrane, double dt, size_t count);
cd_status cd_membrane_stable_dt(const cd_membrane* membrane, double* out_dt);
cd_status cd_membrane_get_time(const cd_membrane* membrane, double* out_time);
cd_status cd_membrane_get_steps(const cd_membrane* membrane, uint64_t* out_steps);
cd_status cd_membrane_get_factorizations(const cd_membrane* membrane, uint64_t* out_count);
cd_status cd_membrane_get_energy(const cd_membrane* membrane, double* out_kinetic, double* out_elastic,
    double* out_gravity);
cd_status cd_membrane_get_momentum(const cd_membrane* membrane, double* out_momentum, size_t count);
cd_status cd_membrane_get_reaction(const cd_membrane* membrane, size_t u, size_t v, double* out_force, size_t count);
cd_status cd_membrane_get_volume(const cd_membrane* membrane, double* out_volume);
cd_status cd_membrane_sample(const cd_membrane* membrane, const double* at, size_t n, cd_outside outside,
    double* out_positions, size_t out_count);
cd_status cd_membrane_get_memory(const cd_membrane* membrane, size_t* out_bytes);
cd_status cd_membrane_hash(const cd_membrane* membrane, uint64_t* out_hash);
cd_status cd_membrane_write_vertices(const cd_membrane* membrane, void* buffer, size_t size, size_t stride,
    size_t position_offset, size_t normal_offset);
cd_status cd_membrane_get_index_count(const cd_membrane* membrane, size_t* out_count);
cd_status cd_membrane_write_indices(const cd_membrane* membrane, void* buffer, size_t size, size_t index_size);
cd_status cd_membrane_save_size(const cd_membrane* membrane, size_t* out_size);
cd_status cd_membrane_save(const cd_membrane* membrane, void* buffer, size_t size, size_t* out_written);
cd_status cd_membrane_load(cd_membrane* membrane, const void* bytes, size_t size);
cd_status cd_membrane_copy_state(cd_membrane* membrane, const cd_membrane* source);
cd_status cd_membrane_reset(cd_membrane* membrane);
cd_status cd_water_create(size_t nx, size_t ny, double dx, double dy, cd_precision precision,
    const cd_allocator* allocator, cd_water** out_water);
void cd_water_destroy(cd_water* water);
cd_status cd_water_get_shape(const cd_water* water, size_t* out_nx, size_t* out_ny, double* out_dx, double* out_dy,
    cd_precision* out_precision);
cd_status cd_water_set_method(cd_water* water, cd_method method);
cd_status cd_water_get_method(const cd_water* water, cd_method* out_method);
cd_status cd_water_set_lambda(cd_water* water, double lambda);
cd_status cd_water_get_lambda(const cd_water* water, double* out_lambda);
cd_status cd_water_set_momentum(cd_water* water, cd_momentum momentum);
cd_status cd_water_get_momentum(const cd_water* water, cd_momentum* out_momentum);
cd_status cd_water_set_first(cd_water* water, int32_t along_y);
cd_status cd_water_get_first(const cd_water* water, int32_t* out_along_y);
cd_status cd_water_set_parallel(cd_water* water, const cd_parallel* parallel);
cd_status cd_water_set_kernels(cd_water* water, cd_kernels kernels);
cd_status cd_water_get_kernels(const cd_water* water, cd_kernels* out_kernels);
cd_status cd_water_set_gravity(cd_water* water, double gravity);
cd_status cd_water_get_gravity(const cd_water* water, double* out_gravity);
cd_status cd_water_set_density(cd_water* water, double density);
cd_status cd_water_get_density(const cd_water* water, double* out_density);
cd_status cd_water_set_drag(cd_water* water, double drag);
cd_status cd_water_get_drag(const cd_water* water, double* out_drag);
cd_status cd_water_set_manning(cd_water* water, double manning);
cd_status cd_water_get_manning(const cd_water* water, double* out_manning);
cd_status cd_water_set_side(cd_water* water, cd_side side, cd_border kind, double value, double rate);
cd_status cd_water_get_side(const cd_water* water, cd_side side, cd_border* out_kind, double* out_value,
    double* out_rate);
cd_status cd_water_set_inflow_depth(cd_water* water, cd_side side, double depth);
cd_status cd_water_get_inflow_depth(const cd_water* water, cd_side side, double* out_depth);
cd_status cd_water_set_bed_rule(cd_water* water, cd_bed_rule rule);
cd_status cd_water_get_bed_rule(const cd_water* water, cd_bed_rule* out_rule);
cd_status cd_water_enable_field(cd_water* water, cd_field field);
cd_status cd_water_disable_field(cd_water* water, cd_field field);
cd_status cd_water_write_f32(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
    const float* values, size_t count);
cd_status cd_water_write_f64(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
    const double* values, size_t count);
cd_status cd_water_read_f32(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
    size_t n_y, float* out_values, size_t count);
cd_status cd_water_read_f64(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
    size_t n_y, double* out_values, size_t count);
cd_status cd_water_view(const cd_water* water, cd_field field, const void** out_data, size_t* out_x_stride,
    size_t* out_y_stride);
cd_status cd_water_add_volume(cd_water* water, double x, double y, double radius, double volume, double* out_added);
cd_status cd_water_add_volume_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
    double volume, double* out_added);
cd_status cd_water_add_source(cd_water* water, double x, double y, double radius, double rate);
cd_status cd_water_add_source_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
    double rate);
cd_status cd_water_splash(cd_water* water, double x, double y, double radius, double height);
cd_status cd_water_impulse(cd_water* water, double x, double y, double radius, double impulse_x, double impulse_y);
cd_status cd_water_set_hulls(cd_water* water, size_t count, size_t n_along, size_t n_across);
cd_status cd_water_get_hulls(const cd_water* water, size_t* out_count, size_t* out_n_along, size_t* out_n_across);
cd_status cd_water_set_hull(cd_water* water, size_t index, double mass, double length, double width,
    const double* heights, size_t count);
cd_status cd_water_set_disc(cd_water* water, size_t index, double mass, double radius);
cd_status cd_water_get_hull(const cd_water* water, size_t index, double* out_mass, double* out_length,
    double* out_width, double* out_area, double* out_heights, size_t count);
cd_status cd_water_remove_hull(cd_water* water, size_t index);
cd_status cd_water_launch_hull(cd_water* water, size_t index, double x, double y, double ahead_x, double ahead_y);
cd_status cd_water_set_hull_pose(cd_water* water, size_t index, const double* pose, size_t count);
cd_status cd_water_get_hull_pose(const cd_water* water, size_t index, double* out_pose, size_t count);
cd_status cd_water_set_hull_velocity(cd_water* water, size_t index, const double* velocity, size_t count);
cd_status cd_water_get_hull_velocity(const cd_water* water, size_t index, double* out_velocity, size_t count);
cd_status cd_water_get_hull_floor(const cd_water* water, size_t index, double* out_pose, size_t count);
cd_status cd_water_set_hull_force(cd_water* water, size_t index, const double* force, size_t count);
cd_status cd_water_get_hull_force(const cd_water* water, size_t index, double* out_force, size_t count);
cd_status cd_water_set_hull_drag(cd_water* water, size_t index, double along, double across, double friction);
cd_status cd_water_get_hull_drag(const cd_water* water, size_t index, double* out_along, double* out_across,
    double* out_friction);
cd_status cd_water_get_hull_load(const cd_water* water, size_t index, double* out_load, size_t count);
cd_status cd_water_get_hull_energy(const cd_water* water, double* out_kinetic, double* out_potential);
cd_status cd_water_sample_heads(const cd_water* water, const double* at, size_t n, cd_outside outside,
    double* out_heads);
cd_status cd_water_step(cd_water* water, double dt, size_t count);
cd_status cd_water_stable_dt(const cd_water* water, double* out_dt);
cd_status cd_water_get_time(const cd_water* water, double* out_time);
cd_status cd_water_get_steps(const cd_water* water, uint64_t* out_steps);
cd_status cd_water_get_factorizations(const cd_water* water, uint64_t* out_count);
cd_status cd_water_get_limited(const cd_water* water, uint64_t* out_cells, double* out_volume);
cd_status cd_water_set_sleep(cd_water* water, double height);
cd_status cd_water_get_sleep(const cd_water* water, double* out_height);
cd_status cd_water_get_awake(const cd_water* water, size_t* out_cells);
cd_status cd_water_get_volume(const cd_water* water, double* out_volume);
cd_status cd_water_get_account(const cd_water* water, double* out_initial, double* out_in, double* out_out,
    double* out_error);
cd_status cd_water_restart_account(cd_water* water);
cd_status cd_water_get_energy(const cd_water* water, double* out_kinetic, double* out_potential);
cd_status cd_water_get_wet_area(const cd_water* water, double* out_area);
cd_status cd_water_get_courant(const cd_water* water, double dt, double* out_courant);
cd_status cd_water_sample(const cd_water* water, const double* at, size_t n, cd_outside outside, double* out_surface,
    double* out_depth, double* out_normal, double* out_velocity);
cd_status cd_water_get_memory(const cd_water* water, size_t* out_bytes);
cd_status cd_water_hash(const cd_water* water, uint64_t* out_hash);
cd_status cd_water_write_vertices(const cd_water* water, void* buffer, size_t size, size_t stride,
    size_t position_offset, size_t normal_offset, size_t depth_offset);
cd_status cd_water_get_index_count(const cd_water* water, int32_t skip_dry, size_t* out_count);
cd_status cd_water_write_indices(const cd_water* water, int32_t skip_dry, void* buffer, size_t size, size_t index_size);
cd_status cd_water_save_size(const cd_water* water, size_t* out_size);
cd_status cd_water_save(const cd_water* water, void* buffer, size_t size, size_t* out_written);
cd_status cd_water_load(cd_water* water, const void* bytes, size_t size);
cd_status cd_water_copy_state(cd_water* water, const cd_water* source);
cd_status cd_water_reset(cd_water* water);
]]

local lib = support.load(0, 2, 0)
local check = support.check
local handle_of = support.handle_of
local number_in = support.number_in
local integer_in = support.integer_in
local flag_in = support.flag_in
local enum_in = support.enum_in
local enum_out = support.enum_out
local array_in = support.array_in
local array_out = support.array_out
local array_result = support.array_result
local bytes_in = support.bytes_in
local bytes_out = support.bytes_out
local string_of = support.string_of
local count_of = support.count_of
local same = support.same
local components_of = support.components_of
local values_of = support.values_of
local cd_bed_rule_1 = ffi.typeof("cd_bed_rule[1]")
local cd_border_1 = ffi.typeof("cd_border[1]")
local cd_kernels_1 = ffi.typeof("cd_kernels[1]")
local cd_kind_1 = ffi.typeof("cd_kind[1]")
local cd_mass_rule_1 = ffi.typeof("cd_mass_rule[1]")
local cd_method_1 = ffi.typeof("cd_method[1]")
local cd_momentum_1 = ffi.typeof("cd_momentum[1]")
local cd_node_1 = ffi.typeof("cd_node[1]")
local cd_precision_1 = ffi.typeof("cd_precision[1]")
local cd_shape_1 = ffi.typeof("cd_shape[1]")
local cd_solver_1 = ffi.typeof("cd_solver[1]")
local double_1 = ffi.typeof("double[1]")
local int32_t_1 = ffi.typeof("int32_t[1]")
local size_t_1 = ffi.typeof("size_t[1]")
local uint64_t_1 = ffi.typeof("uint64_t[1]")
local address_1, strides_4 = ffi.typeof("const void*[1]"), ffi.typeof("size_t[4]")

api["status"] = support.enumeration("cd_status", {
  ["ok"] = 0,
  -- a pointer that may not be null is null
  ["error_null"] = 1,
  -- the handle is of another kind of object
  ["error_handle"] = 2,
  -- a number outside its valid range, or NaN or infinity where it has no meaning
  ["error_value"] = 3,
  -- not one of the enumeration's values
  ["error_enum"] = 4,
  -- an index, a range or a buffer length that does not fit the object
  ["error_range"] = 5,
  -- a size that cannot be represented in memory
  ["error_size"] = 6,
  -- the allocator returned null
  ["error_memory"] = 7,
  -- the field is not switched on: see cd_*_enable_field
  ["error_disabled"] = 8,
  -- what this object cannot do, or what was left out of this build: see cd_build_info
  ["error_unsupported"] = 9,
  -- the state left the finite range during a step, or has not come back to it
  ["error_diverged"] = 10,
  -- the bytes to load are damaged, or of a later version or another kind
  ["error_format"] = 11,
  -- the two objects, or the object and the bytes, differ in shape or precision
  ["error_mismatch"] = 12,
  -- steps were made, but an iterative solve ended short of its tolerance
  ["error_tolerance"] = 13,
  -- steps were made, but a callback gave numbers that it may not
  ["error_callback"] = 14,
})

-- What an object stores its state in; chosen when it is made. Steps compute in double precision whatever it is, but for
-- those that an object's header names.
api["precision"] = support.enumeration("cd_precision", {
  ["float32"] = 0,
  ["float64"] = 1,
})

-- How a step advances the state by dt. CD_METHOD_IMPLICIT is the default, with lambda = 1/2. Bounds hold, and energy is
-- kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the distance that its velocity covers in
-- dt, in a ring or with bend also by 1e-15 of the distance that it would fall in dt, which shows where dt is longer
-- than 1e12 times the time of the fastest swing.
api["method"] = support.enumeration("cd_method", {
  -- Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is backward Euler; for lambda >= 1/2
  -- bounded at every dt
  ["implicit"] = 0,
  -- Kass 1997, eq. 13; without damping it grows at every dt
  ["forward_euler"] = 1,
  -- the new velocity moves the position, of water in its symmetric form (velocity Verlet); bounded up to cd_*_stable_dt
  ["symplectic_euler"] = 2,
  -- two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and L-stable: motion too fast for dt dies
  -- out
  ["stiff_second"] = 3,
})

-- How the two-dimensional system of a membrane's implicit step is solved.
api["solver"] = support.enumeration("cd_solver", {
  -- rows, then columns: Kass 1997, section 9
  ["alternating"] = 0,
  -- both at once, to a tolerance
  ["coupled"] = 1,
  -- the first where that is right for the step, else the second
  ["auto"] = 2,
})

-- How the total mass is dealt out to the nodes.
api["mass_rule"] = support.enumeration("cd_mass_rule", {
  -- every node the same: the notes' rule, first order in space
  ["equal"] = 0,
  -- nodes on a border half as heavy as those inside: second order in space
  ["half_ends"] = 1,
})

-- The instructions that steps are made of. All give the same bits as long as all numbers are finite; how far infinity
-- and NaN spread in steps that end with CD_ERROR_DIVERGED may differ. A new object has the fastest that its processor
-- runs.
api["kernels"] = support.enumeration("cd_kernels", {
  -- what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly SIMD128 where that was
  -- built with -msimd128
  ["plain"] = 0,
  ["avx2"] = 1,
  -- the parts F and DQ of AVX-512
  ["avx512"] = 2,
})

-- What holds a node. The values are also those of the field CD_PIN.
api["node"] = support.enumeration("cd_node", {
  ["free"] = 0,
  -- infinite mass, at rest
  ["pinned"] = 1,
  -- infinite mass, moves with the velocity written to it
  ["driven"] = 2,
  -- border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back
  ["matched"] = 3,
  -- infinite mass; each call of cd_*_step moves it to where CD_TARGET is, evenly, and there it stays until CD_TARGET is
  -- written again. Without that field as CD_NODE_DRIVEN: it stands still where no velocity has been written
  ["posed"] = 4,
})

-- What a collider of ropes and cloth is.
api["shape"] = support.enumeration("cd_shape", {
  ["none"] = 0,
  ["plane"] = 1,
  ["capsule"] = 2,
  ["bed"] = 3,
  ["callback"] = 4,
})

-- What becomes of places outside of an object that it is sampled at.
api["outside"] = support.enumeration("cd_outside", {
  -- CD_ERROR_VALUE, and nothing is told of the other places either
  ["refused"] = 0,
  -- they stand for the nearest place in the object; only NaN is refused
  ["nearest"] = 1,
})

-- Per-node and per-spring data; each object's header lists those that it has. They are in one list, since a field that
-- several objects have means the same in each. All hold numbers, pins and masks too, for one read and one write.
api["field"] = support.enumeration("cd_field", {
  ["position"] = 0,
  ["velocity"] = 1,
  ["force"] = 2,
  ["mass"] = 3,
  ["stiffness"] = 4,
  ["bend"] = 5,
  ["pin"] = 6,
  ["target"] = 7,
  ["stiffness_u"] = 8,
  ["stiffness_v"] = 9,
  ["mask"] = 10,
  ["depth"] = 11,
  ["bed"] = 12,
  ["surface"] = 13,
  ["velocity_x"] = 14,
  ["velocity_y"] = 15,
  ["source"] = 16,
  ["pressure"] = 17,
  ["force_x"] = 18,
  ["force_y"] = 19,
  ["wall_x"] = 20,
  ["wall_y"] = 21,
  ["rest_length"] = 22,
  ["tension"] = 23,
  ["wind"] = 24,
  ["strength"] = 25,
  ["strain"] = 26,
  ["rest_length_u"] = 27,
  ["rest_length_v"] = 28,
  ["tension_u"] = 29,
  ["tension_v"] = 30,
  ["strain_u"] = 31,
  ["strain_v"] = 32,
  ["breaking_strain_u"] = 33,
  ["breaking_strain_v"] = 34,
  ["rest_angle"] = 35,
})

-- The kinds of objects.
api["kind"] = support.enumeration("cd_kind", {
  ["chain"] = 1,
  ["membrane"] = 2,
  ["water"] = 3,
})

-- The two ends of a chain.
api["end"] = support.enumeration("cd_end", {
  ["first"] = 0,
  ["last"] = 1,
})

-- The four edges of a membrane. A corner belongs to two.
api["edge"] = support.enumeration("cd_edge", {
  -- the nodes with u = 0
  ["u_first"] = 0,
  -- u = nu
  ["u_last"] = 1,
  -- v = 0
  ["v_first"] = 2,
  -- v = nv
  ["v_last"] = 3,
})

-- The four sides.
api["side"] = support.enumeration("cd_side", {
  -- x = 0
  ["x_first"] = 0,
  -- x = nx dx
  ["x_last"] = 1,
  -- y = 0
  ["y_first"] = 2,
  -- y = ny dy
  ["y_last"] = 3,
})

-- What is at a side.
api["border"] = support.enumeration("cd_border", {
  ["wall"] = 0,
  -- water of a given level outside, into which waves run without an echo
  ["open"] = 1,
  -- a given discharge comes in; if negative, leaves as far as there is water
  ["inflow"] = 2,
  -- goes on at the opposite side
  ["periodic"] = 3,
  -- holds a given level for what flows out slower than its waves: a lake, a weir
  ["level"] = 4,
})

-- Whether water carries its momentum along.
api["momentum"] = support.enumeration("cd_momentum", {
  ["linear"] = 0,
  ["advected"] = 1,
})

-- What a write to CD_BED leaves as it is.
api["bed_rule"] = support.enumeration("cd_bed_rule", {
  -- the depth: water rides on the bed, volume is kept
  ["lifts_water"] = 0,
  -- the surface of wet cells: the account tells the volume that a write brings or takes
  ["keeps_surface"] = 1,
})

-- Memory from the caller. allocate returns `size` bytes aligned to `alignment` (a power of two, at most 64), or null;
-- release gets back what allocate gave, with the same size and alignment. Both are called only from inside a call on
-- the object, on the caller's thread, never from a step, a read or a write. Copied at create.
function api.allocator(functions)
  return support.callbacks("cd_allocator", {
    allocate = {"void* (*)(void* user, size_t size, size_t alignment)", function(user, size, alignment)
      return functions.allocate(tonumber(size), tonumber(alignment))
    end},
    release = {"void (*)(void* user, void* pointer, size_t size, size_t alignment)", function(user, pointer, size,
        alignment)
      return functions.release(pointer, tonumber(size), tonumber(alignment))
    end},
  })
end

-- Parallel work from the caller. run calls task(context, i) once for every i in [0, count), in any order, on any
-- threads, and returns when all are done. Results do not depend on it, bit for bit, as long as they are finite. Copied
-- when it is set.
function api.parallel(functions)
  return support.callbacks("cd_parallel", {
    run = {"void (*)(void* user, size_t count, void (*task)(void* context, size_t index), void* context)",
        function(user, count, task, context)
      return functions.run(tonumber(count), function(index) return task(context, index) end)
    end},
  })
end

-- A shape from the caller, of a collider of ropes and cloth. distance is given `count` positions, each of `components`
-- numbers and relative to the collider's origin, and the time [s]. To out_distances[i] it writes how far outside of the
-- shape each is [m], less than 0 inside, at most 1e60 in size; to out_normals[i][component] the unit vector along which
-- that distance grows fastest, of a length within 1e-3 of 1. It is called from steps, from any thread of cd_parallel
-- and from several at once. The same position must get the same answer at the same time, whatever others are asked with
-- it, and it may call no function on the object. A shape that moves as a whole should do so by the collider's velocity:
-- one that changes with time by itself is met where it was when the step began. Copied when it is set.
function api.distance(functions)
  return support.callbacks("cd_distance", {
    distance = {"void (*)(void* user, double time, size_t count, size_t components, const double* positions, double* out_distances, double* out_normals)", function(user, time, count, components, positions, out_distances, out_normals)
      return functions.distance(tonumber(time), tonumber(count), tonumber(components), positions, out_distances,
          out_normals)
    end},
  })
end

-- Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none. A static string.
function api.status_name(status)
  return ffi.string(lib.cd_status_name(enum_in("cd_status", status, "cd_status_name", "status")))
end

-- Why the last failed call on this thread failed: the function, the argument, its value, what would be valid. Empty
-- before the first failure; successful calls leave it as it is. The string belongs to the library and stays valid until
-- the next failure on the same thread. The library tells nothing else, and has no hook for messages.
function api.error_message()
  return ffi.string(lib.cd_error_message())
end

-- What cd_*_save made these bytes of: the kind of object, and what its create function has to be given so that it loads
-- them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny; components, of water 1; and the
-- precision. Water's dx and dy, allocators and callbacks may be others. Each output may be null, and is left alone on
-- failure. Errors: CD_ERROR_FORMAT for bytes that are damaged, cut short or of a later version.
function api.saved_shape(bytes)
  local where = "cd_saved_shape"
  local p_bytes, n_bytes = bytes_in(bytes, where, "bytes")
  local size = n_bytes
  local out_kind = cd_kind_1()
  local out_first = size_t_1()
  local out_second = size_t_1()
  local out_components = size_t_1()
  local out_precision = cd_precision_1()
  check(lib.cd_saved_shape(p_bytes, size, out_kind, out_first, out_second, out_components, out_precision))
  return enum_out("cd_kind", out_kind[0]), tonumber(out_first[0]), tonumber(out_second[0]),
      tonumber(out_components[0]), enum_out("cd_precision", out_precision[0])
end

-- The kernels that this build has and this processor runs: the sum of 1 << k for each of them, k a cd_kernels. The
-- largest k is the fastest. CD_KERNELS_PLAIN is always there.
function api.runnable_kernels()
  return tonumber(lib.cd_runnable_kernels())
end

-- The instructions' name, such as "AVX-512"; of CD_KERNELS_PLAIN those that it was built with: "SSE2", "NEON",
-- "SIMD128", or "plain" for one number at a time. "unknown" for a number that is no cd_kernels. A static string.
function api.kernels_name(kernels)
  return ffi.string(lib.cd_kernels_name(enum_in("cd_kernels", kernels, "cd_kernels_name", "kernels")))
end

-- Version of the library that runs: major * 1000000 + minor * 1000 + patch. The macros tell that of the header.
function api.version()
  return tonumber(lib.cd_version())
end

-- The same as text, "0.2.0". A static string.
function api.version_string()
  return ffi.string(lib.cd_version_string())
end

-- Compiler, target, and which objects, features, precisions and kernels this build has, in one line: options of the
-- build leave parts out, and what asks for one that is not there says CD_ERROR_UNSUPPORTED. A static string.
function api.build_info()
  return ffi.string(lib.cd_build_info())
end

-- contdyn: a chain of nodes joined by springs: massive spring, rope, hair, spline.
-- A chain has `springs` springs and nodes = springs + 1 nodes; spring i joins node i to node i + 1. A ring has one
-- spring more, number `springs`, from the last node to the first. A node has 1 to 4 components that never mix. One
-- handle holds one or many strands, each with its own positions, velocities, forces and targets. Strands share masses,
-- stiffnesses, pins and attachments, and so one factorization; only ropes' strands have their own of these too.
-- Energy E = 1/2 sum k_i |x_{i+1} - x_i|^2 + 1/2 sum b_i |x_{i+1} - 2 x_i + x_{i-1}|^2 (Kass 1997, eq. 2 and 5) Motion
-- M x'' + C x' + K x = M g + f, K = the Hessian of E, C = drag M + stiffness_damping K
-- Rest length is zero, unless cd_chain_set_rest_length makes the chain a rope: a free chain draws together, and one
-- stretched evenly is held by its ends. A new chain lies with every node at the origin, at rest, all nodes free, mass
-- 1, stiffness 1, no bend, no gravity, no damping, CD_METHOD_IMPLICIT with lambda 1/2.
-- All computing is done in double precision; CD_FLOAT32 is what positions, velocities, forces and targets are stored
-- in. (Steps of symplectic Euler on uniform chains without damping and forces compute in float32 and are as exact.)
-- Numbers smaller than 2^-80 (float32) or 2^-500 (float64), in those steps velocities, are taken for 0 where a step
-- stores them, so that a scene at rest is never slow. Parameters may be as large as 1e60, masses as small as 1e-60.
-- Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
-- comments name the other errors.
local Chain = support.class("Chain", "cd_chain_destroy")
api.Chain = Chain
Chain._range_alternates = true
Chain._components = 3 -- which result of get_shape
Chain._fields = {
  [0] = {1, 0, 0, 2, 1, 0, true, false},
  [1] = {1, 0, 0, 2, 1, 0, true, false},
  [2] = {1, 0, 0, 2, 1, 0, true, false},
  [7] = {1, 0, 0, 2, 1, 0, true, false},
  [3] = {1, 0, 0, 2, 1, 0, false, true},
  [4] = {1, 0, 0, 2, 0, 1, false, true},
  [5] = {1, 0, 0, 2, 1, 0, false, true},
  [6] = {1, 0, 0, 2, 1, 0, false, true},
  [22] = {1, 0, 0, 2, 0, 1, false, false},
  [23] = {1, 0, 0, 2, 0, 1, false, false},
  [24] = {1, 0, 0, 2, 1, 0, true, false},
  [25] = {1, 0, 0, 2, 0, 1, false, false},
  [35] = {1, 0, 0, 2, 1, 0, false, false},
  [26] = {1, 0, 0, 2, 0, 1, false, false},
}

-- Makes a chain. strands >= 1; springs >= 0 (0: a single node); components 1 to 4. allocator may be null (malloc). The
-- caller owns *out_chain and releases it with cd_chain_destroy; on failure *out_chain is left alone. Errors:
-- CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that this build
-- leaves out.
function Chain.create(strands, springs, components, precision, allocator)
  local where, made = "cd_chain_create", ffi.new("cd_chain*[1]")
  support.check_built(Chain, where)
  if precision == nil then precision = "float64" end
  check(lib.cd_chain_create(integer_in(strands, where, "strands"), integer_in(springs, where, "springs"),
      integer_in(components, where, "components"), enum_in("cd_precision", precision, where, "precision"), allocator,
      made))
  return support.own(Chain, made[0], {allocator = allocator})
end

-- What cd_chain_create was given. Each output may be null.
function Chain:get_shape()
  local where = "cd_chain_get_shape"
  local out_strands = size_t_1()
  local out_springs = size_t_1()
  local out_components = size_t_1()
  local out_precision = cd_precision_1()
  check(lib.cd_chain_get_shape(handle_of(self), out_strands, out_springs, out_components, out_precision))
  return tonumber(out_strands[0]), tonumber(out_springs[0]), tonumber(out_components[0]), enum_out("cd_precision",
      out_precision[0])
end

-- How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
-- CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Chain:set_method(method)
  local where = "cd_chain_set_method"
  method = enum_in("cd_method", method, where, "method")
  self._version = self._version + 1
  check(lib.cd_chain_set_method(handle_of(self), method))
end

-- How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
-- CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Chain:get_method()
  local where = "cd_chain_get_method"
  local out_method = cd_method_1()
  check(lib.cd_chain_get_method(handle_of(self), out_method))
  return enum_out("cd_method", out_method[0])
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.
function Chain:set_lambda(lambda)
  local where = "cd_chain_set_lambda"
  lambda = number_in(lambda, where, "lambda")
  self._version = self._version + 1
  check(lib.cd_chain_set_lambda(handle_of(self), lambda))
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.
function Chain:get_lambda()
  local where = "cd_chain_get_lambda"
  local out_lambda = double_1()
  check(lib.cd_chain_get_lambda(handle_of(self), out_lambda))
  return tonumber(out_lambda[0])
end

-- Spreads the strands of a step over the caller's threads. Null: none. Errors: CD_ERROR_NULL for a table without run.
function Chain:set_parallel(parallel)
  local where = "cd_chain_set_parallel"
  self._version = self._version + 1
  check(lib.cd_chain_set_parallel(handle_of(self), parallel))
  self._kept.parallel = parallel
end

-- The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
-- new chain has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Chain:set_kernels(kernels)
  local where = "cd_chain_set_kernels"
  kernels = enum_in("cd_kernels", kernels, where, "kernels")
  self._version = self._version + 1
  check(lib.cd_chain_set_kernels(handle_of(self), kernels))
end

-- The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
-- new chain has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Chain:get_kernels()
  local where = "cd_chain_get_kernels"
  local out_kernels = cd_kernels_1()
  check(lib.cd_chain_get_kernels(handle_of(self), out_kernels))
  return enum_out("cd_kernels", out_kernels[0])
end

-- Mass [kg], > 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the two ends
-- (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
function Chain:set_mass(mass)
  local where = "cd_chain_set_mass"
  mass = number_in(mass, where, "mass")
  self._version = self._version + 1
  check(lib.cd_chain_set_mass(handle_of(self), mass))
end

-- Mass [kg], > 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the two ends
-- (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
function Chain:get_mass()
  local where = "cd_chain_get_mass"
  local out_mass = double_1()
  check(lib.cd_chain_get_mass(handle_of(self), out_mass))
  return tonumber(out_mass[0])
end

-- Mass [kg], > 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the two ends
-- (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
function Chain:set_mass_rule(rule)
  local where = "cd_chain_set_mass_rule"
  rule = enum_in("cd_mass_rule", rule, where, "rule")
  self._version = self._version + 1
  check(lib.cd_chain_set_mass_rule(handle_of(self), rule))
end

-- Mass [kg], > 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the two ends
-- (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
function Chain:get_mass_rule()
  local where = "cd_chain_get_mass_rule"
  local out_rule = cd_mass_rule_1()
  check(lib.cd_chain_get_mass_rule(handle_of(self), out_rule))
  return enum_out("cd_mass_rule", out_rule[0])
end

-- Stretch stiffness k [N/m], >= 0, of ropes up to INFINITY. Per spring: k times the number of springs. Kass 1997, eq.
-- 7. Waves run along the chain in sqrt(mass / k) seconds.
function Chain:set_stiffness(stiffness)
  local where = "cd_chain_set_stiffness"
  stiffness = number_in(stiffness, where, "stiffness")
  self._version = self._version + 1
  check(lib.cd_chain_set_stiffness(handle_of(self), stiffness))
end

-- Stretch stiffness k [N/m], >= 0, of ropes up to INFINITY. Per spring: k times the number of springs. Kass 1997, eq.
-- 7. Waves run along the chain in sqrt(mass / k) seconds.
function Chain:get_stiffness()
  local where = "cd_chain_get_stiffness"
  local out_stiffness = double_1()
  check(lib.cd_chain_get_stiffness(handle_of(self), out_stiffness))
  return tonumber(out_stiffness[0])
end

-- Bend stiffness b [N/m], >= 0. Per node with two neighbours: b times the cube of the number of springs (Kass 1997, eq.
-- 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a rope bends as a
-- beam of the rigidity E I [N m^2]. Errors: CD_ERROR_MEMORY when bend is switched on.
function Chain:set_bend(bend)
  local where = "cd_chain_set_bend"
  bend = number_in(bend, where, "bend")
  self._version = self._version + 1
  check(lib.cd_chain_set_bend(handle_of(self), bend))
end

-- Bend stiffness b [N/m], >= 0. Per node with two neighbours: b times the cube of the number of springs (Kass 1997, eq.
-- 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a rope bends as a
-- beam of the rigidity E I [N m^2]. Errors: CD_ERROR_MEMORY when bend is switched on.
function Chain:get_bend()
  local where = "cd_chain_get_bend"
  local out_bend = double_1()
  check(lib.cd_chain_get_bend(handle_of(self), out_bend))
  return tonumber(out_bend[0])
end

-- Drag [1/s], >= 0: every node loses velocity at this rate.
function Chain:set_drag(drag)
  local where = "cd_chain_set_drag"
  drag = number_in(drag, where, "drag")
  self._version = self._version + 1
  check(lib.cd_chain_set_drag(handle_of(self), drag))
end

-- Drag [1/s], >= 0: every node loses velocity at this rate.
function Chain:get_drag()
  local where = "cd_chain_get_drag"
  local out_drag = double_1()
  check(lib.cd_chain_get_drag(handle_of(self), out_drag))
  return tonumber(out_drag[0])
end

-- Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
-- amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.
function Chain:set_stiffness_damping(seconds)
  local where = "cd_chain_set_stiffness_damping"
  seconds = number_in(seconds, where, "seconds")
  self._version = self._version + 1
  check(lib.cd_chain_set_stiffness_damping(handle_of(self), seconds))
end

-- Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
-- amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.
function Chain:get_stiffness_damping()
  local where = "cd_chain_get_stiffness_damping"
  local out_seconds = double_1()
  check(lib.cd_chain_get_stiffness_damping(handle_of(self), out_seconds))
  return tonumber(out_seconds[0])
end

-- Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if count
-- is not the number of components.
function Chain:set_gravity(gravity)
  local where = "cd_chain_set_gravity"
  local p_gravity, n_gravity = array_in("double", gravity, where, "gravity")
  local count = count_of(n_gravity, 1, where, "gravity")
  self._version = self._version + 1
  check(lib.cd_chain_set_gravity(handle_of(self), p_gravity, count))
end

-- Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if count
-- is not the number of components.
function Chain:get_gravity(out_gravity)
  local where = "cd_chain_get_gravity"
  local p_out_gravity, n_out_gravity = array_out("double", out_gravity, components_of(self), where, "out_gravity")
  local count = n_out_gravity or 0
  check(lib.cd_chain_get_gravity(handle_of(self), p_out_gravity, count))
  return array_result(out_gravity, p_out_gravity, n_out_gravity)
end

-- What holds an end: the same as writing the field CD_PIN at the first or last node of every strand; the getter tells
-- that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written through
-- CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is: write the next one there. Errors:
-- CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED on a ring; CD_ERROR_DIVERGED for
-- CD_NODE_POSED where the state is not finite.
function Chain:set_end(end_, kind)
  local where = "cd_chain_set_end"
  end_ = enum_in("cd_end", end_, where, "end")
  kind = enum_in("cd_node", kind, where, "kind")
  self._version = self._version + 1
  check(lib.cd_chain_set_end(handle_of(self), end_, kind))
end

-- What holds an end: the same as writing the field CD_PIN at the first or last node of every strand; the getter tells
-- that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written through
-- CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is: write the next one there. Errors:
-- CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED on a ring; CD_ERROR_DIVERGED for
-- CD_NODE_POSED where the state is not finite.
function Chain:get_end(end_)
  local where = "cd_chain_get_end"
  end_ = enum_in("cd_end", end_, where, "end")
  local out_kind = cd_node_1()
  check(lib.cd_chain_get_end(handle_of(self), end_, out_kind))
  return enum_out("cd_node", out_kind[0])
end

-- Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a bend
-- term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value. Needs 3
-- nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding in steps
-- longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for anything but 0 and 1; CD_ERROR_UNSUPPORTED
-- with fewer than 3 nodes or a matched end; CD_ERROR_MEMORY.
function Chain:set_ring(ring)
  local where = "cd_chain_set_ring"
  ring = flag_in(ring, where, "ring")
  self._version = self._version + 1
  check(lib.cd_chain_set_ring(handle_of(self), ring))
end

-- Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a bend
-- term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value. Needs 3
-- nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding in steps
-- longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for anything but 0 and 1; CD_ERROR_UNSUPPORTED
-- with fewer than 3 nodes or a matched end; CD_ERROR_MEMORY.
function Chain:get_ring()
  local where = "cd_chain_get_ring"
  local out_ring = int32_t_1()
  check(lib.cd_chain_get_ring(handle_of(self), out_ring))
  return out_ring[0] ~= 0
end

-- Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by one,
-- others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no step left a free node of it
-- faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost and none gained. Neglected is a mean
-- acceleration of up to 2 speed / seconds: let that be little beside gravity, or what is thrown may stay in the air.
-- speed 0, the default: nothing sleeps, and seconds means nothing and is 0. A plane or capsule that moves wakes what it
-- could touch in the next step; a bed that moves, or a callback, keeps all awake. What changes a strand wakes it, with
-- whatever numbers: a write, an impulse, a teleport, an attachment, a cut; what is set wakes all, but for the hook, the
-- kernels and the tolerance. Who sleeps is part of the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Chain:set_sleep(speed, seconds)
  local where = "cd_chain_set_sleep"
  speed = number_in(speed, where, "speed")
  seconds = number_in(seconds, where, "seconds")
  self._version = self._version + 1
  check(lib.cd_chain_set_sleep(handle_of(self), speed, seconds))
end

-- Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by one,
-- others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no step left a free node of it
-- faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost and none gained. Neglected is a mean
-- acceleration of up to 2 speed / seconds: let that be little beside gravity, or what is thrown may stay in the air.
-- speed 0, the default: nothing sleeps, and seconds means nothing and is 0. A plane or capsule that moves wakes what it
-- could touch in the next step; a bed that moves, or a callback, keeps all awake. What changes a strand wakes it, with
-- whatever numbers: a write, an impulse, a teleport, an attachment, a cut; what is set wakes all, but for the hook, the
-- kernels and the tolerance. Who sleeps is part of the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Chain:get_sleep()
  local where = "cd_chain_get_sleep"
  local out_speed = double_1()
  local out_seconds = double_1()
  check(lib.cd_chain_get_sleep(handle_of(self), out_speed, out_seconds))
  return tonumber(out_speed[0]), tonumber(out_seconds[0])
end

-- How many nodes are awake: those that the next step moves.
function Chain:get_awake()
  local where = "cd_chain_get_awake"
  local out_nodes = size_t_1()
  check(lib.cd_chain_get_awake(handle_of(self), out_nodes))
  return tonumber(out_nodes[0])
end

-- Rest length of a strand [m], 0 or in [1e-60, 1e60]; default 0: no rope. Per spring: length / springs; nodes stay
-- where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands are individuals: each has
-- its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they shared. Length 0
-- switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air, wind and colliders too. Reeled in or paid
-- out a little every step, it is a winch. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 4
-- components or no spring, and for 0 where strands differ in what they would share, or an infinite stiffness would weld
-- all springs or two held nodes.
function Chain:set_rest_length(length)
  local where = "cd_chain_set_rest_length"
  length = number_in(length, where, "length")
  self._version = self._version + 1
  check(lib.cd_chain_set_rest_length(handle_of(self), length))
end

-- Rest length of a strand [m], 0 or in [1e-60, 1e60]; default 0: no rope. Per spring: length / springs; nodes stay
-- where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands are individuals: each has
-- its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they shared. Length 0
-- switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air, wind and colliders too. Reeled in or paid
-- out a little every step, it is a winch. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 4
-- components or no spring, and for 0 where strands differ in what they would share, or an infinite stiffness would weld
-- all springs or two held nodes.
function Chain:get_rest_length()
  local where = "cd_chain_get_rest_length"
  local out_length = double_1()
  check(lib.cd_chain_get_rest_length(handle_of(self), out_length))
  return tonumber(out_length[0])
end

-- Rest angle of a strand [rad], by which its last spring is turned from its first at rest, from the first axis to the
-- second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It is what bend
-- bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles, blades of grass. The
-- field CD_REST_ANGLE has one for each node. Where springs push, a rod takes its shape by turning, else also by going
-- slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a chain that is no rope, or, but for 0, without 2 components:
-- in space a curl needs to know how its links are twisted, which nodes do not tell.
function Chain:set_rest_angle(angle)
  local where = "cd_chain_set_rest_angle"
  angle = number_in(angle, where, "angle")
  self._version = self._version + 1
  check(lib.cd_chain_set_rest_angle(handle_of(self), angle))
end

-- Rest angle of a strand [rad], by which its last spring is turned from its first at rest, from the first axis to the
-- second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It is what bend
-- bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles, blades of grass. The
-- field CD_REST_ANGLE has one for each node. Where springs push, a rod takes its shape by turning, else also by going
-- slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a chain that is no rope, or, but for 0, without 2 components:
-- in space a curl needs to know how its links are twisted, which nodes do not tell.
function Chain:get_rest_angle()
  local where = "cd_chain_get_rest_angle"
  local out_angle = double_1()
  check(lib.cd_chain_get_rest_angle(handle_of(self), out_angle))
  return tonumber(out_angle[0])
end

-- Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
-- Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps: of
-- the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors: CD_ERROR_VALUE.
function Chain:set_push(push)
  local where = "cd_chain_set_push"
  push = flag_in(push, where, "push")
  self._version = self._version + 1
  check(lib.cd_chain_set_push(handle_of(self), push))
end

-- Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
-- Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps: of
-- the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors: CD_ERROR_VALUE.
function Chain:get_push()
  local where = "cd_chain_get_push"
  local out_push = int32_t_1()
  check(lib.cd_chain_get_push(handle_of(self), out_push))
  return out_push[0] ~= 0
end

-- The tension at which a spring breaks [N], 1e-60 to 1e60, or INFINITY, the default: springs hold. A rope's step ends
-- by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension become 0,
-- and the next step shows what the others bear. Where a step ends short of its tolerance and leaves springs of fixed
-- length longer than that allows, as between held nodes that are driven apart, no tension is large enough: then, of the
-- springs between the held nodes on both sides of the longest one, the weakest breaks. Mend a spring by writing
-- CD_STIFFNESS, which a finite strength switches on and keeps on. The field CD_STRENGTH has one for each spring.
-- Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.
function Chain:set_strength(strength)
  local where = "cd_chain_set_strength"
  strength = number_in(strength, where, "strength")
  self._version = self._version + 1
  check(lib.cd_chain_set_strength(handle_of(self), strength))
end

-- The tension at which a spring breaks [N], 1e-60 to 1e60, or INFINITY, the default: springs hold. A rope's step ends
-- by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension become 0,
-- and the next step shows what the others bear. Where a step ends short of its tolerance and leaves springs of fixed
-- length longer than that allows, as between held nodes that are driven apart, no tension is large enough: then, of the
-- springs between the held nodes on both sides of the longest one, the weakest breaks. Mend a spring by writing
-- CD_STIFFNESS, which a finite strength switches on and keeps on. The field CD_STRENGTH has one for each spring.
-- Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.
function Chain:get_strength()
  local where = "cd_chain_get_strength"
  local out_strength = double_1()
  check(lib.cd_chain_get_strength(handle_of(self), out_strength))
  return tonumber(out_strength[0])
end

-- How many springs broke in the last call of cd_chain_step that made steps: those whose CD_STIFFNESS became 0.
function Chain:get_broken()
  local where = "cd_chain_get_broken"
  local out_springs = size_t_1()
  check(lib.cd_chain_get_broken(handle_of(self), out_springs))
  return tonumber(out_springs[0])
end

-- The force [N], one number per component, with which the springs of a rope pull at a node, and its bend: of a held
-- node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along their directions now (0
-- of a spring without length), and of the forces of the bend at the node and at the nodes beside it. After a step that
-- ended short of its tolerance tensions are a guess, 0 or at most the sum of the forces of springs on each node in that
-- step: a rope of fixed length has no tension that holds a driven end which would stretch it. To tie a rope to a body
-- of your own, give the last node its mass, in CD_MASS; or drive an end of a rope of finite stiffness. Where tensions
-- are read, or a strength is set, take lambda = 1. With 1/2 < lambda < 1 they miss up to a third of the pull of hardly
-- yielding springs where nodes swing; with 1/2 those can be twice the mean just after a jolt. With lambda < 1 a load
-- paid out by springs of infinite stiffness is let fall and caught by turns where dt^2 times gravity is less than 5
-- tolerance * length: of 10 kg on 4 m of rope at dt = 1/960 s they are 6 N and 190 N; a smaller tolerance helps.
-- Errors: CD_ERROR_RANGE; CD_ERROR_UNSUPPORTED of a chain that is no rope.
function Chain:get_reaction(strand, node, out_force)
  local where = "cd_chain_get_reaction"
  strand = integer_in(strand, where, "strand")
  node = integer_in(node, where, "node")
  local p_out_force, n_out_force = array_out("double", out_force, components_of(self), where, "out_force")
  local count = n_out_force or 0
  check(lib.cd_chain_get_reaction(handle_of(self), strand, node, p_out_force, count))
  return array_result(out_force, p_out_force, n_out_force)
end

-- Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s whose velocity
-- through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n). Implicit, so
-- that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it would have lambda
-- dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m / dt [N s/m] where its
-- mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6 density d |w_n|, and along a
-- hundredth of that. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.
function Chain:set_air(along, across)
  local where = "cd_chain_set_air"
  along = number_in(along, where, "along")
  across = number_in(across, where, "across")
  self._version = self._version + 1
  check(lib.cd_chain_set_air(handle_of(self), along, across))
end

-- Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s whose velocity
-- through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n). Implicit, so
-- that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it would have lambda
-- dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m / dt [N s/m] where its
-- mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6 density d |w_n|, and along a
-- hundredth of that. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.
function Chain:get_air()
  local where = "cd_chain_get_air"
  local out_along = double_1()
  local out_across = double_1()
  check(lib.cd_chain_get_air(handle_of(self), out_along, out_across))
  return tonumber(out_along[0]), tonumber(out_across[0])
end

-- Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node. Errors:
-- CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set: CD_ERROR_UNSUPPORTED of a chain that is
-- no rope.
function Chain:set_wind(velocity)
  local where = "cd_chain_set_wind"
  local p_velocity, n_velocity = array_in("double", velocity, where, "velocity")
  local count = count_of(n_velocity, 1, where, "velocity")
  self._version = self._version + 1
  check(lib.cd_chain_set_wind(handle_of(self), p_velocity, count))
end

-- Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node. Errors:
-- CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set: CD_ERROR_UNSUPPORTED of a chain that is
-- no rope.
function Chain:get_wind(out_velocity)
  local where = "cd_chain_get_wind"
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, components_of(self), where, "out_velocity")
  local count = n_out_velocity or 0
  check(lib.cd_chain_get_wind(handle_of(self), p_out_velocity, count))
  return array_result(out_velocity, p_out_velocity, n_out_velocity)
end

-- When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its rest
-- length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the fraction s
-- may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In [1e-14, 1/2], default
-- 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one leaves. most_iterations, 1
-- to 10000, default 200, limits the slow and sure method, an interior point, which follows on at most 16 iterations of
-- Newton's; where springs push, it limits Newton's. Errors: CD_ERROR_VALUE.
function Chain:set_tolerance(tolerance, most_iterations)
  local where = "cd_chain_set_tolerance"
  tolerance = number_in(tolerance, where, "tolerance")
  most_iterations = integer_in(most_iterations, where, "most_iterations")
  self._version = self._version + 1
  check(lib.cd_chain_set_tolerance(handle_of(self), tolerance, most_iterations))
end

-- When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its rest
-- length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the fraction s
-- may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In [1e-14, 1/2], default
-- 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one leaves. most_iterations, 1
-- to 10000, default 200, limits the slow and sure method, an interior point, which follows on at most 16 iterations of
-- Newton's; where springs push, it limits Newton's. Errors: CD_ERROR_VALUE.
function Chain:get_tolerance()
  local where = "cd_chain_get_tolerance"
  local out_tolerance = double_1()
  local out_most_iterations = size_t_1()
  check(lib.cd_chain_get_tolerance(handle_of(self), out_tolerance, out_most_iterations))
  return tonumber(out_tolerance[0]), tonumber(out_most_iterations[0])
end

-- What the last call of cd_chain_step did with ropes: the most iterations that a step of a strand took, and the largest
-- error it ended with, as the tolerance counts it, or INFINITY. 0 and 0 without ropes. Each output may be null.
function Chain:get_convergence()
  local where = "cd_chain_get_convergence"
  local out_iterations = size_t_1()
  local out_residual = double_1()
  check(lib.cd_chain_get_convergence(handle_of(self), out_iterations, out_residual))
  return tonumber(out_iterations[0]), tonumber(out_residual[0])
end

-- How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay keep what they are.
-- Rest length 0 takes them away. Errors: CD_ERROR_MEMORY.
function Chain:set_colliders(count)
  local where = "cd_chain_set_colliders"
  count = integer_in(count, where, "count")
  self._version = self._version + 1
  check(lib.cd_chain_set_colliders(handle_of(self), count))
end

-- How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay keep what they are.
-- Rest length 0 takes them away. Errors: CD_ERROR_MEMORY.
function Chain:get_colliders()
  local where = "cd_chain_get_colliders"
  local out_count = size_t_1()
  check(lib.cd_chain_get_colliders(handle_of(self), out_count))
  return tonumber(out_count[0])
end

-- Makes a collider the half space behind the plane through `point` [m] that `normal`, of any length but 0, points out
-- of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's coefficient.
function Chain:set_plane(index, point, normal, friction)
  local where = "cd_chain_set_plane"
  index = integer_in(index, where, "index")
  local p_point, n_point = array_in("double", point, where, "point")
  local p_normal, n_normal = array_in("double", normal, where, "normal")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_point, 1, where, "point")
  same(n_normal, count * 1, where, "normal")
  self._version = self._version + 1
  check(lib.cd_chain_set_plane(handle_of(self), index, p_point, p_normal, count, friction))
end

-- Makes a collider all that is less than `radius` [m], 1e-60 to 1e60, away from the line between two ends: a sphere
-- where they are the same.
function Chain:set_capsule(index, first, last, radius, friction)
  local where = "cd_chain_set_capsule"
  index = integer_in(index, where, "index")
  local p_first, n_first = array_in("double", first, where, "first")
  local p_last, n_last = array_in("double", last, where, "last")
  radius = number_in(radius, where, "radius")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_first, 1, where, "first")
  same(n_last, count * 1, where, "last")
  self._version = self._version + 1
  check(lib.cd_chain_set_capsule(handle_of(self), index, p_first, p_last, count, radius, friction))
end

-- Makes a collider all that lies below a bed of heights [m], at most 1e60 in size, which are copied. The last component
-- is up. With 3 components heights[j * columns + i] is at the first two components origin + (i column_spacing, j
-- row_spacing), of at least 2 columns and rows; with 2 components a single row is along the first one, and row_spacing
-- means nothing. Heights count from the origin's own; spacings [m] are 1e-60 to 1e60. Between heights the bed is
-- bilinear, with creases rounded within a quarter of the spacing either side; beyond the border it goes on at the
-- border's height. How far outside a node is, is its height above the bed times the upward part of the bed's normal. A
-- step meets the bed at the plane that touches it there where it finds the node. What the bed rises above that plane on
-- the node's way the node may end inside of, and the next step takes it out; however fast, none falls through. Errors:
-- CD_ERROR_RANGE too, if height_count is not columns * rows; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 1 component.
function Chain:set_bed(index, origin, columns, rows, column_spacing, row_spacing, heights, friction)
  local where = "cd_chain_set_bed"
  index = integer_in(index, where, "index")
  local p_origin, n_origin = array_in("double", origin, where, "origin")
  columns = integer_in(columns, where, "columns")
  rows = integer_in(rows, where, "rows")
  column_spacing = number_in(column_spacing, where, "column_spacing")
  row_spacing = number_in(row_spacing, where, "row_spacing")
  local p_heights, n_heights = array_in("double", heights, where, "heights")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_origin, 1, where, "origin")
  local height_count = count_of(n_heights, 1, where, "heights")
  self._version = self._version + 1
  check(lib.cd_chain_set_bed(handle_of(self), index, p_origin, count, columns, rows, column_spacing, row_spacing,
      p_heights, height_count, friction))
end

-- Each output may be null; 0 columns and rows of what is no bed. Errors: CD_ERROR_RANGE for an index that no collider
-- has, and, with out_heights, if height_count is not columns * rows.
function Chain:get_bed(index, out_heights)
  local where = "cd_chain_get_bed"
  index = integer_in(index, where, "index")
  local p_out_heights, n_out_heights = array_out("double", out_heights, nil, where, "out_heights")
  local height_count = n_out_heights or 0
  local out_columns = size_t_1()
  local out_rows = size_t_1()
  check(lib.cd_chain_get_bed(handle_of(self), index, out_columns, out_rows, p_out_heights, height_count))
  return tonumber(out_columns[0]), tonumber(out_rows[0]), array_result(out_heights, p_out_heights, n_out_heights)
end

-- Makes a collider the shape that a callback tells the distances of, whose positions are relative to origin [m]. A step
-- asks for all nodes of a strand at once, at its start and then in each iteration where they would end. Where a shape
-- is hollow it is met as beds are. Where an answer is not what cd_distance says, that step takes it for nothing there,
-- and cd_chain_step says CD_ERROR_CALLBACK. The callback itself is no state: after a load, or a copied state, a
-- collider that was CD_SHAPE_CALLBACK before goes on with the one it had, and for any other cd_chain_step says
-- CD_ERROR_UNSUPPORTED until it is set again. origin may be null: a collider that is CD_SHAPE_CALLBACK stays as it is
-- and gets this callback; count and friction mean nothing then. Errors: CD_ERROR_NULL too, for a table without a
-- function; CD_ERROR_MEMORY.
function Chain:set_callback(index, distance, origin, friction)
  local where = "cd_chain_set_callback"
  index = integer_in(index, where, "index")
  local p_origin, n_origin = array_in("double", origin, where, "origin", true)
  friction = number_in(friction, where, "friction")
  local count = count_of(n_origin, 1, where, "origin")
  self._version = self._version + 1
  check(lib.cd_chain_set_callback(handle_of(self), index, distance, p_origin, count, friction))
  self._kept.distance = distance
end

-- Makes a collider CD_SHAPE_NONE, at rest: nothing touches it.
function Chain:remove_collider(index)
  local where = "cd_chain_remove_collider"
  index = integer_in(index, where, "index")
  self._version = self._version + 1
  check(lib.cd_chain_remove_collider(handle_of(self), index))
end

-- Velocity of a collider [m/s], default 0, one number per component, at most 1e60 in size: steps move it, and it
-- carries what it touches along. It keeps its velocity when it is made another shape. A capsule that turns: before each
-- step put it where it will be after it, less dt times its middle's velocity, and give it that: cloth on limbs that
-- swing at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the step begins, 3.5e-2 m.
function Chain:set_collider_velocity(index, velocity)
  local where = "cd_chain_set_collider_velocity"
  index = integer_in(index, where, "index")
  local p_velocity, n_velocity = array_in("double", velocity, where, "velocity")
  local count = count_of(n_velocity, 1, where, "velocity")
  self._version = self._version + 1
  check(lib.cd_chain_set_collider_velocity(handle_of(self), index, p_velocity, count))
end

-- What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule its two ends; of a
-- bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for its velocity. One number per
-- component in each array. Each output may be null. Errors: CD_ERROR_RANGE for an index that no collider has, or a
-- count that is not the number of components.
function Chain:get_collider(index, out_first, out_second, out_velocity)
  local where = "cd_chain_get_collider"
  index = integer_in(index, where, "index")
  local p_out_first, n_out_first = array_out("double", out_first, components_of(self), where, "out_first")
  local p_out_second, n_out_second = array_out("double", out_second, components_of(self), where, "out_second")
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, components_of(self), where, "out_velocity")
  local count = n_out_first or n_out_second or n_out_velocity or 0
  same(n_out_second, count * 1, where, "out_second")
  same(n_out_velocity, count * 1, where, "out_velocity")
  local out_shape = cd_shape_1()
  local out_radius = double_1()
  local out_friction = double_1()
  check(lib.cd_chain_get_collider(handle_of(self), index, out_shape, p_out_first, p_out_second, p_out_velocity, count,
      out_radius, out_friction))
  return enum_out("cd_shape", out_shape[0]), array_result(out_first, p_out_first, n_out_first),
      array_result(out_second, p_out_second, n_out_second), array_result(out_velocity, p_out_velocity, n_out_velocity),
      tonumber(out_radius[0]), tonumber(out_friction[0])
end

-- Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Chain:set_loads(loads)
  local where = "cd_chain_set_loads"
  loads = flag_in(loads, where, "loads")
  self._version = self._version + 1
  check(lib.cd_chain_set_loads(handle_of(self), loads))
end

-- Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Chain:get_loads()
  local where = "cd_chain_get_loads"
  local out_loads = int32_t_1()
  check(lib.cd_chain_get_loads(handle_of(self), out_loads))
  return out_loads[0] ~= 0
end

-- What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean over its time: 6
-- numbers, the force along x, y and z [N] and its moment about the origin [N m]; about a point p it is less by p x
-- force. Momentum of ropes changes by what all else gives, less this, but 0 is told of a strand whose step ended short
-- of its tolerance. What a node forgets of the speed at which it came out of a collider is not given. A strand that
-- sleeps bears as in its last step. 0 before a step. Part of the state. Errors: CD_ERROR_RANGE for index, or if count
-- is not 6; CD_ERROR_DISABLED unless cd_chain_set_loads has asked for it.
function Chain:get_collider_load(index, out_load)
  local where = "cd_chain_get_collider_load"
  index = integer_in(index, where, "index")
  local p_out_load, n_out_load = array_out("double", out_load, 6, where, "out_load")
  local count = n_out_load or 0
  check(lib.cd_chain_get_collider_load(handle_of(self), index, p_out_load, count))
  return array_result(out_load, p_out_load, n_out_load)
end

-- How thick ropes are, as a radius [m] in [0, 1e60], default 0: nodes stay this far outside of colliders.
function Chain:set_thickness(radius)
  local where = "cd_chain_set_thickness"
  radius = number_in(radius, where, "radius")
  self._version = self._version + 1
  check(lib.cd_chain_set_thickness(handle_of(self), radius))
end

-- How thick ropes are, as a radius [m] in [0, 1e60], default 0: nodes stay this far outside of colliders.
function Chain:get_thickness()
  local where = "cd_chain_get_thickness"
  local out_radius = double_1()
  check(lib.cd_chain_get_thickness(handle_of(self), out_radius))
  return tonumber(out_radius[0])
end

-- Switches a field on, filled with the present uniform values (force 0, target the present position). On already:
-- nothing happens. CD_STRENGTH switches CD_STIFFNESS on too. Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED
-- for CD_TARGET where the state is not finite; here and below CD_ERROR_UNSUPPORTED for the fields of ropes of a chain
-- that is none.
function Chain:enable_field(field)
  local where = "cd_chain_enable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_chain_enable_field(handle_of(self), field))
end

-- Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, pin, tension and strain, and for stiffness where springs
-- may break.
function Chain:disable_field(field)
  local where = "cd_chain_disable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_chain_disable_field(handle_of(self), field))
end

-- Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand + strands) and nodes
-- (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
-- have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
-- rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for
-- CD_STRAIN.
function Chain:write_f32(field, first_strand, strands, first, n, values)
  local where = "cd_chain_write_f32"
  field = enum_in("cd_field", field, where, "field")
  first_strand = integer_in(first_strand, where, "first_strand")
  strands = integer_in(strands, where, "strands")
  first = integer_in(first, where, "first")
  n = integer_in(n, where, "n")
  local p_values, n_values = array_in("float", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_chain_write_f32(handle_of(self), field, first_strand, strands, first, n, p_values, count))
end

-- Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand + strands) and nodes
-- (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
-- have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
-- rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for
-- CD_STRAIN.
function Chain:write_f64(field, first_strand, strands, first, n, values)
  local where = "cd_chain_write_f64"
  field = enum_in("cd_field", field, where, "field")
  first_strand = integer_in(first_strand, where, "first_strand")
  strands = integer_in(strands, where, "strands")
  first = integer_in(first, where, "first")
  n = integer_in(n, where, "n")
  local p_values, n_values = array_in("double", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_chain_write_f64(handle_of(self), field, first_strand, strands, first, n, p_values, count))
end

-- Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand + strands) and nodes
-- (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
-- have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
-- rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for
-- CD_STRAIN.
function Chain:read_f32(field, first_strand, strands, first, n, out_values)
  local where = "cd_chain_read_f32"
  field = enum_in("cd_field", field, where, "field")
  first_strand = integer_in(first_strand, where, "first_strand")
  strands = integer_in(strands, where, "strands")
  first = integer_in(first, where, "first")
  n = integer_in(n, where, "n")
  local p_out_values, n_out_values = array_out("float", out_values, strands * n * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_chain_read_f32(handle_of(self), field, first_strand, strands, first, n, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand + strands) and nodes
-- (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
-- have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
-- rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for
-- CD_STRAIN.
function Chain:read_f64(field, first_strand, strands, first, n, out_values)
  local where = "cd_chain_read_f64"
  field = enum_in("cd_field", field, where, "field")
  first_strand = integer_in(first_strand, where, "first_strand")
  strands = integer_in(strands, where, "strands")
  first = integer_in(first, where, "first")
  n = integer_in(n, where, "n")
  local p_out_values, n_out_values = array_out("double", out_values, strands * n * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_chain_read_f64(handle_of(self), field, first_strand, strands, first, n, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Where a field lies in the chain's own memory, in the chain's precision, to read without a copy: the value of (strand,
-- node, component) is at byte *out_data + strand * strand_stride + node * node_stride + component * component_stride.
-- Position, velocity, force and target only. The pointer is good until the field is switched off or the chain released;
-- the numbers change with every write and step. Do not write through it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED,
-- CD_ERROR_UNSUPPORTED.
function Chain:view(field)
  return support.view(self, enum_in("cd_field", field, "cd_chain_view", "field"), function(handle, value)
    local data, strides = address_1(), strides_4()
    check(lib.cd_chain_view(handle, value, data, strides + 0, strides + 1, strides + 2))
    return data[0], strides
  end, 3)
end

-- Adds impulse [N s], one number per component, to a node: its velocity changes by impulse / mass, in a welded group by
-- impulse / the group's mass; a held node takes none. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED.
function Chain:impulse(strand, node, impulse)
  local where = "cd_chain_impulse"
  strand = integer_in(strand, where, "strand")
  node = integer_in(node, where, "node")
  local p_impulse, n_impulse = array_in("double", impulse, where, "impulse")
  local count = count_of(n_impulse, 1, where, "impulse")
  self._version = self._version + 1
  check(lib.cd_chain_impulse(handle_of(self), strand, node, p_impulse, count))
end

-- Moves a strand as a whole, as if it had always been there: every position and target becomes rotation * x + offset,
-- every velocity rotation * v; tensions stay, and colliders stay where they are. rotation: components rows of as many
-- numbers, orthogonal to 1e-6, with rest angles no mirror image; null: none. offset [m]: one number per component,
-- which count counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite.
function Chain:teleport(strand, rotation, offset)
  local where = "cd_chain_teleport"
  strand = integer_in(strand, where, "strand")
  local p_rotation, n_rotation = array_in("double", rotation, where, "rotation", true)
  local p_offset, n_offset = array_in("double", offset, where, "offset")
  local count = count_of(n_offset, 1, where, "offset")
  same(n_rotation, count * count, where, "rotation")
  self._version = self._version + 1
  check(lib.cd_chain_teleport(handle_of(self), strand, p_rotation, p_offset, count))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does. In
-- a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand is
-- tied. target, one number per component, is given to every strand that is tied; null: the present position, and count
-- means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on.
-- Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not
-- finite.
function Chain:attach(strand, node, stiffness, damping, target)
  local where = "cd_chain_attach"
  strand = integer_in(strand, where, "strand")
  node = integer_in(node, where, "node")
  stiffness = number_in(stiffness, where, "stiffness")
  damping = number_in(damping, where, "damping")
  local p_target, n_target = array_in("double", target, where, "target", true)
  local count = count_of(n_target, 1, where, "target")
  self._version = self._version + 1
  check(lib.cd_chain_attach(handle_of(self), strand, node, stiffness, damping, p_target, count))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does. In
-- a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand is
-- tied. target, one number per component, is given to every strand that is tied; null: the present position, and count
-- means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on.
-- Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not
-- finite.
function Chain:detach(strand, node)
  local where = "cd_chain_detach"
  strand = integer_in(strand, where, "strand")
  node = integer_in(node, where, "node")
  self._version = self._version + 1
  check(lib.cd_chain_detach(handle_of(self), strand, node))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does. In
-- a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand is
-- tied. target, one number per component, is given to every strand that is tied; null: the present position, and count
-- means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on.
-- Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not
-- finite.
function Chain:get_attachment(strand, node)
  local where = "cd_chain_get_attachment"
  strand = integer_in(strand, where, "strand")
  node = integer_in(node, where, "node")
  local out_stiffness = double_1()
  local out_damping = double_1()
  check(lib.cd_chain_get_attachment(handle_of(self), strand, node, out_stiffness, out_damping))
  return tonumber(out_stiffness[0]), tonumber(out_damping[0])
end

-- Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no rope
-- `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the mean of
-- theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives that node's
-- velocity. A cut or welded spring gets a stiffness again by writing CD_STIFFNESS. Both switch CD_STIFFNESS on. Bend is
-- not cut with the spring: write CD_BEND. In a rope it is, as long as the stiffness is 0, and welding fixes the
-- spring's length only. Errors: CD_ERROR_RANGE, CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED if it would join two held
-- nodes.
function Chain:cut(strand, spring)
  local where = "cd_chain_cut"
  strand = integer_in(strand, where, "strand")
  spring = integer_in(spring, where, "spring")
  self._version = self._version + 1
  check(lib.cd_chain_cut(handle_of(self), strand, spring))
end

-- Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no rope
-- `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the mean of
-- theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives that node's
-- velocity. A cut or welded spring gets a stiffness again by writing CD_STIFFNESS. Both switch CD_STIFFNESS on. Bend is
-- not cut with the spring: write CD_BEND. In a rope it is, as long as the stiffness is 0, and welding fixes the
-- spring's length only. Errors: CD_ERROR_RANGE, CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED if it would join two held
-- nodes.
function Chain:weld(strand, spring)
  local where = "cd_chain_weld"
  strand = integer_in(strand, where, "strand")
  spring = integer_in(spring, where, "spring")
  self._version = self._version + 1
  check(lib.cd_chain_weld(handle_of(self), strand, spring))
end

-- Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps. Never allocates.
-- Time is proportional to count * strands * nodes * components. Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number
-- leaves the finite range: all steps are made, the message gives the first bad one, the chain can be read, and steps
-- again after cd_chain_reset, a load, or once finite positions and velocities have been written; of ropes
-- CD_ERROR_UNSUPPORTED for what they can't have, CD_ERROR_CALLBACK as cd_chain_set_callback says, and
-- CD_ERROR_TOLERANCE if a step ended short of its tolerance: all steps are made, and good to the error that
-- cd_chain_get_convergence tells, but for tensions: see cd_chain_get_reaction.
function Chain:step(dt, count)
  local where = "cd_chain_step"
  dt = number_in(dt, where, "dt")
  if count == nil then count = 1 end
  count = integer_in(count, where, "count")
  self._version = self._version + 1
  check(lib.cd_chain_step(handle_of(self), dt, count))
end

-- The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded, whatever method is set: the largest dt with 4 M - 2
-- dt C - dt^2 K positive definite. Exact for stretch with drag and stiffness damping; with bend a lower bound, exact in
-- the limit of many nodes; with matched ends and attachment damping a lower bound, and close. INFINITY if nothing can
-- swing. Errors: CD_ERROR_UNSUPPORTED of ropes.
function Chain:stable_dt()
  local where = "cd_chain_stable_dt"
  local out_dt = double_1()
  check(lib.cd_chain_stable_dt(handle_of(self), out_dt))
  return tonumber(out_dt[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Chain:get_time()
  local where = "cd_chain_get_time"
  local out_time = double_1()
  check(lib.cd_chain_get_time(handle_of(self), out_time))
  return tonumber(out_time[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Chain:get_steps()
  local where = "cd_chain_get_steps"
  local out_steps = uint64_t_1()
  check(lib.cd_chain_get_steps(handle_of(self), out_steps))
  return out_steps[0]
end

-- How many factorizations the chain has made: one at the first implicit step and one at the first after each change of
-- dt, lambda, method or a parameter. Ropes make none. Not part of the saved state.
function Chain:get_factorizations()
  local where = "cd_chain_get_factorizations"
  local out_count = uint64_t_1()
  check(lib.cd_chain_get_factorizations(handle_of(self), out_count))
  return out_count[0]
end

-- Energies of all strands together [J]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend and
-- attachments; a welded spring holds none. Gravity: -sum m g x of the free nodes. Undamped, lambda = 1/2 keeps their
-- sum, of ropes but for what is told of them.
function Chain:get_energy()
  local where = "cd_chain_get_energy"
  local out_kinetic = double_1()
  local out_elastic = double_1()
  local out_gravity = double_1()
  check(lib.cd_chain_get_energy(handle_of(self), out_kinetic, out_elastic, out_gravity))
  return tonumber(out_kinetic[0]), tonumber(out_elastic[0]), tonumber(out_gravity[0])
end

-- Momentum of the free nodes of all strands together [kg m/s], one number per component. Errors: CD_ERROR_RANGE if
-- count is not the number of components.
function Chain:get_momentum(out_momentum)
  local where = "cd_chain_get_momentum"
  local p_out_momentum, n_out_momentum = array_out("double", out_momentum, components_of(self), where, "out_momentum")
  local count = n_out_momentum or 0
  check(lib.cd_chain_get_momentum(handle_of(self), p_out_momentum, count))
  return array_result(out_momentum, p_out_momentum, n_out_momentum)
end

-- Positions of one strand at places along it, linear between nodes: at[j] in [0, springs] (ring: to springs + 1),
-- out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE if there is no such strand or
-- out_count is another number; CD_ERROR_ENUM; CD_ERROR_VALUE for a place beyond the strand.
function Chain:sample(strand, at, outside, out_positions)
  local where = "cd_chain_sample"
  strand = integer_in(strand, where, "strand")
  local p_at, n_at = array_in("double", at, where, "at")
  if outside == nil then outside = "refused" end
  outside = enum_in("cd_outside", outside, where, "outside")
  local n = count_of(n_at, 1, where, "at")
  local p_out_positions, n_out_positions = array_out("double", out_positions, n * components_of(self), where,
      "out_positions")
  local out_count = n_out_positions or 0
  check(lib.cd_chain_sample(handle_of(self), strand, p_at, n, outside, p_out_positions, out_count))
  return array_result(out_positions, p_out_positions, n_out_positions)
end

-- Bytes the chain holds from its allocator.
function Chain:get_memory()
  local where = "cd_chain_get_memory"
  local out_bytes = size_t_1()
  check(lib.cd_chain_get_memory(handle_of(self), out_bytes))
  return tonumber(out_bytes[0])
end

-- A 64-bit hash of everything cd_chain_save would write. Equal on every machine, compiler and vector width.
function Chain:hash()
  local where = "cd_chain_hash"
  local out_hash = uint64_t_1()
  check(lib.cd_chain_hash(handle_of(self), out_hash))
  return out_hash[0]
end

-- The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-endian
-- on every machine, versioned, with a checksum. save needs size >= cd_chain_save_size and tells what it wrote. load
-- needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are damaged,
-- cut short, of a later version or another kind are refused and change nothing. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Chain:save_size()
  local where = "cd_chain_save_size"
  local out_size = size_t_1()
  check(lib.cd_chain_save_size(handle_of(self), out_size))
  return tonumber(out_size[0])
end

-- The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-endian
-- on every machine, versioned, with a checksum. save needs size >= cd_chain_save_size and tells what it wrote. load
-- needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are damaged,
-- cut short, of a later version or another kind are refused and change nothing. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Chain:save(buffer)
  local where = "cd_chain_save"
  local p_buffer, n_buffer = bytes_out(buffer, self:save_size(), where, "buffer")
  local size = n_buffer
  local out_written = size_t_1()
  check(lib.cd_chain_save(handle_of(self), p_buffer, size, out_written))
  if buffer == nil then return string_of(p_buffer, tonumber(out_written[0])) end
  return tonumber(out_written[0])
end

-- The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-endian
-- on every machine, versioned, with a checksum. save needs size >= cd_chain_save_size and tells what it wrote. load
-- needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are damaged,
-- cut short, of a later version or another kind are refused and change nothing. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Chain:load(bytes)
  local where = "cd_chain_load"
  local p_bytes, n_bytes = bytes_in(bytes, where, "bytes")
  local size = n_bytes
  self._version = self._version + 1
  check(lib.cd_chain_load(handle_of(self), p_bytes, size))
end

-- Makes `chain` what `source` is, as save and load would, without the bytes: the two must agree in shape and precision.
-- Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Chain:copy_state(source)
  local where = "cd_chain_copy_state"
  self._version = self._version + 1
  check(lib.cd_chain_copy_state(handle_of(self), handle_of(source)))
end

-- Positions, velocities, tensions, time and steps back to 0. Parameters, fields and pins stay; targets too.
function Chain:reset()
  local where = "cd_chain_reset"
  self._version = self._version + 1
  check(lib.cd_chain_reset(handle_of(self)))
end

-- contdyn: a membrane: nodes joined by springs in two directions: drum, balloon, plate, and with rest lengths cloth.
-- A membrane has `nu` springs along u and `nv` along v, and (nu + 1) (nv + 1) nodes; node (u, v) has the number v (nu +
-- 1) + u wherever nodes are listed. A node has 1 to 4 components that never mix. A direction can be closed to a ring:
-- its last nodes are then joined to the first by one spring more.
-- Energy E = 1/2 sum k_u |x_{u+1,v} - x_{u,v}|^2 + 1/2 sum k_v |x_{u,v+1} - x_{u,v}|^2 + 1/2 sum b (|x_uu|^2 + 2
-- |x_uv|^2 + |x_vv|^2) (Kass 1997, section 8; the thin plate's energy) Motion M x'' + C x' + K x = M g + f + pressure
-- along the normal, K = the Hessian of E, C = drag M + stiffness_damping K
-- Rest length is zero, unless cd_membrane_set_rest_length makes the membrane cloth: a free sheet draws together, and
-- one stretched evenly is held by its edges. A new membrane lies at the origin, at rest, all nodes free, mass 1,
-- stiffness 1 both ways, no bend, gravity and damping, CD_METHOD_IMPLICIT with lambda 1/2, CD_SOLVER_AUTO.
-- Which solver? An implicit step of a sheet without rest lengths has a two-dimensional system to solve, here with h =
-- lambda dt. Leave that to CD_SOLVER_AUTO, or take CD_SOLVER_ALTERNATING for a fixed cost and less memory. A sheet is
-- uniform here if its masses and stiffnesses are the totals dealt out and no node is absent; if nothing holds it but
-- whole rows and columns and at most 16 single nodes, held or attached, these while h (h + damping) (2 k + 16 b) is at
-- most 1e4 times a node's mass; and if with bend each direction is held at both edges or a ring, not both a ring.
-- CD_SOLVER_ALTERNATING rows, then columns (Kass 1997, section 9). Uniform sheets are stable at any stiffness and any
-- dt that stays the same. A motion of the angular frequencies w_u and w_v along the two directions is slowed down as if
-- it were 1 + (w_u h)^2 (w_v h)^2 times as heavy; where the sheet comes to rest does not depend on dt. Other sheets, a
-- plate that is a ring both ways among them, would blow up: their step, not quite linear and at six times the cost, is
-- the best, in energy, of sums of the lines' answers, the velocity and common motion. It leaves slow motions anywhere
-- where fast ones have energy: a plate with a hole was off by all that it swung. CD_SOLVER_COUPLED the system itself,
-- to a tolerance, by conjugate gradients: nothing is slowed down. Uniform sheets without bend and rings take one or two
-- iterations of some ten alternating solves each, others multigrid, 4 to 100 times the cost. It comes to rest where
-- alternating does. Take it where stiff sheets must move in time, or stiff parts against each other: alternating finds
-- only their common motion. It needs many iterations where springs or masses vary at random by decades, plates with
-- free edges hardly stretch or many nodes are tied. CD_SOLVER_AUTO of uniform sheets, for each dt, alternating where
-- the slowest motion (half a wave along each direction, round a ring a whole one, with the kinks at held or attached
-- nodes) is made at most 5% heavier. Else coupled; and so, until cd_membrane_reset, uniform sheets that have been
-- coupled once, whose steps have differed in dt, method, lambda, damping or solver, or of which moving nodes were
-- pinned. At that bound a kick of one of 33 x 33 nodes goes 31 times as far as it should, of a radius of an eighth of
-- the sheet 3.5, of a quarter 1.4. It holds some 300 bytes a node; alternating takes 36 where edges hold it. Builds
-- without coupled solver alternate. Steps are of second order in time, those of alternating plates with stiffness
-- damping of first. Without rest lengths: Energy: lambda = 1/2 keeps it, and lambda > 1/2 never adds any, whatever the
-- tolerance of coupled solves. Momentum: of a free sheet, and of each part of a torn one, it is kept however stiff they
-- are; alternating, up to a stiffness of 1e19 mass / h^2 of uniform sheets, and a bend of 1e13 mass / h^2 of plates
-- with one ring. Unlike steps: alternating, the energy that a uniform sheet keeps counts the extra mass, which depends
-- on dt, lambda and damping. If these keep changing it grows without bound: with lambda = 1/2 or CD_METHOD_STIFF_SECOND
-- by up to an eighth a step where 16 and 17 ms take turns, with lambda = 1 by a quarter where some steps are twice as
-- long. CD_FLOAT32: alternating, the rounding of a velocity is a kick whose energy is so many times larger as the
-- motion is heavier: where (w_u h) (w_v h) is beyond 1e4, take CD_FLOAT64 or the coupled solver.
-- CD_METHOD_STIFF_SECOND: adds no energy where coupled solves meet the default tolerance; a step that ended short of
-- its own has added a third, one that alternates on a sheet that is not uniform a twentieth. What chain.h says of
-- precision and of numbers that are too small holds for sheets too. Parameters may be as large as 1e60, masses as small
-- as 1e-60. Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind;
-- the comments name the other errors. Functions that the chain has too mean the same here.
local Membrane = support.class("Membrane", "cd_membrane_destroy")
api.Membrane = Membrane
Membrane._range_alternates = false
Membrane._components = 3 -- which result of get_shape
Membrane._fields = {
  [0] = {1, 1, 0, 2, 1, 0, true, false},
  [1] = {1, 1, 0, 2, 1, 0, true, false},
  [2] = {1, 1, 0, 2, 1, 0, true, false},
  [7] = {1, 1, 0, 2, 1, 0, true, false},
  [3] = {1, 1, 0, 2, 1, 0, false, false},
  [8] = {1, 0, 1, 2, 1, 0, false, false},
  [9] = {1, 1, 0, 2, 0, 2, false, false},
  [6] = {1, 1, 0, 2, 1, 0, false, false},
  [10] = {1, 1, 0, 2, 1, 0, false, false},
  [27] = {1, 0, 1, 2, 1, 0, false, false},
  [28] = {1, 1, 0, 2, 0, 2, false, false},
  [33] = {1, 0, 1, 2, 1, 0, false, false},
  [34] = {1, 1, 0, 2, 0, 2, false, false},
  [24] = {1, 1, 0, 2, 1, 0, true, false},
  [29] = {1, 0, 1, 2, 1, 0, false, false},
  [30] = {1, 1, 0, 2, 0, 2, false, false},
  [31] = {1, 0, 1, 2, 1, 0, false, false},
  [32] = {1, 1, 0, 2, 0, 2, false, false},
}

-- Makes a membrane. nu, nv >= 0 (0: a single row or column of nodes); components 1 to 4. allocator may be null
-- (malloc). The caller owns *out_membrane and releases it with cd_membrane_destroy; on failure *out_membrane is left
-- alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision
-- that this build leaves out.
function Membrane.create(nu, nv, components, precision, allocator)
  local where, made = "cd_membrane_create", ffi.new("cd_membrane*[1]")
  support.check_built(Membrane, where)
  if precision == nil then precision = "float64" end
  check(lib.cd_membrane_create(integer_in(nu, where, "nu"), integer_in(nv, where, "nv"), integer_in(components, where,
      "components"), enum_in("cd_precision", precision, where, "precision"), allocator, made))
  return support.own(Membrane, made[0], {allocator = allocator})
end

-- What cd_membrane_create was given. Each output may be null.
function Membrane:get_shape()
  local where = "cd_membrane_get_shape"
  local out_nu = size_t_1()
  local out_nv = size_t_1()
  local out_components = size_t_1()
  local out_precision = cd_precision_1()
  check(lib.cd_membrane_get_shape(handle_of(self), out_nu, out_nv, out_components, out_precision))
  return tonumber(out_nu[0]), tonumber(out_nv[0]), tonumber(out_components[0]), enum_out("cd_precision",
      out_precision[0])
end

-- How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Membrane:set_method(method)
  local where = "cd_membrane_set_method"
  method = enum_in("cd_method", method, where, "method")
  self._version = self._version + 1
  check(lib.cd_membrane_set_method(handle_of(self), method))
end

-- How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Membrane:get_method()
  local where = "cd_membrane_get_method"
  local out_method = cd_method_1()
  check(lib.cd_membrane_get_method(handle_of(self), out_method))
  return enum_out("cd_method", out_method[0])
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.
function Membrane:set_lambda(lambda)
  local where = "cd_membrane_set_lambda"
  lambda = number_in(lambda, where, "lambda")
  self._version = self._version + 1
  check(lib.cd_membrane_set_lambda(handle_of(self), lambda))
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.
function Membrane:get_lambda()
  local where = "cd_membrane_get_lambda"
  local out_lambda = double_1()
  check(lib.cd_membrane_get_lambda(handle_of(self), out_lambda))
  return tonumber(out_lambda[0])
end

-- How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Membrane:set_solver(solver)
  local where = "cd_membrane_set_solver"
  solver = enum_in("cd_solver", solver, where, "solver")
  self._version = self._version + 1
  check(lib.cd_membrane_set_solver(handle_of(self), solver))
end

-- How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Membrane:get_solver()
  local where = "cd_membrane_get_solver"
  local out_solver = cd_solver_1()
  check(lib.cd_membrane_get_solver(handle_of(self), out_solver))
  return enum_out("cd_solver", out_solver[0])
end

-- Which of the two the last step took that found it awake; CD_SOLVER_AUTO: neither. Not part of the saved state.
function Membrane:get_solver_taken()
  local where = "cd_membrane_get_solver_taken"
  local out_solver = cd_solver_1()
  check(lib.cd_membrane_get_solver_taken(handle_of(self), out_solver))
  return enum_out("cd_solver", out_solver[0])
end

-- When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in [1e-14, 1/2], default
-- 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system. It may take
-- most_iterations, >= 1, default 100, and ends when 500 have not halved the residual, which rounding may keep from
-- falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends short of the tolerance. Errors: CD_ERROR_VALUE.
function Membrane:set_tolerance(tolerance, most_iterations)
  local where = "cd_membrane_set_tolerance"
  tolerance = number_in(tolerance, where, "tolerance")
  most_iterations = integer_in(most_iterations, where, "most_iterations")
  self._version = self._version + 1
  check(lib.cd_membrane_set_tolerance(handle_of(self), tolerance, most_iterations))
end

-- When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in [1e-14, 1/2], default
-- 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system. It may take
-- most_iterations, >= 1, default 100, and ends when 500 have not halved the residual, which rounding may keep from
-- falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends short of the tolerance. Errors: CD_ERROR_VALUE.
function Membrane:get_tolerance()
  local where = "cd_membrane_get_tolerance"
  local out_tolerance = double_1()
  local out_most_iterations = size_t_1()
  check(lib.cd_membrane_get_tolerance(handle_of(self), out_tolerance, out_most_iterations))
  return tonumber(out_tolerance[0]), tonumber(out_most_iterations[0])
end

-- What the last call of cd_membrane_step did when it took CD_SOLVER_COUPLED: the most iterations that a solve needed,
-- and the largest residual it ended with, as a fraction of the one it started from: INFINITY where its square is. 0 and
-- 0 if there was no such solve. Soft motions beside stiff ones may be off by more. Each output may be null.
function Membrane:get_convergence()
  local where = "cd_membrane_get_convergence"
  local out_iterations = size_t_1()
  local out_residual = double_1()
  check(lib.cd_membrane_get_convergence(handle_of(self), out_iterations, out_residual))
  return tonumber(out_iterations[0]), tonumber(out_residual[0])
end

-- Spreads a step over the caller's threads. Null turns it off. Errors: CD_ERROR_NULL for a table without run.
function Membrane:set_parallel(parallel)
  local where = "cd_membrane_set_parallel"
  self._version = self._version + 1
  check(lib.cd_membrane_set_parallel(handle_of(self), parallel))
  self._kept.parallel = parallel
end

-- The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Membrane:set_kernels(kernels)
  local where = "cd_membrane_set_kernels"
  kernels = enum_in("cd_kernels", kernels, where, "kernels")
  self._version = self._version + 1
  check(lib.cd_membrane_set_kernels(handle_of(self), kernels))
end

-- The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Membrane:get_kernels()
  local where = "cd_membrane_get_kernels"
  local out_kernels = cd_kernels_1()
  check(lib.cd_membrane_get_kernels(handle_of(self), out_kernels))
  return enum_out("cd_kernels", out_kernels[0])
end

-- Mass [kg], > 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts half, in
-- its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter at
-- a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
-- nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
function Membrane:set_mass(mass)
  local where = "cd_membrane_set_mass"
  mass = number_in(mass, where, "mass")
  self._version = self._version + 1
  check(lib.cd_membrane_set_mass(handle_of(self), mass))
end

-- Mass [kg], > 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts half, in
-- its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter at
-- a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
-- nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
function Membrane:get_mass()
  local where = "cd_membrane_get_mass"
  local out_mass = double_1()
  check(lib.cd_membrane_get_mass(handle_of(self), out_mass))
  return tonumber(out_mass[0])
end

-- Mass [kg], > 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts half, in
-- its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter at
-- a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
-- nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
function Membrane:set_mass_rule(rule)
  local where = "cd_membrane_set_mass_rule"
  rule = enum_in("cd_mass_rule", rule, where, "rule")
  self._version = self._version + 1
  check(lib.cd_membrane_set_mass_rule(handle_of(self), rule))
end

-- Mass [kg], > 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts half, in
-- its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter at
-- a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
-- nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
function Membrane:get_mass_rule()
  local where = "cd_membrane_get_mass_rule"
  local out_rule = cd_mass_rule_1()
  check(lib.cd_membrane_get_mass_rule(handle_of(self), out_rule))
  return enum_out("cd_mass_rule", out_rule[0])
end

-- Stretch stiffness along u and along v [N/m], >= 0: a sheet stretched evenly along u by the length d holds the energy
-- k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the edges; along v
-- likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component has no size of its
-- own: with the sides L_u and L_v under the tension S [N/m] k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S.
function Membrane:set_stiffness(along_u, along_v)
  local where = "cd_membrane_set_stiffness"
  along_u = number_in(along_u, where, "along_u")
  along_v = number_in(along_v, where, "along_v")
  self._version = self._version + 1
  check(lib.cd_membrane_set_stiffness(handle_of(self), along_u, along_v))
end

-- Stretch stiffness along u and along v [N/m], >= 0: a sheet stretched evenly along u by the length d holds the energy
-- k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the edges; along v
-- likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component has no size of its
-- own: with the sides L_u and L_v under the tension S [N/m] k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S.
function Membrane:get_stiffness()
  local where = "cd_membrane_get_stiffness"
  local out_along_u = double_1()
  local out_along_v = double_1()
  check(lib.cd_membrane_get_stiffness(handle_of(self), out_along_u, out_along_v))
  return tonumber(out_along_u[0]), tonumber(out_along_v[0])
end

-- Bend stiffness b [N/m], >= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit square
-- of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of it along the
-- edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate of side L with b
-- = D / L^2 has the flexural rigidity D [N m]; one of L_u by L_v has b L_u^3 / L_v along u, b L_v^3 / L_u along v and b
-- L_u L_v in twist. Cut springs do not cut it, but CD_MASK. Errors: CD_ERROR_MEMORY when bend is switched on.
function Membrane:set_bend(bend)
  local where = "cd_membrane_set_bend"
  bend = number_in(bend, where, "bend")
  self._version = self._version + 1
  check(lib.cd_membrane_set_bend(handle_of(self), bend))
end

-- Bend stiffness b [N/m], >= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit square
-- of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of it along the
-- edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate of side L with b
-- = D / L^2 has the flexural rigidity D [N m]; one of L_u by L_v has b L_u^3 / L_v along u, b L_v^3 / L_u along v and b
-- L_u L_v in twist. Cut springs do not cut it, but CD_MASK. Errors: CD_ERROR_MEMORY when bend is switched on.
function Membrane:get_bend()
  local where = "cd_membrane_get_bend"
  local out_bend = double_1()
  check(lib.cd_membrane_get_bend(handle_of(self), out_bend))
  return tonumber(out_bend[0])
end

-- Drag [1/s], >= 0: every node loses velocity at this rate.
function Membrane:set_drag(drag)
  local where = "cd_membrane_set_drag"
  drag = number_in(drag, where, "drag")
  self._version = self._version + 1
  check(lib.cd_membrane_set_drag(handle_of(self), drag))
end

-- Drag [1/s], >= 0: every node loses velocity at this rate.
function Membrane:get_drag()
  local where = "cd_membrane_get_drag"
  local out_drag = double_1()
  check(lib.cd_membrane_get_drag(handle_of(self), out_drag))
  return tonumber(out_drag[0])
end

-- Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
-- amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.
function Membrane:set_stiffness_damping(seconds)
  local where = "cd_membrane_set_stiffness_damping"
  seconds = number_in(seconds, where, "seconds")
  self._version = self._version + 1
  check(lib.cd_membrane_set_stiffness_damping(handle_of(self), seconds))
end

-- Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
-- amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.
function Membrane:get_stiffness_damping()
  local where = "cd_membrane_get_stiffness_damping"
  local out_seconds = double_1()
  check(lib.cd_membrane_get_stiffness_damping(handle_of(self), out_seconds))
  return tonumber(out_seconds[0])
end

-- Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if count
-- is not the number of components.
function Membrane:set_gravity(gravity)
  local where = "cd_membrane_set_gravity"
  local p_gravity, n_gravity = array_in("double", gravity, where, "gravity")
  local count = count_of(n_gravity, 1, where, "gravity")
  self._version = self._version + 1
  check(lib.cd_membrane_set_gravity(handle_of(self), p_gravity, count))
end

-- Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if count
-- is not the number of components.
function Membrane:get_gravity(out_gravity)
  local where = "cd_membrane_get_gravity"
  local p_out_gravity, n_out_gravity = array_out("double", out_gravity, components_of(self), where, "out_gravity")
  local count = n_out_gravity or 0
  check(lib.cd_membrane_get_gravity(handle_of(self), p_out_gravity, count))
  return array_result(out_gravity, p_out_gravity, n_out_gravity)
end

-- Pressure [Pa] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a node is
-- pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at the positions
-- a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3 components only;
-- costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other components unless 0; CD_ERROR_MEMORY.
function Membrane:set_pressure(pressure)
  local where = "cd_membrane_set_pressure"
  pressure = number_in(pressure, where, "pressure")
  self._version = self._version + 1
  check(lib.cd_membrane_set_pressure(handle_of(self), pressure))
end

-- Pressure [Pa] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a node is
-- pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at the positions
-- a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3 components only;
-- costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other components unless 0; CD_ERROR_MEMORY.
function Membrane:get_pressure()
  local where = "cd_membrane_get_pressure"
  local out_pressure = double_1()
  check(lib.cd_membrane_get_pressure(handle_of(self), out_pressure))
  return tonumber(out_pressure[0])
end

-- What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning stops
-- the nodes; driving leaves their velocity, which is then written through CD_VELOCITY; posing switches CD_TARGET on and
-- sets the edge's targets to where it is: write the next ones there. CD_NODE_MATCHED leaves the edge free, with the
-- impedance that sends no echo back to a wave that runs straight at it. Where CD_PIN is switched on, all but matched
-- are written to it along the edge. The getter tells what was set last, whatever was written to CD_PIN since. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED in the direction of a ring; CD_ERROR_MEMORY;
-- CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
function Membrane:set_edge(edge, kind)
  local where = "cd_membrane_set_edge"
  edge = enum_in("cd_edge", edge, where, "edge")
  kind = enum_in("cd_node", kind, where, "kind")
  self._version = self._version + 1
  check(lib.cd_membrane_set_edge(handle_of(self), edge, kind))
end

-- What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning stops
-- the nodes; driving leaves their velocity, which is then written through CD_VELOCITY; posing switches CD_TARGET on and
-- sets the edge's targets to where it is: write the next ones there. CD_NODE_MATCHED leaves the edge free, with the
-- impedance that sends no echo back to a wave that runs straight at it. Where CD_PIN is switched on, all but matched
-- are written to it along the edge. The getter tells what was set last, whatever was written to CD_PIN since. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED in the direction of a ring; CD_ERROR_MEMORY;
-- CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
function Membrane:get_edge(edge)
  local where = "cd_membrane_get_edge"
  edge = enum_in("cd_edge", edge, where, "edge")
  local out_kind = cd_node_1()
  check(lib.cd_membrane_get_edge(handle_of(self), edge, out_kind))
  return enum_out("cd_node", out_kind[0])
end

-- Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and fields of
-- masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: CD_ERROR_VALUE for anything but 0 and 1;
-- CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge; CD_ERROR_MEMORY.
function Membrane:set_ring(along_u, along_v)
  local where = "cd_membrane_set_ring"
  along_u = flag_in(along_u, where, "along_u")
  along_v = flag_in(along_v, where, "along_v")
  self._version = self._version + 1
  check(lib.cd_membrane_set_ring(handle_of(self), along_u, along_v))
end

-- Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and fields of
-- masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: CD_ERROR_VALUE for anything but 0 and 1;
-- CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge; CD_ERROR_MEMORY.
function Membrane:get_ring()
  local where = "cd_membrane_get_ring"
  local out_along_u = int32_t_1()
  local out_along_v = int32_t_1()
  check(lib.cd_membrane_get_ring(handle_of(self), out_along_u, out_along_v))
  return out_along_u[0] ~= 0, out_along_v[0] ~= 0
end

-- Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s], in
-- [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Membrane:set_sleep(speed, seconds)
  local where = "cd_membrane_set_sleep"
  speed = number_in(speed, where, "speed")
  seconds = number_in(seconds, where, "seconds")
  self._version = self._version + 1
  check(lib.cd_membrane_set_sleep(handle_of(self), speed, seconds))
end

-- Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s], in
-- [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Membrane:get_sleep()
  local where = "cd_membrane_get_sleep"
  local out_speed = double_1()
  local out_seconds = double_1()
  check(lib.cd_membrane_get_sleep(handle_of(self), out_speed, out_seconds))
  return tonumber(out_speed[0]), tonumber(out_seconds[0])
end

-- Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s], in
-- [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Membrane:get_awake()
  local where = "cd_membrane_get_awake"
  local out_nodes = size_t_1()
  check(lib.cd_membrane_get_awake(handle_of(self), out_nodes))
  return tonumber(out_nodes[0])
end

-- Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both are 0 or neither
-- is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a membrane sets
-- lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and colliders too. Errors:
-- CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components and springs along both directions.
function Membrane:set_rest_length(along_u, along_v)
  local where = "cd_membrane_set_rest_length"
  along_u = number_in(along_u, where, "along_u")
  along_v = number_in(along_v, where, "along_v")
  self._version = self._version + 1
  check(lib.cd_membrane_set_rest_length(handle_of(self), along_u, along_v))
end

-- Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both are 0 or neither
-- is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a membrane sets
-- lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and colliders too. Errors:
-- CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components and springs along both directions.
function Membrane:get_rest_length()
  local where = "cd_membrane_get_rest_length"
  local out_along_u = double_1()
  local out_along_v = double_1()
  check(lib.cd_membrane_get_rest_length(handle_of(self), out_along_u, out_along_v))
  return tonumber(out_along_u[0]), tonumber(out_along_v[0])
end

-- Shear stiffness [N/m], >= 0, default 0, of a spring along each diagonal of every cell, with the law and the mean rest
-- lengths of the cell's springs. Of square cells the shear modulus is half of it [N/m]. Errors here and below:
-- CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth.
function Membrane:set_shear(stiffness)
  local where = "cd_membrane_set_shear"
  stiffness = number_in(stiffness, where, "stiffness")
  self._version = self._version + 1
  check(lib.cd_membrane_set_shear(handle_of(self), stiffness))
end

-- Shear stiffness [N/m], >= 0, default 0, of a spring along each diagonal of every cell, with the law and the mean rest
-- lengths of the cell's springs. Of square cells the shear modulus is half of it [N/m]. Errors here and below:
-- CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth.
function Membrane:get_shear()
  local where = "cd_membrane_get_shear"
  local out_stiffness = double_1()
  check(lib.cd_membrane_get_shear(handle_of(self), out_stiffness))
  return tonumber(out_stiffness[0])
end

-- What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l), longer
-- ones pull by as much, c dealt out as a stiffness of mass * rate. rate [1/s^2] >= 0, default 80: flags of a metre wave
-- in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds from node to node.
function Membrane:set_compression(rate)
  local where = "cd_membrane_set_compression"
  rate = number_in(rate, where, "rate")
  self._version = self._version + 1
  check(lib.cd_membrane_set_compression(handle_of(self), rate))
end

-- What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l), longer
-- ones pull by as much, c dealt out as a stiffness of mass * rate. rate [1/s^2] >= 0, default 80: flags of a metre wave
-- in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds from node to node.
function Membrane:get_compression()
  local where = "cd_membrane_get_compression"
  local out_rate = double_1()
  check(lib.cd_membrane_get_compression(handle_of(self), out_rate))
  return tonumber(out_rate[0])
end

-- The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
-- INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each spring: a seam is a
-- line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row and each
-- column of springs at most one. First goes the spring whose strain is the largest multiple of its breaking strain;
-- then its neighbour in the next row, and so on from row to row, while that is beyond its breaking strain too; then the
-- same in the rows that are left. So tears go on from their ends, and jerked cloth parts without falling to pieces. A
-- cut spring's stiffness becomes 0, and adds no energy. Mend it by writing CD_STIFFNESS_U or _V, which finite breaking
-- strains switch on and keep on. A cell of cloth that lacks two or more springs is open: it is not drawn, it has no
-- volume, and air and pressure go through it. Errors: CD_ERROR_MEMORY too.
function Membrane:set_breaking_strain(strain)
  local where = "cd_membrane_set_breaking_strain"
  strain = number_in(strain, where, "strain")
  self._version = self._version + 1
  check(lib.cd_membrane_set_breaking_strain(handle_of(self), strain))
end

-- The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
-- INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each spring: a seam is a
-- line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row and each
-- column of springs at most one. First goes the spring whose strain is the largest multiple of its breaking strain;
-- then its neighbour in the next row, and so on from row to row, while that is beyond its breaking strain too; then the
-- same in the rows that are left. So tears go on from their ends, and jerked cloth parts without falling to pieces. A
-- cut spring's stiffness becomes 0, and adds no energy. Mend it by writing CD_STIFFNESS_U or _V, which finite breaking
-- strains switch on and keep on. A cell of cloth that lacks two or more springs is open: it is not drawn, it has no
-- volume, and air and pressure go through it. Errors: CD_ERROR_MEMORY too.
function Membrane:get_breaking_strain()
  local where = "cd_membrane_get_breaking_strain"
  local out_strain = double_1()
  check(lib.cd_membrane_get_breaking_strain(handle_of(self), out_strain))
  return tonumber(out_strain[0])
end

-- How many springs tore in the last call of cd_membrane_step that made steps: those whose stiffness became 0. Where
-- there are any, cd_membrane_write_indices may write other triangles than before.
function Membrane:get_broken()
  local where = "cd_membrane_get_broken"
  local out_springs = size_t_1()
  check(lib.cd_membrane_get_broken(handle_of(self), out_springs))
  return tonumber(out_springs[0])
end

-- How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of conjugate
-- gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that all brought.
-- Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains much. After a step
-- get_convergence tells the most of conjugate gradients that a step took, and what gradient was left over the first.
function Membrane:set_effort(newton, gradient)
  local where = "cd_membrane_set_effort"
  newton = integer_in(newton, where, "newton")
  gradient = integer_in(gradient, where, "gradient")
  self._version = self._version + 1
  check(lib.cd_membrane_set_effort(handle_of(self), newton, gradient))
end

-- How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of conjugate
-- gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that all brought.
-- Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains much. After a step
-- get_convergence tells the most of conjugate gradients that a step took, and what gradient was left over the first.
function Membrane:get_effort()
  local where = "cd_membrane_get_effort"
  local out_newton = size_t_1()
  local out_gradient = size_t_1()
  check(lib.cd_membrane_get_effort(handle_of(self), out_newton, out_gradient))
  return tonumber(out_newton[0]), tonumber(out_gradient[0])
end

-- Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a whose velocity through
-- the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n). Implicit, so that it
-- only takes energy, as seen from the air, at any dt; areas and directions are those that the step starts from. Air of
-- density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02 s. A node on an edge bears
-- half the air: with CD_MASS_EQUAL, where it has the whole mass, a flat sheet folds as it falls; with CD_MASS_HALF_ENDS
-- it falls flat. Errors: CD_ERROR_MEMORY too.
function Membrane:set_air(along, across)
  local where = "cd_membrane_set_air"
  along = number_in(along, where, "along")
  across = number_in(across, where, "across")
  self._version = self._version + 1
  check(lib.cd_membrane_set_air(handle_of(self), along, across))
end

-- Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a whose velocity through
-- the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n). Implicit, so that it
-- only takes energy, as seen from the air, at any dt; areas and directions are those that the step starts from. Air of
-- density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02 s. A node on an edge bears
-- half the air: with CD_MASS_EQUAL, where it has the whole mass, a flat sheet folds as it falls; with CD_MASS_HALF_ENDS
-- it falls flat. Errors: CD_ERROR_MEMORY too.
function Membrane:get_air()
  local where = "cd_membrane_get_air"
  local out_along = double_1()
  local out_across = double_1()
  check(lib.cd_membrane_get_air(handle_of(self), out_along, out_across))
  return tonumber(out_along[0]), tonumber(out_across[0])
end

-- Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node. Errors:
-- CD_ERROR_RANGE too, if count is not the number of components.
function Membrane:set_wind(velocity)
  local where = "cd_membrane_set_wind"
  local p_velocity, n_velocity = array_in("double", velocity, where, "velocity")
  local count = count_of(n_velocity, 1, where, "velocity")
  self._version = self._version + 1
  check(lib.cd_membrane_set_wind(handle_of(self), p_velocity, count))
end

-- Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node. Errors:
-- CD_ERROR_RANGE too, if count is not the number of components.
function Membrane:get_wind(out_velocity)
  local where = "cd_membrane_get_wind"
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, components_of(self), where, "out_velocity")
  local count = n_out_velocity or 0
  check(lib.cd_membrane_get_wind(handle_of(self), p_out_velocity, count))
  return array_result(out_velocity, p_out_velocity, n_out_velocity)
end

-- As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
-- them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
-- be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
-- none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself. Depth:
-- contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the default
-- effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside comes out,
-- and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v +
-- 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the default effort, what begins to slide
-- is up to a quarter too slow in its first half second. What friction holds creeps, at half of the largest force that
-- it can hold by 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step
-- finds a node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
-- callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
-- CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the
-- functions of cd_chain.
function Membrane:set_colliders(count)
  local where = "cd_membrane_set_colliders"
  count = integer_in(count, where, "count")
  self._version = self._version + 1
  check(lib.cd_membrane_set_colliders(handle_of(self), count))
end

-- As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
-- them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
-- be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
-- none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself. Depth:
-- contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the default
-- effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside comes out,
-- and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v +
-- 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the default effort, what begins to slide
-- is up to a quarter too slow in its first half second. What friction holds creeps, at half of the largest force that
-- it can hold by 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step
-- finds a node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
-- callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
-- CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the
-- functions of cd_chain.
function Membrane:get_colliders()
  local where = "cd_membrane_get_colliders"
  local out_count = size_t_1()
  check(lib.cd_membrane_get_colliders(handle_of(self), out_count))
  return tonumber(out_count[0])
end

-- As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
-- them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
-- be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
-- none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself. Depth:
-- contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the default
-- effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside comes out,
-- and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v +
-- 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the default effort, what begins to slide
-- is up to a quarter too slow in its first half second. What friction holds creeps, at half of the largest force that
-- it can hold by 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step
-- finds a node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
-- callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
-- CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the
-- functions of cd_chain.
function Membrane:set_plane(index, point, normal, friction)
  local where = "cd_membrane_set_plane"
  index = integer_in(index, where, "index")
  local p_point, n_point = array_in("double", point, where, "point")
  local p_normal, n_normal = array_in("double", normal, where, "normal")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_point, 1, where, "point")
  same(n_normal, count * 1, where, "normal")
  self._version = self._version + 1
  check(lib.cd_membrane_set_plane(handle_of(self), index, p_point, p_normal, count, friction))
end

-- As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
-- them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
-- be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
-- none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself. Depth:
-- contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the default
-- effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside comes out,
-- and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v +
-- 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the default effort, what begins to slide
-- is up to a quarter too slow in its first half second. What friction holds creeps, at half of the largest force that
-- it can hold by 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step
-- finds a node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
-- callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
-- CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the
-- functions of cd_chain.
function Membrane:set_capsule(index, first, last, radius, friction)
  local where = "cd_membrane_set_capsule"
  index = integer_in(index, where, "index")
  local p_first, n_first = array_in("double", first, where, "first")
  local p_last, n_last = array_in("double", last, where, "last")
  radius = number_in(radius, where, "radius")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_first, 1, where, "first")
  same(n_last, count * 1, where, "last")
  self._version = self._version + 1
  check(lib.cd_membrane_set_capsule(handle_of(self), index, p_first, p_last, count, radius, friction))
end

-- As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
-- them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
-- be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
-- none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself. Depth:
-- contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the default
-- effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside comes out,
-- and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v +
-- 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the default effort, what begins to slide
-- is up to a quarter too slow in its first half second. What friction holds creeps, at half of the largest force that
-- it can hold by 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step
-- finds a node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
-- callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
-- CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the
-- functions of cd_chain.
function Membrane:set_bed(index, origin, columns, rows, column_spacing, row_spacing, heights, friction)
  local where = "cd_membrane_set_bed"
  index = integer_in(index, where, "index")
  local p_origin, n_origin = array_in("double", origin, where, "origin")
  columns = integer_in(columns, where, "columns")
  rows = integer_in(rows, where, "rows")
  column_spacing = number_in(column_spacing, where, "column_spacing")
  row_spacing = number_in(row_spacing, where, "row_spacing")
  local p_heights, n_heights = array_in("double", heights, where, "heights")
  friction = number_in(friction, where, "friction")
  local count = count_of(n_origin, 1, where, "origin")
  local height_count = count_of(n_heights, 1, where, "heights")
  self._version = self._version + 1
  check(lib.cd_membrane_set_bed(handle_of(self), index, p_origin, count, columns, rows, column_spacing, row_spacing,
      p_heights, height_count, friction))
end

-- Each output may be null.
function Membrane:get_bed(index, out_heights)
  local where = "cd_membrane_get_bed"
  index = integer_in(index, where, "index")
  local p_out_heights, n_out_heights = array_out("double", out_heights, nil, where, "out_heights")
  local height_count = n_out_heights or 0
  local out_columns = size_t_1()
  local out_rows = size_t_1()
  check(lib.cd_membrane_get_bed(handle_of(self), index, out_columns, out_rows, p_out_heights, height_count))
  return tonumber(out_columns[0]), tonumber(out_rows[0]), array_result(out_heights, p_out_heights, n_out_heights)
end

-- origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
function Membrane:set_callback(index, distance, origin, friction)
  local where = "cd_membrane_set_callback"
  index = integer_in(index, where, "index")
  local p_origin, n_origin = array_in("double", origin, where, "origin", true)
  friction = number_in(friction, where, "friction")
  local count = count_of(n_origin, 1, where, "origin")
  self._version = self._version + 1
  check(lib.cd_membrane_set_callback(handle_of(self), index, distance, p_origin, count, friction))
  self._kept.distance = distance
end

-- origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
function Membrane:remove_collider(index)
  local where = "cd_membrane_remove_collider"
  index = integer_in(index, where, "index")
  self._version = self._version + 1
  check(lib.cd_membrane_remove_collider(handle_of(self), index))
end

-- origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
function Membrane:set_collider_velocity(index, velocity)
  local where = "cd_membrane_set_collider_velocity"
  index = integer_in(index, where, "index")
  local p_velocity, n_velocity = array_in("double", velocity, where, "velocity")
  local count = count_of(n_velocity, 1, where, "velocity")
  self._version = self._version + 1
  check(lib.cd_membrane_set_collider_velocity(handle_of(self), index, p_velocity, count))
end

-- Each output may be null.
function Membrane:get_collider(index, out_first, out_second, out_velocity)
  local where = "cd_membrane_get_collider"
  index = integer_in(index, where, "index")
  local p_out_first, n_out_first = array_out("double", out_first, components_of(self), where, "out_first")
  local p_out_second, n_out_second = array_out("double", out_second, components_of(self), where, "out_second")
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, components_of(self), where, "out_velocity")
  local count = n_out_first or n_out_second or n_out_velocity or 0
  same(n_out_second, count * 1, where, "out_second")
  same(n_out_velocity, count * 1, where, "out_velocity")
  local out_shape = cd_shape_1()
  local out_radius = double_1()
  local out_friction = double_1()
  check(lib.cd_membrane_get_collider(handle_of(self), index, out_shape, p_out_first, p_out_second, p_out_velocity,
      count, out_radius, out_friction))
  return enum_out("cd_shape", out_shape[0]), array_result(out_first, p_out_first, n_out_first),
      array_result(out_second, p_out_second, n_out_second), array_result(out_velocity, p_out_velocity, n_out_velocity),
      tonumber(out_radius[0]), tonumber(out_friction[0])
end

-- What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
-- lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
-- whatever the effort; of held ones as right as the step's velocities are.
function Membrane:set_loads(loads)
  local where = "cd_membrane_set_loads"
  loads = flag_in(loads, where, "loads")
  self._version = self._version + 1
  check(lib.cd_membrane_set_loads(handle_of(self), loads))
end

-- What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
-- lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
-- whatever the effort; of held ones as right as the step's velocities are.
function Membrane:get_loads()
  local where = "cd_membrane_get_loads"
  local out_loads = int32_t_1()
  check(lib.cd_membrane_get_loads(handle_of(self), out_loads))
  return out_loads[0] ~= 0
end

-- What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
-- lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
-- whatever the effort; of held ones as right as the step's velocities are.
function Membrane:get_collider_load(index, out_load)
  local where = "cd_membrane_get_collider_load"
  index = integer_in(index, where, "index")
  local p_out_load, n_out_load = array_out("double", out_load, 6, where, "out_load")
  local count = n_out_load or 0
  check(lib.cd_membrane_get_collider_load(handle_of(self), index, p_out_load, count))
  return array_result(out_load, p_out_load, n_out_load)
end

-- How thick cloth is, as a distance [m] in [0, 1e60], default 0, that nodes keep from colliders.
function Membrane:set_thickness(distance)
  local where = "cd_membrane_set_thickness"
  distance = number_in(distance, where, "distance")
  self._version = self._version + 1
  check(lib.cd_membrane_set_thickness(handle_of(self), distance))
end

-- How thick cloth is, as a distance [m] in [0, 1e60], default 0, that nodes keep from colliders.
function Membrane:get_thickness()
  local where = "cd_membrane_get_thickness"
  local out_distance = double_1()
  check(lib.cd_membrane_get_thickness(handle_of(self), out_distance))
  return tonumber(out_distance[0])
end

-- Switches a field on, filled with the present uniform values (force 0, target the present position, mask 1, pin what
-- the edges say). CD_BREAKING_STRAIN_U and _V switch CD_STIFFNESS_U and _V on too. On already: nothing happens. Errors:
-- CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_TARGET where the state is not finite; here and below
-- CD_ERROR_UNSUPPORTED for the fields of cloth of a membrane that is none.
function Membrane:enable_field(field)
  local where = "cd_membrane_enable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_membrane_enable_field(handle_of(self), field))
end

-- Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened, all nodes
-- there, none held but on edges. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, tension and
-- strain, and for the stiffness of springs that may tear.
function Membrane:disable_field(field)
  local where = "cd_membrane_disable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_membrane_disable_field(handle_of(self), field))
end

-- Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u, first_u + n_u) x
-- [first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
-- springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer: n_u *
-- n_v * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
-- CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
-- CD_ERROR_UNSUPPORTED for tension and strain.
function Membrane:write_f32(field, first_u, first_v, n_u, n_v, values)
  local where = "cd_membrane_write_f32"
  field = enum_in("cd_field", field, where, "field")
  first_u = integer_in(first_u, where, "first_u")
  first_v = integer_in(first_v, where, "first_v")
  n_u = integer_in(n_u, where, "n_u")
  n_v = integer_in(n_v, where, "n_v")
  local p_values, n_values = array_in("float", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_membrane_write_f32(handle_of(self), field, first_u, first_v, n_u, n_v, p_values, count))
end

-- Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u, first_u + n_u) x
-- [first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
-- springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer: n_u *
-- n_v * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
-- CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
-- CD_ERROR_UNSUPPORTED for tension and strain.
function Membrane:write_f64(field, first_u, first_v, n_u, n_v, values)
  local where = "cd_membrane_write_f64"
  field = enum_in("cd_field", field, where, "field")
  first_u = integer_in(first_u, where, "first_u")
  first_v = integer_in(first_v, where, "first_v")
  n_u = integer_in(n_u, where, "n_u")
  n_v = integer_in(n_v, where, "n_v")
  local p_values, n_values = array_in("double", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_membrane_write_f64(handle_of(self), field, first_u, first_v, n_u, n_v, p_values, count))
end

-- Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u, first_u + n_u) x
-- [first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
-- springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer: n_u *
-- n_v * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
-- CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
-- CD_ERROR_UNSUPPORTED for tension and strain.
function Membrane:read_f32(field, first_u, first_v, n_u, n_v, out_values)
  local where = "cd_membrane_read_f32"
  field = enum_in("cd_field", field, where, "field")
  first_u = integer_in(first_u, where, "first_u")
  first_v = integer_in(first_v, where, "first_v")
  n_u = integer_in(n_u, where, "n_u")
  n_v = integer_in(n_v, where, "n_v")
  local p_out_values, n_out_values = array_out("float", out_values, n_u * n_v * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_membrane_read_f32(handle_of(self), field, first_u, first_v, n_u, n_v, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u, first_u + n_u) x
-- [first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
-- springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer: n_u *
-- n_v * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
-- CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
-- CD_ERROR_UNSUPPORTED for tension and strain.
function Membrane:read_f64(field, first_u, first_v, n_u, n_v, out_values)
  local where = "cd_membrane_read_f64"
  field = enum_in("cd_field", field, where, "field")
  first_u = integer_in(first_u, where, "first_u")
  first_v = integer_in(first_v, where, "first_v")
  n_u = integer_in(n_u, where, "n_u")
  n_v = integer_in(n_v, where, "n_v")
  local p_out_values, n_out_values = array_out("double", out_values, n_u * n_v * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_membrane_read_f64(handle_of(self), field, first_u, first_v, n_u, n_v, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Where a field lies in the membrane's own memory, in the membrane's precision, to read without a copy: the value of
-- (u, v, component) is at byte *out_data + u * u_stride + v * v_stride + component * component_stride. Position,
-- velocity, force and target only. The pointer is good until the field is switched off or the membrane released; the
-- numbers change with every write and step. Do not write through it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED,
-- CD_ERROR_UNSUPPORTED.
function Membrane:view(field)
  return support.view(self, enum_in("cd_field", field, "cd_membrane_view", "field"), function(handle, value)
    local data, strides = address_1(), strides_4()
    check(lib.cd_membrane_view(handle, value, data, strides + 0, strides + 1, strides + 2))
    return data[0], strides
  end, 3)
end

-- Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs away from the place
-- (u, v), counted on the lattice and not round a ring, by weights (1 - (distance / radius)^2)^2, scaled to sum to 1;
-- all on the nearest node if there is none. A node's velocity changes by its share / its mass; held and absent nodes
-- lose it. u in [0, nu], v in [0, nv], radius >= 0. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED.
function Membrane:impulse(u, v, radius, impulse)
  local where = "cd_membrane_impulse"
  u = number_in(u, where, "u")
  v = number_in(v, where, "v")
  radius = number_in(radius, where, "radius")
  local p_impulse, n_impulse = array_in("double", impulse, where, "impulse")
  local count = count_of(n_impulse, 1, where, "impulse")
  self._version = self._version + 1
  check(lib.cd_membrane_impulse(handle_of(self), u, v, radius, p_impulse, count))
end

-- Moves the sheet as a whole, as if it had always been there: every position and target becomes rotation * x + offset,
-- every velocity rotation * v; colliders stay where they are. rotation: components rows of as many numbers, orthogonal
-- to 1e-6; null: none. offset [m]: one number per component, which count counts. Errors: CD_ERROR_RANGE,
-- CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite.
function Membrane:teleport(rotation, offset)
  local where = "cd_membrane_teleport"
  local p_rotation, n_rotation = array_in("double", rotation, where, "rotation", true)
  local p_offset, n_offset = array_in("double", offset, where, "offset")
  local count = count_of(n_offset, 1, where, "offset")
  same(n_rotation, count * count, where, "rotation")
  self._version = self._version + 1
  check(lib.cd_membrane_teleport(handle_of(self), p_rotation, p_offset, count))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
-- target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
-- writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach:
-- CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
function Membrane:attach(u, v, stiffness, damping, target)
  local where = "cd_membrane_attach"
  u = integer_in(u, where, "u")
  v = integer_in(v, where, "v")
  stiffness = number_in(stiffness, where, "stiffness")
  damping = number_in(damping, where, "damping")
  local p_target, n_target = array_in("double", target, where, "target", true)
  local count = count_of(n_target, 1, where, "target")
  self._version = self._version + 1
  check(lib.cd_membrane_attach(handle_of(self), u, v, stiffness, damping, p_target, count))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
-- target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
-- writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach:
-- CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
function Membrane:detach(u, v)
  local where = "cd_membrane_detach"
  u = integer_in(u, where, "u")
  v = integer_in(v, where, "v")
  self._version = self._version + 1
  check(lib.cd_membrane_detach(handle_of(self), u, v))
end

-- Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
-- target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
-- writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach:
-- CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
function Membrane:get_attachment(u, v)
  local where = "cd_membrane_get_attachment"
  u = integer_in(u, where, "u")
  v = integer_in(v, where, "v")
  local out_stiffness = double_1()
  local out_damping = double_1()
  check(lib.cd_membrane_get_attachment(handle_of(self), u, v, out_stiffness, out_damping))
  return tonumber(out_stiffness[0]), tonumber(out_damping[0])
end

-- Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps. Never allocates.
-- Time is proportional to count * nodes * components, with CD_SOLVER_COUPLED to the iterations too. Errors:
-- CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives the
-- first bad one, the membrane can be read, and steps again after cd_membrane_reset, a load, or once finite positions
-- and velocities have been written; CD_ERROR_TOLERANCE if a coupled solve ended short of its tolerance: all steps are
-- made, and good to the residual that cd_membrane_get_convergence tells.
function Membrane:step(dt, count)
  local where = "cd_membrane_step"
  dt = number_in(dt, where, "dt")
  if count == nil then count = 1 end
  count = integer_in(count, where, "count")
  self._version = self._version + 1
  check(lib.cd_membrane_step(handle_of(self), dt, count))
end

-- The longest dt at which CD_METHOD_SYMPLECTIC_EULER is sure to stay bounded, whatever method is set: the largest dt
-- with 4 M - 2 dt C - dt^2 K positive definite, by a bound on K that is exact in the limit of many nodes for uniform
-- sheets, and a safe lower bound otherwise. INFINITY if nothing can swing. Errors: CD_ERROR_UNSUPPORTED of cloth.
function Membrane:stable_dt()
  local where = "cd_membrane_stable_dt"
  local out_dt = double_1()
  check(lib.cd_membrane_stable_dt(handle_of(self), out_dt))
  return tonumber(out_dt[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Membrane:get_time()
  local where = "cd_membrane_get_time"
  local out_time = double_1()
  check(lib.cd_membrane_get_time(handle_of(self), out_time))
  return tonumber(out_time[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Membrane:get_steps()
  local where = "cd_membrane_get_steps"
  local out_steps = uint64_t_1()
  check(lib.cd_membrane_get_steps(handle_of(self), out_steps))
  return out_steps[0]
end

-- How many factorizations the membrane has made: one at the first implicit step and one at the first after each change
-- of dt, lambda, method, solver or a parameter. Not part of the saved state.
function Membrane:get_factorizations()
  local where = "cd_membrane_get_factorizations"
  local out_count = uint64_t_1()
  check(lib.cd_membrane_get_factorizations(handle_of(self), out_count))
  return out_count[0]
end

-- Energies [J]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend and attachments. Gravity:
-- -sum m g x of the free nodes. What of their sum lambda = 1/2 keeps is told above.
function Membrane:get_energy()
  local where = "cd_membrane_get_energy"
  local out_kinetic = double_1()
  local out_elastic = double_1()
  local out_gravity = double_1()
  check(lib.cd_membrane_get_energy(handle_of(self), out_kinetic, out_elastic, out_gravity))
  return tonumber(out_kinetic[0]), tonumber(out_elastic[0]), tonumber(out_gravity[0])
end

-- Momentum of the free nodes [kg m/s], one number per component. Errors: CD_ERROR_RANGE if count is not the number of
-- components.
function Membrane:get_momentum(out_momentum)
  local where = "cd_membrane_get_momentum"
  local p_out_momentum, n_out_momentum = array_out("double", out_momentum, components_of(self), where, "out_momentum")
  local count = n_out_momentum or 0
  check(lib.cd_membrane_get_momentum(handle_of(self), p_out_momentum, count))
  return array_result(out_momentum, p_out_momentum, n_out_momentum)
end

-- The force [N], one number per component, with which springs, shear and bend pull at a node where it is now: of a held
-- node, what the sheet does to whatever holds it, but for weight, forces, attachment, pressure and wind of that node
-- itself. Errors: CD_ERROR_RANGE for count, or if there is no such node.
function Membrane:get_reaction(u, v, out_force)
  local where = "cd_membrane_get_reaction"
  u = integer_in(u, where, "u")
  v = integer_in(v, where, "v")
  local p_out_force, n_out_force = array_out("double", out_force, components_of(self), where, "out_force")
  local count = n_out_force or 0
  check(lib.cd_membrane_get_reaction(handle_of(self), u, v, p_out_force, count))
  return array_result(out_force, p_out_force, n_out_force)
end

-- Volume between the sheet and the origin [m^3]: a third of the integral of x over the surface's normal, each cell the
-- mean of its two triangulations, cells with an absent node or torn open left out. Of a drum-head whose rim lies in a
-- plane through the origin it is the volume under it; of a closed surface, what it encloses. 3 components only. Errors:
-- CD_ERROR_UNSUPPORTED.
function Membrane:get_volume()
  local where = "cd_membrane_get_volume"
  local out_volume = double_1()
  check(lib.cd_membrane_get_volume(handle_of(self), out_volume))
  return tonumber(out_volume[0])
end

-- Positions at n places on the sheet, bilinear between nodes: at[j] = {u, v}, u in [0, nu] (ring: to nu + 1), v
-- likewise; out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE, CD_ERROR_ENUM,
-- CD_ERROR_VALUE.
function Membrane:sample(at, outside, out_positions)
  local where = "cd_membrane_sample"
  local p_at, n_at = array_in("double", at, where, "at")
  if outside == nil then outside = "refused" end
  outside = enum_in("cd_outside", outside, where, "outside")
  local n = count_of(n_at, 2, where, "at")
  local p_out_positions, n_out_positions = array_out("double", out_positions, n * components_of(self), where,
      "out_positions")
  local out_count = n_out_positions or 0
  check(lib.cd_membrane_sample(handle_of(self), p_at, n, outside, p_out_positions, out_count))
  return array_result(out_positions, p_out_positions, n_out_positions)
end

-- Bytes the membrane holds from its allocator.
function Membrane:get_memory()
  local where = "cd_membrane_get_memory"
  local out_bytes = size_t_1()
  check(lib.cd_membrane_get_memory(handle_of(self), out_bytes))
  return tonumber(out_bytes[0])
end

-- A 64-bit hash of everything cd_membrane_save would write. Equal on every machine, compiler and vector width.
function Membrane:hash()
  local where = "cd_membrane_hash"
  local out_hash = uint64_t_1()
  check(lib.cd_membrane_hash(handle_of(self), out_hash))
  return out_hash[0]
end

-- Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i * stride, its position as
-- 3 floats at position_offset and its unit normal, smooth across the sheet, as 3 floats at normal_offset. A normal
-- points along x_u x x_v and is zero where the sheet has no area or is not finite. Components that are not there are
-- written as 0, and a fourth is not drawn; a membrane of 1 component is drawn as the height z over the unit square, x =
-- u / nu, y = v / nv (a direction without a spring: 0; a ring: u / (nu + 1), and for the normals the sheet goes on
-- beyond its ends). normal_offset SIZE_MAX: no normals. Bytes between are left alone; any offset and stride will do,
-- aligned or not, that keeps the vertices apart. Absent nodes get their vertex too, with a zero normal. Errors:
-- CD_ERROR_RANGE if size < nodes * stride, an offset and its 12 bytes reach past stride, or both overlap.
function Membrane:write_vertices(buffer, stride, position_offset, normal_offset)
  local where = "cd_membrane_write_vertices"
  local p_buffer, n_buffer = bytes_out(buffer, nil, where, "buffer")
  stride = integer_in(stride, where, "stride")
  position_offset = integer_in(position_offset, where, "position_offset")
  normal_offset = integer_in(normal_offset, where, "normal_offset")
  local size = n_buffer
  check(lib.cd_membrane_write_vertices(handle_of(self), p_buffer, size, stride, position_offset, normal_offset))
end

-- How many indices cd_membrane_write_indices writes now: 6 per cell of four nodes that are there, of cloth 0 if it is
-- torn open, 3 per cell of which three are there. Cells that close a ring are among them, but not of 1 component: they
-- would reach back across the unit square.
function Membrane:get_index_count()
  local where = "cd_membrane_get_index_count"
  local out_count = size_t_1()
  check(lib.cd_membrane_get_index_count(handle_of(self), out_count))
  return tonumber(out_count[0])
end

-- Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order),
-- counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v + 1). `size` is
-- that of the buffer in bytes. The numbers change with CD_MASK, cd_membrane_set_ring and what is cut of cloth only.
-- 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart, are never written. Errors:
-- CD_ERROR_VALUE for another index_size; CD_ERROR_RANGE if size is too small; CD_ERROR_UNSUPPORTED for more nodes.
function Membrane:write_indices(buffer, index_size)
  local where = "cd_membrane_write_indices"
  local p_buffer, n_buffer = bytes_out(buffer, nil, where, "buffer")
  index_size = integer_in(index_size, where, "index_size")
  local size = n_buffer
  check(lib.cd_membrane_write_indices(handle_of(self), p_buffer, size, index_size))
end

-- The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a membrane
-- of the same shape and precision; it switches fields on and off as they were. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Membrane:save_size()
  local where = "cd_membrane_save_size"
  local out_size = size_t_1()
  check(lib.cd_membrane_save_size(handle_of(self), out_size))
  return tonumber(out_size[0])
end

-- The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a membrane
-- of the same shape and precision; it switches fields on and off as they were. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Membrane:save(buffer)
  local where = "cd_membrane_save"
  local p_buffer, n_buffer = bytes_out(buffer, self:save_size(), where, "buffer")
  local size = n_buffer
  local out_written = size_t_1()
  check(lib.cd_membrane_save(handle_of(self), p_buffer, size, out_written))
  if buffer == nil then return string_of(p_buffer, tonumber(out_written[0])) end
  return tonumber(out_written[0])
end

-- The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a membrane
-- of the same shape and precision; it switches fields on and off as they were. Errors: save: CD_ERROR_RANGE. load:
-- CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Membrane:load(bytes)
  local where = "cd_membrane_load"
  local p_bytes, n_bytes = bytes_in(bytes, where, "bytes")
  local size = n_bytes
  self._version = self._version + 1
  check(lib.cd_membrane_load(handle_of(self), p_bytes, size))
end

-- Makes `membrane` what `source` is, as save and load would, without the bytes: the two must agree in shape and
-- precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Membrane:copy_state(source)
  local where = "cd_membrane_copy_state"
  self._version = self._version + 1
  check(lib.cd_membrane_copy_state(handle_of(self), handle_of(source)))
end

-- Positions, velocities, time and steps back to 0. Parameters, fields and pins stay; targets too.
function Membrane:reset()
  local where = "cd_membrane_reset"
  self._version = self._version + 1
  check(lib.cd_membrane_reset(handle_of(self)))
end

-- contdyn: water: a height field of columns over a bed: pool, river, tide, flood.
-- A water has nx x ny cells of dx x dy metres; ny = 1 is a slice. A cell holds a column of water of depth d >= 0 over
-- its bed b; its surface is h = b + d. Velocities live on the faces between cells: x-face (i, j) lies between the cells
-- (i - 1, j) and (i, j), so that there are nx + 1 of them in a row; y-face (i, j) between (i, j - 1) and (i, j). Cell
-- (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).
-- Motion d_t + (d u)_x + (d v)_y = source u_t [+ u u_x + v u_y] = -g h_x - p_x / density + force - friction u, and v
-- likewise friction = drag + g manning^2 |u| / d^(4/3) (Kass 1997, eq. 32-33; the bracket: shallow water)
-- CD_MOMENTUM_LINEAR without the bracket: waves, splashes, tides, floods that creep. CD_MOMENTUM_ADVECTED with it:
-- moving shores, dam breaks, bores, whirls. Momentum goes with the water that leaves a cell, upwind, of second order
-- where depths are even.
-- What to set: the momentum by this list; lambda as cd_water_set_momentum sets it; one step a frame, which is never too
-- long to be stable, or more where waves must run at their speed (cd_water_get_courant at most 1). lambda = 1/2 is of
-- second order in time and keeps the energy of small waves; above 1/2 short waves die out, and linear water, whose
-- shores are steep, needs a little more. Right for waves much longer than the water is deep and for surfaces that do
-- not turn over: there is no dispersion, and there are no ship wakes.
-- A step sweeps along all rows, then along all columns, and the next step the other way round. Along such a line the
-- fluxes and the changes of the surface are solved for together, by the theta scheme, theta = lambda, in time in
-- proportion to its cells. The depth at a face is the mean of its two cells'; where these differ a lot, it is nearer to
-- that of the cell which the water leaves. No cell gives more than it has and gets: cd_water_get_limited tells how much
-- that holds back. So no depth is negative, a lake lies still on any bed, and cd_water_get_account tells all changes of
-- volume. Explicit methods differ in that no surface is solved for: half of the slope pushes, the water moves, then the
-- other half pushes (velocity Verlet).
-- What goes wrong, and by how much. "From n cells on": in steps, or parts of fast water's, in which waves cross as
-- many. Long steps: from 1 cell on waves run too slowly, short ones most, and slantwise more than along the axes. Make
-- them shorter: to solve for the whole plane, a system that streams make neither symmetric nor definite, cost tens of
-- times as much, and gained and lost water. Fast water: a line whose water would run more than half a cell makes its
-- step in 2, 4, ... 64 parts, at so many times the cost, none of which begins with faster water. Water that runs more
-- than 32 cells is carried less exactly, and ripples on it may grow; on slower water only those of linear momentum,
-- lambda 1/2, uneven beds do. Bores, linear: momentum is not carried on, so that a shore moves with the slope of the
-- surface there, and a bore a tenth, half, twice as high as the depth before it is 2, 9, 22% too slow, against a stream
-- as much too fast. Bores, advected: within 1.2% of their speed, also against streams, until water runs over 32 cells;
-- from 2 cells on those a tenth of the depth high are spread over 2 to 6 times as many. Waves behind a bore: with
-- lambda = 1/2 up to its own height (linear: 1.6), with 0.6 up to 0.3 (1.3), all along its way where the water behind
-- it rests. Energy, linear: where water deepens it gains h_t u^2 / 2, at random shores some hundredths in all (and see
-- hulls). From 2 cells on waves in the plane, with lambda = 1/2, grow in thousands of steps to a ninth of the depth.
-- Energy, advected: from 1 cell on it does not rise by itself. Below 1 cell up to 0.005 of it is won among cliffs, far
-- below also at shores, and 0.01 in the first step after velocities are written there. Energy, both: from 1 cell on no
-- face gains more than its water loses by falling: linear over uneven depths, advected where a depth changes by half;
-- from 1e12 on rounding may add any amount. Air that presses water dry adds 1.4 times what it has to give where
-- momentum is linear, half of it where advected, any amount if explicit. Dry land: what pushes water away from it gives
-- the face at the water's edge a velocity that no water follows.
-- A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, no drag, CD_MOMENTUM_LINEAR,
-- CD_METHOD_IMPLICIT with lambda 0.55. All computing is in double precision; CD_FLOAT32 is what depth, bed, velocities
-- and the fields are stored in. Steps store 0 for depths below 2^-80 m and velocities below 2^-80 (float32), 2^-500
-- m/s. Parameters may be as large as 1e60.
-- Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
-- comments name the other errors. Functions that chain and membrane have too mean the same here.
local Water = support.class("Water", "cd_water_destroy")
api.Water = Water
Water._range_alternates = false
Water._components = nil -- which result of get_shape
Water._fields = {
  [11] = {1, 0, 0, 2, 0, 0, false, false},
  [12] = {1, 0, 0, 2, 0, 0, false, false},
  [13] = {1, 0, 0, 2, 0, 0, false, false},
  [14] = {1, 1, 0, 2, 0, 0, false, false},
  [15] = {1, 0, 0, 2, 1, 0, false, false},
  [16] = {1, 0, 0, 2, 0, 0, false, false},
  [17] = {1, 0, 0, 2, 0, 0, false, false},
  [18] = {1, 1, 0, 2, 0, 0, false, false},
  [19] = {1, 0, 0, 2, 1, 0, false, false},
  [10] = {1, 0, 0, 2, 0, 0, false, false},
  [20] = {1, 1, 0, 2, 0, 0, false, false},
  [21] = {1, 0, 0, 2, 1, 0, false, false},
}

-- Makes a water. nx, ny >= 1; dx, dy [m] in [1e-30, 1e30]. allocator may be null (malloc). The caller owns *out_water
-- and releases it with cd_water_destroy; on failure *out_water is left alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM,
-- CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that this build leaves out.
function Water.create(nx, ny, dx, dy, precision, allocator)
  local where, made = "cd_water_create", ffi.new("cd_water*[1]")
  support.check_built(Water, where)
  if precision == nil then precision = "float64" end
  check(lib.cd_water_create(integer_in(nx, where, "nx"), integer_in(ny, where, "ny"), number_in(dx, where, "dx"),
      number_in(dy, where, "dy"), enum_in("cd_precision", precision, where, "precision"), allocator, made))
  return support.own(Water, made[0], {allocator = allocator})
end

-- What cd_water_create was given, or what has been loaded since. Each output may be null.
function Water:get_shape()
  local where = "cd_water_get_shape"
  local out_nx = size_t_1()
  local out_ny = size_t_1()
  local out_dx = double_1()
  local out_dy = double_1()
  local out_precision = cd_precision_1()
  check(lib.cd_water_get_shape(handle_of(self), out_nx, out_ny, out_dx, out_dy, out_precision))
  return tonumber(out_nx[0]), tonumber(out_ny[0]), tonumber(out_dx[0]), tonumber(out_dy[0]), enum_out("cd_precision",
      out_precision[0])
end

-- How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form, second order in time
-- and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at no dt. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY.
function Water:set_method(method)
  local where = "cd_water_set_method"
  method = enum_in("cd_method", method, where, "method")
  self._version = self._version + 1
  check(lib.cd_water_set_method(handle_of(self), method))
end

-- How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form, second order in time
-- and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at no dt. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY.
function Water:get_method()
  local where = "cd_water_get_method"
  local out_method = cd_method_1()
  check(lib.cd_water_get_method(handle_of(self), out_method))
  return enum_out("cd_method", out_method[0])
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; below 1/2 it grows without bound at most dt. Errors: CD_ERROR_VALUE.
function Water:set_lambda(lambda)
  local where = "cd_water_set_lambda"
  lambda = number_in(lambda, where, "lambda")
  self._version = self._version + 1
  check(lib.cd_water_set_lambda(handle_of(self), lambda))
end

-- lambda of CD_METHOD_IMPLICIT, in [0, 1]; below 1/2 it grows without bound at most dt. Errors: CD_ERROR_VALUE.
function Water:get_lambda()
  local where = "cd_water_get_lambda"
  local out_lambda = double_1()
  check(lib.cd_water_get_lambda(handle_of(self), out_lambda))
  return tonumber(out_lambda[0])
end

-- Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for advected.
-- Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Water:set_momentum(momentum)
  local where = "cd_water_set_momentum"
  momentum = enum_in("cd_momentum", momentum, where, "momentum")
  self._version = self._version + 1
  check(lib.cd_water_set_momentum(handle_of(self), momentum))
end

-- Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for advected.
-- Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
function Water:get_momentum()
  local where = "cd_water_get_momentum"
  local out_momentum = cd_momentum_1()
  check(lib.cd_water_get_momentum(handle_of(self), out_momentum))
  return enum_out("cd_momentum", out_momentum[0])
end

-- Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns it
-- round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit. Errors: CD_ERROR_VALUE
-- for anything but 0 and 1.
function Water:set_first(along_y)
  local where = "cd_water_set_first"
  along_y = flag_in(along_y, where, "along_y")
  self._version = self._version + 1
  check(lib.cd_water_set_first(handle_of(self), along_y))
end

-- Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns it
-- round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit. Errors: CD_ERROR_VALUE
-- for anything but 0 and 1.
function Water:get_first()
  local where = "cd_water_get_first"
  local out_along_y = int32_t_1()
  check(lib.cd_water_get_first(handle_of(self), out_along_y))
  return out_along_y[0] ~= 0
end

-- Spreads a step over the caller's threads. Null turns it off. It costs memory, for work that threads do not share.
-- Errors: CD_ERROR_NULL for a table without run; CD_ERROR_MEMORY.
function Water:set_parallel(parallel)
  local where = "cd_water_set_parallel"
  self._version = self._version + 1
  check(lib.cd_water_set_parallel(handle_of(self), parallel))
  self._kept.parallel = parallel
end

-- The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
-- new water has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Water:set_kernels(kernels)
  local where = "cd_water_set_kernels"
  kernels = enum_in("cd_kernels", kernels, where, "kernels")
  self._version = self._version + 1
  check(lib.cd_water_set_kernels(handle_of(self), kernels))
end

-- The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
-- new water has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
-- CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
function Water:get_kernels()
  local where = "cd_water_get_kernels"
  local out_kernels = cd_kernels_1()
  check(lib.cd_water_get_kernels(handle_of(self), out_kernels))
  return enum_out("cd_kernels", out_kernels[0])
end

-- Gravity [m/s^2], 0 or in [1e-60, 1e6]; default 9.81.
function Water:set_gravity(gravity)
  local where = "cd_water_set_gravity"
  gravity = number_in(gravity, where, "gravity")
  self._version = self._version + 1
  check(lib.cd_water_set_gravity(handle_of(self), gravity))
end

-- Gravity [m/s^2], 0 or in [1e-60, 1e6]; default 9.81.
function Water:get_gravity()
  local where = "cd_water_get_gravity"
  local out_gravity = double_1()
  check(lib.cd_water_get_gravity(handle_of(self), out_gravity))
  return tonumber(out_gravity[0])
end

-- Density [kg/m^3], in [1e-6, 1e6]; default 1000. Only pressure, impulses and energies know it.
function Water:set_density(density)
  local where = "cd_water_set_density"
  density = number_in(density, where, "density")
  self._version = self._version + 1
  check(lib.cd_water_set_density(handle_of(self), density))
end

-- Density [kg/m^3], in [1e-6, 1e6]; default 1000. Only pressure, impulses and energies know it.
function Water:get_density()
  local where = "cd_water_get_density"
  local out_density = double_1()
  check(lib.cd_water_get_density(handle_of(self), out_density))
  return tonumber(out_density[0])
end

-- Drag [1/s], >= 0: velocities die out by exp(-drag t). Default 0.
function Water:set_drag(drag)
  local where = "cd_water_set_drag"
  drag = number_in(drag, where, "drag")
  self._version = self._version + 1
  check(lib.cd_water_set_drag(handle_of(self), drag))
end

-- Drag [1/s], >= 0: velocities die out by exp(-drag t). Default 0.
function Water:get_drag()
  local where = "cd_water_get_drag"
  local out_drag = double_1()
  check(lib.cd_water_get_drag(handle_of(self), out_drag))
  return tonumber(out_drag[0])
end

-- Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded wood.
-- Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning.
function Water:set_manning(manning)
  local where = "cd_water_set_manning"
  manning = number_in(manning, where, "manning")
  self._version = self._version + 1
  check(lib.cd_water_set_manning(handle_of(self), manning))
end

-- Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded wood.
-- Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning.
function Water:get_manning()
  local where = "cd_water_get_manning"
  local out_manning = double_1()
  check(lib.cd_water_get_manning(handle_of(self), out_manning))
  return tonumber(out_manning[0])
end

-- What is at a side. `value` now, and how fast it changes, `rate` per second, from now on, both at most 1e60 in size,
-- in CD_FLOAT32 1e30: CD_BORDER_OPEN level of the water outside [m], which is at rest: for a tide set level and rate
-- anew as it goes. Low waves leave without an echo; some hundredths of high ones come back. With d the depth in the
-- cell at the side, D the level's depth over the same bed, water leaves by u = 2 (sqrt(g d) - sqrt(g D)), linear by u =
-- sqrt(g d) (1 - D / d), and the discharge is u d. Where u is faster than waves, as over a side that lies higher than
-- the level, water falls off: a stream slower than its waves leaves at critical depth, u = sqrt(g d), a faster one as
-- it comes. CD_BORDER_LEVEL level [m] that is held at the side itself: with D its depth over the bed of the cell there
-- and q the discharge one face inside, what leaves tends, as waves cross half a cell, to q + 2 D (sqrt(g d) - sqrt(g
-- D)), advected with q D / d for q where d < D. Advected water that comes in at U stands U^2 / 2 g lower, at most D /
-- 3. Waves are thrown back; with lambda = 1/2 some may grow, slowly. What outruns its waves falls off as above.
-- CD_BORDER_INFLOW discharge per metre of the side [m^2/s] into the water, velocity times depth; into a cell below
-- critical depth it comes in at that. If negative it leaves, as far as there is water. CD_BORDER_WALL,
-- CD_BORDER_PERIODIC value and rate mean nothing Both sides of a direction are periodic or neither is: setting one sets
-- the other, and leaving it leaves both, the opposite one as a wall. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
function Water:set_side(side, kind, value, rate)
  local where = "cd_water_set_side"
  side = enum_in("cd_side", side, where, "side")
  kind = enum_in("cd_border", kind, where, "kind")
  value = number_in(value, where, "value")
  rate = number_in(rate, where, "rate")
  self._version = self._version + 1
  check(lib.cd_water_set_side(handle_of(self), side, kind, value, rate))
end

-- Value and rate as of now; 0 where they mean nothing. Each output may be null. Errors: CD_ERROR_ENUM.
function Water:get_side(side)
  local where = "cd_water_get_side"
  side = enum_in("cd_side", side, where, "side")
  local out_kind = cd_border_1()
  local out_value = double_1()
  local out_rate = double_1()
  check(lib.cd_water_get_side(handle_of(self), side, out_kind, out_value, out_rate))
  return enum_out("cd_border", out_kind[0]), tonumber(out_value[0]), tonumber(out_rate[0])
end

-- Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else advected water comes in
-- at the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has that depth in
-- the first cell; if slower, or if it drowns the gate, that of what comes after. Other sides, outflow and linear
-- momentum do not use it; cd_water_set_side keeps it. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
function Water:set_inflow_depth(side, depth)
  local where = "cd_water_set_inflow_depth"
  side = enum_in("cd_side", side, where, "side")
  depth = number_in(depth, where, "depth")
  self._version = self._version + 1
  check(lib.cd_water_set_inflow_depth(handle_of(self), side, depth))
end

-- Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else advected water comes in
-- at the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has that depth in
-- the first cell; if slower, or if it drowns the gate, that of what comes after. Other sides, outflow and linear
-- momentum do not use it; cd_water_set_side keeps it. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
function Water:get_inflow_depth(side)
  local where = "cd_water_get_inflow_depth"
  side = enum_in("cd_side", side, where, "side")
  local out_depth = double_1()
  check(lib.cd_water_get_inflow_depth(handle_of(self), side, out_depth))
  return tonumber(out_depth[0])
end

-- What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors: CD_ERROR_ENUM.
function Water:set_bed_rule(rule)
  local where = "cd_water_set_bed_rule"
  rule = enum_in("cd_bed_rule", rule, where, "rule")
  self._version = self._version + 1
  check(lib.cd_water_set_bed_rule(handle_of(self), rule))
end

-- What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors: CD_ERROR_ENUM.
function Water:get_bed_rule()
  local where = "cd_water_get_bed_rule"
  local out_rule = cd_bed_rule_1()
  check(lib.cd_water_get_bed_rule(handle_of(self), out_rule))
  return enum_out("cd_bed_rule", out_rule[0])
end

-- Switches a field on: no sources, pressure, force or walls yet, all cells there. On already: nothing happens. Errors:
-- CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for a field of other objects; CD_ERROR_MEMORY.
function Water:enable_field(field)
  local where = "cd_water_enable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_water_enable_field(handle_of(self), field))
end

-- Switches a field off and releases its memory. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED if it is always there.
function Water:disable_field(field)
  local where = "cd_water_disable_field"
  field = enum_in("cd_field", field, where, "field")
  self._version = self._version + 1
  check(lib.cd_water_disable_field(handle_of(self), field))
end

-- Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x [first_y, first_y
-- + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are rounded once,
-- to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
function Water:write_f32(field, first_x, first_y, n_x, n_y, values)
  local where = "cd_water_write_f32"
  field = enum_in("cd_field", field, where, "field")
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  local p_values, n_values = array_in("float", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_water_write_f32(handle_of(self), field, first_x, first_y, n_x, n_y, p_values, count))
end

-- Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x [first_y, first_y
-- + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are rounded once,
-- to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
function Water:write_f64(field, first_x, first_y, n_x, n_y, values)
  local where = "cd_water_write_f64"
  field = enum_in("cd_field", field, where, "field")
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  local p_values, n_values = array_in("double", values, where, "values")
  local count = count_of(n_values, 1, where, "values")
  self._version = self._version + 1
  check(lib.cd_water_write_f64(handle_of(self), field, first_x, first_y, n_x, n_y, p_values, count))
end

-- Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x [first_y, first_y
-- + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are rounded once,
-- to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
function Water:read_f32(field, first_x, first_y, n_x, n_y, out_values)
  local where = "cd_water_read_f32"
  field = enum_in("cd_field", field, where, "field")
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  local p_out_values, n_out_values = array_out("float", out_values, n_x * n_y * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_water_read_f32(handle_of(self), field, first_x, first_y, n_x, n_y, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x [first_y, first_y
-- + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are rounded once,
-- to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED,
-- CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
function Water:read_f64(field, first_x, first_y, n_x, n_y, out_values)
  local where = "cd_water_read_f64"
  field = enum_in("cd_field", field, where, "field")
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  local p_out_values, n_out_values = array_out("double", out_values, n_x * n_y * values_of(self, field), where,
      "out_values")
  local count = n_out_values or 0
  check(lib.cd_water_read_f64(handle_of(self), field, first_x, first_y, n_x, n_y, p_out_values, count))
  return array_result(out_values, p_out_values, n_out_values)
end

-- Where a field lies in the water's own memory, in its precision, to read without a copy: the value of (i, j) is at
-- byte *out_data + i * x_stride + j * y_stride. All but CD_SURFACE, CD_MASK and the walls. The pointer is good until
-- the field is switched off or the water released; the numbers change with every write and step. Do not write through
-- it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.
function Water:view(field)
  return support.view(self, enum_in("cd_field", field, "cd_water_view", "field"), function(handle, value)
    local data, strides = address_1(), strides_4()
    check(lib.cd_water_view(handle, value, data, strides + 0, strides + 1))
    return data[0], strides
  end, 2)
end

-- Adds volume [m^3] over a disc, or takes it if negative, as far as there is water in each cell's share. out_added,
-- which may be null, tells what it came to. The account counts it. Errors: CD_ERROR_VALUE, CD_ERROR_DIVERGED.
function Water:add_volume(x, y, radius, volume)
  local where = "cd_water_add_volume"
  x = number_in(x, where, "x")
  y = number_in(y, where, "y")
  radius = number_in(radius, where, "radius")
  volume = number_in(volume, where, "volume")
  local out_added = double_1()
  self._version = self._version + 1
  check(lib.cd_water_add_volume(handle_of(self), x, y, radius, volume, out_added))
  return tonumber(out_added[0])
end

-- Adds volume [m^3] evenly over the cells there of a rectangle, or takes it; out_added as above. Errors:
-- CD_ERROR_RANGE; CD_ERROR_VALUE, CD_ERROR_DIVERGED.
function Water:add_volume_rectangle(first_x, first_y, n_x, n_y, volume)
  local where = "cd_water_add_volume_rectangle"
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  volume = number_in(volume, where, "volume")
  local out_added = double_1()
  self._version = self._version + 1
  check(lib.cd_water_add_volume_rectangle(handle_of(self), first_x, first_y, n_x, n_y, volume, out_added))
  return tonumber(out_added[0])
end

-- Adds a source of rate [m^3/s] over a disc to CD_SOURCE, or a drain if negative, and switches that field on. Errors:
-- CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Water:add_source(x, y, radius, rate)
  local where = "cd_water_add_source"
  x = number_in(x, where, "x")
  y = number_in(y, where, "y")
  radius = number_in(radius, where, "radius")
  rate = number_in(rate, where, "rate")
  self._version = self._version + 1
  check(lib.cd_water_add_source(handle_of(self), x, y, radius, rate))
end

-- The same evenly over the cells there of a rectangle. Errors: CD_ERROR_RANGE; CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Water:add_source_rectangle(first_x, first_y, n_x, n_y, rate)
  local where = "cd_water_add_source_rectangle"
  first_x = integer_in(first_x, where, "first_x")
  first_y = integer_in(first_y, where, "first_y")
  n_x = integer_in(n_x, where, "n_x")
  n_y = integer_in(n_y, where, "n_y")
  rate = number_in(rate, where, "rate")
  self._version = self._version + 1
  check(lib.cd_water_add_source_rectangle(handle_of(self), first_x, first_y, n_x, n_y, rate))
end

-- A splash: water of the disc, down to `height` [m] >= 0 at its centre and as far as there is water, is heaped up on
-- the wet cells around it, out to twice the radius, if there are any; volume is kept. Errors: CD_ERROR_VALUE,
-- _DIVERGED.
function Water:splash(x, y, radius, height)
  local where = "cd_water_splash"
  x = number_in(x, where, "x")
  y = number_in(y, where, "y")
  radius = number_in(radius, where, "radius")
  height = number_in(height, where, "height")
  self._version = self._version + 1
  check(lib.cd_water_splash(handle_of(self), x, y, radius, height))
end

-- Adds an impulse (x, y) [N s] over a disc: a face's velocity changes by its share of it / the mass of water at it,
-- shares in proportion to that mass too; on dry faces nothing happens. Errors: CD_ERROR_VALUE, CD_ERROR_DIVERGED.
function Water:impulse(x, y, radius, impulse_x, impulse_y)
  local where = "cd_water_impulse"
  x = number_in(x, where, "x")
  y = number_in(y, where, "y")
  radius = number_in(radius, where, "radius")
  impulse_x = number_in(impulse_x, where, "impulse_x")
  impulse_y = number_in(impulse_y, where, "impulse_y")
  self._version = self._version + 1
  check(lib.cd_water_impulse(handle_of(self), x, y, radius, impulse_x, impulse_y))
end

-- How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along` and `n_across`, 1 to
-- 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls n_along
-- and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each output may be null.
function Water:set_hulls(count, n_along, n_across)
  local where = "cd_water_set_hulls"
  count = integer_in(count, where, "count")
  n_along = integer_in(n_along, where, "n_along")
  n_across = integer_in(n_across, where, "n_across")
  self._version = self._version + 1
  check(lib.cd_water_set_hulls(handle_of(self), count, n_along, n_across))
end

-- How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along` and `n_across`, 1 to
-- 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls n_along
-- and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each output may be null.
function Water:get_hulls()
  local where = "cd_water_get_hulls"
  local out_count = size_t_1()
  local out_n_along = size_t_1()
  local out_n_across = size_t_1()
  check(lib.cd_water_get_hulls(handle_of(self), out_count, out_n_along, out_n_across))
  return tonumber(out_count[0]), tonumber(out_n_along[0]), tonumber(out_n_across[0])
end

-- Makes a hull of a mass [kg] in [1e-12, 1e15] and length and width [m], >= 1e-60 and at most 512 cells. heights[j][i]:
-- of the floor's plate i along, j to port, above the keel [m], in [0, 1e60], or -1 where there is none; `count` is
-- n_along n_across; null: flat. Where it is, and how it moves, stays. Errors: CD_ERROR_VALUE, also for no plate.
function Water:set_hull(index, mass, length, width, heights)
  local where = "cd_water_set_hull"
  index = integer_in(index, where, "index")
  mass = number_in(mass, where, "mass")
  length = number_in(length, where, "length")
  width = number_in(width, where, "width")
  local p_heights, n_heights = array_in("double", heights, where, "heights", true)
  local count = count_of(n_heights, 1, where, "heights")
  self._version = self._version + 1
  check(lib.cd_water_set_hull(handle_of(self), index, mass, length, width, p_heights, count))
end

-- Makes a hull with a flat round floor: those plates of a square whose middles lie in the disc, all stretched so that
-- their area is the disc's. The radius [m] is >= 1e-60, the square at most 512 cells wide. Errors: CD_ERROR_VALUE.
function Water:set_disc(index, mass, radius)
  local where = "cd_water_set_disc"
  index = integer_in(index, where, "index")
  mass = number_in(mass, where, "mass")
  radius = number_in(radius, where, "radius")
  self._version = self._version + 1
  check(lib.cd_water_set_disc(handle_of(self), index, mass, radius))
end

-- What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be null; heights:
-- `count` of them, or null and any count.
function Water:get_hull(index, out_heights)
  local where = "cd_water_get_hull"
  index = integer_in(index, where, "index")
  local p_out_heights, n_out_heights = array_out("double", out_heights, nil, where, "out_heights")
  local count = n_out_heights or 0
  local out_mass = double_1()
  local out_length = double_1()
  local out_width = double_1()
  local out_area = double_1()
  check(lib.cd_water_get_hull(handle_of(self), index, out_mass, out_length, out_width, out_area, p_out_heights, count))
  return tonumber(out_mass[0]), tonumber(out_length[0]), tonumber(out_width[0]), tonumber(out_area[0]),
      array_result(out_heights, p_out_heights, n_out_heights)
end

-- What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be null; heights:
-- `count` of them, or null and any count.
function Water:remove_hull(index)
  local where = "cd_water_remove_hull"
  index = integer_in(index, where, "index")
  self._version = self._version + 1
  check(lib.cd_water_remove_hull(handle_of(self), index))
end

-- Launches a hull at (x, y) in the scene, its bow towards (ahead_x, ahead_y) of any length but 0, at rest. It lies as
-- it would in time. The water that it displaces goes, evenly, to all cells whose surface is within its draft of that
-- under it; where there is no such cell, or the bed bears it, it displaces none. What it displaced before is not given
-- back: to move a hull set its pose. Errors: CD_ERROR_VALUE; CD_ERROR_DISABLED if it has no mass, or no cell is under
-- it, or gravity is 0; CD_ERROR_DIVERGED of a water that did.
function Water:launch_hull(index, x, y, ahead_x, ahead_y)
  local where = "cd_water_launch_hull"
  index = integer_in(index, where, "index")
  x = number_in(x, where, "x")
  y = number_in(y, where, "y")
  ahead_x = number_in(ahead_x, where, "ahead_x")
  ahead_y = number_in(ahead_y, where, "ahead_y")
  self._version = self._version + 1
  check(lib.cd_water_launch_hull(handle_of(self), index, x, y, ahead_x, ahead_y))
end

-- The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most 1e15
-- in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
-- that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with its
-- keel a third of the water's depth below the bed it presses all water away. Errors: CD_ERROR_VALUE.
function Water:set_hull_pose(index, pose)
  local where = "cd_water_set_hull_pose"
  index = integer_in(index, where, "index")
  local p_pose, n_pose = array_in("double", pose, where, "pose")
  local count = count_of(n_pose, 1, where, "pose")
  self._version = self._version + 1
  check(lib.cd_water_set_hull_pose(handle_of(self), index, p_pose, count))
end

-- The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most 1e15
-- in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
-- that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with its
-- keel a third of the water's depth below the bed it presses all water away. Errors: CD_ERROR_VALUE.
function Water:get_hull_pose(index, out_pose)
  local where = "cd_water_get_hull_pose"
  index = integer_in(index, where, "index")
  local p_out_pose, n_out_pose = array_out("double", out_pose, nil, where, "out_pose")
  local count = n_out_pose or 0
  check(lib.cd_water_get_hull_pose(handle_of(self), index, p_out_pose, count))
  return array_result(out_pose, p_out_pose, n_out_pose)
end

-- The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most 1e15
-- in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
-- that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with its
-- keel a third of the water's depth below the bed it presses all water away. Errors: CD_ERROR_VALUE.
function Water:set_hull_velocity(index, velocity)
  local where = "cd_water_set_hull_velocity"
  index = integer_in(index, where, "index")
  local p_velocity, n_velocity = array_in("double", velocity, where, "velocity")
  local count = count_of(n_velocity, 1, where, "velocity")
  self._version = self._version + 1
  check(lib.cd_water_set_hull_velocity(handle_of(self), index, p_velocity, count))
end

-- The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most 1e15
-- in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
-- that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with its
-- keel a third of the water's depth below the bed it presses all water away. Errors: CD_ERROR_VALUE.
function Water:get_hull_velocity(index, out_velocity)
  local where = "cd_water_get_hull_velocity"
  index = integer_in(index, where, "index")
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, nil, where, "out_velocity")
  local count = n_out_velocity or 0
  check(lib.cd_water_get_hull_velocity(handle_of(self), index, p_out_velocity, count))
  return array_result(out_velocity, p_out_velocity, n_out_velocity)
end

-- The pose in which the floor lies on the water since the last step or launch, to be drawn: 7 numbers.
function Water:get_hull_floor(index, out_pose)
  local where = "cd_water_get_hull_floor"
  index = integer_in(index, where, "index")
  local p_out_pose, n_out_pose = array_out("double", out_pose, nil, where, "out_pose")
  local count = n_out_pose or 0
  check(lib.cd_water_get_hull_floor(handle_of(self), index, p_out_pose, count))
  return array_result(out_pose, p_out_pose, n_out_pose)
end

-- What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up [N] and
-- moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors: CD_ERROR_VALUE.
function Water:set_hull_force(index, force)
  local where = "cd_water_set_hull_force"
  index = integer_in(index, where, "index")
  local p_force, n_force = array_in("double", force, where, "force")
  local count = count_of(n_force, 1, where, "force")
  self._version = self._version + 1
  check(lib.cd_water_set_hull_force(handle_of(self), index, p_force, count))
end

-- What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up [N] and
-- moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors: CD_ERROR_VALUE.
function Water:get_hull_force(index, out_force)
  local where = "cd_water_get_hull_force"
  index = integer_in(index, where, "index")
  local p_out_force, n_out_force = array_out("double", out_force, nil, where, "out_force")
  local count = n_out_force or 0
  check(lib.cd_water_get_hull_force(handle_of(self), index, p_out_force, count))
  return array_result(out_force, p_out_force, n_out_force)
end

-- Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and Coulomb friction
-- on the bed; in [0, 1e30], default 0. Errors: CD_ERROR_VALUE.
function Water:set_hull_drag(index, along, across, friction)
  local where = "cd_water_set_hull_drag"
  index = integer_in(index, where, "index")
  along = number_in(along, where, "along")
  across = number_in(across, where, "across")
  friction = number_in(friction, where, "friction")
  self._version = self._version + 1
  check(lib.cd_water_set_hull_drag(handle_of(self), index, along, across, friction))
end

-- Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and Coulomb friction
-- on the bed; in [0, 1e30], default 0. Errors: CD_ERROR_VALUE.
function Water:get_hull_drag(index)
  local where = "cd_water_get_hull_drag"
  index = integer_in(index, where, "index")
  local out_along = double_1()
  local out_across = double_1()
  local out_friction = double_1()
  check(lib.cd_water_get_hull_drag(handle_of(self), index, out_along, out_across, out_friction))
  return tonumber(out_along[0]), tonumber(out_across[0]), tonumber(out_friction[0])
end

-- What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up [N], moments yaw, pitch, roll [N m].
function Water:get_hull_load(index, out_load)
  local where = "cd_water_get_hull_load"
  index = integer_in(index, where, "index")
  local p_out_load, n_out_load = array_out("double", out_load, nil, where, "out_load")
  local count = n_out_load or 0
  check(lib.cd_water_get_hull_load(handle_of(self), index, p_out_load, count))
  return array_result(out_load, p_out_load, n_out_load)
end

-- Energies of all hulls [J]: of their motion; mass g z, and what their skins hold. Each output may be null.
function Water:get_hull_energy()
  local where = "cd_water_get_hull_energy"
  local out_kinetic = double_1()
  local out_potential = double_1()
  check(lib.cd_water_get_hull_energy(handle_of(self), out_kinetic, out_potential))
  return tonumber(out_kinetic[0]), tonumber(out_potential[0])
end

-- How high [m] the water would stand at n places, at[k] = {x, y}, with no hull pressing on it: its surface and the head
-- that hulls press with. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for more than fit in
-- memory.
function Water:sample_heads(at, outside, out_heads)
  local where = "cd_water_sample_heads"
  local p_at, n_at = array_in("double", at, where, "at")
  if outside == nil then outside = "refused" end
  outside = enum_in("cd_outside", outside, where, "outside")
  local n = count_of(n_at, 2, where, "at")
  local p_out_heads, n_out_heads = array_out("double", out_heads, n, where, "out_heads")
  same(n_out_heads, n * 1, where, "out_heads")
  check(lib.cd_water_sample_heads(handle_of(self), p_at, n, outside, p_out_heads))
  return array_result(out_heads, p_out_heads, n_out_heads)
end

-- Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps. Never allocates.
-- Time is proportional to count * cells, and to the parts that steps are made in (see above). Errors: CD_ERROR_VALUE;
-- CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives the first bad one, the
-- water can be read, and steps again after cd_water_reset, a load, or once finite depths and velocities have been
-- written.
function Water:step(dt, count)
  local where = "cd_water_step"
  dt = number_in(dt, where, "dt")
  if count == nil then count = 1 end
  count = integer_in(count, where, "count")
  self._version = self._version + 1
  check(lib.cd_water_step(handle_of(self), dt, count))
end

-- The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded for small waves on the water as it lies now,
-- whatever method is set: the least of both axes, each exact in the limit of many cells for water of one depth, a safe
-- lower bound otherwise; for a stream over an uneven bed take 0.8 of it. INFINITY if nothing can swing.
function Water:stable_dt()
  local where = "cd_water_stable_dt"
  local out_dt = double_1()
  check(lib.cd_water_stable_dt(handle_of(self), out_dt))
  return tonumber(out_dt[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Water:get_time()
  local where = "cd_water_get_time"
  local out_time = double_1()
  check(lib.cd_water_get_time(handle_of(self), out_time))
  return tonumber(out_time[0])
end

-- Simulated time [s] and steps made since create or reset, those before a load or a copied state included.
function Water:get_steps()
  local where = "cd_water_get_steps"
  local out_steps = uint64_t_1()
  check(lib.cd_water_get_steps(handle_of(self), out_steps))
  return out_steps[0]
end

-- How many times lines have been solved along a direction since the water was made: of every sweep the most parts that
-- a line made its step in, each a factorization of its own, since depths change. Not part of the saved state.
function Water:get_factorizations()
  local where = "cd_water_get_factorizations"
  local out_count = uint64_t_1()
  check(lib.cd_water_get_factorizations(handle_of(self), out_count))
  return out_count[0]
end

-- What the last call of cd_water_step had to hold back so that no cell gave more than it had and got: in how many
-- cells, counted once per sweep and part, and how much less water [m^3] went through faces. Each output may be null.
function Water:get_limited()
  local where = "cd_water_get_limited"
  local out_cells = uint64_t_1()
  local out_volume = double_1()
  check(lib.cd_water_get_limited(handle_of(self), out_cells, out_volume))
  return out_cells[0], tonumber(out_volume[0])
end

-- Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all waves
-- are lower than `height` [m], in [0, 1e60], and so are all that a step could carry there. Default 0: nothing sleeps.
-- Neglected are, at each face, a rise of the surface below height / 16, a velocity below height sqrt(g / d), and water
-- that stands less than the height over the higher bed. What falls asleep stops, so energy is lost and none gained;
-- volume is kept. Waves lower than the height meet sleeping water as a wall. The energy bound of long steps, which is
-- one of whole lines, is then one of what is awake of a line. Awake stay parts with sources or forces, under hulls, and
-- at open, level and inflow sides; and all of the water while there are higher waves at a periodic side. Which parts
-- sleep follows from the state alone, whatever hook and kernels; where all are awake a step has the bits of one of
-- water that never sleeps. A step's time is in proportion to the cells awake, each up to half as dear again. A splash,
-- a volume, an impulse, a write of cells or faces and what is set of a hull wake what they touch; after any other call
-- that may change the water the next step looks at all of it, in half a step's time. Costs a byte for ten cells. The
-- height is kept with the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Water:set_sleep(height)
  local where = "cd_water_set_sleep"
  height = number_in(height, where, "height")
  self._version = self._version + 1
  check(lib.cd_water_set_sleep(handle_of(self), height))
end

-- Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all waves
-- are lower than `height` [m], in [0, 1e60], and so are all that a step could carry there. Default 0: nothing sleeps.
-- Neglected are, at each face, a rise of the surface below height / 16, a velocity below height sqrt(g / d), and water
-- that stands less than the height over the higher bed. What falls asleep stops, so energy is lost and none gained;
-- volume is kept. Waves lower than the height meet sleeping water as a wall. The energy bound of long steps, which is
-- one of whole lines, is then one of what is awake of a line. Awake stay parts with sources or forces, under hulls, and
-- at open, level and inflow sides; and all of the water while there are higher waves at a periodic side. Which parts
-- sleep follows from the state alone, whatever hook and kernels; where all are awake a step has the bits of one of
-- water that never sleeps. A step's time is in proportion to the cells awake, each up to half as dear again. A splash,
-- a volume, an impulse, a write of cells or faces and what is set of a hull wake what they touch; after any other call
-- that may change the water the next step looks at all of it, in half a step's time. Costs a byte for ten cells. The
-- height is kept with the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
function Water:get_sleep()
  local where = "cd_water_get_sleep"
  local out_height = double_1()
  check(lib.cd_water_get_sleep(handle_of(self), out_height))
  return tonumber(out_height[0])
end

-- How many cells were awake in the last step; all, before it and where nothing sleeps. Not part of the saved state.
function Water:get_awake()
  local where = "cd_water_get_awake"
  local out_cells = size_t_1()
  check(lib.cd_water_get_awake(handle_of(self), out_cells))
  return tonumber(out_cells[0])
end

-- Volume [m^3]: the sum of all depths times the cells' area.
function Water:get_volume()
  local where = "cd_water_get_volume"
  local out_volume = double_1()
  check(lib.cd_water_get_volume(handle_of(self), out_volume))
  return tonumber(out_volume[0])
end

-- The volume account [m^3], kept in double whatever the precision: what was there when it was started (by create,
-- reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in since then (sides,
-- sources, volumes added, beds that keep the surface), what went out, and what the present volume has above initial +
-- in - out, which is rounding. Each output may be null.
function Water:get_account()
  local where = "cd_water_get_account"
  local out_initial = double_1()
  local out_in = double_1()
  local out_out = double_1()
  local out_error = double_1()
  check(lib.cd_water_get_account(handle_of(self), out_initial, out_in, out_out, out_error))
  return tonumber(out_initial[0]), tonumber(out_in[0]), tonumber(out_out[0]), tonumber(out_error[0])
end

-- The volume account [m^3], kept in double whatever the precision: what was there when it was started (by create,
-- reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in since then (sides,
-- sources, volumes added, beds that keep the surface), what went out, and what the present volume has above initial +
-- in - out, which is rounding. Each output may be null.
function Water:restart_account()
  local where = "cd_water_restart_account"
  self._version = self._version + 1
  check(lib.cd_water_restart_account(handle_of(self)))
end

-- Energies [J]; each output may be null. Kinetic: density / 2 times area, mean depth of both cells and velocity^2 of
-- faces, at a shore as steps begin with it. Potential: density g times area, depth and height of the column's middle.
function Water:get_energy()
  local where = "cd_water_get_energy"
  local out_kinetic = double_1()
  local out_potential = double_1()
  check(lib.cd_water_get_energy(handle_of(self), out_kinetic, out_potential))
  return tonumber(out_kinetic[0]), tonumber(out_potential[0])
end

-- Area [m^2] of the cells with depth > 0.
function Water:get_wet_area()
  local where = "cd_water_get_wet_area"
  local out_area = double_1()
  check(lib.cd_water_get_wet_area(handle_of(self), out_area))
  return tonumber(out_area[0])
end

-- The largest Courant number of a step of dt [s], in [0, 1e30], over directions and wet faces: (|u| + sqrt(g d)) dt /
-- dx. Errors: CD_ERROR_VALUE.
function Water:get_courant(dt)
  local where = "cd_water_get_courant"
  dt = number_in(dt, where, "dt")
  local out_courant = double_1()
  check(lib.cd_water_get_courant(handle_of(self), dt, out_courant))
  return tonumber(out_courant[0])
end

-- The water at n places, at[k] = {x, y} in metres inside the scene: surface [m] and depth [m], bilinear between cell
-- centres that are there, level beyond the outermost ones; normal of the surface (3 numbers, unit length, z up);
-- velocity [m/s] (2 numbers), bilinear between faces. A dry place has the bed for its surface. Each output may be null.
-- Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for more than fit in memory.
function Water:sample(at, outside, out_surface, out_depth, out_normal, out_velocity)
  local where = "cd_water_sample"
  local p_at, n_at = array_in("double", at, where, "at")
  if outside == nil then outside = "refused" end
  outside = enum_in("cd_outside", outside, where, "outside")
  local n = count_of(n_at, 2, where, "at")
  local p_out_surface, n_out_surface = array_out("double", out_surface, n, where, "out_surface")
  local p_out_depth, n_out_depth = array_out("double", out_depth, n, where, "out_depth")
  local p_out_normal, n_out_normal = array_out("double", out_normal, n * 3, where, "out_normal")
  local p_out_velocity, n_out_velocity = array_out("double", out_velocity, n * 2, where, "out_velocity")
  same(n_out_surface, n * 1, where, "out_surface")
  same(n_out_depth, n * 1, where, "out_depth")
  same(n_out_normal, n * 3, where, "out_normal")
  same(n_out_velocity, n * 2, where, "out_velocity")
  check(lib.cd_water_sample(handle_of(self), p_at, n, outside, p_out_surface, p_out_depth, p_out_normal,
      p_out_velocity))
  return array_result(out_surface, p_out_surface, n_out_surface), array_result(out_depth, p_out_depth, n_out_depth),
      array_result(out_normal, p_out_normal, n_out_normal), array_result(out_velocity, p_out_velocity, n_out_velocity)
end

-- Bytes the water holds from its allocator.
function Water:get_memory()
  local where = "cd_water_get_memory"
  local out_bytes = size_t_1()
  check(lib.cd_water_get_memory(handle_of(self), out_bytes))
  return tonumber(out_bytes[0])
end

-- A 64-bit hash of everything cd_water_save would write. Equal on every machine, compiler and vector width.
function Water:hash()
  local where = "cd_water_hash"
  local out_hash = uint64_t_1()
  check(lib.cd_water_hash(handle_of(self), out_hash))
  return out_hash[0]
end

-- Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k at byte k *
-- stride, its position, the cell's centre on the surface, as 3 floats at position_offset; its unit normal as 3 floats
-- at normal_offset; its depth as 1 float at depth_offset, 0 where it is dry and -1 where the cell is absent, for a
-- shader to fade out shores. normal_offset or depth_offset SIZE_MAX: none. Bytes between are left alone; any offset and
-- stride will do that keeps them apart. Errors: CD_ERROR_RANGE if size is less than cells * stride, or an offset and
-- its bytes reach past stride, or two overlap.
function Water:write_vertices(buffer, stride, position_offset, normal_offset, depth_offset)
  local where = "cd_water_write_vertices"
  local p_buffer, n_buffer = bytes_out(buffer, nil, where, "buffer")
  stride = integer_in(stride, where, "stride")
  position_offset = integer_in(position_offset, where, "position_offset")
  normal_offset = integer_in(normal_offset, where, "normal_offset")
  depth_offset = integer_in(depth_offset, where, "depth_offset")
  local size = n_buffer
  check(lib.cd_water_write_vertices(handle_of(self), p_buffer, size, stride, position_offset, normal_offset,
      depth_offset))
end

-- How many indices cd_water_write_indices writes now: 6 per square of four neighbouring cells that are there, 3 per
-- square of which three are. skip_dry 1: squares without a wet cell are left out, so that it changes with the water.
-- Errors: CD_ERROR_VALUE for a skip_dry neither 0 nor 1.
function Water:get_index_count(skip_dry)
  local where = "cd_water_get_index_count"
  skip_dry = flag_in(skip_dry, where, "skip_dry")
  local out_count = size_t_1()
  check(lib.cd_water_get_index_count(handle_of(self), skip_dry, out_count))
  return tonumber(out_count[0])
end

-- Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order), counter-
-- clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and 2^32 - 1 with 4 are never
-- written. Errors: CD_ERROR_VALUE for another index_size, or skip_dry neither 0 nor 1; CD_ERROR_RANGE if size is too
-- small; CD_ERROR_UNSUPPORTED for more than 65535 or 2^32 - 1 cells.
function Water:write_indices(skip_dry, buffer, index_size)
  local where = "cd_water_write_indices"
  skip_dry = flag_in(skip_dry, where, "skip_dry")
  local p_buffer, n_buffer = bytes_out(buffer, nil, where, "buffer")
  index_size = integer_in(index_size, where, "index_size")
  local size = n_buffer
  check(lib.cd_water_write_indices(handle_of(self), skip_dry, p_buffer, size, index_size))
end

-- The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
-- Little-endian on every machine, versioned, with a checksum. save needs size >= cd_water_save_size and tells what it
-- wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields on
-- and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused. Errors:
-- save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Water:save_size()
  local where = "cd_water_save_size"
  local out_size = size_t_1()
  check(lib.cd_water_save_size(handle_of(self), out_size))
  return tonumber(out_size[0])
end

-- The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
-- Little-endian on every machine, versioned, with a checksum. save needs size >= cd_water_save_size and tells what it
-- wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields on
-- and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused. Errors:
-- save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Water:save(buffer)
  local where = "cd_water_save"
  local p_buffer, n_buffer = bytes_out(buffer, self:save_size(), where, "buffer")
  local size = n_buffer
  local out_written = size_t_1()
  check(lib.cd_water_save(handle_of(self), p_buffer, size, out_written))
  if buffer == nil then return string_of(p_buffer, tonumber(out_written[0])) end
  return tonumber(out_written[0])
end

-- The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
-- Little-endian on every machine, versioned, with a checksum. save needs size >= cd_water_save_size and tells what it
-- wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields on
-- and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused. Errors:
-- save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Water:load(bytes)
  local where = "cd_water_load"
  local p_bytes, n_bytes = bytes_in(bytes, where, "bytes")
  local size = n_bytes
  self._version = self._version + 1
  check(lib.cd_water_load(handle_of(self), p_bytes, size))
end

-- Makes `water` what `source` is, as save and load would, without the bytes: the two must agree in cells and precision.
-- Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
function Water:copy_state(source)
  local where = "cd_water_copy_state"
  self._version = self._version + 1
  check(lib.cd_water_copy_state(handle_of(self), handle_of(source)))
end

-- Depths, velocities, time, steps and account back to 0, hulls to where new ones lie, at rest. Bed, parameters and the
-- other fields stay, and what hulls are. What is at sides begins again with time: a level or discharge that changes is
-- what it was at time 0, or by its rate would have been if it was set later; then set it anew.
function Water:reset()
  local where = "cd_water_reset"
  self._version = self._version + 1
  check(lib.cd_water_reset(handle_of(self)))
end

return api
