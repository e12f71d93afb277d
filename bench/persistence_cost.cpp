// SPDX-License-Identifier: MIT
#include "bench/persistence_cost.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/bench_scenes.h"
#include "server/recovery/checkpoint_data.h"
#include "server/storage/compression.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
The scene: spheres, boxes and capsules poured between walls (scene d of 'speed' at 5000), 200 steps after the start, all awake. A
checkpoint as a server takes it (docs/design/persistence.md).

Columns, ms of processor time, median of the repetitions: moment (the tick's thread: RestorePoint::keep() and who owns what),
encode (another thread: RestorePoint::save() with its hash, and zstd; save(), state_hash() and zstd by themselves beside), decode (unpack, load(),
compare the hash); MB packed; and one step of the same world.

Examples:
  jostle-bench persistence
  jostle-bench persistence --bodies 1000,20000 --json persistence.json

Exit status: 0 done, 1 the world that came back differs, or the file could not be written, 2 wrong flags.)";

struct Flags {
    std::vector<int> bodies = {1000, 5000};
    int repetitions = 15;
    std::string json;
};

template <class T>
T must(Result<T> result) {
    if (!result.ok()) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

struct Times {
    std::vector<double> checkpoint, encode, save, hash, pack, decode, step;
    double packed_mb = 0;
    bool same = true;
};

double median(const std::vector<double>& values) {
    return spread_of(values).median;
}

template <class Work>
void time(std::vector<double>& into, Work&& work) {
    const double began = cpu_seconds();
    work();
    into.push_back(1e3 * (cpu_seconds() - began));
}

void repeat_once(server::HostedWorld& world, std::uint32_t tick, physics::RestorePoint& spare,
                 Times& times) {
    time(times.step, [&] {
        if (Status s = world.step(1.0 / 60, tick); !s.ok())
            throw std::runtime_error(s.error().message);
    });
    server::CheckpointCopy moment{.tick = tick, .bodies = std::move(spare), .host_state = {}};
    time(times.checkpoint, [&] {
        moment.host_state = world.host_state(tick);
        moment.bodies.capture(world.world());
    });
    server::CheckpointData host_state;
    time(times.encode, [&] { host_state = must(server::encode_checkpoint(moment)); });
    spare = std::move(moment.bodies);
    std::vector<std::byte> saved;
    time(times.save, [&] { saved = physics::save(world.world()); });
    time(times.hash, [&] { times.same &= physics::state_hash(world.world()) == host_state.hash; });
    time(times.pack, [&] {
        times.packed_mb =
            static_cast<double>(
                server::compress({reinterpret_cast<const char*>(saved.data()), saved.size()})
                    .size()) /
            1e6;
    });
    time(times.decode,
         [&] { times.same &= server::decode_checkpoint(host_state.bytes, host_state.hash).ok(); });
}

Times measure(int bodies, int repetitions) {
    scenes::SceneDescription scene = scenes::bench_pile(bodies);
    scene.world.sleeping = false;
    server::HostLimits limits;
    limits.scene = {.bodies_max = 1 << 30,
                    .joints_max = 1 << 30,
                    .joints_per_pair_max = 1 << 30,
                    .geometry_bytes_max = 1e12,
                    .body_geometry_bytes_max = 1 << 30,
                    .work_per_second_max = 1e15,
                    .first_step_seconds_max = 1e3};
    server::HostedWorld world = must(server::HostedWorld::create(scene, limits, 1));
    Times times;
    physics::RestorePoint spare;  // its memory is used again, as a server does
    std::uint32_t tick = 1;
    for (int k = 0; k < 200; k++)
        if (Status s = world.step(1.0 / 60, ++tick); !s.ok())
            throw std::runtime_error(s.error().message);
    for (int k = 0; k < repetitions; k++) repeat_once(world, ++tick, spare, times);
    return times;
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    auto rows = nlohmann::ordered_json::array();
    bool same = true;
    std::printf("bodies   moment   encode (save   hash   pack)  decode     step   MB packed\n");
    for (const int bodies : flags.bodies) {
        const Times t = measure(bodies, flags.repetitions);
        same &= t.same;
        std::printf("%6d %8.2f %8.1f %6.1f %6.1f %6.1f %8.1f %8.2f %9.2f%s\n", bodies,
                    median(t.checkpoint), median(t.encode), median(t.save), median(t.hash),
                    median(t.pack), median(t.decode), median(t.step), t.packed_mb,
                    t.same ? "" : "  ANOTHER WORLD CAME BACK");
        rows.push_back({{"bodies", bodies},
                        {"checkpoint_ms", rounded(median(t.checkpoint))},
                        {"encode_ms", rounded(median(t.encode))},
                        {"save_ms", rounded(median(t.save))},
                        {"hash_ms", rounded(median(t.hash))},
                        {"pack_ms", rounded(median(t.pack))},
                        {"decode_ms", rounded(median(t.decode))},
                        {"step_ms", rounded(median(t.step))},
                        {"packed_mb", rounded(t.packed_mb)},
                        {"same", t.same}});
    }
    if (flags.json.empty()) return same ? 0 : 1;
    const nlohmann::ordered_json head = {{"benchmark", "persistence"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"repetitions", flags.repetitions}};
    return write_result(flags.json, head, rows) && same ? 0 : 1;
}

}  // namespace

void add_persistence(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("persistence", "What it costs to keep a world beyond its process.");
    const auto flags = std::make_shared<Flags>();
    command->add_option("--bodies", flags->bodies, "How many, with commas between")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    command->add_option("--repetitions", flags->repetitions, "How often each is done")
        ->capture_default_str()
        ->check(CLI::Range(1, 10000));
    command->add_option("--json", flags->json, "Writes the figures here as JSON");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
