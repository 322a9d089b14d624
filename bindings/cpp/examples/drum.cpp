// A round drum, hit off its centre: its skin seen from above, three times.
#include <contdyn/contdyn.hpp>

#include <cstdio>
#include <vector>

using contdyn::field;

int main() {
    const std::size_t n = 48, across = n + 1;
    contdyn::membrane drum(n, n, 1);
    drum.set_mass(0.1);           // kg
    drum.set_stiffness(200, 200); // N/m
    drum.set_drag(4);             // 1/s

    std::vector<double> pin;
    for (std::size_t v = 0; v <= n; ++v) {
        for (std::size_t u = 0; u <= n; ++u) {
            const double x = static_cast<double>(u) - n / 2.0, y = static_cast<double>(v) - n / 2.0;
            pin.push_back(x * x + y * y < n * n / 4.0 ? 0 : 1); // held outside the rim
        }
    }
    drum.enable_field(field::pin);
    drum.write_f64(field::pin, pin);
    drum.impulse(18, 20, 6, {0.05}); // N s

    for (int picture = 0; picture < 3; ++picture) {
        drum.step(1 / 2000.0, picture == 0 ? 10 : 20);
        const std::vector<double> height = drum.read_f64(field::position);
        std::printf("%.3f s\n", drum.get_time());
        for (std::size_t v = 0; v <= n; v += 2) {
            for (std::size_t u = 0; u <= n; ++u) {
                const std::size_t i = v * across + u;
                const double level = height[i] / 0.02;
                const int shade = level < -1 ? 0 : level > 1 ? 8 : static_cast<int>((level + 1) * 4 + 0.5);
                std::putchar(pin[i] != 0 ? ' ' : "@%#*+=-:."[8 - shade]);
            }
            std::putchar('\n');
        }
    }
}
