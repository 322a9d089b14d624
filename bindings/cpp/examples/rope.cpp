// A rope swings down: seven moments, 0 to 6.
#include <contdyn/contdyn.hpp>

#include <cstdio>
#include <string>
#include <vector>

int main() {
    const std::size_t springs = 120;
    contdyn::chain rope(1, springs, 2);
    std::vector<double> x;
    for (std::size_t i = 0; i <= springs; ++i)
        x.insert(x.end(), {static_cast<double>(i) / springs, 0.0}); // 1 m, straight
    rope.write_f64(contdyn::field::position, x);
    rope.set_mass(0.2);    // kg
    rope.set_stiffness(1); // N/m: hanging, its weight stretches it to m g / 2 k = 0.98 m
    rope.set_gravity({0, -9.81});
    rope.set_drag(0.3);
    rope.set_end(contdyn::end::first, contdyn::node::pinned);

    const int width = 64, height = 22;
    std::vector<std::string> page(height, std::string(width, ' '));
    for (int moment = 0; moment < 7; ++moment) {
        const contdyn::chain::field_view at = rope.view(contdyn::field::position); // not copied
        for (std::size_t i = 0; i <= springs; ++i) {
            const int column = static_cast<int>((at(0, i, 0) + 1.05) * width / 2.1);
            const int row = static_cast<int>(-at(0, i, 1) * height / 1.4);
            if (row >= 0 && row < height && column >= 0 && column < width)
                page[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = static_cast<char>('0' + moment);
        }
        rope.step(1 / 240.0, 42);
    }
    for (const std::string& line : page) std::printf("%s\n", line.c_str());
    const auto energy = rope.get_energy();
    std::printf("after %.2f s: kinetic %.3f J, elastic %.3f J\n", rope.get_time(), energy.kinetic, energy.elastic);
}
