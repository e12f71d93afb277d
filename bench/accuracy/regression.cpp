// SPDX-License-Identifier: MIT
#include "bench/accuracy/regression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/faults.h"
#include "bench/measure.h"
#include "bench/result_file.h"

namespace jostle::bench::accuracy {
namespace {

constexpr std::array rates = {30.0, 60.0, 120.0, 240.0, 480.0};

// They require runs at 1920 or 960 Hz as reference.
constexpr std::array<std::string_view, 2> slow_scenes = {"c17-rope", "c17-cloth"};

// Rows of the default mode have no mode in the file.
const std::string& mode_of(const Row& row) {
    return row.mode.empty() ? engine_kinds()[0].modes[0] : row.mode;
}

std::string name_of(const Row& row) {
    return mode_of(row) == engine_kinds()[0].modes[0] ? row.scene : row.scene + " " + row.mode;
}

const Row* find_row(const std::vector<Row>& rows, const Row& like) {
    for (const Row& row : rows)
        if (row.scene == like.scene && row.rate_hz == like.rate_hz && mode_of(row) == mode_of(like))
            return &row;
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
    changes.push_back({name_of(row), row.rate_hz, words, is > was});
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
        changes.push_back({name_of(after), after.rate_hz,
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
        for (const char* of_the_machine : {"engine", "cpu_us_per_second"})
            json.erase(of_the_machine);
        if (mode_of(row) == engine_kinds()[0].modes[0]) json.erase("mode");
        all.push_back(json);
    }
    return write_result(file, {{"benchmark", "accuracy --regression"}}, all);
}

void print(const Row& row) {
    if (row.usable())
        std::printf("%-20s %4g %11.4g %11.4g\n", name_of(row).c_str(), row.rate_hz, row.error,
                    row.second_error);
    else
        std::printf("%-20s %4g  %s\n", name_of(row).c_str(), row.rate_hz, row.failed.c_str());
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

int print_faults(const JudgedFaults& judged) {
    std::fputs(to_text(judged).c_str(), stdout);
    std::printf("%zu faults, %zu known faults\n", judged.failures.size(), judged.explained.size());
    return judged.failures.empty() ? 0 : 1;
}

bool write_known_faults(const std::string& file, const std::vector<KnownFault>& known) {
    return write_result(file, {{"benchmark", "accuracy --regression"}}, to_json(known));
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
        const bool jointed = !experiment->start(0).scene.joints.empty();
        for (const std::string& mode : {jostle.modes[0], std::string("iterative")})
            for (const double rate : rates) {
                if (rate > experiment->short_max_hz || (mode != jostle.modes[0] && !jointed)) break;
                show_progress(experiment->name + " " + std::to_string(static_cast<int>(rate)) +
                              " Hz");
                rows.push_back(run_row_in_child(*experiment, jostle, mode, rate, Timing::none));
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
            changes.push_back({name_of(row), row.rate_hz, "is not in the file", true});
    }
    for (const Row& row : before)
        if (!find_row(after, row) && (all || has_scene(after, row.scene)))
            changes.push_back({name_of(row), row.rate_hz, "is only in the file", true});
    return changes;
}

int run_regression(const std::vector<const Experiment*>& experiments,
                   const RegressionFiles& files) {
    const bool all = experiments.size() == all_experiments().size();
    std::vector<Row> before;
    std::vector<KnownFault> known;
    if (!files.rows.empty() && !(files.update && all)) try {
            before = read_rows(files.rows);
        } catch (const nlohmann::json::exception& error) {
            std::fprintf(stderr,
                         "jostle-bench: no rows in %s: %s\nCreate the file with --update and all "
                         "scenes.\n",
                         files.rows.c_str(), error.what());
            return 1;
        }
    if (!files.known_faults.empty()) try {
            std::ifstream in(files.known_faults);
            known = known_faults_from(in);
        } catch (const nlohmann::json::exception& error) {
            std::fprintf(stderr, "jostle-bench: no rows in %s: %s\n", files.known_faults.c_str(),
                         error.what());
            return 1;
        }
    if (files.update && !can_write(files.rows)) return 1;
    const std::vector<Row> rows = regression_rows(experiments);
    if (files.rows.empty() || files.update)
        for (const Row& row : rows) print(row);
    const std::vector<Fault> faults = faults_of(rows, experiments);
    int status = print_faults(judge(faults, known, experiments));
    if (files.rows.empty()) return status;
    if (!files.update)
        return std::max(status,
                        print_changes(changes_between(before, rows, all), rows.size(), files.rows));
    if (!files.known_faults.empty() &&
        !write_known_faults(files.known_faults, updated(known, faults, experiments)))
        return 1;
    // Scenes that did not run keep their rows and positions.
    std::vector<Row> rows_of_scene;
    for (const Experiment& experiment : all_experiments())
        for (const Row& row : has_scene(rows, experiment.name) ? rows : before)
            if (row.scene == experiment.name) rows_of_scene.push_back(row);
    return write_rows(files.rows, rows_of_scene) ? status : 1;
}

}  // namespace jostle::bench::accuracy
