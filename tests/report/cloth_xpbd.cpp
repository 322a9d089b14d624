#include "cloth_xpbd.hpp"

#include <algorithm>
#include <cmath>

#include "each_width.hpp"

namespace report {
namespace {

// Puts a row of springs right, one Gauss-Seidel step of each. Once: the only iteration of a substep, of which nothing
// has pulled before. A spring's multiplier is its pull in units in which a node moves by its inverse mass times it.
template <bool Once>
inline __attribute__((always_inline)) void pull(float* __restrict x0, float* __restrict y0, float* __restrict z0,
                                                float* __restrict x1, float* __restrict y1, float* __restrict z1,
                                                const float* w0, const float* w1, const float* there,
                                                float* __restrict pulled, float length, float compliance,
                                                std::size_t lanes) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const float dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const float now = std::sqrt(dx * dx + dy * dy + dz * dz + 1e-20f), weight = w0[i] + w1[i] + compliance;
        float change;
        if (Once) {
            const float over = now - length;
            change = there[i] * (over > 0 ? over : 0.0f) / (weight * now);
        } else {
            const float old = pulled[i], next = old + (now - length - compliance * old) / weight;
            const float kept = there[i] * (next > 0 ? next : 0.0f);
            pulled[i] = kept;
            change = (kept - old) / now;
        }
        const float a = w0[i] * change, b = w1[i] * change;
        x0[i] += a * dx, y0[i] += a * dy, z0[i] += a * dz;
        x1[i] -= b * dx, y1[i] -= b * dy, z1[i] -= b * dz;
    }
}

struct Sweep {
    float *x, *y, *z, *multipliers;
    const float* inverse_mass;
    float h;
    std::size_t lanes;
};

template <bool Once>
inline __attribute__((always_inline)) void pull_all(const Sweep& all, const std::vector<XpbdCloth::Row>& rows) {
    for (const XpbdCloth::Row& row : rows)
        pull<Once>(all.x + row.first, all.y + row.first, all.z + row.first, all.x + row.second, all.y + row.second,
                   all.z + row.second, all.inverse_mass + row.first, all.inverse_mass + row.second, row.there,
                   all.multipliers + row.multiplier, row.length, 1 / (row.stiffness * all.h * all.h), all.lanes);
}
REPORT_EACH_WIDTH void pull_once(const Sweep& all, const std::vector<XpbdCloth::Row>& rows) {
    pull_all<true>(all, rows);
}
REPORT_EACH_WIDTH void pull_again(const Sweep& all, const std::vector<XpbdCloth::Row>& rows) {
    pull_all<false>(all, rows);
}

REPORT_EACH_WIDTH void fall(float* __restrict x, float* __restrict before, float* __restrict v,
                            const float* __restrict free, float gained, float h, std::size_t numbers) {
    for (std::size_t i = 0; i < numbers; ++i) {
        before[i] = x[i];
        v[i] += gained * free[i];
        x[i] += h * v[i];
    }
}
REPORT_EACH_WIDTH void take_velocity(const float* __restrict x, const float* __restrict before, float* __restrict v,
                                     float rate, std::size_t numbers) {
    for (std::size_t i = 0; i < numbers; ++i) v[i] = rate * (x[i] - before[i]);
}

} // namespace

XpbdCloth::XpbdCloth(const ClothScene& scene, int substeps, int iterations)
    : scene_(scene), substeps_(substeps), iterations_(iterations) {
    const std::size_t n = scene.side, even = (n + 1) / 2, odd = n / 2;
    lanes_ = (even + 7) / 8 * 8;
    pitch_ = lanes_ + 8;
    const std::size_t numbers = 2 * pitch_ * n;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::vector<float>* field : {&position_[k], &before_[k], &velocity_[k]}) field->assign(numbers, 0.0f);
    inverse_mass_.assign(numbers, 0.0f);
    free_.assign(numbers, 0.0f);
    for (std::size_t v = 0; v < n; ++v)
        for (std::size_t u = 0; u < n; ++u)
            if (v > 0 || (u > 0 && u < n - 1))
                inverse_mass_[node(u, v)] = float(double(n * n) / scene.mass), free_[node(u, v)] = 1;

    all_.assign(lanes_, 0.0f), short_even_ = short_odd_ = all_;
    std::fill_n(all_.begin(), even, 1.0f);
    std::fill_n(short_even_.begin(), odd, 1.0f);     // from even nodes to the odd ones behind them
    std::fill_n(short_odd_.begin(), even - 1, 1.0f); // from odd nodes to the even ones behind them
    const float length = float(scene.length()), diagonal = length * std::sqrt(2.0f);
    const float k = float(scene.stiffness), shear = float(scene.shear);
    std::size_t multiplier = 0;
    auto add = [&](std::size_t first, std::size_t second, float rest, float stiffness,
                   const std::vector<float>& there) {
        rows_.push_back({first, second, multiplier, rest, stiffness, there.data()});
        multiplier += lanes_;
    };
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t here = node(0, v), odd_here = node(1, v), next = node(0, v + 1), odd_next = node(1, v + 1);
        add(here, odd_here, length, k, short_even_);
        add(odd_here, here + 1, length, k, short_odd_);
        if (v + 1 == n) break;
        add(here, next, length, k, all_);
        add(odd_here, odd_next, length, k, short_even_);
        add(here, odd_next, diagonal, shear, short_even_);
        add(odd_here, next + 1, diagonal, shear, short_odd_);
        add(odd_here, next, diagonal, shear, short_even_);
        add(here + 1, odd_next, diagonal, shear, short_odd_);
    }
    multipliers_.assign(multiplier, 0.0f);
    reset();
}

void XpbdCloth::reset() {
    for (std::vector<float>& component : velocity_) std::fill(component.begin(), component.end(), 0.0f);
    for (std::size_t v = 0; v < scene_.side; ++v)
        for (std::size_t u = 0; u < scene_.side; ++u) {
            position_[0][node(u, v)] = float(double(u) * scene_.length());
            position_[1][node(u, v)] = 0;
            position_[2][node(u, v)] = float(double(v) * scene_.length());
        }
}

void XpbdCloth::frame(double dt) {
    const float h = float(dt / substeps_), gained = float(-scene_.gravity) * h;
    const Sweep all{position_[0].data(),
                    position_[1].data(),
                    position_[2].data(),
                    multipliers_.data(),
                    inverse_mass_.data(),
                    h,
                    lanes_};
    for (int substep = 0; substep < substeps_; ++substep) {
        for (std::size_t k = 0; k < 3; ++k)
            fall(position_[k].data(), before_[k].data(), velocity_[k].data(), free_.data(), k == 1 ? gained : 0.0f, h,
                 free_.size());
        if (iterations_ == 1) pull_once(all, rows_);
        else {
            std::fill(multipliers_.begin(), multipliers_.end(), 0.0f);
            for (int i = 0; i < iterations_; ++i) pull_again(all, rows_);
        }
        for (std::size_t k = 0; k < 3; ++k)
            take_velocity(position_[k].data(), before_[k].data(), velocity_[k].data(), 1 / h, free_.size());
    }
}

} // namespace report
