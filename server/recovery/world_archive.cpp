// SPDX-License-Identifier: MIT
#include "server/recovery/world_archive.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "server/recovery/checkpoint_data.h"
#include "server/recovery/journal_codec.h"
#include "server/recovery/world_storage_copy.h"
#include "server/storage/compression.h"
#include "server/storage/journal_chain.h"
#include "server/storage/sqlite_storage.h"
#include "server/util/bytes.h"
#include "server/util/log.h"

namespace jostle::server {
namespace {

constexpr auto timeout = std::chrono::seconds(5);
constexpr ClientId ids_per_reservation = 1 << 16;
constexpr const char* secret_note = "secret";
constexpr const char* clients_note = "clients";
constexpr std::size_t secret_bytes = 32;

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
    return {ErrorCode::unavailable, "the store does not answer; try again in a moment"};
}

CheckpointCopy checkpoint_copy_of(const HostedWorld& world, std::uint32_t tick) {
    CheckpointCopy checkpoint_copy{
        .tick = tick, .bodies = {}, .host_state = world.host_state(tick)};
    checkpoint_copy.bodies.capture(world.world());
    return checkpoint_copy;
}

Result<Checkpoint> checkpoint_of(const HostedWorld& world, std::uint32_t tick,
                                 std::uint64_t sequence) {
    Result<CheckpointData> host_state = encode_checkpoint(checkpoint_copy_of(world, tick));
    if (!host_state.ok()) return host_state.error();
    return Checkpoint{.tick = tick,
                      .hash = host_state->hash,
                      .sequence = sequence,
                      .exact = std::move(host_state->bytes),
                      .portable = {}};
}

// "w12-ab34": 12.
std::uint32_t number_of(const std::string& id) {
    std::uint32_t number = 0;
    if (!id.empty()) std::from_chars(id.data() + 1, id.data() + id.size(), number);
    return number;
}

}  // namespace

WorldArchive::WorldArchive(const PersistenceSettings& settings, const HostLimits& limits,
                           int threads, std::function<void()> on_results_sent)
    : limits_(limits),
      threads_(threads),
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
    Result<std::unique_ptr<SqliteStorage>> store = SqliteStorage::open(
        settings.database,
        {.durability = settings.durability == "process" ? Durability::process : Durability::machine,
         .file_system = file_system});
    if (!store.ok()) return store.error();
    std::unique_ptr<WorldArchive> archive(
        new WorldArchive(settings, limits, threads, std::move(on_results_sent)));
    const auto failed = [&](const Error& error) {
        return Error{error.code, settings.database + ": " + error.message};
    };
    Result<std::unique_ptr<CrashMarkers>> marks = CrashMarkers::open(settings.database + ".marks");
    if (!marks.ok()) return marks.error();
    archive->marks_ = *std::move(marks);
    if (Status s = archive->read_notes(**store); !s.ok()) return failed(s.error());
    const Result<std::vector<StoredWorld>> worlds = (*store)->worlds();
    if (!worlds.ok()) return failed(worlds.error());
    // Keepers of worlds that are taken up know the writer: it comes first, and has nothing to do.
    WorldStorage& there = **store;
    archive->writer_ = std::make_unique<StorageWriter>(*std::move(store), StorageWriterSettings{});
    CrashMarkers::count_fatal_signals(archive->marks_.get());
    if (Status s = archive->load_worlds(there, *worlds); !s.ok()) return failed(s.error());
    return archive;
}

Status WorldArchive::read_notes(WorldStorage& store) {
    const auto secret = store.note(secret_note);
    if (!secret.ok()) return secret.error();
    const auto clients = store.note(clients_note);
    if (!clients.ok()) return clients.error();
    if (*secret) {
        secret_ = **secret;
    } else {
        secret_.resize(secret_bytes);
        if (::getentropy(secret_.data(), secret_.size()) != 0)
            return Error{ErrorCode::unavailable, "the system gives no random bytes"};
    }
    if (*clients) {
        ByteReader from(**clients);
        first_client_ = std::max<ClientId>(1, from.small());
        if (!from.ok() || !from.at_end())
            return Error{ErrorCode::corrupt_data, "the note of client ids is none"};
    }
    if (secret_.size() != secret_bytes || first_client_ > 0xffffffff - 2 * ids_per_reservation)
        return Error{ErrorCode::corrupt_data, "a note is not what it was"};
    reserved_ = first_client_ + ids_per_reservation;
    const StorageChange changes[] = {PutNote{secret_note, secret_}, clients_note_of(reserved_)};
    return store.write(changes);
}

