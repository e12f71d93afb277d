// SPDX-License-Identifier: MIT
//
// Parts that messages of several kinds share.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "jostle/physics/defs.h"
#include "jostle/physics/vec3.h"
#include "jostle/v1/common.pb.h"

namespace jostle::v1 {
enum BodyType : int;
}

namespace jostle::server {

// Encodes the start of a ServerMessage whose end is shared by many clients (out_message.h).
//
// The header of a field whose content is `own` followed by `shared_bytes` more bytes: tag, length,
// then `own`.
std::string encode_header(int field_number, std::string_view own, std::size_t shared_bytes);

// Converts vectors from and to messages. Unchecked: callers must validate client values.
inline physics::Vec3 to_vector(const v1::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

inline void write_vector(v1::Vec3& to, physics::Vec3 from) {
    to.set_x(from.x);
    to.set_y(from.y);
    to.set_z(from.z);
}

v1::BodyType to_message(physics::BodyType type);

}  // namespace jostle::server
