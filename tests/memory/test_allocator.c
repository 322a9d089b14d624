/* Memory from the caller: every allocation of every call that may allocate, refused in turn, once and for good; how
 * much is held; and what never allocates. Of each kind of object the same. */
#include <string.h>

#include "heap.h"
#include "jobs.h"
#include "subjects.h"

/* Where a test is: what a failure tells. */
static struct {
    const char *kind, *scene, *call;
    size_t request;
} at;

static void must_hold(bool holds, const char* what, int line) {
    if (holds) return;
    print_error("%s, scene %s, %s, request %zu: not so: %s\n    the last message is: %s\n", at.kind, at.scene, at.call,
                at.request, what, cd_error_message());
    _fail(__FILE__, line);
}
#define must(condition) must_hold((condition), #condition, __LINE__)

/* An object with much switched on, and another, for calls to copy or load. */
static struct source {
    any* object;
    unsigned char bytes[1 << 16];
    size_t size;
} sources[KINDS][2];

static bool is_of(const struct subject* s, cd_kind kind) { return s->kind->number == kind; }

static bool has_lengths(const struct subject* s, size_t scene) { return scene - s->lengths < s->have_lengths; }

static bool is_always_on(const struct subject* s, cd_field field) {
    return field <= CD_VELOCITY || (field >= CD_DEPTH && field <= CD_VELOCITY_Y) || field == CD_TENSION ||
           field == CD_STRAIN || (field >= CD_TENSION_U && field <= CD_STRAIN_V) ||
           (field == CD_PIN && is_of(s, CD_KIND_CHAIN));
}

static void build(const struct subject* s, any* object, size_t scene) {
    at.kind = s->kind->name, at.call = "none", at.request = 0;
    at.scene = s->build(object, scene);
    if (scene == s->scenes - 1) ok(s->kind->set_method(object, CD_METHOD_FORWARD_EULER));
}

static any* create(const struct subject* s, struct heap* heap, size_t first, size_t second, size_t components,
                   cd_precision precision) {
    cd_allocator allocator;
    if (heap) allocator = heap_allocator(heap);
    any* object = NULL;
    ok(s->kind->create(first, second, components, precision, heap ? &allocator : NULL, &object));
    return object;
}

static any* begin(const struct subject* s, struct heap* heap, size_t scene) {
    any* object = create(s, heap, s->first, s->second, COMPONENTS, CD_FLOAT64);
    build(s, object, scene);
    ok(s->kind->step(object, s->dt, 2));
    return object;
}

static void end(const struct subject* s, any* object, struct heap* heap) {
    s->kind->destroy(object);
    must(heap->live_bytes == 0 && heap->mistakes == 0);
    heap_free(heap);
}

/* Makes a call that every kind has, or one of the kind's own. */
static struct made make_any(const struct subject* s, any* o, size_t number) {
    static struct jobs jobs;
    const cd_parallel reversed = jobs_reversed(&jobs);
    const struct kind* kind = s->kind;
    size_t i = 0;
    for (cd_method m = CD_METHOD_IMPLICIT; m <= CD_METHOD_STIFF_SECOND; ++m)
        NAMED(text_of("set_method %d", (int)m), false, kind->set_method(o, m));
    CALL(kind->set_parallel(o, &reversed));
    CALL(kind->set_parallel(o, NULL));
    CALL(kind->set_kernels(o, CD_KERNELS_PLAIN));
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        if (!s->has_field(field, true)) continue;
        NAMED(text_of("enable_field %d", (int)field), is_always_on(s, field), kind->enable_field(o, field));
        NAMED(text_of("disable_field %d", (int)field), is_always_on(s, field), kind->disable_field(o, field));
    }
    for (size_t k = 0; k < 2; ++k) {
        const struct source* of = &sources[s - subjects][k];
        NAMED(text_of("load %zu", k), false, kind->load(o, of->bytes, of->size));
        NAMED(text_of("copy_state %zu", k), false, kind->copy_state(o, of->object));
    }
    NEVER(kind->step(o, s->dt, 3));
    NEVER(kind->reset(o));
    return s->call(o, number - i);
}

static struct made make(const struct subject* s, any* object, size_t number) {
    const struct made made = make_any(s, object, number);
    at.call = made.text ? made.text : "none";
    return made;
}

static void go_on(const struct subject* s, any* object, double dt, size_t steps) {
    const cd_status status = s->kind->step(object, dt, steps);
    must(status == CD_OK || s->may_not_step(object, status));
}

