// SPDX-License-Identifier: MIT
//
// The messages of the modules that come with Jostle (modules.proto), read and written by what their
// fields say of themselves: which setting of the module they are, and its range.
#pragma once

#include <string>

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace google::protobuf {
class Message;
}

namespace jostle::scenes {

// Each item of each list becomes a thing of `module`. `path` is the message's.
void read_module_objects(FieldReader& in, const SceneDescription& scene, SceneModule& module,
                         const std::string& path, const google::protobuf::Message& message);

// The other way. False: a thing is of a list, or has a setting, that the message does not have.
bool write_module_objects(google::protobuf::Message& message, const SceneDescription& scene,
                          const SceneModule& module);

}  // namespace jostle::scenes
