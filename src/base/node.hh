// What holds a node, as a cd_node or the number of a field.
#pragma once

#include "contdyn/base.h"

namespace cd {

// Whether the node moves as it is told, whatever pulls at it.
template <class Number> constexpr bool holds(Number kind) {
    return kind == CD_NODE_PINNED || kind == CD_NODE_DRIVEN || kind == CD_NODE_POSED;
}
// Whether it may stand in the field CD_PIN of any node: CD_NODE_MATCHED is for ends and edges.
template <class Number> constexpr bool is_kind(Number kind) { return kind == CD_NODE_FREE || holds(kind); }

} // namespace cd
