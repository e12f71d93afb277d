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
// Entities that the original run creates while a world is replayed without some inputs.
constexpr std::uint32_t original_ids_max = 1 << 20;

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
        for (const OmittedInputs& omitted : options_.omitted)
            std::erase_if(*ticks, [&](std::uint32_t t) { return t >= omitted.first_tick; });
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

    // Returns as much of the journal as can be replayed.
    RecoveredWorld resume(RecoveredWorld world) {
        warnings_ = std::move(world.warnings);
        replay_entries(world);
        world.warnings = std::move(warnings_);
        return world;
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
        replay_entries(world);
        world.warnings = std::move(warnings_);
        return world;
    }

    void replay_entries(RecoveredWorld& world) {
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
        if (segment->rewind || segment->undo) {
            if (options_.last_tick && world.tick >= *options_.last_tick) return false;
            Status done = segment->rewind ? rewind_to(*segment->rewind, entry, world)
                                          : undo(*segment->undo, entry, world);
            // The checkpoint of that tick contains the result.
            if (!done.ok() && done.error().code == ErrorCode::not_found &&
                (segment->rewind ? is_before_omitted(segment->rewind->to)
                                 : options_.omitted.empty()))
                done = load_result(entry, world, done);
            if (!done.ok()) return lost(done.error());
            if (options_.after_tick) options_.after_tick(world.world, world.tick);
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
            if (Status s = replay(world, {now, done.commands}, paused); !s.ok())
                return lost(s.error());
        }
        ASSERT(world.tick == entry.last_tick);
        world.sequence = entry.sequence;
        world.chain = entry.chain;
        return true;
    }

    // The world after `last_tick`, from an older checkpoint than the one of this recovery if
    // necessary.
    Result<RecoveredWorld> past(std::uint32_t last_tick, std::vector<OmittedInputs> omitted,
                                const std::string& context) {
        if (options_.rewinds_max == 0)
            return Error{ErrorCode::resource_exhausted,
                         context + ": rewinds are nested too deeply"};
        std::erase_if(omitted,
                      [&](const OmittedInputs& inputs) { return inputs.first_tick > last_tick; });
        const bool has_omitted = !omitted.empty();
        Result<RecoveredWorld> past = recover_world(storage_, stored_, definition_,
                                                    {.last_tick = last_tick,
                                                     .threads = options_.threads,
                                                     .rewinds_max = options_.rewinds_max - 1,
                                                     .omitted = std::move(omitted),
                                                     .may_apply = options_.may_apply});
        if (!past.ok()) return Error{past.error().code, context + ": " + past.error().message};
        if (past->tick != last_tick || (has_omitted && !past->without))
            return Error{ErrorCode::not_found, context + ": that tick is no longer retained"};
        return past;
    }

    Status rewind_to(const Rewind& rewind, const JournalEntry& entry, RecoveredWorld& world) {
        const std::string context = "rewind from tick " + std::to_string(rewind.tick) +
                                    " to tick " + std::to_string(rewind.to);
        if (rewind.tick != entry.first_tick || rewind.tick != entry.last_tick)
            return Error{ErrorCode::corrupt_data, context + " in an entry with other ticks"};
        Result<RecoveredWorld> found = past(rewind.to, options_.omitted, context);
        if (!found.ok()) return found.error();
        continue_from(world, std::move(found->world), std::move(found->without));
        world.tick = rewind.tick;
        return {};
    }

    Status undo(const Undo& undo, const JournalEntry& entry, RecoveredWorld& world) {
        const std::string context = "undo in tick " + std::to_string(undo.tick) + " of client " +
                                    std::to_string(undo.client) + " from tick " +
                                    std::to_string(undo.first_tick);
        if (undo.tick != entry.first_tick || undo.tick != entry.last_tick)
            return Error{ErrorCode::corrupt_data, context + " in an entry with other ticks"};
        std::vector<OmittedInputs> omitted{{undo.client, undo.first_tick, undo.tick - 1}};
        Result<RecoveredWorld> undone = past(undo.tick - 1, omitted, context);
        if (!undone.ok()) return undone.error();
        std::optional<WorldWithout> without;
        if (world.without) {
            omitted.insert(omitted.end(), options_.omitted.begin(), options_.omitted.end());
            Result<RecoveredWorld> both = past(undo.tick - 1, omitted, context);
            if (!both.ok()) return both.error();
            without = std::move(both->without);
        }
        continue_from(world, std::move(undone->without->world), std::move(without));
        world.tick = undo.tick;
        return {};
    }

    static void continue_from(RecoveredWorld& world, HostedWorld next,
                              std::optional<WorldWithout> without) {
        next.continue_from(world.world);
        if (without)
            without->world.continue_from(world.without ? world.without->world : world.world);
        world.world = std::move(next);
        world.without = std::move(without);
    }

    bool is_before_omitted(std::uint32_t tick) const {
        return std::ranges::all_of(options_.omitted, [&](const OmittedInputs& inputs) {
            return tick < inputs.first_tick;
        });
    }

    Status load_result(const JournalEntry& entry, RecoveredWorld& world, const Status& failed) {
        Result<RecoveredWorld> result = from_checkpoint(entry.last_tick);
        if (!result.ok() || result->is_portable || result->sequence != entry.sequence)
            return failed;
        world.world = std::move(result->world);
        world.without.reset();
        world.tick = entry.last_tick;
        return {};
    }

    Status replay(RecoveredWorld& world, const JournaledTick& tick, bool paused) {
        if (Status s = split(world, tick.tick); !s.ok()) return s;
        const bool admitted = !options_.may_apply || options_.may_apply(tick);
        for (const JournaledCommand& command : tick.commands) {
            if (admitted) {
                const EntityId affected = world.world.replay(command);
                if (world.without && command.action)
                    replay_without(world, command, tick.tick, affected);
            } else if (command.sequence != 0) {  // a command without a sequence is never resent
                world.world.replay({command.client, command.sequence, std::nullopt});
            }
        }
        step(world.world, tick.tick, paused);
        if (world.without) step(world.without->world, tick.tick, paused);
        if (options_.after_tick) options_.after_tick(world.world, tick.tick);
        return {};
    }

    void step(HostedWorld& world, std::uint32_t tick, bool paused) {
        // A step that is rejected now was rejected in the original run, too.
        if (!paused) static_cast<void>(world.step(1 / definition_.scene->hz, tick + 1).ok());
        static_cast<void>(world.newly_quarantined());
    }

    // --- the world without the inputs of clients ---

    // Before the first omitted tick both worlds are the same.
    Status split(RecoveredWorld& world, std::uint32_t tick) {
        for (const OmittedInputs& omitted : options_.omitted) {
            if (tick < omitted.first_tick) continue;
            if (!world.without)
                if (Status s = copy_world(world, tick); !s.ok()) return s;
            auto& begun = world.without->begun;
            if (std::ranges::find(begun, omitted) != begun.end()) continue;
            begun.push_back(omitted);
            world.without->world.replay({omitted.client, 0, DisconnectCommand{}});
        }
        return {};
    }

    Status copy_world(RecoveredWorld& world, std::uint32_t tick) {
        const Result<Checkpoint> copy = make_checkpoint(world.world, tick - 1, 0);
        if (!copy.ok()) return copy.error();
        Result<DecodedCheckpoint> saved = decode_checkpoint(copy->exact, copy->hash);
        if (!saved.ok()) return saved.error();
        if (Status s = saved->bodies.set_threads(options_.threads); !s.ok()) return s;
        Result<HostedWorld> without =
            HostedWorld::restore(std::move(saved->bodies), saved->host_state, definition_.limits,
                                 definition_.scene->hz, definition_.work_per_second);
        if (!without.ok()) return without.error();
        // Spawned bodies get the ids of the original run, and bodies of modules get later ones.
        without->skip_ids(original_ids_max);
        world.without.emplace(WorldWithout{*std::move(without)});
        return {};
    }

    void replay_without(RecoveredWorld& world, const JournaledCommand& command, std::uint32_t tick,
                        EntityId affected) const {
        const bool is_omitted =
            !ends_something(*command.action) &&
            std::ranges::any_of(options_.omitted, [&](const OmittedInputs& omitted) {
                return omitted.client == command.client && omitted.first_tick <= tick &&
                       tick <= omitted.last_tick;
            });
        if (is_omitted) {
            world.omitted++;
            return;
        }
        const bool spawns = std::holds_alternative<SpawnCommand>(*command.action) ||
                            std::holds_alternative<CloneCommand>(*command.action);
        // Its client knows that the spawn was refused.
        if (spawns && affected == 0) return;
        world.without->world.replay(command, spawns ? affected : 0);
    }

    static bool ends_something(const Action& action) {
        const auto* const possess = std::get_if<PossessCommand>(&action);
        // Decisions about the members of a room outlive an undo.
        if (const auto* const room = std::get_if<RoomCommand>(&action))
            return !std::holds_alternative<CleanUpBodies>(room->kind);
        return std::holds_alternative<ReleaseCommand>(action) ||
               std::holds_alternative<LeaveCommand>(action) ||
               std::holds_alternative<DisconnectCommand>(action) ||
               std::holds_alternative<JoinCommand>(action) || (possess && possess->entity == 0);
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

RecoveredWorld continue_recovery(WorldStorage& storage, const StoredWorld& stored,
                                 const WorldDefinition& definition, const RecoveryOptions& options,
                                 RecoveredWorld world) {
    return Recovery(storage, stored, definition, options).resume(std::move(world));
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
