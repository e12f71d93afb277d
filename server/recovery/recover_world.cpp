// SPDX-License-Identifier: MIT
#include "server/recovery/recover_world.h"

#include <algorithm>
#include <utility>

#include "server/recovery/checkpoint_data.h"
#include "server/storage/compression.h"

namespace jostle::server {
namespace {

constexpr std::size_t entries_bytes_max = 8 << 20;  // in memory at once
constexpr std::size_t entry_bytes_max = 64 << 20;   // unpacked

std::string said(const std::string& what, const Error& error) {
    return what + ": " + error.message;
}

class Recovery {
public:
    Recovery(WorldStorage& store, const StoredWorld& stored, const WorldDefinition& record,
             const RecoveryOptions& options)
        : store_(store), stored_(stored), record_(record), options_(options) {}

    Result<RecoveredWorld> run() {
        Result<std::vector<std::uint32_t>> ticks = store_.checkpoint_ticks(stored_.id);
        if (!ticks.ok()) return ticks.error();
        if (options_.checkpoint)
            std::erase_if(*ticks, [&](std::uint32_t t) { return t != *options_.checkpoint; });
        if (options_.last_tick)
            std::erase_if(*ticks, [&](std::uint32_t t) { return t > *options_.last_tick; });
        if (ticks->empty())
            return Error{ErrorCode::not_found, "no checkpoint of world " + stored_.id +
                                                   " is kept from which it could be had"};
        Error last;
        for (const std::uint32_t tick : *ticks) {
            Result<RecoveredWorld> world = from_checkpoint(tick);
            if (world.ok()) return go_on(*std::move(world));
            last = world.error();
            remarks_.push_back(said("the checkpoint of tick " + std::to_string(tick), last));
        }
        return last;
    }

private:
    Result<RecoveredWorld> from_checkpoint(std::uint32_t tick) {
        const Result<Checkpoint> kept = store_.checkpoint(stored_.id, tick);
        if (!kept.ok()) return kept.error();
        Result<DecodedCheckpoint> saved = decode_checkpoint(kept->exact, kept->hash);
        if (!saved.ok()) return saved.error();
        if (Status s = saved->bodies.set_threads(options_.threads); !s.ok()) return s.error();
        Result<HostedWorld> world =
            HostedWorld::restore(std::move(saved->bodies), saved->host_state, record_.limits,
                                 record_.scene->hz, record_.work_per_second);
        if (!world.ok()) return world.error();
        return RecoveredWorld{.world = *std::move(world),
                              .tick = kept->tick,
                              .checkpoint = kept->tick,
                              .sequence = kept->sequence};
    }

    Result<RecoveredWorld> go_on(RecoveredWorld world) {
        if (stored_.engine != build_engine_id())
            remarks_.push_back("it was kept by \"" + stored_.engine + "\" and goes on with \"" +
                               build_engine_id() +
                               "\": what is done again may come out a little otherwise");
        if (Status s = find_chain(world); !s.ok()) return s.error();
        for (bool more = true; more;) {
            const Result<std::vector<JournalEntry>> entries =
                store_.entries(stored_.id, world.sequence, entries_bytes_max);
            if (!entries.ok()) {
                remarks_.push_back(
                    said("what was done after tick " + std::to_string(world.tick) + " is lost",
                         entries.error()));
                break;
            }
            more = !entries->empty();
            for (const JournalEntry& entry : *entries)
                if (!more || !(more = apply(entry, world))) break;
        }
        world.warnings = std::move(remarks_);
        return world;
    }

    // The chain of the entry that the checkpoint ends with.
    Status find_chain(RecoveredWorld& world) {
        if (world.sequence == 0) return {};
        const Result<std::vector<JournalEntry>> last =
            store_.entries(stored_.id, world.sequence - 1, 0);
        if (!last.ok()) return last.error();
        if (!last->empty() && last->front().sequence == world.sequence)
            world.chain = last->front().chain;
        return {};
    }

