// What a frame takes beside its steps, and what makes a step dearer: numbers read and written, vertices with normals, a
// copy of the state, an object made, a time step of its own every frame, a pinned node in a sheet; and what sleep saves.
#include <cmath>
#include <cstring>

#include "bench.hpp"
#include "chain_runner.hpp"
#include "membrane_runner.hpp"
#include "water_runner.hpp"

namespace report {
namespace {

constexpr std::size_t kSide = 65, kNodes = kSide * kSide; // of sheets, and of water
constexpr double kFrame = 1.0 / 60;

// A rolling surface, all edges held.
std::shared_ptr<Sheet> rolling_sheet() {
    const auto sheet = std::make_shared<Sheet>(kSide - 1, kSide - 1, 3, CD_FLOAT32);
    std::vector<double> x;
    for (std::size_t v = 0; v < kSide; ++v)
        for (std::size_t u = 0; u < kSide; ++u)
            x.insert(x.end(), {double(u), double(v), std::sin(0.2 * double(u)) * std::cos(0.3 * double(v))});
    sheet->write(CD_POSITION, x);
    sheet->pin_edges();
    return sheet;
}

std::shared_ptr<Water> a_pool() {
    const auto water = std::make_shared<Water>(kSide, kSide, 1, 1, CD_FLOAT32);
    water->write(CD_DEPTH, std::vector<double>(kNodes, 1));
    return water;
}

// A surface as floats, and the vertices that a plain loop makes of it, with normals across the slopes of neighbours.
struct Drawn {
    std::vector<float> height = std::vector<float>(kNodes), vertex = std::vector<float>(6 * kNodes);

