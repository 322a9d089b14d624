// Two parts of one program with errors of another kind, and spans of another standard.
#ifndef MIXED_HPP
#define MIXED_HPP

#include <contdyn/contdyn.h>

// Steps the other part's chain; the status of a call that is refused.
cd_status step_by_status(cd_chain* chain);

#endif
