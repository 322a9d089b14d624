// Beyond its sides a scene goes on as its mirror image, and as that one's, without end.
#include "model/water_hull_plates.hh"

extern "C" {
#include "cmocka_all.h" // last: it makes a macro of the name fail
}
#undef fail

namespace {

void every_second_image_is_a_mirror_image(void**) {
    constexpr double kSize = 0.5;
    constexpr size_t kCells = 6;
    for (int image = -5; image <= 5; ++image) {
        const double inside = (image + 0.25) * kSize * double(kCells);
        assert_true(cd::facing(inside, kSize, kCells, false) == (image % 2 == 0 ? 1 : -1));
        assert_true(cd::facing(inside, kSize, kCells, true) == 1);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {cmocka_unit_test(every_second_image_is_a_mirror_image)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
