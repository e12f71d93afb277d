// SPDX-License-Identifier: MIT
//
// Body references in joints and modules of a scene: "link[3]" is the fourth body named link, "link"
// the first.
#pragma once

#include <cstddef>
#include <string>

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace jostle::scenes {

// Returns the index of the body in scene.bodies. If there is none, reports an error and returns 0.
std::size_t find_body(FieldReader& in, const SceneDescription& scene, const std::string& path,
                      const std::string& text);
// Inverse of find_body().
std::string name_of(const SceneDescription& scene, std::size_t body);

}  // namespace jostle::scenes
