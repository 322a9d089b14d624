// contdyn for C++17: chain, membrane and water as classes over the C functions of libcontdyn, and nothing to link
// beside it.
//
// Every C function is here under its name less the prefix: cd_chain_set_mass(chain, 2) is rope.set_mass(2). What a
// function does, its shapes, units, valid ranges and errors, is told in the C header of the same name; here a line
// tells which one it is, and the shape of what spans hold. What one output was is returned; what several were is
// returned as a struct with their names. A flag, 0 or 1 in C, is a bool.
//
// Errors: with CONTDYN_EXCEPTIONS 1, the default where exceptions are on, a failed call throws contdyn::error. With 0
// nothing throws: functions return a contdyn::status, or a contdyn::result<T> where they return a T here. Parts of a
// program may choose differently, and between C++17 and C++20, but not hand these objects to each other: give handle().
//
// An object that was moved from, destroyed or never made holds no handle: calls on it fail with error_null.
//
// Made by generate.py from templates/ and bindings/api.json.
#ifndef CONTDYN_CONTDYN_HPP
#define CONTDYN_CONTDYN_HPP

#if __cplusplus < 201703L && !defined(_MSVC_LANG)
#error "contdyn.hpp needs C++17"
#endif

#include <contdyn/contdyn.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#ifndef CONTDYN_EXCEPTIONS
#ifdef __cpp_exceptions
#define CONTDYN_EXCEPTIONS 1
#else
#define CONTDYN_EXCEPTIONS 0
#endif
#endif

#if CONTDYN_EXCEPTIONS
#include <stdexcept>
#endif
#if __cplusplus >= 202002L && __has_include(<span>)
#include <span>
#endif

