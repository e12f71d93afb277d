// SPDX-License-Identifier: MIT
#include "bench/accuracy/regression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/measure.h"
#include "bench/result_file.h"

namespace jostle::bench::accuracy {
namespace {

constexpr std::array rates = {30.0, 60.0, 120.0};

// They require runs at 1920 or 960 Hz as reference.
constexpr std::array<std::string_view, 2> slow_scenes = {"c17-rope", "c17-cloth"};

const Row* find_row(const std::vector<Row>& rows, const Row& like) {
    for (const Row& row : rows)
        if (row.scene == like.scene && row.rate_hz == like.rate_hz) return &row;
    return nullptr;
}

bool has_scene(const std::vector<Row>& rows, const std::string& scene) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.scene == scene; });
}

// Compares one value. Adds nothing if it changed by at most a third.
void compare(const Row& row, const char* name, double before, double after,
             std::vector<RegressionChange>& changes) {
    const double was = std::max(before, rounding), is = std::max(after, rounding);
    if (is <= was * regression_ratio && was <= is * regression_ratio) return;
    char words[120];
    std::snprintf(words, sizeof words, "%s %.4g -> %.4g (%.2f times)", name, before, after,
                  is / was);
    changes.push_back({row.scene, row.rate_hz, words, is > was});
}

// The second value of some scenes is not an error but the motion of a body that must fall.
bool second_counts(const Row& row) {
    const Experiment* experiment = find_experiment(row.scene);
    return !experiment || !experiment->measures.starts_with("1 when it stands");
}

void compare_rows(const Row& before, const Row& after, std::vector<RegressionChange>& changes) {
    if (before.usable() && after.usable()) {
        compare(after, "error", before.error, after.error, changes);
        if (second_counts(after))
            compare(after, "second error", before.second_error, after.second_error, changes);
    } else if (before.usable() != after.usable()) {
        changes.push_back({after.scene, after.rate_hz,
                           after.usable() ? "failed before, not now" : "failed: " + after.failed,
                           !after.usable()});
    }
}

std::vector<Row> read_rows(const std::string& file) {
    std::ifstream in(file);
    std::vector<Row> rows;
    const auto json = nlohmann::ordered_json::parse(in);
    for (const auto& row : json.at("rows")) rows.push_back(row_from(row));
    return rows;
}

bool write_rows(const std::string& file, const std::vector<Row>& rows) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
        auto json = to_json(row);
        for (const char* of_the_machine : {"engine", "mode", "cpu_us_per_second"})
            json.erase(of_the_machine);
        all.push_back(json);
    }
    return write_result(file, {{"benchmark", "accuracy --regression"}}, all);
}

void print(const Row& row) {
    if (row.usable())
        std::printf("%-10s %4g %11.4g %11.4g\n", row.scene.c_str(), row.rate_hz, row.error,
                    row.second_error);
    else
        std::printf("%-10s %4g  %s\n", row.scene.c_str(), row.rate_hz, row.failed.c_str());
}

int print_changes(const std::vector<RegressionChange>& changes, std::size_t rows,
                  const std::string& file) {
    int faults = 0, better = 0;
    for (const RegressionChange& change : changes) {
        (change.fault ? faults : better)++;
        std::printf("%s: %s at %g Hz: %s\n", change.fault ? "WORSE" : "better",
                    change.scene.c_str(), change.rate_hz, change.words.c_str());
    }
    std::printf("%zu rows, %d values worse by more than a third, %d better\n", rows, faults,
                better);
    if (faults + better > 0)
        std::printf(
            "If the change is intended, update the file and explain it in the commit message:\n"
            "  jostle-bench accuracy --regression --compare-to %s --update\n",
            file.c_str());
    return faults > 0 ? 1 : 0;
}

}  // namespace

bool in_regression_set(const Experiment& experiment) {
    return std::find(slow_scenes.begin(), slow_scenes.end(), experiment.name) == slow_scenes.end();
}

std::vector<Row> regression_rows(const std::vector<const Experiment*>& experiments) {
    const EngineKind& jostle = engine_kinds()[0];
    std::vector<Row> rows;
    for (const Experiment* experiment : experiments) {
        if (!in_regression_set(*experiment)) continue;
        // computes the reference, which child processes inherit
        static_cast<void>(experiment->start(0));
        for (const double rate : rates) {
            show_progress(experiment->name + " " + std::to_string(static_cast<int>(rate)) + " Hz");
            rows.push_back(
                run_row_in_child(*experiment, jostle, jostle.modes[0], rate, Timing::none));
        }
    }
    show_progress("");
    return rows;
}

std::vector<RegressionChange> changes_between(const std::vector<Row>& before,
                                              const std::vector<Row>& after, bool all) {
    std::vector<RegressionChange> changes;
    for (const Row& row : after) {
        if (const Row* old = find_row(before, row))
            compare_rows(*old, row, changes);
        else
            changes.push_back({row.scene, row.rate_hz, "is not in the file", true});
    }
    for (const Row& row : before)
        if (!find_row(after, row) && (all || has_scene(after, row.scene)))
            changes.push_back({row.scene, row.rate_hz, "is only in the file", true});
    return changes;
}

int run_regression(const std::vector<const Experiment*>& experiments, const std::string& file,
                   bool update) {
    const bool all = experiments.size() == all_experiments().size();
    std::vector<Row> before;
    if (!file.empty() && !(update && all)) try {
            before = read_rows(file);
        } catch (const nlohmann::json::exception& error) {
            std::fprintf(stderr,
                         "jostle-bench: no rows in %s: %s\nCreate the file with --update and all "
                         "scenes.\n",
                         file.c_str(), error.what());
            return 1;
        }
    if (update && !can_write(file)) return 1;
    const std::vector<Row> rows = regression_rows(experiments);
    if (file.empty() || update)
        for (const Row& row : rows) print(row);
    if (file.empty()) return 0;
    if (!update) return print_changes(changes_between(before, rows, all), rows.size(), file);
    // Scenes that did not run keep their rows and positions.
    std::vector<Row> rows_of_scene;
    for (const Experiment& experiment : all_experiments())
        for (const Row& row : has_scene(rows, experiment.name) ? rows : before)
            if (row.scene == experiment.name) rows_of_scene.push_back(row);
    return write_rows(file, rows_of_scene) ? 0 : 1;
}

}  // namespace jostle::bench::accuracy
