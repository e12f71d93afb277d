// SPDX-License-Identifier: MIT
#include "server/recovery/world_archive.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/serialization.h"
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/journal_codec.h"
#include "server/recovery/world_storage_copy.h"
#include "server/storage/compression.h"
#include "server/storage/journal_chain.h"
#include "server/storage/online_backup.h"
#include "server/util/bytes.h"
#include "server/util/log.h"

namespace jostle::server {
namespace {

constexpr auto timeout = std::chrono::seconds(5);
constexpr ClientId ids_per_reservation = 1 << 16;
constexpr const char* secret_note = "secret";
constexpr const char* clients_note = "clients";
constexpr std::size_t secret_bytes = 32;
constexpr const char* how_to_accept =
    "; restore a backup, or start once with --accept-damage to continue with what can be read";

PutNote clients_note_of(ClientId first_free) {
    ByteWriter to;
    to.number(first_free);
    return {clients_note, to.take()};
}

std::vector<PreviousClient> previous_clients_of(const SavedHostState& host_state) {
    std::vector<PreviousClient> previous_clients;
    for (const auto& [client, sequence] : clients_of(host_state))
        previous_clients.push_back({client, sequence});
    return previous_clients;
}

Error slow() {
    return {ErrorCode::unavailable, "the database does not respond; retry later"};
}

// Copies the files as they are, so that nothing is lost by continuing.
Status accept_damage(SqliteStorage& storage, const std::string& path) {
    const std::string aside = path + ".damaged-" + std::to_string(std::time(nullptr));
    for (const char* suffix : {"", "-wal", ".head"}) {
        std::error_code error;
        if (!std::filesystem::exists(path + suffix, error)) continue;
        std::filesystem::copy_file(path + suffix, aside + suffix, error);
        if (error)
            return Error{ErrorCode::unavailable, "cannot copy the damaged file to " + aside +
                                                     suffix + ": " + error.message()};
    }
    const StorageDamage damage = storage.damage();
    log_warn("{}: damage is accepted; the files as they were are {}*", path, aside);
    if (!damage.store.empty()) log_warn("{}: {}", path, damage.store);
    for (const auto& [world, reason] : damage.worlds) log_warn("world {}: {}", world, reason);
    return storage.accept_damage();
}

// The rewinds and undos in a journal: ticks in which they happened, and the oldest tick that a
// replay of them starts from.
struct Jumps {
    std::vector<std::uint32_t> ticks;  // ascending
    std::uint32_t oldest = 0xffffffff;
};
Result<Jumps> jumps_in(WorldStorageCopy& copy, const std::string& id) {
    Jumps jumps;
    const auto entries = copy.entries(id, 0, 0);
    if (!entries.ok()) return entries.error();
    for (const JournalEntry& entry : *entries) {
        const Result<std::string> data = decompress(entry.data, std::size_t{64} << 20);
        if (!data.ok()) return data.error();
        const Result<JournalSegment> segment = decode_journal(*data);
        if (!segment.ok()) return segment.error();
        if (segment->rewind) jumps.oldest = std::min(jumps.oldest, segment->rewind->to);
        if (segment->undo) jumps.oldest = std::min(jumps.oldest, segment->undo->first_tick - 1);
        if (segment->rewind || segment->undo) jumps.ticks.push_back(entry.last_tick);
    }
    return jumps;
}

// "w12-ab34" returns 12.
std::uint32_t number_of(const std::string& id) {
    std::uint32_t number = 0;
    if (!id.empty()) std::from_chars(id.data() + 1, id.data() + id.size(), number);
    return number;
}

}  // namespace

struct WorldArchive::ArchivedUndo : PreparedUndo {
    ArchivedUndo(WorldDefinition of, RecoveryOptions with, RecoveredWorld recovered)
        : definition(std::move(of)), options(std::move(with)), world(std::move(recovered)) {}

