// Water: alternating implicit and explicit steps, calm or not, two threads, scenes that are nearly still, any size.
#include <cmath>

#include "bench.hpp"
#include "textbook_water.hpp"
#include "water_runner.hpp"

namespace report {
namespace {

const double kCell = 0.1, kFrame = 1.0 / 60;

double wave(std::size_t i, std::size_t j, std::size_t side) {
    return 0.05 * std::cos(19 * double(i) / double(side)) * std::cos(13 * double(j) / double(side));
}

// A square pool, walled in, 1 m deep and level with 0.
std::shared_ptr<Water> pool_of(std::size_t side, cd_precision precision, double waves = 1,
                               Way way = Way::water_linear) {
    const auto water = std::make_shared<Water>(side, side, kCell, kCell, precision);
    water->write(CD_BED, std::vector<double>(side * side, -1.0));
    std::vector<double> surface(side * side);
    for (std::size_t k = 0; k < surface.size(); ++k) surface[k] = waves * wave(k % side, k / side, side);
    water->write(CD_SURFACE, surface);
    water->set(method(way));
    return water;
}

Subject stepped(const std::string& name, const std::shared_ptr<Water>& water, double dt = kFrame) {
    return {name, [water, dt] { check(cd_water_step(water->get(), dt, 1)); }, [water] { return water->hash(); }};
}

template <class Real> Subject textbook(std::size_t side) {
    const auto water = std::make_shared<TextbookWater<Real>>(side, side, Real(kCell), Real(kCell), Real(kEarth));
    water->bed.assign(side * side, -1);
    for (std::size_t k = 0; k < side * side; ++k) water->now[k] = Real(wave(k % side, k / side, side));
    water->before = water->now;
    return {"textbook", [water] { water->step(Real(kFrame)); }, [water] { return hash_of(water->now, kHashStart); }};
}

std::string name_of(const char* what, std::size_t side) {
    return "water." + std::string(what) + "." + std::to_string(side);
}

// Depth and two velocities of every cell.
Subject state_of(std::size_t side) { return traffic<float>(3 * side * side); }

Bench implicit_beside_textbook(std::size_t side, const std::string& reach) {
    const std::string name = name_of("implicit", side);
    return {name, [=] {
                Case it{name, side * side, {}, reach};
                it.subjects = {stepped("float32", pool_of(side, CD_FLOAT32)),
                               stepped("float64", pool_of(side, CD_FLOAT64)),
                               stepped("advected", pool_of(side, CD_FLOAT32, 1, Way::water_advected)),
                               textbook<float>(side), state_of(side)};
                return it;
            }};
}

Bench explicit_beside_copy(std::size_t side) {
    const std::string name = name_of("explicit", side);
    return {name, [=] {
                Case it{name, side * side, {}, "1.5 times the copy, beyond L2"};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) {
                    const auto pool = pool_of(side, precision, 1, Way::water_explicit);
                    double dt = 0;
                    check(cd_water_stable_dt(pool->get(), &dt));
                    it.subjects.push_back(stepped(report::name_of(precision), pool, 0.7 * dt));
                }
                it.subjects.push_back(state_of(side));
                return it;
            }};
}

// Calm water, beside the same water on the way that all water can go: where there may be walls inside.
// Implicit steps: of so many frames, 0.5 cells that waves cross in each.
Bench calm_beside_any(std::size_t side, Way way, double frames = 1) {
    const std::string kind = way == Way::water_explicit ? "explicit" : frames > 1 ? "linear.long" : "linear";
    const std::string name = name_of(("any." + kind).c_str(), side);
    return {name, [=] {
                Case it{name, side * side, {}};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64})
                    for (bool walls : {false, true}) {
                        const auto pool = pool_of(side, precision, frames > 1 ? 0.5 : 1, way);
                        double dt = frames * kFrame;
                        if (way == Way::water_explicit) check(cd_water_stable_dt(pool->get(), &dt)), dt *= 0.7;
                        if (walls) pool->enable(CD_WALL_X), pool->enable(CD_WALL_Y);
                        const std::string subject = std::string(walls ? "any " : "calm ") + report::name_of(precision);
                        it.subjects.push_back(stepped(subject, pool, dt));
                    }
                return it;
            }};
}

Bench shared_by_threads(std::size_t side) {
    const std::string name = name_of("threads", side);
    return {name, [=] {
                const auto pair = pool_of(side, CD_FLOAT32);
                check(cd_water_set_parallel(pair->get(), &two_threads()));
                Case it{name, side * side, {}, "two threads 1.7 times one, beyond L2"};
                it.subjects = {stepped("one thread", pool_of(side, CD_FLOAT32)), stepped("two threads", pair)};
                it.subjects.push_back(meeting());
                return it;
            }};
}

Bench still_beside_lively(std::size_t side, cd_precision precision) {
    const std::string name = name_of("still", side) + "." + report::name_of(precision);
    return {
        name, [=] {
            const auto kicked = pool_of(side, precision, 0);
            check(cd_water_splash(kicked->get(), 0.5 * kCell * double(side), 0.5 * kCell * double(side), kCell, 0.01));
            Case it{name, side * side, {}, "never slower than the lively one"};
            it.subjects = {stepped("lively", pool_of(side, precision)),
                           stepped("nearly still", pool_of(side, precision, 1e-37)),
                           stepped("still", pool_of(side, precision, 0)), stepped("kicked", kicked)};
            return it;
        }};
}

Bench by_each_kernels(std::size_t side, Way way) {
    const std::string name = name_of(way == Way::water_advected ? "kernels.advected" : "kernels", side);
    return {name, [=] {
                Case it{name, side * side, {}};
                it.subjects = of_each_kernels([&](cd_kernels kernels) {
                    const auto pool = pool_of(side, CD_FLOAT32, 1, way);
                    check(cd_water_set_kernels(pool->get(), kernels));
                    return stepped(cd_kernels_name(kernels), pool);
                });
                it.subjects.push_back(state_of(side));
                return it;
            }};
}

Bench at_any_size(std::size_t side) {
    const std::string name = name_of("size", side);
    return {name, [=] {
                Case it{name, side * side, {}, "flat within 2, but for the copy's steps"};
                it.subjects = {stepped("float32", pool_of(side, CD_FLOAT32)), state_of(side)};
                return it;
            }};
}

} // namespace

std::vector<Bench> water_benches() {
    std::vector<Bench> all = {implicit_beside_textbook(256, "10 times the textbook"),
                              implicit_beside_textbook(1024, "14 times the textbook"),
                              implicit_beside_textbook(2048, "12 times the textbook")};
    for (std::size_t side : {256, 1024, 2048}) all.push_back(explicit_beside_copy(side));
    for (Way way : {Way::water_linear, Way::water_explicit}) all.push_back(calm_beside_any(256, way));
    all.push_back(calm_beside_any(256, Way::water_linear, 40));
    all.push_back(shared_by_threads(1024));
    for (Way way : {Way::water_linear, Way::water_advected}) all.push_back(by_each_kernels(256, way));
    all.push_back(by_each_kernels(1024, Way::water_linear));
    for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) all.push_back(still_beside_lively(128, precision));
    for (std::size_t side : {2, 10, 32, 100, 316, 1000, 3162}) all.push_back(at_any_size(side));
    return all;
}

} // namespace report
