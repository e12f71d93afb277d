// SPDX-License-Identifier: MIT
//
// Replays a persisted world from a server's database (server/recovery): verifies its checkpoints,
// restores any tick, and finds the first difference of two databases. Each object opens the
// database exclusively, so no server may use it. One thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/recovery/recover_world.h"
#include "server/storage/world_storage.h"

namespace jostle::replay {

class PersistedWorld {
public:
    // Opens a world by id or name. Returns an error if the database cannot be opened or has no such
    // world.
    static Result<PersistedWorld> open(const std::string& file, const std::string& world);
    struct Listing {
        std::vector<server::StoredWorld> worlds;
        std::vector<std::string> damage;  // of the database, one sentence each
    };
    static Result<Listing> list(const std::string& file);

    struct Summary {
        std::string id, name, scene, engine;
        std::vector<std::uint32_t> checkpoints;  // ticks, ascending
        std::uint32_t last_tick = 0;
        std::uint64_t entries = 0, commands = 0, bytes = 0;
        std::string corruption;  // empty: none found
    };
    Result<Summary> summary();

    struct Verification {
        std::uint32_t first_tick = 0, last_tick = 0;
        int checkpoints = 0;              // number of compared checkpoints, excluding the first one
        std::vector<std::string> errors;  // one sentence each
    };
    // Replays from the oldest checkpoint and compares each later one with the replayed world.
    Result<Verification> verify();

    // Restores a tick from the newest checkpoint before it. not_found: the tick is not available.
    Result<server::RecoveredWorld> at(std::uint32_t tick);
    // The tick as a scene, with state that a scene cannot express, one sentence each.
    Result<server::ExportedScene> scene_at(std::uint32_t tick);

    struct Portable {
        std::uint32_t tick = 0;
        std::size_t bytes = 0;             // of the portable form
        std::vector<std::string> omitted;  // parts that it cannot represent, one sentence each
    };
    // Writes a checkpoint of the last tick with a portable form, from which another version can
    // resume. failed_precondition: another version wrote the world, or it is damaged.
    Result<Portable> add_portable();

    // Reports the state hash of every `every`-th tick, from the oldest checkpoint on.
    using OnHash = std::function<void(std::uint32_t tick, std::uint64_t hash)>;
    Status hashes(std::uint32_t every, const OnHash& on_hash);

    struct Difference {
        std::uint32_t tick = 0;  // the first tick that differs
        std::string field;       // the first field that differs, with both values
    };
    // Compares the ticks that both worlds have. Returns nothing if they are equal.
    Result<std::optional<Difference>> first_difference(PersistedWorld& other);

    const std::string& id() const { return stored_.id; }

private:
    PersistedWorld(std::unique_ptr<server::WorldStorage> store, server::StoredWorld stored,
                   server::WorldDefinition record, std::vector<std::string> damage)
        : store_(std::move(store)),
          stored_(std::move(stored)),
          record_(std::move(record)),
          damage_(std::move(damage)) {}
    Result<server::RecoveredWorld> replay_from_first(const server::RecoveryOptions& options);
    Result<std::uint32_t> oldest();

    std::unique_ptr<server::WorldStorage> store_;
    server::StoredWorld stored_;
    server::WorldDefinition record_;
    std::vector<std::string> damage_;  // of the database and of this world
};

}  // namespace jostle::replay
