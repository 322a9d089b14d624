// Sheets: alternating, coupled and explicit steps, two threads, scenes that are nearly still, any size.
#include "bench.hpp"
#include "membrane_runner.hpp"
#include "textbook_sheet.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;

std::shared_ptr<Sheet> sheet_of(std::size_t side, std::size_t components, cd_precision precision,
                                Way way = Way::alternating_half) {
    const auto sheet = std::make_shared<Sheet>(side - 1, side - 1, components, precision);
    sheet->write(CD_VELOCITY, random_numbers(side * side * components, 1));
    sheet->set(method(way));
    return sheet;
}

Subject stepped(const std::string& name, const std::shared_ptr<Sheet>& sheet, double dt = kFrame) {
    return {name, [sheet, dt] { check(cd_membrane_step(sheet->get(), dt, 1)); }, [sheet] { return sheet->hash(); },
            [sheet] {
                std::uint64_t count = 0;
                check(cd_membrane_get_factorizations(sheet->get(), &count));
                return std::size_t(count);
            }};
}

// One sheet of the textbook's for each component.
template <class Real> Subject textbook(std::size_t side, std::size_t components, double explicit_dt = 0) {
    SheetProblem problem;
    problem.nu = problem.nv = side - 1;
    TextbookSheet<Real> one(side, side, Real(problem.mass_of_node()), Real(problem.spring_along_u()));
    for (std::size_t v = 0; v + 1 < side; ++v) one.along_v[v] = Real(problem.spring_along_v(v));
    const auto sheets = std::make_shared<std::vector<TextbookSheet<Real>>>(components, one);
    const std::vector<double> velocity = random_numbers(side * side * components, 1);
    for (std::size_t k = 0; k < velocity.size(); ++k) (*sheets)[k % components].v[k / components] = Real(velocity[k]);
    return {"textbook",
            [sheets, explicit_dt] {
                for (auto& sheet : *sheets)
                    if (explicit_dt > 0) sheet.explicit_step(Real(explicit_dt), true);
                    else sheet.implicit_step(Real(kFrame), Real(0.5));
            },
            [sheets] { return hash_of_all(*sheets); }};
}

std::string name_of(const char* what, std::size_t side, std::size_t components) {
    return "sheet." + std::string(what) + "." + std::to_string(side) + ".c" + std::to_string(components);
}

Bench alternating(std::size_t side, std::size_t components, const std::string& reach) {
    const std::string name = name_of("alternating", side, components);
    return {name, [=] {
                Case it{name, side * side, {}, reach};
                it.subjects = {stepped("float32", sheet_of(side, components, CD_FLOAT32)),
                               stepped("float64", sheet_of(side, components, CD_FLOAT64)),
                               textbook<float>(side, components), traffic<float>(2 * side * side * components)};
                return it;
            }};
}

Bench coupled(std::size_t side, std::size_t components) {
    const std::string name = name_of("coupled", side, components);
    return {name, [=] {
                Case it{name, side * side, {}, "cheaper than CHOLMOD's solve alone"};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) {
                    const auto sheet = sheet_of(side, components, precision, Way::coupled_half);
                    check(cd_membrane_set_tolerance(sheet->get(), 1e-4, 100));
                    it.subjects.push_back(stepped(report::name_of(precision), sheet));
                }
                it.subjects.push_back(traffic<float>(2 * side * side * components));
                return it;
            }};
}

Bench explicit_beside_copy(std::size_t side, std::size_t components) {
    const std::string name = name_of("explicit", side, components);
    return {name, [=] {
                const double dt = 0.6 / double(side);
                Case it{name, side * side, {}, "1.5 times the copy, beyond L2"};
                for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64})
                    it.subjects.push_back(stepped(report::name_of(precision),
                                                  sheet_of(side, components, precision, Way::symplectic_euler), dt));
                it.subjects.push_back(textbook<float>(side, components, dt));
                it.subjects.push_back(traffic<float>(2 * side * side * components));
                it.subjects.push_back(wide_traffic(2 * side * side * components));
                return it;
            }};
}

