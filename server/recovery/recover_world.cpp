// SPDX-License-Identifier: MIT
#include "server/recovery/recover_world.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/portable_checkpoint.h"
#include "server/storage/compression.h"

namespace jostle::server {
namespace {

constexpr std::size_t entries_bytes_max = 8 << 20;  // memory limit of one read
constexpr std::size_t entry_bytes_max = 64 << 20;   // decompressed

std::string describe(const std::string& what, const Error& error) {
    return what + ": " + error.message;
}

class Recovery {
public:
    Recovery(WorldStorage& storage, const StoredWorld& stored, const WorldDefinition& definition,
             const RecoveryOptions& options)
        : storage_(storage), stored_(stored), definition_(definition), options_(options) {}

    Result<RecoveredWorld> run() {
        Result<std::vector<std::uint32_t>> ticks = storage_.checkpoint_ticks(stored_.id);
        if (!ticks.ok()) return ticks.error();
        if (options_.checkpoint)
            std::erase_if(*ticks, [&](std::uint32_t t) { return t != *options_.checkpoint; });
        if (options_.last_tick)
            std::erase_if(*ticks, [&](std::uint32_t t) { return t > *options_.last_tick; });
        if (ticks->empty())
            return Error{ErrorCode::not_found,
                         "world " + stored_.id + " has no checkpoint to recover from"};
        Error last;
        for (const std::uint32_t tick : *ticks) {
            Result<RecoveredWorld> world = from_checkpoint(tick);
            if (world.ok() && world->is_portable) return without_journal(*std::move(world));
            if (world.ok()) return replay_journal(*std::move(world));
            last = world.error();
            warnings_.push_back(describe("the checkpoint of tick " + std::to_string(tick), last));
        }
        return last;
    }

private:
    Result<RecoveredWorld> from_checkpoint(std::uint32_t tick) {
        const Result<Checkpoint> stored_checkpoint = storage_.checkpoint(stored_.id, tick);
        if (!stored_checkpoint.ok()) return stored_checkpoint.error();
        Result<DecodedCheckpoint> saved =
            options_.portable_only
                ? Error{ErrorCode::failed_precondition, "the world definition is not supported"}
                : decode_checkpoint(stored_checkpoint->exact, stored_checkpoint->hash);
        // A damaged exact form is an error: an older checkpoint and the journal restore the world
        // bit-identically.
        if (!saved.ok() && saved.error().code == ErrorCode::failed_precondition)
            return from_portable(*stored_checkpoint, saved.error());
        if (!saved.ok()) return saved.error();
        if (Status s = saved->bodies.set_threads(options_.threads); !s.ok()) return s.error();
        Result<HostedWorld> world =
            HostedWorld::restore(std::move(saved->bodies), saved->host_state, definition_.limits,
                                 definition_.scene->hz, definition_.work_per_second);
        if (!world.ok()) return world.error();
        return RecoveredWorld{.world = *std::move(world),
                              .tick = stored_checkpoint->tick,
                              .checkpoint = stored_checkpoint->tick,
                              .sequence = stored_checkpoint->sequence,
                              .scene = definition_.scene};
    }

    Result<RecoveredWorld> from_portable(const Checkpoint& checkpoint, const Error& unsupported) {
        if (checkpoint.portable.empty())
            return Error{ErrorCode::failed_precondition,
                         unsupported.message +
                             "; the checkpoint has no portable form: add one with "
                             "jostle-replay --add-portable of the version that wrote it (\"" +
                             stored_.engine + "\")"};
        Result<PortableWorld> portable = decode_portable(checkpoint.portable, checkpoint.tick,
                                                         definition_.limits, options_.threads);
        if (!portable.ok()) return portable.error();
        warnings_.push_back(describe("recovered from the portable form of the checkpoint of tick " +
                                         std::to_string(checkpoint.tick) +
                                         " without accumulated impulses, sleep and grabs",
                                     unsupported));
        for (std::string& omitted : portable->omitted)
            warnings_.push_back("the portable form omits " + std::move(omitted));
        return RecoveredWorld{.world = std::move(portable->world),
                              .tick = checkpoint.tick,
                              .checkpoint = checkpoint.tick,
                              .sequence = checkpoint.sequence,
                              .scene = std::move(portable->definition.scene),
                              .is_portable = true};
    }

