// Chains: of one and more components, many strands, bend, small scenes, scenes that are nearly still, any length.
#include <cmath>

#include "bench.hpp"
#include "chain_runner.hpp"
#include "textbook.hpp"
#include "textbook_rod.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;

struct Shape {
    std::size_t nodes, components = 1, strands = 1;

    std::size_t lines() const { return components * strands; }
    std::size_t all() const { return nodes * strands; }
    std::size_t numbers() const { return nodes * lines(); }
};

using Setup = std::function<void(cd_chain*)>;
void nothing(cd_chain*) {}

// Mass and stiffness 1, random velocities, lambda = 1/2.
std::shared_ptr<Chain> chain_of(const Shape& shape, cd_precision precision, const Setup& set_up = nothing) {
    const auto chain = std::make_shared<Chain>(shape.nodes - 1, shape.components, precision, shape.strands);
    chain->write(CD_VELOCITY, random_numbers(shape.numbers(), 1));
    set_up(chain->get());
    return chain;
}

Subject stepped(const std::string& name, const std::shared_ptr<Chain>& chain, double dt = kFrame) {
    return {name, [chain, dt] { check(cd_chain_step(chain->get(), dt, 1)); }, [chain] { return chain->hash(); },
            [chain] {
                std::uint64_t count = 0;
                check(cd_chain_get_factorizations(chain->get(), &count));
                return std::size_t(count);
            }};
}

// The lines of a shape, each a chain of its own.
template <class Real> Subject textbook(const Shape& shape, double explicit_dt = 0) {
    const double n = double(shape.nodes);
    const auto lines = std::make_shared<std::vector<TextbookChain<Real>>>(
        shape.lines(), TextbookChain<Real>(shape.nodes, Real(1 / n), Real(n - 1)));
    const std::vector<double> velocity = random_numbers(shape.numbers(), 1);
    for (std::size_t l = 0; l < lines->size(); ++l)
        for (std::size_t i = 0; i < shape.nodes; ++i) {
            const std::size_t strand = l / shape.components, component = l % shape.components;
            (*lines)[l].v[i] = Real(velocity[(strand * shape.nodes + i) * shape.components + component]);
        }
    return {"textbook",
            [lines, explicit_dt] {
                for (auto& line : *lines)
                    if (explicit_dt > 0) line.explicit_step(Real(explicit_dt), true);
                    else line.implicit_step(Real(kFrame), Real(0.5));
            },
            [lines] { return hash_of_all(*lines); }};
}

std::string name_of(const char* what, const Shape& shape) {
    return "chain." + std::string(what) + "." +
           (shape.strands > 1 ? std::to_string(shape.strands) + "x" : std::string()) + std::to_string(shape.nodes) +
           ".c" + std::to_string(shape.components);
}

Bench implicit_beside_textbook(const Shape& shape, const std::string& reach) {
    return {name_of("implicit", shape), [=] {
                Case it{name_of("implicit", shape), shape.all(), {}, reach};
                it.subjects = {stepped("float32", chain_of(shape, CD_FLOAT32)),
                               stepped("float64", chain_of(shape, CD_FLOAT64)), textbook<float>(shape),
                               traffic<float>(2 * shape.numbers())};
                return it;
            }};
}

Bench bent_beside_textbook(const Shape& shape) {
    return {name_of("bend", shape), [=] {
                const double n = double(shape.nodes), bend = 1e-3;
                const Setup set_up = [=](cd_chain* chain) { check(cd_chain_set_bend(chain, bend)); };
                const auto rods = std::make_shared<std::vector<TextbookRod<float>>>(
                    shape.lines(), TextbookRod<float>(shape.nodes, float(1 / n), float(n - 1),
                                                      float(bend * (n - 1) * (n - 1) * (n - 1))));
                const std::vector<double> velocity = random_numbers(shape.numbers(), 1);
                for (std::size_t k = 0; k < velocity.size(); ++k)
                    (*rods)[k % shape.lines()].v[k / shape.lines()] = float(velocity[k]);
                Case it{name_of("bend", shape), shape.all(), {}, "4 times the textbook"};
                it.subjects = {stepped("float32", chain_of(shape, CD_FLOAT32, set_up)),
                               stepped("float64", chain_of(shape, CD_FLOAT64, set_up)),
                               {"textbook",
                                [rods] {
                                    for (auto& rod : *rods) rod.implicit_step(float(kFrame), 0.5f);
                                },
                                [rods] { return hash_of_all(*rods); }},
                               traffic<float>(2 * shape.numbers())};
                return it;
            }};
}

