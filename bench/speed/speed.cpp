// SPDX-License-Identifier: MIT
#include "bench/speed/speed.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "bench/speed/engine_kinds.h"
#include "bench/speed/growth.h"
#include "bench/speed/measure_row.h"
#include "bench/speed/measure_server_row.h"
#include "bench/speed/speed_plot.h"
#include "bench/speed/speed_scenes.h"
#include "bench/speed/speed_table.h"
#include "jostle/scenes/catalog.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
Common to all scenes: 60 steps a second, gravity 9.81 m/s^2, density 1000 kg/m^3, friction 0.5 of
each pair, no bounce, damping 0.05 /s. Each row runs in a process of its own: its memory is its own,
and an engine that crashes leaves a row that says so. Steps are timed alone, in processor time of
the thread at one thread and in wall-clock time at more (column clock). A second run of the same
steps is checked for accuracy every 10 steps, by the shapes' geometry and the same for all engines.

Columns: ms_mean of a step, the same in the steps while a twentieth of the bodies moves (faster than
5 cm/s) and while all rests; ms_p99, ms_worst without the first step, ms_first; deep_mm,
mean_mm and >1cm: deepest overlap, mean overlap and pairs deeper than 1 cm at the end; peak_mm: deepest at any look; drift_mm and worst_mm: how far the
two ends of a joint are apart, at the end and at worst; asleep: the step by which all slept; the
player of scene e is let go after the last one, so its step comes later; awake and moving: bodies
that do not sleep at the end, and those faster than 5 cm/s; top_m: highest centre at the end; tunnel:
bodies behind the wall of scene i; MiB: peak of the process.

--growth pours scene d with other counts over a floor that grows with the count (0.02 m^2 a body),
so that the pile stays as deep: 300 steps, then the mean of 60, and the memory a body takes.

--server measures no solver but a whole server: jostle-server hosts each scene, --clients real clients
of jostle-load play in it over loopback, and jostlectl records its ticks from the moment in which the
last has joined. The programs are those beside this one; --threads is the server's
tick.physics_threads, and all else has the server's defaults. It stands here, and not in a subcommand
of its own, as it takes the scenes, threads and files of the other rows. Columns: ticks that ran;
late: ticks that never ran, as the world was late by more than it may catch up, and their share of all
that were due; over: ticks that took longer than a period; ms of whole ticks (inputs, step, frame,
answers); begun: how late a tick began at worst, ms; clients connected to the end; snapshots and kbit
a second and client; age of a snapshot when its client has decoded it, ms; errors; processor time of
the server, of one core. A scene holds its rate when no tick took longer than a period, and catches up
when some did and none was given up; the exit status is 0 either way.

Examples:
  jostle-bench speed --scene a,c --threads 1,2
  jostle-bench speed --scene all --json speed.json --plot speed.svg
  jostle-bench speed --server --scene trees,washer --json server.json
  jostle-bench speed --growth 500,1000,2000 --peers bullet --plot growth.svg

Exit status: 0 done, 1 a row failed or a file could not be written, 2 wrong flags.)";

constexpr int clients_max = 250;  // that a server lets in from one address

struct Flags {
    std::vector<std::string> scenes = {"all"};
    std::vector<int> threads = {1};
    std::vector<std::string> peers = {"all"};
    std::vector<int> growth;
    bool server = false;
    int clients = 20;
    double seconds = 10;
    std::string script;
    int steps = 0;  // 0: the scene's own
    std::string sleep = "off";
    bool no_accuracy = false;
    std::string json, plot;
};

// --- what the flags name ---

std::string scene_names() {
    std::string contains = "all, moving";
    for (const SpeedScene& scene : speed_scenes())
        contains += std::string(", ") + scene.letter + " or " + scene.name;
    return contains;
}

std::string peer_names() {
    std::string contains = "all, none";
    for (const EngineKind& kind : engine_kinds().subspan(1))
        contains += std::string(", ") + kind.name + (kind.make ? "" : " (not built in)");
    return contains;
}

// Empty when right, else what is wrong: what CLI11 asks of a check.
std::string check_scene(const std::string& name) {
    if (name == "all" || name == "moving" || find_speed_scene(name)) return "";
    return "there is no scene " + name + "; there are " + scene_names();
}

