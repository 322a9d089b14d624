#define CONTDYN_EXCEPTIONS 1
#include "check.hpp"

#include "mixed.hpp"

int main() {
    contdyn::chain rope(1, 4, 1);
    CHECK(step_by_status(rope.handle()) == CD_ERROR_VALUE);
    CHECK(rope.get_steps() == 2);
    REFUSED(contdyn::status::error_value, "lambda", rope.set_lambda(2));
}
