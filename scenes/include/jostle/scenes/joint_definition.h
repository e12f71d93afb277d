// SPDX-License-Identifier: MIT
//
// Converts jostle.v1.Joint to physics::JointDef and back, for joints outside of scene files. Any
// thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "jostle/physics/joint_defs.h"
#include "jostle/physics/result.h"

namespace jostle::v1 {
class Joint;
}

namespace jostle::scenes {

/// A joint without its bodies.
struct JointDefinition {
    physics::JointDef joint;  ///< body_a and body_b are null
    std::optional<physics::Transform> frame =
        {};  ///< in the world, in place of frame_a and frame_b
};

/// Converts an untrusted message; every number is checked. Fields that only scene files have (name,
/// body_a, body_b, repeat) must be absent. An error names the field, with `path` as the beginning
/// of its path.
physics::Result<JointDefinition> joint_from_message(const v1::Joint& message,
                                                    const std::string& path);

/// Writes frames, kind, breaking limits and solver, so that joint_from_message() restores them.
void write_joint_definition(v1::Joint& out, const physics::JointDef& def);

/// Returns the joint as a serialized message, for storage.
std::string joint_bytes(const JointDefinition& joint);
/// Inverse of joint_bytes(). The bytes are untrusted; errors are those of joint_from_message(), and
/// corrupt_data if the bytes are not a message.
physics::Result<JointDefinition> joint_from_bytes(std::string_view bytes, const std::string& path);

}  // namespace jostle::scenes
