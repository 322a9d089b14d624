/* contdyn: ropes, hair, sheets, drums and water on regular lattices, after Michael Kass,
 * "An Introduction to Continuum Dynamics for Computer Graphics" (1997). This header includes all others. */
#ifndef CONTDYN_CONTDYN_H
#define CONTDYN_CONTDYN_H

#include "base.h"
#include "chain.h"
#include "membrane.h"
#include "water.h"

#endif
