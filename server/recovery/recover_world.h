// SPDX-License-Identifier: MIT
//
// Recovers a world from storage: loads its newest intact checkpoint and replays the journal.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/recovery/journal_codec.h"
#include "server/recovery/world_definition.h"
#include "server/storage/world_storage.h"
#include "server/world/hosted_world.h"

namespace jostle::server {

// Inputs of a client that a replay leaves out, except for those that end something: releases and
// leaving. From the first tick on, the client counts as disconnected.
struct OmittedInputs {
    ClientId client = 0;
    std::uint32_t first_tick = 0, last_tick = 0;

    bool operator==(const OmittedInputs&) const = default;
};

// A world that is replayed beside the original one, without some inputs.
struct WorldWithout {
    HostedWorld world;
    std::vector<OmittedInputs> begun = {};  // whose first tick was reached
};

struct RecoveredWorld {
    HostedWorld world;
    // Without RecoveryOptions::omitted; nothing: their first tick was not reached.
    std::optional<WorldWithout> without = {};
    std::size_t omitted = 0;       // number of omitted inputs
    std::uint32_t tick = 0;        // last applied tick
    std::uint32_t checkpoint = 0;  // tick of the checkpoint it was recovered from
    std::uint64_t sequence = 0;
    Chain chain{};
    // The scene that it was built from: of the definition, or of a portable checkpoint.
    std::shared_ptr<const scenes::SceneDescription> scene = {};
    // It was recovered from the portable form of a checkpoint, so it is close to the original
    // world but not bit-identical, and its older checkpoints do not match its scene.
    bool is_portable = false;
    // Damage found and deviations from the original run, one sentence each.
    std::vector<std::string> warnings;
    bool is_cut = false;  // ticks after `tick` are stored but cannot be read
};

struct RecoveryOptions {
    std::optional<std::uint32_t> checkpoint = {};  // by its tick; empty: the newest intact one
    std::optional<std::uint32_t> last_tick = {};   // empty: up to the end of the journal
    int threads = 1;
    int rewinds_max = 16;  // maximum nesting depth
    // Use only the portable forms of checkpoints, for example because the definition is not that
    // of the exact ones.
    bool portable_only = false;
    // If not empty, a second world is replayed without these inputs (RecoveredWorld::without). Only
    // checkpoints before their first ticks are used.
    std::vector<OmittedInputs> omitted = {};
    // Called before each replayed tick. False: its commands are counted but not executed.
    std::function<bool(const JournaledTick& tick)> may_apply = nullptr;
    std::function<void(const HostedWorld& world, std::uint32_t tick)> after_tick = nullptr;
};

// A checkpoint whose exact form has an unsupported format version is replaced by its portable form,
// after which no journal can be replayed. corrupt_data: no checkpoint is intact. not_found: there
// is none. failed_precondition: this version cannot read any.
Result<RecoveredWorld> recover_world(WorldStorage& storage, const StoredWorld& stored,
                                     const WorldDefinition& definition,
                                     const RecoveryOptions& options);

// Continues the replay of a recovered world with journal entries that were written since.
// `options`: those of recover_world().
RecoveredWorld continue_recovery(WorldStorage& storage, const StoredWorld& stored,
                                 const WorldDefinition& definition, const RecoveryOptions& options,
                                 RecoveredWorld world);

// The definition of a world whose stored definition this version cannot read, taken from the
// portable form of its newest checkpoint. Recover the world with portable_only.
Result<WorldDefinition> portable_definition(WorldStorage& storage, const StoredWorld& stored,
                                            const HostLimits& limits);

}  // namespace jostle::server