    Drawn() {
        for (std::size_t i = 0; i < kNodes; ++i) height[i] = std::sin(0.01f * float(i));
    }
    void by_a_plain_loop() {
        for (std::size_t v = 0; v < kSide; ++v)
            for (std::size_t u = 0; u < kSide; ++u) {
                const std::size_t left = u > 0 ? u - 1 : u, right = u + 1 < kSide ? u + 1 : u;
                const std::size_t low = v > 0 ? v - 1 : v, high = v + 1 < kSide ? v + 1 : v;
                const float x = (height[v * kSide + right] - height[v * kSide + left]) / float(right - left);
                const float y = (height[high * kSide + u] - height[low * kSide + u]) / float(high - low);
                const float scale = 1 / std::sqrt(x * x + y * y + 1);
                const float six[6] = {float(u), float(v), height[v * kSide + u], -x * scale, -y * scale, scale};
                std::memcpy(&vertex[6 * (v * kSide + u)], six, sizeof six);
            }
    }
};
Subject plain_loop(const std::shared_ptr<Drawn>& drawn) {
    return {"plain loop over heights", [drawn] { drawn->by_a_plain_loop(); }};
}
constexpr std::size_t kVertex = 6 * sizeof(float), kNormal = kVertex / 2; // bytes; where a normal begins

// write(object, buffer, its bytes): vertices of all nodes or cells.
template <class Object, class Write>
Bench vertices(const std::string& name, std::shared_ptr<Object> (*make)(), Write write) {
    return {name, [=] {
                const auto object = make();
                const auto drawn = std::make_shared<Drawn>();
                const auto draw = [=] { check(write(object->get(), drawn->vertex.data(), kNodes * kVertex)); };
                return Case{name, kNodes, {{"float32", draw}, plain_loop(drawn)}, "4 ns"};
            }};
}

// Of all positions; a copy reads and writes as many numbers.
Bench numbers_of_a_sheet(bool write) {
    const std::string name = write ? "frame.write.sheet" : "frame.read.sheet";
    return {name, [name, write] {
                const auto sheet = rolling_sheet();
                const auto numbers = std::make_shared<std::vector<float>>(3 * kNodes);
                const auto move = [sheet, numbers, write] {
                    const std::size_t n = numbers->size();
                    float* const all = numbers->data();
                    check(write ? cd_membrane_write_f32(sheet->get(), CD_POSITION, 0, 0, kSide, kSide, all, n)
                                : cd_membrane_read_f32(sheet->get(), CD_POSITION, 0, 0, kSide, kSide, all, n));
                };
                return Case{name, 3 * kNodes, {{"float32", move}, traffic<float>(3 * kNodes)}, "0.5 ns"};
            }};
}

Bench copy_of_a_sheet() {
    return {"frame.copy.sheet", [] {
                const auto sheet = rolling_sheet(), other = rolling_sheet();
                std::size_t bytes = 0;
                check(cd_membrane_save_size(sheet->get(), &bytes));
                const auto from = std::make_shared<std::vector<char>>(bytes),
                           to = std::make_shared<std::vector<char>>(bytes);
                Case it{"frame.copy.sheet", kNodes, {}, "1.5 times the copy"};
                it.subjects = {
                    {"float32", [sheet, other] { check(cd_membrane_copy_state(other->get(), sheet->get())); }},
                    {"copy", [from, to, bytes] { std::memcpy(to->data(), from->data(), bytes); }}};
                return it;
            }};
}

// Steps whose dt is that of the last one, and steps of which each has another.
template <class Object, class Step>
Bench time_steps(const std::string& name, std::size_t nodes, std::shared_ptr<Object> (*make)(), Step step) {
    return {name, [=] {
                const auto same = make(), other = make();
                const auto number = std::make_shared<std::size_t>(0);
                Case it{name, nodes, {}, "1.3 times the first"};
                it.subjects = {{"one dt", [same, step] { check(step(same->get(), kFrame)); }},
                               {"another dt each step", [other, step, number] {
                                    check(step(other->get(), kFrame * (1 + 1e-3 * double((*number)++ % 7))));
                                }}};
                return it;
            }};
}

std::shared_ptr<Chain> a_chain() {
    const auto chain = std::make_shared<Chain>(1000, 3, CD_FLOAT32);
    check(cd_chain_set_end(chain->get(), CD_END_FIRST, CD_NODE_PINNED));
    return chain;
}
// So stiff that its factors settle nowhere along it.
std::shared_ptr<Chain> a_stiff_chain() {
    const auto chain = a_chain();
    check(cd_chain_set_stiffness(chain->get(), 100));
    return chain;
}
std::shared_ptr<Chain> a_rod() {
    const auto rod = a_chain();
    check(cd_chain_set_bend(rod->get(), 1e-6));
    return rod;
}

// A short strand as a game makes them by the hundred.
Bench a_chain_that_comes_and_goes() {
    return {"frame.create.chain", [] {
                const auto make = [] {
                    cd_chain* chain = nullptr;
                    check(cd_chain_create(1, 15, 3, CD_FLOAT32, nullptr, &chain));
                    cd_chain_destroy(chain);
                };
                return Case{"frame.create.chain", 16, {{"float32", make}}};
            }};
}

Bench a_pinned_node() {
    return {"frame.pinned.sheet", [] {
                const auto plain = rolling_sheet(), pinned = rolling_sheet();
                pinned->enable(CD_PIN);
                const double kind = CD_NODE_PINNED;
                check(cd_membrane_write_f64(pinned->get(), CD_PIN, kSide / 2, kSide / 2, 1, 1, &kind, 1));
                const auto step = [](const std::shared_ptr<Sheet>& sheet) {
                    return [sheet] { check(cd_membrane_step(sheet->get(), kFrame, 1)); };
                };
                Case it{"frame.pinned.sheet", kNodes, {}, "2 times the first"};
                it.subjects = {{"edges held", step(plain)}, {"and a node inside", step(pinned)}};
                return it;
            }};
}

// A sheet that hangs by its corners and sways, solved to a tolerance.
Bench a_coupled_sheet() {
    static constexpr std::size_t kLarge = 256;
    return {"frame.coupled.sheet", [] {
                Case it{"frame.coupled.sheet", kLarge * kLarge, {}, "25 ns"};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) {
                    const auto sheet = std::make_shared<Sheet>(kLarge - 1, kLarge - 1, 3, precision);
                    std::vector<double> x;
                    for (std::size_t v = 0; v < kLarge; ++v)
                        for (std::size_t u = 0; u < kLarge; ++u)
                            x.insert(x.end(), {double(u) / kLarge, double(v) / kLarge, 0});
                    sheet->write(CD_POSITION, x);
                    sheet->set(method(Way::coupled_half));
                    sheet->enable(CD_PIN);
                    const double kind = CD_NODE_PINNED, gravity[3] = {0, 0, -9.81};
                    for (std::size_t u : {std::size_t(0), kLarge - 1})
                        for (std::size_t v : {std::size_t(0), kLarge - 1})
                            check(cd_membrane_write_f64(sheet->get(), CD_PIN, u, v, 1, 1, &kind, 1));
                    check(cd_membrane_set_stiffness(sheet->get(), 100, 100));
                    check(cd_membrane_set_gravity(sheet->get(), gravity, 3));
                    check(cd_membrane_set_tolerance(sheet->get(), 1e-4, 100));
                    it.subjects.push_back(
                        {report::name_of(precision), [sheet] { check(cd_membrane_step(sheet->get(), kFrame, 1)); }});
                }
                return it;
            }};
}

// A large lake, on which something splashes every 50 frames and the waves die out by drag. Sleeping, only they cost.
Bench a_sleeping_lake() {
    static constexpr std::size_t kLake = 1024;
    return {"frame.sleep.water", [] {
                const auto lake = [](double height, bool splashes) {
                    const auto water = std::make_shared<Water>(kLake, kLake, 1, 1, CD_FLOAT32);
                    water->write(CD_DEPTH, std::vector<double>(kLake * kLake, 1));
                    check(cd_water_set_drag(water->get(), 1));
                    check(cd_water_set_sleep(water->get(), height));
                    const auto frame = std::make_shared<std::size_t>(0);
                    return [water, frame, splashes] {
                        if (splashes && (*frame)++ % 50 == 0)
                            check(cd_water_splash(water->get(), 0.3 * kLake, 0.6 * kLake, 5, 0.5));
                        check(cd_water_step(water->get(), kFrame, 1));
                    };
                };
                Case it{"frame.sleep.water", kLake * kLake, {}, "what is awake"};
                it.subjects = {{"never sleeps", lake(0, true)},
                               {"sleeps below 1e-3 m", lake(1e-3, true)},
                               {"all asleep", lake(1e-3, false)}};
                return it;
            }};
}

// Hair on a head, of which none, one strand in ten, or all are at rest: a strand that is pushed every frame is awake.
Bench sleeping_ropes() {
    static constexpr std::size_t kStrands = 500, kSprings = 19, kAll = kStrands * (kSprings + 1);
    return {"frame.sleep.ropes", [] {
                const auto hair = [](double speed, std::size_t of) {
                    const auto ropes = std::make_shared<Chain>(kSprings, 3, CD_FLOAT32, kStrands);
                    const double gravity[3] = {0, -9.81, 0};
                    std::vector<double> x;
                    for (std::size_t s = 0; s < kStrands; ++s)
                        for (std::size_t i = 0; i <= kSprings; ++i)
                            x.insert(x.end(), {0.01 * double(s), -0.05 * double(i), 0});
                    ropes->write(CD_POSITION, x);
                    check(cd_chain_set_rest_length(ropes->get(), 0.05 * kSprings));
                    check(cd_chain_set_stiffness(ropes->get(), INFINITY));
                    check(cd_chain_set_lambda(ropes->get(), 1));
                    check(cd_chain_set_drag(ropes->get(), 1));
                    check(cd_chain_set_gravity(ropes->get(), gravity, 3));
                    check(cd_chain_set_end(ropes->get(), CD_END_FIRST, CD_NODE_PINNED));
                    check(cd_chain_set_sleep(ropes->get(), speed, 0.5));
                    const auto frame = std::make_shared<double>(0);
                    return [ropes, frame, of] {
                        const double push[3] = {0.02 * std::sin(*frame += 0.1), 0, 0};
                        for (std::size_t s = 0; s < kStrands && of > 0; s += of)
                            check(cd_chain_impulse(ropes->get(), s, kSprings, push, 3));
                        check(cd_chain_step(ropes->get(), kFrame, 1));
                    };
                };
                Case it{"frame.sleep.ropes", kAll, {}, "what is awake"};
                it.subjects = {{"never sleep", hair(0, 10)},
                               {"one in ten awake", hair(1e-2, 10)},
                               {"all awake", hair(1e-2, 1)},
                               {"all asleep", hair(1e-2, 0)}};
                return it;
            }};
}

} // namespace

