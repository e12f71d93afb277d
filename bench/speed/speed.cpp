// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "bench/speed/engine_kinds.h"
#include "bench/speed/growth.h"
#include "bench/speed/server_row.h"
#include "bench/speed/speed_row.h"
#include "bench/speed/speed_scenes.h"
#include "bench/speed/speed_table.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
All scenes have 60 steps per second, gravity 9.81 m/s^2, density 1000 kg/m^3, friction 0.5 for each
pair, no restitution, and damping 0.05 /s; only wheels, wheels_mesh and mixed_masses have densities
and frictions of their own. --scene moving selects the scenes in which all bodies move. The options
of scenes (--count and others) apply to each selected scene that has them, and the end of a line and
the result files state their values. Each row runs in its own process, so that its memory is
measured separately; if an engine crashes, its row records the failure. Only the steps are timed, in
CPU time of the thread with one thread and in wall-clock time with more threads (column clock). A
second run of the same steps checks the accuracy every 10 steps, from the geometry of the shapes and
equally for all engines.

Columns:
  ms_mean                    of a step
  moving, rest               ms_mean of the steps in which at least 5 % of the bodies are faster
                             than 5 cm/s, and of the others
  ms_p99, ms_worst           without the first step
  ms_first                   of the first step
  deep_mm, mean_mm, >1cm     at the end: deepest overlap, mean overlap, pairs deeper than 1 cm
  peak_mm                    deepest overlap of all checks
  drift_mm, worst_mm         distance between the two anchors of a joint: at the end, worst
  asleep                     first step at which all bodies slept; the player of scene e is released
                             after the last step, so the number may be larger than the steps
  awake, moving              at the end: awake bodies, bodies faster than 5 cm/s
  top_m                      highest centre at the end
  tunnel                     bodies that passed the wall of scenes i and box_shot
  MiB                        peak memory of the process

--growth measures one scene with several numbers of bodies: 300 steps, then the mean of 60, and the
memory per body. A pile is scene d on a floor of 0.02 m^2 per body, so that its depth is constant; a
chain is scene chain. The last lines fit ms_mean = c * bodies^p to the rows of each engine (least
squares of the logarithms): exponent p is 1 if the time per body is constant.

--server measures a whole server: jostle-server hosts each scene, --clients clients of jostle-load
play in it over loopback, and jostlectl records its ticks from the time when all clients have
joined. The programs must be in the directory of jostle-bench. A server hosts the scenes of its
catalogue: a to i, and of moving those up to junkyard in the list above. --threads sets
tick.physics_threads; all other settings are the defaults of the server. Columns:
  ticks, late, late%         ticks that ran; ticks that never ran because the world was late by more
                             than it may catch up; their share of all due ticks
  over                       ticks that took longer than a period
  ms_mean, ms_p99, ms_worst  of whole ticks (inputs, step, frame, replies)
  begun                      largest delay of the start of a tick, ms
  clients                    connected at the end
  snaps/s, kbit/s            received per client
  age_p50, age_p99           age of a snapshot when its client has decoded it, ms
  errors, cpu%               errors of the clients; CPU time of the server, percent of one core
A world holds its rate if no tick took longer than a period, and catches up if some did and none was
dropped. The exit status is 0 in all cases.

Examples:
  jostle-bench speed --scene a,c --threads 1,2
  jostle-bench speed --scene all --json speed.json --csv speed.csv
  tools/analysis/plot.py speed speed.csv -o speed.svg
  jostle-bench speed --server --scene trees,washer --json server.json
  jostle-bench speed --scene wheels,wheels_mesh --wheels 8 --cell 1 --peers none
  jostle-bench speed --growth 500,1000,2000 --peers bullet --csv growth.csv
  jostle-bench speed --growth 100,1000,10000 --growth-of chain --peers none

Exit status: 0 success, 1 a row failed or a file could not be written, 2 invalid flags.)";

constexpr int clients_max = 250;  // the server's limit per address

struct Flags {
    std::vector<std::string> scenes = {"all"};
    std::vector<int> threads = {1};
    std::vector<std::string> peers = {"all"};
    std::vector<int> growth;
    std::string growth_of = "pile";
    ParameterValues parameters;
    bool server = false;
    int clients = 20;
    double seconds = 10;
    std::string script;
    int steps = 0;  // 0: the scene's default
    std::string sleep = "off";
    bool no_accuracy = false;
    std::string json, csv;
};

// --- values of the flags ---

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

// Returns an empty string for a valid value, otherwise an error message, as CLI11 expects.
std::string check_scene(const std::string& name) {
    if (name == "all" || name == "moving" || find_speed_scene(name)) return "";
    return "unknown scene " + name + "; must be one of " + scene_names();
}