Bench explicit_beside_copy(const Shape& shape) {
    return {name_of("explicit", shape), [=] {
                const auto chains = {chain_of(shape, CD_FLOAT32), chain_of(shape, CD_FLOAT64)};
                const double dt = 0.9 / double(shape.nodes);
                Case it{name_of("explicit", shape), shape.all(), {}, "1.5 times the copy, beyond L2"};
                for (const auto& chain : chains) {
                    check(cd_chain_set_method(chain->get(), CD_METHOD_SYMPLECTIC_EULER));
                    it.subjects.push_back(stepped(it.subjects.empty() ? "float32" : "float64", chain, dt));
                }
                it.subjects.push_back(textbook<float>(shape, dt));
                it.subjects.push_back(traffic<float>(2 * shape.numbers()));
                it.subjects.push_back(wide_traffic(2 * shape.numbers()));
                return it;
            }};
}

Bench shared_by_threads(const Shape& shape) {
    return {name_of("threads", shape), [=] {
                const auto pair = chain_of(shape, CD_FLOAT32);
                check(cd_chain_set_parallel(pair->get(), &two_threads()));
                Case it{name_of("threads", shape), shape.all(), {}, "two threads 1.7 times one, beyond L2"};
                it.subjects = {stepped("one thread", chain_of(shape, CD_FLOAT32)), stepped("two threads", pair)};
                it.subjects.push_back(meeting());
                return it;
            }};
}

// A lively scene, one that has decayed to nothing, and a kick on a still one, which dies out along the line.
Bench still_beside_lively(const Shape& shape, cd_precision precision) {
    const std::string name = name_of("still", shape) + "." + report::name_of(precision);
    return {name, [=] {
                const auto decayed = chain_of(shape, precision), kicked = chain_of(shape, precision);
                const auto stiff = [](cd_chain* chain) { check(cd_chain_set_lambda(chain, 1)); };
                stiff(decayed->get()), stiff(kicked->get());
                check(cd_chain_set_drag(decayed->get(), 100));
                check(cd_chain_set_end(decayed->get(), CD_END_FIRST, CD_NODE_PINNED));
                check(cd_chain_step(decayed->get(), kFrame, 3000000 / shape.all() + 300));
                check(cd_chain_reset(kicked->get()));
                const std::vector<double> kick(shape.components, 1.0);
                check(cd_chain_impulse(kicked->get(), 0, shape.nodes / 2, kick.data(), kick.size()));
                Case it{name, shape.all(), {}, "never slower than the lively one"};
                it.subjects = {
                    stepped("lively", chain_of(shape, precision)),
                    stepped("lively, drag",
                            chain_of(shape, precision, [](cd_chain* c) { check(cd_chain_set_drag(c, 1e-3)); })),
                    stepped("decayed, drag", decayed), stepped("kicked", kicked)};
                return it;
            }};
}

Bench small_scenes() {
    return {"chain.handles.1000x16.c3", [] {
                const Shape shape{16, 3, 1};
                const std::size_t count = 1000;
                Case it{"chain.handles.1000x16.c3", shape.all() * count, {}, "no factorization", count};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) {
                    const auto chains = std::make_shared<std::vector<std::shared_ptr<Chain>>>();
                    for (std::size_t k = 0; k < count; ++k) chains->push_back(chain_of(shape, precision));
                    Subject all = stepped(report::name_of(precision), chains->back());
                    all.step = [chains] {
                        for (const auto& chain : *chains) check(cd_chain_step(chain->get(), kFrame, 1));
                    };
                    it.subjects.push_back(all);
                }
                it.subjects.push_back(textbook<float>({shape.nodes, shape.components, count}));
                it.subjects.push_back(traffic<float>(2 * count * shape.numbers()));
                return it;
            }};
}

