// SPDX-License-Identifier: MIT
//
// Converts jostle.v1.Joint to SceneJoint and back.
#pragma once

#include <optional>
#include <string>

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace jostle::v1 {
class Joint;
enum JointSolver : int;
}  // namespace jostle::v1

namespace jostle::scenes {

inline constexpr std::size_t joints_max = 200000;  // after repeats

// Returns nullopt if the message has no solver. An unknown solver is reported as an error.
std::optional<physics::JointSolver> read_solver(FieldReader& in, const std::string& path,
                                                v1::JointSolver solver);
v1::JointSolver message_of(physics::JointSolver solver);

// Appends the joint and its copies to scene.joints. All bodies of the scene must exist already.
void read_joint(FieldReader& in, SceneDescription& scene, const std::string& path,
                const v1::Joint& message);
void write_joint(v1::Joint& out, const SceneDescription& scene, const SceneJoint& joint);

}  // namespace jostle::scenes