std::string check_peer(const std::string& name) {
    if (name == "all" || name == "none") return "";
    const EngineKind* kind = find_engine_kind(name);
    if (!kind || kind == &engine_kinds()[0])
        return "unknown peer " + name + "; must be one of " + peer_names();
    if (kind->make) return "";
    return name + " is not built in: install its library (scripts/setup --with-peers), then run " +
           "cmake and build again";
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_named(const Flags& flags, const SpeedScene& scene) {
    return contains(flags.scenes, scene.letter) || contains(flags.scenes, scene.name);
}

// For a server, all and moving select the scenes of the catalogue.
std::vector<const SpeedScene*> selected_scenes(const Flags& flags) {
    std::vector<const SpeedScene*> chosen;
    for (const SpeedScene& scene : speed_scenes()) {
        const bool is_in_group =
            contains(flags.scenes, "all") || (scene.all_move && contains(flags.scenes, "moving"));
        if (is_named(flags, scene) || (is_in_group && (!flags.server || is_in_catalogue(scene))))
            chosen.push_back(&scene);
    }
    return chosen;
}

// Jostle with every number of threads, and each peer once.
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

// --- runs ---

bool write_files(const Flags& flags, const nlohmann::ordered_json& head,
                 const nlohmann::ordered_json& rows) {
    const bool json_done = flags.json.empty() || write_result(flags.json, head, rows);
    const bool csv_done = flags.csv.empty() || write_text(flags.csv, csv_text(rows));
    return json_done && csv_done;
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

// Collects the rows of a table and writes the files. The exit status is 1 if a row failed or a file
// could not be written.
template <class Row>
struct Table {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    bool failed = false;

    void add(const Row& row, const std::string& line) {
        print_line(line);
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
                                                       .accuracy = !flags.no_accuracy,
                                                       .parameters = flags.parameters});
            table.add(row, speed_line(row));
        }
    nlohmann::ordered_json head = result_header("speed");
    head["sleep"] = flags.sleep;
    return write_files(flags, head, table.json) && !table.failed ? 0 : 1;
}

int run_growth(const Flags& flags) {
    const GrowthScene& scene = *find_growth_scene(flags.growth_of);
    Table<GrowthRow> table;
    std::vector<GrowthRow> rows;
    print_line(growth_heading());
    for (const int bodies : flags.growth)
        for (const EngineConfiguration& configuration : configurations(flags)) {
            rows.push_back(measure_growth_in_child(scene, *configuration.engine,
                                                   configuration.threads, bodies));
            table.add(rows.back(), growth_line(rows.back()));
        }
    nlohmann::ordered_json head = result_header("speed growth");
    head["steps_before"] = growth_steps_before;
    head["steps_timed"] = growth_steps_timed;
    head["exponents"] = nlohmann::ordered_json::array();
    for (const GrowthFit& fit : fit_growth(rows)) {
        print_line(growth_fit_line(fit));
        head["exponents"].push_back(to_json(fit));
    }
    return write_files(flags, head, table.json) && !table.failed ? 0 : 1;
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
    return write_files(flags, head, table.json) && !table.failed ? 0 : 1;
}

int run(const Flags& flags) {
    for (const std::string& path : {flags.json, flags.csv})
        if (!path.empty() && !can_write(path)) return 1;
    if (flags.server) return run_server(flags);
    if (contains(flags.peers, "all"))
        for (const std::string& peer : missing_peers())
            std::fprintf(stderr, "jostle-bench: %s is not built in\n", peer.c_str());
    return flags.growth.empty() ? run_scenes(flags) : run_growth(flags);
}

// "--wheels N [default: 10; 2 to 32, even]"
std::string option_text(const ParameterRange& range) {
    const ParameterKind& kind = parameter_kinds()[static_cast<std::size_t>(range.parameter)];
    char standard[32];
    std::snprintf(standard, sizeof standard, "%g", range.standard);
    return std::string(kind.option) + " " + kind.type_name + " [default: " + standard + "; " +
           range_text(range) + "]";
}

std::string scene_and_engine_list() {
    std::string text = "Scenes:\n";
    for (const SpeedScene& scene : speed_scenes()) {
        text += std::string("  ") + scene.letter + "  " + scene.name + ", " +
                std::to_string(scene.steps) + " steps: " + description_of(scene) + "\n";
        for (const ParameterRange& range : scene.parameters)
            text += "      " + option_text(range) + "\n";
    }
    text += "\nEngines (peers run on one thread, regardless of --threads):\n";
    for (const EngineKind& kind : engine_kinds())
        text += std::string("  ") + kind.name + (kind.make ? "" : " (not built in)") + ": " +
                kind.settings + "\n";
    return text;
}

// Accepts the whole text only: CLI11 reads empty text as 0.
double to_number(const char* option, const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc{} && rest == end) return number;
    throw CLI::ConversionError(std::string(option) + ": '" + text + "' is not a number");
}

// The options that set parameters of scenes. The list of scenes states their defaults and ranges.
void add_parameters(CLI::App& command, Flags& flags) {
    for (std::size_t k = 0; k < parameter_count; k++) {
        const ParameterKind& kind = parameter_kinds()[k];
        std::optional<double>& value = flags.parameters[k];
        command
            .add_option_function<std::string>(
                kind.option,
                [&value, &kind](const std::string& text) { value = to_number(kind.option, text); },
                kind.help)
            ->type_name(kind.type_name)
            ->group("Options of scenes");
    }
}