    WorldDefinition definition;
    RecoveryOptions options;
    RecoveredWorld world;
};

WorldArchive::WorldArchive(const PersistenceSettings& settings, const HostLimits& limits,
                           int threads, std::function<void()> on_results_sent)
    : path_(settings.database),
      limits_(limits),
      threads_(threads),
      accepts_damage_(settings.accept_damage),
      journal_settings_{.checkpoint_interval_seconds = settings.checkpoint_interval_seconds,
                        .replay_seconds_max = settings.replay_seconds_max,
                        .history_retention_hours = settings.history_retention_hours,
                        .on_results_sent = std::move(on_results_sent)},
      checkpoints_(std::make_unique<CheckpointWriter>()) {}

WorldArchive::~WorldArchive() {
    CrashMarkers::count_fatal_signals(nullptr);
    checkpoints_.reset();
    writer_.reset();
}

Result<std::unique_ptr<WorldArchive>> WorldArchive::open(const PersistenceSettings& settings,
                                                         const HostLimits& limits, int threads,
                                                         std::function<void()> on_results_sent,
                                                         const char* file_system) {
    Result<std::unique_ptr<SqliteStorage>> storage = SqliteStorage::open(
        settings.database,
        {.durability = settings.durability == "process" ? Durability::process : Durability::machine,
         .file_system = file_system});
    if (!storage.ok()) return storage.error();
    std::unique_ptr<WorldArchive> archive(
        new WorldArchive(settings, limits, threads, std::move(on_results_sent)));
    const auto failed = [&](const Error& error) {
        return Error{error.code, settings.database + ": " + error.message};
    };
    Result<std::unique_ptr<CrashMarkers>> marks = CrashMarkers::open(settings.database + ".marks");
    if (!marks.ok()) return marks.error();
    archive->marks_ = *std::move(marks);
    if (!archive->marks_->is_stored())
        log_warn("{}.marks: no space for it; crashes until the next start are not counted",
                 settings.database);
    if (!(*storage)->damage().is_none() && settings.accept_damage)
        if (Status s = accept_damage(**storage, settings.database); !s.ok())
            return failed(s.error());
    const Result<std::vector<StoredWorld>> worlds = (*storage)->worlds();
    if (!worlds.ok()) return failed(worlds.error());
    // The journals of loaded worlds refer to the writer, so it must exist first; its queue is
    // empty.
    SqliteStorage& opened = **storage;
    const StorageDamage damage = opened.damage();
    archive->writer_ =
        std::make_unique<StorageWriter>(*std::move(storage), StorageWriterSettings{});
    archive->store_damage_ = damage.store;
    if (!damage.store.empty())
        for (const StoredWorld& world : *worlds)
            archive->set_aside(world.id, world.name, damage.store);
    if (!damage.store.empty()) {
        archive->damage_ = "the database is damaged: " + damage.store + how_to_accept;
        log_error("{}", *archive->damage_);
    }
    Status done;
    const bool is_started = archive->writer_->run_on_writer(
        [&](WorldStorage&) { done = archive->read_notes(opened); }, timeout);
    if (!is_started) done = slow();
    if (!done.ok()) return failed(done.error());
    CrashMarkers::count_fatal_signals(archive->marks_.get());
    if (!damage.store.empty()) return archive;
    if (Status s = archive->load_worlds(opened, damage, *worlds); !s.ok()) return failed(s.error());
    for (StorageChange& change : std::exchange(archive->delayed_, {}))
        if (!archive->writer_->push(std::move(change), nullptr)) return failed(slow());
    return archive;
}

Status WorldArchive::read_notes(WorldStorage& storage) {
    const auto secret = storage.note(secret_note);
    if (!secret.ok()) return secret.error();
    const auto clients = storage.note(clients_note);
    if (!clients.ok()) return clients.error();
    if (*secret) {
        secret_ = **secret;
    } else {
        secret_.resize(secret_bytes);
        if (::getentropy(secret_.data(), secret_.size()) != 0)
            return Error{ErrorCode::unavailable, "the operating system returned no random bytes"};
    }
    if (*clients) {
        ByteReader from(**clients);
        first_client_ = std::max<ClientId>(1, from.small());
        if (!from.ok() || !from.at_end())
            return Error{ErrorCode::corrupt_data, "the note of client ids is corrupt"};
    }
    if (secret_.size() != secret_bytes || first_client_ > 0xffffffff - 2 * ids_per_reservation)
        return Error{ErrorCode::corrupt_data, "a note is out of range"};
    reserved_ = first_client_ + ids_per_reservation;
    ASSERT(reserved_ > first_client_);
    if (!store_damage_.empty()) return {};
    std::vector<StorageChange> changes{PutNote{secret_note, secret_}, clients_note_of(reserved_)};
    // Tokens that a new secret seals must survive this process.
    return *secret ? write_or_queue(storage, std::move(changes)) : storage.write(changes);
}

Status WorldArchive::write_or_queue(WorldStorage& storage, std::vector<StorageChange> changes) {
    Status done = storage.write(changes);
    if (done.ok() || (done.error().code != ErrorCode::unavailable &&
                      done.error().code != ErrorCode::resource_exhausted))
        return done;
    std::ranges::move(changes, std::back_inserter(delayed_));
    return {};
}

void WorldArchive::set_aside(const std::string& id, const std::string& name,
                             const std::string& reason) {
    log_error("world {} \"{}\" is not resumed; its data stays in the database: {}", id, name,
              reason);
    names_aside_.push_back(name);
    damage_ = "world " + id + " \"" + name + "\" is not resumed: " + reason;
    if (names_aside_.size() > 1)
        damage_ =
            std::to_string(names_aside_.size()) + " worlds are not resumed; the last: " + *damage_;
}

std::optional<std::string> WorldArchive::name_conflict(const std::string& name) const {
    if (!store_damage_.empty()) return "the database is damaged: " + store_damage_;
    if (std::ranges::find(names_aside_, name) == names_aside_.end()) return std::nullopt;
    return "the database has a world \"" + name + "\" that could not be resumed";
}

void WorldArchive::on_client(ClientId next) {
    ASSERT(writer_);
    ClientId reserved = reserved_;
    if (next + ids_per_reservation / 4 < reserved || reserved > 0xffffffff - ids_per_reservation)
        return;
    const ClientId more = reserved + ids_per_reservation;
    ASSERT(more > reserved);
    if (reserved_.compare_exchange_strong(reserved, more) &&
        !writer_->push(clients_note_of(more), nullptr))
        reserved_ = reserved;
}

bool WorldArchive::flush(Clock::duration within) {
    const Clock::time_point until = Clock::now() + within;
    return checkpoints_->wait(within) && writer_->flush(until - Clock::now());
}

// --- persisted worlds ---

// A corrupt world does not prevent the others from loading. A disk that cannot be read is a
// temporary fault: loading fails as a whole, so that all worlds can be loaded later.
Status WorldArchive::load_worlds(WorldStorage& storage, const StorageDamage& damage,
                                 const std::vector<StoredWorld>& worlds) {
    for (const StoredWorld& stored : worlds) {
        const Clock::time_point began = Clock::now();
        if (const auto at = damage.worlds.find(stored.id); at != damage.worlds.end()) {
            set_aside(stored.id, stored.name, at->second + how_to_accept);
            continue;
        }
        Result<PersistedWorld> persisted = Error{};
        writer_->run_on_writer([&](WorldStorage&) { persisted = load_world(storage, stored); },
                               std::chrono::hours(1));
        if (!persisted.ok() && (persisted.error().code == ErrorCode::unavailable ||
                                persisted.error().code == ErrorCode::resource_exhausted))
            return persisted.error();
        if (!persisted.ok()) {
            set_aside(stored.id, stored.name, persisted.error().message);
            continue;
        }
        log_info("world {} \"{}\" resumed after tick {}, expecting {} clients; {:.0f} ms",
                 stored.id, stored.name, persisted->start.tick, persisted->previous_clients.size(),
                 to_ms(Clock::now() - began));
        loaded_.push_back(*std::move(persisted));
    }
    std::ranges::stable_sort(loaded_, {}, [](const PersistedWorld& persisted) {
        return number_of(persisted.start.label.id);
    });
    return {};
}

Result<PersistedWorld> WorldArchive::load_world(WorldStorage& storage, const StoredWorld& stored) {
    Result<WorldDefinition> definition = decode_world_definition(stored.settings);
    const bool is_unsupported =
        !definition.ok() && definition.error().code == ErrorCode::failed_precondition;
    if (is_unsupported) {
        const std::string why = definition.error().message;
        definition = portable_definition(storage, stored, limits_);
        if (!definition.ok())
            return Error{definition.error().code, why + "; " + definition.error().message};
        log_warn("world {} \"{}\": {}; its portable checkpoint replaces it", stored.id, stored.name,
                 why);
    }
    if (!definition.ok()) return definition.error();
    Result<RecoveredWorld> found = recover(storage, stored, *definition, is_unsupported);
    if (!found.ok()) return found.error();
    definition->scene = found->scene;
    definition->limits = limits_;
    found->world.set_limits(limits_);
    StoredWorld now{.id = stored.id,
                    .name = stored.name,
                    .epoch = stored.epoch + 1,
                    .engine = build_engine_id(),
                    .settings = encode_world_definition(*definition)};
    std::vector<StorageChange> changes{TruncateJournal{stored.id, found->tick, found->sequence}};
    // From here on the world is like one that was never stopped: a new checkpoint contains
    // everything so far, unless nothing changed.
    const bool unchanged = found->tick == found->checkpoint && !found->is_portable &&
                           now.engine == stored.engine && now.settings == stored.settings;
    if (!unchanged) {
        Result<Checkpoint> checkpoint = make_checkpoint(found->world, found->tick, found->sequence);
        if (!checkpoint.ok()) return checkpoint.error();
        changes.emplace_back(PutCheckpoint{stored.id, *std::move(checkpoint)});
    }
    Result<std::vector<std::uint32_t>> ticks = storage.checkpoint_ticks(stored.id);
    if (!ticks.ok()) return ticks.error();
    // Older checkpoints contain ids of another scene.
    if (found->is_portable) {
        changes.emplace_back(Trim{stored.id, found->tick});
        ticks->clear();
    }
    std::erase_if(*ticks, [&](std::uint32_t tick) { return tick >= found->tick; });
    ticks->insert(ticks->begin(), found->tick);
    std::ranges::reverse(*ticks);
    ASSERT(std::ranges::is_sorted(*ticks));
    const JournalPosition position{.epoch = now.epoch,
                                   .sequence = found->sequence,
                                   .chain = found->chain,
                                   .checkpoints = *std::move(ticks)};
    changes.emplace_back(PutWorld{std::move(now)});
    if (Status s = write_or_queue(storage, std::move(changes)); !s.ok()) return s.error();
    marks_->of(stored.id).forget();

    std::vector<PreviousClient> previous_clients =
        previous_clients_of(found->world.host_state(found->tick));
    PersistedWorld persisted{.start = {.label = {stored.id, stored.name, definition->owner},
                                       .scene = definition->scene,
                                       .world = std::move(found->world),
                                       .tick = found->tick},
                             .previous_clients = std::move(previous_clients)};
    persisted.start.world_journal = make_journal(persisted.start, position);
    return persisted;
}

// A tick that crashed twice in a row is replayed without its commands. If the fault lies further
// back, each further crash doubles the number of quarantined ticks.
Result<RecoveredWorld> WorldArchive::recover(WorldStorage& storage, const StoredWorld& stored,
                                             const WorldDefinition& definition,
                                             bool portable_only) {
    const CrashMarker mark = marks_->of(stored.id);
    const std::uint32_t crashes = mark.crashes(), last = mark.crashed_tick();
    const std::uint32_t ticks = crashes < 2 ? 0 : 1U << std::min(crashes - 2, 30U);
    RecoveryOptions options{.threads = threads_, .portable_only = portable_only};
    options.may_apply = [&](const JournaledTick& tick) {
        mark.begin(tick.tick);
        const bool is_suspect = tick.tick <= last && last - tick.tick < ticks;
        if (is_suspect && !tick.commands.empty()) quarantine_tick(stored, tick);
        return !is_suspect;
    };
    Result<RecoveredWorld> found = recover_world(storage, stored, definition, options);
    mark.end();
    if (!found.ok()) return found;
    if (ticks > 0)
        found->warnings.push_back("it crashed " + std::to_string(crashes) + " times in tick " +
                                  std::to_string(last) + ": the commands of the last " +
                                  std::to_string(ticks) + " ticks up to it are quarantined");
    for (const std::string& warning : found->warnings)
        log_error("world {} \"{}\": {}", stored.id, stored.name, warning);
    if (found->is_cut && !accepts_damage_)
        return Error{ErrorCode::corrupt_data, found->warnings.back() + how_to_accept};
    return found;
}

void WorldArchive::quarantine_tick(const StoredWorld& stored, const JournaledTick& tick) {
    log_error("world {} \"{}\": {} commands of tick {} are quarantined", stored.id, stored.name,
              tick.commands.size(), tick.tick);
    writer_->push(PutNote{"aside " + stored.id + " " + std::to_string(tick.tick),
                          encode_journal({{tick}, {}})},
                  nullptr);
}

std::shared_ptr<WorldJournal> WorldArchive::make_journal(const WorldStart& start,
                                                         const JournalPosition& position) {
    ASSERT(writer_ && checkpoints_ && marks_);
    return std::make_shared<StoredWorldJournal>(start.label.id, start.scene->hz, position, *writer_,
                                                *checkpoints_, marks_->of(start.label.id),
                                                journal_settings_);
}

// --- created, deleted and failed worlds ---

Status WorldArchive::open(WorldStart& start) {
    const std::string& id = start.label.id;
    if (const auto conflict = name_conflict(start.label.name))
        return Error{ErrorCode::failed_precondition, *conflict};
    Result<Checkpoint> checkpoint = make_checkpoint(start.world, start.tick, 0);
    if (!checkpoint.ok()) return checkpoint.error();
    const WorldDefinition definition{.owner = start.label.owner,
                                     .scene = start.scene,
                                     .limits = limits_,
                                     .work_per_second = start.world.work_per_second()};
    const bool pushed = writer_->push(PutWorld{{.id = id,
                                                .name = start.label.name,
                                                .epoch = 1,
                                                .engine = build_engine_id(),
                                                .settings = encode_world_definition(definition)}},
                                      nullptr) &&
                        writer_->push(PutCheckpoint{id, *std::move(checkpoint)}, nullptr);
    if (!pushed || !writer_->flush(timeout)) {
        writer_->push(DropWorld{id}, nullptr);
        return Error{ErrorCode::unavailable,
                     "the world cannot be persisted: " +
                         failure_reason().value_or("the database is slow; retry later")};
    }
    start.world_journal = make_journal(start, {.epoch = 1, .checkpoints = {start.tick}});
    return {};
}

void WorldArchive::drop(const std::string& id) {
    checkpoints_->wait(timeout);
    marks_->drop(id);
    if (!writer_->push(DropWorld{id}, nullptr) || !writer_->flush(timeout))
        log_error("world {}: cannot persist its deletion; it may reappear after a restart", id);
}

Result<std::unique_ptr<WorldStorage>> WorldArchive::copy_of(const std::string& id,
                                                            std::uint32_t last_tick) {
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    writer_->run_on_writer(
        [&](WorldStorage& storage) {
            copy = WorldStorageCopy::of(storage, id, 2, last_tick, last_tick);
        },
        timeout);
    if (!copy.ok()) return copy.error();
    return std::unique_ptr<WorldStorage>(*std::move(copy));
}

Result<HostedWorld> WorldArchive::world_at(const std::string& id, std::uint32_t tick) {
    const Result<std::unique_ptr<WorldStorage>> copy = copy_of(id, tick);
    if (!copy.ok()) return copy.error();
    const Result<std::vector<StoredWorld>> stored = (*copy)->worlds();
    if (!stored.ok()) return stored.error();
    const Result<WorldDefinition> definition = decode_world_definition(stored->front().settings);
    if (!definition.ok()) return definition.error();
    Result<RecoveredWorld> found = recover_world(**copy, stored->front(), *definition,
                                                 {.last_tick = tick, .threads = threads_});
    if (!found.ok()) return found.error();
    if (found->tick != tick)
        return Error{ErrorCode::not_found, "tick " + std::to_string(tick) +
                                               " is not retained; the last retained tick is " +
                                               std::to_string(found->tick)};
    found->world.set_limits(limits_);
    return std::move(found->world);
}

Result<WorldArchive::StoppedWorld> WorldArchive::load_stopped_world(const std::string& id) {
    checkpoints_->wait(timeout);
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    Result<std::vector<std::uint32_t>> ticks = slow();
    writer_->run_on_writer(
        [&](WorldStorage& storage) {
            copy = WorldStorageCopy::of(storage, id, 2);
            ticks = storage.checkpoint_ticks(id);
        },
        timeout);
    if (!copy.ok()) return copy.error();
    if (!ticks.ok()) return ticks.error();
    const StoredWorld stored = (*copy)->worlds().value().front();
    Result<WorldDefinition> definition = decode_world_definition(stored.settings);
    if (!definition.ok()) return definition.error();
    Result<RecoveredWorld> found = recover(**copy, stored, *definition);
    if (!found.ok()) return found.error();
    std::ranges::reverse(*ticks);
    return StoppedWorld{stored, *std::move(definition), *std::move(found), *std::move(ticks)};
}

WorldStart WorldArchive::start_of(StoppedWorld last) {
    WorldStart start{.label = {last.stored.id, last.stored.name, last.definition.owner},
                     .scene = last.definition.scene,
                     .world = std::move(last.found.world),
                     .tick = last.found.tick};
    start.world_journal = make_journal(start, {.epoch = last.stored.epoch,
                                               .sequence = last.found.sequence,
                                               .chain = last.found.chain,
                                               .checkpoints = std::move(last.checkpoints)});
    return start;
}

// The writer copies some pages at a time and writes changes in between.
Result<TemporaryFile> WorldArchive::back_up() {
    constexpr int pages_per_step = 256;                     // 1 MiB
    const std::string path = path_ + ".backup-unfinished";  // a killed process may have left one
    std::unique_ptr<OnlineBackup> backup;
    Status done;
    const auto on_writer = [&](auto&& function) {
        const auto call = [&](WorldStorage& storage) { done = function(storage); };
        if (!writer_->run_on_writer(call, timeout)) done = slow();
        return done.ok();
    };
    // SQLite objects are used and destroyed on the writer's thread.
    const auto fail = [&] {
        const Status why = done;
        on_writer([&](WorldStorage&) {
            backup.reset();
            return Status();
        });
        return why.error();
    };
    ::unlink(path.c_str());
    const auto begin = [&](WorldStorage& storage) -> Status {
        auto begun = static_cast<SqliteStorage&>(storage).begin_backup(path);
        if (!begun.ok()) return begun.error();
        backup = *std::move(begun);
        return {};
    };
    if (!on_writer(begin)) return done.error();
    for (bool is_complete = false; !is_complete;)
        if (!on_writer([&](WorldStorage&) -> Status {
                const Result<bool> copied = backup->step(pages_per_step);
                if (!copied.ok()) return copied.error();
                is_complete = *copied;
                return is_complete ? backup->finish() : Status();
            }))
            return fail();
    TemporaryFile file(std::fopen(path.c_str(), "rb"));
    ::unlink(path.c_str());
    on_writer([&](WorldStorage&) {
        backup.reset();
        return Status();
    });
    if (!file) return Error{ErrorCode::unavailable, path + ": " + std::strerror(errno)};
    return file;
}

Result<WorldStart> WorldArchive::reload(const std::string& id) {
    Result<StoppedWorld> last = load_stopped_world(id);
    if (!last.ok()) return last.error();
    return start_of(*std::move(last));
}

// The journal only grows: an entry records the rewind or undo, and a checkpoint contains the state
// it leads to. Both are queued like any tick; if the process crashes before they are written, it
// did not happen.
Result<WorldStart> WorldArchive::continue_with(StoppedWorld last, HostedWorld next,
                                               JournalSegment why) {
    const std::string& id = last.stored.id;
    RecoveredWorld& found = last.found;
    next.continue_from(found.world);
    found.world = std::move(next);
    found.tick++;
    JournalEntry entry{.sequence = ++found.sequence,
                       .epoch = last.stored.epoch,
                       .first_tick = found.tick,
                       .last_tick = found.tick,
                       .data = compress(encode_journal(why))};
    found.chain = entry.chain = next_chain(found.chain, entry.data);
    Result<Checkpoint> checkpoint = make_checkpoint(found.world, found.tick, found.sequence);
    if (!checkpoint.ok()) return checkpoint.error();
    if (!writer_->push(AppendEntry{id, std::move(entry)}, nullptr))
        return Error{ErrorCode::unavailable, "the database does not keep up; retry later"};
    const bool pushed = writer_->push(PutCheckpoint{id, *std::move(checkpoint)}, nullptr);
    if (pushed) last.checkpoints.push_back(found.tick);
    WorldStart start = start_of(std::move(last));
    if (!pushed) start.world_journal->on_interrupted();  // requests a checkpoint in its first tick
    return start;
}

Result<WorldStart> WorldArchive::rewind(const std::string& id, std::uint32_t tick,
                                        HostedWorld past) {
    Result<StoppedWorld> last = load_stopped_world(id);
    if (!last.ok()) return last.error();
    const Rewind rewind{.tick = last->found.tick + 1, .to = tick};
    return continue_with(*std::move(last), std::move(past),
                         {.ticks = {}, .paused_ticks = {}, .rewind = rewind});
}

Result<std::unique_ptr<WorldStorageCopy>> WorldArchive::copy_since(const std::string& id,
                                                                   std::uint32_t tick) {
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    const auto read = [&](auto&& function) { return writer_->run_on_writer(function, timeout); };
    read([&](WorldStorage& storage) { copy = WorldStorageCopy::of(storage, id, 2, tick); });
    Jumps jumps;
    while (copy.ok()) {
        Result<Jumps> found = jumps_in(**copy, id);
        if (!found.ok()) return found.error();
        jumps = *std::move(found);
        if (jumps.oldest >= (*copy)->checkpoint_ticks(id).value().back()) break;
        Result<std::unique_ptr<WorldStorageCopy>> older = slow();
        read([&](WorldStorage& storage) {
            older = WorldStorageCopy::of(storage, id, 2, jumps.oldest);
        });
        if (!older.ok() && older.error().code == ErrorCode::not_found) break;
        copy = std::move(older);
    }
    if (!copy.ok()) return copy;
    read([&](WorldStorage& storage) {
        const std::uint32_t newest = (*copy)->checkpoint_ticks(id).value().front();
        for (const std::uint32_t jump : jumps.ticks)
            if (jump > newest)
                if (Result<Checkpoint> result = storage.checkpoint(id, jump); result.ok())
                    (*copy)->add(*std::move(result));
    });
    return copy;
}

Result<std::unique_ptr<PreparedUndo>> WorldArchive::prepare_undo(const std::string& id,
                                                                 ClientId client,
                                                                 std::uint32_t first_tick) {
    Result<std::unique_ptr<WorldStorageCopy>> copy = copy_since(id, first_tick - 1);
    if (!copy.ok()) return copy.error();
    const StoredWorld stored = (*copy)->worlds().value().front();
    Result<WorldDefinition> definition = decode_world_definition(stored.settings);
    if (!definition.ok()) return definition.error();
    RecoveryOptions options{.threads = threads_, .omitted = {{client, first_tick, 0xffffffff}}};
    Result<RecoveredWorld> found = recover_world(**copy, stored, *definition, options);
    if (!found.ok()) return found.error();
    if (found->is_cut)
        return Error{ErrorCode::failed_precondition, "cannot replay the world from tick " +
                                                         std::to_string(found->checkpoint) + ": " +
                                                         found->warnings.back()};
    auto undo = std::make_unique<ArchivedUndo>(*std::move(definition), std::move(options),
                                               *std::move(found));
    // Each pass replays the ticks of the previous one, so that few are left when the world stops.
    constexpr int passes_max = 8;
    const double few_ticks = undo->definition.scene->hz;
    for (int pass = 0; pass < passes_max; pass++) {
        const std::uint32_t tick = undo->world.tick;
        if (Status s = replay_new_ticks(id, *undo); !s.ok()) return s.error();
        if (undo->world.tick - tick < few_ticks) break;
    }
    if (undo->world.omitted == 0)
        return Error{ErrorCode::not_found, "client " + std::to_string(client) +
                                               " has no inputs since tick " +
                                               std::to_string(first_tick)};
    undo->inputs = undo->world.omitted;
    return std::unique_ptr<PreparedUndo>(std::move(undo));
}

Status WorldArchive::replay_new_ticks(const std::string& id, ArchivedUndo& undo) {
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    writer_->run_on_writer(
        [&](WorldStorage& storage) {
            copy = WorldStorageCopy::journal_of(storage, id, undo.world.sequence);
        },
        timeout);
    if (!copy.ok()) return copy.error();
    const StoredWorld stored = (*copy)->worlds().value().front();
    undo.world =
        continue_recovery(**copy, stored, undo.definition, undo.options, std::move(undo.world));
    undo.inputs = undo.world.omitted;
    if (!undo.world.is_cut) return {};
    return Error{ErrorCode::failed_precondition,
                 "the history is shorter than the time that the replay takes: " +
                     undo.world.warnings.back()};
}

Result<WorldStart> WorldArchive::undo(const std::string& id, PreparedUndo& prepared) {
    ArchivedUndo& undo = static_cast<ArchivedUndo&>(prepared);
    Result<StoppedWorld> last = load_stopped_world(id);
    if (!last.ok()) return last.error();
    const OmittedInputs& omitted = undo.options.omitted.front();
    if (Status s = replay_new_ticks(id, undo); !s.ok()) return s.error();
    // Both were replayed from different checkpoints.
    if (undo.world.tick != last->found.tick || physics::state_hash(undo.world.world.world()) !=
                                                   physics::state_hash(last->found.world.world()))
        return Error{ErrorCode::internal,
                     "the journal replays to tick " + std::to_string(undo.world.tick) +
                         " in another state than that of tick " + std::to_string(last->found.tick)};
    // A rewind to before the first undone tick was the last change.
    if (!undo.world.without)
        return Error{
            ErrorCode::failed_precondition,
            "the world has just been rewound to before tick " + std::to_string(omitted.first_tick)};
    const Undo entry{
        .tick = last->found.tick + 1, .first_tick = omitted.first_tick, .client = omitted.client};
    return continue_with(*std::move(last), std::move(undo.world.without->world),
                         {.ticks = {}, .paused_ticks = {}, .rewind = {}, .undo = entry});
}

}  // namespace jostle::server
