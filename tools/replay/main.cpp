// SPDX-License-Identifier: MIT
//
// jostle-replay: inspects recordings and databases of persisted worlds, and restores any tick.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/command_line/command_line.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/scene_file.h"
#include "tools/replay/recording_report.h"
#include "tools/replay/world_replay.h"

namespace {

using jostle::client::Playback;
using jostle::client::RecordingReader;
namespace replay = jostle::replay;
using replay::PersistedWorld;

constexpr const char* footer = R"(
Examples:
  jostle-replay yard.rec                    # summarize a recording
  jostle-replay yard.rec --at 1234          # print the poses in a tick
  jostle-replay yard.rec --at 1234 --json
  jostle-replay yard.rec --verify           # decode everything and verify every CRC

  jostle-replay worlds.db --world           # list the worlds of a database
  jostle-replay worlds.db --world yard      # summarize a world
  jostle-replay worlds.db --world yard --verify
  jostle-replay worlds.db --world yard --at 1234 --export then.json
  jostle-replay worlds.db --world yard --hash-every 600
  jostle-replay worlds.db --world yard --diff other.db
  jostle-replay worlds.db --world --add-portable    # all worlds, before an older server opens them

Recordings are written by jostle-record. A truncated recording, after a crash or while it is
written, is read up to its last complete record; corrupt records are skipped. The summary reports
both. Positions are in m, rotations are quaternions. A tick without a snapshot shows the preceding
snapshot.

A database contains the persisted worlds of a server (persistence.database,
docs/guides/operator/persist.md). Stop the server first, or copy its files. Replay is bit-identical:
--verify compares each checkpoint with the replayed world, and --diff names the first tick and field
in which two databases differ.

Exit status: 0 success, 1 damage, a difference, no worlds, or the tick is not available, 2 invalid
flags or files.)";

struct Flags {
    std::string file;
    std::optional<std::uint32_t> at, hash_every;
    std::optional<std::string> world;
    std::string export_to, diff;
    bool verify = false, json = false, add_portable = false;
};

int fail(int status, const std::string& message) {
    std::fprintf(stderr, "jostle-replay: %s\n", message.c_str());
    return status;
}

int print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    return 0;
}

int print(const nlohmann::json& json) {
    return print(json.dump(2) + "\n");
}

// --- recordings ---

int run_recording(const Flags& flags) {
    auto recording = RecordingReader::open(flags.file);
    if (!recording.ok()) return fail(2, recording.error().message);
    if (!flags.at && !flags.verify) {
        const auto summary = summarize(*recording);
        print(flags.json ? replay::to_json(*recording, summary)
                         : replay::to_text(*recording, summary));
        return summary.errors == 0 ? 0 : 1;
    }
    Playback playback(*std::move(recording));
    if (flags.verify) {
        const auto check = jostle::client::check(playback);
        print(flags.json ? replay::to_json(check) : replay::to_text(check));
        return check.errors.empty() ? 0 : 1;
    }
    if (const auto s = playback.seek(*flags.at); !s.ok())
        return fail(1, flags.file + ": " + s.error().message);
    return print(flags.json ? replay::state_json(playback, *flags.at)
                            : replay::state_text(playback, *flags.at));
}

// --- databases ---

int list(const Flags& flags) {
    const auto listing = PersistedWorld::list(flags.file);
    if (!listing.ok()) return fail(2, listing.error().message);
    auto json = nlohmann::json::array();
    for (const auto& world : listing->worlds) {
        json.push_back({{"id", world.id}, {"name", world.name}, {"epochs", world.epoch}});
        if (!flags.json)
            std::printf("%-16s %s, opened %llu times\n", world.id.c_str(), world.name.c_str(),
                        static_cast<unsigned long long>(world.epoch));
    }
    if (flags.json) print(json);
    for (const std::string& damage : listing->damage) fail(1, damage);
    if (listing->worlds.empty()) return fail(1, flags.file + " contains no worlds");
    return listing->damage.empty() ? 0 : 1;
}

