#include "object.hpp"

#include <stdio.h>
#include <stdlib.h>

#include "random.hpp"

namespace fuzz {

template <class Api> void Object<Api>::act() {
    const size_t percent = below(100);
    if (percent < 28) step();
    else if (percent < 44) this->write_by_chance();
    else if (percent < 47) this->read_by_chance();
    else if (percent < 48) this->view_by_chance();
    else if (percent < 52) this->enable_by_chance();
    else if (percent < 54) this->disable_by_chance();
    else if (percent < 57) this->set_enum("set_method", Api::set_method, chance(0.5) ? CD_METHOD_IMPLICIT : 3);
    else if (percent < 59) set_lambda();
    else if (percent < 60) this->set_number("set_drag", Api::set_drag, pick_number(-3, 2), {0, 1e3});
    else if (percent < 62) set_parallel();
    else if (percent < 63) this->set_enum("set_kernels", Api::set_kernels, 2, kNoMemory | kNoTwin);
    else if (percent < 66) this->remake_twin();
    else if (percent < 68) this->load_damaged();
    else if (percent < 69) reset();
    else if (percent < 70) this->keep();
    else if (percent < 71) this->go_back();
    else if (percent < 74) get_something();
    else if (percent < 75) this->save_into_too_little();
    else act_by_kind();
}

template <class Api> void Object<Api>::set_lambda() {
    static const double usual[] = {0.5, 0.5, 0.5, 0.55, 0.75, 1, 0.25, 0};
    const double lambda = chance(run.bad) ? wild_number() : usual[below(8)];
    this->set_number("set_lambda", Api::set_lambda, lambda, {0, 1});
}

template <class Api> void Object<Api>::set_parallel() {
    // Threads are dear: few objects get them.
    const Order order = chance(0.03) ? Order::threads : Order(below(3));
    const bool null = order == Order::none, without_run = chance(0.03);
    const cd_status status = this->both(text("set_parallel, order %d", int(order)), kNoTwin, [&](Handle* handle, int) {
        this->hook.order = order;
        cd_parallel table = this->hook.table();
        if (without_run) table.run = nullptr;
        return Api::set_parallel(handle, null ? nullptr : &table);
    });
    if (!run.broken && !null && without_run && status != CD_ERROR_NULL && status != CD_ERROR_MEMORY)
        problem("set_parallel without run: %s", cd_status_name(status));
}

template <class Api> void Object<Api>::get_something() {
    switch (below(10)) {
    case 0: this->get("get_method", Api::get_method); break;
    case 1: this->get("get_lambda", Api::get_lambda); break;
    case 2: this->get("get_drag", Api::get_drag); break;
    case 3: this->get("stable_dt", Api::stable_dt); break;
    case 4: this->get("get_time", Api::get_time); break;
    case 5: this->get("get_steps", Api::get_steps); break;
    case 6: this->get("get_factorizations", Api::get_factorizations, false); break;
    case 7: this->get("get_kernels", Api::get_kernels, false); break;
    case 8: this->get("get_memory", Api::get_memory, false); break;
    default: this->get("save_size", Api::save_size);
    }
}

template <class Api> void Object<Api>::reset() {
    double time = 0;
    Api::get_time(this->first(), &time);
    if (time > 1e6) this->past.moderate = false; // what changes by a rate at a side begins as far back
    const cd_status status = this->both("reset", kNoMemory, [&](Handle* handle, int) { return Api::reset(handle); });
    if (run.broken) return;
    if (status != CD_OK) problem("reset: %s", cd_error_message());
    this->past.diverged = false;
    if (!is_finite()) problem("not finite after reset");
}

// ---- steps ---------------------------------------------------------------------------------------------------------

static double pick_dt() {
    if (chance(run.bad)) return wild_number();
    if (run.sane) return decades(-5, chance(0.2) ? 5 : 1);
    return chance(0.3) ? decades(-30, 30) : decades(-6, 3);
}

static void dump(const Bytes& bytes, const char* path) {
    FILE* const file = fopen(path, "wb");
    if (!file) return;
    fwrite(bytes.data(), 1, bytes.size(), file);
    fclose(file);
}

template <class Api> void Object<Api>::step() {
    Step s = {};
    s.dt = pick_dt();
    s.count = chance(0.03) ? 0 : chance(0.4) ? 1 : 1 + below(chance(0.2) ? 20 : 4);
    s.size_before = state_size();
    Api::stable_dt(this->first(), &s.stable_dt_before);
    Api::get_steps(this->first(), &s.steps_before);
    s.hash_before = this->hash();
    before_step(s.dt);
    if (run.tracing && getenv("FUZZ_DUMP")) dump(this->saved(), getenv("FUZZ_DUMP"));
    s.status = this->both(text("step %.17g, %zu", s.dt, s.count), kSteps | kNoMemory,
                          [&](Handle* handle, int) { return Api::step(handle, s.dt, s.count); });
    if (run.broken) return;
    if (s.dt == 0) s.count = 0; // a pause
    check_step(s);
    after_step(s);
    this->check_state();
}

template <class Api> void Object<Api>::check_step(const Step& s) {
    const char* const name = cd_status_name(s.status);
    const bool diverged = s.status == CD_ERROR_DIVERGED;
    if (s.status != CD_OK && s.status != CD_ERROR_TOLERANCE && s.status != CD_ERROR_CALLBACK && !diverged) return;
    totals->steps += s.count;
    totals->diverged += diverged;
    totals->short_of_tolerance += s.status == CD_ERROR_TOLERANCE;
    uint64_t steps = 0;
    Api::get_steps(this->first(), &steps);
    const bool began_finite = s.size_before < INFINITY, finite = is_finite();
    if (began_finite && steps != s.steps_before + s.count) // from a state that is not finite none are made
        problem("%zu steps from step %llu on end at %llu, %s", s.count, static_cast<unsigned long long>(s.steps_before),
                static_cast<unsigned long long>(steps), name);
    if (s.count == 0 && this->hash() != s.hash_before) problem("no steps, but another hash");
    if (!finite && !diverged && s.count > 0) problem("a step ends not finite, but with %s", name);
    this->past.diverged = !finite;
    if (!diverged || !began_finite || !this->past.moderate || this->past.crafted) return;
    // A wild number may be lost within the step again, as where a pinned node takes it up; a moderate one may not.
    if (finite && s.dt < 1e6) problem("CD_ERROR_DIVERGED, but all is finite");
    // In so short a time no method has blown up what was moderate.
    if (run.sane && s.size_before < 1e6 && s.dt * double(s.count) <= fmin(s.stable_dt_before, 1e10) && !is_driven())
        problem("diverged in %zu steps of %g, where a stable one is %g", s.count, s.dt, s.stable_dt_before);
}

// ---- misuse --------------------------------------------------------------------------------------------------------

template <class Api> void Object<Api>::misuse(void* other) {
    Handle* const bad = static_cast<Handle*>(other);
    const uint64_t before = this->hash();
    double number = 7;
    uint64_t hash = 7;
    size_t size = 7;
    const cd_status wanted = other ? CD_ERROR_HANDLE : CD_ERROR_NULL;
    cd_status status = wanted;
    switch (below(10)) {
    case 0: status = Api::step(bad, 0.1, 1); break;
    case 1: status = Api::hash(bad, &hash); break;
    case 2: status = Api::save_size(bad, &size); break;
    case 3: status = Api::stable_dt(bad, &number); break;
    case 4: status = Api::copy_state(this->first(), bad); break;
    case 5: status = Api::copy_state(bad, this->first()); break;
    case 6: status = Api::set_lambda(bad, 0.5); break;
    case 7: status = Api::enable_field(bad, CD_FORCE); break;
    case 8: status = Api::load(bad, "x", 1); break;
    default: Api::destroy(bad);
    }
    ++totals->calls;
    if (status != wanted)
        problem("%s, called with %s: %s", Api::name, other ? "another kind" : "null", cd_status_name(status));
    if (number != 7 || hash != 7 || size != 7) problem("%s: a bad handle, and yet an output is written", Api::name);
    Api::hash(this->first(), &hash);
    if (hash != before) problem("%s: a bad handle changed another object", Api::name);
}

template <class Api> bool Object<Api>::take(AnyObject& other) {
    Object* const same_kind = dynamic_cast<Object*>(&other);
    if (same_kind) this->take_another(*same_kind, chance(0.5));
    return same_kind != nullptr;
}

template class Object<ChainApi>;
template class Object<MembraneApi>;
template class Object<WaterApi>;

} // namespace fuzz
