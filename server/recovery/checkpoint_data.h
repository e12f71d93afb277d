// SPDX-License-Identifier: MIT
//
// A hosted world as bytes: its bodies, and what it is beside them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/world/hosted_world.h"
#include "server/world/world_persistence.h"

namespace jostle::server {

struct CheckpointData {
    std::uint64_t hash = 0;  // of the state of the bodies
    std::string bytes;
};
// Takes tens of milliseconds for thousands of bodies: not for a tick's thread.
Result<CheckpointData> encode_checkpoint(const CheckpointCopy& checkpoint_copy);

struct DecodedCheckpoint {
    physics::World bodies;
    SavedHostState host_state;
};
// corrupt_data: the bytes are no such image, or their hash is another one.
Result<DecodedCheckpoint> decode_checkpoint(std::string_view bytes, std::uint64_t hash);

}  // namespace jostle::server
