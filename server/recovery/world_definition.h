// SPDX-License-Identifier: MIT
//
// The persisted definition of a world: its scene, its owner, and the limits that its commands are
// checked against.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"
#include "server/world/hosted_state.h"

namespace jostle::server {

struct WorldDefinition {
    std::string owner;
    std::shared_ptr<const scenes::SceneDescription> scene;
    HostLimits limits;
    double work_per_second = 0;
};

std::string encode_world_definition(const WorldDefinition& definition);
// corrupt_data: the bytes are not a world definition. failed_precondition: they have a version that
// this server does not read.
Result<WorldDefinition> decode_world_definition(std::string_view bytes);

// Identifies the arithmetic and the version within which checkpoints are exact to the bit.
std::string build_engine_id();

}  // namespace jostle::server