std::vector<Bench> frame_benches() {
    return {
        vertices("frame.vertices.sheet", rolling_sheet,
                 [](cd_membrane* x, float* to, std::size_t bytes) {
                     return cd_membrane_write_vertices(x, to, bytes, kVertex, 0, kNormal);
                 }),
        vertices("frame.vertices.water", a_pool,
                 [](cd_water* x, float* to, std::size_t bytes) {
                     return cd_water_write_vertices(x, to, bytes, kVertex, 0, kNormal, SIZE_MAX);
                 }),
        numbers_of_a_sheet(false),
        numbers_of_a_sheet(true),
        copy_of_a_sheet(),
        a_chain_that_comes_and_goes(),
        time_steps("frame.dt.chain", 1001, a_chain, [](cd_chain* x, double dt) { return cd_chain_step(x, dt, 1); }),
        time_steps("frame.dt.stiff_chain", 1001, a_stiff_chain,
                   [](cd_chain* x, double dt) { return cd_chain_step(x, dt, 1); }),
        time_steps("frame.dt.rod", 1001, a_rod, [](cd_chain* x, double dt) { return cd_chain_step(x, dt, 1); }),
        time_steps("frame.dt.sheet", kNodes, rolling_sheet,
                   [](cd_membrane* x, double dt) { return cd_membrane_step(x, dt, 1); }),
        time_steps("frame.dt.water", kNodes, a_pool, [](cd_water* x, double dt) { return cd_water_step(x, dt, 1); }),
        a_pinned_node(),
        a_coupled_sheet(),
        a_sleeping_lake(),
        sleeping_ropes()};
}

} // namespace report
