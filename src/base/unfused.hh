// Comes before all else that GCC compiles. With -ffp-contract=off too its vectorizer of straight lines fuses what adds and
// subtracts by turns (vfmaddsub), where the user's flags let it use such instructions, as -march=native does.
#pragma once

#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif
