// SPDX-License-Identifier: MIT
#include "bench/integrators/integrators.h"

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
A particle moves for 2 s through a field whose motion is known in closed form. The error is the RMS
distance from it over all steps. The order tells how fast the error falls: 1, half at twice the
rate; 2, a quarter; 4, a sixteenth. The drift is the largest change of energy over the energy at the
start; an energy that is positive and one that is negative (kepler) are both meant. Jostle's own row
is a free body in a World that a step listener pushes in each of 8 sub-steps, with all that a step
does besides.

Examples:
  jostle-bench integrators
  jostle-bench integrators --field kepler --method verlet,rk4 --rates 120,240,480
  jostle-bench integrators --json integrators.json --csv integrators.csv

Exit status: 0 done, 1 a file could not be written, 2 wrong flags.)";

struct Flags {
    std::vector<std::string> fields = {"all"}, methods = {"all"};
    std::vector<double> rates = {120, 240, 480, 960};
    std::string json, csv;
};

template <class Kinds>
CLI::Validator one_of(const Kinds& kinds, const char* what) {
    std::vector<std::string> contains = {"all"};
    for (const auto& kind : kinds) contains.emplace_back(kind.name);
    return CLI::Validator(
        [contains, what](std::string& text) -> std::string {
            std::string known;
            for (const std::string& name : contains) {
                if (text == name) return "";
                known += (known.empty() ? "" : ", ") + name;
            }
            return std::string("there is no ") + what + " " + text + "; there are " + known;
        },
        what);
}

std::string check_rate_of_particle(const std::string& text) {
    char* end = nullptr;
    const double rate = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == 0 && rate >= 4 && rate <= 100000 && std::round(rate) == rate)
        return "";
    return text + " is no rate: a whole number of steps a second from 4 to 100000";
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
    text += "Methods, and their order in smooth fields:\n";
    for (const IntegratorKind& kind : integrator_kinds())
        text += std::string("  ") + kind.name + ": " + kind.about + ", " +
                std::to_string(static_cast<int>(kind.order)) + "\n";
    return text;
}

}  // namespace

void add_integrators(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "integrators", "Error, order and energy of ways to step a particle through a field.");
    const auto flags = std::make_shared<Flags>();
    command->add_option("--field", flags->fields, "By name, or all")
        ->delimiter(',')
        ->capture_default_str()
        ->check(one_of(all_fields(), "field"));
    command->add_option("--method", flags->methods, "By name, or all")
        ->delimiter(',')
        ->capture_default_str()
        ->check(one_of(integrator_kinds(), "method"));
    command->add_option("--rates", flags->rates, "Steps a second")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::Validator(check_rate_of_particle, "HZ"));
    command->add_option("--json", flags->json, "Writes the rows here as JSON");
    command->add_option("--csv", flags->csv, "Writes the rows here as CSV");
    command->footer("\n" + lists() + footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
