// SPDX-License-Identifier: MIT
//
// jostle-sim: runs a scene offline, as fast as possible.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "base/command_line/command_line.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "tools/sim/converge.h"
#include "tools/sim/progress.h"
#include "tools/sim/report.h"
#include "tools/sim/trace.h"

namespace {

using jostle::physics::Status;
using jostle::physics::World;

constexpr const char* footer = R"(
Examples:
  jostle-sim pyramid --seconds 10
  jostle-sim my_scene.json --seconds 5 --hz 120 --substeps 4 --threads 2 --json report.json
  jostle-sim stack --trace stack.csv
  jostle-sim my_scene.json --converge --seconds 3 --tolerance 0.01,0.001 --json converge.json
  jostle-sim machines --inspect --at 120
  jostle-sim my_scene.json --inspect door --at 0 --json rows.json
  jostle-sim stack --inspect --csv residuals.csv
  tools/analysis/plot.py residuals residuals.csv -o residuals.svg

With --error-tolerance, the last line states whether all islands stayed within the tolerance. The
error of an island after a second is the mean of its estimates over that second.

The trace has a header and one row per tick and dynamic or kinematic body: tick, body (index in the
scene), name, position px py pz (m), rotation qx qy qz qw, velocity vx vy vz (m/s), angular velocity
wx wy wz (rad/s). --save writes the final world; --load resumes from such a file.

--converge determines the step rate and the number of sub-steps that a scene needs. It runs the
scene at half its rate, then at twice that, and so on, until two runs agree. The finest run is
the reference. The report lists the error and the CPU time of each combination of rate and
sub-steps, the order of convergence (2: doubling the rate divides the error by 4), and the
cheapest setting within each tolerance. Of settings whose times are within 15 %, it chooses the
one with the fewest sub-steps. It marks errors that exceed that of a lower rate by a third. A run
with perturbed initial velocities detects chaotic scenes, in which no rate is accurate for long;
the report states for how long.

--inspect analyses the constraint system of a step. It steps to --at and selects the group of a
body: all bodies connected to it by joints and touching contacts (without a body: every group).
The system has one row per direction that is held, driven, limited or subject to friction. The
report lists redundant rows, the condition number of A x = b, the results of nine solution
methods with their residual per iteration, and the effect of softness and scaling. A "~" marks
forces of a method that has not converged. Bodies are selected by name or by index in the scene,
from 0. docs/design/constraint_systems.md has an example.

Exit status: 0 success, 1 the run failed, 2 invalid flags or scene.)";

struct Flags {
    std::string scene, json, trace, save, load, sleep, write_scene, instructions;
    double seconds = 10;
    std::optional<double> hz;
    std::optional<int> substeps;
    std::optional<double> tolerance;
    std::optional<double> substep_budget;
    std::optional<double> step_budget;
    std::string island_substeps;
    int threads = 1, trace_every = 1;
    bool list = false, converge = false;
    std::vector<double> rates, tolerances = {0.01};
    std::vector<int> substep_counts;
    double finest_hz = 1920, scale = 0, budget = 120;
    std::string inspect;  // empty: not requested
    std::string csv;
    std::uint64_t at = 60;
    double position_correction = 0;
    int iterations = 1000;
    bool solver_softness = false;
};

// Unlike CLI::Range, rejects values that are not numbers.
CLI::Validator between(double low, double high) {
    return CLI::Validator(
        [low, high](std::string& text) -> std::string {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (!text.empty() && *end == 0 && value >= low && value <= high) return "";
            char words[160];
            std::snprintf(words, sizeof words, "%.40s is not a number from %g to %g", text.c_str(),
                          low, high);
            return words;
        },
        "");
}

// The instruction sets of this machine, from slow to fast.
std::string instruction_set_names() {
    std::string names;
    for (const auto set : jostle::physics::available_instruction_sets())
        names += std::string(names.empty() ? "" : ", ") + instruction_set_name(set);
    return names;
}

std::optional<jostle::physics::InstructionSet> find_instruction_set(const std::string& name) {
    for (const auto set : jostle::physics::available_instruction_sets())
        if (name == instruction_set_name(set)) return set;
    return std::nullopt;
}

