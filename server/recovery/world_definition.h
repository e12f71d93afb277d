// SPDX-License-Identifier: MIT
//
// What a world is made of, as it stands in the store: its scene, its owner, and the limits that its
// commands are judged by.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"
#include "server/world/apply_action.h"

namespace jostle::server {

struct WorldDefinition {
    std::string owner;
    std::shared_ptr<const scenes::SceneDescription> scene;
    HostLimits limits;
    double work_per_second = 0;
};

std::string encode_world_definition(const WorldDefinition& record);
// corrupt_data: the bytes are no such record.
Result<WorldDefinition> decode_world_definition(std::string_view bytes);

// By whose arithmetic and format checkpoints are exact to the bit.
std::string build_engine_id();

}  // namespace jostle::server
