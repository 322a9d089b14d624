#include "body.hpp"

#include <math.h>

#include "random.hpp"

namespace fuzz {

// ---- energy --------------------------------------------------------------------------------------------------------

// By how much rounding may change the energy in a step: it rounds a state of this size, takes the smallest
// numbers for 0, and moves nodes by some 1e-15 of v dt, in a ring or with bend of what they fall, too: see base.h.
template <class Api> double Body<Api>::room_for_energy(double dt) const {
    const bool wide = this->precision == CD_FLOAT64;
    const double rounding = wide ? 1e-10 : 1e-5, smallest = wide ? 0x1p-500 : 0x1p-80;
    const double x = this->largest_of({CD_POSITION, CD_TARGET}), v = this->largest_of({CD_VELOCITY});
    const double k = stiffest(), m = heaviest(), g = gravity();
    const double by_rounding = rounding * (8 * k * x * x + m * v * v + m * g * x);
    const double by_clearing = smallest * (8 * k * x + m * v + m * g + smallest * (k + m));
    const double astray = 1e-15 * (v * dt + (falls_astray() ? g * dt * dt : 0));
    const double by_going_astray = (8 * k * (x + astray) + m * g) * astray;
    return 4 * double(nodes * components) * (by_rounding + by_clearing + by_going_astray);
}

template <class Api> void Body<Api>::before_step(double dt) {
    if (has_lengths()) set_callbacks_again();
    energy_before = energy();
    room_before = room_for_energy(dt);
}

template <class Api> void Body<Api>::after_step(const Step& s) {
    const Past& past = this->past;
    if (!run.sane || !past.moderate || past.crafted || !isfinite(energy_before) || this->is_driven()) return;
    if (s.size_before == HUGE_VAL) return; // no steps are made from what is not finite, if only of a held node
    cd_method method = CD_METHOD_IMPLICIT;
    double lambda = 0;
    Api::get_method(this->first(), &method);
    Api::get_lambda(this->first(), &lambda);
    const bool implicit = method == CD_METHOD_IMPLICIT && lambda >= 0.5;
    if (!implicit && method != CD_METHOD_STIFF_SECOND) return;
    // In such a time nothing that falls leaves the range of float32.
    const bool stays_near = energy_before < 1e10 && s.dt * double(s.count) < 1e10;
    if (s.status == CD_ERROR_DIVERGED && stays_near)
        return problem("%s: diverged, lambda %g, method %d, dt %g", Api::name, lambda, int(method), s.dt);
    if (s.status != CD_OK && s.status != CD_ERROR_TOLERANCE) return;
    if (!implicit || !keeps_its_energy()) return;
    if (s.count != 1) return; // between steps it may have been larger, and so is rounding
    const double after = energy(), room = fmax(room_before, room_for_energy(s.dt)) + room_of_kind() + 1e-30;
    if (after > energy_before + room)
        problem("%s: energy from %.17g to %.17g, where rounding explains %g; lambda %g, dt %g", Api::name,
                energy_before, after, room, lambda, s.dt);
}

// ---- calls that both have ------------------------------------------------------------------------------------------

template <class Api> void Body<Api>::set_gravity(cd_status (*setter)(Handle*, const double*, size_t)) {
    double gravity[4];
    bool moderate = true;
    for (double& g : gravity) {
        g = chance(0.3) ? 0 : chance(0.5) ? -9.81 : pick_number(-1, 1);
        moderate &= fabs(g) < 1e3;
    }
    const size_t count = pick_count(components);
    const bool null = pick_null();
    const cd_status status =
        this->both(text("set_gravity %.17g %.17g %.17g %.17g, count %zu%s", gravity[0], gravity[1], gravity[2],
                        gravity[3], count, null ? ", null" : ""),
                   kNoMemory, [&](Handle* handle, int) { return setter(handle, null ? nullptr : gravity, count); });
    if (status == CD_OK && !moderate) this->past.moderate = false;
}

template <class Api> void Body<Api>::get_gravity(cd_status (*getter)(const Handle*, double*, size_t)) {
    double gravity[2][4] = {};
    const size_t count = pick_count(components);
    this->both("get_gravity", kReads, [&](Handle* handle, int which) { return getter(handle, gravity[which], count); });
    this->must_agree("get_gravity", gravity[0], gravity[1], 4);
}

template <class Api> size_t Body<Api>::awake_nodes(cd_status (*getter)(const Handle*, size_t*)) const {
    size_t awake = 0;
    getter(this->first(), &awake);
    return awake;
}

template <class Api> void Body<Api>::set_sleep(cd_status (*setter)(Handle*, double, double)) {
    const double speed = chance(0.2) ? 0 : pick_number(-6, 2), seconds = pick_number(-3, 1);
    this->both(text("set_sleep %.17g %.17g", speed, seconds), 0,
               [&](Handle* handle, int) { return setter(handle, speed, seconds); });
}

template <class Api> void Body<Api>::get_sleep(cd_status (*getter)(const Handle*, double*, double*)) {
    double pair[2][2] = {};
    this->both("get_sleep", kReads,
               [&](Handle* handle, int which) { return getter(handle, &pair[which][0], &pair[which][1]); });
    this->must_agree("get_sleep", pair[0], pair[1], 2);
}

template <class Api> void Body<Api>::get_energy(cd_status (*getter)(const Handle*, double*, double*, double*)) {
    double energies[2][3] = {};
    const bool only_one = chance(0.1);
    this->both("get_energy", kReads, [&](Handle* handle, int which) {
        double* const out = energies[which];
        return getter(handle, &out[0], only_one ? nullptr : &out[1], only_one ? nullptr : &out[2]);
    });
    this->must_agree("get_energy", energies[0], energies[1], 3);
}

template <class Api> void Body<Api>::get_momentum(cd_status (*getter)(const Handle*, double*, size_t)) {
    double momentum[2][4] = {};
    const size_t count = pick_count(components);
    this->both("get_momentum", kReads,
               [&](Handle* handle, int which) { return getter(handle, momentum[which], count); });
    this->must_agree("get_momentum", momentum[0], momentum[1], 4);
}

template <class Api> typename Body<Api>::Tie Body<Api>::pick_tie() const {
    Tie tie;
    tie.stiffness = pick_number(-1, 4);
    tie.damping = chance(0.5) ? 0 : pick_number(-2, 2);
    for (double& x : tie.target) x = !run.sane && chance(0.05) ? wild_number() : uniform(-1, 1);
    tie.null = chance(0.4);
    tie.count = pick_count(components);
    return tie;
}

template <class Api> void Body<Api>::has_tied(const Tie& tie, cd_status status) {
    bool moderate = tie.stiffness < 1e5 && tie.damping < 1e3;
    for (double x : tie.target) moderate &= fabs(x) < 1e3;
    if (tie.null) moderate &= this->largest_of({CD_POSITION}) < 1e3; // the target is where the node is
    if (status == CD_OK && !moderate) this->past.moderate = false;
}

template <class Api> typename Body<Api>::Impulse Body<Api>::pick_impulse() const {
    Impulse impulse;
    for (double& x : impulse.size) x = run.sane ? uniform(-1, 1) : chance(0.1) ? wild_number() : uniform(-1e3, 1e3);
    impulse.count = pick_count(components);
    return impulse;
}

template <class Api> typename Body<Api>::Move Body<Api>::pick_move() const {
    Move move = {};
    for (double& x : move.offset) x = chance(run.bad) ? wild_number() : chance(0.5) ? 0 : uniform(-1, 1);
    move.moderate = true;
    for (double x : move.offset) move.moderate &= fabs(x) <= 1;
    const size_t n = components, a = below(n), b = (a + 1) % n;
    const double c = cos(uniform(-4, 4)), s = sqrt(1 - c * c);
    for (size_t i = 0; i < n; ++i) move.rotation[i * n + i] = 1;
    if (a != b) {
        move.rotation[a * n + a] = move.rotation[b * n + b] = c;
        move.rotation[a * n + b] = -s, move.rotation[b * n + a] = s;
    }
    if (chance(run.bad)) move.rotation[below(n * n)] += wild_number();
    move.turns = chance(0.7);
    move.count = pick_count(n);
    return move;
}

template class Body<ChainApi>;
template class Body<MembraneApi>;

} // namespace fuzz