    // The journal after a portable checkpoint belongs to a world with other bits.
    Result<RecoveredWorld> without_journal(RecoveredWorld world) {
        if (Status s = find_chain(world); !s.ok()) return s.error();
        const Result<std::vector<JournalEntry>> rest =
            storage_.entries(stored_.id, world.sequence, 0);
        if (!rest.ok())
            lose_rest(world, rest.error());
        else if (!rest->empty())
            lose_rest(world, {ErrorCode::failed_precondition,
                              "the journal cannot be replayed from a portable checkpoint; add a "
                              "newer one with jostle-replay --add-portable of the version that "
                              "wrote it (\"" +
                                  stored_.engine + "\")"});
        world.warnings = std::move(warnings_);
        return world;
    }

    Result<RecoveredWorld> replay_journal(RecoveredWorld world) {
        if (stored_.engine != build_engine_id())
            warnings_.push_back("saved by \"" + stored_.engine + "\", resumed by \"" +
                                build_engine_id() + "\": replayed ticks may differ slightly");
        if (Status s = find_chain(world); !s.ok()) return s.error();
        for (bool more = true; more;) {
            const Result<std::vector<JournalEntry>> entries =
                storage_.entries(stored_.id, world.sequence, entries_bytes_max);
            if (!entries.ok()) {
                lose_rest(world, entries.error());
                break;
            }
            more = !entries->empty();
            for (const JournalEntry& entry : *entries)
                if (!more || !(more = apply(entry, world))) break;
        }
        world.warnings = std::move(warnings_);
        return world;
    }

    // Reads the chain value of the last entry contained in the checkpoint.
    Status find_chain(RecoveredWorld& world) {
        if (world.sequence == 0) return {};
        const Result<std::vector<JournalEntry>> last =
            storage_.entries(stored_.id, world.sequence - 1, 0);
        if (!last.ok()) return last.error();
        if (!last->empty() && last->front().sequence == world.sequence)
            world.chain = last->front().chain;
        return {};
    }

    void lose_rest(RecoveredWorld& world, const Error& error) {
        world.is_cut = true;
        warnings_.push_back(
            describe("everything after tick " + std::to_string(world.tick) + " is lost", error));
    }

    // Returns false if the world cannot be replayed further.
    bool apply(const JournalEntry& entry, RecoveredWorld& world) {
        const auto lost = [&](const Error& error) {
            lose_rest(world, error);
            return false;
        };
        const Result<std::string> data = decompress(entry.data, entry_bytes_max);
        if (!data.ok()) return lost(data.error());
        const Result<JournalSegment> segment = decode_journal(*data);
        if (!segment.ok()) return lost(segment.error());
        if (entry.first_tick != world.tick + 1 || entry.last_tick < entry.first_tick)
            return lost({ErrorCode::corrupt_data, "entry " + std::to_string(entry.sequence) +
                                                      " has unexpected ticks " +
                                                      std::to_string(entry.first_tick) + " to " +
                                                      std::to_string(entry.last_tick)});
        if (segment->rewind) {
            if (options_.last_tick && world.tick >= *options_.last_tick) return false;
            if (Status s = rewind_to(*segment->rewind, entry, world); !s.ok())
                return lost(s.error());
        }
        auto tick = segment->ticks.begin();
        auto paused_ticks = segment->paused_ticks.begin();
        while (world.tick < entry.last_tick) {
            if (options_.last_tick && world.tick >= *options_.last_tick) return false;
            const std::uint32_t now = ++world.tick;
            ASSERT(now <= entry.last_tick);
            while (paused_ticks != segment->paused_ticks.end() && paused_ticks->last < now)
                ++paused_ticks;
            const bool paused =
                paused_ticks != segment->paused_ticks.end() && paused_ticks->first <= now;
            const bool busy = tick != segment->ticks.end() && tick->tick == now;
            static const JournaledTick empty_tick;
            const JournaledTick& done = busy ? *tick++ : empty_tick;
            replay(world.world, {now, done.commands}, paused);
        }
        ASSERT(world.tick == entry.last_tick);
        world.sequence = entry.sequence;
        world.chain = entry.chain;
        return true;
    }