// Throws an error for a flag that does not fit the selected scenes.
void check_selection(const Flags& flags) {
    for (std::size_t k = 0; k < parameter_count; k++)
        if (flags.parameters[k] && (flags.server || !flags.growth.empty()))
            throw CLI::ValidationError(std::string(parameter_kinds()[k].option) +
                                       ": not supported with --growth or --server");
    const std::vector<const SpeedScene*> selected = selected_scenes(flags);
    if (const auto status = check_parameters(selected, flags.parameters); !status)
        throw CLI::ValidationError(status.error().message);
    if (!flags.server) return;
    for (const SpeedScene* scene : selected)
        if (!is_in_catalogue(*scene) && is_named(flags, *scene))
            throw CLI::ValidationError(std::string("--scene: ") + scene->letter +
                                       " is not in the catalogue of jostle-server");
}

// Adds the flags that require --server; excludes the flags that do not apply to a server.
void add_server_flags(CLI::App& command, Flags& flags, std::initializer_list<CLI::Option*> others) {
    CLI::Option* server =
        command.add_flag("--server", flags.server,
                         "Measure a server with clients instead of the engines\n"
                         "[default scenes: c and those of moving in its catalogue]");
    for (CLI::Option* other : others) server->excludes(other);
    command
        .add_option("--clients", flags.clients,
                    "Connect N clients to the server [default: 20; 1 to 250]")
        ->type_name("N")
        ->check(CLI::Range(1, clients_max).description(""))
        ->needs(server);
    command
        .add_option("--seconds", flags.seconds,
                    "Record each server for this time [default: 10; 1 to 30]")
        ->type_name("SECONDS")
        ->check(CLI::Range(1.0, 30.0).description(""))
        ->needs(server);
    command
        .add_option("--script", flags.script,
                    "Run this script in the clients; see jostle-bot --help\n"
                    "[default: push bodies]")
        ->type_name("FILE")
        ->check(CLI::ExistingFile.description(""))
        ->needs(server);
}

}  // namespace

void add_speed(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("speed", "Measure time, error and memory of Jostle and other engines");
    const auto flags = std::make_shared<Flags>();
    CLI::Option* scene =
        command
            ->add_option("--scene", flags->scenes,
                         "Run scenes by letter or name; all or moving; see below\n[default: all]")
            ->type_name("NAME")
            ->delimiter(',')
            ->check(CLI::Validator(check_scene, ""));
    command
        ->add_option("--threads", flags->threads,
                     "Run Jostle with these numbers of threads [default: 1; 1 to 64]")
        ->type_name("N")
        ->delimiter(',')
        ->check(CLI::Range(1, 64).description(""));
    CLI::Option* peers =
        command
            ->add_option("--peers", flags->peers,
                         "Run peer engines by name; all that are built in, or none\n"
                         "[default: all]")
            ->type_name("NAME")
            ->delimiter(',')
            ->check(CLI::Validator(check_peer, ""));
    CLI::Option* steps =
        command
            ->add_option("--steps", flags->steps,
                         "Steps per scene [default: those of the scene; 1 to 1000000]")
            ->type_name("N")
            ->check(CLI::Range(1, 1000000).description(""));
    CLI::Option* sleep =
        command->add_option("--sleep", flags->sleep, "Enable sleeping: on or off [default: off]")
            ->type_name("on|off")
            ->check(CLI::IsMember({"on", "off"}).description(""));
    CLI::Option* no_accuracy = command->add_flag("--no-accuracy", flags->no_accuracy,
                                                 "Skip the second run, which checks the accuracy");
    CLI::Option* growth = command
                              ->add_option("--growth", flags->growth,
                                           "Measure a pile or chain with these numbers of bodies\n"
                                           "[1 to 1000000]")
                              ->type_name("N")
                              ->delimiter(',')
                              ->check(CLI::Range(1, 1000000).description(""))
                              ->excludes(scene)
                              ->excludes(steps);
    command
        ->add_option("--growth-of", flags->growth_of,
                     "Scene of --growth: pile or chain [default: pile]")
        ->type_name("pile|chain")
        ->check(CLI::IsMember({"pile", "chain"}).description(""))
        ->needs(growth);
    command->add_option("--json", flags->json, "Write the rows as JSON")->type_name("FILE");
    command->add_option("--csv", flags->csv, "Write the rows as CSV")->type_name("FILE");
    add_parameters(*command, *flags);
    add_server_flags(*command, *flags, {peers, steps, sleep, no_accuracy, growth});
    command->footer("\n" + scene_and_engine_list() + footer);
    command->callback([flags, scene, &status] {
        if (flags->server && scene->count() == 0) flags->scenes = {"c", "moving"};
        check_selection(*flags);
        status = run(*flags);
    });
}

}  // namespace jostle::bench
