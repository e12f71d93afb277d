// SPDX-License-Identifier: MIT
//
// Converts a scene of the accuracy benchmark to MuJoCo's XML.
#pragma once

#include <string>

#include "bench/accuracy/accuracy_bodies.h"
#include "jostle/base/result.h"

namespace jostle::bench::accuracy {

Result<std::string> mujoco_xml(const Scene& scene, const BodyTree& tree, const std::string& mode);

}  // namespace jostle::bench::accuracy
