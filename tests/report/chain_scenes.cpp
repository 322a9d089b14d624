// Pictures: a rope let go from the horizontal, and a tuft of hair in a gust.
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "plot.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60, kGravity = 9.81;

Polyline strand_line(const std::vector<double>& xy, std::size_t strand, std::size_t nodes) {
    Polyline line;
    for (std::size_t i = 0; i < nodes; ++i) {
        line.x.push_back(xy[2 * (strand * nodes + i)]);
        line.y.push_back(xy[2 * (strand * nodes + i) + 1]);
    }
    return line;
}

double total_energy(const Chain& chain) {
    double kinetic = 0, elastic = 0, gravity = 0;
    check(cd_chain_get_energy(chain.get(), &kinetic, &elastic, &gravity));
    return kinetic + elastic + gravity;
}

void swinging_rope(Report& report) {
    const std::size_t springs = 200, strokes = 15, steps_between = 12;
    const double dt = 1.0 / 240;
    Chain chain(springs, 2, precisions().front());
    check(cd_chain_set_stiffness(chain.get(), 0.5 * kGravity));
    check(cd_chain_set_end(chain.get(), CD_END_FIRST, CD_NODE_PINNED));
    const double gravity[] = {0, -kGravity};
    check(cd_chain_set_gravity(chain.get(), gravity, 2));
    std::vector<double> start;
    for (std::size_t i = 0; i <= springs; ++i) start.insert(start.end(), {double(i) / double(springs), 0});
    chain.write(CD_POSITION, start);

    Picture picture{"", -1.15, -2.12, 1.3, 0.12, {}, {}, {}};
    Csv csv("time_s,node,x_m,y_m");
    const double energy = total_energy(chain);
    double drift = 0;
    for (std::size_t s = 0; s <= strokes; ++s) {
        const std::vector<double> xy = chain.read(CD_POSITION);
        Polyline line = strand_line(xy, 0, springs + 1);
        const double age = double(s) / double(strokes), time = double(s * steps_between) * dt;
        line.colour = 1;
        line.opacity = 0.15 + 0.85 * age * age;
        line.width = 1.4 + 1.6 * age;
        picture.lines.push_back(line);
        picture.dots.push_back({line.x.back(), line.y.back(), 2 + 2.5 * age, 2});
        for (std::size_t i = 0; i <= springs; i += 4) csv.row(time, i, xy[2 * i], xy[2 * i + 1]);
        if (s % 5 == 0)
            picture.labels.push_back({line.x.back() + 0.05, line.y.back() - 0.01, si(time, "s", 2), 0, "start"});
        if (s < strokes) check(cd_chain_step(chain.get(), dt, steps_between));
        drift = std::fmax(drift, std::fabs(total_energy(chain) - energy));
    }
    picture.dots.push_back({0, 0, 4, 0});
    report.outcome("chain.scene.rope", hex(chain.hash()));
    report.summary("chain.scene.rope.energy_drift", drift / kGravity, "of m g L");
    const std::string rope = report.page.show(render(picture), "A rope that was let go from the horizontal");
    report.page.figure({rope}, "",
                       "A rope held at one end swings down from the horizontal and keeps its energy to " +
                       number(drift / kGravity, 2) + " of m g L. One stroke every " +
                       si(double(steps_between) * dt, "s", 2) + ", the older the fainter; " + std::to_string(springs) +
                       " springs, λ = 1/2, 240 steps a second. Rest length is zero in the notes' chain, so it is "
                       "a soft rope: at rest it would hang as long as it was held, and in the swing it reaches twice "
                       "that depth.");
    report.save("scene_rope.csv", csv);
}

// Many strands with bend and without stretch, rooted in position and direction.
struct Tuft {
    static constexpr std::size_t kStrands = 150, kSprings = 30;
    static constexpr double kBend = 3.4, kRadius = 0.16;
    Chain chain{kSprings, 2, precisions().back(), kStrands};

