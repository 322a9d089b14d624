#define CONTDYN_EXCEPTIONS 0
#include <contdyn/contdyn.hpp>

#include "mixed.hpp"

cd_status step_by_status(cd_chain* chain) {
    contdyn::chain rope(chain);
    const contdyn::status s = rope.step(0.5, 2) != contdyn::status::ok ? contdyn::status::ok : rope.step(-1);
    return rope.release() == chain ? static_cast<cd_status>(s) : CD_OK;
}