void add_converge_flags(CLI::App& app, Flags& flags) {
    CLI::Option* converge =
        app.add_flag("--converge", flags.converge,
                     "Refine the steps until two runs agree, and report errors; see below");
    converge->group("Convergence");
    const auto requires_mode = [&](CLI::Option* option) {
        return option->needs(converge)->group("Convergence");
    };
    requires_mode(app.add_option("--tolerance", flags.tolerances,
                                 "Relative errors to achieve, separated by commas\n"
                                 "[default: 0.01; 1e-9 to 10]")
                      ->type_name("ERROR")
                      ->delimiter(',')
                      ->check(between(1e-9, 10)));
    requires_mode(app.add_option("--rates", flags.rates,
                                 "Step rates, separated by commas; each a multiple of the lowest\n"
                                 "[default: half the scene's rate, then doubled; 4 to 10000]")
                      ->type_name("HZ")
                      ->delimiter(',')
                      ->check(between(4, 10000)));
    requires_mode(app.add_option("--substep-counts", flags.substep_counts,
                                 "Numbers of sub-steps, separated by commas\n"
                                 "[default: a quarter, half, all and twice the scene's; 1 to 64]")
                      ->type_name("N")
                      ->delimiter(',')
                      ->check(CLI::Range(1, 64).description("")));
    requires_mode(app.add_option("--finest-hz", flags.finest_hz,
                                 "Maximum step rate [default: 1920; 8 to 10000]")
                      ->type_name("HZ")
                      ->check(between(8, 10000)));
    requires_mode(
        app.add_option("--scale", flags.scale,
                       "Divide distances by this length\n"
                       "[default: diagonal of the box in which the bodies move; 1e-6 to 1e6]")
            ->type_name("METRES")
            ->check(between(1e-6, 1e6)));
    requires_mode(
        app.add_option("--budget", flags.budget,
                       "Skip runs that would exceed this CPU time [default: 120; 0.1 to 1e6]")
            ->type_name("SECONDS")
            ->check(between(0.1, 1e6)));
    for (const char* other :
         {"--error-tolerance", "--substep-budget", "--step-budget", "--substep-report", "--threads",
          "--trace", "--trace-every", "--save", "--load", "--write-scene"})
        converge->excludes(app.get_option(other));
}

void add_inspect_flags(CLI::App& app, Flags& flags) {
    CLI::Option* inspect = app.add_option_function<std::vector<std::string>>(
        "--inspect",
        [&flags](const std::vector<std::string>& given) {
            flags.inspect = given.empty() || given[0].empty() ? "all" : given[0];
        },
        "Analyse the constraint system of a step for BODY; see below\n[default: all]");
    inspect->expected(0, 1)->type_name("[BODY|all]")->group("Inspection");
    const auto requires_mode = [&](CLI::Option* option) {
        return option->needs(inspect)->group("Inspection");
    };
    requires_mode(app.add_option("--at", flags.at,
                                 "Inspect after step N of the world [default: 60; 0 to 1e8]")
                      ->type_name("N")
                      ->check(CLI::Range(0, 100000000).description("")));
    requires_mode(app.add_option("--position-correction", flags.position_correction,
                                 "Correct this share of position errors per sub-step (Baumgarte)\n"
                                 "[default: 0; 0 to 1]")
                      ->type_name("RATIO")
                      ->check(between(0, 1)));
    requires_mode(app.add_option("--iterations", flags.iterations,
                                 "Maximum iterations of a method [default: 1000; 1 to 1000000]")
                      ->type_name("N")
                      ->check(CLI::Range(1, 1000000).description("")));
    requires_mode(
        app.add_option("--csv", flags.csv, "Write the residual per iteration to FILE as CSV")
            ->type_name("FILE"));
    requires_mode(app.add_flag("--solver-softness", flags.solver_softness,
                               "Use the softness of the solver's sweeps instead of rigid rows"));
    for (const char* other :
         {"--converge", "--seconds", "--trace", "--trace-every", "--save", "--write-scene"})
        inspect->excludes(app.get_option(other));
}

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option("SCENE", flags.scene, "Catalogue scene or scene file")->type_name("");
    app.add_option("--seconds", flags.seconds, "Simulated time [default: 10; 0 to 1e6]")
        ->type_name("SECONDS")
        ->check(between(0, 1e6));
    app.add_option("--hz", flags.hz, "Steps per second [default: the scene's; 4 to 10000]")
        ->type_name("HZ")
        ->check(between(4, 10000));
    app.add_option("--substeps", flags.substeps,
                   "Sub-steps per step [default: the scene's; 1 to 64]")
        ->type_name("N")
        ->check(CLI::Range(1, 64).description(""));
    app.add_option("--error-tolerance", flags.tolerance,
                   "Choose sub-steps per island for this error after 1 s; 0 disables\n"
                   "[default: the scene's; 0 to 1000]")
        ->type_name("METRES")
        ->check(between(0, 1e3));
    app.add_option("--substep-budget", flags.substep_budget,
                   "With a tolerance: limit the sub-steps per step, summed over the\nbodies; 0 is "
                   "unlimited "
                   "[default: the scene's; 0 to 4294967295]")
        ->type_name("N")
        ->check(between(0, 4294967295.0));
    app.add_option("--step-budget", flags.step_budget,
                   "Limit the work per step, in units of about 0.1 us; after a step above\n"
                   "the limit the next one reduces its quality; 0 is unlimited\n"
                   "[default: the scene's; 0 to 4294967295]")
        ->type_name("WORK")
        ->check(between(0, 4294967295.0));
    app.add_option("--threads", flags.threads,
                   "Threads of the step; the result is identical [default: 1; 1 to 64]")
        ->type_name("N")
        ->check(CLI::Range(1, 64).description(""));
    app.add_option("--instructions", flags.instructions,
                   "Instruction set of the inner loops: " + instruction_set_names() +
                       ";\nthe result is identical [default: the last]")
        ->type_name("NAME")
        ->check([](const std::string& name) {
            return find_instruction_set(name) ? std::string()
                                              : name + " is not one of " + instruction_set_names();
        });
    app.add_option("--sleep", flags.sleep, "Enable sleeping: on or off [default: the scene's]")
        ->type_name("SWITCH")
        ->check(CLI::IsMember({"on", "off"}).description(""));
    app.add_option("--load", flags.load, "Resume from a saved world of the same scene")
        ->type_name("FILE");
    app.add_flag("--list", flags.list, "Print the scene catalogue and exit");
    app.add_option("--json", flags.json, "Write the report to FILE as JSON")
        ->type_name("FILE")
        ->group("Output");
    app.add_option("--substep-report", flags.island_substeps,
                   "Write each island's final sub-steps to FILE as JSON; \"-\" prints text")
        ->type_name("FILE")
        ->group("Output");
    app.add_option("--trace", flags.trace, "Write poses and velocities to FILE as CSV")
        ->type_name("FILE")
        ->group("Output");
    app.add_option("--trace-every", flags.trace_every,
                   "Trace every N-th tick [default: 1; 1 to 1000000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000).description(""))
        ->group("Output");
    app.add_option("--save", flags.save, "Write the final world to FILE")
        ->type_name("FILE")
        ->group("Output");
    app.add_option("--write-scene", flags.write_scene, "Write the scene to FILE as a scene file")
        ->type_name("FILE")
        ->group("Output");
    add_converge_flags(app, flags);
    add_inspect_flags(app, flags);
    app.footer(footer);
}

