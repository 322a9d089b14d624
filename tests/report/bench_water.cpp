// Water: linear, advected and explicit steps on a lake, a stream, islands and a beach; long steps, two threads, scenes
// that are nearly still, any size.
#include <cmath>

#include "bench.hpp"
#include "textbook_water.hpp"
#include "water_runner.hpp"

namespace report {
namespace {

const double kCell = 0.1, kFrame = 1.0 / 60;

// A square, walled in but for the stream's ring, with waves of up to 5 cm on water 1 m deep that is level with 0. In a
// step of a frame waves cross half a cell.
struct Scene {
    std::string name;
    double waves = 1; // of the 5 cm

    double wave(std::size_t i, std::size_t j, std::size_t side) const {
        return waves * 0.05 * std::cos(19 * double(i) / double(side)) * std::cos(13 * double(j) / double(side));
    }
    double bed(std::size_t i, std::size_t j, std::size_t side) const {
        if (name == "islands") // a quarter of it is dry, in hills 16 cells apart
            return -1 + 2.2 * std::pow(std::sin(M_PI * double(i) / 16) * std::sin(M_PI * double(j) / 16), 2);
        return name == "beach" ? 2 * double(i) / double(side) - 1 : -1;
    }
    double speed() const { return name == "stream" ? 0.2 * kCell / kFrame : 0; } // 0.2 cells a step

    std::shared_ptr<Water> water(std::size_t side, cd_precision precision, Way way = Way::water_linear) const {
        const auto made = std::make_shared<Water>(side, side, kCell, kCell, precision);
        std::vector<double> beds(side * side), surface(side * side);
        for (std::size_t k = 0; k < surface.size(); ++k)
            beds[k] = bed(k % side, k / side, side), surface[k] = wave(k % side, k / side, side);
        if (speed() > 0) check(cd_water_set_side(made->get(), CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        made->write(CD_BED, beds);
        made->write(CD_SURFACE, surface);
        made->write(CD_VELOCITY_X, std::vector<double>((side + 1) * side, speed()));
        made->set(method(way));
        return made;
    }
    template <class Real> Subject textbook(std::size_t side, const std::string& called) const {
        const auto made = std::make_shared<TextbookWater<Real>>(side, side, Real(kCell), Real(kCell), Real(kEarth));
        for (std::size_t k = 0; k < side * side; ++k) {
            made->bed[k] = Real(bed(k % side, k / side, side));
            made->now[k] = std::max(made->bed[k], Real(wave(k % side, k / side, side)));
        }
        made->before = made->now;
        return {called, [made] { made->step(Real(kFrame)); }, [made] { return hash_of(made->now, kHashStart); }};
    }
};

const Scene kLake = {"lake"};

Subject stepped(const std::string& name, const std::shared_ptr<Water>& water, double dt = kFrame) {
    return {name, [water, dt] { check(cd_water_step(water->get(), dt, 1)); }, [water] { return water->hash(); }};
}

std::string name_of(const std::string& what, std::size_t side) { return "water." + what + "." + std::to_string(side); }

// Depth and two velocities of every cell.
Subject state_of(std::size_t side) { return traffic<float>(3 * side * side); }

// The textbook makes its own implicit step beside all of them: it has neither streams nor an explicit one.
Bench beside_textbook(const Scene& scene, std::size_t side, Way way) {
    const std::string name = name_of(method(way).key + "." + scene.name, side);
    return {name, [=] {
                Case it{name, side * side, {}, "float64 at most 2.2 times float32"};
                it.subjects = {stepped("float32", scene.water(side, CD_FLOAT32, way)),
                               stepped("float64", scene.water(side, CD_FLOAT64, way)),
                               scene.textbook<float>(side, "textbook"),
                               scene.textbook<double>(side, "textbook of float64"), state_of(side)};
                return it;
            }};
}

// Steps of 40 frames, in which waves cross 21 cells.
Bench in_long_steps(std::size_t side) {
    const std::string name = name_of("long", side);
    return {name, [=] {
                Case it{name, side * side, {}};
                for (Way way : {Way::water_linear, Way::water_advected}) {
                    const auto water = Scene{"lake", 0.5}.water(side, CD_FLOAT32, way);
                    it.subjects.push_back(stepped(method(way).key, water, 40 * kFrame));
                }
                return it;
            }};
}

Bench shared_by_threads(std::size_t side, Way way) {
    const std::string name = name_of("threads." + method(way).key, side);
    return {name, [=] {
                const auto pair = kLake.water(side, CD_FLOAT32, way);
                check(cd_water_set_parallel(pair->get(), &two_threads()));
                Case it{name, side * side, {}, "two threads 1.8 times one"};
                it.subjects = {stepped("one thread", kLake.water(side, CD_FLOAT32, way)), stepped("two threads", pair)};
                it.subjects.push_back(meeting());
                return it;
            }};
}

Bench still_beside_lively(std::size_t side, cd_precision precision) {
    const std::string name = name_of("still", side) + "." + report::name_of(precision);
    return {name, [=] {
                const auto kicked = Scene{"lake", 0}.water(side, precision);
                const double middle = 0.5 * kCell * double(side);
                check(cd_water_splash(kicked->get(), middle, middle, kCell, 0.01));
                Case it{name, side * side, {}, "never slower than the lively one"};
                it.subjects = {stepped("lively", kLake.water(side, precision)),
                               stepped("nearly still", Scene{"lake", 1e-37}.water(side, precision)),
                               stepped("still", Scene{"lake", 0}.water(side, precision)), stepped("kicked", kicked)};
                return it;
            }};
}

Bench by_each_kernels(std::size_t side, Way way) {
    const std::string name = name_of("kernels." + method(way).key, side);
    return {name, [=] {
                Case it{name, side * side, {}};
                it.subjects = of_each_kernels([&](cd_kernels kernels) {
                    const auto water = kLake.water(side, CD_FLOAT32, way);
                    check(cd_water_set_kernels(water->get(), kernels));
                    return stepped(cd_kernels_name(kernels), water);
                });
                it.subjects.push_back(state_of(side));
                return it;
            }};
}

Bench at_any_size(std::size_t side) {
    const std::string name = name_of("size", side);
    return {name, [=] {
                Case it{name, side * side, {}, "flat within 2, but for the copy's steps"};
                it.subjects = {stepped("float32", kLake.water(side, CD_FLOAT32)), state_of(side)};
                return it;
            }};
}

} // namespace

std::vector<Bench> water_benches() {
    std::vector<Bench> all;
    for (std::size_t side : {256, 1024})
        for (Way way : {Way::water_linear, Way::water_advected, Way::water_explicit})
            for (const char* scene : {"lake", "stream", "islands", "beach"})
                all.push_back(beside_textbook({scene}, side, way));
    all.push_back(in_long_steps(256));
    for (Way way : {Way::water_linear, Way::water_advected, Way::water_explicit})
        all.push_back(shared_by_threads(1024, way));
    for (Way way : {Way::water_linear, Way::water_advected}) all.push_back(by_each_kernels(256, way));
    all.push_back(by_each_kernels(1024, Way::water_linear));
    for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) all.push_back(still_beside_lively(128, precision));
    for (std::size_t side : {2, 10, 32, 100, 316, 1000, 3162}) all.push_back(at_any_size(side));
    return all;
}

} // namespace report