void WorldArchive::on_client(ClientId next) {
    ClientId reserved = reserved_;
    if (next + ids_per_reservation / 4 < reserved || reserved > 0xffffffff - ids_per_reservation)
        return;
    const ClientId more = reserved + ids_per_reservation;
    if (reserved_.compare_exchange_strong(reserved, more) &&
        !writer_->push(clients_note_of(more), nullptr))
        reserved_ = reserved;
}

bool WorldArchive::flush(Clock::duration within) {
    const Clock::time_point until = Clock::now() + within;
    return checkpoints_->wait(within) && writer_->flush(until - Clock::now());
}

// --- worlds that come back ---

// One that is damaged holds up no other; a disk that is full or gone may be well again soon, and
// then all of them are to come back.
Status WorldArchive::load_worlds(WorldStorage& store, const std::vector<StoredWorld>& worlds) {
    for (const StoredWorld& stored : worlds) {
        const Clock::time_point began = Clock::now();
        Result<PersistedWorld> kept = Error{};
        writer_->run_on_writer([&](WorldStorage&) { kept = load_world(store, stored); },
                               std::chrono::hours(1));
        if (!kept.ok() && (kept.error().code == ErrorCode::unavailable ||
                           kept.error().code == ErrorCode::resource_exhausted))
            return kept.error();
        if (!kept.ok()) {
            log_error(
                "world {} \"{}\" cannot be had back; what there is of it stays in the store: "
                "{}",
                stored.id, stored.name, kept.error().message);
            continue;
        }
        log_info("world {} \"{}\" goes on after tick {}, with {} clients to come back; {:.0f} ms",
                 stored.id, stored.name, kept->start.tick, kept->previous_clients.size(),
                 to_ms(Clock::now() - began));
        loaded_.push_back(*std::move(kept));
    }
    std::ranges::stable_sort(
        loaded_, {}, [](const PersistedWorld& kept) { return number_of(kept.start.label.id); });
    return {};
}

Result<PersistedWorld> WorldArchive::load_world(WorldStorage& store, const StoredWorld& stored) {
    Result<WorldDefinition> record = decode_world_definition(stored.settings);
    if (!record.ok()) return record.error();
    Result<RecoveredWorld> found = recover(store, stored, *record);
    if (!found.ok()) return found.error();
    record->limits = limits_;
    found->world.set_limits(limits_);
    StoredWorld now{.id = stored.id,
                    .name = stored.name,
                    .epoch = stored.epoch + 1,
                    .engine = build_engine_id(),
                    .settings = encode_world_definition(*record)};
    std::vector<StorageChange> changes{TruncateJournal{stored.id, found->tick, found->sequence}};
    // From here on it is as a world that was never stopped: what came before is in a checkpoint,
    // unless nothing came.
    const bool as_it_was = found->tick == found->checkpoint && now.engine == stored.engine &&
                           now.settings == stored.settings;
    if (!as_it_was) {
        Result<Checkpoint> checkpoint = checkpoint_of(found->world, found->tick, found->sequence);
        if (!checkpoint.ok()) return checkpoint.error();
        changes.emplace_back(PutCheckpoint{stored.id, *std::move(checkpoint)});
    }
    Result<std::vector<std::uint32_t>> ticks = store.checkpoint_ticks(stored.id);
    if (!ticks.ok()) return ticks.error();
    std::erase_if(*ticks, [&](std::uint32_t tick) { return tick >= found->tick; });
    ticks->insert(ticks->begin(), found->tick);
    std::ranges::reverse(*ticks);
    const JournalPosition place{.epoch = now.epoch,
                                .sequence = found->sequence,
                                .chain = found->chain,
                                .checkpoints = *std::move(ticks)};
    changes.emplace_back(PutWorld{std::move(now)});
    if (Status s = store.write(changes); !s.ok()) return s.error();
    marks_->of(stored.id).forget();

    std::vector<PreviousClient> previous_clients =
        previous_clients_of(found->world.host_state(found->tick));
    PersistedWorld kept{.start = {.label = {stored.id, stored.name, record->owner},
                                  .scene = record->scene,
                                  .world = std::move(found->world),
                                  .tick = found->tick},
                        .previous_clients = std::move(previous_clients)};
    kept.start.world_journal = make_journal(kept.start, place);
    return kept;
}

