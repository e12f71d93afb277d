// SPDX-License-Identifier: MIT
#include "checkpoint.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/snapshot.h"
#include "jostle/scenes/lab.h"
#include "measure.h"
#include "persistence/compressed.h"
#include "result_file.h"

namespace jostle::bench {
namespace {

using physics::World;

constexpr const char* checkpoint_footer = R"(
The way of a checkpoint, from a world that runs to bytes for a disk and back:
  keep        a RestorePoint of the world: the only part that its thread does
  save        the point as bytes, on any thread
  compress    the bytes, as they are stored
  decompress  what is stored
  load        a world of it: when a server starts
and another way to the same bytes, for who wants a second world, too:
  restore     the point into a spare world
  save        ... that world as bytes ("save spare")
  hash        ... its state_hash()
Boxes are poured between walls and never sleep, so that nothing of the world is at rest: the worst case. Between two
repetitions the world takes a step. The bytes of both ways and the loaded world's hash are compared; a difference ends
the run.

Columns: bodies, contacts (touching), processor time of the thread in milliseconds (median of the repetitions), of save
and compress together ("background"), and MB (1e6 bytes) of the world as bytes, before and after.

Examples:
  jostle-bench checkpoint
  jostle-bench checkpoint --bodies 20000 --json checkpoint.json

Exit status: 0 done, 1 a loaded world differs, or the file could not be written, 2 wrong flags.)";

struct CheckpointFlags {
    std::vector<int> bodies = {1000, 5000};
    int repetitions = 20;
    std::string json;
};

constexpr const char* part_names[] = {"keep", "save",    "compress",   "decompress",
                                      "load", "restore", "save spare", "hash"};
constexpr std::size_t part_count = std::size(part_names);

struct CheckpointRow {
    int bodies = 0, contacts = 0;
    std::vector<double> ms[part_count], background_ms;
    std::size_t saved_bytes = 0, compressed_bytes = 0;
    bool same = true;
};

// The scene is ours: a refused call is a fault of this file.
template <class T>
T taken(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

World boxes_in_a_pile(int bodies) {
    scenes::SceneDescription scene = scenes::lab_pile(bodies);
    scene.world.sleeping = false;
    for (scenes::SceneBody& body : scene.bodies)
        if (body.name == "piece") body.shapes[0].geometry = physics::Box{{0.3, 0.25, 0.35}};
    World world = taken(scenes::build_scene(scene)).world;
    for (int k = 0; k < 200; k++) world.step(1.0 / 60).expect();
    return world;
}

// Takes the times between its calls.
class PartTimes {
public:
    explicit PartTimes(CheckpointRow& row) : row_(row) {}
    void done(std::size_t part) {
        const double now = cpu_seconds();
        row_.ms[part].push_back(1e3 * (now - began_));
        began_ = now;
    }

private:
    CheckpointRow& row_;
    double began_ = cpu_seconds();
};

void take_checkpoint(CheckpointRow& row, const World& world, physics::RestorePoint& point,
                     World& spare) {
    PartTimes times(row);
    point.keep(world);
    times.done(0);
    const std::vector<std::byte> saved = taken(point.save());
    times.done(1);
    const std::string stored =
        server::compress({reinterpret_cast<const char*>(saved.data()), saved.size()});
    times.done(2);
    const std::string bytes = taken(server::decompress(stored, saved.size()));
    times.done(3);
    const World loaded = taken(physics::load(std::as_bytes(std::span(bytes))));
    times.done(4);
    point.restore(spare).expect();
    times.done(5);
    const std::vector<std::byte> saved_spare = physics::save(spare);
    times.done(6);
    const std::uint64_t hash = physics::state_hash(spare);
    times.done(7);
    row.background_ms.push_back(row.ms[1].back() + row.ms[2].back());
    row.saved_bytes = saved.size();
    row.compressed_bytes = stored.size();
    row.same = row.same && saved == saved_spare && physics::state_hash(loaded) == hash;
}

CheckpointRow measure_checkpoints(int bodies, int repetitions) {
    show_progress(std::to_string(bodies) + " boxes");
    World world = boxes_in_a_pile(bodies);
    CheckpointRow row{.bodies = bodies, .contacts = world.summary().contacts};
    World spare = taken(World::create());
    physics::RestorePoint point;
    point.keep(world);  // so that memory is there, as in a server that has run for a while
    point.restore(spare).expect();
    for (int k = 0; k < repetitions && row.same; k++) {
        take_checkpoint(row, world, point, spare);
        world.step(1.0 / 60).expect();
    }
    show_progress("");
    return row;
}

void print_checkpoint_head() {
    std::printf("%7s %8s", "boxes", "contacts");
    for (const char* name : part_names) std::printf(" %10s", name);
    std::printf(" %10s %8s %8s\n", "background", "MB", "stored");
}

void print_checkpoint(const CheckpointRow& row) {
    std::printf("%7d %8d", row.bodies, row.contacts);
    for (const auto& ms : row.ms) std::printf(" %10.2f", spread_of(ms).median);
    std::printf(" %10.2f %8.2f %8.2f\n", spread_of(row.background_ms).median,
                1e-6 * static_cast<double>(row.saved_bytes),
                1e-6 * static_cast<double>(row.compressed_bytes));
    std::fflush(stdout);
}

nlohmann::ordered_json spread_json(const std::vector<double>& values) {
    const Spread s = spread_of(values);
    return {{"median", rounded(s.median)}, {"low", rounded(s.low)}, {"high", rounded(s.high)}};
}

std::string json_name(std::string part) {
    std::replace(part.begin(), part.end(), ' ', '_');
    return part + "_ms";
}

nlohmann::ordered_json json_of(const CheckpointRow& row) {
    nlohmann::ordered_json json = {{"boxes", row.bodies}, {"contacts", row.contacts}};
    for (std::size_t part = 0; part < part_count; part++)
        json[json_name(part_names[part])] = spread_json(row.ms[part]);
    json["background_ms"] = spread_json(row.background_ms);
    json["saved_bytes"] = row.saved_bytes;
    json["compressed_bytes"] = row.compressed_bytes;
    return json;
}

int run_checkpoints(const CheckpointFlags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    print_checkpoint_head();
    for (const int bodies : flags.bodies) {
        const CheckpointRow row = measure_checkpoints(bodies, flags.repetitions);
        if (!row.same) {
            std::fprintf(stderr, "jostle-bench: %d boxes: the loaded world differs\n", bodies);
            return 1;
        }
        print_checkpoint(row);
        rows.push_back(json_of(row));
    }
    if (flags.json.empty()) return 0;
    const nlohmann::ordered_json head = {{"benchmark", "checkpoint"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"repetitions", flags.repetitions}};
    return write_result(flags.json, head, rows) ? 0 : 1;
}

}  // namespace

void add_checkpoint(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "checkpoint", "Times the way of a running world to bytes for a disk, and back.");
    const auto flags = std::make_shared<CheckpointFlags>();
    command->add_option("--bodies", flags->bodies, "How many; several with commas")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    command->add_option("--repetitions", flags->repetitions, "Of which the median is shown")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option("--json", flags->json, "Writes the figures here as JSON");
    command->footer(checkpoint_footer);
    command->callback([flags, &status] { status = run_checkpoints(*flags); });
}

}  // namespace jostle::bench
