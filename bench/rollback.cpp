// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/bench_scenes.h"

namespace jostle::bench {
namespace {

using physics::RestorePoint;
using physics::World;

constexpr const char* footer = R"(
A repetition captures the state of the world, runs some steps that are to be reverted, and restores
the state. The restore point is reused: it held a state before the first repetition. After each
restore, the hash of the world is compared with that of the captured state; a difference ends the
run. Worlds have one thread.

Scenes:  pile    spheres, boxes and capsules poured between walls (for 5000 bodies scene d of
                 'speed'), 200 steps after the start
         asleep  boxes that sleep on a floor and are not woken
         woken   the same boxes, all woken after the capture; the restore returns them to sleep

Columns: bodies, touching contacts, milliseconds of capture() and of restore(): median, smallest and
largest of the repetitions in CPU time of the thread; for comparison one step of the same world, and
save() + load() of its bytes.

Examples:
  jostle-bench rollback --bodies 5000
  jostle-bench rollback --bodies 1000,5000,20000 --scenes pile --json rollback.json

Exit status: 0 success, 1 a restored world differs, or the file could not be written, 2 invalid
flags.)";

struct Flags {
    std::vector<int> bodies = {5000};
    std::vector<std::string> scenes = {"pile", "asleep", "woken"};
    int steps = 8;
    int repetitions = 20;
    std::string json;
};

struct Row {
    std::string scene;
    int bodies = 0, contacts = 0;
    std::vector<double> save_ms, restore_ms, step_ms, save_and_load_ms;
    bool same = true;
};

// Throws if a call fails: the scenes are part of this file, so a failure is a bug in it.
template <class T>
T must(physics::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}
void must(const physics::Status& status) {
    if (!status) throw std::runtime_error(status.error().message);
}

void step(World& world) {
    must(world.step(1.0 / 60));
}

World make_pile(int bodies) {
    scenes::SceneDescription scene = scenes::bench_pile(bodies);
    scene.world.sleeping = false;
    World world = must(scenes::build_scene(scene)).world;
    for (int k = 0; k < 200; k++) step(world);
    return world;
}

World make_asleep(int bodies) {
    World world = must(World::create());
    must(world.create_body({.type = physics::BodyType::static_body, .pose = {{0, -1, 0}, {}}},
                           {.geometry = physics::Box{{2000, 1, 2000}}}));
    const int side = static_cast<int>(std::ceil(std::sqrt(bodies)));
    for (int k = 0; k < bodies; k++)
        must(world.create_body({.pose = {{2.0 * (k % side), 0.5, 2.0 * (k / side)}, {}},
                                .linear_damping = 0.05,
                                .angular_damping = 0.05},
                               {.geometry = physics::Box{{0.5, 0.5, 0.5}}}));
    do step(world);
    while (world.profile().bodies_awake > 0 && world.step_count() < 1000);
    return world;
}

void wake_all(World& world) {
    for (const physics::BodyId body : world.bodies())
        if (must(world.body(body)).type == physics::BodyType::dynamic) must(world.wake(body));
}

void repeat_once(Row& row, World& world, RestorePoint& point, int steps) {
    const std::uint64_t hash_before = physics::state_hash(world);
    const double began = cpu_seconds();
    point.capture(world);
    const double saved = cpu_seconds();
    if (row.scene == "woken") wake_all(world);
    const double step_start = cpu_seconds();
    for (int k = 0; k < steps; k++) step(world);
    const double step_end = cpu_seconds();
    must(point.restore(world));
    const double restored = cpu_seconds();
    row.save_ms.push_back(1e3 * (saved - began));
    row.step_ms.push_back(1e3 * (step_end - step_start) / steps);
    row.restore_ms.push_back(1e3 * (restored - step_end));
    row.same = row.same && physics::state_hash(world) == hash_before;
}

void save_and_load(Row& row, const World& world) {
    const double began = cpu_seconds();
    const World copy = must(physics::load(physics::save(world)));
    row.save_and_load_ms.push_back(1e3 * (cpu_seconds() - began));
    row.same = row.same && physics::state_hash(copy) == physics::state_hash(world);
}

Row measure(const std::string& scene, int bodies, const Flags& flags) {
    show_progress(scene + ", " + std::to_string(bodies) + " bodies");
    World world = scene == "pile" ? make_pile(bodies) : make_asleep(bodies);
    Row row{.scene = scene, .bodies = bodies, .contacts = world.summary().contacts};
    RestorePoint point;
    point.capture(world);
    for (int k = 0; k < flags.repetitions && row.same; k++)
        repeat_once(row, world, point, flags.steps);
    for (int k = 0; k < 3 && row.same; k++) save_and_load(row, world);
    show_progress("");
    return row;
}

void print_head() {
    std::printf("%-7s %7s %8s %24s %24s %8s %9s\n", "scene", "bodies", "contacts",
                "capture ms (low to high)", "restore ms (low to high)", "step ms", "bytes ms");
}

void print_row(const Row& row) {
    const Spread capture = spread_of(row.save_ms), restore = spread_of(row.restore_ms);
    std::printf("%-7s %7d %8d %8.3f (%5.2f to %5.2f) %8.3f (%5.2f to %5.2f) %8.3f %9.1f\n",
                row.scene.c_str(), row.bodies, row.contacts, capture.median, capture.low,
                capture.high, restore.median, restore.low, restore.high,
                spread_of(row.step_ms).median, spread_of(row.save_and_load_ms).median);
    std::fflush(stdout);
}

nlohmann::ordered_json to_json(const Spread& s) {
    return {{"median", rounded(s.median)}, {"low", rounded(s.low)}, {"high", rounded(s.high)}};
}

nlohmann::ordered_json to_json(const Row& row) {
    return {{"scene", row.scene},
            {"bodies", row.bodies},
            {"contacts", row.contacts},
            {"save_ms", to_json(spread_of(row.save_ms))},
            {"restore_ms", to_json(spread_of(row.restore_ms))},
            {"step_ms", to_json(spread_of(row.step_ms))},
            {"save_and_load_ms", to_json(spread_of(row.save_and_load_ms))}};
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    print_head();
    for (const std::string& scene : flags.scenes)
        for (const int bodies : flags.bodies) {
            const Row row = measure(scene, bodies, flags);
            if (!row.same) {
                std::fprintf(stderr, "jostle-bench: %s, %d bodies: the restored world differs\n",
                             scene.c_str(), bodies);
                return 1;
            }
            print_row(row);
            rows.push_back(to_json(row));
        }
    if (flags.json.empty()) return 0;
    const nlohmann::ordered_json head = {{"benchmark", "rollback"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"repetitions", flags.repetitions},
                                         {"steps", flags.steps}};
    return write_result(flags.json, head, rows) ? 0 : 1;
}

}  // namespace

void add_rollback(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "rollback", "Measure the cost of capturing and restoring the state of a world");
    const auto flags = std::make_shared<Flags>();
    command->add_option("--bodies", flags->bodies, "Numbers of bodies [default: 5000; 1 to 100000]")
        ->type_name("N")
        ->delimiter(',')
        ->check(CLI::Range(1, 100000).description(""));
    command->add_option("--scenes", flags->scenes, "Scenes [default: pile,asleep,woken]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::IsMember({"pile", "asleep", "woken"}).description(""));
    command
        ->add_option("--steps", flags->steps,
                     "Steps between capture and restore [default: 8; 1 to 10000]")
        ->type_name("N")
        ->check(CLI::Range(1, 10000).description(""));
    command
        ->add_option("--repetitions", flags->repetitions,
                     "Repeat N times; show the median [default: 20; 1 to 1000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000).description(""));
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
