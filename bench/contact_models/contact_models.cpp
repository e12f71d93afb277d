// SPDX-License-Identifier: MIT
#include "bench/contact_models/contact_models.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "bench/subcommands.h"

namespace jostle::bench {
namespace contact_models {
namespace {

constexpr std::array kinds = {
    ContactModelKind{"penalty", "springs of 1e5 N/m and dampers, explicit step",
                     make_penalty_model},
    ContactModelKind{"impulses",
                     "velocity constraints: ten iterations of sequential impulses, warm-started",
                     make_impulse_model},
    ContactModelKind{"xpbd", "positions: ten sub-steps of one iteration", make_xpbd_model},
};
constexpr double run_seconds_min = 0.01;  // s of CPU time: a run is repeated until then

constexpr const char* footer = R"(
Sixteen balls drop 0.5 m on a plane and bounce (restitution 0.8), ten form a stack, one slides until
friction (0.4) stops it; 2 s. Balls do not rotate. All models receive the same contacts.
  overlap  deepest overlap in the stack during the last second, mm
  energy   relative error of the dropped balls' energy after the bounce; RMS, each ball starts 1/16
           of a step after the previous one
  slide    relative error of the stopping distance
  failed   a ball is faster than 25 m/s, or its velocity is not finite

Examples:
  jostle-bench contact-models
  jostle-bench contact-models --model penalty --rates 240,480,960,1920

Exit status: 0 success, 1 a file could not be written, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> contact_models = {"all"};
    std::vector<double> rates = {30, 60, 120, 240, 480, 960, 1920};
    std::string json, csv;
};

std::string check_contact_model(const std::string& name) {
    std::string known = "all";
    if (name == "all" || find_contact_model(name)) return "";
    for (const ContactModelKind& kind : kinds) known += std::string(", ") + kind.name;
    return "unknown model " + name + "; must be one of " + known;
}

std::string check_rate_of_model(const std::string& text) {
    char* end = nullptr;
    const double rate = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == 0 && rate >= 4 && rate <= 100000) return "";
    return text + " is not a valid rate; must be 4 to 100000 Hz";
}

double time_of_run(const ContactModelKind& kind, double rate_hz) {
    const long steps = std::lround(scene_seconds * rate_hz);
    double least = 0, spent = 0;
    for (int run = 0; run == 0 || spent < run_seconds_min; run++) {
        ContactScene scene(1 / rate_hz);
        const auto model = kind.make();
        const double before = cpu_seconds();
        for (long k = 0; k < steps; k++) model->step(scene.balls, 1 / rate_hz);
        const double took = cpu_seconds() - before;
        least = run == 0 ? took : std::min(least, took);
        spent += took;
    }
    return least;
}

void print_row(const ContactModelRow& row) {
    if (row.errors.failed)
        std::printf("%-9s %6g  failed\n", row.model.c_str(), row.rate_hz);
    else
        std::printf("%-9s %6g %12.4g %11.4g %11.4g %11.4g\n", row.model.c_str(), row.rate_hz,
                    1000 * row.errors.overlap, row.errors.energy, row.errors.slide,
                    row.cpu_us_per_second);
}

std::string csv_of(const std::vector<ContactModelRow>& rows) {
    std::string text = "model,rate_hz,overlap_m,energy_error,slide_error,cpu_us_per_second\n";
    for (const ContactModelRow& row : rows) {
        char line[160];
        const SceneErrors& errors = row.errors;
        if (errors.failed)
            std::snprintf(line, sizeof line, "%s,%g,blown,,,\n", row.model.c_str(), row.rate_hz);
        else
            std::snprintf(line, sizeof line, "%s,%g,%.4g,%.4g,%.4g,%.4g\n", row.model.c_str(),
                          row.rate_hz, errors.overlap, errors.energy, errors.slide,
                          row.cpu_us_per_second);
        text += line;
    }
    return text;
}

int run(Flags flags) {
    for (const std::string& path : {flags.json, flags.csv})
        if (!path.empty() && !can_write(path)) return 1;
    std::sort(flags.rates.begin(), flags.rates.end());
    std::vector<ContactModelRow> rows;
    std::printf("%-9s %6s %12s %11s %11s %11s\n", "model", "hz", "overlap, mm", "energy", "slide",
                "cpu us/s");
    for (const ContactModelKind& kind : kinds) {
        const auto& chosen = flags.contact_models;
        if (std::find(chosen.begin(), chosen.end(), "all") == chosen.end() &&
            std::find(chosen.begin(), chosen.end(), kind.name) == chosen.end())
            continue;
        for (const double rate : flags.rates) {
            rows.push_back(contact_model_row(kind, rate));
            print_row(rows.back());
        }
    }
    bool done = flags.csv.empty() || write_text(flags.csv, csv_of(rows));
    if (flags.json.empty()) return done ? 0 : 1;
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const ContactModelRow& row : rows) json.push_back(to_json(row));
    const nlohmann::ordered_json head = {
        {"benchmark", "contact-models"}, {"cpu", cpu_model()}, {"compiler", compiler()}};
    done = write_result(flags.json, head, json) && done;
    return done ? 0 : 1;
}

}  // namespace

std::span<const ContactModelKind> contact_model_kinds() {
    return kinds;
}

const ContactModelKind* find_contact_model(std::string_view name) {
    for (const ContactModelKind& kind : kinds)
        if (name == kind.name) return &kind;
    return nullptr;
}

ContactModelRow contact_model_row(const ContactModelKind& kind, double rate_hz) {
    ContactScene scene(1 / rate_hz);
    const auto model = kind.make();
    for (long k = 0; k < std::lround(scene_seconds * rate_hz); k++) {
        model->step(scene.balls, 1 / rate_hz);
        scene.sample();
    }
    return {kind.name, rate_hz, scene.errors(), 1e6 * time_of_run(kind, rate_hz) / scene_seconds};
}

nlohmann::ordered_json to_json(const ContactModelRow& row) {
    nlohmann::ordered_json json = {{"model", row.model}, {"rate_hz", row.rate_hz}};
    if (row.errors.failed) {
        json["blown"] = true;
        return json;
    }
    json["overlap_m"] = rounded(row.errors.overlap);
    json["energy_error"] = rounded(row.errors.energy);
    json["slide_error"] = rounded(row.errors.slide);
    json["cpu_us_per_second"] = rounded(row.cpu_us_per_second);
    return json;
}

}  // namespace contact_models

void add_contact_models(CLI::App& app, int& status) {
    using namespace contact_models;
    CLI::App* command = app.add_subcommand("contact-models", "Compare contact models on one scene");
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option("--model", flags->contact_models,
                     "Run models by name, or all; see below [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_contact_model, ""));
    command
        ->add_option("--rates", flags->rates,
                     "Step rates, in Hz\n[default: 30,60,120,240,480,960,1920; 4 to 100000]")
        ->type_name("HZ")
        ->delimiter(',')
        ->check(CLI::Validator(check_rate_of_model, ""));
    command->add_option("--json", flags->json, "Write the rows as JSON")->type_name("FILE");
    command->add_option("--csv", flags->csv, "Write the rows as CSV")->type_name("FILE");
    std::string list = "\nModels:\n";
    for (const ContactModelKind& kind : kinds)
        list += std::string("  ") + kind.name + ": " + kind.about + "\n";
    command->footer(list + footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench
