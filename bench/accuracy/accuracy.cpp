// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_report.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/faults.h"
#include "bench/accuracy/flag_selection.h"
#include "bench/accuracy/regression.h"
#include "bench/accuracy/run_row.h"
#include "bench/measure.h"
#include "bench/result_file.h"

namespace jostle::bench {
namespace {

using namespace accuracy;

constexpr const char* footer = R"(
Each row runs in its own process; if an engine crashes, its row records the failure. Errors are
measured at the end of each step, against a closed-form solution or the classical Runge-Kutta method
at 19200 Hz. Impact scenes run from 16 initial states, 1/16 of a step apart; the reported error is
the root mean square. The time is the CPU time of the step calls per simulated second, the lowest of
up to four runs. A row fails if a body is lost or the engine reports an error.

Examples:
  jostle-bench accuracy --scene j1,j2 --peers none
  jostle-bench accuracy --scene all --rates 30,60,120 --csv accuracy.csv --scenes-csv scenes.csv
  tools/analysis/plot.py accuracy accuracy.csv scenes.csv -o accuracy.svg
  jostle-bench accuracy --scene c8 --modes default --peers bullet,ode
  jostle-bench accuracy --scene slide,graded --peers none
  jostle-bench accuracy --regression --scene slide --draw 50 --seed 7
  jostle-bench accuracy --scene none --merge accuracy.csv --json accuracy.json
  jostle-bench accuracy --scene c9-r100 --merge accuracy.json --json both.json
  jostle-bench accuracy --regression --compare-to bench/results/accuracy_short.json
      --known-faults bench/results/accuracy_faults.json

--regression also checks two rules and reports a fault for each violation:
  finer  The error at a rate is at most 4/3 of the larger of the least error at any coarser rate of
         the same scene and mode, and a tenth of the scene's finest tolerance.
  limit  In the default mode, the errors of a member of a family are at most the limits of the
         family, at 60 Hz and finer rates (overlap: 30 Hz).

Exit status: 0 success, 1 a file could not be read or written, --compare-to found a regression or
--regression found a fault that --known-faults does not list, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> scenes = {"all"};
    std::vector<std::string> rates = {"30", "60", "120", "240", "480"};
    std::vector<std::string> peers = {"all"};
    std::vector<std::string> modes = {"all"};
    std::string json, csv, scenes_csv, tables, add, against, known_faults;
    bool regression = false, update = false;
    int draw = 0;  // members of each family; 0: those of every run
    std::uint64_t seed = 2;

    std::vector<const Experiment*> experiments() const {
        return draw > 0 ? drawn_experiments(scenes, draw, seed) : selected_experiments(scenes);
    }
};

void print_row(const Row& row) {
    if (!row.unsupported.empty()) return;
    if (row.usable())
        std::printf("%-14s %-8s %-18s %6g %11.4g %11.4g %12.4g\n", row.scene.c_str(),
                    row.engine.c_str(), row.mode.c_str(), row.rate_hz, row.error, row.second_error,
                    row.cpu_us_per_second);
    else
        std::printf("%-14s %-8s %-18s %6g  failed: %s\n", row.scene.c_str(), row.engine.c_str(),
                    row.mode.c_str(), row.rate_hz, row.failed.c_str());
    std::fflush(stdout);
}

// Runs all rates of one mode. Stops if the engine does not support the scene or a rate takes too
// long.
void run_mode(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
              const Flags& flags, std::vector<Row>& rows) {
    for (const std::string& rate : flags.rates) {
        const double hz = std::stod(rate);
        if (hz > experiment.max_hz) continue;
        show_progress(experiment.name + " " + kind.name + " " + mode + " " + rate + " Hz");
        Row row = run_row_in_child(experiment, kind, mode, hz);
        show_progress("");
        print_row(row);
        rows.push_back(row);
        if (!row.unsupported.empty() || row.failed == takes_too_long) return;
    }
}

// Reads the rows of a file written by --json or --csv; reports errors on stderr.
std::optional<std::vector<Row>> earlier_rows(const std::string& path) {
    std::vector<Row> rows;
    if (path.empty()) return rows;
    std::ifstream in(path);
    try {
        if (path.ends_with(".csv")) return rows_from_csv(in);
        const auto json = nlohmann::ordered_json::parse(in);
        for (const auto& row : json.at("rows")) rows.push_back(row_from(row));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "jostle-bench: no rows in %s: %s\n", path.c_str(), error.what());
        return {};
    }
    return rows;
}

// The experiments that have rows.
std::vector<const Experiment*> reported(const std::vector<Row>& rows) {
    std::vector<const Experiment*> experiments;
    const auto has_rows = [&](const Experiment& experiment) {
        return std::any_of(rows.begin(), rows.end(),
                           [&](const Row& row) { return row.scene == experiment.name; });
    };
    for (const Experiment& experiment : all_experiments())
        if (has_rows(experiment)) experiments.push_back(&experiment);
    for (const Row& row : rows) {  // drawn members
        const Experiment* experiment = find_experiment(row.scene);
        if (experiment &&
            std::find(experiments.begin(), experiments.end(), experiment) == experiments.end())
            experiments.push_back(experiment);
    }
    return experiments;
}

std::vector<Row> run_rows(const Flags& flags, std::vector<Row> rows) {
    std::printf("%-14s %-8s %-18s %6s %11s %11s %12s\n", "scene", "engine", "mode", "rate", "error",
                "second", "cpu us/s");
    for (const Experiment* experiment : flags.experiments()) {
        // computes the reference, which child processes inherit
        static_cast<void>(experiment->start(0));
        for (const EngineKind* kind : selected_engines(flags.peers))
            for (const std::string& mode : selected_modes(*kind, flags.modes))
                run_mode(*experiment, *kind, mode, flags, rows);
    }
    return rows;
}