std::string check_peer(const std::string& name) {
    if (name == "all" || name == "none") return "";
    const EngineKind* kind = find_engine_kind(name);
    if (!kind || kind == &engine_kinds()[0])
        return "there is no peer " + name + "; there are " + peer_names();
    if (kind->make) return "";
    return name + " is not built in: install its library (scripts/setup --with-peers), then run " +
           "cmake and build anew";
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

std::vector<const SpeedScene*> selected_scenes(const Flags& flags) {
    std::vector<const SpeedScene*> chosen;
    for (const SpeedScene& scene : speed_scenes())
        if (contains(flags.scenes, "all") || contains(flags.scenes, scene.letter) ||
            contains(flags.scenes, scene.name) ||
            (scene.all_move && contains(flags.scenes, "moving")))
            chosen.push_back(&scene);
    return chosen;
}

// Jostle at every number of threads, and each peer once.
struct EngineConfiguration {
    const EngineKind* engine;
    int threads;
};

std::vector<EngineConfiguration> configurations(const Flags& flags) {
    std::vector<EngineConfiguration> chosen;
    for (const EngineKind& kind : engine_kinds()) {
        if (kind.threads_max > 1)
            for (const int threads : flags.threads) chosen.push_back({&kind, threads});
        else if (kind.make && (contains(flags.peers, "all") || contains(flags.peers, kind.name)))
            chosen.push_back({&kind, 1});
    }
    return chosen;
}

std::vector<std::string> missing_peers() {
    std::vector<std::string> absent;
    for (const EngineKind& kind : engine_kinds())
        if (!kind.make) absent.push_back(kind.name);
    return absent;
}

// --- the run ---

std::string machine_note() {
    return cpu_model() + ", " + compiler();
}

bool write_files(const Flags& flags, const nlohmann::ordered_json& head,
                 const nlohmann::ordered_json& rows, const std::string& plot) {
    const bool json_done = flags.json.empty() || write_result(flags.json, head, rows);
    const bool plot_done = flags.plot.empty() || write_text(flags.plot, plot);
    return json_done && plot_done;
}

nlohmann::ordered_json result_header(const char* benchmark) {
    return {{"benchmark", benchmark},
            {"cpu", cpu_model()},
            {"compiler", compiler()},
            {"peers_not_built_in", missing_peers()}};
}

void print_line(const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

// A table of rows, and then the files. 1 when a row failed or a file could not be written.
template <class Row>
struct Table {
    std::vector<Row> rows;
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    bool failed = false;

    void add(const Row& row, const std::string& line) {
        print_line(line);
        rows.push_back(row);
        json.push_back(to_json(row));
        failed = failed || row.failed;
    }
};

int run_scenes(const Flags& flags) {
    Table<SpeedRow> table;
    print_line(speed_heading());
    for (const SpeedScene* scene : selected_scenes(flags))
        for (const EngineConfiguration& configuration : configurations(flags)) {
            const SpeedRow row = measure_row_in_child({.scene = scene,
                                                       .engine = configuration.engine,
                                                       .threads = configuration.threads,
                                                       .steps = flags.steps,
                                                       .sleep = flags.sleep == "on",
                                                       .accuracy = !flags.no_accuracy});
            table.add(row, speed_line(row));
        }
    nlohmann::ordered_json head = result_header("speed");
    head["sleep"] = flags.sleep;
    const bool written =
        write_files(flags, head, table.json, plot_speed(table.rows, machine_note()));
    return written && !table.failed ? 0 : 1;
}

int run_growth(const Flags& flags) {
    Table<GrowthRow> table;
    print_line(growth_heading());
    for (const int bodies : flags.growth)
        for (const EngineConfiguration& configuration : configurations(flags)) {
            const GrowthRow row =
                measure_growth_in_child(*configuration.engine, configuration.threads, bodies);
            table.add(row, growth_line(row));
        }
    nlohmann::ordered_json head = result_header("speed growth");
    head["steps_before"] = growth_steps_before;
    head["steps_timed"] = growth_steps_timed;
    const bool written =
        write_files(flags, head, table.json, plot_growth(table.rows, machine_note()));
    return written && !table.failed ? 0 : 1;
}

int run_server(const Flags& flags) {
    Table<ServerRow> table;
    print_line(server_heading());
    for (const SpeedScene* scene : selected_scenes(flags))
        for (const int threads : flags.threads) {
            const ServerRow row = measure_server_row({.scene = scene,
                                                      .threads = threads,
                                                      .clients = flags.clients,
                                                      .seconds = flags.seconds,
                                                      .script = flags.script});
            table.add(row, server_line(row));
        }
    nlohmann::ordered_json head = result_header("speed server");
    head.erase("peers_not_built_in");
    return write_files(flags, head, table.json, "") && !table.failed ? 0 : 1;
}

int run(const Flags& flags) {
    for (const std::string& path : {flags.json, flags.plot})
        if (!path.empty() && !can_write(path)) return 1;
    if (flags.server) return run_server(flags);
    if (contains(flags.peers, "all"))
        for (const std::string& peer : missing_peers())
            std::fprintf(stderr, "jostle-bench: %s is not built in\n", peer.c_str());
    return flags.growth.empty() ? run_scenes(flags) : run_growth(flags);
}

std::string about(const SpeedScene& scene) {
    for (const scenes::CatalogEntry& entry : scenes::catalog())
        if (entry.name == scene.name) return std::string(entry.description);
    return "";
}

std::string scene_and_engine_list() {
    std::string text = "Scenes:\n";
    for (const SpeedScene& scene : speed_scenes())
        text += std::string("  ") + scene.letter + "  " + scene.name + ", " +
                std::to_string(scene.steps) + " steps: " + about(scene) + "\n";
    text += "\nEngines (peers run on one thread, whatever --threads says):\n";
    for (const EngineKind& kind : engine_kinds())
        text += std::string("  ") + kind.name + (kind.make ? "" : " (not built in)") + ": " +
                kind.settings + "\n";
    return text;
}

// Beside --server: what only it takes, and what says nothing about a server.
void add_server_flags(CLI::App& command, Flags& flags, std::initializer_list<CLI::Option*> others) {
    CLI::Option* server = command.add_flag(
        "--server", flags.server,
        "Instead of the solver: a server with clients; scenes c and moving unless named");
    for (CLI::Option* other : others) server->excludes(other);
    command.add_option("--clients", flags.clients, "Of the server")
        ->capture_default_str()
        ->check(CLI::Range(1, clients_max))
        ->needs(server);
    command.add_option("--seconds", flags.seconds, "For how long each server is watched")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 30.0))
        ->needs(server);
    command
        .add_option("--script", flags.script,
                    "What clients do (jostle-bot --help has the format); they push things about")
        ->check(CLI::ExistingFile)
        ->needs(server);
}

}  // namespace

