// chain.h: what surrounds ropes, air and what they touch.
#include "api/chain_handle.hh"
#include "api/surroundings.hh"

using namespace cd;

CD_SURROUNDINGS_FUNCTIONS(chain)
CD_FUNCTION(chain, , set_thickness, (double radius),
            shared::set_thickness(__func__, x, "radius", radius, x.rope.thickness))
CD_GETTER(chain, get_thickness, double, out_radius, x.rope.thickness)
