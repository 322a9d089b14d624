// Something falls into a pool with an island: its waves, seen from above, and the account of its water.
#include <contdyn/contdyn.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

using contdyn::field;

int main() {
    const std::size_t nx = 72, ny = 48;
    const double cell = 4.0 / nx; // m: 4 m x 2.67 m
    contdyn::water pool(nx, ny, cell, cell);

    std::vector<double> bed;
    for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
            const double x = (static_cast<double>(i) + 0.5) * cell - 2.7,
                         y = (static_cast<double>(j) + 0.5) * cell - 1.3;
            bed.push_back(std::fmax(0, 0.75 - 0.8 * std::sqrt(x * x + y * y)));
        }
    }
    pool.write_f64(field::bed, bed);
    pool.write_f64(field::surface, std::vector<double>(nx * ny, 0.5)); // half a metre deep
    pool.splash(1.0, 1.2, 0.25, 0.2);

    for (int picture = 0; picture < 3; ++picture) {
        if (picture > 0) pool.step(1 / 120.0, 48);
        const std::vector<double> surface = pool.read_f64(field::surface), depth = pool.read_f64(field::depth);
        std::printf("%.1f s\n", pool.get_time());
        for (std::size_t j = 0; j < ny; j += 2) {
            for (std::size_t i = 0; i < nx; ++i) {
                const double level = (surface[j * nx + i] - 0.5) / 0.02;
                const int shade = level < -1 ? 0 : level > 1 ? 6 : static_cast<int>((level + 1) * 3 + 0.5);
                std::putchar(depth[j * nx + i] > 0 ? " .-~=*#"[shade] : '^');
            }
            std::putchar('\n');
        }
    }
    const auto account = pool.get_account();
    std::printf("%.4f m^3, %.4f at the start, %.4f in, %.4f out\n", pool.get_volume(), account.initial, account.in,
                account.out);
}