int fail(int status, const std::string& message) {
    std::fprintf(stderr, "jostle-sim: %s\n", message.c_str());
    return status;
}

double process_cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Replaces the built world by a saved one, which has the ids of the scene that created it.
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

bool can_write(const std::string& path) {
    return path.empty() || std::ofstream(path, std::ios::app).good();
}

bool write_text(const std::string& path, const std::string& text) {
    std::ofstream out(path);
    out << text;
    out.close();
    return static_cast<bool>(out);
}

int run_converge(const jostle::scenes::SceneDescription& scene, const Flags& flags) {
    if (!can_write(flags.json)) return fail(1, "cannot write " + flags.json);
    jostle::sim::ConvergenceOptions options{.seconds = flags.seconds,
                                            .rates = flags.rates,
                                            .finest_hz = flags.finest_hz,
                                            .substeps = flags.substep_counts,
                                            .tolerances = flags.tolerances,
                                            .scale = flags.scale,
                                            .budget_seconds = flags.budget};
    std::sort(options.rates.begin(), options.rates.end());
    options.rates.erase(std::unique(options.rates.begin(), options.rates.end()),
                        options.rates.end());
    std::sort(options.tolerances.rbegin(), options.tolerances.rend());
    const auto found = jostle::sim::converge(scene, options, jostle::sim::show_line);
    jostle::sim::show_line("");
    if (!found) return fail(2, found.error().message);
    std::fputs(to_text(*found).c_str(), stdout);
    if (flags.json.empty()) return 0;
    std::ofstream out(flags.json);
    out << to_json(*found);
    out.close();
    return out ? 0 : fail(1, "cannot write " + flags.json);
}

int run_inspect(const jostle::scenes::SceneDescription& scene, jostle::scenes::BuiltScene& built,
                const Flags& flags) {
    for (const std::string& path : {flags.json, flags.csv})
        if (!can_write(path)) return fail(1, "cannot write " + path);
    World& world = built.world;
    if (world.step_count() > flags.at)
        return fail(2, "--at: the world is at step " + std::to_string(world.step_count()) +
                           " already; use a later step");
    {
        jostle::sim::Progress progress(flags.at - world.step_count());
        for (std::uint64_t step = 1; world.step_count() < flags.at; step++) {
            if (const Status s = world.step(1 / scene.hz); !s.ok())
                return fail(1, s.error().message);
            progress.at(step, world.profile().bodies_awake);
        }
    }
    const auto found =
        jostle::sim::inspect(scene, built,
                             {.body = flags.inspect,
                              .rows = {.position_correction = flags.position_correction,
                                       .solver_softness = flags.solver_softness},
                              .limits = {.iterations_max = flags.iterations}});
    if (!found.ok())
        return fail(found.error().code == jostle::ErrorCode::not_found ? 2 : 1,
                    found.error().message);
    std::fputs(to_text(*found).c_str(), stdout);
    if (!flags.json.empty())
        if (!write_text(flags.json, to_json(*found))) return fail(1, "cannot write " + flags.json);
    if (!flags.csv.empty() && !write_text(flags.csv, residuals_csv(*found)))
        return fail(1, "cannot write " + flags.csv);
    return 0;
}

