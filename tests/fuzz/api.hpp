// The functions that chain, membrane and water have in common, as three types with the same members; and where the
// numbers of a field lie, told the same way for all three.
#ifndef FUZZ_API_HPP
#define FUZZ_API_HPP

#include <contdyn/contdyn.h>

#include <type_traits>

namespace fuzz {

// A part of a field. "Outer" counts what lies further apart in the caller's buffer: strands of a chain, rows of a
// sheet.
struct Part {
    size_t outer, outer_count, inner, inner_count;
    size_t count; // of numbers in the buffer
};

// How large a field is.
struct Extent {
    size_t outer, inner, components;
    size_t count() const { return outer * inner * components; }
};

// What cd_*_view tells.
struct View {
    const void* data;
    size_t outer_stride, inner_stride, component_stride;
};

#define FUZZ_API(Name, object)                                                       \
    struct Name {                                                                    \
        using Handle = cd_##object;                                                  \
        static constexpr const char* name = #object;                                 \
        static constexpr auto destroy = cd_##object##_destroy;                       \
        static constexpr auto set_method = cd_##object##_set_method;                 \
        static constexpr auto get_method = cd_##object##_get_method;                 \
        static constexpr auto set_lambda = cd_##object##_set_lambda;                 \
        static constexpr auto get_lambda = cd_##object##_get_lambda;                 \
        static constexpr auto set_parallel = cd_##object##_set_parallel;             \
        static constexpr auto set_kernels = cd_##object##_set_kernels;               \
        static constexpr auto get_kernels = cd_##object##_get_kernels;               \
        static constexpr auto set_drag = cd_##object##_set_drag;                     \
        static constexpr auto get_drag = cd_##object##_get_drag;                     \
        static constexpr auto enable_field = cd_##object##_enable_field;             \
        static constexpr auto disable_field = cd_##object##_disable_field;           \
        static constexpr auto write_f32 = cd_##object##_write_f32;                   \
        static constexpr auto write_f64 = cd_##object##_write_f64;                   \
        static constexpr auto read_f32 = cd_##object##_read_f32;                     \
        static constexpr auto read_f64 = cd_##object##_read_f64;                     \
        static constexpr auto step = cd_##object##_step;                             \
        static constexpr auto stable_dt = cd_##object##_stable_dt;                   \
        static constexpr auto get_time = cd_##object##_get_time;                     \
        static constexpr auto get_steps = cd_##object##_get_steps;                   \
        static constexpr auto get_factorizations = cd_##object##_get_factorizations; \
        static constexpr auto get_memory = cd_##object##_get_memory;                 \
        static constexpr auto hash = cd_##object##_hash;                             \
        static constexpr auto save_size = cd_##object##_save_size;                   \
        static constexpr auto save = cd_##object##_save;                             \
        static constexpr auto load = cd_##object##_load;                             \
        static constexpr auto copy_state = cd_##object##_copy_state;                 \
        static constexpr auto reset = cd_##object##_reset;                           \
    }
FUZZ_API(ChainApi, chain);
FUZZ_API(MembraneApi, membrane);
FUZZ_API(WaterApi, water);
#undef FUZZ_API

// Those of what ropes and cloth touch.
template <class Api> struct Colliders;
#define FUZZ_COLLIDERS(Name, object)                                                       \
    template <> struct Colliders<Name> {                                                   \
        static constexpr auto set_colliders = cd_##object##_set_colliders;                 \
        static constexpr auto get_colliders = cd_##object##_get_colliders;                 \
        static constexpr auto set_plane = cd_##object##_set_plane;                         \
        static constexpr auto set_capsule = cd_##object##_set_capsule;                     \
        static constexpr auto set_bed = cd_##object##_set_bed;                             \
        static constexpr auto get_bed = cd_##object##_get_bed;                             \
        static constexpr auto set_callback = cd_##object##_set_callback;                   \
        static constexpr auto remove_collider = cd_##object##_remove_collider;             \
        static constexpr auto set_collider_velocity = cd_##object##_set_collider_velocity; \
        static constexpr auto get_collider = cd_##object##_get_collider;                   \
        static constexpr auto set_thickness = cd_##object##_set_thickness;                 \
        static constexpr auto get_thickness = cd_##object##_get_thickness;                 \
        static constexpr auto set_loads = cd_##object##_set_loads;                         \
        static constexpr auto get_loads = cd_##object##_get_loads;                         \
        static constexpr auto get_collider_load = cd_##object##_get_collider_load;         \
    }
FUZZ_COLLIDERS(ChainApi, chain);
FUZZ_COLLIDERS(MembraneApi, membrane);
#undef FUZZ_COLLIDERS

// Calls a function that writes or reads a field. A chain's take strands first, a sheet's take what lies closest first.
template <class Api, class Function, class Number>
cd_status on_part(Function function, typename Api::Handle* handle, cd_field field, const Part& p, Number* numbers) {
    if constexpr (std::is_same<Api, ChainApi>::value)
        return function(handle, field, p.outer, p.outer_count, p.inner, p.inner_count, numbers, p.count);
    else return function(handle, field, p.inner, p.outer, p.inner_count, p.outer_count, numbers, p.count);
}

} // namespace fuzz

#endif
