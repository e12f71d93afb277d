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

/// Reads a scene from untrusted JSON text, completely or not at all. An error names the line, the
/// path of the field ("bodies[2].shapes[0].box.half_extents.x: -1 ...") and the accepted values.
/// Any thread.
physics::Result<SceneDescription> read_scene_json(std::string_view text);
/// Reads a scene file of at most 64 MiB. Errors are those of read_scene_json(), preceded by the
/// path, and not_found if the file cannot be read.
physics::Result<SceneDescription> read_scene_file(const std::string& path);
/// Reads a scene from an untrusted message. Errors are those of read_scene_json(), without lines.
physics::Result<SceneDescription> from_message(const v1::Scene& message);

/// Converts a scene to a message. from_message() returns an equal scene.
v1::Scene to_message(const SceneDescription& description);
/// Converts a scene to JSON text, deterministically. read_scene_json() returns an equal scene.
std::string write_scene_json(const SceneDescription& description);

/// Loads a scene by a name of the catalogue or the path of a scene file, as accepted by --scene and
/// jostle-sim. A name that contains '.' or '/' is a path. Returns not_found for an unknown name;
/// the message lists the catalogue.
physics::Result<SceneDescription> load_scene(const std::string& name_or_path);

}  // namespace jostle::scenes