    // False: the world goes no further.
    bool apply(const JournalEntry& entry, RecoveredWorld& world) {
        const auto lost = [&](const Error& error) {
            remarks_.push_back(
                said("what was done after tick " + std::to_string(world.tick) + " is lost", error));
            return false;
        };
        const Result<std::string> data = decompress(entry.data, entry_bytes_max);
        if (!data.ok()) return lost(data.error());
        const Result<JournalSegment> batch = decode_journal(*data);
        if (!batch.ok()) return lost(batch.error());
        if (entry.first_tick != world.tick + 1 || entry.last_tick < entry.first_tick)
            return lost({ErrorCode::corrupt_data, "entry " + std::to_string(entry.sequence) +
                                                      " is of ticks " +
                                                      std::to_string(entry.first_tick) + " to " +
                                                      std::to_string(entry.last_tick)});
        if (batch->rewind) {
            if (options_.last_tick && world.tick >= *options_.last_tick) return false;
            if (Status s = rewind_to(*batch->rewind, entry, world); !s.ok()) return lost(s.error());
        }
        auto tick = batch->ticks.begin();
        auto paused_ticks = batch->paused_ticks.begin();
        while (world.tick < entry.last_tick) {
            if (options_.last_tick && world.tick >= *options_.last_tick) return false;
            const std::uint32_t now = ++world.tick;
            while (paused_ticks != batch->paused_ticks.end() && paused_ticks->last < now)
                ++paused_ticks;
            const bool stands =
                paused_ticks != batch->paused_ticks.end() && paused_ticks->first <= now;
            const bool busy = tick != batch->ticks.end() && tick->tick == now;
            static const JournaledTick quiet;
            const JournaledTick& done = busy ? *tick++ : quiet;
            replay(world.world, {now, done.commands}, stands);
        }
        world.sequence = entry.sequence;
        world.chain = entry.chain;
        return true;
    }

    Status rewind_to(const Rewind& rewind, const JournalEntry& entry, RecoveredWorld& world) {
        const std::string from_to = "tick " + std::to_string(rewind.tick) + " went back to tick " +
                                    std::to_string(rewind.to);
        if (rewind.tick != entry.first_tick || rewind.tick != entry.last_tick)
            return Error{ErrorCode::corrupt_data, from_to + " in an entry of others"};
        if (options_.rewinds_max == 0)
            return Error{ErrorCode::resource_exhausted,
                         from_to + ": too many such lie within one another"};
        Result<RecoveredWorld> then = recover_world(store_, stored_, record_,
                                                    {.last_tick = rewind.to,
                                                     .threads = options_.threads,
                                                     .rewinds_max = options_.rewinds_max - 1,
                                                     .may_apply = options_.may_apply});
        if (!then.ok()) return Error{then.error().code, from_to + ": " + then.error().message};
        if (then->tick != rewind.to)
            return Error{ErrorCode::not_found, from_to + ", which is not kept any longer"};
        then->world.continue_from(world.world);
        world.world = std::move(then->world);
        world.tick = rewind.tick;
        if (options_.after_tick) options_.after_tick(world.world, world.tick);
        return {};
    }

    void replay(HostedWorld& world, const JournaledTick& tick, bool stands) {
        const bool admitted = !options_.may_apply || options_.may_apply(tick);
        for (const JournaledCommand& command : tick.commands) {
            if (admitted)
                world.replay(command);
            else if (command.sequence != 0)  // nobody says it again
                world.replay({command.client, command.sequence, std::nullopt});
        }
        // One that is refused was refused then, too.
        if (!stands) static_cast<void>(world.step(1 / record_.scene->hz, tick.tick + 1).ok());
        static_cast<void>(world.newly_quarantined());
        if (options_.after_tick) options_.after_tick(world, tick.tick);
    }

    WorldStorage& store_;
    const StoredWorld& stored_;
    const WorldDefinition& record_;
    const RecoveryOptions& options_;
    std::vector<std::string> remarks_;
};

}  // namespace

Result<RecoveredWorld> recover_world(WorldStorage& store, const StoredWorld& stored,
                                     const WorldDefinition& record,
                                     const RecoveryOptions& options) {
    return Recovery(store, stored, record, options).run();
}

}  // namespace jostle::server
