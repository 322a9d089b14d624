// Parts of cloth that springs hold together, as wholes.
#include <math.h>

#include "model/membrane_cloth.hh"

namespace cd {

bool share_momentum(const ClothWork& w, size_t contacts) {
    double *const *const force = w.error, *const *const missing = w.image;
    double* const matrix[6] = {w.conjugate[0], w.conjugate[1], w.conjugate[2], w.answer[0], w.answer[1], w.answer[2]};
    w.each_place([&](size_t at) {
        for (int k = 0; k < 3 && w.part[at] == at; ++k) {
            matrix[k][at] = matrix[k + 3][at] = 0;
            missing[k][at] = w.bound[at] > 0 ? HUGE_VAL : 0;
            force[k][at] = -missing[k][at];
        }
    });
    const int blocks = w.has_blocks() ? 6 : 3;
    w.each_place([&](size_t at) {
        const size_t part = w.part[at];
        if (w.bound[part] > 0) {
            for (int k = 0; k < 3 && !(w.moves[at] > 0); ++k) {
                missing[k][part] = fmin(missing[k][part], w.w[k][at]);
                force[k][part] = fmax(force[k][part], w.w[k][at]);
            }
            return;
        }
        double own[6] = {}, kept[3];
        for (int k = 0; k < blocks; ++k) own[k] = w.own[k][at], matrix[k][part] += own[k];
        const double x = w.w[0][at], y = w.w[1][at], z = w.w[2][at];
        kept[0] = own[0] * x + own[3] * y + own[4] * z;
        kept[1] = own[3] * x + own[1] * y + own[5] * z;
        kept[2] = own[4] * x + own[5] * y + own[2] * z;
        for (int k = 0; k < 3; ++k) force[k][part] += w.given[k][at], missing[k][part] += w.given[k][at] - kept[k];
    });
    if (CD_WITH_CONTACT) widen_by_contacts(w, contacts, missing, force);
    bool any = false;
    w.each_place([&](size_t at) {
        if (w.part[at] != at) return;
        for (int k = 0; k < 3 && w.bound[at] > 0; ++k) {
            const double least = missing[k][at], most = force[k][at];
            force[k][at] = least > most ? 0 : fmax(least, 0) + fmin(most, 0);
            missing[k][at] = 0;
        }
        if (w.bound[at] > 0) return;
        double sum[6], mean[3] = {}, shift[3] = {};
        const auto solve = [&](double* const* right, double* x) {
            const double of[3] = {right[0][at], right[1][at], right[2][at]};
            return solve_block(sum, of, x);
        };
        for (int k = 0; k < 6; ++k) sum[k] = matrix[k][at];
        any = true;
        if (!solve(force, mean) || !solve(missing, shift)) shift[0] = shift[1] = shift[2] = 0;
        for (int k = 0; k < 3; ++k) force[k][at] = mean[k], missing[k][at] = shift[k];
    });
    for (int k = 0; any && k < 3; ++k)
        w.each_place([&](size_t at) { w.w[k][at] += w.moves[at] * missing[k][w.part[at]]; });
    return any;
}

} // namespace cd