int summarize(PersistedWorld& world, const Flags& flags) {
    const auto summary = world.summary();
    if (!summary.ok()) return fail(1, summary.error().message);
    if (flags.json) {
        print(nlohmann::json{{"id", summary->id},
                             {"name", summary->name},
                             {"scene", summary->scene},
                             {"engine", summary->engine},
                             {"checkpoints", summary->checkpoints},
                             {"last_tick", summary->last_tick},
                             {"entries", summary->entries},
                             {"commands", summary->commands},
                             {"bytes", summary->bytes},
                             {"damage", summary->corruption}});
    } else {
        std::printf(
            "world %s \"%s\" of scene %s, written by %s\n%zu checkpoints, the oldest of "
            "tick %u; the journal ends at tick %u\n%llu commands in %llu records, %.1f "
            "kB\n",
            summary->id.c_str(), summary->name.c_str(), summary->scene.c_str(),
            summary->engine.c_str(), summary->checkpoints.size(),
            summary->checkpoints.empty() ? 0 : summary->checkpoints.front(), summary->last_tick,
            static_cast<unsigned long long>(summary->commands),
            static_cast<unsigned long long>(summary->entries),
            static_cast<double>(summary->bytes) / 1e3);
        if (!summary->corruption.empty()) std::printf("corrupt: %s\n", summary->corruption.c_str());
    }
    return summary->corruption.empty() ? 0 : 1;
}

int verify(PersistedWorld& world, const Flags& flags) {
    const auto verification = world.verify();
    if (!verification.ok()) return fail(1, verification.error().message);
    if (flags.json) {
        print(nlohmann::json{{"first_tick", verification->first_tick},
                             {"last_tick", verification->last_tick},
                             {"checkpoints", verification->checkpoints},
                             {"faults", verification->errors}});
    } else {
        for (const std::string& fault : verification->errors) std::printf("%s\n", fault.c_str());
        std::printf("ticks %u to %u replayed, %d checkpoints compared: %s\n",
                    verification->first_tick, verification->last_tick, verification->checkpoints,
                    verification->errors.empty() ? "identical" : "DIFFERENT");
    }
    return verification->errors.empty() ? 0 : 1;
}

int print_state_at(PersistedWorld& world, const Flags& flags) {
    if (flags.export_to.empty()) {
        auto found = world.at(*flags.at);
        if (!found.ok()) return fail(1, found.error().message);
        const std::size_t bodies = found->world.world().bodies().size();
        char hash[17];
        std::snprintf(
            hash, sizeof hash, "%016llx",
            static_cast<unsigned long long>(jostle::physics::state_hash(found->world.world())));
        if (flags.json)
            return print(nlohmann::json{{"tick", found->tick}, {"bodies", bodies}, {"hash", hash}});
        std::printf("tick %u: %zu bodies, hash %s\n", found->tick, bodies, hash);
        return 0;
    }
    const auto exported = world.scene_at(*flags.at);
    if (!exported.ok()) return fail(1, exported.error().message);
    std::ofstream out(flags.export_to, std::ios::binary);
    out << jostle::scenes::write_scene_json(exported->scene);
    out.close();
    if (!out) return fail(2, "cannot write " + flags.export_to);
    for (const std::string& omitted : exported->omitted)
        std::fprintf(stderr, "omitted: %s\n", omitted.c_str());
    return 0;
}

int print_hashes(PersistedWorld& world, const Flags& flags) {
    const auto print_hash = [](std::uint32_t tick, std::uint64_t hash) {
        std::printf("%u %016llx\n", tick, static_cast<unsigned long long>(hash));
    };
    const jostle::Status done = world.hashes(*flags.hash_every, print_hash);
    return done.ok() ? 0 : fail(1, done.error().message);
}

int print_difference(PersistedWorld& world, const Flags& flags) {
    auto other = PersistedWorld::open(flags.diff, *flags.world);
    if (!other.ok()) return fail(2, other.error().message);
    const auto difference = world.first_difference(*other);
    if (!difference.ok()) return fail(1, difference.error().message);
    if (!*difference) return print(std::string("the worlds are identical\n"));
    std::printf("the worlds differ from tick %u: %s\n", (*difference)->tick,
                (*difference)->field.c_str());
    return 1;
}