// A tick that crashed twice in a row is done again without its commands; should the fault lie
// further back, each crash more takes twice as many ticks.
Result<RecoveredWorld> WorldArchive::recover(WorldStorage& store, const StoredWorld& stored,
                                             const WorldDefinition& record) {
    const CrashMarker mark = marks_->of(stored.id);
    const std::uint32_t crashes = mark.crashes(), last = mark.crashed_tick();
    const std::uint32_t ticks = crashes < 2 ? 0 : 1U << std::min(crashes - 2, 30U);
    RecoveryOptions options{.threads = threads_};
    options.may_apply = [&](const JournaledTick& tick) {
        mark.begin(tick.tick);
        const bool is_suspect = tick.tick <= last && last - tick.tick < ticks;
        if (is_suspect && !tick.commands.empty()) quarantine_tick(stored, tick);
        return !is_suspect;
    };
    Result<RecoveredWorld> found = recover_world(store, stored, record, options);
    mark.end();
    if (!found.ok()) return found;
    if (ticks > 0)
        found->warnings.push_back("it crashed " + std::to_string(crashes) + " times in tick " +
                                  std::to_string(last) + ": what was done in the last " +
                                  std::to_string(ticks) + " ticks up to it is set aside");
    for (const std::string& remark : found->warnings)
        log_error("world {} \"{}\": {}", stored.id, stored.name, remark);
    return found;
}

void WorldArchive::quarantine_tick(const StoredWorld& stored, const JournaledTick& tick) {
    log_error("world {} \"{}\": {} commands of tick {} are set aside", stored.id, stored.name,
              tick.commands.size(), tick.tick);
    writer_->push(PutNote{"aside " + stored.id + " " + std::to_string(tick.tick),
                          encode_journal({{tick}, {}})},
                  nullptr);
}

std::shared_ptr<WorldJournal> WorldArchive::make_journal(const WorldStart& start,
                                                         const JournalPosition& position) {
    return std::make_shared<StoredWorldJournal>(start.label.id, start.scene->hz, position, *writer_,
                                                *checkpoints_, marks_->of(start.label.id),
                                                journal_settings_);
}

// --- worlds that begin, end, and fail ---

Status WorldArchive::open(WorldStart& start) {
    const std::string& id = start.label.id;
    Result<Checkpoint> checkpoint = checkpoint_of(start.world, start.tick, 0);
    if (!checkpoint.ok()) return checkpoint.error();
    const WorldDefinition record{.owner = start.label.owner,
                                 .scene = start.scene,
                                 .limits = limits_,
                                 .work_per_second = start.world.work_per_second()};
    const bool pushed = writer_->push(PutWorld{{.id = id,
                                                .name = start.label.name,
                                                .epoch = 1,
                                                .engine = build_engine_id(),
                                                .settings = encode_world_definition(record)}},
                                      nullptr) &&
                        writer_->push(PutCheckpoint{id, *std::move(checkpoint)}, nullptr);
    if (!pushed || !writer_->flush(timeout)) {
        writer_->push(DropWorld{id}, nullptr);
        return Error{ErrorCode::unavailable,
                     "the world cannot be kept: " +
                         failure_reason().value_or("the store is slow; try again in a moment")};
    }
    start.world_journal = make_journal(start, {.epoch = 1, .checkpoints = {start.tick}});
    return {};
}

void WorldArchive::drop(const std::string& id) {
    checkpoints_->wait(timeout);
    marks_->drop(id);
    if (!writer_->push(DropWorld{id}, nullptr) || !writer_->flush(timeout))
        log_error("world {} may come back: that it was deleted could not be kept", id);
}

Result<std::unique_ptr<WorldStorage>> WorldArchive::copy_of(const std::string& id,
                                                            std::uint32_t last_tick) {
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    writer_->run_on_writer(
        [&](WorldStorage& store) { copy = WorldStorageCopy::of(store, id, 2, last_tick); },
        timeout);
    if (!copy.ok()) return copy.error();
    return std::unique_ptr<WorldStorage>(*std::move(copy));
}

