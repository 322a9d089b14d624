// Parts of cloth that springs hold together, as wholes.
#include <math.h>

#include "model/membrane_cloth.hh"

namespace cd {

namespace {

// Of a symmetric matrix in the order of ClothMatrix::ground.
void multiply(const double* a, const double* x, double* out) {
    out[0] = a[0] * x[0] + a[3] * x[1] + a[4] * x[2];
    out[1] = a[3] * x[0] + a[1] * x[1] + a[5] * x[2];
    out[2] = a[4] * x[0] + a[5] * x[1] + a[2] * x[2];
}

} // namespace

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
    bool any = false;
    w.each_place([&](size_t at) {
        const size_t part = w.part[at];
        for (int k = 0; k < 3 && part == at; ++k)
            least[k][at] = least[k][at] > most[k][at] ? 0 : fmax(least[k][at], 0) + fmin(most[k][at], 0);
        if (w.bound[part] == kHeld) return;
        any = true;
        double own[6] = {}, touched[6] = {}, kept[3], went[3], rubbed[3], now[3], beside[3], base[3];
        for (int k = 0; k < blocks; ++k) {
            own[k] = w.own[k][at], touched[k] = w.ground[k][at] - own[k];
            matrix[k][part] += w.ground[k][at];
        }
        for (int k = 0; k < 3; ++k) now[k] = w.w[k][at], base[k] = least[k][part], beside[k] = now[k] - base[k];
        multiply(own, now, kept), multiply(own, base, went), multiply(touched, beside, rubbed);
        for (int k = 0; k < 3; ++k) {
            const double given = w.rhs[k][at] + w.residual[k][at];
            shift[k][part] += given - kept[k], whole[k][part] += (given - went[k]) + rubbed[k];
        }
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
