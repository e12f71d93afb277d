// SPDX-License-Identifier: MIT
#include "tools/replay/world_replay.h"

#include <algorithm>
#include <map>
#include <utility>

#include "jostle/physics/serialization.h"
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/portable_checkpoint.h"
#include "server/storage/compression.h"
#include "server/storage/sqlite_storage.h"

namespace jostle::replay {

using server::RecoveredWorld;

namespace {

// `world`: its id; empty: all worlds.
std::vector<std::string> damage_of(const server::StorageDamage& damage, const std::string& world) {
    std::vector<std::string> sentences;
    if (!damage.store.empty()) sentences.push_back("the database is damaged: " + damage.store);
    for (const auto& [id, reason] : damage.worlds)
        if (world.empty() || id == world) sentences.push_back("world " + id + ": " + reason);
    return sentences;
}

}  // namespace

Result<PersistedWorld::Listing> PersistedWorld::list(const std::string& file) {
    auto storage = server::SqliteStorage::open(file, {.create = false});
    if (!storage.ok()) return storage.error();
    auto worlds = (*storage)->worlds();
    if (!worlds.ok()) return worlds.error();
    return Listing{*std::move(worlds), damage_of((*storage)->damage(), "")};
}

Result<PersistedWorld> PersistedWorld::open(const std::string& file, const std::string& world) {
    auto storage = server::SqliteStorage::open(file, {.create = false});
    if (!storage.ok()) return storage.error();
    const auto all = (*storage)->worlds();
    if (!all.ok()) return all.error();
    for (const server::StoredWorld& stored : *all) {
        if (stored.id != world && stored.name != world) continue;
        auto record = server::decode_world_definition(stored.settings);
        if (!record.ok()) return record.error();
        std::vector<std::string> damage = damage_of((*storage)->damage(), stored.id);
        return PersistedWorld(*std::move(storage), stored, *std::move(record), std::move(damage));
    }
    std::string names;
    for (const server::StoredWorld& stored : *all)
        names += (names.empty() ? "" : ", ") + stored.name;
    return Error{ErrorCode::not_found, file + " has no world \"" + world + "\"; it contains " +
                                           (names.empty() ? "none" : names)};
}

Result<std::uint32_t> PersistedWorld::oldest() {
    const auto ticks = store_->checkpoint_ticks(stored_.id);
    if (!ticks.ok()) return ticks.error();
    if (ticks->empty()) return Error{ErrorCode::not_found, "the world has no checkpoint"};
    return ticks->back();
}

Result<PersistedWorld::Summary> PersistedWorld::summary() {
    const auto ticks = store_->checkpoint_ticks(stored_.id);
    if (!ticks.ok()) return ticks.error();
    Summary summary{.id = stored_.id,
                    .name = stored_.name,
                    .scene = record_.scene->name,
                    .engine = stored_.engine,
                    .checkpoints = {ticks->rbegin(), ticks->rend()}};
    if (!damage_.empty()) summary.corruption = damage_.front();
    if (summary.checkpoints.empty()) {
        summary.corruption = "the world has no checkpoint";
        return summary;
    }
    summary.last_tick = summary.checkpoints.back();
    const auto first = store_->checkpoint(stored_.id, summary.checkpoints.front());
    if (!first.ok()) summary.corruption = first.error().message;
    std::uint64_t after = first.ok() ? first->sequence : 0;
    for (;;) {
        const auto entries = store_->entries(stored_.id, after, 8 << 20);
        if (!entries.ok()) summary.corruption = entries.error().message;
        if (!entries.ok() || entries->empty()) return summary;
        for (const server::JournalEntry& entry : *entries) {
            summary.entries++;
            summary.bytes += entry.data.size();
            summary.last_tick = std::max(summary.last_tick, entry.last_tick);
            const auto data = server::decompress(entry.data, 64 << 20);
            const auto batch = data.ok() ? server::decode_journal(*data) : data.error();
            if (!batch.ok()) summary.corruption = batch.error().message;
            if (!batch.ok()) return summary;
            for (const server::JournaledTick& tick : batch->ticks)
                summary.commands += tick.commands.size();
        }
        after = entries->back().sequence;
    }
}

Result<RecoveredWorld> PersistedWorld::replay_from_first(const server::RecoveryOptions& options) {
    const auto first = oldest();
    if (!first.ok()) return first.error();
    server::RecoveryOptions from = options;
    from.checkpoint = *first;
    return server::recover_world(*store_, stored_, record_, from);
}

Result<PersistedWorld::Verification> PersistedWorld::verify() {
    const auto ticks = store_->checkpoint_ticks(stored_.id);
    if (!ticks.ok()) return ticks.error();
    Verification verification{.errors = damage_};
    std::map<std::uint32_t, std::uint64_t> hashes, data_hashes;
    for (const std::uint32_t tick : *ticks) {
        const auto checkpoint = store_->checkpoint(stored_.id, tick);
        if (!checkpoint.ok()) {
            verification.errors.push_back(checkpoint.error().message);
            continue;
        }
        hashes[tick] = checkpoint->hash;
        // The replay reports checkpoints that cannot be decoded.
        if (const auto decoded = server::decode_checkpoint(checkpoint->exact, checkpoint->hash);
            decoded.ok())
            data_hashes[tick] = server::data_hash(decoded->host_state);
    }
    const auto compare = [&](const server::HostedWorld& world, std::uint32_t tick) {
        const auto at = hashes.find(tick);
        if (at == hashes.end()) return;
        verification.checkpoints++;
        if (physics::state_hash(world.world()) != at->second)
            verification.errors.push_back("the checkpoint of tick " + std::to_string(tick) +
                                          " differs from the replayed world");
        const auto data = data_hashes.find(tick);
        if (data != data_hashes.end() && world.data_hash() != data->second)
            verification.errors.push_back("the players or attributes of the checkpoint of tick " +
                                          std::to_string(tick) + " differ from the replayed world");
    };
    const auto world = replay_from_first({.after_tick = compare});
    if (!world.ok()) return world.error();
    verification.first_tick = world->checkpoint;
    verification.last_tick = world->tick;
    verification.errors.insert(verification.errors.end(), world->warnings.begin(),
                               world->warnings.end());
    return verification;
}

Result<RecoveredWorld> PersistedWorld::at(std::uint32_t tick) {
    auto world = server::recover_world(*store_, stored_, record_, {.last_tick = tick});
    if (!world.ok()) return world;
    if (world->tick != tick)
        return Error{ErrorCode::not_found, "tick " + std::to_string(tick) +
                                               " is not available; the last tick is " +
                                               std::to_string(world->tick)};
    return world;
}

Result<server::ExportedScene> PersistedWorld::scene_at(std::uint32_t tick) {
    auto world = at(tick);
    if (!world.ok()) return world.error();
    return world->world.exported(*world->scene);
}

Result<PersistedWorld::Portable> PersistedWorld::add_portable() {
    if (!damage_.empty()) return Error{ErrorCode::failed_precondition, damage_.front()};
    auto world = server::recover_world(*store_, stored_, record_, {});
    if (!world.ok()) return world.error();
    // The exact form would no longer be that of the engine that the database names.
    if (!world->warnings.empty())
        return Error{ErrorCode::failed_precondition,
                     "world " + stored_.id + ": " + world->warnings.back() +
                         "; use the jostle-replay of the version that wrote the database"};
    auto checkpoint = server::make_checkpoint(world->world, world->tick, world->sequence);
    if (!checkpoint.ok()) return checkpoint.error();
    server::PortableForm portable = server::encode_portable(world->world, world->tick, record_);
    const Portable added{world->tick, portable.bytes.size(), std::move(portable.omitted)};
    checkpoint->portable = std::move(portable.bytes);
    const server::StorageChange change[] = {
        server::PutCheckpoint{stored_.id, *std::move(checkpoint)}};
    if (Status s = store_->write(change); !s.ok()) return s.error();
    return added;
}

Status PersistedWorld::hashes(std::uint32_t every, const OnHash& on_hash) {
    const auto report = [&](const server::HostedWorld& world, std::uint32_t tick) {
        if (tick % every == 0) on_hash(tick, physics::state_hash(world.world()));
    };
    const auto world = replay_from_first({.after_tick = report});
    if (!world.ok()) return world.error();
    if (!world->warnings.empty()) return Error{ErrorCode::corrupt_data, world->warnings.back()};
    return {};
}

Result<std::optional<PersistedWorld::Difference>> PersistedWorld::first_difference(
    PersistedWorld& other) {
    std::map<std::uint32_t, std::uint64_t> ours;
    if (Status s = hashes(1, [&](std::uint32_t tick, std::uint64_t hash) { ours[tick] = hash; });
        !s.ok())
        return s.error();
    std::optional<std::uint32_t> differs;
    std::size_t compared = 0;
    const auto compare = [&](std::uint32_t tick, std::uint64_t hash) {
        const auto at = ours.find(tick);
        if (at == ours.end() || differs) return;
        compared++;
        if (at->second != hash) differs = tick;
    };
    if (Status s = other.hashes(1, compare); !s.ok()) return s.error();
    if (!differs) {
        if (compared == 0)
            return Error{ErrorCode::failed_precondition, "the databases have no tick in common"};
        return std::optional<Difference>();
    }
    const auto a = replay_from_first({.last_tick = differs});
    if (!a.ok()) return a.error();
    const auto b = other.replay_from_first({.last_tick = differs});
    if (!b.ok()) return b.error();
    return std::optional(
        Difference{*differs, physics::first_difference(a->world.world(), b->world.world())
                                 .value_or("no field differs")});
}

}  // namespace jostle::replay
