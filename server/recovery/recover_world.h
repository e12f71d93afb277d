// SPDX-License-Identifier: MIT
//
// A world from the store: its newest checkpoint that is whole, and then again what was done to it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/recovery/journal_codec.h"
#include "server/recovery/world_definition.h"
#include "server/storage/world_storage.h"
#include "server/world/hosted_world.h"

namespace jostle::server {

struct RecoveredWorld {
    HostedWorld world;
    std::uint32_t tick = 0;        // the last one that is in it
    std::uint32_t checkpoint = 0;  // the tick of the one that it came from
    std::uint64_t sequence = 0;
    Chain chain{};
    // What was found to be damaged or done otherwise, each as a sentence.
    std::vector<std::string> warnings;
};

struct RecoveryOptions {
    std::optional<std::uint32_t> checkpoint = {};  // by its tick; nothing: the newest whole one
    std::optional<std::uint32_t> last_tick = {};   // nothing: as far as the journal goes
    int threads = 1;
    int rewinds_max = 16;  // that lie within one another
    // Before each tick that is done again. False: its commands are counted and not done.
    std::function<bool(const JournaledTick& tick)> may_apply = nullptr;
    std::function<void(const HostedWorld& world, std::uint32_t tick)> after_tick = nullptr;
};

// corrupt_data: no checkpoint is whole. not_found: there is none.
Result<RecoveredWorld> recover_world(WorldStorage& store, const StoredWorld& stored,
                                     const WorldDefinition& record, const RecoveryOptions& options);

}  // namespace jostle::server