void add_speed(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "speed", "Jostle and other engines on the same scenes: time, error and memory.");
    const auto flags = std::make_shared<Flags>();
    CLI::Option* scene = command->add_option("--scene", flags->scenes, "By letter or name, or all")
                             ->delimiter(',')
                             ->capture_default_str()
                             ->check(CLI::Validator(check_scene, "SCENE"));
    command->add_option("--threads", flags->threads, "For Jostle; several with commas")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::Range(1, 64));
    CLI::Option* peers =
        command
            ->add_option("--peers", flags->peers, "Beside Jostle: all that are built in, or none")
            ->delimiter(',')
            ->capture_default_str()
            ->check(CLI::Validator(check_peer, "PEER"));
    CLI::Option* steps =
        command->add_option("--steps", flags->steps, "Instead of the scene's own number")
            ->check(CLI::Range(1, 1000000));
    CLI::Option* sleep =
        command->add_option("--sleep", flags->sleep, "Whether bodies may sleep: on or off")
            ->capture_default_str()
            ->check(CLI::IsMember({"on", "off"}));
    CLI::Option* no_accuracy =
        command->add_flag("--no-accuracy", flags->no_accuracy, "Times only: no second run");
    CLI::Option* growth = command
                              ->add_option("--growth", flags->growth,
                                           "Instead of scenes: piles of so many bodies each")
                              ->delimiter(',')
                              ->check(CLI::Range(1, 1000000))
                              ->excludes(scene)
                              ->excludes(steps);
    command->add_option("--json", flags->json, "Writes the rows here as JSON");
    CLI::Option* plot = command->add_option("--plot", flags->plot, "Draws them here as SVG");
    add_server_flags(*command, *flags, {peers, steps, sleep, no_accuracy, growth, plot});
    command->footer("\n" + scene_and_engine_list() + footer);
    command->callback([flags, scene, &status] {
        if (flags->server && scene->count() == 0) flags->scenes = {"c", "moving"};
        status = run(*flags);
    });
}

}  // namespace jostle::bench
