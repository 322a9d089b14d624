// Random scenes give the same bits with all kernels, with any parallel hook, and for an object that goes on in the
// place of another, by a copy of its state or by save and load.
//
// By default a fixed number of scenes of a fixed seed. CONTDYN_RANDOM_SCENES=N runs N scenes of each kind of object,
// CONTDYN_RANDOM_SEED=S begins with scene S: with N = 1 it is that one alone, as a failure names it. Two threads share
// them, each of which has objects of its own: with -DCONTDYN_SANITIZE=thread that shows that objects share nothing.
extern "C" {
#include "cmocka_all.h"
#include "jobs.h"
}
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include <atomic>
#include <string>

#include "random_bodies.hpp"
#include "random_membranes.hpp"
#include "random_water.hpp"

namespace {

constexpr size_t kScenes = 250;

size_t from_environment(const char* name, size_t otherwise) {
    const char* const text = getenv(name);
    return text ? size_t(strtoull(text, nullptr, 10)) : otherwise;
}

// ---- what differs between objects ----------------------------------------------------------------------------------

#define FUNCTIONS(object)                                                                                       \
    cd_status step(cd_##object* o, double dt, size_t n) { return cd_##object##_step(o, dt, n); }                \
    cd_status set_kernels(cd_##object* o, cd_kernels k) { return cd_##object##_set_kernels(o, k); }             \
    cd_status set_parallel(cd_##object* o, const cd_parallel* p) { return cd_##object##_set_parallel(o, p); }   \
    cd_status copy_state(cd_##object* o, const cd_##object* from) { return cd_##object##_copy_state(o, from); } \
    cd_status save_size(const cd_##object* o, size_t* size) { return cd_##object##_save_size(o, size); }        \
    cd_status save(const cd_##object* o, std::vector<char>& bytes, size_t* written) {                           \
        return cd_##object##_save(o, bytes.data(), bytes.size(), written);                                      \
    }                                                                                                           \
    cd_status load(cd_##object* o, const std::vector<char>& bytes) {                                            \
        return cd_##object##_load(o, bytes.data(), bytes.size());                                               \
    }                                                                                                           \
    uint64_t hash_of(const cd_##object* o) {                                                                    \
        uint64_t hash = 0;                                                                                      \
        cd_##object##_hash(o, &hash);                                                                           \
        return hash;                                                                                            \
    }                                                                                                           \
    void destroy(cd_##object* o) { cd_##object##_destroy(o); }
FUNCTIONS(chain)
FUNCTIONS(membrane)
FUNCTIONS(water)

// ---- the variants of a scene ---------------------------------------------------------------------------------------

enum class Way { alone, backwards, threads, copied, loaded };

template <class Handle> struct Variant {
    Way way = Way::alone;
    cd_kernels kernels = CD_KERNELS_PLAIN;
    Handle* object = nullptr;
    struct jobs jobs = {};
    Returned returned;
    cd_status stepped = CD_OK;

    std::string text() const {
        static const char* const names[] = {"no hook", "tasks backwards", "tasks on two threads", "goes on in a copy",
                                            "goes on from saved bytes"};
        return std::string(cd_kernels_name(kernels)) + ", " + names[int(way)];
    }
};

// Every kernel set alone, and every other way with kernels by chance.
template <class Handle> std::vector<Variant<Handle>> variants_of(Random& random) {
    std::vector<Variant<Handle>> all;
    std::vector<cd_kernels> runnable;
    for (cd_kernels kernels = CD_KERNELS_PLAIN; cd_runnable_kernels() >> kernels; ++kernels)
        if (cd_runnable_kernels() >> kernels & 1) runnable.push_back(kernels);
    for (cd_kernels kernels : runnable) all.emplace_back(), all.back().kernels = kernels;
    for (Way way : {Way::backwards, Way::threads, Way::copied, Way::loaded}) {
        all.emplace_back();
        all.back().way = way, all.back().kernels = runnable[random.below(runnable.size())];
    }
    return all;
}

template <class Scene>
typename Scene::Handle* successor_of(const Scene& scene, const Variant<typename Scene::Handle>& v) {
    typename Scene::Handle* const next = scene.make();
    set_kernels(next, v.kernels);
    cd_status status = CD_OK;
    if (v.way == Way::copied) {
        status = copy_state(next, v.object);
    } else {
        size_t size = 0, written = 0;
        save_size(v.object, &size);
        std::vector<char> bytes(size);
        status = save(v.object, bytes, &written);
        if (status == CD_OK) status = load(next, bytes);
    }
    scene.set_callbacks(next);
    if (status != CD_OK) print_error("%s: %s\n", v.text().c_str(), cd_error_message());
    destroy(v.object);
    return next;
}

// ---- a scene -------------------------------------------------------------------------------------------------------

// Prints the first number in which the two differ.
template <class Scene, class Handle>
void print_difference(const Scene& scene, const Variant<Handle>& a, const Variant<Handle>& b) {
    print_error("    %s, and\n    %s:\n", a.text().c_str(), b.text().c_str());
    if (a.stepped != b.stepped)
        print_error("    the step gives %s and %s\n", cd_status_name(a.stepped), cd_status_name(b.stepped));
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        std::vector<double> x, y;
        if (scene.read(a.object, field, x) != CD_OK || scene.read(b.object, field, y) != CD_OK) continue;
        for (size_t i = 0; i < x.size(); ++i)
            if (memcmp(&x[i], &y[i], sizeof x[i]) != 0) {
                const Size size = scene.size_of(a.object, field);
                print_error("    field %d, row or strand %zu, number %zu, component %zu: %.17g and %.17g\n", int(field),
                            i / (size.columns * size.components), i / size.components % size.columns,
                            i % size.components, x[i], y[i]);
                return;
            }
    }
    print_error("    no field differs, but %s does\n",
                hash_of(a.object) == hash_of(b.object) ? "something that calls returned" : "the hash");
}

template <class Scene> bool is_the_same_in_all_variants(uint64_t seed) {
    using Handle = typename Scene::Handle;
    Random random(seed, 0);
    const Scene scene(random);
    const size_t rounds = random.from_to(3, 10), handover = random.below(rounds);
    const size_t busy = size_t(random.any_of({1, 3, 8})); // fewer changes than that at once
    const bool small = scene.numbers() < 100;
    std::vector<Variant<Handle>> variants = variants_of<Handle>(random);
    const cd_parallel backwards = jobs_reversed(&variants[0].jobs), threads = jobs_threads(&variants[0].jobs);
    for (Variant<Handle>& v : variants) {
        v.object = scene.make();
        set_kernels(v.object, v.kernels);
        Random same(seed, 1);
        scene.begin(v.object, same, busy, v.returned);
    }
    bool same = true;
    for (size_t round = 0; round < rounds && same; ++round) {
        const bool with_threads = random.chance(0.3); // they are slow to begin
        for (Variant<Handle>& v : variants) {
            if (v.way == Way::backwards) set_parallel(v.object, &backwards);
            if (v.way == Way::threads) set_parallel(v.object, with_threads ? &threads : nullptr);
            if (round == handover && (v.way == Way::copied || v.way == Way::loaded)) v.object = successor_of(scene, v);
            Random again(seed, 2 + round);
            for (size_t k = again.below(busy); k > 0; --k) scene.act(v.object, again, v.returned);
            const double dt = scene.pick_dt(v.object, again, v.returned);
            v.stepped = step(v.object, dt, again.from_to(1, small ? 12 : 4));
            if (v.stepped == CD_OK || v.stepped == CD_ERROR_TOLERANCE) scene.measure(v.object, v.returned);
        }
        const Variant<Handle>& first = variants[0];
        for (const Variant<Handle>& v : variants) {
            const bool diverged = first.stepped == CD_ERROR_DIVERGED && v.stepped == CD_ERROR_DIVERGED;
            if (v.stepped == first.stepped && v.returned.hash == first.returned.hash &&
                (diverged || hash_of(v.object) == hash_of(first.object)))
                continue;
            print_error("%s scene %llu, after round %zu of %zu:\n", Scene::name, static_cast<unsigned long long>(seed),
                        round, rounds);
            print_difference(scene, first, v);
            same = false;
            break;
        }
        if (first.stepped == CD_ERROR_DIVERGED) break;
    }
    for (Variant<Handle>& v : variants) destroy(v.object);
    return same;
}

struct Scenes {
    size_t first, count;
    std::atomic<size_t> next{0}, different{0};
};

template <class Scene> void* play(void* argument) {
    Scenes& scenes = *static_cast<Scenes*>(argument);
    for (size_t k; scenes.different < 5 && (k = scenes.next++) < scenes.count;)
        scenes.different += !is_the_same_in_all_variants<Scene>(scenes.first + k);
    return nullptr;
}

template <class Scene> void all_variants_of_a_scene_give_the_same_bits(void**) {
    Scenes scenes{from_environment("CONTDYN_RANDOM_SEED", 1), from_environment("CONTDYN_RANDOM_SCENES", kScenes)};
    pthread_t other;
    assert_int_equal(pthread_create(&other, nullptr, play<Scene>, &scenes), 0);
    play<Scene>(&scenes);
    assert_int_equal(pthread_join(other, nullptr), 0);
    assert_int_equal(scenes.different.load(), 0);
}

} // namespace

int main() {
    const struct CMUnitTest tests[] = {
        {"random chains", all_variants_of_a_scene_give_the_same_bits<ChainScene>, nullptr, nullptr, nullptr},
        {"random membranes", all_variants_of_a_scene_give_the_same_bits<MembraneScene>, nullptr, nullptr, nullptr},
        {"random waters", all_variants_of_a_scene_give_the_same_bits<WaterScene>, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