static void accounts_for(const struct subject* s, const any* object, const struct heap* heap) {
    must(kind_memory(s->kind, object) == heap->live_bytes);
    must(heap->mistakes == 0);
}

static int set_up(void** state) {
    (void)state;
    for (size_t i = 0; i < 2 * KINDS; ++i) {
        const struct subject* s = &subjects[i / 2];
        struct source* of = &sources[i / 2][i % 2];
        of->object = create(s, NULL, s->first, s->second, COMPONENTS, CD_FLOAT64);
        build(s, of->object, i % 2 == 0 ? s->everything : s->other);
        assert_true(i % 2 == 1 || strcmp(at.scene, "everything") == 0);
        ok(s->kind->step(of->object, s->dt, 3));
        ok(s->kind->save(of->object, of->bytes, sizeof of->bytes, &of->size));
    }
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    for (size_t i = 0; i < 2 * KINDS; ++i) kinds[i / 2].destroy(sources[i / 2][i % 2].object);
    return 0;
}

/* The hash after the call and some steps, when memory does not run out; and how often the call asks for it. */
static uint64_t undisturbed(const struct subject* s, size_t scene, size_t number, struct made* out_made,
                            size_t* out_asked) {
    struct heap heap = {0};
    any* object = begin(s, &heap, scene);
    heap_fail(&heap, 0, false);
    *out_made = make(s, object, number);
    *out_asked = heap.asked;
    accounts_for(s, object, &heap);
    go_on(s, object, s->dt, 4);
    const uint64_t hash = kind_hash(s->kind, object);
    end(s, object, &heap);
    return hash;
}

static void refuse_request(const struct subject* s, size_t scene, size_t number, size_t request, bool for_good,
                           cd_status wanted, uint64_t after) {
    struct heap heap = {0};
    any* object = begin(s, &heap, scene);
    const uint64_t before = kind_hash(s->kind, object);
    const size_t live = heap.live_bytes, blocks = heap.live_blocks;
    heap_fail(&heap, at.request = request, for_good);
    const cd_status refused = make(s, object, number).status;
    must(refused == CD_ERROR_MEMORY);
    must(heap.refused > 0);
    must(strstr(cd_error_message(), text_of("cd_%s_", s->kind->name)) != NULL);
    must(kind_hash(s->kind, object) == before);
    must(heap.live_bytes == live && heap.live_blocks == blocks);
    accounts_for(s, object, &heap);
    heap_fail(&heap, 0, false); /* memory is back: the same call now does what it always did */
    must(make(s, object, number).status == wanted);
    go_on(s, object, s->dt, 4);
    must(kind_hash(s->kind, object) == after);
    accounts_for(s, object, &heap);
    end(s, object, &heap);
}

static void a_refused_allocation_changes_nothing_and_the_object_still_works(void** state) {
    const struct subject* s = *state;
    size_t refused = 0;
    for (size_t scene = 0; scene < s->scenes; ++scene) {
        for (size_t number = 0;; ++number) {
            struct made made;
            size_t asked;
            const uint64_t after = undisturbed(s, scene, number, &made, &asked);
            if (!made.text) break;
            if (made.never) must(asked == 0);
            for (int for_good = 0; for_good <= 1; ++for_good)
                for (size_t request = 1; request <= asked; request += is_brief() ? 9 : 1, ++refused)
                    refuse_request(s, scene, number, request, for_good, made.status, after);
        }
    }
    assert_true(refused > (is_brief() ? 150 : 600));
}

static void an_object_steps_on_as_before_after_refused_calls(void** state) {
    const struct subject* s = *state;
    for (size_t scene = 0; scene < s->scenes; ++scene) {
        struct heap heap = {0}, calm = {0};
        any *object = begin(s, &heap, scene), *left_alone = begin(s, &calm, scene);
        struct made made = {"", false, CD_OK};
        for (size_t number = 0; made.text; ++number) {
            any* kept = create(s, NULL, s->first, s->second, COMPONENTS, CD_FLOAT64);
            ok(s->kind->copy_state(kept, object));
            heap_fail(&heap, 1, true);
            made = make(s, object, number);
            const size_t asked = heap.asked;
            heap_fail(&heap, 0, false);
            must((made.status == CD_ERROR_MEMORY) == (asked > 0));
            if (asked == 0) ok(s->kind->copy_state(object, kept)); /* needed none: take it back */
            s->kind->destroy(kept);
        }
        go_on(s, object, s->dt, 50);
        go_on(s, left_alone, s->dt, 50);
        must(kind_hash(s->kind, object) == kind_hash(s->kind, left_alone));
        end(s, object, &heap);
        end(s, left_alone, &calm);
    }
}