int run(const Flags& flags) {
    if (const auto set = find_instruction_set(flags.instructions))
        if (const Status s = jostle::physics::use_instruction_set(*set); !s.ok())
            return fail(2, s.error().message);
    auto scene = jostle::scenes::load_scene(flags.scene);
    if (!scene.ok()) return fail(2, scene.error().message);
    if (flags.hz) scene->hz = *flags.hz;
    if (flags.substeps) scene->world.substeps = *flags.substeps;
    if (flags.tolerance) scene->world.tolerance = *flags.tolerance;
    if (flags.substep_budget)
        scene->world.substep_budget = static_cast<std::int64_t>(*flags.substep_budget);
    if (flags.step_budget) scene->world.step_budget = static_cast<std::int64_t>(*flags.step_budget);
    if (!flags.sleep.empty()) scene->world.sleeping = flags.sleep == "on";
    if (flags.converge) return run_converge(*scene, flags);
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
    if (!flags.inspect.empty()) return run_inspect(*scene, *built, flags);
    std::unique_ptr<jostle::sim::Trace> trace;
    if (!flags.trace.empty()) {
        trace = jostle::sim::Trace::open(flags.trace);
        if (!trace) return fail(1, "cannot write " + flags.trace);
        trace->write(built->world.step_count(), *built, *scene);
    }

    const auto steps = static_cast<std::uint64_t>(std::llround(flags.seconds * scene->hz));
    jostle::sim::StepStatistics meter;
    jostle::sim::ToleranceCheck tolerance(built->world.tolerance(), scene->hz);
    double cpu_ms = 0;
    {
        jostle::sim::Progress progress(steps);
        for (std::uint64_t step = 1; step <= steps; step++) {
            const double before = process_cpu_ms();
            const auto began = std::chrono::steady_clock::now();
            if (const Status s = built->world.step(1 / scene->hz); !s.ok())
                return fail(1, s.error().message);
            const std::chrono::duration<double, std::milli> took =
                std::chrono::steady_clock::now() - began;
            cpu_ms += process_cpu_ms() - before;
            meter.add(built->world.profile(), took.count());
            if (built->world.tolerance() > 0) tolerance.add(built->world.island_substeps());
            if (trace && step % static_cast<std::uint64_t>(flags.trace_every) == 0)
                trace->write(built->world.step_count(), *built, *scene);
            progress.at(step, built->world.profile().bodies_awake);
        }
    }
    if (trace && !trace->close())
        return fail(1, "cannot write " + flags.trace + ": the file is incomplete");

    jostle::sim::Report report{.scene = scene->name,
                               .threads = flags.threads,
                               .substeps = built->world.substeps(),
                               .hz = scene->hz};
    meter.fill(report, built->world);
    report.cpu_ms_per_step_mean = steps > 0 ? cpu_ms / static_cast<double>(steps) : 0;
    if (built->world.tolerance() > 0) report.tolerance = tolerance.verdict();
    std::fputs(to_text(report).c_str(), stdout);
    if (!flags.json.empty()) {
        std::ofstream out(flags.json);
        out << to_json(report);
        if (!out) return fail(1, "cannot write " + flags.json);
    }
    if (flags.island_substeps == "-")
        std::fputs(jostle::sim::to_text(built->world.island_substeps()).c_str(), stdout);
    else if (!flags.island_substeps.empty() &&
             !write_text(flags.island_substeps,
                         jostle::sim::to_json(built->world.island_substeps())))
        return fail(1, "cannot write " + flags.island_substeps);
    if (report.tolerance) std::fputs(to_text(*report.tolerance).c_str(), stdout);
    if (!flags.save.empty() && !save_world(built->world, flags.save))
        return fail(1, "cannot write " + flags.save);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Run a scene offline as fast as possible and report its cost and its final state."};
    Flags flags;
    add_flags(app, flags);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-sim", JOSTLE_VERSION}, argc, argv))
        return *status;
    if (flags.list) {
        for (const auto& scene : jostle::scenes::catalog())
            std::printf("%-12.*s %.*s\n", static_cast<int>(scene.name.size()), scene.name.data(),
                        static_cast<int>(scene.description.size()), scene.description.data());
        return 0;
    }
    if (flags.scene.empty())
        return fail(2, "a scene is missing; use a scene file or a scene of --list");
    return run(flags);
}
