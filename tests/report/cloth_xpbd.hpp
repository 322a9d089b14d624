// Position-based dynamics with compliance (XPBD) of a square sheet, the usual solver of games, to compare cloth with:
// float32, one spring after the other, in an order in which a whole row of them is independent and fills vectors.
#ifndef REPORT_CLOTH_XPBD_HPP
#define REPORT_CLOTH_XPBD_HPP

#include <cstddef>
#include <vector>

namespace report {

// What the library and position-based dynamics both simulate: side x side nodes on a square of 1 m, which lies level
// and is held by the two corners of its row v = 0.
struct ClothScene {
    std::size_t side;
    double mass = 0.2, stiffness = 3000, shear = 100, gravity = 9.81; // stiffness: of one spring
    double length() const { return 1 / double(side - 1); }            // of a spring
};

// A row's nodes with even u lie side by side, then those with odd u, so that the springs along u between an even node
// and the odd one behind it are one loop over neighbours in memory, those between an odd and an even node another, and
// the springs to the next row four or five. Springs only pull.
class XpbdCloth {
public:
    XpbdCloth(const ClothScene& scene, int substeps, int iterations);
    void reset();
    void frame(double dt);
    double at(std::size_t u, std::size_t v, std::size_t component) const { return position_[component][node(u, v)]; }

    // A row of springs: between the nodes `first` and those `second` behind it, and what they have pulled by so far.
    struct Row {
        std::size_t first, second, multiplier;
        float length, stiffness;
        const float* there; // 1 for a spring, 0 where the row has ended
    };

private:
    std::size_t node(std::size_t u, std::size_t v) const { return v * 2 * pitch_ + (u % 2) * pitch_ + u / 2; }

    ClothScene scene_;
    int substeps_, iterations_;
    std::size_t pitch_, lanes_; // numbers in half a row, and how many of them are computed
    std::vector<float> position_[3], before_[3], velocity_[3], inverse_mass_, free_, multipliers_;
    std::vector<float> all_, short_even_, short_odd_;
    std::vector<Row> rows_;
};

} // namespace report

#endif