static void a_create_that_runs_out_of_memory_gives_all_of_it_back(void** state) {
    const struct subject* s = *state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        struct heap heap = {0};
        const cd_allocator allocator = heap_allocator(&heap);
        any* object = create(s, &heap, s->first, s->second, COMPONENTS, precision);
        at.kind = s->kind->name, at.scene = "none", at.call = "create", at.request = 0;
        const size_t needed = heap.asked;
        assert_true(needed > 0);
        accounts_for(s, object, &heap);
        s->kind->destroy(object);
        for (int for_good = 0; for_good <= 1; ++for_good) {
            for (size_t request = 1; request <= needed; ++request) {
                heap_fail(&heap, at.request = request, for_good);
                object = &heap;
                (void)cd_chain_get_steps(NULL, NULL); /* the last message is of another function */
                const cd_status refused =
                    s->kind->create(s->first, s->second, COMPONENTS, precision, &allocator, &object);
                must(refused == CD_ERROR_MEMORY && object == &heap);
                must(strstr(cd_error_message(), text_of("cd_%s_create:", s->kind->name)) == cd_error_message());
                must(heap.live_bytes == 0 && heap.live_blocks == 0);
            }
        }
        heap_fail(&heap, needed + 1, true);
        end(s, create(s, &heap, s->first, s->second, COMPONENTS, precision), &heap);
    }
}

/* The same for each precision and scene, of many shapes. */
typedef void look(const struct subject* s, any* object, size_t scene, const struct heap* heap);

static void tell_of_calls(const struct subject* s, any* object, size_t scene, const struct heap* heap) {
    (void)scene;
    for (size_t number = 0; make(s, object, number).text; ++number) { /* those that do not go together are refused */
        accounts_for(s, object, heap);
        go_on(s, object, s->dt / 10, 1);
        accounts_for(s, object, heap);
    }
}

static void tell_of_methods(const struct subject* s, any* object, size_t scene, const struct heap* heap) {
    (void)scene;
    const bool is_water = is_of(s, CD_KIND_WATER), is_membrane = is_of(s, CD_KIND_MEMBRANE);
    for (cd_method m = is_water ? CD_METHOD_SYMPLECTIC_EULER : CD_METHOD_STIFF_SECOND; m >= CD_METHOD_IMPLICIT; --m)
        for (cd_solver solver = is_membrane ? CD_SOLVER_AUTO : CD_SOLVER_ALTERNATING; solver >= 0; --solver) {
            ok(s->kind->set_method(object, m));
            if (is_membrane) ok(cd_membrane_set_solver(object, solver));
            accounts_for(s, object, heap);
            go_on(s, object, s->dt / 10, 2);
            accounts_for(s, object, heap);
        }
}

static void tell_of_fields(const struct subject* s, any* object, size_t scene, const struct heap* heap) {
    const bool lengths = has_lengths(s, scene);
    ok(s->kind->set_method(object, CD_METHOD_IMPLICIT));
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        if (!s->has_field(field, lengths)) continue;
        ok(s->kind->enable_field(object, field));
        accounts_for(s, object, heap);
        go_on(s, object, s->dt / 10, 1);
    }
    if (lengths) s->surround(object, true);
    accounts_for(s, object, heap);
    for (cd_field field = CD_BREAKING_STRAIN_V; field >= CD_FORCE; --field) {
        if (!s->has_field(field, lengths) || is_always_on(s, field)) continue;
        ok(s->kind->disable_field(object, field));
        accounts_for(s, object, heap);
        go_on(s, object, s->dt / 10, 1);
    }
    if (lengths) s->surround(object, false);
    accounts_for(s, object, heap);
}