    static double angle(std::size_t strand) {  // of the root, from the vertical
        return 1.3 * (2 * (double(strand) + 0.5) / double(kStrands) - 1) + 0.06 * std::sin(double(strand) * 5.1);
    }
    static double length(std::size_t strand) { return 1 + 0.13 * std::sin(double(strand) * 2.4); }

    Tuft() {
        check(cd_chain_set_stiffness(chain.get(), 0));
        check(cd_chain_set_bend(chain.get(), kBend));
        check(cd_chain_set_drag(chain.get(), 2));
        std::vector<double> pins(kSprings + 1, CD_NODE_FREE), start;
        pins[0] = pins[1] = CD_NODE_PINNED;
        chain.write(CD_PIN, pins);
        for (std::size_t s = 0; s < kStrands; ++s)
            for (std::size_t i = 0; i <= kSprings; ++i) {
                double r = kRadius + length(s) * double(i) / double(kSprings);
                start.insert(start.end(), {r * std::sin(angle(s)), r * std::cos(angle(s))});
            }
        chain.write(CD_POSITION, start);
        const double gravity[] = {0, -kGravity};
        check(cd_chain_set_gravity(chain.get(), gravity, 2));
        check(cd_chain_enable_field(chain.get(), CD_FORCE));
    }

    // Wind from the left that grows with height and comes in gusts along the tuft.
    void blow(double strength) {
        std::vector<double> force, xy = chain.read(CD_POSITION);
        for (std::size_t k = 0; k < kStrands * (kSprings + 1); ++k) {
            double height = std::fmax(0.0, xy[2 * k + 1]), gust = 1 + 0.35 * std::sin(4 * xy[2 * k]);
            force.insert(force.end(), {strength * height * gust / double(kSprings + 1), 0});
        }
        chain.write(CD_FORCE, force);
    }

    std::string draw(const std::string& title) const {
        Picture picture{title, -1.25, -0.22, 1.55, 1.12, {}, {}, {}};
        const std::vector<double> xy = chain.read(CD_POSITION);
        for (std::size_t s = 0; s < kStrands; ++s) {
            Polyline line = strand_line(xy, (s * 61) % kStrands, kSprings + 1);
            line.colour = s / 5 % 4 == 0 ? 2 : s / 5 % 4 == 1 ? 0 : 5;
            line.opacity = 0.8;
            line.width = 1.1;
            picture.lines.push_back(line);
        }
        return render(picture);
    }
};

void hair_in_a_gust(Report& report) {
    Tuft tuft;
    check(cd_chain_set_lambda(tuft.chain.get(), 1));
    check(cd_chain_step(tuft.chain.get(), 1e4, 1));
    std::vector<double> speeds = tuft.chain.read(CD_VELOCITY);
    double fastest = 0;
    for (double v : speeds) fastest = std::fmax(fastest, std::fabs(v));
    std::string rest = tuft.draw("at rest, after one step of 10 000 s");
    check(cd_chain_set_lambda(tuft.chain.get(), 0.5));
    for (int frame = 0; frame < 30; ++frame) {
        tuft.blow(24 * std::sin(M_PI * double(frame) / 60));
        check(cd_chain_step(tuft.chain.get(), kFrame, 1));
    }
    report.outcome("chain.scene.hair", hex(tuft.chain.hash()));
    report.page.figure(
        {rest, report.page.show(tuft.draw("half a second into a gust from the left"), "Hair in a gust")}, "",
        std::to_string(Tuft::kStrands) + " strands with bend hang together in one handle and share one factorization. "
        "Each is rooted in position and direction. A single backward Euler step of 10 000 s finds how they hang "
        "(greatest speed left: " + number(fastest, 1) + " m/s); the gust is a force on every node, written anew each "
        "frame.");
}

}  // namespace

void report_chain_scenes(Report& report) {
    report.page.section("chain-scenes", "Chains: pictures");
    swinging_rope(report);
    hair_in_a_gust(report);
}

}  // namespace report
