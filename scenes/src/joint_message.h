// SPDX-License-Identifier: MIT
//
// jostle.v1.Joint to SceneJoint and back.
#pragma once

#include "field_reader.h"
#include "jostle/scenes/scene.h"

namespace jostle::v1 {
class Joint;
}

namespace jostle::scenes {

inline constexpr std::size_t joints_max = 200000;  // after repeats

// Appends the joint and its copies to scene.joints. The scene's bodies are all there.
void read_joint(FieldReader& in, SceneDescription& scene, const std::string& path,
                const v1::Joint& message);
void write_joint(v1::Joint& out, const SceneDescription& scene, const SceneJoint& joint);

}  // namespace jostle::scenes
