// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

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
The scene: spheres, boxes and capsules poured between walls (for 5000 bodies scene d of 'speed'),
200 steps after the start, all awake. The benchmark measures a checkpoint as the server creates it
(docs/design/persistence.md).

Columns, ms of CPU time, median of the repetitions: capture (in the tick's thread:
RestorePoint::capture() and the state of the host), encode (in another thread: RestorePoint::save()
with its hash, and zstd; save(), state_hash() and zstd are also listed separately), decode
(decompress, load() and compare the hash); one step of the same world; MB packed.

Examples:
  jostle-bench persistence
  jostle-bench persistence --bodies 1000,20000 --json persistence.json

Exit status: 0 success, 1 the restored world differs, or the file could not be written, 2 invalid
flags.)";

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
    server::CheckpointCopy checkpoint{.tick = tick, .bodies = std::move(spare), .host_state = {}};
    time(times.checkpoint, [&] {
        checkpoint.host_state = world.host_state(tick);
        checkpoint.bodies.capture(world.world());
    });
    server::CheckpointData encoded;
    time(times.encode, [&] { encoded = must(server::encode_checkpoint(checkpoint)); });
    spare = std::move(checkpoint.bodies);
    std::vector<std::byte> saved;
    time(times.save, [&] { saved = physics::save(world.world()); });
    time(times.hash, [&] { times.same &= physics::state_hash(world.world()) == encoded.hash; });
    time(times.pack, [&] {
        times.packed_mb =
            static_cast<double>(
                server::compress({reinterpret_cast<const char*>(saved.data()), saved.size()})
                    .size()) /
            1e6;
    });
    time(times.decode,
         [&] { times.same &= server::decode_checkpoint(encoded.bytes, encoded.hash).ok(); });
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
    physics::RestorePoint spare;  // its memory is reused, as in a server
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
    std::printf("bodies  capture   encode (save   hash   pack)  decode     step   MB packed\n");
    for (const int bodies : flags.bodies) {
        const Times t = measure(bodies, flags.repetitions);
        same &= t.same;
        std::printf("%6d %8.2f %8.1f %6.1f %6.1f %6.1f %8.1f %8.2f %9.2f%s\n", bodies,
                    median(t.checkpoint), median(t.encode), median(t.save), median(t.hash),
                    median(t.pack), median(t.decode), median(t.step), t.packed_mb,
                    t.same ? "" : "  RESTORED WORLD DIFFERS");
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
        app.add_subcommand("persistence", "Measure the cost of saving and loading a world");
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option("--bodies", flags->bodies,
                     "Numbers of bodies [default: 1000,5000; 1 to 100000]")
        ->type_name("N")
        ->delimiter(',')
        ->check(CLI::Range(1, 100000).description(""));
    command
        ->add_option("--repetitions", flags->repetitions,
                     "Repeat N times; show the median [default: 15; 1 to 10000]")
        ->type_name("N")
        ->check(CLI::Range(1, 10000).description(""));
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
