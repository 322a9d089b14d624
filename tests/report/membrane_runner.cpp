#include "membrane_runner.hpp"

#include <cmath>

#include "textbook_sheet.hpp"

namespace report {

Sheet::Sheet(std::size_t nu, std::size_t nv, std::size_t components, cd_precision precision)
    : nu_(nu), nv_(nv), components_(components) {
    check(cd_membrane_create(nu, nv, components, precision, nullptr, &membrane_));
    check(cd_membrane_set_solver(membrane_, CD_SOLVER_ALTERNATING));
}

void Sheet::write(cd_field field, const std::vector<double>& values) {
    const std::size_t columns = nu_ + (field == CD_STIFFNESS_U ? 0 : 1), rows = nv_ + (field == CD_STIFFNESS_V ? 0 : 1);
    check(cd_membrane_write_f64(membrane_, field, 0, 0, columns, rows, values.data(), values.size()));
}

std::vector<double> Sheet::read(cd_field field) const {
    std::vector<double> values((nu_ + 1) * (nv_ + 1) * components_);
    check(cd_membrane_read_f64(membrane_, field, 0, 0, nu_ + 1, nv_ + 1, values.data(), values.size()));
    return values;
}

void Sheet::set(const Method& method) {
    check(cd_membrane_set_method(membrane_, method.method));
    check(cd_membrane_set_solver(membrane_, method.solver));
    check(cd_membrane_set_lambda(membrane_, 0.75));  // a change, so that the next step factors anew
    if (method.method == CD_METHOD_IMPLICIT) check(cd_membrane_set_lambda(membrane_, method.lambda));
}

void Sheet::pin_edges() {
    for (cd_edge edge : {CD_EDGE_U_FIRST, CD_EDGE_U_LAST, CD_EDGE_V_FIRST, CD_EDGE_V_LAST})
        check(cd_membrane_set_edge(membrane_, edge, CD_NODE_PINNED));
}

std::uint64_t Sheet::hash() const {
    std::uint64_t hash = 0;
    check(cd_membrane_hash(membrane_, &hash));
    return hash;
}

std::size_t Sheet::iterations() const {
    std::size_t iterations = 0;
    check(cd_membrane_get_convergence(membrane_, &iterations, nullptr));
    return iterations;
}

namespace {

void set_up(const SheetProblem& problem, Sheet& sheet) {
    cd_membrane* membrane = sheet.get();
    check(cd_membrane_set_mass(membrane, problem.mass));
    check(cd_membrane_set_stiffness(membrane, problem.along_u, problem.along_v));
    if (problem.edges == Edges::held) sheet.pin_edges();
    if (problem.edges == Edges::held_along_v)
        for (cd_edge edge : {CD_EDGE_V_FIRST, CD_EDGE_V_LAST})
            check(cd_membrane_set_edge(membrane, edge, CD_NODE_PINNED));
    if (problem.seam > 0) {
        sheet.enable(CD_STIFFNESS_V);
        const std::vector<double> row(problem.nu + 1, problem.spring_along_v(problem.nv / 2));
        check(
            cd_membrane_write_f64(membrane, CD_STIFFNESS_V, 0, problem.nv / 2, row.size(), 1, row.data(), row.size()));
    }
    const double origin = 0;
    if (problem.tie > 0) check(cd_membrane_attach(membrane, 0, 0, problem.tie, 0, &origin, 1));
}

class LibraryRunner : public Runner {
public:
    LibraryRunner(const SheetProblem& problem, const Method& method, cd_precision precision)
        : problem_(problem), method_(method), sheet_(problem.nu, problem.nv, 1, precision) {
        set_up(problem, sheet_);
        reset();
    }

    void reset() override {
        check(cd_membrane_reset(sheet_.get()));
        if (!problem_.position.empty()) sheet_.write(CD_POSITION, problem_.position);
        if (!problem_.velocity.empty()) sheet_.write(CD_VELOCITY, problem_.velocity);
        sheet_.set(method_);
    }

    bool step(double dt, std::size_t count) override {
        const cd_status status = cd_membrane_step(sheet_.get(), dt, count);
        if (status == CD_ERROR_DIVERGED || status == CD_ERROR_TOLERANCE) return false;
        check(status);
        return true;
    }

    std::vector<double> positions() const override { return sheet_.read(CD_POSITION); }
    std::vector<double> velocities() const override { return sheet_.read(CD_VELOCITY); }
    std::uint64_t hash() const override { return sheet_.hash(); }
    std::size_t iterations() const override { return sheet_.iterations(); }

private:
    SheetProblem problem_;
    Method method_;
    Sheet sheet_;
};

template <class Real> class TextbookRunner : public Runner {
public:
    TextbookRunner(const SheetProblem& problem, const Method& method)
        : problem_(problem),
          method_(method),
          sheet_(problem.nu + 1, problem.nv + 1, Real(problem.mass_of_node()), Real(problem.spring_along_u())) {
        for (std::size_t v = 0; v < problem.nv; ++v) sheet_.along_v[v] = Real(problem.spring_along_v(v));
        for (std::size_t v = 0; v <= problem.nv; ++v)
            for (std::size_t u = 0; u <= problem.nu; ++u) sheet_.held[v * (problem.nu + 1) + u] = problem.is_held(u, v);
        sheet_.tie = Real(problem.tie);
        reset();
    }

    void reset() override {
        sheet_.x.assign(problem_.nodes(), 0);
        sheet_.v.assign(problem_.nodes(), 0);
        if (!problem_.position.empty()) sheet_.x.assign(problem_.position.begin(), problem_.position.end());
        if (!problem_.velocity.empty()) sheet_.v.assign(problem_.velocity.begin(), problem_.velocity.end());
    }

    bool step(double dt, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i) {
            if (method_.is_explicit()) sheet_.explicit_step(Real(dt), method_.method == CD_METHOD_SYMPLECTIC_EULER);
            else sheet_.implicit_step(Real(dt), Real(method_.lambda));
        }
        for (Real x : sheet_.x)
            if (!std::isfinite(x)) return false;
        return true;
    }

    std::vector<double> positions() const override { return {sheet_.x.begin(), sheet_.x.end()}; }
    std::vector<double> velocities() const override { return {sheet_.v.begin(), sheet_.v.end()}; }
    std::uint64_t hash() const override { return hash_of(sheet_.v, hash_of(sheet_.x, kHashStart)); }

private:
    SheetProblem problem_;
    Method method_;
    TextbookSheet<Real> sheet_;
};

}  // namespace

std::unique_ptr<Runner> make_runner(const SheetProblem& problem, const Method& method, cd_precision precision) {
    if (!method.textbook) return std::make_unique<LibraryRunner>(problem, method, precision);
    if (precision == CD_FLOAT32) return std::make_unique<TextbookRunner<float>>(problem, method);
    return std::make_unique<TextbookRunner<double>>(problem, method);
}

MakeRunner runners_of(const SheetProblem& problem) {
    return [problem](const Method& how, cd_precision precision) { return make_runner(problem, how, precision); };
}

double stable_dt(const SheetProblem& problem) {
    Sheet sheet(problem.nu, problem.nv, 1, precisions().front());
    set_up(problem, sheet);
    double dt = 0;
    check(cd_membrane_stable_dt(sheet.get(), &dt));
    return dt;
}

}  // namespace report
