#include "chain_runner.hpp"

#include <cmath>

#include "textbook.hpp"

namespace report {

Chain::Chain(std::size_t springs, std::size_t components, cd_precision precision, std::size_t strands)
    : strands_(strands), springs_(springs), components_(components) {
    check(cd_chain_create(strands, springs, components, precision, nullptr, &chain_));
}

void Chain::write(cd_field field, const std::vector<double>& values) {
    bool shared = field == CD_MASS || field == CD_STIFFNESS || field == CD_BEND || field == CD_PIN;
    std::size_t n = field == CD_STIFFNESS ? springs_ : springs_ + 1;
    check(cd_chain_write_f64(chain_, field, 0, shared ? 1 : strands_, 0, n, values.data(), values.size()));
}

std::vector<double> Chain::read(cd_field field) const {
    std::vector<double> values(strands_ * (springs_ + 1) * components_);
    check(cd_chain_read_f64(chain_, field, 0, strands_, 0, springs_ + 1, values.data(), values.size()));
    return values;
}

std::uint64_t Chain::hash() const {
    std::uint64_t hash = 0;
    check(cd_chain_hash(chain_, &hash));
    return hash;
}

const std::vector<Way>& library_ways() {
    static const std::vector<Way> kWays = {Way::forward_euler, Way::symplectic_euler, Way::half, Way::backward,
                                           Way::stiff_second};
    return kWays;
}

namespace {

class LibraryRunner : public Runner {
public:
    LibraryRunner(const Problem& problem, const Method& method, cd_precision precision)
        : problem_(problem), method_(method), chain_(problem.springs, 1, precision) {
        cd_chain* chain = chain_.get();
        check(cd_chain_set_mass(chain, problem.mass));
        check(cd_chain_set_stiffness(chain, problem.stiffness));
        if (problem.pin_first) check(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        if (problem.pin_last) check(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
        check(cd_chain_set_gravity(chain, &problem.gravity, 1));
        check(cd_chain_set_drag(chain, problem.drag));
        const double origin = 0;
        if (problem.tie > 0) check(cd_chain_attach(chain, 0, problem.springs, problem.tie, 0, &origin, 1));
        if (!problem.node_mass.empty()) {
            check(cd_chain_enable_field(chain, CD_MASS));
            chain_.write(CD_MASS, problem.node_mass);
        }
        check(cd_chain_set_method(chain, method.method));
        reset();
    }

    void reset() override {
        check(cd_chain_reset(chain_.get()));
        if (!problem_.position.empty()) chain_.write(CD_POSITION, problem_.position);
        if (!problem_.velocity.empty()) chain_.write(CD_VELOCITY, problem_.velocity);
        check(cd_chain_set_lambda(chain_.get(), 0.75));  // a change, so that the next step factors anew
        if (method_.method == CD_METHOD_IMPLICIT) check(cd_chain_set_lambda(chain_.get(), method_.lambda));
    }

    bool step(double dt, std::size_t count) override {
        cd_status status = cd_chain_step(chain_.get(), dt, count);
        if (status == CD_ERROR_DIVERGED) return false;
        check(status);
        return true;
    }

    std::vector<double> positions() const override { return chain_.read(CD_POSITION); }
    std::vector<double> velocities() const override { return chain_.read(CD_VELOCITY); }
    std::uint64_t hash() const override { return chain_.hash(); }

private:
    Problem problem_;
    Method method_;
    Chain chain_;
};

template <class Real>
class TextbookRunner : public Runner {
public:
    TextbookRunner(const Problem& problem, const Method& method)
        : problem_(problem), method_(method),
          chain_(problem.springs + 1, Real(problem.mass_of_node()), Real(problem.stiffness_of_spring())) {
        chain_.pin_first = problem.pin_first;
        chain_.pin_last = problem.pin_last;
        chain_.gravity = Real(problem.gravity);
        chain_.drag = Real(problem.drag);
        chain_.tie = Real(problem.tie);
        if (!problem.node_mass.empty()) chain_.mass.assign(problem.node_mass.begin(), problem.node_mass.end());
        reset();
    }

    void reset() override {
        chain_.x.assign(chain_.nodes, 0);
        chain_.v.assign(chain_.nodes, 0);
        if (!problem_.position.empty()) chain_.x.assign(problem_.position.begin(), problem_.position.end());
        if (!problem_.velocity.empty()) chain_.v.assign(problem_.velocity.begin(), problem_.velocity.end());
    }

    bool step(double dt, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i) {
            if (method_.is_explicit())
                chain_.explicit_step(Real(dt), method_.method == CD_METHOD_SYMPLECTIC_EULER);
            else
                chain_.implicit_step(Real(dt), Real(method_.lambda));
        }
        for (Real x : chain_.x)
            if (!std::isfinite(x)) return false;
        return true;
    }

    std::vector<double> positions() const override { return {chain_.x.begin(), chain_.x.end()}; }
    std::vector<double> velocities() const override { return {chain_.v.begin(), chain_.v.end()}; }

    std::uint64_t hash() const override { return hash_of(chain_.v, hash_of(chain_.x, kHashStart)); }

private:
    Problem problem_;
    Method method_;
    TextbookChain<Real> chain_;
};

}  // namespace

std::unique_ptr<Runner> make_runner(const Problem& problem, const Method& method, cd_precision precision) {
    if (!method.textbook) return std::make_unique<LibraryRunner>(problem, method, precision);
    if (precision == CD_FLOAT32) return std::make_unique<TextbookRunner<float>>(problem, method);
    return std::make_unique<TextbookRunner<double>>(problem, method);
}

MakeRunner runners_of(const Problem& problem) {
    return [problem](const Method& how, cd_precision precision) { return make_runner(problem, how, precision); };
}

double stable_dt(const Problem& problem) {
    Chain chain(problem.springs, 1, precisions().front());
    check(cd_chain_set_mass(chain.get(), problem.mass));
    check(cd_chain_set_stiffness(chain.get(), problem.stiffness));
    if (problem.pin_first) check(cd_chain_set_end(chain.get(), CD_END_FIRST, CD_NODE_PINNED));
    if (problem.pin_last) check(cd_chain_set_end(chain.get(), CD_END_LAST, CD_NODE_PINNED));
    check(cd_chain_set_drag(chain.get(), problem.drag));
    const double origin = 0;
    if (problem.tie > 0) check(cd_chain_attach(chain.get(), 0, problem.springs, problem.tie, 0, &origin, 1));
    double dt = 0;
    check(cd_chain_stable_dt(chain.get(), &dt));
    return dt;
}

}  // namespace report