Bench shared_by_threads(std::size_t side, std::size_t components) {
    const std::string name = name_of("threads", side, components);
    return {
        name, [=] {
            const auto pair = sheet_of(side, components, CD_FLOAT32);
            check(cd_membrane_set_parallel(pair->get(), &two_threads()));
            Case it{name, side * side, {}, "two threads 1.7 times one, beyond L2"};
            it.subjects = {stepped("one thread", sheet_of(side, components, CD_FLOAT32)), stepped("two threads", pair)};
            it.subjects.push_back(meeting());
            return it;
        }};
}

Bench still_beside_lively(std::size_t side, cd_precision precision) {
    const std::string name = name_of("still", side, 1) + "." + report::name_of(precision);
    return {name, [=] {
                const auto decayed = sheet_of(side, 1, precision), kicked = sheet_of(side, 1, precision);
                for (const auto& sheet : {decayed, kicked}) sheet->set(method(Way::alternating_backward));
                decayed->pin_edges();
                check(cd_membrane_set_drag(decayed->get(), 100));
                check(cd_membrane_step(decayed->get(), kFrame, 2000));
                check(cd_membrane_reset(kicked->get()));
                const double kick = 1;
                check(cd_membrane_impulse(kicked->get(), side / 2, side / 2, 0, &kick, 1));
                const auto lively = sheet_of(side, 1, precision);
                lively->pin_edges();
                check(cd_membrane_set_drag(lively->get(), 1e-3));
                Case it{name, side * side, {}, "never slower than the lively one"};
                it.subjects = {stepped("lively", sheet_of(side, 1, precision)), stepped("lively, drag", lively),
                               stepped("decayed, drag", decayed), stepped("kicked", kicked)};
                return it;
            }};
}

Bench by_each_kernels(std::size_t side, std::size_t components, Way way) {
    const std::string name = name_of(way == Way::coupled_half ? "kernels.coupled" : "kernels", side, components);
    return {name, [=] {
                Case it{name, side * side, {}};
                it.subjects = of_each_kernels([&](cd_kernels kernels) {
                    const auto sheet = sheet_of(side, components, CD_FLOAT32, way);
                    check(cd_membrane_set_kernels(sheet->get(), kernels));
                    return stepped(cd_kernels_name(kernels), sheet);
                });
                it.subjects.push_back(traffic<float>(2 * side * side * components));
                return it;
            }};
}

Bench at_any_size(std::size_t side, std::size_t components) {
    const std::string name = name_of("size", side, components);
    return {name, [=] {
                Case it{name, side * side, {}, "flat within 2, but for the copy's steps"};
                it.subjects = {stepped("float32", sheet_of(side, components, CD_FLOAT32)),
                               traffic<float>(2 * side * side * components)};
                return it;
            }};
}

} // namespace

std::vector<Bench> sheet_benches() {
    std::vector<Bench> all = {alternating(256, 3, "14 times the textbook"),
                              alternating(1024, 3, "16 times the textbook"),
                              alternating(256, 1, ""),
                              alternating(1024, 1, "at most 5 times the copy"),
                              coupled(256, 1),
                              coupled(256, 3)};
    for (std::size_t side : {256, 1024, 2048}) all.push_back(explicit_beside_copy(side, 1));
    for (std::size_t side : {1024, 2048}) all.push_back(explicit_beside_copy(side, 3));
    all.push_back(shared_by_threads(512, 1));
    all.push_back(shared_by_threads(1024, 3));
    for (std::size_t side : {256, 1024}) all.push_back(by_each_kernels(side, 3, Way::alternating_half));
    all.push_back(by_each_kernels(256, 3, Way::coupled_half));
    for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) all.push_back(still_beside_lively(128, precision));
    for (std::size_t side : {2, 10, 32, 100, 316, 1000, 3162}) all.push_back(at_any_size(side, 1));
    return all;
}

} // namespace report