int add_portable(const Flags& flags) {
    const auto listing = PersistedWorld::list(flags.file);
    if (!listing.ok()) return fail(2, listing.error().message);
    auto json = nlohmann::json::array();
    int status = 0;
    bool found = false;
    for (const auto& stored : listing->worlds) {
        if (!flags.world->empty() && *flags.world != stored.id && *flags.world != stored.name)
            continue;
        found = true;
        auto world = PersistedWorld::open(flags.file, stored.id);
        if (!world.ok()) status = fail(1, world.error().message);
        if (!world.ok()) continue;
        const auto added = world->add_portable();
        if (!added.ok()) status = fail(1, added.error().message);
        if (!added.ok()) continue;
        json.push_back({{"id", stored.id},
                        {"name", stored.name},
                        {"tick", added->tick},
                        {"bytes", added->bytes},
                        {"omitted", added->omitted}});
        if (flags.json) continue;
        std::printf("world %s \"%s\": portable checkpoint of tick %u, %.1f kB\n", stored.id.c_str(),
                    stored.name.c_str(), added->tick, static_cast<double>(added->bytes) / 1e3);
        for (const std::string& omitted : added->omitted)
            std::printf("  omitted: %s\n", omitted.c_str());
    }
    if (flags.json) print(json);
    for (const std::string& damage : listing->damage) status = fail(1, damage);
    if (found) return status;
    return fail(1, flags.file + " contains no world" +
                       (flags.world->empty() ? "s" : " \"" + *flags.world + "\""));
}

int run_database(const Flags& flags) {
    if (flags.add_portable) return add_portable(flags);
    if (flags.world->empty()) return list(flags);
    auto world = PersistedWorld::open(flags.file, *flags.world);
    if (!world.ok()) return fail(2, world.error().message);
    if (flags.verify) return verify(*world, flags);
    if (flags.at) return print_state_at(*world, flags);
    if (flags.hash_every) return print_hashes(*world, flags);
    if (!flags.diff.empty()) return print_difference(*world, flags);
    return summarize(*world, flags);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Inspect a recording of a world, or a database with persisted worlds: summarize, restore "
        "a\n"
        "tick, or verify."};
    Flags flags;
    app.add_option("FILE", flags.file, "Recording, or with --world a database")
        ->type_name("")
        ->required();
    auto* world = app.add_option("--world", flags.world,
                                 "Use a world of a database by name or id; without WORLD list them")
                      ->type_name("[WORLD]")
                      ->expected(0, 1)
                      ->default_str("");
    auto* at = app.add_option("--at", flags.at, "Print the state in TICK")->type_name("TICK");
    auto* verify_flag =
        app.add_flag("--verify", flags.verify, "Decode everything and list the errors")
            ->excludes(at);
    app.add_option("--export", flags.export_to, "Write the state --at as a scene file to FILE")
        ->type_name("FILE")
        ->needs(at)
        ->needs(world);
    auto* every = app.add_option("--hash-every", flags.hash_every,
                                 "Print the state hash of every N-th tick [1 to 1e9]")
                      ->type_name("N")
                      ->check(CLI::Range(1U, 1000000000U).description(""))
                      ->needs(world)
                      ->excludes(at)
                      ->excludes(verify_flag);
    auto* diff =
        app.add_option("--diff", flags.diff, "Compare with the same world in another database")
            ->type_name("FILE")
            ->needs(world)
            ->excludes(at)
            ->excludes(verify_flag)
            ->excludes(every);
    app.add_flag("--add-portable", flags.add_portable,
                 "Write a checkpoint from which another version can resume")
        ->needs(world)
        ->excludes(at)
        ->excludes(verify_flag)
        ->excludes(every)
        ->excludes(diff);
    app.add_flag("--json", flags.json, "Print JSON");
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-replay", JOSTLE_VERSION}, argc, argv))
        return *status;
    return flags.world ? run_database(flags) : run_recording(flags);
}
