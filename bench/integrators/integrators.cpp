// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench/integrators/integrator_row.h"
#include "bench/measure.h"
#include "bench/result_file.h"

namespace jostle::bench {
namespace {

using namespace integrators;

constexpr const char* footer = R"(
A particle moves for 2 s through a field with an exact solution. The error is the RMS distance from
the exact solution over all steps. The order states how fast the error falls when the rate doubles:
1, to 1/2; 2, to 1/4; 4, to 1/16. The energy drift is the largest change of the energy relative to
the initial energy, which may be negative (kepler). Jostle's row is a free body in a World, driven
by a step listener in each of 8 sub-steps, including all other work of a step.

Examples:
  jostle-bench integrators
  jostle-bench integrators --field kepler --method verlet,rk4 --rates 120,240,480
  jostle-bench integrators --json integrators.json --csv integrators.csv

Exit status: 0 success, 1 a file could not be written, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> fields = {"all"}, methods = {"all"};
    std::vector<double> rates = {120, 240, 480, 960};
    std::string json, csv;
};

template <class Kinds>
CLI::Validator one_of(const Kinds& kinds, const char* what) {
    std::vector<std::string> names = {"all"};
    for (const auto& kind : kinds) names.emplace_back(kind.name);
    return CLI::Validator(
        [names, what](std::string& text) -> std::string {
            std::string known;
            for (const std::string& name : names) {
                if (text == name) return "";
                known += (known.empty() ? "" : ", ") + name;
            }
            return std::string("unknown ") + what + " " + text + "; must be one of " + known;
        },
        what);
}

std::string check_rate_of_particle(const std::string& text) {
    char* end = nullptr;
    const double rate = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == 0 && rate >= 4 && rate <= 100000 && std::round(rate) == rate)
        return "";
    return text + " is not a valid rate; must be an integer from 4 to 100000 Hz";
}

bool chosen(const std::vector<std::string>& list, std::string_view name) {
    return std::find(list.begin(), list.end(), "all") != list.end() ||
           std::find(list.begin(), list.end(), name) != list.end();
}

std::string number_or(const std::optional<double>& value, const char* format) {
    if (!value) return "";
    char text[32];
    std::snprintf(text, sizeof text, format, *value);
    return text;
}

void print_row(const IntegratorRow& row) {
    std::printf("%-11s %-14s %7g %11.4g %7s %11s %9.4g\n", row.field.c_str(), row.method.c_str(),
                row.rate_hz, row.error, number_or(row.order, "%.2f").c_str(),
                number_or(row.energy_drift, "%.3g").c_str(), row.ns_per_step);
}

std::string csv_of(const std::vector<IntegratorRow>& rows) {
    std::string text = "field,method,rate_hz,error_m,order,energy_drift,ns_per_step\n";
    for (const IntegratorRow& row : rows) {
        char line[200];
        std::snprintf(line, sizeof line, "%s,%s,%g,%.4g,%s,%s,%.4g\n", row.field.c_str(),
                      row.method.c_str(), row.rate_hz, row.error,
                      number_or(row.order, "%.4g").c_str(),
                      number_or(row.energy_drift, "%.4g").c_str(), row.ns_per_step);
        text += line;
    }
    return text;
}

int run(Flags flags) {
    for (const std::string& path : {flags.json, flags.csv})
        if (!path.empty() && !can_write(path)) return 1;
    std::sort(flags.rates.begin(), flags.rates.end());
    flags.rates.erase(std::unique(flags.rates.begin(), flags.rates.end()), flags.rates.end());
    std::vector<IntegratorRow> all;
    std::printf("%-11s %-14s %7s %11s %7s %11s %9s\n", "field", "method", "hz", "error, m", "order",
                "energy", "ns/step");
    for (const ParticleField& field : all_fields()) {
        if (!chosen(flags.fields, field.name)) continue;
        for (const IntegratorKind& kind : integrator_kinds()) {
            if (!chosen(flags.methods, kind.name)) continue;
            for (const IntegratorRow& row : integrator_rows(field, kind, flags.rates)) {
                print_row(row);
                all.push_back(row);
            }
        }
    }
    bool done = flags.csv.empty() || write_text(flags.csv, csv_of(all));
    if (flags.json.empty()) return done ? 0 : 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const IntegratorRow& row : all) rows.push_back(to_json(row));
    const nlohmann::ordered_json head = {
        {"benchmark", "integrators"}, {"cpu", cpu_model()}, {"compiler", compiler()}};
    done = write_result(flags.json, head, rows) && done;
    return done ? 0 : 1;
}

std::string lists() {
    std::string text = "Fields:\n";
    for (const ParticleField& field : all_fields())
        text += "  " + field.name + ": " + field.about + "\n";
    text += "Methods and their order in smooth fields:\n";
    for (const IntegratorKind& kind : integrator_kinds())
        text += std::string("  ") + kind.name + ": " + kind.about + ", " +
                std::to_string(static_cast<int>(kind.order)) + "\n";
    return text;
}

}  // namespace

void add_integrators(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("integrators", "Measure error, order and energy drift of integrators");
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option("--field", flags->fields,
                     "Run fields by name, or all; see below [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(one_of(all_fields(), "field").description(""));
    command
        ->add_option("--method", flags->methods,
                     "Run methods by name, or all; see below [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(one_of(integrator_kinds(), "method").description(""));
    command
        ->add_option("--rates", flags->rates,
                     "Step rates, in Hz [default: 120,240,480,960; 4 to 100000]")
        ->type_name("HZ")
        ->delimiter(',')
        ->check(CLI::Validator(check_rate_of_particle, ""));
    command->add_option("--json", flags->json, "Write the rows as JSON")->type_name("FILE");
    command->add_option("--csv", flags->csv, "Write the rows as CSV")->type_name("FILE");
    command->footer("\n" + lists() + footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
