// SPDX-License-Identifier: MIT
//
// Scene files: jostle.v1.Scene as JSON, as a message, and as a SceneDescription.
// docs/reference/scene_format.md says what a file holds.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::v1 {
class Scene;
}

namespace jostle::scenes {

// Foreign text and messages are read as a whole or not at all. An error names the field with its
// path ("bodies[2].shapes[0].box.half_extents.x: -1 ...") and says what to do; of a text it names
// the line, of a file the file, too.
physics::Result<SceneDescription> read_scene_json(std::string_view text);
physics::Result<SceneDescription> read_scene_file(const std::string& path);
physics::Result<SceneDescription> from_message(const v1::Scene& message);

v1::Scene to_message(const SceneDescription& description);
std::string write_scene_json(const SceneDescription& description);

// A name of the catalogue or the path of a scene file, as --scene and jostle-sim take it: what has
// a '.' or a '/' in it is a path.
physics::Result<SceneDescription> load_scene(const std::string& name_or_path);

}  // namespace jostle::scenes
