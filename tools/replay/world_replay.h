// SPDX-License-Identifier: MIT
//
// What a server's store has of a world (server/recovery), done again: is it whole, what was it in
// any tick, and where do two of them part? Each opens the store for itself alone, so no server may
// have it open. One thread.
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
    // By id or name. Errors: the store cannot be opened, or has no such world.
    static Result<PersistedWorld> open(const std::string& file, const std::string& world);
    static Result<std::vector<server::StoredWorld>> list(const std::string& file);

    struct Summary {
        std::string id, name, scene, engine;
        std::vector<std::uint32_t> checkpoints;  // ticks, rising
        std::uint32_t last_tick = 0;
        std::uint64_t entries = 0, commands = 0, bytes = 0;
        std::string corruption;  // empty: none was found
    };
    Result<Summary> summary();

    struct Verification {
        std::uint32_t first_tick = 0, last_tick = 0;
        int checkpoints = 0;              // that were compared, the first one not among them
        std::vector<std::string> errors;  // each a sentence
    };
    // From the oldest checkpoint on: each later one must be what the world has become then.
    Result<Verification> verify();

    // From the newest checkpoint before it. not_found: that tick is not kept.
    Result<server::RecoveredWorld> at(std::uint32_t tick);
    // As a scene file, and what it cannot say, each as a sentence.
    Result<server::ExportedScene> scene_at(std::uint32_t tick);

    // The hash of the state after each tick, from the oldest checkpoint on.
    using OnHash = std::function<void(std::uint32_t tick, std::uint64_t hash)>;
    Status hashes(std::uint32_t every, const OnHash& on_hash);

    struct Difference {
        std::uint32_t tick = 0;  // the first one after which they differ
        std::string field;       // the first one, with both values
    };
    // Of the ticks that both have. Nothing: they are the same.
    Result<std::optional<Difference>> first_difference(PersistedWorld& other);

    const std::string& id() const { return stored_.id; }

private:
    PersistedWorld(std::unique_ptr<server::WorldStorage> store, server::StoredWorld stored,
                   server::WorldDefinition record)
        : store_(std::move(store)), stored_(std::move(stored)), record_(std::move(record)) {}
    Result<server::RecoveredWorld> replay_from_first(const server::RecoveryOptions& options);
    Result<std::uint32_t> oldest();

    std::unique_ptr<server::WorldStorage> store_;
    server::StoredWorld stored_;
    server::WorldDefinition record_;
};

}  // namespace jostle::replay
