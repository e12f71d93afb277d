// SPDX-License-Identifier: MIT
//
// Handles of the objects of a world. An id is valid until its object is destroyed. A later object
// may reuse the index, but with another generation. The lowest free index is assigned first, so the
// same sequence of calls yields the same ids. A default-constructed id is null and names no object.
#pragma once

#include <compare>
#include <cstdint>

namespace jostle::physics {

/// Handle of a body.
struct BodyId {
    std::uint32_t index = 0xffffffff;  ///< position in the world's store; 0xffffffff: null
    std::uint32_t generation = 0;      ///< distinguishes successive objects at one index

    auto operator<=>(const BodyId&) const = default;
};

/// Handle of a shape.
struct ShapeId {
    std::uint32_t index = 0xffffffff;  ///< position in the world's store; 0xffffffff: null
    std::uint32_t generation = 0;      ///< distinguishes successive objects at one index

    auto operator<=>(const ShapeId&) const = default;
};

/// Handle of a joint.
struct JointId {
    std::uint32_t index = 0xffffffff;  ///< position in the world's store; 0xffffffff: null
    std::uint32_t generation = 0;      ///< distinguishes successive objects at one index

    auto operator<=>(const JointId&) const = default;
};

/// Handle of a force field.
struct FieldId {
    std::uint32_t index = 0xffffffff;  ///< position in the world's store; 0xffffffff: null
    std::uint32_t generation = 0;      ///< distinguishes successive objects at one index

    auto operator<=>(const FieldId&) const = default;
};

/// Return true for a null id. A non-null id may still name a destroyed object; see
/// World::contains().
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
