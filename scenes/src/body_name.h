// SPDX-License-Identifier: MIT
//
// How joints and modules of a scene name bodies: "link[3]" is the fourth body called link, "link"
// the first.
#pragma once

#include <cstddef>
#include <string>

#include "jostle/scenes/scene.h"
#include "scenes/src/field_reader.h"

namespace jostle::scenes {

// The place of that body in scene.bodies. One that is not there is noted, and 0.
std::size_t find_body(FieldReader& in, const SceneDescription& scene, const std::string& path,
                      const std::string& text);
// The other way round.
std::string name_of(const SceneDescription& scene, std::size_t body);

}  // namespace jostle::scenes
