// SPDX-License-Identifier: MIT
//
// jostle-sim: a scene, offline, as fast as it can.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "progress.h"
#include "report.h"
#include "trace.h"

namespace {

using jostle::physics::Status;
using jostle::physics::World;

constexpr const char* footer = R"(
Examples:
  jostle-sim pyramid --seconds 10
  jostle-sim my_scene.json --seconds 5 --hz 120 --substeps 4 --threads 2 --json report.json
  jostle-sim stack --trace stack.csv

The trace has a header and one row per body and tick: tick, body (its place in the scene), name, position px py pz (m),
rotation qx qy qz qw, velocity vx vy vz (m/s), angular velocity wx wy wz (rad/s). Static bodies are left out.
--save writes the world as it ends; --load goes on from such a file instead of the scene's start.

Exit status: 0 done, 1 the run failed, 2 wrong flags or scene.)";

struct Flags {
    std::string scene, json, trace, save, load, sleep, write_scene;
    double seconds = 10;
    std::optional<double> hz;
    std::optional<int> substeps;
    int threads = 1, trace_every = 1;
    bool list = false;
};

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option("scene", flags.scene, "A scene's name or the path of a scene file");
    app.add_option("--seconds", flags.seconds, "Simulated time")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1e6));
    app.add_option("--hz", flags.hz, "Steps per second; default: the scene's")
        ->check(CLI::Range(4.0, 10000.0));
    app.add_option("--substeps", flags.substeps, "Solver passes per step; default: the scene's")
        ->check(CLI::Range(1, 64));
    app.add_option("--threads", flags.threads, "Threads of the step; the bits are the same for any")
        ->capture_default_str()
        ->check(CLI::Range(1, 64));
    app.add_option("--sleep", flags.sleep, "on or off; default: the scene's")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_option("--json", flags.json, "Writes the report here as JSON");
    app.add_option("--trace", flags.trace, "Writes poses and velocities here as CSV");
    app.add_option("--trace-every", flags.trace_every, "Ticks between traced ones")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000));
    app.add_option("--save", flags.save, "Writes the world here when done");
    app.add_option("--load", flags.load, "Goes on from a saved world of the same scene");
    app.add_option("--write-scene", flags.write_scene, "Writes the scene here as a scene file");
    app.add_flag("--list", flags.list, "Names every scene of the catalogue and exits");
    app.footer(footer);
}

int fail(int status, const std::string& message) {
    std::fprintf(stderr, "jostle-sim: %s\n", message.c_str());
    return status;
}

double process_cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Replaces the built world by a saved one. The ids in a saved world are those of the scene it came
// from.
Status load_world(jostle::scenes::BuiltScene& built, const std::string& path, int threads) {
    std::ifstream in(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    if (!in) return jostle::physics::Error{{}, "cannot read " + path};
    jostle::scenes::register_catalog_modules();
    auto world = jostle::physics::load(std::as_bytes(std::span(text)));
    if (!world.ok()) return jostle::physics::Error{{}, path + ": " + world.error().message};
    built.world = std::move(*world);
    return built.world.set_threads(threads);
}

bool save_world(const World& world, const std::string& path) {
    const auto bytes = jostle::physics::save(world);
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    return out.good();
}

int run(const Flags& flags) {
    auto scene = jostle::scenes::load_scene(flags.scene);
    if (!scene.ok()) return fail(2, scene.error().message);
    if (flags.hz) scene->hz = *flags.hz;
    if (flags.substeps) scene->world.substeps = *flags.substeps;
    if (!flags.sleep.empty()) scene->world.sleeping = flags.sleep == "on";
    scene->world.threads = flags.threads;
    if (!flags.write_scene.empty()) {
        std::ofstream out(flags.write_scene);
        out << jostle::scenes::write_scene_json(*scene);
        if (!out) return fail(1, "cannot write " + flags.write_scene);
    }
    auto built = jostle::scenes::build_scene(*scene);
    if (!built.ok()) return fail(2, flags.scene + ": " + built.error().message);
    if (!flags.load.empty())
        if (const Status s = load_world(*built, flags.load, flags.threads); !s.ok())
            return fail(2, s.error().message);
    std::unique_ptr<jostle::sim::Trace> trace;
    if (!flags.trace.empty()) {
        trace = jostle::sim::Trace::open(flags.trace);
        if (!trace) return fail(1, "cannot write " + flags.trace);
        trace->write(built->world.step_count(), *built, *scene);
    }

    const auto steps = static_cast<std::uint64_t>(std::llround(flags.seconds * scene->hz));
    jostle::sim::Meter meter;
    double cpu_ms = 0;
    {
        jostle::sim::Progress progress(steps);
        for (std::uint64_t step = 1; step <= steps; step++) {
            const double before = process_cpu_ms();
            if (const Status s = built->world.step(1 / scene->hz); !s.ok())
                return fail(1, s.error().message);
            cpu_ms += process_cpu_ms() - before;
            meter.add(built->world.profile());
            if (trace && step % static_cast<std::uint64_t>(flags.trace_every) == 0)
                trace->write(built->world.step_count(), *built, *scene);
            progress.at(step, built->world.profile().bodies_awake);
        }
    }
    if (trace && !trace->close()) return fail(1, "cannot write all of " + flags.trace);

    jostle::sim::Report report{.scene = scene->name,
                               .threads = flags.threads,
                               .substeps = built->world.substeps(),
                               .hz = scene->hz};
    meter.fill(report, built->world);
    report.cpu_ms_per_step_mean = steps > 0 ? cpu_ms / static_cast<double>(steps) : 0;
    std::fputs(to_text(report).c_str(), stdout);
    if (!flags.json.empty()) {
        std::ofstream out(flags.json);
        out << to_json(report);
        if (!out) return fail(1, "cannot write " + flags.json);
    }
    if (!flags.save.empty() && !save_world(built->world, flags.save))
        return fail(1, "cannot write " + flags.save);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Runs a scene offline as fast as it can and reports what it cost and how it ended."};
    Flags flags;
    add_flags(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (flags.list) {
        for (const auto& scene : jostle::scenes::catalog())
            std::printf("%-12.*s %.*s\n", static_cast<int>(scene.name.size()), scene.name.data(),
                        static_cast<int>(scene.description.size()), scene.description.data());
        return 0;
    }
    if (flags.scene.empty())
        return fail(2, "name a scene or a scene file; --list names the scenes");
    return run(flags);
}