Result<HostedWorld> WorldArchive::world_at(const std::string& id, std::uint32_t tick) {
    const Result<std::unique_ptr<WorldStorage>> copy = copy_of(id, tick);
    if (!copy.ok()) return copy.error();
    const Result<std::vector<StoredWorld>> stored = (*copy)->worlds();
    if (!stored.ok()) return stored.error();
    const Result<WorldDefinition> record = decode_world_definition(stored->front().settings);
    if (!record.ok()) return record.error();
    Result<RecoveredWorld> found =
        recover_world(**copy, stored->front(), *record, {.last_tick = tick, .threads = threads_});
    if (!found.ok()) return found.error();
    if (found->tick != tick)
        return Error{ErrorCode::not_found, "tick " + std::to_string(tick) +
                                               " is not kept; the last one is " +
                                               std::to_string(found->tick)};
    found->world.set_limits(limits_);
    return std::move(found->world);
}

Result<WorldArchive::StoppedWorld> WorldArchive::load_stopped_world(const std::string& id) {
    checkpoints_->wait(timeout);
    Result<std::unique_ptr<WorldStorageCopy>> copy = slow();
    Result<std::vector<std::uint32_t>> ticks = slow();
    writer_->run_on_writer(
        [&](WorldStorage& store) {
            copy = WorldStorageCopy::of(store, id, 2);
            ticks = store.checkpoint_ticks(id);
        },
        timeout);
    if (!copy.ok()) return copy.error();
    if (!ticks.ok()) return ticks.error();
    const StoredWorld stored = (*copy)->worlds().value().front();
    Result<WorldDefinition> record = decode_world_definition(stored.settings);
    if (!record.ok()) return record.error();
    Result<RecoveredWorld> found = recover(**copy, stored, *record);
    if (!found.ok()) return found.error();
    std::ranges::reverse(*ticks);
    return StoppedWorld{stored, *std::move(record), *std::move(found), *std::move(ticks)};
}

WorldStart WorldArchive::start_of(StoppedWorld last) {
    WorldStart start{.label = {last.stored.id, last.stored.name, last.record.owner},
                     .scene = last.record.scene,
                     .world = std::move(last.found.world),
                     .tick = last.found.tick};
    start.world_journal = make_journal(start, {.epoch = last.stored.epoch,
                                               .sequence = last.found.sequence,
                                               .chain = last.found.chain,
                                               .checkpoints = std::move(last.checkpoints)});
    return start;
}

Result<WorldStart> WorldArchive::reload(const std::string& id) {
    Result<StoppedWorld> last = load_stopped_world(id);
    if (!last.ok()) return last.error();
    return start_of(*std::move(last));
}

// The journal only grows: it says that the world went back, and a checkpoint says to what. Both are
// handed over like any tick; should they be lost with the process, the world did not go back.
Result<WorldStart> WorldArchive::rewind(const std::string& id, std::uint32_t tick,
                                        HostedWorld then) {
    Result<StoppedWorld> last = load_stopped_world(id);
    if (!last.ok()) return last.error();
    RecoveredWorld& found = last->found;
    then.continue_from(found.world);
    found.world = std::move(then);
    found.tick++;
    JournalEntry entry{
        .sequence = ++found.sequence,
        .epoch = last->stored.epoch,
        .first_tick = found.tick,
        .last_tick = found.tick,
        .data = compress(encode_journal(
            {.ticks = {}, .paused_ticks = {}, .rewind = Rewind{.tick = found.tick, .to = tick}}))};
    found.chain = entry.chain = next_chain(found.chain, entry.data);
    Result<Checkpoint> checkpoint = checkpoint_of(found.world, found.tick, found.sequence);
    if (!checkpoint.ok()) return checkpoint.error();
    if (!writer_->push(AppendEntry{id, std::move(entry)}, nullptr))
        return Error{ErrorCode::unavailable, "the store does not keep up; try again in a moment"};
    const bool pushed = writer_->push(PutCheckpoint{id, *std::move(checkpoint)}, nullptr);
    if (pushed) last->checkpoints.push_back(found.tick);
    WorldStart start = start_of(*std::move(last));
    if (!pushed) start.world_journal->on_interrupted();  // it asks for one in its first tick
    return start;
}

}  // namespace jostle::server
