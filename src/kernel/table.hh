// What the files need that make the tables of kernels.hh.
#pragma once

#include "kernel/kernels.hh"

#ifndef CD_SET
#define CD_SET CD_KERNELS_PLAIN // what CD_ISA is in the public header
#endif

// A kernel, or null where the part that needs it is left out.
#define CD_KERNEL_0(kernel) nullptr
#define CD_KERNEL_1(kernel) kernel
#define CD_KERNEL_OF(part, kernel) CD_KERNEL_##part(kernel)
#define CD_KERNEL(part, kernel) CD_KERNEL_OF(part, kernel)
