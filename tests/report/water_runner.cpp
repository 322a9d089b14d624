#include "water_runner.hpp"

#include <cmath>

#include "textbook_water.hpp"

namespace report {

Water::Water(std::size_t nx, std::size_t ny, double dx, double dy, cd_precision precision) : nx_(nx), ny_(ny) {
    check(cd_water_create(nx, ny, dx, dy, precision, nullptr, &water_));
}

void Water::write(cd_field field, const std::vector<double>& values) {
    check(cd_water_write_f64(water_, field, 0, 0, columns(field), rows(field), values.data(), values.size()));
}

std::vector<double> Water::read(cd_field field) const {
    std::vector<double> values(columns(field) * rows(field));
    check(cd_water_read_f64(water_, field, 0, 0, columns(field), rows(field), values.data(), values.size()));
    return values;
}

void Water::set(const Method& method) {
    check(cd_water_set_momentum(water_, method.momentum));
    check(cd_water_set_method(water_, method.method));
    if (method.method == CD_METHOD_IMPLICIT) check(cd_water_set_lambda(water_, method.lambda));
}

double Water::volume() const {
    double volume = 0;
    check(cd_water_get_volume(water_, &volume));
    return volume;
}

double Water::energy() const {
    double kinetic = 0, potential = 0;
    check(cd_water_get_energy(water_, &kinetic, &potential));
    return kinetic + potential;
}

std::uint64_t Water::hash() const {
    std::uint64_t hash = 0;
    check(cd_water_hash(water_, &hash));
    return hash;
}

void set_up(const WaterProblem& problem, Water& water) {
    check(cd_water_set_gravity(water.get(), kEarth));
    if (!problem.bed.empty()) water.write(CD_BED, problem.bed);
    water.write(CD_DEPTH, problem.depth);
    if (!problem.velocity_x.empty()) water.write(CD_VELOCITY_X, problem.velocity_x);
    if (!problem.velocity_y.empty()) water.write(CD_VELOCITY_Y, problem.velocity_y);
}

namespace {

class LibraryRunner : public Runner {
public:
    LibraryRunner(const WaterProblem& problem, const Method& method, cd_precision precision)
        : problem_(problem), water_(problem.nx, problem.ny, problem.dx, problem.dy, precision) {
        water_.set(method);
        reset();
    }

    void reset() override {
        check(cd_water_reset(water_.get()));
        check(cd_water_set_first(water_.get(), 0));
        set_up(problem_, water_);
    }

    bool step(double dt, std::size_t count) override {
        const cd_status status = cd_water_step(water_.get(), dt, count);
        if (status == CD_ERROR_DIVERGED) return false;
        check(status);
        return true;
    }

    std::vector<double> positions() const override {
        std::vector<double> depth = water_.read(CD_DEPTH);
        for (double& d : depth) d -= problem_.still;
        return depth;
    }
    std::vector<double> velocities() const override { return {}; }
    std::uint64_t hash() const override { return water_.hash(); }

private:
    WaterProblem problem_;
    Water water_;
};

template <class Real> class TextbookRunner : public Runner {
public:
    TextbookRunner(const WaterProblem& problem, const Method& method)
        : problem_(problem), water_(problem.nx, problem.ny, Real(problem.dx), Real(problem.dy), Real(kEarth)) {
        water_.puts_back = method.puts_back;
        if (!problem.bed.empty()) water_.bed.assign(problem.bed.begin(), problem.bed.end());
        reset();
    }

    void reset() override {
        for (std::size_t k = 0; k < problem_.cells(); ++k)
            water_.now[k] = water_.before[k] = Real(double(water_.bed[k]) + problem_.depth[k]);
        fresh_ = true;
    }

    bool step(double dt, std::size_t count) override {
        if (fresh_ && !problem_.rate.empty())
            for (std::size_t k = 0; k < problem_.cells(); ++k) water_.before[k] -= Real(dt * problem_.rate[k]);
        fresh_ = false;
        for (std::size_t i = 0; i < count; ++i) water_.step(Real(dt));
        for (Real h : water_.now)
            if (!std::isfinite(h)) return false;
        return true;
    }

    std::vector<double> positions() const override {
        std::vector<double> depth(problem_.cells());
        for (std::size_t k = 0; k < depth.size(); ++k)
            depth[k] = double(water_.now[k]) - double(water_.bed[k]) - problem_.still;
        return depth;
    }
    std::vector<double> velocities() const override { return {}; }
    std::uint64_t hash() const override { return hash_of(water_.now, hash_of(water_.before, kHashStart)); }

private:
    WaterProblem problem_;
    TextbookWater<Real> water_;
    bool fresh_ = true;
};

} // namespace

std::unique_ptr<Runner> make_runner(const WaterProblem& problem, const Method& method, cd_precision precision) {
    if (!method.textbook) return std::make_unique<LibraryRunner>(problem, method, precision);
    if (precision == CD_FLOAT32) return std::make_unique<TextbookRunner<float>>(problem, method);
    return std::make_unique<TextbookRunner<double>>(problem, method);
}

MakeRunner runners_of(const WaterProblem& problem) {
    return [problem](const Method& how, cd_precision precision) { return make_runner(problem, how, precision); };
}

double stable_dt(const WaterProblem& problem) {
    Water water(problem.nx, problem.ny, problem.dx, problem.dy, precisions().front());
    set_up(problem, water);
    double dt = 0;
    check(cd_water_stable_dt(water.get(), &dt));
    return dt;
}

} // namespace report
