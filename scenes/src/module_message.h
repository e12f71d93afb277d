// SPDX-License-Identifier: MIT
//
// Converts jostle.v1.Module to SceneModule and back.
#pragma once

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace jostle::v1 {
class Module;
}

namespace jostle::scenes {

// Appends the module to scene.modules. All bodies of the scene must exist already.
void read_module(FieldReader& in, SceneDescription& scene, const std::string& path,
                 const v1::Module& message);
void write_module(v1::Module& out, const SceneDescription& scene, const SceneModule& module);

}  // namespace jostle::scenes
