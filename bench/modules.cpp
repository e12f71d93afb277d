// SPDX-License-Identifier: MIT
#include "bench/modules.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/measure.h"
#include "bench/module_cases.h"
#include "bench/result_file.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
A case is a world with that many objects of one module. After a run-in of two simulated seconds each step is timed, in
processor time of its thread; worlds have one thread. All that a step does counts, the solver's part, too.

Columns: objects; milliseconds of a step: mean, 99th percentile, worst; microseconds of the mean for each object; steps
that took longer than 1/60 s.

Examples:
  jostle-bench modules
  jostle-bench modules --case ragdoll_powered --objects 200 --json modules.json

Exit status: 0 done, 1 the file could not be written, 2 wrong flags.)";

struct Flags {
    std::vector<std::string> cases;
    int objects = 0, steps = 600;
    std::string json;
};

struct Row {
    std::string name;
    int objects = 0;
    std::vector<double> step_ms;
};

Row measure(const ModuleCase& one, const Flags& flags) {
    Row row{.name = one.name, .objects = flags.objects > 0 ? flags.objects : one.objects};
    show_progress(row.name + ", " + std::to_string(row.objects) + " objects");
    const std::unique_ptr<ModuleScene> scene = one.make(row.objects);
    constexpr int run_in = 120;
    for (int k = 0; k < run_in + flags.steps; k++) {
        const double began = cpu_seconds();
        scene->step(k);
        if (k >= run_in) row.step_ms.push_back(1e3 * (cpu_seconds() - began));
    }
    show_progress("");
    return row;
}

double max_of(const Row& row) {
    return *std::max_element(row.step_ms.begin(), row.step_ms.end());
}

long count_late(const Row& row) {
    return std::count_if(row.step_ms.begin(), row.step_ms.end(),
                         [](double ms) { return ms > 1e3 / 60; });
}

void print(const Row& row) {
    const double ms = mean(row.step_ms);
    std::printf("%-24s %8d %9.3f %9.3f %9.3f %12.2f %6ld\n", row.name.c_str(), row.objects, ms,
                percentile_99(row.step_ms), max_of(row), 1e3 * ms / row.objects, count_late(row));
}

nlohmann::ordered_json to_json(const Row& row) {
    const double ms = mean(row.step_ms);
    return {{"case", row.name},        {"objects", row.objects},
            {"ms_mean", ms},           {"ms_p99", percentile_99(row.step_ms)},
            {"ms_worst", max_of(row)}, {"us_per_object", 1e3 * ms / row.objects},
            {"late", count_late(row)}};
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    std::printf("%-24s %8s %9s %9s %9s %12s %6s\n", "case", "objects", "ms mean", "p99", "worst",
                "us an object", "late");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ModuleCase& one : module_cases()) {
        const auto& contains = flags.cases;
        if (!contains.empty() &&
            std::find(contains.begin(), contains.end(), one.name) == contains.end())
            continue;
        const Row row = measure(one, flags);
        print(row);
        rows.push_back(to_json(row));
    }
    if (flags.json.empty()) return 0;
    return write_result(flags.json, {{"benchmark", "modules"}}, rows) ? 0 : 1;
}

std::vector<std::string> case_names() {
    std::vector<std::string> contains;
    for (const ModuleCase& one : module_cases()) contains.emplace_back(one.name);
    return contains;
}

}  // namespace

void add_modules(CLI::App& app, int& status) {
    auto flags = std::make_shared<Flags>();
    CLI::App* command =
        app.add_subcommand("modules", "What a step costs with many objects of a module");
    command->footer(footer);
    command->add_option("--case", flags->cases, "These alone")
        ->delimiter(',')
        ->check(CLI::IsMember(case_names()));
    command->add_option("--objects", flags->objects, "Instead of the case's own number")
        ->check(CLI::Range(1, 10000));
    command->add_option("--steps", flags->steps, "That are timed")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--json", flags->json, "Writes the rows here as JSON");
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
