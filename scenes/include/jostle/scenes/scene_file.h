// SPDX-License-Identifier: MIT
//
// Scene files: the JSON form of jostle.v1.Scene. The only part of scenes/ that knows the protobuf
// message.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::v1 {
class Scene;
}

namespace jostle::scenes {

// Foreign text. Errors name the field with its path ("bodies[2].shapes[0].box.half_extents.x: -1
// ...") and what to do.
physics::Result<SceneDescription> read_scene_json(std::string_view text);
physics::Result<SceneDescription> read_scene_file(const std::string& path);
physics::Result<SceneDescription> from_message(const v1::Scene& message);

v1::Scene to_message(const SceneDescription& description);
std::string write_scene_json(const SceneDescription& description);

// A catalogue name, or the path of a scene file: what --scene and jostle-sim take.
physics::Result<SceneDescription> load_scene(const std::string& name_or_path);

}  // namespace jostle::scenes