    Status rewind_to(const Rewind& rewind, const JournalEntry& entry, RecoveredWorld& world) {
        const std::string context = "rewind from tick " + std::to_string(rewind.tick) +
                                    " to tick " + std::to_string(rewind.to);
        if (rewind.tick != entry.first_tick || rewind.tick != entry.last_tick)
            return Error{ErrorCode::corrupt_data, context + " in an entry with other ticks"};
        if (options_.rewinds_max == 0)
            return Error{ErrorCode::resource_exhausted,
                         context + ": rewinds are nested too deeply"};
        Result<RecoveredWorld> past = recover_world(storage_, stored_, definition_,
                                                    {.last_tick = rewind.to,
                                                     .threads = options_.threads,
                                                     .rewinds_max = options_.rewinds_max - 1,
                                                     .may_apply = options_.may_apply});
        if (!past.ok()) return Error{past.error().code, context + ": " + past.error().message};
        if (past->tick != rewind.to)
            return Error{ErrorCode::not_found, context + ": that tick is no longer retained"};
        past->world.continue_from(world.world);
        world.world = std::move(past->world);
        world.tick = rewind.tick;
        if (options_.after_tick) options_.after_tick(world.world, world.tick);
        return {};
    }

    void replay(HostedWorld& world, const JournaledTick& tick, bool paused) {
        const bool admitted = !options_.may_apply || options_.may_apply(tick);
        for (const JournaledCommand& command : tick.commands) {
            if (admitted)
                world.replay(command);
            else if (command.sequence != 0)  // a command without a sequence is never resent
                world.replay({command.client, command.sequence, std::nullopt});
        }
        // A step that is rejected now was rejected in the original run, too.
        if (!paused) static_cast<void>(world.step(1 / definition_.scene->hz, tick.tick + 1).ok());
        static_cast<void>(world.newly_quarantined());
        if (options_.after_tick) options_.after_tick(world, tick.tick);
    }

    WorldStorage& storage_;
    const StoredWorld& stored_;
    const WorldDefinition& definition_;
    const RecoveryOptions& options_;
    std::vector<std::string> warnings_;
};

}  // namespace

Result<RecoveredWorld> recover_world(WorldStorage& storage, const StoredWorld& stored,
                                     const WorldDefinition& definition,
                                     const RecoveryOptions& options) {
    return Recovery(storage, stored, definition, options).run();
}

Result<WorldDefinition> portable_definition(WorldStorage& storage, const StoredWorld& stored,
                                            const HostLimits& limits) {
    const Result<std::vector<std::uint32_t>> ticks = storage.checkpoint_ticks(stored.id);
    if (!ticks.ok()) return ticks.error();
    if (ticks->empty())
        return Error{ErrorCode::not_found, "world " + stored.id + " has no checkpoint"};
    const Result<Checkpoint> newest = storage.checkpoint(stored.id, ticks->front());
    if (!newest.ok()) return newest.error();
    if (newest->portable.empty())
        return Error{ErrorCode::not_found, "the newest checkpoint has no portable form"};
    Result<PortableWorld> portable = decode_portable(newest->portable, newest->tick, limits, 1);
    if (!portable.ok()) return portable.error();
    return std::move(portable->definition);
}

}  // namespace jostle::server
