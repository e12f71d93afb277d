// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_report.h"
#include "bench/accuracy/flag_selection.h"
#include "bench/accuracy/stress_test.h"
#include "bench/measure.h"
#include "bench/processes/program.h"
#include "bench/result_file.h"

namespace jostle::bench {
namespace {

using namespace accuracy;

constexpr const char* footer = R"(
A test passes if no body is lost, the engine reports no error, no body ever exceeds twice the speed
that its energy allows, and the measured value is below the limit. Each test runs in its own
process.

Examples:
  jostle-bench stability --peers none
  jostle-bench stability --scene s6,s9-j1 --peers bullet,ode --json stability.json

Exit status: 0 all tests ran (passed or failed), 1 a file could not be written, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> scenes = {"all"};
    std::vector<std::string> peers = {"all"};
    std::vector<std::string> modes = {"default"};
    std::string json, tables;
};

std::string check_test(const std::string& id) {
    if (id == "all") return "";
    std::string known = "all";
    for (const StressTest& test : all_stress_tests()) {
        if (test.id == id) return "";
        known += ", " + test.id;
    }
    return "unknown test " + id + "; must be one of " + known;
}

constexpr rlim_t longest_s = 240;  // of CPU time

// Runs in its own process, which returns the text of to_json().
nlohmann::ordered_json run_in_process(const StressTest& test, const EngineKind& kind,
                                      const std::string& mode) {
    const ChildResult answer = run_in_child([&] {
        const rlimit limit{longest_s, longest_s + 1};
        setrlimit(RLIMIT_CPU, &limit);
        return to_json(test, kind, mode, test.run(kind, mode)).dump();
    });
    if (answer.failure.empty()) return nlohmann::ordered_json::parse(answer.text);
    return to_json(test, kind, mode, {.why = answer.failure});
}

void print_row(const nlohmann::ordered_json& row) {
    if (row.contains("lacks")) return;
    const std::string id = row["id"], engine = row["engine"], mode = row["mode"];
    char figure[24] = "-";
    if (row.contains("figure"))
        std::snprintf(figure, sizeof figure, "%.4g", row["figure"].get<double>());
    std::printf("%-8s %-8s %-18s %-4s %11s  < %-6g %s\n", id.c_str(), engine.c_str(), mode.c_str(),
                row["pass"] ? "pass" : "FAIL", figure, row["limit"].get<double>(),
                row.value("why", "").c_str());
    std::fflush(stdout);
}

int run(const Flags& flags) {
    for (const std::string& path : {flags.json, flags.tables})
        if (!path.empty() && !can_write(path)) return 1;
    if (contains(flags.peers, "all")) print_missing_peers();
    std::printf("%-8s %-8s %-18s %-4s %11s  %s\n", "test", "engine", "mode", "", "figure", "limit");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const StressTest& test : all_stress_tests()) {
        if (!contains(flags.scenes, "all") && !contains(flags.scenes, test.id)) continue;
        for (const EngineKind* kind : selected_engines(flags.peers))
            for (const std::string& mode : selected_modes(*kind, flags.modes)) {
                show_progress(test.id + " " + kind->name + " " + mode);
                const nlohmann::ordered_json row = run_in_process(test, *kind, mode);
                show_progress("");
                print_row(row);
                rows.push_back(row);
            }
    }
    bool done = flags.json.empty() || write_result(flags.json, result_header("stability"), rows);
    if (!flags.tables.empty())
        done = replace_section(flags.tables, "stability", stability_table(rows)) && done;
    return done ? 0 : 1;
}

std::string stress_test_list() {
    std::string text = "Tests and their measured values:\n";
    for (const StressTest& test : all_stress_tests())
        text += "  " + test.id + ": " + test.about + "\n    " + test.figure + "\n";
    return text;
}

}  // namespace

void add_stability(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("stability", "Run stress tests in Jostle and other engines");
    const auto flags = std::make_shared<Flags>();
    command->add_option("--scene", flags->scenes, "Run tests by id; all; see below [default: all]")
        ->type_name("ID")
        ->delimiter(',')
        ->check(CLI::Validator(check_test, ""));
    command
        ->add_option("--peers", flags->peers,
                     "Run peer engines by name; all that are built in, or none\n[default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_peer, ""));
    command
        ->add_option("--modes", flags->modes,
                     "Run modes by name; all, or default (that of each engine)\n"
                     "[default: default]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_mode, ""));
    command->add_option("--json", flags->json, "Write the rows as JSON")->type_name("FILE");
    command
        ->add_option("--tables", flags->tables,
                     "Update the table in this copy of docs/records/accuracy.md")
        ->type_name("FILE");
    command->footer("\n" + stress_test_list() + "\n" + engine_list() + footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