static void the_memory_told_is_the_memory_held(void** state) {
    static look* const looks[] = {tell_of_calls, tell_of_methods, tell_of_fields};
    const struct subject* s = *state;
    for (size_t scene = 0; scene < s->scenes; ++scene) {
        const bool lengths = has_lengths(s, scene), is_membrane = is_of(s, CD_KIND_MEMBRANE);
        const size_t first = scene + (is_membrane ? 5 : 1);
        const size_t second = is_of(s, CD_KIND_CHAIN) ? 8 + scene : is_membrane ? 17 - scene : 1 + (29 - scene) % 15;
        const size_t components = lengths && is_membrane ? 3 : 1 + scene % (lengths ? 3 : 4);
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (size_t k = 0; k < COUNT(looks); ++k) {
                struct heap heap = {0};
                any* object = create(s, &heap, first, second, components, precision);
                accounts_for(s, object, &heap);
                build(s, object, scene);
                accounts_for(s, object, &heap);
                looks[k](s, object, scene, &heap);
                end(s, object, &heap);
            }
    }
}

static void read_and_write(const struct subject* s, any* object) {
    static double values[1 << 16];
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        const size_t count = kind_numbers(s->kind, object, field);
        if (count == 0) continue;
        assert_true(count <= COUNT(values));
        ok(s->kind->read(object, field, values, count));
        const cd_status status = s->kind->write(object, field, values, count);
        const bool only_read = field == CD_STRAIN || (field >= CD_TENSION_U && field <= CD_STRAIN_V);
        must(status == (only_read ? CD_ERROR_UNSUPPORTED : CD_OK));
    }
}

static void save_and_load(const struct subject* s, any* object) {
    static unsigned char bytes[1 << 22];
    size_t size;
    ok(s->kind->save_size(object, &size));
    ok(s->kind->save(object, bytes, sizeof bytes, &size));
    ok(s->kind->load(object, bytes, size)); /* the fields that are on already */
    kind_hash(s->kind, object);
}

static void never_allocates(const struct subject* s, any* object, double dt, size_t steps, const struct heap* heap) {
    const size_t allocations = heap->allocations, live = heap->live_bytes;
    at.call = "step";
    go_on(s, object, dt, steps);
    must(heap->allocations == allocations && heap->live_bytes == live);
    at.call = "read and write";
    read_and_write(s, object);
    must(heap->allocations == allocations && heap->live_bytes == live);
    at.call = "save and load";
    save_and_load(s, object);
    must(heap->allocations == allocations && heap->live_bytes == live);
}

static void steps_reads_writes_save_and_load_never_allocate(void** state) {
    const struct subject* s = *state;
    for (size_t scene = 0; scene < s->scenes; ++scene)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (int spread = 0; spread <= 1; ++spread) {
                struct heap heap = {0};
                struct jobs jobs = {0};
                const cd_parallel reversed = jobs_reversed(&jobs);
                any* object = create(s, &heap, s->first, s->second, COMPONENTS, precision);
                build(s, object, scene);
                if (spread) ok(s->kind->set_parallel(object, &reversed));
                for (int round = 1; round <= 3; ++round) never_allocates(s, object, s->dt / 2 * round, 3, &heap);
                end(s, object, &heap);
            }
}

/* Nor do the steps of an object that is large enough for its user's threads to have a part in them. */
static void steps_on_threads_never_allocate(void** state) {
    const struct subject* s = *state;
    for (size_t scene = 0; scene < s->scenes; scene += is_brief() ? 5 : 1) {
        struct heap heap = {0};
        struct jobs jobs = {0};
        const cd_parallel reversed = jobs_reversed(&jobs);
        const size_t components = has_lengths(s, scene) ? 3 : 1;
        any* object = create(s, &heap, s->wide, s->high, components, scene % 2 ? CD_FLOAT32 : CD_FLOAT64);
        build(s, object, scene);
        ok(s->kind->set_parallel(object, &reversed));
        for (int round = 1; round <= 2; ++round) never_allocates(s, object, s->dt / 2 * round, 1, &heap);
        must(jobs.runs > 0);
        end(s, object, &heap);
    }
}

#define OF(number, of, test) \
    { .name = #test of, .test_func = test, .initial_state = (void*)&subjects[number] }
#define OF_EACH(test) OF(0, ": chain", test), OF(1, ": membrane", test), OF(2, ": water", test)

int main(void) {
    const struct CMUnitTest tests[] = {
        OF_EACH(a_refused_allocation_changes_nothing_and_the_object_still_works),
        OF_EACH(an_object_steps_on_as_before_after_refused_calls),
        OF_EACH(a_create_that_runs_out_of_memory_gives_all_of_it_back),
        OF_EACH(the_memory_told_is_the_memory_held),
        OF_EACH(steps_reads_writes_save_and_load_never_allocate),
        OF_EACH(steps_on_threads_never_allocate),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
