// SPDX-License-Identifier: MIT
//
// Scene files: jostle.v1.Scene as JSON, as a message, and as a SceneDescription.
// docs/reference/scene_format.md specifies the format.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::v1 {
class Scene;
}

namespace jostle::scenes {

/// Read an untrusted scene completely or not at all. An error names the path of the field
/// ("bodies[2].shapes[0].box.half_extents.x: -1 ...") and the accepted values. For text it also
/// names the line, for a file the file. Any thread.
physics::Result<SceneDescription> read_scene_json(std::string_view text);
physics::Result<SceneDescription> read_scene_file(const std::string& path);
physics::Result<SceneDescription> from_message(const v1::Scene& message);

/// Convert a scene to a message or to JSON text, deterministically. Reading the result returns an
/// equal scene.
v1::Scene to_message(const SceneDescription& description);
std::string write_scene_json(const SceneDescription& description);

/// Loads a scene by a name of the catalogue or the path of a scene file, as accepted by --scene and
/// jostle-sim. A name that contains '.' or '/' is a path. Returns not_found for an unknown name;
/// the message lists the catalogue.
physics::Result<SceneDescription> load_scene(const std::string& name_or_path);

}  // namespace jostle::scenes
