// Objects release what they hold, once; what was moved from, destroyed or never made refuses every call.
#include "check.hpp"

#include <map>
#include <new>

using namespace contdyn;

namespace {

// What an object holds, by its address.
struct heap {
    std::map<void*, std::size_t> held;
    cd_allocator table() {
        return {this,
                [](void* user, std::size_t size, std::size_t alignment) -> void* {
                    void* pointer = ::operator new(size, std::align_val_t(alignment));
                    static_cast<heap*>(user)->held[pointer] = size;
                    return pointer;
                },
                [](void* user, void* pointer, std::size_t size, std::size_t alignment) {
                    auto& known = static_cast<heap*>(user)->held;
                    CHECK(known.count(pointer) == 1 && known[pointer] == size);
                    known.erase(pointer);
                    ::operator delete(pointer, std::align_val_t(alignment));
                }};
    }
};

template <class Object, class Create> void owned_once(Create create) {
    heap memory;
    const cd_allocator allocator = memory.table();
    {
        Object first = create(&allocator);
        CHECK(first && !memory.held.empty());
        const auto* handle = first.handle();
        std::size_t bytes = 0;
        for (const auto& [pointer, size] : memory.held) bytes += size;
        CHECK(GET(first.get_memory()) == bytes);

        Object second = std::move(first);
        CHECK(!first && second.handle() == handle);                       // NOLINT: what a move leaves is defined
        REFUSED(status::error_null, "null", first.hash());                // NOLINT
        REFUSED(status::error_null, "null", first.step(0.1));             // NOLINT
        REFUSED(status::error_null, "null", first.view(field::velocity)); // NOLINT
        REFUSED(status::error_null, "null", first.read_f64(field::velocity));
        REFUSED(status::error_null, "null", first.save());

        Object third = create(&allocator);
        const std::size_t two = memory.held.size();
        third = std::move(second); // releases its own
        CHECK(memory.held.size() < two && third.handle() == handle && !second);
        Object& same = third;
        third = std::move(same);
        CHECK(third.handle() == handle);

        std::swap(first, third);
        CHECK(first.handle() == handle && !third);

        first.destroy();
        CHECK(!first && memory.held.empty());
        first.destroy();
        REFUSED(status::error_null, "null", first.reset());

        first = create(&allocator);
        Object taken_over(first.release());
        CHECK(!first && taken_over && !memory.held.empty());
        OK(taken_over.reset());
    }
    CHECK(memory.held.empty());
    Object none;
    CHECK(!none && none.handle() == nullptr);
    REFUSED(status::error_null, "null", none.get_shape());
}

void a_failed_create_makes_nothing() {
    cd_allocator empty = {nullptr, [](void*, std::size_t, std::size_t) -> void* { return nullptr; },
                          [](void*, void*, std::size_t, std::size_t) {}};
    REFUSED(status::error_memory, "", chain::create(1, 10, 3, precision::float32, &empty));
    REFUSED(status::error_value, "components", chain::create(1, 10, 5));
    REFUSED(status::error_enum, "precision", membrane::create(4, 4, 1, static_cast<precision>(7)));
    REFUSED(status::error_size, "", water::create(SIZE_MAX / 2, 3, 1, 1));
#if CONTDYN_EXCEPTIONS
    REFUSED(status::error_value, "components", chain(1, 10, 5));
    REFUSED(status::error_memory, "", membrane(4, 4, 1, precision::float64, &empty));
    REFUSED(status::error_value, "dx", water(4, 4, -1, 1));
#else
    const result<chain> none = chain::create(1, 10, 5);
    CHECK(!none && !none.value() && none.status() == status::error_value);
#endif
}

void objects_live_in_containers() {
    std::vector<chain> ropes;
    for (std::size_t i = 1; i <= 20; ++i) ropes.push_back(GET(chain::create(1, i, 2)));
    ropes.erase(ropes.begin());
    for (std::size_t i = 0; i < ropes.size(); ++i) CHECK(GET(ropes[i].get_shape()).springs == i + 2);
}

} // namespace

int main() {
    static_assert(!std::is_copy_constructible_v<chain> && !std::is_copy_assignable_v<water>);
    static_assert(std::is_nothrow_move_constructible_v<membrane> && std::is_nothrow_move_assignable_v<chain>);
    static_assert(sizeof(chain) == sizeof(void*));
    owned_once<chain>([](const cd_allocator* a) { return GET(chain::create(2, 5, 2, precision::float64, a)); });
    owned_once<membrane>([](const cd_allocator* a) { return GET(membrane::create(3, 5, 1, precision::float32, a)); });
    owned_once<water>([](const cd_allocator* a) { return GET(water::create(3, 5, 1, 1, precision::float32, a)); });
    a_failed_create_makes_nothing();
    objects_live_in_containers();
}
