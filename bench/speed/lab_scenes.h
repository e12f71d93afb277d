// SPDX-License-Identifier: MIT
//
// The scenes of the laboratory, by letter and by name. Their numbers are fixed for good: results
// taken at different times, and those of other engines' authors, are about the same scenes.
#pragma once

#include <span>
#include <string_view>

#include "speed/scene_description.h"

namespace jostle::bench {

struct LabScene {
    const char* letter;
    const char* name;
    const char* about;  // one line
    SceneDescription (*build)();
};

std::span<const LabScene> lab_scenes();

// By letter or name; null when there is no such scene.
const LabScene* find_lab_scene(std::string_view letter_or_name);

// Scene d with another count: the same bodies in columns over a square whose area grows with the
// count (0.02 m^2 a body), so that the settled pile is as deep for every count. 5000 is scene d.
SceneDescription poured_pile(int count);

}  // namespace jostle::bench