bool write_files(const Flags& flags, const std::vector<Row>& rows, const Score& score) {
    bool done = true;
    if (!flags.json.empty()) {
        nlohmann::ordered_json head = result_header("accuracy");
        head["work"] = work_json(rows);
        head["score"] = score_json(score);
        nlohmann::ordered_json json = nlohmann::ordered_json::array();
        for (const Row& row : rows) json.push_back(to_json(row));
        done = write_result(flags.json, head, json) && done;
    }
    if (!flags.csv.empty()) {
        std::string text = csv_heading() + "\n";
        for (const Row& row : rows)
            if (row.unsupported.empty()) text += csv_line(row) + "\n";
        done = write_text(flags.csv, text) && done;
    }
    if (!flags.scenes_csv.empty())
        done = write_text(flags.scenes_csv, scenes_csv(reported(rows))) && done;
    if (flags.tables.empty()) return done;
    return replace_section(flags.tables, "jostle at 60 Hz", jostle_table(rows)) &&
           replace_section(flags.tables, "families", family_table(rows)) &&
           replace_section(flags.tables, "score", score_table(score)) && done;
}

int run(const Flags& flags) {
    if (flags.regression)
        return run_regression(flags.experiments(),
                              {flags.against, flags.known_faults, flags.update});
    for (const std::string& path : {flags.json, flags.csv, flags.scenes_csv, flags.tables})
        if (!path.empty() && !can_write(path)) return 1;
    auto earlier = earlier_rows(flags.add);
    if (!earlier) return 1;
    if (contains(flags.peers, "all")) print_missing_peers();
    const std::vector<Row> rows = run_rows(flags, std::move(*earlier));
    for (const Experiment* experiment : reported(rows))
        std::printf("%s", scene_report(*experiment, rows).c_str());
    const Score score = score_of(rows, "jostle");
    std::printf("%s", score_report(score).c_str());
    const Score of_families = score_of(rows, "jostle", Scope::families);
    if (!of_families.comparisons.empty())
        std::printf("\nMembers of families:%s", score_report(of_families).c_str());
    const std::string faults = to_text(judge(faults_of(rows, reported(rows)), {}, {}));
    if (!faults.empty()) std::printf("\nFaults of Jostle (--help):\n%s", faults.c_str());
    return write_files(flags, rows, score) ? 0 : 1;
}

}  // namespace

void add_accuracy(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "accuracy", "Measure CPU time against error for Jostle and other engines");
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option("--scene", flags->scenes,
                     "Run scenes and families by name; all, fixed (no families),\n"
                     "families or none; see below [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_experiment, ""));
    CLI::Option* draw =
        command
            ->add_option("--draw", flags->draw,
                         "Run N other members of the selected families instead\n[1 to 1000]")
            ->type_name("N")
            ->check(CLI::Range(1, 1000).description(""));
    command
        ->add_option("--seed", flags->seed,
                     "Draw with this seed; runs without --draw use 1 [default: 2]")
        ->type_name("SEED")
        ->needs(draw);
    command
        ->add_option("--rates", flags->rates,
                     "Step rates, in Hz [default: 30,60,120,240,480;\n"
                     "at least 4, must divide 19200]")
        ->type_name("HZ")
        ->delimiter(',')
        ->check(CLI::Validator(check_rate, ""));
    command
        ->add_option("--peers", flags->peers,
                     "Run peer engines by name; all that are built in, or none\n[default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_peer, ""));
    command
        ->add_option("--modes", flags->modes,
                     "Run modes by name; all, or default (that of each engine)\n"
                     "[default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_mode, ""));
    command->add_option("--json", flags->json, "Write rows, work and score as JSON")
        ->type_name("FILE");
    command->add_option("--csv", flags->csv, "Write the rows as CSV")->type_name("FILE");
    command
        ->add_option("--scenes-csv", flags->scenes_csv,
                     "Write the scenes, their error measures and tolerances as CSV")
        ->type_name("FILE");
    command
        ->add_option("--tables", flags->tables,
                     "Update the tables in this copy of docs/records/accuracy.md")
        ->type_name("FILE");
    command
        ->add_option("--merge", flags->add,
                     "Include the rows of an earlier result, JSON or CSV, in the report")
        ->type_name("FILE");
    CLI::Option* regression =
        command->add_flag("--regression", flags->regression,
                          "Measure the errors of Jostle only, at 30, 60 and 120 Hz, on the\n"
                          "scenes that take seconds, and check two rules; see below");
    CLI::Option* against =
        command
            ->add_option("--compare-to", flags->against,
                         "Compare with this file; a value that is worse by more than 1/3\n"
                         "is a regression")
            ->type_name("FILE")
            ->needs(regression);
    against->excludes(draw);
    command
        ->add_option("--known-faults", flags->known_faults,
                     "Accept the faults in this file, with their causes")
        ->type_name("FILE")
        ->needs(regression);
    command
        ->add_flag("--update", flags->update,
                   "Write the measured values to the --compare-to file, and remove\n"
                   "obsolete faults from the --known-faults file")
        ->needs(against);
    for (const char* other : {"--rates", "--peers", "--modes", "--json", "--csv", "--scenes-csv",
                              "--tables", "--merge"})
        regression->excludes(command->get_option(other));
    command->footer("\n" + experiment_list() + "\n" + family_list() + "\n" + engine_list() +
                    footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
