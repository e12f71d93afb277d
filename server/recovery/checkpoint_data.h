// SPDX-License-Identifier: MIT
//
// Encodes a hosted world: its bodies and its host state.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/storage/storage_types.h"
#include "server/world/hosted_world.h"
#include "server/world/world_persistence.h"

namespace jostle::server {

struct CheckpointData {
    std::uint64_t hash = 0;  // of the state of the bodies
    std::string bytes;
};
// Takes tens of milliseconds for thousands of bodies: do not call on a tick thread.
Result<CheckpointData> encode_checkpoint(const CheckpointCopy& checkpoint_copy);

// The exact checkpoint of a world that does not step meanwhile, without a portable form.
Result<Checkpoint> make_checkpoint(const HostedWorld& world, std::uint32_t tick,
                                   std::uint64_t sequence);

struct DecodedCheckpoint {
    physics::World bodies;
    SavedHostState host_state;
};
// corrupt_data: the bytes are not a checkpoint, or the state hash differs from `hash`.
// failed_precondition: they have a format version that this server does not read.
Result<DecodedCheckpoint> decode_checkpoint(std::string_view bytes, std::uint64_t hash);

}  // namespace jostle::server
