// SPDX-License-Identifier: MIT
//
// Reads and writes the messages of the modules that come with Jostle (modules.proto), driven by
// field options: the name of the module setting and its range.
#pragma once

#include <string>

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace google::protobuf {
class Message;
}

namespace jostle::scenes {

// Each item of each list becomes an object of `module`. `path` is the path of the message.
void read_module_objects(FieldReader& in, const SceneDescription& scene, SceneModule& module,
                         const std::string& path, const google::protobuf::Message& message);

// The inverse. Returns false if an object has a list or a setting that the message lacks.
bool write_module_objects(google::protobuf::Message& message, const SceneDescription& scene,
                          const SceneModule& module);

}  // namespace jostle::scenes
