// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/measure.h"
#include "bench/module_cases.h"
#include "bench/result_file.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
A case is a world with many objects of one module. After a warm-up of 120 steps (2 s), each step is
timed in CPU time of its thread; worlds have one thread. The time covers the whole step, including
the solver.

Columns: objects; milliseconds per step: mean, 99th percentile, worst; microseconds of the mean per
object; steps that took longer than 1/60 s; RMS distance of the objects from the closed form of their
motion at the end, for the cases that have one. throw_bodies is the peer of the particles_throw
cases: the same throw with rigid bodies. It has the closed form of the same linear drag.
rope_loads_joints is the peer of rope_loads: the same rope of rigid bodies with directly solved joints.
Some cases add a line
with other errors.

Examples:
  jostle-bench modules
  jostle-bench modules --case ragdoll_powered --objects 200 --json modules.json

Exit status: 0 success, 1 the file could not be written, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> cases;
    int objects = 0, steps = 0;
    std::string json;
};

struct Row {
    std::string name;
    int objects = 0;
    std::vector<double> step_ms;
    std::optional<double> error;  // m
    std::string errors;
};

Row measure(const ModuleCase& one, const Flags& flags) {
    Row row{.name = one.name, .objects = flags.objects > 0 ? flags.objects : one.objects};
    show_progress(row.name + ", " + std::to_string(row.objects) + " objects");
    const std::unique_ptr<ModuleScene> scene = one.make(row.objects);
    constexpr int run_in = 120;
    const int steps = flags.steps > 0 ? flags.steps : (one.steps > 0 ? one.steps : 600);
    for (int k = 0; k < run_in + steps; k++) {
        const double began = cpu_seconds();
        scene->step(k);
        if (k >= run_in) row.step_ms.push_back(1e3 * (cpu_seconds() - began));
    }
    show_progress("");
    row.error = scene->error();
    row.errors = scene->errors();
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
    std::printf("%-28s %8d %9.3f %9.3f %9.3f %12.3f %6ld", row.name.c_str(), row.objects, ms,
                percentile_99(row.step_ms), max_of(row), 1e3 * ms / row.objects, count_late(row));
    if (row.error) std::printf(" %10.2e", *row.error);
    std::printf("\n");
    if (!row.errors.empty()) std::printf("    %s\n", row.errors.c_str());
}

nlohmann::ordered_json to_json(const Row& row) {
    const double ms = mean(row.step_ms);
    nlohmann::ordered_json json = {
        {"case", row.name},        {"objects", row.objects},
        {"ms_mean", ms},           {"ms_p99", percentile_99(row.step_ms)},
        {"ms_worst", max_of(row)}, {"us_per_object", 1e3 * ms / row.objects},
        {"late", count_late(row)}};
    if (row.error) json["error_m"] = *row.error;
    if (!row.errors.empty()) json["errors"] = row.errors;
    return json;
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    std::printf("%-28s %8s %9s %9s %9s %12s %6s %10s\n", "case", "objects", "ms mean", "p99",
                "worst", "us/object", "late", "error m");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ModuleCase& one : module_cases()) {
        const auto& names = flags.cases;
        if (!names.empty() && std::find(names.begin(), names.end(), one.name) == names.end())
            continue;
        const Row row = measure(one, flags);
        print(row);
        rows.push_back(to_json(row));
    }
    if (flags.json.empty()) return 0;
    return write_result(flags.json, {{"benchmark", "modules"}}, rows) ? 0 : 1;
}

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const ModuleCase& one : module_cases()) names.emplace_back(one.name);
    return names;
}

}  // namespace

void add_modules(CLI::App& app, int& status) {
    auto flags = std::make_shared<Flags>();
    CLI::App* command =
        app.add_subcommand("modules", "Measure the cost of a step with many objects of a module");
    command->footer(footer);
    command->add_option("--case", flags->cases, "Run cases by name [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::IsMember(case_names()));
    command
        ->add_option("--objects", flags->objects,
                     "Number of objects [default: that of the case; 1 to 100000]")
        ->type_name("N")
        ->check(CLI::Range(1, 100000).description(""));
    command
        ->add_option("--steps", flags->steps,
                     "Timed steps [default: 600, or that of the case; 1 to 1000000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000).description(""));
    command->add_option("--json", flags->json, "Write the rows as JSON")->type_name("FILE");
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
