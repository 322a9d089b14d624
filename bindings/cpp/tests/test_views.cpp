// Spans, bytes and fields in place: what they are made of, and what they say of wrong sizes.
#include "check.hpp"

#include <array>
#include <string>
#include <string_view>

using namespace contdyn;

namespace {

std::size_t count(span<const double> values) { return values.size(); }
double* first(span<double> values) { return values.data(); }
std::size_t size_of(bytes data) { return data.size(); }
std::size_t room_of(buffer out) { return out.size(); }

void spans() {
    std::vector<double> list(5, 1.0);
    const std::vector<double> constant(4, 1.0);
    std::array<double, 3> array{};
    double plain[2] = {};
    CHECK(count(list) == 5 && count(constant) == 4 && count(array) == 3 && count(plain) == 2 && count({}) == 0);
    CHECK(count({1, 2.5, 3}) == 3 && count({plain, 1}) == 1 && count(std::vector<double>(7)) == 7);
    CHECK(first(list) == list.data() && first(plain) == plain && first({plain + 1, 1}) == plain + 1);
    double sum = 0;
    for (double x : span<const double>(list)) sum += x;
    CHECK(sum == 5 && span<double>(plain)[1] == 0 && span<double>().empty());
    const span<double> all = list;
    const span<const double> read_only = all;
    CHECK(read_only.data() == list.data() && count(all) == 5);
    static_assert(!std::is_constructible_v<span<double>, const std::vector<double>&>);
    static_assert(!std::is_constructible_v<span<const double>, std::vector<float>&>);
#ifdef __cpp_lib_span
    const std::span<double> standard = list;
    CHECK(count(standard) == 5 && first(standard) == list.data());
    const std::span<const double> back = read_only;
    CHECK(back.size() == 5);
#endif
    CHECK(size_of(list) == 40 && size_of(std::string_view("abc")) == 3 && size_of(plain) == 16);
    CHECK(room_of(array) == 24 && room_of({plain, 8}) == 8);
    static_assert(!std::is_constructible_v<buffer, const std::vector<double>&>);
    static_assert(!std::is_constructible_v<bytes, std::vector<std::string>&>);
}

// The sizes that this header checks, since the library is not told them.
void places_and_outputs() {
    water pool = GET(water::create(4, 4, 1, 1));
    double one[1], two[2], three[3];
    const double at[2] = {1, 1};
    REFUSED(status::error_range, "water::sample", pool.sample({1, 1, 1}, outside::refused, one));
    REFUSED(status::error_range, "water::sample", pool.sample(at, outside::refused, two));
    REFUSED(status::error_range, "water::sample", pool.sample(at, outside::refused, one, two));
    REFUSED(status::error_range, "water::sample", pool.sample(at, outside::refused, one, one, two));
    REFUSED(status::error_range, "water::sample", pool.sample(at, outside::refused, one, one, three, one));
    OK(pool.sample(at, outside::refused, {}, {}, three));
    CHECK(three[2] == 1);
    // a refusal of the library's own takes the message over again
    REFUSED(status::error_value, "cd_water_sample", pool.sample({9, 9}, outside::refused, one));

    const membrane sheet = GET(membrane::create(4, 4, 1));
    REFUSED(status::error_range, "membrane::sample", sheet.sample({1, 1, 1}, outside::refused, two));

    membrane cloth = GET(membrane::create(4, 4, 3));
    OK(cloth.set_rest_length(1, 1));
    OK(cloth.set_colliders(1));
    REFUSED(status::error_range, "membrane::set_plane", cloth.set_plane(0, {0, 0}, {0, 1, 0}));
    REFUSED(status::error_range, "membrane::set_capsule", cloth.set_capsule(0, {0, 0, 0}, {0, 1}, 1));
    REFUSED(status::error_range, "count", cloth.get_collider(0, {}, three, three));
    REFUSED(status::error_range, "count", cloth.set_plane(0, {0, 0}, {0, 1}));
}

template <class Number> void a_chain_in_place(precision p) {
    chain rope = GET(chain::create(2, 3, 2, p));
    std::vector<double> x(16);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i) / 4;
    OK(rope.write_f64(field::position, x));
    const chain::field_view view = GET(rope.view(field::position));
    CHECK(view.stored == p);
    for (std::size_t s = 0, i = 0; s < 2; ++s) {
        for (std::size_t n = 0; n < 4; ++n) {
            for (std::size_t c = 0; c < 2; ++c, ++i) {
                CHECK(view(s, n, c) == x[i]);
                const auto* byte = static_cast<const unsigned char*>(view.data);
                byte += s * view.strand_stride + n * view.node_stride + c * view.component_stride;
                CHECK(static_cast<double>(*reinterpret_cast<const Number*>(byte)) == x[i]);
            }
        }
    }
    OK(rope.set_end(end::last, node::driven));
    OK(rope.write_f64(field::velocity, 0, 1, 3, 1, {1, 0}));
    OK(rope.step(0.5));
    CHECK(view(0, 3, 0) == x[6] + 0.5); // seen through the same view
}

void whole_fields() {
    chain rope = GET(chain::create(2, 5, 3));
    const auto sizes = [&](field f) { return GET(rope.get_size(f)); };
    CHECK(sizes(field::velocity) == 36 && sizes(field::mass) == 6 && sizes(field::stiffness) == 5);
    OK(rope.set_ring(true));
    OK(rope.enable_field(field::stiffness));
    CHECK(sizes(field::stiffness) == 6 && GET(rope.read_f32(field::stiffness)).size() == 6);
    CHECK(GET(rope.read_f64(field::pin)).size() == 6);

    membrane cloth = GET(membrane::create(3, 2, 3));
    OK(cloth.set_rest_length(1, 1));
    OK(cloth.set_ring(true, false));
    for (field f : {field::rest_length_u, field::rest_length_v, field::wind, field::tension_u, field::tension_v,
                    field::strain_u, field::strain_v, field::breaking_strain_u, field::breaking_strain_v}) {
        OK(cloth.enable_field(f));
        CHECK(GET(cloth.read_f64(f)).size() == GET(cloth.get_size(f)));
    }
    CHECK(GET(cloth.get_size(field::strain_u)) == 12 && GET(cloth.get_size(field::strain_v)) == 8);

    water pool = GET(water::create(3, 2, 1, 1));
    for (field f : {field::wall_x, field::wall_y, field::mask, field::force_x, field::force_y, field::source}) {
        OK(pool.enable_field(f));
        const std::vector<double> values = GET(pool.read_f64(f));
        CHECK(values.size() == GET(pool.get_size(f)));
        OK(pool.write_f64(f, values));
    }
}

} // namespace

int main() {
    spans();
    places_and_outputs();
    a_chain_in_place<float>(precision::float32);
    a_chain_in_place<double>(precision::float64);
    whole_fields();
}
