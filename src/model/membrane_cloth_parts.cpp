// Parts of cloth that springs hold together, as wholes.
#include <math.h>

#include "model/membrane_cloth.hh"

namespace cd {

bool share_momentum(const ClothWork& w, size_t contacts, double dt) {
    double *const *const whole = w.error, *const *const shift = w.image, *const *const least = w.answer;
    double *const *const most = w.to, *const matrix[6] = {w.conjugate[0], w.conjugate[1], w.conjugate[2],
                                                          w.trial[0],     w.trial[1],     w.trial[2]};
    for (int k = 0; k < 3; ++k)
        w.each_place([&](size_t at) {
            matrix[k][at] = matrix[k + 3][at] = whole[k][at] = shift[k][at] = w.residual[k][at] = 0;
            least[k][at] = HUGE_VAL, most[k][at] = -HUGE_VAL;
        });
    for (int k = 0; k < 3; ++k)
        w.each_place([&](size_t at) {
            if (w.moves[at] > 0) return;
            double &lower = least[k][w.part[at]], &upper = most[k][w.part[at]];
            lower = fmin(lower, w.w[k][at]), upper = fmax(upper, w.w[k][at]);
        });
    if (CD_WITH_CONTACT) {
        widen_by_contacts(w, contacts, least, most);
        add_contacts(w, contacts, dt, w.w, w.residual, nullptr);
        hold_normals(w, contacts, matrix);
    }
    const int blocks = w.has_blocks() ? 6 : 3;
    const auto add = [&](double* const* planes, size_t at, double x, double y, double z, double* sum) {
        double a[6] = {};
        for (int k = 0; k < blocks; ++k) a[k] = planes[k][at];
        sum[0] += a[0] * x + a[3] * y + a[4] * z;
        sum[1] += a[3] * x + a[1] * y + a[5] * z;
        sum[2] += a[4] * x + a[5] * y + a[2] * z;
    };
    bool any = false;
    w.each_place([&](size_t at) {
        const size_t part = w.part[at];
        for (int k = 0; k < 3 && part == at; ++k)
            least[k][at] = least[k][at] > most[k][at] ? 0 : fmax(least[k][at], 0) + fmin(most[k][at], 0);
        if (w.bound[part] == kHeld) return;
        any = true;
        const double x = w.w[0][at], y = w.w[1][at], z = w.w[2][at];
        double kept[3] = {}, beside[3] = {};
        add(w.own, at, x, y, z, kept);
        add(w.ground, at, x - least[0][part], y - least[1][part], z - least[2][part], beside);
        for (int k = 0; k < 3; ++k) {
            const double left = (w.rhs[k][at] - kept[k]) + w.residual[k][at];
            shift[k][part] += left, whole[k][part] += left + beside[k];
        }
        for (int k = 0; k < blocks; ++k) matrix[k][part] += w.ground[k][at];
    });
    w.each_place([&](size_t at) {
        double sum[6], of_all[3] = {}, more[3] = {};
        const auto solve = [&](double* const* right, double* x) {
            const double of[3] = {right[0][at], right[1][at], right[2][at]};
            return solve_block(sum, of, x);
        };
        for (int k = 0; k < 6; ++k) sum[k] = matrix[k][at];
        if (w.part[at] != at) return;
        if (w.bound[at] != kHeld && (!solve(whole, of_all) || !solve(shift, more))) more[0] = more[1] = more[2] = 0;
        for (int k = 0; k < 3; ++k) whole[k][at] = least[k][at] + of_all[k], shift[k][at] = more[k];
    });
    for (int k = 0; any && k < 3; ++k)
        w.each_place([&](size_t at) { w.w[k][at] += w.moves[at] * shift[k][w.part[at]]; });
    return any;
}

} // namespace cd
