// SPDX-License-Identifier: MIT
//
// Handles. An id is valid until its object is destroyed. A later object may have the same index,
// but not the same generation. The lowest free index is handed out first, so the same calls give
// the same ids. A default id is null: it names nothing.
#pragma once

#include <compare>
#include <cstdint>

namespace jostle::physics {

struct BodyId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const BodyId&) const = default;
};

struct ShapeId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const ShapeId&) const = default;
};

struct JointId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const JointId&) const = default;
};

struct FieldId {  // a force field
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const FieldId&) const = default;
};

inline bool is_null(BodyId id) {
    return id.index == 0xffffffff;
}
inline bool is_null(ShapeId id) {
    return id.index == 0xffffffff;
}
inline bool is_null(JointId id) {
    return id.index == 0xffffffff;
}
inline bool is_null(FieldId id) {
    return id.index == 0xffffffff;
}

}  // namespace jostle::physics