namespace contdyn {

// ---- enumerations ---------------------------------------------------------------------------------------------------

// What became of a call.
enum class [[nodiscard]] status : std::int32_t {
    ok = CD_OK,
    error_null = CD_ERROR_NULL,
    error_handle = CD_ERROR_HANDLE,
    error_value = CD_ERROR_VALUE,
    error_enum = CD_ERROR_ENUM,
    error_range = CD_ERROR_RANGE,
    error_size = CD_ERROR_SIZE,
    error_memory = CD_ERROR_MEMORY,
    error_disabled = CD_ERROR_DISABLED,
    error_unsupported = CD_ERROR_UNSUPPORTED,
    error_diverged = CD_ERROR_DIVERGED,
    error_format = CD_ERROR_FORMAT,
    error_mismatch = CD_ERROR_MISMATCH,
    error_tolerance = CD_ERROR_TOLERANCE,
    error_callback = CD_ERROR_CALLBACK
};

// What becomes of places outside of an object that it is sampled at.
enum class outside : std::int32_t { refused = CD_OUTSIDE_REFUSED, nearest = CD_OUTSIDE_NEAREST };

// The kinds of objects.
enum class kind : std::int32_t { chain = CD_KIND_CHAIN, membrane = CD_KIND_MEMBRANE, water = CD_KIND_WATER };

// What an object stores and computes in.
enum class precision : std::int32_t { float32 = CD_FLOAT32, float64 = CD_FLOAT64 };

// How a step advances the state by dt.
enum class method : std::int32_t {
    implicit = CD_METHOD_IMPLICIT,
    forward_euler = CD_METHOD_FORWARD_EULER,
    symplectic_euler = CD_METHOD_SYMPLECTIC_EULER,
    stiff_second = CD_METHOD_STIFF_SECOND
};

// How the two-dimensional system of an implicit step is solved.
enum class solver : std::int32_t {
    alternating = CD_SOLVER_ALTERNATING,
    coupled = CD_SOLVER_COUPLED,
    auto_ = CD_SOLVER_AUTO
};

// How the total mass is dealt out to the nodes.
enum class mass_rule : std::int32_t { equal = CD_MASS_EQUAL, half_ends = CD_MASS_HALF_ENDS };

// The instructions that steps are made of.
enum class kernels : std::int32_t { plain = CD_KERNELS_PLAIN, avx2 = CD_KERNELS_AVX2, avx512 = CD_KERNELS_AVX512 };

// What holds a node.
enum class node : std::int32_t {
    free = CD_NODE_FREE,
    pinned = CD_NODE_PINNED,
    driven = CD_NODE_DRIVEN,
    matched = CD_NODE_MATCHED,
    posed = CD_NODE_POSED
};

// What a collider of ropes and cloth is.
enum class shape : std::int32_t {
    none = CD_SHAPE_NONE,
    plane = CD_SHAPE_PLANE,
    capsule = CD_SHAPE_CAPSULE,
    bed = CD_SHAPE_BED,
    callback = CD_SHAPE_CALLBACK
};

// Per-node and per-spring data.
enum class field : std::int32_t {
    position = CD_POSITION,
    velocity = CD_VELOCITY,
    force = CD_FORCE,
    mass = CD_MASS,
    stiffness = CD_STIFFNESS,
    bend = CD_BEND,
    pin = CD_PIN,
    target = CD_TARGET,
    stiffness_u = CD_STIFFNESS_U,
    stiffness_v = CD_STIFFNESS_V,
    mask = CD_MASK,
    depth = CD_DEPTH,
    bed = CD_BED,
    surface = CD_SURFACE,
    velocity_x = CD_VELOCITY_X,
    velocity_y = CD_VELOCITY_Y,
    source = CD_SOURCE,
    pressure = CD_PRESSURE,
    force_x = CD_FORCE_X,
    force_y = CD_FORCE_Y,
    wall_x = CD_WALL_X,
    wall_y = CD_WALL_Y,
    rest_length = CD_REST_LENGTH,
    tension = CD_TENSION,
    wind = CD_WIND,
    strength = CD_STRENGTH,
    strain = CD_STRAIN,
    rest_length_u = CD_REST_LENGTH_U,
    rest_length_v = CD_REST_LENGTH_V,
    tension_u = CD_TENSION_U,
    tension_v = CD_TENSION_V,
    strain_u = CD_STRAIN_U,
    strain_v = CD_STRAIN_V,
    breaking_strain_u = CD_BREAKING_STRAIN_U,
    breaking_strain_v = CD_BREAKING_STRAIN_V,
    rest_angle = CD_REST_ANGLE
};

// The two ends of a chain.
enum class end : std::int32_t { first = CD_END_FIRST, last = CD_END_LAST };

// The four edges of a membrane.
enum class edge : std::int32_t {
    u_first = CD_EDGE_U_FIRST,
    u_last = CD_EDGE_U_LAST,
    v_first = CD_EDGE_V_FIRST,
    v_last = CD_EDGE_V_LAST
};

// The four sides.
enum class side : std::int32_t {
    x_first = CD_SIDE_X_FIRST,
    x_last = CD_SIDE_X_LAST,
    y_first = CD_SIDE_Y_FIRST,
    y_last = CD_SIDE_Y_LAST
};

// What is at a side.
enum class border : std::int32_t {
    wall = CD_BORDER_WALL,
    open = CD_BORDER_OPEN,
    inflow = CD_BORDER_INFLOW,
    periodic = CD_BORDER_PERIODIC,
    level = CD_BORDER_LEVEL
};

// Whether water carries its momentum along.
enum class momentum : std::int32_t { linear = CD_MOMENTUM_LINEAR, advected = CD_MOMENTUM_ADVECTED };

// What a write to CD_BED leaves as it is.
enum class bed_rule : std::int32_t { lifts_water = CD_BED_LIFTS_WATER, keeps_surface = CD_BED_KEEPS_SURFACE };

// ---- what the library says of itself --------------------------------------------------------------------------------

inline const char* status_name(status s) { return cd_status_name(static_cast<cd_status>(s)); }
inline std::uint32_t version() { return cd_version(); }
inline const char* version_string() { return cd_version_string(); }
inline const char* build_info() { return cd_build_info(); }
inline const char* kernels_name(kernels k) { return cd_kernels_name(static_cast<cd_kernels>(k)); }

// Those that this build has and this processor runs, the fastest last.
inline std::vector<kernels> runnable_kernels() {
    std::vector<kernels> all;
    for (cd_kernels k = 0; cd_runnable_kernels() >> k != 0; ++k)
        if (cd_runnable_kernels() >> k & 1) all.push_back(static_cast<kernels>(k));
    return all;
}

namespace refusal {
// Why this header refused a call without asking the library; null after a refusal of the library's own.
inline thread_local const char* message = nullptr;
} // namespace refusal

// Why the last failed call on this thread failed.
inline const char* error_message() { return refusal::message ? refusal::message : cd_error_message(); }

#if CONTDYN_EXCEPTIONS
// What a failed call throws; what() is its message.
class error : public std::runtime_error {
public:
    explicit error(contdyn::status s) : std::runtime_error(error_message()), status_(s) {}
    contdyn::status status() const noexcept { return status_; }

private:
    contdyn::status status_;
};
#endif

// ---- views ----------------------------------------------------------------------------------------------------------

// A pointer and a size: made of arrays, of whatever has data() and size(), of braces where it is only read. In C++20 it
// is a std::span. Braces live as long as the call they stand in.
#ifdef __cpp_lib_span
inline namespace spans_20 {

template <class T> class span : public std::span<T> {
public:
    using std::span<T>::span;
    constexpr span(std::span<T> other) : std::span<T>(other) {}
    template <class U = T, std::enable_if_t<std::is_const_v<U>, int> = 0>
    constexpr span(std::initializer_list<std::remove_const_t<T>> list) : std::span<T>(list.begin(), list.size()) {}
};
#else
inline namespace spans_17 {

template <class T> class span {
public:
    using element_type = T;
    using value_type = std::remove_cv_t<T>;

    constexpr span() = default;
    constexpr span(T* data, std::size_t size) : data_(data), size_(size) {}
    template <class U = T, std::enable_if_t<std::is_const_v<U>, int> = 0>
    constexpr span(std::initializer_list<value_type> list) : span(list.begin(), list.size()) {}
    template <class Container, class Element = std::remove_pointer_t<decltype(std::data(std::declval<Container&>()))>,
              std::enable_if_t<std::is_convertible_v<Element (*)[], T (*)[]>, int> = 0>
    constexpr span(Container&& values) : span(std::data(values), std::size(values)) {}

    constexpr T* data() const { return data_; }
    constexpr std::size_t size() const { return size_; }
    constexpr bool empty() const { return size_ == 0; }
    constexpr T& operator[](std::size_t i) const { return data_[i]; }
    constexpr T* begin() const { return data_; }
    constexpr T* end() const { return data_ + size_; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};
#endif

// Bytes to read, and bytes to write to: of a pointer and a size in bytes, or of a container of plain structs.
template <class Void> class basic_bytes {
public:
    constexpr basic_bytes(Void* data, std::size_t size) : data_(data), size_(size) {}
    template <
        class Container, class Element = std::remove_pointer_t<decltype(std::data(std::declval<Container&>()))>,
        std::enable_if_t<std::is_convertible_v<Element*, Void*> && std::is_trivially_copyable_v<Element>, int> = 0>
    constexpr basic_bytes(Container&& values) : basic_bytes(std::data(values), std::size(values) * sizeof(Element)) {}

    constexpr Void* data() const { return data_; }
    constexpr std::size_t size() const { return size_; }

private:
    Void* data_;
    std::size_t size_;
};
using bytes = basic_bytes<const void>;
using buffer = basic_bytes<void>;

// ---- outcomes -------------------------------------------------------------------------------------------------------

#if CONTDYN_EXCEPTIONS
inline namespace throwing {

template <class T = void> using outcome = T;

namespace detail {

inline void done(cd_status s, const char* message = nullptr) {
    if (s == CD_OK) return;
    refusal::message = message;
    throw error(static_cast<status>(s));
}

template <class T> T got(cd_status s, T& out) {
    done(s);
    return std::move(out);
}

} // namespace detail

#else
inline namespace returning {

// A value; or why there is none, and a T made of nothing.
template <class T> class [[nodiscard]] result {
public:
    result(T value) : status_(contdyn::status::ok), value_(std::move(value)) {}
    result(contdyn::status s) : status_(s), value_() {}

    contdyn::status status() const { return status_; }
    explicit operator bool() const { return status_ == contdyn::status::ok; }

    T& value() & { return value_; }
    const T& value() const& { return value_; }
    T&& value() && { return std::move(value_); }
    T& operator*() & { return value_; }
    const T& operator*() const& { return value_; }
    T&& operator*() && { return std::move(value_); }
    T* operator->() { return &value_; }
    const T* operator->() const { return &value_; }

private:
    contdyn::status status_;
    T value_;
};

namespace detail {

template <class T> struct outcome_of { using type = result<T>; };
template <> struct outcome_of<void> { using type = status; };

inline status done(cd_status s, const char* message = nullptr) {
    if (s != CD_OK) refusal::message = message;
    return static_cast<status>(s);
}

template <class T> result<T> got(cd_status s, T& out) {
    if (s != CD_OK) return done(s);
    return std::move(out);
}

} // namespace detail

template <class T = void> using outcome = typename detail::outcome_of<T>::type;
#endif

namespace detail {

// An argument as the C functions take it.
template <class T> constexpr auto raw(const T& value) {
    if constexpr (std::is_enum_v<T>) return static_cast<std::underlying_type_t<T>>(value);
    else return value;
}

template <class First, class... Rest> struct last_of : last_of<Rest...> {};
template <class Last> struct last_of<Last> { using type = Last; };

// A number in a field's own memory.
inline double number_at(const void* data, std::size_t offset, precision stored) {
    const void* at = static_cast<const unsigned char*>(data) + offset;
    if (stored == precision::float64) return *static_cast<const double*>(at);
    return static_cast<double>(*static_cast<const float*>(at));
}

// Whether a matrix, where there is one, has as many rows and columns as a vector has numbers.
inline bool is_square(span<const double> matrix, span<const double> vector) {
    const std::size_t n = vector.size();
    return matrix.size() == 0 || (n != 0 && matrix.size() % n == 0 && matrix.size() / n == n);
}

// A whole field, as reads and writes take it: first and number of strands and nodes, or firsts and numbers along u and
// v or x and y; how many values that are; and why it is not known.
struct block {
    cd_status status;
    std::size_t at[4];
    std::size_t count;
};

// Holds a handle, and releases it.
template <class Handle, void (*Destroy)(Handle*)> class owner {
public:
    owner() = default;
    explicit owner(Handle* handle) noexcept : handle_(handle) {}
    owner(owner&& other) noexcept : handle_(other.release()) {}
    owner& operator=(owner&& other) noexcept {
        std::swap(handle_, other.handle_);
        if (this != &other) other.destroy();
        return *this;
    }
    ~owner() { Destroy(handle_); }

    // At once; what the destructor does.
    void destroy() noexcept { Destroy(release()); }

    explicit operator bool() const noexcept { return handle_ != nullptr; }

    // For C functions. release gives the handle away.
    Handle* handle() noexcept { return handle_; }
    const Handle* handle() const noexcept { return handle_; }
    [[nodiscard]] Handle* release() noexcept { return std::exchange(handle_, nullptr); }

protected:
    // Functions without outputs.
    template <class... Parameters, class... Arguments>
    outcome<> call(cd_status (*function)(Parameters...), const Arguments&... arguments) const {
        return done(function(handle_, raw(arguments)...));
    }

    // Functions with one output, their last parameter.
    template <class T, class... Parameters, class... Arguments>
    outcome<T> value(cd_status (*function)(Parameters...), const Arguments&... arguments) const {
        std::remove_pointer_t<typename last_of<Parameters...>::type> number{};
        const cd_status s = function(handle_, raw(arguments)..., &number);
        T out = static_cast<T>(number);
        return got(s, out);
    }

    template <class T, class Function>
    outcome<> write_whole(Function function, field f, const block& all, span<const T> values) {
        cd_status s = all.status;
        if (s == CD_OK)
            s = function(handle_, raw(f), all.at[0], all.at[1], all.at[2], all.at[3], values.data(), values.size());
        return done(s);
    }
    template <class T, class Function>
    outcome<std::vector<T>> read_whole(Function function, field f, const block& all) const {
        std::vector<T> out(all.status == CD_OK ? all.count : 0);
        cd_status s = all.status;
        if (s == CD_OK)
            s = function(handle_, raw(f), all.at[0], all.at[1], all.at[2], all.at[3], out.data(), out.size());
        return got(s, out);
    }
    static outcome<std::size_t> size_of(const block& all) {
        std::size_t out = all.count;
        return got(all.status, out);
    }

    template <class Size, class Save> outcome<std::vector<std::byte>> save_whole(Size size, Save save) const {
        std::size_t bytes = 0;
        cd_status s = size(handle_, &bytes);
        std::vector<std::byte> out(bytes);
        if (s == CD_OK) s = save(handle_, out.data(), out.size(), &bytes);
        return got(s, out);
    }

    Handle* handle_ = nullptr;
};

} // namespace detail

// ---- what functions with several outputs return ---------------------------------------------------------------------

struct attachment {
    double stiffness, damping;
};
struct stopping {
    double tolerance;
    std::size_t most_iterations;
};
struct convergence {
    std::size_t iterations;
    double residual;
};
struct calm {
    double speed, seconds;
};
struct resistance {
    double along, across;
};
struct collider {
    contdyn::shape shape;
    double radius, friction;
};
// Heights of a bed.
struct lattice {
    std::size_t columns, rows;
};
// What saved bytes are of: what that kind of object was made with.
struct saved_object {
    contdyn::kind kind;
    std::size_t first, second, components;
    contdyn::precision precision;
};

inline outcome<saved_object> saved_shape(bytes saved) {
    saved_object out{};
    cd_kind k = 0;
    cd_precision p = 0;
    const cd_status s = cd_saved_shape(saved.data(), saved.size(), &k, &out.first, &out.second, &out.components, &p);
    out.kind = static_cast<kind>(k), out.precision = static_cast<precision>(p);
    return detail::got(s, out);
}

// ---- chain ----------------------------------------------------------------------------------------------------------

// Massive spring, rope, hair, spline; see <contdyn/chain.h>.
class chain : public detail::owner<cd_chain, cd_chain_destroy> {
public:
    struct shape {
        std::size_t strands, springs, components;
        contdyn::precision precision;
    };
    struct energy {
        double kinetic, elastic, gravity;
    };
    // Good until the field is switched off or the chain released. Strides are in bytes.
    struct field_view {
        const void* data;
        std::size_t strand_stride, node_stride, component_stride;
        precision stored;
        double operator()(std::size_t strand, std::size_t node, std::size_t component) const {
            return detail::number_at(data, strand * strand_stride + node * node_stride + component * component_stride,
                                     stored);
        }
    };

    // No chain; one made by C, to be owned; a new one, as create makes it.
    chain() = default;
    explicit chain(cd_chain* handle) noexcept : owner(handle) {}
#if CONTDYN_EXCEPTIONS
    chain(std::size_t strands, std::size_t springs, std::size_t components, precision p = precision::float32,
          const cd_allocator* allocator = nullptr)
        : chain(create(strands, springs, components, p, allocator)) {}
#endif

    // See cd_chain_create. The allocator's functions must not throw.
    static outcome<chain> create(std::size_t strands, std::size_t springs, std::size_t components,
                                 precision p = precision::float32, const cd_allocator* allocator = nullptr) {
        chain out;
        return detail::got(cd_chain_create(strands, springs, components, detail::raw(p), allocator, &out.handle_), out);
    }

    // What it was created with.
    outcome<shape> get_shape() const {
        shape out{};
        cd_precision p = 0;
        const cd_status s = cd_chain_get_shape(handle_, &out.strands, &out.springs, &out.components, &p);
        out.precision = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- method ----

    // How steps are made; lambda of the implicit method, in [0, 1].
    outcome<> set_method(method m) { return call(cd_chain_set_method, m); }
    outcome<method> get_method() const { return value<method>(cd_chain_get_method); }
    outcome<> set_lambda(double lambda) { return call(cd_chain_set_lambda, lambda); }
    outcome<double> get_lambda() const { return value<double>(cd_chain_get_lambda); }

    // The caller's threads, whose functions must not throw; null turns them off.
    outcome<> set_parallel(const cd_parallel* parallel) { return call(cd_chain_set_parallel, parallel); }
    outcome<> set_kernels(kernels k) { return call(cd_chain_set_kernels, k); }
    outcome<kernels> get_kernels() const { return value<kernels>(cd_chain_get_kernels); }

    // ---- parameters: totals of one strand ----

    // Mass [kg] > 0, and how it is dealt out to the nodes.
    outcome<> set_mass(double mass) { return call(cd_chain_set_mass, mass); }
    outcome<double> get_mass() const { return value<double>(cd_chain_get_mass); }
    outcome<> set_mass_rule(mass_rule rule) { return call(cd_chain_set_mass_rule, rule); }
    outcome<mass_rule> get_mass_rule() const { return value<mass_rule>(cd_chain_get_mass_rule); }

    // Stretch stiffness [N/m] >= 0; of ropes up to INFINITY.
    outcome<> set_stiffness(double stiffness) { return call(cd_chain_set_stiffness, stiffness); }
    outcome<double> get_stiffness() const { return value<double>(cd_chain_get_stiffness); }

    // Bend stiffness [N/m], drag [1/s] and stiffness damping [s], >= 0.
    outcome<> set_bend(double bend) { return call(cd_chain_set_bend, bend); }
    outcome<double> get_bend() const { return value<double>(cd_chain_get_bend); }
    outcome<> set_drag(double drag) { return call(cd_chain_set_drag, drag); }
    outcome<double> get_drag() const { return value<double>(cd_chain_get_drag); }
    outcome<> set_stiffness_damping(double seconds) { return call(cd_chain_set_stiffness_damping, seconds); }
    outcome<double> get_stiffness_damping() const { return value<double>(cd_chain_get_stiffness_damping); }

    // Gravity [m/s^2], gravity[component].
    outcome<> set_gravity(span<const double> gravity) {
        return call(cd_chain_set_gravity, gravity.data(), gravity.size());
    }
    outcome<> get_gravity(span<double> gravity) const {
        return call(cd_chain_get_gravity, gravity.data(), gravity.size());
    }

    // What holds an end; whether the last node is joined to the first.
    outcome<> set_end(end e, node kind) { return call(cd_chain_set_end, e, kind); }
    outcome<node> get_end(end e) const { return value<node>(cd_chain_get_end, e); }
    outcome<> set_ring(bool ring) { return call(cd_chain_set_ring, ring); }
    outcome<bool> get_ring() const { return value<bool>(cd_chain_get_ring); }

    // Below which speed [m/s], 0: never, and after how many seconds of it a strand sleeps; how many nodes are awake.
    outcome<> set_sleep(double speed, double seconds) { return call(cd_chain_set_sleep, speed, seconds); }
    outcome<calm> get_sleep() const {
        calm out{};
        return detail::got(cd_chain_get_sleep(handle_, &out.speed, &out.seconds), out);
    }
    outcome<std::size_t> get_awake() const { return value<std::size_t>(cd_chain_get_awake); }

    // ---- ropes: springs that have a length ----

    // Rest length of a strand [m], 0: none; whether springs shorter than theirs push or are slack.
    outcome<> set_rest_length(double length) { return call(cd_chain_set_rest_length, length); }
    outcome<double> get_rest_length() const { return value<double>(cd_chain_get_rest_length); }
    outcome<> set_rest_angle(double angle) { return call(cd_chain_set_rest_angle, angle); }
    outcome<double> get_rest_angle() const { return value<double>(cd_chain_get_rest_angle); }
    outcome<> set_push(bool push) { return call(cd_chain_set_push, push); }
    outcome<bool> get_push() const { return value<bool>(cd_chain_get_push); }

    // The tension at which a spring breaks [N], INFINITY: none does; how many did in the last call of step.
    outcome<> set_strength(double strength) { return call(cd_chain_set_strength, strength); }
    outcome<double> get_strength() const { return value<double>(cd_chain_get_strength); }
    outcome<std::size_t> get_broken() const { return value<std::size_t>(cd_chain_get_broken); }

    // The force [N] with which the springs of a rope pull at a node, force[component].
    outcome<> get_reaction(std::size_t strand, std::size_t node, span<double> force) const {
        return call(cd_chain_get_reaction, strand, node, force.data(), force.size());
    }

    // What the nodes of a rope stay outside of. Places, radius and thickness are in metres, velocities in metres a
    // second, each array with a number per component. Of a plane get_collider tells its point first, then its normal;
    // of a capsule its two ends, of a bed its origin and spacings, of a callback its origin.
    outcome<> set_colliders(std::size_t count) { return call(cd_chain_set_colliders, count); }
    outcome<std::size_t> get_colliders() const { return value<std::size_t>(cd_chain_get_colliders); }
    outcome<> set_plane(std::size_t index, span<const double> point, span<const double> normal, double friction = 0) {
        if (point.size() != normal.size())
            return detail::done(CD_ERROR_RANGE, "chain::set_plane: point and normal differ in size");
        return call(cd_chain_set_plane, index, point.data(), normal.data(), normal.size(), friction);
    }
    outcome<> set_capsule(std::size_t index, span<const double> first, span<const double> last, double radius,
                          double friction = 0) {
        if (first.size() != last.size())
            return detail::done(CD_ERROR_RANGE, "chain::set_capsule: first and last differ in size");
        return call(cd_chain_set_capsule, index, first.data(), last.data(), last.size(), radius, friction);
    }
    // A bed is given by its heights row after row; get_bed tells its size, and its heights if
    // there is room for them.
    outcome<> set_bed(std::size_t index, span<const double> origin, std::size_t columns, std::size_t rows,
                      double column_spacing, double row_spacing, span<const double> heights, double friction = 0) {
        return call(cd_chain_set_bed, index, origin.data(), origin.size(), columns, rows, column_spacing, row_spacing,
                    heights.data(), heights.size(), friction);
    }
    outcome<lattice> get_bed(std::size_t index, span<double> heights = {}) const {
        lattice out{};
        return detail::got(
            cd_chain_get_bed(handle_, index, &out.columns, &out.rows, heights.data(), heights.size()), out);
    }
    // Without an origin the collider stays as it is, and only gets its callback again.
    outcome<> set_callback(std::size_t index, const cd_distance* distance, span<const double> origin,
                           double friction = 0) {
        return call(cd_chain_set_callback, index, distance, origin.data(), origin.size(), friction);
    }
    outcome<> remove_collider(std::size_t index) { return call(cd_chain_remove_collider, index); }
    outcome<> set_collider_velocity(std::size_t index, span<const double> velocity) {
        return call(cd_chain_set_collider_velocity, index, velocity.data(), velocity.size());
    }
    outcome<collider> get_collider(std::size_t index, span<double> first, span<double> second,
                                   span<double> velocity) const {
        collider out{};
        cd_shape kind = 0;
        const bool fit = first.size() == velocity.size() && second.size() == velocity.size();
        const std::size_t count = fit ? velocity.size() : static_cast<std::size_t>(-1); // refused
        const cd_status s = cd_chain_get_collider(handle_, index, &kind, first.data(), second.data(), velocity.data(),
                                                  count, &out.radius, &out.friction);
        out.shape = static_cast<contdyn::shape>(kind);
        return detail::got(s, out);
    }
    outcome<> set_thickness(double radius) { return call(cd_chain_set_thickness, radius); }
    outcome<double> get_thickness() const { return value<double>(cd_chain_get_thickness); }
    // Whether steps note what they do to each collider: forces along x, y and z [N], and moments about the origin [N m].
    outcome<> set_loads(bool loads) { return call(cd_chain_set_loads, loads); }
    outcome<bool> get_loads() const { return value<bool>(cd_chain_get_loads); }
    outcome<> get_collider_load(std::size_t index, span<double> load) const {
        return call(cd_chain_get_collider_load, index, load.data(), load.size());
    }

    // Resistance of the air per length of a rope [N s/m^2]; its velocity [m/s], velocity[component].
    outcome<> set_air(double along, double across) { return call(cd_chain_set_air, along, across); }
    outcome<resistance> get_air() const {
        resistance out{};
        return detail::got(cd_chain_get_air(handle_, &out.along, &out.across), out);
    }
    outcome<> set_wind(span<const double> velocity) {
        return call(cd_chain_set_wind, velocity.data(), velocity.size());
    }
    outcome<> get_wind(span<double> velocity) const {
        return call(cd_chain_get_wind, velocity.data(), velocity.size());
    }

    // When a step is content with the springs' lengths; what the last call of step came to.
    outcome<> set_tolerance(double tolerance, std::size_t most_iterations = 200) {
        return call(cd_chain_set_tolerance, tolerance, most_iterations);
    }
    outcome<stopping> get_tolerance() const {
        stopping out{};
        return detail::got(cd_chain_get_tolerance(handle_, &out.tolerance, &out.most_iterations), out);
    }
    outcome<convergence> get_convergence() const {
        convergence out{};
        return detail::got(cd_chain_get_convergence(handle_, &out.iterations, &out.residual), out);
    }

    // ---- fields ----

    // Switches a field on, with the present uniform values; off, which releases its memory.
    outcome<> enable_field(field f) { return call(cd_chain_enable_field, f); }
    outcome<> disable_field(field f) { return call(cd_chain_disable_field, f); }

    // values[strand][node or spring][component], of `strands` strands and n nodes from the first ones on.
    outcome<> write_f32(field f, std::size_t first_strand, std::size_t strands, std::size_t first, std::size_t n,
                        span<const float> values) {
        return call(cd_chain_write_f32, f, first_strand, strands, first, n, values.data(), values.size());
    }
    outcome<> write_f64(field f, std::size_t first_strand, std::size_t strands, std::size_t first, std::size_t n,
                        span<const double> values) {
        return call(cd_chain_write_f64, f, first_strand, strands, first, n, values.data(), values.size());
    }
    outcome<> read_f32(field f, std::size_t first_strand, std::size_t strands, std::size_t first, std::size_t n,
                       span<float> values) const {
        return call(cd_chain_read_f32, f, first_strand, strands, first, n, values.data(), values.size());
    }
    outcome<> read_f64(field f, std::size_t first_strand, std::size_t strands, std::size_t first, std::size_t n,
                       span<double> values) const {
        return call(cd_chain_read_f64, f, first_strand, strands, first, n, values.data(), values.size());
    }

    // The same of a whole field, and how many values it has.
    outcome<> write_f32(field f, span<const float> values) {
        return write_whole(cd_chain_write_f32, f, whole(f), values);
    }
    outcome<> write_f64(field f, span<const double> values) {
        return write_whole(cd_chain_write_f64, f, whole(f), values);
    }
    outcome<std::vector<float>> read_f32(field f) const { return read_whole<float>(cd_chain_read_f32, f, whole(f)); }
    outcome<std::vector<double>> read_f64(field f) const { return read_whole<double>(cd_chain_read_f64, f, whole(f)); }
    outcome<std::size_t> get_size(field f) const { return size_of(whole(f)); }

    // A field where it lies, to read without a copy.
    outcome<field_view> view(field f) const {
        field_view out{};
        cd_precision p = 0;
        cd_status s = cd_chain_view(handle_, detail::raw(f), &out.data, &out.strand_stride, &out.node_stride,
                                    &out.component_stride);
        if (s == CD_OK) s = cd_chain_get_shape(handle_, nullptr, nullptr, nullptr, &p);
        out.stored = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- acting on it ----

    // Adds newton_seconds[component] to a node.
    outcome<> impulse(std::size_t strand, std::size_t node, span<const double> newton_seconds) {
        return call(cd_chain_impulse, strand, node, newton_seconds.data(), newton_seconds.size());
    }

    // Moves a strand as a whole: positions and targets to rotation[row][column] x + offset[component], and velocities
    // along. An empty rotation is none.
    outcome<> teleport(std::size_t strand, span<const double> rotation, span<const double> offset) {
        if (!detail::is_square(rotation, offset))
            return detail::done(CD_ERROR_RANGE, "chain::teleport: rotation is no matrix of the size of offset");
        return call(cd_chain_teleport, strand, rotation.size() ? rotation.data() : nullptr, offset.data(),
                    offset.size());
    }

    // Here and below the strand of a rope; in a chain that is no rope 0, for all strands, which share such things.
    // Ties a node to its target[component], or to where it is, by a spring [N/m] with damping [N s/m].
    outcome<> attach(std::size_t strand, std::size_t node, double stiffness, double damping,
                     span<const double> target = {}) {
        return call(cd_chain_attach, strand, node, stiffness, damping, target.data(), target.size());
    }
    outcome<> detach(std::size_t strand, std::size_t node) { return call(cd_chain_detach, strand, node); }
    outcome<attachment> get_attachment(std::size_t strand, std::size_t node) const {
        attachment out{};
        return detail::got(cd_chain_get_attachment(handle_, strand, node, &out.stiffness, &out.damping), out);
    }

    // Cuts a spring, or makes it rigid; of a rope fixes its length.
    outcome<> cut(std::size_t strand, std::size_t spring) { return call(cd_chain_cut, strand, spring); }
    outcome<> weld(std::size_t strand, std::size_t spring) { return call(cd_chain_weld, strand, spring); }

    // ---- time ----

    // Makes steps of dt [s]; the longest dt of the symplectic method.
    outcome<> step(double dt, std::size_t count = 1) { return call(cd_chain_step, dt, count); }
    outcome<double> stable_dt() const { return value<double>(cd_chain_stable_dt); }

    // Simulated time [s], and steps and factorizations made.
    outcome<double> get_time() const { return value<double>(cd_chain_get_time); }
    outcome<std::uint64_t> get_steps() const { return value<std::uint64_t>(cd_chain_get_steps); }
    outcome<std::uint64_t> get_factorizations() const { return value<std::uint64_t>(cd_chain_get_factorizations); }

    // ---- measuring ----

    // Energies [J], and momentum [kg m/s], momentum[component].
    outcome<energy> get_energy() const {
        energy out{};
        return detail::got(cd_chain_get_energy(handle_, &out.kinetic, &out.elastic, &out.gravity), out);
    }
    outcome<> get_momentum(span<double> momentum) const {
        return call(cd_chain_get_momentum, momentum.data(), momentum.size());
    }

    // positions[place][component] of a strand at[place] springs from its beginning.
    outcome<> sample(std::size_t strand, span<const double> at, outside o, span<double> positions) const {
        return call(cd_chain_sample, strand, at.data(), at.size(), o, positions.data(), positions.size());
    }

    // Bytes it holds, and a hash of its state that is equal on every machine.
    outcome<std::size_t> get_memory() const { return value<std::size_t>(cd_chain_get_memory); }
    outcome<std::uint64_t> hash() const { return value<std::uint64_t>(cd_chain_hash); }

    // ---- keeping ----

    // The whole state as bytes; into a buffer, which tells how many were written.
    outcome<std::vector<std::byte>> save() const { return save_whole(cd_chain_save_size, cd_chain_save); }
    outcome<std::size_t> save(buffer out) const { return value<std::size_t>(cd_chain_save, out.data(), out.size()); }
    outcome<std::size_t> save_size() const { return value<std::size_t>(cd_chain_save_size); }

    // Takes a state of the same shape and precision: from saved bytes, from another chain.
    outcome<> load(bytes saved) { return call(cd_chain_load, saved.data(), saved.size()); }
    outcome<> copy_state(const chain& source) { return call(cd_chain_copy_state, source.handle_); }

    // Positions, velocities, tensions, time and steps back to 0.
    outcome<> reset() { return call(cd_chain_reset); }

private:
    detail::block whole(field f) const {
        std::size_t strands = 0, springs = 0, components = 0;
        std::int32_t ring = 0;
        cd_status s = cd_chain_get_shape(handle_, &strands, &springs, &components, nullptr);
        if (s == CD_OK) s = cd_chain_get_ring(handle_, &ring);
        const bool each =
            f == field::position || f == field::velocity || f == field::force || f == field::target || f == field::wind;
        const bool of_springs = f == field::stiffness || f == field::rest_length || f == field::tension ||
                                f == field::strength || f == field::strain;
        const std::size_t items = springs + (!of_springs || ring != 0);
        double length = 0;
        if (s == CD_OK) s = cd_chain_get_rest_length(handle_, &length);
        if (!each) components = 1;
        if (!each && length == 0) strands = 1;
        return {s, {0, strands, 0, items}, strands * items * components};
    }
};

// ---- membrane -------------------------------------------------------------------------------------------------------

// Drum, cloth, flag, thin plate; see <contdyn/membrane.h>.
class membrane : public detail::owner<cd_membrane, cd_membrane_destroy> {
public:
    struct shape {
        std::size_t nu, nv, components;
        contdyn::precision precision;
    };
    struct energy {
        double kinetic, elastic, gravity;
    };
    template <class T> struct directions { T along_u, along_v; };
    struct effort {
        std::size_t newton, gradient;
    };
    // Good until the field is switched off or the membrane released. Strides are in bytes.
    struct field_view {
        const void* data;
        std::size_t u_stride, v_stride, component_stride;
        precision stored;
        double operator()(std::size_t u, std::size_t v, std::size_t component) const {
            return detail::number_at(data, u * u_stride + v * v_stride + component * component_stride, stored);
        }
    };

    // No membrane; one made by C, to be owned; a new one, as create makes it.
    membrane() = default;
    explicit membrane(cd_membrane* handle) noexcept : owner(handle) {}
#if CONTDYN_EXCEPTIONS
    membrane(std::size_t nu, std::size_t nv, std::size_t components, precision p = precision::float32,
             const cd_allocator* allocator = nullptr)
        : membrane(create(nu, nv, components, p, allocator)) {}
#endif

    // See cd_membrane_create. The allocator's functions must not throw.
    static outcome<membrane> create(std::size_t nu, std::size_t nv, std::size_t components,
                                    precision p = precision::float32, const cd_allocator* allocator = nullptr) {
        membrane out;
        return detail::got(cd_membrane_create(nu, nv, components, detail::raw(p), allocator, &out.handle_), out);
    }

    // What it was created with.
    outcome<shape> get_shape() const {
        shape out{};
        cd_precision p = 0;
        const cd_status s = cd_membrane_get_shape(handle_, &out.nu, &out.nv, &out.components, &p);
        out.precision = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- method ----

    // How steps are made; lambda of the implicit method, in [0, 1].
    outcome<> set_method(method m) { return call(cd_membrane_set_method, m); }
    outcome<method> get_method() const { return value<method>(cd_membrane_get_method); }
    outcome<> set_lambda(double lambda) { return call(cd_membrane_set_lambda, lambda); }
    outcome<double> get_lambda() const { return value<double>(cd_membrane_get_lambda); }

    // How implicit steps solve their system, and which solver the last call of step took; when the coupled solver is
    // content; what it did in that call.
    outcome<> set_solver(solver s) { return call(cd_membrane_set_solver, s); }
    outcome<solver> get_solver() const { return value<solver>(cd_membrane_get_solver); }
    outcome<solver> get_solver_taken() const { return value<solver>(cd_membrane_get_solver_taken); }
    outcome<> set_tolerance(double tolerance, std::size_t most_iterations = 100) {
        return call(cd_membrane_set_tolerance, tolerance, most_iterations);
    }
    outcome<stopping> get_tolerance() const {
        stopping out{};
        return detail::got(cd_membrane_get_tolerance(handle_, &out.tolerance, &out.most_iterations), out);
    }
    outcome<convergence> get_convergence() const {
        convergence out{};
        return detail::got(cd_membrane_get_convergence(handle_, &out.iterations, &out.residual), out);
    }

    // The caller's threads, whose functions must not throw; null turns them off.
    outcome<> set_parallel(const cd_parallel* parallel) { return call(cd_membrane_set_parallel, parallel); }
    outcome<> set_kernels(kernels k) { return call(cd_membrane_set_kernels, k); }
    outcome<kernels> get_kernels() const { return value<kernels>(cd_membrane_get_kernels); }

    // ---- parameters: totals of the sheet ----

    // Mass [kg] > 0, and how it is dealt out to the nodes.
    outcome<> set_mass(double mass) { return call(cd_membrane_set_mass, mass); }
    outcome<double> get_mass() const { return value<double>(cd_membrane_get_mass); }
    outcome<> set_mass_rule(mass_rule rule) { return call(cd_membrane_set_mass_rule, rule); }
    outcome<mass_rule> get_mass_rule() const { return value<mass_rule>(cd_membrane_get_mass_rule); }

    // Stretch stiffness [N/m] >= 0 along u and along v.
    outcome<> set_stiffness(double along_u, double along_v) {
        return call(cd_membrane_set_stiffness, along_u, along_v);
    }
    outcome<directions<double>> get_stiffness() const {
        directions<double> out{};
        return detail::got(cd_membrane_get_stiffness(handle_, &out.along_u, &out.along_v), out);
    }

    // Bend stiffness [N/m], drag [1/s] and stiffness damping [s], >= 0.
    outcome<> set_bend(double bend) { return call(cd_membrane_set_bend, bend); }
    outcome<double> get_bend() const { return value<double>(cd_membrane_get_bend); }
    outcome<> set_drag(double drag) { return call(cd_membrane_set_drag, drag); }
    outcome<double> get_drag() const { return value<double>(cd_membrane_get_drag); }
    outcome<> set_stiffness_damping(double seconds) { return call(cd_membrane_set_stiffness_damping, seconds); }
    outcome<double> get_stiffness_damping() const { return value<double>(cd_membrane_get_stiffness_damping); }

    // Gravity [m/s^2], gravity[component].
    outcome<> set_gravity(span<const double> gravity) {
        return call(cd_membrane_set_gravity, gravity.data(), gravity.size());
    }
    outcome<> get_gravity(span<double> gravity) const {
        return call(cd_membrane_get_gravity, gravity.data(), gravity.size());
    }

    // Pressure [Pa] along the normal.
    outcome<> set_pressure(double pressure) { return call(cd_membrane_set_pressure, pressure); }
    outcome<double> get_pressure() const { return value<double>(cd_membrane_get_pressure); }

    // What holds an edge; whether the last nodes along a direction are joined to the first.
    outcome<> set_edge(edge e, node kind) { return call(cd_membrane_set_edge, e, kind); }
    outcome<node> get_edge(edge e) const { return value<node>(cd_membrane_get_edge, e); }
    outcome<> set_ring(bool along_u, bool along_v) { return call(cd_membrane_set_ring, along_u, along_v); }
    outcome<directions<bool>> get_ring() const {
        directions<std::int32_t> flags{};
        const cd_status s = cd_membrane_get_ring(handle_, &flags.along_u, &flags.along_v);
        directions<bool> out{flags.along_u != 0, flags.along_v != 0};
        return detail::got(s, out);
    }

    // Below which speed [m/s], 0: never, and after how many seconds of it a sheet sleeps; how many nodes are awake.
    outcome<> set_sleep(double speed, double seconds) { return call(cd_membrane_set_sleep, speed, seconds); }
    outcome<calm> get_sleep() const {
        calm out{};
        return detail::got(cd_membrane_get_sleep(handle_, &out.speed, &out.seconds), out);
    }
    outcome<std::size_t> get_awake() const { return value<std::size_t>(cd_membrane_get_awake); }

    // ---- cloth: springs that have a length ----

    // Rest lengths of the sheet along u and along v [m], 0: none.
    outcome<> set_rest_length(double along_u, double along_v) {
        return call(cd_membrane_set_rest_length, along_u, along_v);
    }
    outcome<directions<double>> get_rest_length() const {
        directions<double> out{};
        return detail::got(cd_membrane_get_rest_length(handle_, &out.along_u, &out.along_v), out);
    }

    // Shear stiffness [N/m]; what keeps cloth from crumpling within its own plane [1/s^2].
    outcome<> set_shear(double stiffness) { return call(cd_membrane_set_shear, stiffness); }
    outcome<double> get_shear() const { return value<double>(cd_membrane_get_shear); }
    outcome<> set_compression(double rate) { return call(cd_membrane_set_compression, rate); }
    outcome<double> get_compression() const { return value<double>(cd_membrane_get_compression); }

    // The strain at which a spring tears, INFINITY: none does; how many did in the last call of step.
    outcome<> set_breaking_strain(double strain) { return call(cd_membrane_set_breaking_strain, strain); }
    outcome<double> get_breaking_strain() const { return value<double>(cd_membrane_get_breaking_strain); }
    outcome<std::size_t> get_broken() const { return value<std::size_t>(cd_membrane_get_broken); }

    // How many iterations a step may do: Newton's, and of conjugate gradients in each of them.
    outcome<> set_effort(std::size_t newton, std::size_t gradient) {
        return call(cd_membrane_set_effort, newton, gradient);
    }
    outcome<effort> get_effort() const {
        effort out{};
        return detail::got(cd_membrane_get_effort(handle_, &out.newton, &out.gradient), out);
    }

    // Resistance of the air per area of cloth [N s/m^3]; its velocity [m/s], velocity[component].
    outcome<> set_air(double along, double across) { return call(cd_membrane_set_air, along, across); }
    outcome<resistance> get_air() const {
        resistance out{};
        return detail::got(cd_membrane_get_air(handle_, &out.along, &out.across), out);
    }
    outcome<> set_wind(span<const double> velocity) {
        return call(cd_membrane_set_wind, velocity.data(), velocity.size());
    }
    outcome<> get_wind(span<double> velocity) const {
        return call(cd_membrane_get_wind, velocity.data(), velocity.size());
    }

    // What the nodes of cloth stay outside of. Places, radius and thickness are in metres, velocities in metres a
    // second, each array with a number per component. Of a plane get_collider tells its point first, then its normal;
    // of a capsule its two ends, of a bed its origin and spacings, of a callback its origin.
    outcome<> set_colliders(std::size_t count) { return call(cd_membrane_set_colliders, count); }
    outcome<std::size_t> get_colliders() const { return value<std::size_t>(cd_membrane_get_colliders); }
    outcome<> set_plane(std::size_t index, span<const double> point, span<const double> normal, double friction = 0) {
        if (point.size() != normal.size())
            return detail::done(CD_ERROR_RANGE, "membrane::set_plane: point and normal differ in size");
        return call(cd_membrane_set_plane, index, point.data(), normal.data(), normal.size(), friction);
    }
    outcome<> set_capsule(std::size_t index, span<const double> first, span<const double> last, double radius,
                          double friction = 0) {
        if (first.size() != last.size())
            return detail::done(CD_ERROR_RANGE, "membrane::set_capsule: first and last differ in size");
        return call(cd_membrane_set_capsule, index, first.data(), last.data(), last.size(), radius, friction);
    }
    // A bed is given by its heights row after row; get_bed tells its size, and its heights if
    // there is room for them.
    outcome<> set_bed(std::size_t index, span<const double> origin, std::size_t columns, std::size_t rows,
                      double column_spacing, double row_spacing, span<const double> heights, double friction = 0) {
        return call(cd_membrane_set_bed, index, origin.data(), origin.size(), columns, rows, column_spacing,
                    row_spacing, heights.data(), heights.size(), friction);
    }
    outcome<lattice> get_bed(std::size_t index, span<double> heights = {}) const {
        lattice out{};
        return detail::got(
            cd_membrane_get_bed(handle_, index, &out.columns, &out.rows, heights.data(), heights.size()), out);
    }
    // Without an origin the collider stays as it is, and only gets its callback again.
    outcome<> set_callback(std::size_t index, const cd_distance* distance, span<const double> origin,
                           double friction = 0) {
        return call(cd_membrane_set_callback, index, distance, origin.data(), origin.size(), friction);
    }
    outcome<> remove_collider(std::size_t index) { return call(cd_membrane_remove_collider, index); }
    outcome<> set_collider_velocity(std::size_t index, span<const double> velocity) {
        return call(cd_membrane_set_collider_velocity, index, velocity.data(), velocity.size());
    }
    outcome<collider> get_collider(std::size_t index, span<double> first, span<double> second,
                                   span<double> velocity) const {
        collider out{};
        cd_shape kind = 0;
        const bool fit = first.size() == velocity.size() && second.size() == velocity.size();
        const std::size_t count = fit ? velocity.size() : static_cast<std::size_t>(-1); // refused
        const cd_status s = cd_membrane_get_collider(handle_, index, &kind, first.data(), second.data(),
                                                     velocity.data(), count, &out.radius, &out.friction);
        out.shape = static_cast<contdyn::shape>(kind);
        return detail::got(s, out);
    }
    outcome<> set_thickness(double distance) { return call(cd_membrane_set_thickness, distance); }
    outcome<double> get_thickness() const { return value<double>(cd_membrane_get_thickness); }
    // Whether steps note what they do to each collider: forces along x, y and z [N], and moments about the origin [N m].
    outcome<> set_loads(bool loads) { return call(cd_membrane_set_loads, loads); }
    outcome<bool> get_loads() const { return value<bool>(cd_membrane_get_loads); }
    outcome<> get_collider_load(std::size_t index, span<double> load) const {
        return call(cd_membrane_get_collider_load, index, load.data(), load.size());
    }

    // ---- fields ----

    // Switches a field on, with the present uniform values; off, which releases its memory.
    outcome<> enable_field(field f) { return call(cd_membrane_enable_field, f); }
    outcome<> disable_field(field f) { return call(cd_membrane_disable_field, f); }

    // values[v][u][component], of n_u x n_v nodes or springs from the first ones on.
    outcome<> write_f32(field f, std::size_t first_u, std::size_t first_v, std::size_t n_u, std::size_t n_v,
                        span<const float> values) {
        return call(cd_membrane_write_f32, f, first_u, first_v, n_u, n_v, values.data(), values.size());
    }
    outcome<> write_f64(field f, std::size_t first_u, std::size_t first_v, std::size_t n_u, std::size_t n_v,
                        span<const double> values) {
        return call(cd_membrane_write_f64, f, first_u, first_v, n_u, n_v, values.data(), values.size());
    }
    outcome<> read_f32(field f, std::size_t first_u, std::size_t first_v, std::size_t n_u, std::size_t n_v,
                       span<float> values) const {
        return call(cd_membrane_read_f32, f, first_u, first_v, n_u, n_v, values.data(), values.size());
    }
    outcome<> read_f64(field f, std::size_t first_u, std::size_t first_v, std::size_t n_u, std::size_t n_v,
                       span<double> values) const {
        return call(cd_membrane_read_f64, f, first_u, first_v, n_u, n_v, values.data(), values.size());
    }

    // The same of a whole field, and how many values it has.
    outcome<> write_f32(field f, span<const float> values) {
        return write_whole(cd_membrane_write_f32, f, whole(f), values);
    }
    outcome<> write_f64(field f, span<const double> values) {
        return write_whole(cd_membrane_write_f64, f, whole(f), values);
    }
    outcome<std::vector<float>> read_f32(field f) const { return read_whole<float>(cd_membrane_read_f32, f, whole(f)); }
    outcome<std::vector<double>> read_f64(field f) const {
        return read_whole<double>(cd_membrane_read_f64, f, whole(f));
    }
    outcome<std::size_t> get_size(field f) const { return size_of(whole(f)); }

    // A field where it lies, to read without a copy.
    outcome<field_view> view(field f) const {
        field_view out{};
        cd_precision p = 0;
        cd_status s =
            cd_membrane_view(handle_, detail::raw(f), &out.data, &out.u_stride, &out.v_stride, &out.component_stride);
        if (s == CD_OK) s = cd_membrane_get_shape(handle_, nullptr, nullptr, nullptr, &p);
        out.stored = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- acting on it ----

    // Adds newton_seconds[component], spread over the nodes less than `radius` springs from the place (u, v).
    outcome<> impulse(double u, double v, double radius, span<const double> newton_seconds) {
        return call(cd_membrane_impulse, u, v, radius, newton_seconds.data(), newton_seconds.size());
    }

    // Moves the sheet as a whole: positions and targets to rotation[row][column] x + offset[component], and velocities
    // along. An empty rotation is none.
    outcome<> teleport(span<const double> rotation, span<const double> offset) {
        if (!detail::is_square(rotation, offset))
            return detail::done(CD_ERROR_RANGE, "membrane::teleport: rotation is no matrix of the size of offset");
        return call(cd_membrane_teleport, rotation.size() ? rotation.data() : nullptr, offset.data(), offset.size());
    }

    // Ties a node to its target[component], or to where it is, by a spring [N/m] with damping [N s/m].
    outcome<> attach(std::size_t u, std::size_t v, double stiffness, double damping, span<const double> target = {}) {
        return call(cd_membrane_attach, u, v, stiffness, damping, target.data(), target.size());
    }
    outcome<> detach(std::size_t u, std::size_t v) { return call(cd_membrane_detach, u, v); }
    outcome<attachment> get_attachment(std::size_t u, std::size_t v) const {
        attachment out{};
        return detail::got(cd_membrane_get_attachment(handle_, u, v, &out.stiffness, &out.damping), out);
    }

    // ---- time ----

    // Makes steps of dt [s]; the longest dt of the symplectic method.
    outcome<> step(double dt, std::size_t count = 1) { return call(cd_membrane_step, dt, count); }
    outcome<double> stable_dt() const { return value<double>(cd_membrane_stable_dt); }

    // Simulated time [s], and steps and factorizations made.
    outcome<double> get_time() const { return value<double>(cd_membrane_get_time); }
    outcome<std::uint64_t> get_steps() const { return value<std::uint64_t>(cd_membrane_get_steps); }
    outcome<std::uint64_t> get_factorizations() const { return value<std::uint64_t>(cd_membrane_get_factorizations); }

    // ---- measuring ----

    // Energies [J], and momentum [kg m/s], momentum[component].
    outcome<energy> get_energy() const {
        energy out{};
        return detail::got(cd_membrane_get_energy(handle_, &out.kinetic, &out.elastic, &out.gravity), out);
    }
    outcome<> get_momentum(span<double> momentum) const {
        return call(cd_membrane_get_momentum, momentum.data(), momentum.size());
    }

    // The force [N] with which springs, shear and bend pull at a node, force[component].
    outcome<> get_reaction(std::size_t u, std::size_t v, span<double> force) const {
        return call(cd_membrane_get_reaction, u, v, force.data(), force.size());
    }

    // Volume [m^3] between the sheet and the origin.
    outcome<double> get_volume() const { return value<double>(cd_membrane_get_volume); }

    // positions[place][component] at[place] = {u, v}.
    outcome<> sample(span<const double> at, outside o, span<double> positions) const {
        if (at.size() % 2 != 0) return detail::done(CD_ERROR_RANGE, "membrane::sample: at has an odd number of values");
        return call(cd_membrane_sample, at.data(), at.size() / 2, static_cast<cd_outside>(o), positions.data(),
                    positions.size());
    }

    // Bytes it holds, and a hash of its state that is equal on every machine.
    outcome<std::size_t> get_memory() const { return value<std::size_t>(cd_membrane_get_memory); }
    outcome<std::uint64_t> hash() const { return value<std::uint64_t>(cd_membrane_hash); }

    // ---- drawing ----

    // A vertex per node, in a buffer of structs; SIZE_MAX: no normals.
    outcome<> write_vertices(buffer out, std::size_t stride, std::size_t position_offset,
                             std::size_t normal_offset = SIZE_MAX) const {
        return call(cd_membrane_write_vertices, out.data(), out.size(), stride, position_offset, normal_offset);
    }

    // Triangles, as vertex numbers of 2 or 4 bytes; how many numbers they are.
    outcome<> write_indices(buffer out, std::size_t index_size) const {
        return call(cd_membrane_write_indices, out.data(), out.size(), index_size);
    }
    outcome<std::size_t> get_index_count() const { return value<std::size_t>(cd_membrane_get_index_count); }

    // ---- keeping ----

    // The whole state as bytes; into a buffer, which tells how many were written.
    outcome<std::vector<std::byte>> save() const { return save_whole(cd_membrane_save_size, cd_membrane_save); }
    outcome<std::size_t> save(buffer out) const { return value<std::size_t>(cd_membrane_save, out.data(), out.size()); }
    outcome<std::size_t> save_size() const { return value<std::size_t>(cd_membrane_save_size); }

    // Takes a state of the same shape and precision: from saved bytes, from another membrane.
    outcome<> load(bytes saved) { return call(cd_membrane_load, saved.data(), saved.size()); }
    outcome<> copy_state(const membrane& source) { return call(cd_membrane_copy_state, source.handle_); }

    // Positions, velocities, time and steps back to 0.
    outcome<> reset() { return call(cd_membrane_reset); }

private:
    detail::block whole(field f) const {
        std::size_t nu = 0, nv = 0, components = 0;
        std::int32_t ring_u = 0, ring_v = 0;
        cd_status s = cd_membrane_get_shape(handle_, &nu, &nv, &components, nullptr);
        if (s == CD_OK) s = cd_membrane_get_ring(handle_, &ring_u, &ring_v);
        const bool each =
            f == field::position || f == field::velocity || f == field::force || f == field::target || f == field::wind;
        const bool of_springs_u = f == field::stiffness_u || f == field::rest_length_u || f == field::tension_u ||
                                  f == field::strain_u || f == field::breaking_strain_u;
        const bool of_springs_v = f == field::stiffness_v || f == field::rest_length_v || f == field::tension_v ||
                                  f == field::strain_v || f == field::breaking_strain_v;
        const std::size_t n_u = nu + (!of_springs_u || ring_u != 0);
        const std::size_t n_v = nv + (!of_springs_v || ring_v != 0);
        return {s, {0, 0, n_u, n_v}, n_u * n_v * (each ? components : 1)};
    }
};

// ---- water ----------------------------------------------------------------------------------------------------------

// Pool, river, tide, flood; see <contdyn/water.h>.
class water : public detail::owner<cd_water, cd_water_destroy> {
public:
    struct shape {
        std::size_t nx, ny;
        double dx, dy;
        contdyn::precision precision;
    };
    struct energy {
        double kinetic, potential;
    };
    struct boundary {
        border kind;
        double value, rate;
    };
    struct limited {
        std::uint64_t cells;
        double volume;
    };
    struct account {
        double initial, in, out, error;
    };
    struct hulls {
        std::size_t count, n_along, n_across;
    };
    struct hull {
        double mass, length, width, area;
    };
    struct hull_drag {
        double along, across, friction;
    };
    // Good until the field is switched off or the water released. Strides are in bytes.
    struct field_view {
        const void* data;
        std::size_t x_stride, y_stride;
        precision stored;
        double operator()(std::size_t i, std::size_t j) const {
            return detail::number_at(data, i * x_stride + j * y_stride, stored);
        }
    };

    // No water; one made by C, to be owned; a new one, as create makes it.
    water() = default;
    explicit water(cd_water* handle) noexcept : owner(handle) {}
#if CONTDYN_EXCEPTIONS
    water(std::size_t nx, std::size_t ny, double dx, double dy, precision p = precision::float32,
          const cd_allocator* allocator = nullptr)
        : water(create(nx, ny, dx, dy, p, allocator)) {}
#endif

    // See cd_water_create. The allocator's functions must not throw.
    static outcome<water> create(std::size_t nx, std::size_t ny, double dx, double dy, precision p = precision::float32,
                                 const cd_allocator* allocator = nullptr) {
        water out;
        return detail::got(cd_water_create(nx, ny, dx, dy, detail::raw(p), allocator, &out.handle_), out);
    }

    // What it was created with.
    outcome<shape> get_shape() const {
        shape out{};
        cd_precision p = 0;
        const cd_status s = cd_water_get_shape(handle_, &out.nx, &out.ny, &out.dx, &out.dy, &p);
        out.precision = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- method ----

    // How steps are made; lambda of the implicit method, in [0, 1].
    outcome<> set_method(method m) { return call(cd_water_set_method, m); }
    outcome<method> get_method() const { return value<method>(cd_water_get_method); }
    outcome<> set_lambda(double lambda) { return call(cd_water_set_lambda, lambda); }
    outcome<double> get_lambda() const { return value<double>(cd_water_get_lambda); }

    // Linear or advected momentum.
    outcome<> set_momentum(momentum m) { return call(cd_water_set_momentum, m); }
    outcome<momentum> get_momentum() const { return value<momentum>(cd_water_get_momentum); }

    // Whether the next step sweeps along y first.
    outcome<> set_first(bool along_y) { return call(cd_water_set_first, along_y); }
    outcome<bool> get_first() const { return value<bool>(cd_water_get_first); }

    // The caller's threads, whose functions must not throw; null turns them off.
    outcome<> set_parallel(const cd_parallel* parallel) { return call(cd_water_set_parallel, parallel); }
    outcome<> set_kernels(kernels k) { return call(cd_water_set_kernels, k); }
    outcome<kernels> get_kernels() const { return value<kernels>(cd_water_get_kernels); }

    // ---- parameters ----

    // Gravity [m/s^2], density [kg/m^3].
    outcome<> set_gravity(double gravity) { return call(cd_water_set_gravity, gravity); }
    outcome<double> get_gravity() const { return value<double>(cd_water_get_gravity); }
    outcome<> set_density(double density) { return call(cd_water_set_density, density); }
    outcome<double> get_density() const { return value<double>(cd_water_get_density); }

    // Drag [1/s], Manning's roughness of the bed [s/m^(1/3)].
    outcome<> set_drag(double drag) { return call(cd_water_set_drag, drag); }
    outcome<double> get_drag() const { return value<double>(cd_water_get_drag); }
    outcome<> set_manning(double manning) { return call(cd_water_set_manning, manning); }
    outcome<double> get_manning() const { return value<double>(cd_water_get_manning); }

    // What is at a side: a level [m] or a discharge [m^2/s], and how fast it changes per second. Of the two that have a
    // level, border::open lets waves leave without an echo, border::level holds it at the side for what flows out
    // slower than its waves.
    outcome<> set_side(side s, border kind, double level = 0, double rate = 0) {
        return call(cd_water_set_side, s, kind, level, rate);
    }
    outcome<boundary> get_side(side s) const {
        boundary out{};
        cd_border kind = 0;
        const cd_status got = cd_water_get_side(handle_, detail::raw(s), &kind, &out.value, &out.rate);
        out.kind = static_cast<border>(kind);
        return detail::got(got, out);
    }

    // Depth of an inflow [m], in which advected water comes in; 0: that of the cell at the side.
    outcome<> set_inflow_depth(side s, double depth) { return call(cd_water_set_inflow_depth, s, depth); }
    outcome<double> get_inflow_depth(side s) const { return value<double>(cd_water_get_inflow_depth, s); }

    // What a write of the bed leaves as it is.
    outcome<> set_bed_rule(bed_rule rule) { return call(cd_water_set_bed_rule, rule); }
    outcome<bed_rule> get_bed_rule() const { return value<bed_rule>(cd_water_get_bed_rule); }

    // ---- fields ----

    // Switches a field on, with no sources, pressure, force or walls, all cells there; off, which releases its memory.
    outcome<> enable_field(field f) { return call(cd_water_enable_field, f); }
    outcome<> disable_field(field f) { return call(cd_water_disable_field, f); }

    // values[j][i], of n_x x n_y cells or faces from the first ones on.
    outcome<> write_f32(field f, std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                        span<const float> values) {
        return call(cd_water_write_f32, f, first_x, first_y, n_x, n_y, values.data(), values.size());
    }
    outcome<> write_f64(field f, std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                        span<const double> values) {
        return call(cd_water_write_f64, f, first_x, first_y, n_x, n_y, values.data(), values.size());
    }
    outcome<> read_f32(field f, std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                       span<float> values) const {
        return call(cd_water_read_f32, f, first_x, first_y, n_x, n_y, values.data(), values.size());
    }
    outcome<> read_f64(field f, std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                       span<double> values) const {
        return call(cd_water_read_f64, f, first_x, first_y, n_x, n_y, values.data(), values.size());
    }

    // The same of a whole field, and how many values it has.
    outcome<> write_f32(field f, span<const float> values) {
        return write_whole(cd_water_write_f32, f, whole(f), values);
    }
    outcome<> write_f64(field f, span<const double> values) {
        return write_whole(cd_water_write_f64, f, whole(f), values);
    }
    outcome<std::vector<float>> read_f32(field f) const { return read_whole<float>(cd_water_read_f32, f, whole(f)); }
    outcome<std::vector<double>> read_f64(field f) const { return read_whole<double>(cd_water_read_f64, f, whole(f)); }
    outcome<std::size_t> get_size(field f) const { return size_of(whole(f)); }

    // A field where it lies, to read without a copy.
    outcome<field_view> view(field f) const {
        field_view out{};
        cd_precision p = 0;
        cd_status s = cd_water_view(handle_, detail::raw(f), &out.data, &out.x_stride, &out.y_stride);
        if (s == CD_OK) s = cd_water_get_shape(handle_, nullptr, nullptr, nullptr, nullptr, &p);
        out.stored = static_cast<precision>(p);
        return detail::got(s, out);
    }

    // ---- acting on it ----

    // Adds volume [m^3] over a disc, or a rectangle of cells, or takes it; what it came to.
    outcome<double> add_volume(double x, double y, double radius, double volume) {
        return value<double>(cd_water_add_volume, x, y, radius, volume);
    }
    outcome<double> add_volume_rectangle(std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                                         double volume) {
        return value<double>(cd_water_add_volume_rectangle, first_x, first_y, n_x, n_y, volume);
    }

    // Adds a source of rate [m^3/s] over a disc, or a rectangle of cells, or a drain.
    outcome<> add_source(double x, double y, double radius, double rate) {
        return call(cd_water_add_source, x, y, radius, rate);
    }
    outcome<> add_source_rectangle(std::size_t first_x, std::size_t first_y, std::size_t n_x, std::size_t n_y,
                                   double rate) {
        return call(cd_water_add_source_rectangle, first_x, first_y, n_x, n_y, rate);
    }

    // Heaps up the water of a disc around it, down to height [m]; pushes it by an impulse [N s].
    outcome<> splash(double x, double y, double radius, double height) {
        return call(cd_water_splash, x, y, radius, height);
    }
    outcome<> impulse(double x, double y, double radius, double impulse_x, double impulse_y) {
        return call(cd_water_impulse, x, y, radius, impulse_x, impulse_y);
    }

    // ---- what floats on it ----

    // Hulls, numbered from 0, and the plates of each along and across.
    outcome<> set_hulls(std::size_t count, std::size_t n_along = 1, std::size_t n_across = 1) {
        return call(cd_water_set_hulls, count, n_along, n_across);
    }
    outcome<hulls> get_hulls() const {
        hulls out{};
        return detail::got(cd_water_get_hulls(handle_, &out.count, &out.n_along, &out.n_across), out);
    }

    // What a hull is: mass [kg], length and width [m], heights of its floor's plates above the keel, none: flat. A disc.
    outcome<> set_hull(std::size_t index, double mass, double length, double width, span<const double> heights = {}) {
        const double* const first = heights.size() ? heights.data() : nullptr;
        return call(cd_water_set_hull, index, mass, length, width, first, heights.size());
    }
    outcome<> set_disc(std::size_t index, double mass, double radius) {
        return call(cd_water_set_disc, index, mass, radius);
    }
    outcome<hull> get_hull(std::size_t index, span<double> heights = {}) const {
        hull out{};
        double* const first = heights.size() ? heights.data() : nullptr;
        const cd_status s = cd_water_get_hull(handle_, index, &out.mass, &out.length, &out.width, &out.area, first,
                                              heights.size());
        return detail::got(s, out);
    }
    outcome<> remove_hull(std::size_t index) { return call(cd_water_remove_hull, index); }

    // Lays it on the water at (x, y), its bow towards (ahead_x, ahead_y).
    outcome<> launch_hull(std::size_t index, double x, double y, double ahead_x, double ahead_y) {
        return call(cd_water_launch_hull, index, x, y, ahead_x, ahead_y);
    }

    // {x, y, z, ahead_x, ahead_y, pitch, roll} of its body, and of its floor as it lies on the water; velocities along
    // x, y, z and of yaw, pitch, roll.
    outcome<> set_hull_pose(std::size_t index, span<const double> pose) {
        return call(cd_water_set_hull_pose, index, pose.data(), pose.size());
    }
    outcome<> get_hull_pose(std::size_t index, span<double> pose) const {
        return call(cd_water_get_hull_pose, index, pose.data(), pose.size());
    }
    outcome<> get_hull_floor(std::size_t index, span<double> pose) const {
        return call(cd_water_get_hull_floor, index, pose.data(), pose.size());
    }
    outcome<> set_hull_velocity(std::size_t index, span<const double> velocity) {
        return call(cd_water_set_hull_velocity, index, velocity.data(), velocity.size());
    }
    outcome<> get_hull_velocity(std::size_t index, span<double> velocity) const {
        return call(cd_water_get_hull_velocity, index, velocity.data(), velocity.size());
    }

    // Forces ahead, to port and up [N], moments of yaw, pitch and roll [N m], from outside; drag against the water along
    // and across [N s/m] and friction on the bed; what water and bed did in the last step, along x, y, z.
    outcome<> set_hull_force(std::size_t index, span<const double> force) {
        return call(cd_water_set_hull_force, index, force.data(), force.size());
    }
    outcome<> get_hull_force(std::size_t index, span<double> force) const {
        return call(cd_water_get_hull_force, index, force.data(), force.size());
    }
    outcome<> set_hull_drag(std::size_t index, double along, double across, double friction = 0) {
        return call(cd_water_set_hull_drag, index, along, across, friction);
    }
    outcome<hull_drag> get_hull_drag(std::size_t index) const {
        hull_drag out{};
        return detail::got(cd_water_get_hull_drag(handle_, index, &out.along, &out.across, &out.friction), out);
    }
    outcome<> get_hull_load(std::size_t index, span<double> load) const {
        return call(cd_water_get_hull_load, index, load.data(), load.size());
    }

    // Energies of all hulls [J].
    outcome<energy> get_hull_energy() const {
        energy out{};
        return detail::got(cd_water_get_hull_energy(handle_, &out.kinetic, &out.potential), out);
    }

    // How high the water would stand at at[place] = {x, y} with no hull pressing on it: heads[place].
    outcome<> sample_heads(span<const double> at, outside o, span<double> heads) const {
        if (at.size() != 2 * heads.size())
            return detail::done(CD_ERROR_RANGE, "water::sample_heads: heads does not fit the places in at");
        return call(cd_water_sample_heads, at.data(), heads.size(), static_cast<cd_outside>(o), heads.data());
    }

    // ---- sleep ----

    // The height [m] of waves below which water sleeps, 0: never; how many cells were awake in the last step.
    outcome<> set_sleep(double height) { return call(cd_water_set_sleep, height); }
    outcome<double> get_sleep() const { return value<double>(cd_water_get_sleep); }
    outcome<std::size_t> get_awake() const { return value<std::size_t>(cd_water_get_awake); }

    // ---- time ----

    // Makes steps of dt [s]; the longest dt of the symplectic method.
    outcome<> step(double dt, std::size_t count = 1) { return call(cd_water_step, dt, count); }
    outcome<double> stable_dt() const { return value<double>(cd_water_stable_dt); }

    // Simulated time [s], and steps and factorizations made.
    outcome<double> get_time() const { return value<double>(cd_water_get_time); }
    outcome<std::uint64_t> get_steps() const { return value<std::uint64_t>(cd_water_get_steps); }
    outcome<std::uint64_t> get_factorizations() const { return value<std::uint64_t>(cd_water_get_factorizations); }

    // In how many cells the last call of step had to hold water back, and how much [m^3].
    outcome<limited> get_limited() const {
        limited out{};
        return detail::got(cd_water_get_limited(handle_, &out.cells, &out.volume), out);
    }

    // ---- measuring ----

    // Volume [m^3], and its account.
    outcome<double> get_volume() const { return value<double>(cd_water_get_volume); }
    outcome<account> get_account() const {
        account out{};
        return detail::got(cd_water_get_account(handle_, &out.initial, &out.in, &out.out, &out.error), out);
    }
    outcome<> restart_account() { return call(cd_water_restart_account); }

    // Energies [J].
    outcome<energy> get_energy() const {
        energy out{};
        return detail::got(cd_water_get_energy(handle_, &out.kinetic, &out.potential), out);
    }

    // Area [m^2] of the wet cells; the largest Courant number of a step of dt [s].
    outcome<double> get_wet_area() const { return value<double>(cd_water_get_wet_area); }
    outcome<double> get_courant(double dt) const { return value<double>(cd_water_get_courant, dt); }

    // At at[place] = {x, y} [m]: surface[place], depth[place], normal[place][3], velocity[place][2]; what is empty is
    // left out.
    outcome<> sample(span<const double> at, outside o, span<double> surface, span<double> depth = {},
                     span<double> normal = {}, span<double> velocity = {}) const {
        const std::size_t n = at.size() / 2;
        const auto fits = [n](span<double> values, std::size_t times) {
            return values.size() == 0 || (values.size() % times == 0 && values.size() / times == n);
        };
        if (at.size() % 2 != 0 || !fits(surface, 1) || !fits(depth, 1) || !fits(normal, 3) || !fits(velocity, 2))
            return detail::done(CD_ERROR_RANGE, "water::sample: an output's size does not fit the places in at");
        const auto there = [](span<double> values) { return values.size() ? values.data() : nullptr; };
        return call(cd_water_sample, at.data(), n, static_cast<cd_outside>(o), there(surface), there(depth),
                    there(normal), there(velocity));
    }

    // Bytes it holds, and a hash of its state that is equal on every machine.
    outcome<std::size_t> get_memory() const { return value<std::size_t>(cd_water_get_memory); }
    outcome<std::uint64_t> hash() const { return value<std::uint64_t>(cd_water_hash); }

    // ---- drawing ----

    // A vertex per cell, in a buffer of structs; SIZE_MAX: no normals, no depths.
    outcome<> write_vertices(buffer out, std::size_t stride, std::size_t position_offset,
                             std::size_t normal_offset = SIZE_MAX, std::size_t depth_offset = SIZE_MAX) const {
        return call(cd_water_write_vertices, out.data(), out.size(), stride, position_offset, normal_offset,
                    depth_offset);
    }

    // Triangles, without dry ones if wanted, as vertex numbers of 2 or 4 bytes; how many numbers they are.
    outcome<> write_indices(bool skip_dry, buffer out, std::size_t index_size) const {
        return call(cd_water_write_indices, skip_dry, out.data(), out.size(), index_size);
    }
    outcome<std::size_t> get_index_count(bool skip_dry) const {
        return value<std::size_t>(cd_water_get_index_count, skip_dry);
    }

    // ---- keeping ----

    // The whole state as bytes; into a buffer, which tells how many were written.
    outcome<std::vector<std::byte>> save() const { return save_whole(cd_water_save_size, cd_water_save); }
    outcome<std::size_t> save(buffer out) const { return value<std::size_t>(cd_water_save, out.data(), out.size()); }
    outcome<std::size_t> save_size() const { return value<std::size_t>(cd_water_save_size); }

    // Takes a state of the same number of cells and precision: from saved bytes, from another water.
    outcome<> load(bytes saved) { return call(cd_water_load, saved.data(), saved.size()); }
    outcome<> copy_state(const water& source) { return call(cd_water_copy_state, source.handle_); }

    // Depths, velocities, time, steps and account back to 0.
    outcome<> reset() { return call(cd_water_reset); }

private:
    detail::block whole(field f) const {
        std::size_t nx = 0, ny = 0;
        const cd_status s = cd_water_get_shape(handle_, &nx, &ny, nullptr, nullptr, nullptr);
        if (f == field::velocity_x || f == field::force_x || f == field::wall_x) ++nx;
        if (f == field::velocity_y || f == field::force_y || f == field::wall_y) ++ny;
        return {s, {0, 0, nx, ny}, nx * ny};
    }
};

} // namespace throwing or returning
} // namespace spans_17 or spans_20
} // namespace contdyn

#endif