// 500 strands of 20 nodes, each rooted by two of them on the upper half of a ball, that sway as the head nods.
Bench hair() {
    static constexpr std::size_t kStrands = 500, kSprings = 19, kAll = kStrands * (kSprings + 1);
    return {"chain.hair.500x20", [] {
                const auto of = [](const std::string& name, double bend, bool on_ball) {
                    const double radius = 0.1, length = 0.3, centre[3] = {0, 0, 0};
                    const auto strands = std::make_shared<Chain>(kSprings, 3, CD_FLOAT32, kStrands);
                    cd_chain* const chain = strands->get();
                    std::vector<double> x, rooted(kAll, 0);
                    for (std::size_t s = 0; s < kStrands; ++s) {
                        const double z = 0.2 + 0.8 * (double(s) + 0.5) / double(kStrands);
                        const double across = std::sqrt(1 - z * z), angle = 2.399963 * double(s);
                        for (std::size_t i = 0; i <= kSprings; ++i) {
                            const double r = 1.001 * radius + length * double(i) / double(kSprings);
                            x.insert(x.end(), {r * across * std::cos(angle), r * across * std::sin(angle), r * z});
                            rooted[s * (kSprings + 1) + i] = i < 2 ? CD_NODE_PINNED : CD_NODE_FREE;
                        }
                    }
                    strands->write(CD_POSITION, x);
                    check(cd_chain_set_rest_length(chain, length)); // so that strands have pins of their own
                    check(cd_chain_set_stiffness(chain, INFINITY));
                    check(cd_chain_enable_field(chain, CD_PIN));
                    check(cd_chain_write_f64(chain, CD_PIN, 0, kStrands, 0, kSprings + 1, rooted.data(), kAll));
                    check(cd_chain_set_mass(chain, 1e-4));
                    check(cd_chain_set_bend(chain, bend));
                    check(cd_chain_set_lambda(chain, 1));
                    check(cd_chain_set_drag(chain, 1));
                    check(cd_chain_set_tolerance(chain, 1e-3, 200));
                    if (on_ball) {
                        check(cd_chain_set_colliders(chain, 1));
                        check(cd_chain_set_capsule(chain, 0, centre, centre, 3, radius, 0.3));
                    }
                    Subject all = stepped(name, strands);
                    const auto time = std::make_shared<double>(0);
                    all.step = [strands, time] {
                        const double nod = 0.5 * std::sin(6 * (*time += kFrame));
                        const double gravity[3] = {9.81 * std::sin(nod), 0, -9.81 * std::cos(nod)};
                        check(cd_chain_set_gravity(strands->get(), gravity, 3));
                        check(cd_chain_step(strands->get(), kFrame, 1));
                    };
                    return all;
                };
                Case it{"chain.hair.500x20", kAll, {}, "50 ns, 500 us a call"};
                it.subjects = {of("bend and ball", 1e-6, true), of("bend", 1e-6, false), of("ball", 0, true)};
                return it;
            }};
}

Bench by_each_kernels(const Shape& shape) {
    return {name_of("kernels", shape), [=] {
                Case it{name_of("kernels", shape), shape.all(), {}};
                it.subjects = of_each_kernels([&](cd_kernels kernels) {
                    const auto chain = chain_of(shape, CD_FLOAT32);
                    check(cd_chain_set_kernels(chain->get(), kernels));
                    return stepped(cd_kernels_name(kernels), chain);
                });
                it.subjects.push_back(traffic<float>(2 * shape.numbers()));
                return it;
            }};
}

// The library alone, at lengths from a hundred nodes to ten million.
Bench at_any_length(const Shape& shape) {
    return {name_of("length", shape), [=] {
                Case it{name_of("length", shape), shape.all(), {}, "flat within 2, but for the copy's steps"};
                it.subjects = {stepped("float32", chain_of(shape, CD_FLOAT32)), traffic<float>(2 * shape.numbers())};
                return it;
            }};
}

} // namespace

std::vector<Bench> chain_benches() {
    std::vector<Bench> all;
    for (std::size_t n : {1000, 10000, 100000, 1000000})
        all.push_back(implicit_beside_textbook({n}, "5 times the textbook"));
    for (std::size_t n : {1000, 100000}) all.push_back(implicit_beside_textbook({n, 3}, "8 times the textbook"));
    all.push_back(implicit_beside_textbook({32, 3, 4096}, "12 times the textbook"));
    for (const Shape& shape : {Shape{1000}, Shape{100000}, Shape{1000, 3}, Shape{32, 3, 4096}})
        all.push_back(bent_beside_textbook(shape));
    for (const Shape& shape :
         {Shape{10000}, Shape{1000000}, Shape{1000000, 3}, Shape{32, 3, 4096}, Shape{32, 3, 32768}})
        all.push_back(explicit_beside_copy(shape));
    for (const Shape& shape : {Shape{32, 3, 4096}, Shape{32, 3, 32768}}) all.push_back(shared_by_threads(shape));
    for (const Shape& shape : {Shape{1000}, Shape{100000}, Shape{1000, 3}, Shape{32, 3, 4096}})
        all.push_back(by_each_kernels(shape));
    for (const Shape& shape : {Shape{10000}, Shape{32, 3, 1024}})
        for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) all.push_back(still_beside_lively(shape, precision));
    all.push_back(small_scenes());
    all.push_back(hair());
    for (std::size_t components : {1, 3})
        for (std::size_t n : {2, 100, 1000, 10000, 100000, 1000000, 10000000})
            if (n * components <= 10000000) all.push_back(at_any_length({n, components}));
    return all;
}

} // namespace report
