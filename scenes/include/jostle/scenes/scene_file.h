// SPDX-License-Identifier: MIT
//
// Scene files: jostle.v1.Scene as JSON, as a message, and as a SceneDescription.
// docs/reference/scene_format.md specifies the format.
#pragma once

#include "jostle/scenes/scene.h"

namespace google::protobuf {
class Message;
}

namespace jostle::v1 {
class Scene;
}

namespace jostle::scenes {

/// Reads a scene from untrusted JSON text, completely or not at all. The error has a line for each
/// problem, at most 20, with line, column, path of the field ("bodies[2].shapes[0].sphere.radius:
/// -1
/// ...") and the accepted values. Joints and modules are checked once the bodies are valid. Any
/// thread.
physics::Result<SceneDescription> read_scene_json(std::string_view text);
/// Reads a scene file of at most 64 MiB. Errors are those of read_scene_json(), preceded by the
/// path, and not_found if the file cannot be read.
physics::Result<SceneDescription> read_scene_file(const std::string& path);
/// Reads a scene from an untrusted message. Errors are those of read_scene_json(), without
/// positions.
physics::Result<SceneDescription> from_message(const v1::Scene& message);

/// Reads a message from untrusted JSON text. Errors are those of read_scene_json() for unknown
/// fields and wrong types. A scene in it may have a "$schema".
physics::Status read_json_message(std::string_view text, google::protobuf::Message& message);
/// Adds the positions in the text to errors of from_message(); the scene is in the field `parent`
/// of the text, such as "scene.", or "".
std::string with_positions(std::string_view text, const std::string& parent,
                           const std::string& errors);

/// Converts a scene to a message. from_message() returns an equal scene.
v1::Scene to_message(const SceneDescription& description);
/// Converts a scene to JSON text, deterministically. read_scene_json() returns an equal scene.
std::string write_scene_json(const SceneDescription& description);

/// Loads a scene by a name of the catalogue or the path of a scene file, as accepted by --scene and
/// jostle-sim. A name that contains '.' or '/' is a path. Returns not_found for an unknown name;
/// the message lists the catalogue.
physics::Result<SceneDescription> load_scene(const std::string& name_or_path);

}  // namespace jostle::scenes
