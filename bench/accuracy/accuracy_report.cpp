// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/flag_selection.h"
#include "bench/accuracy/row_family.h"
#include "bench/accuracy/stress_test.h"
#include "bench/result_file.h"
#include "jostle/base/format_text.h"

namespace jostle::bench::accuracy {

namespace {

constexpr double usual_hz = 60;

std::string where(const Row& row) {
    return format_text("%s@%g", row.mode.c_str(), row.rate_hz);
}

std::string work_of(const std::optional<Row>& row) {
    if (!row) return "-";
    return format_text("%.3g (%s)", row->cpu_us_per_second, where(*row).c_str());
}

struct Series {
    std::string engine, mode;
    bool operator==(const Series&) const = default;
};

std::vector<Series> series_of(const std::vector<Row>& rows, const std::string& scene) {
    std::vector<Series> found;
    for (const Row& row : rows) {
        const Series series{row.engine, row.mode};
        if (row.scene == scene && row.unsupported.empty() &&
            std::find(found.begin(), found.end(), series) == found.end())
            found.push_back(series);
    }
    return found;
}

std::string error_at_usual_rate(const std::vector<Row>& rows, const std::string& scene,
                                const Series& series) {
    for (const Row& row : rows)
        if (row.scene == scene && row.engine == series.engine && row.mode == series.mode &&
            row.rate_hz == usual_hz)
            return row.usable() ? format_text("%.3g", row.error) : "failed";
    return "-";
}

std::vector<std::string> engines_of(const std::vector<Series>& all) {
    std::vector<std::string> engines;
    for (const Series& series : all)
        if (!contains(engines, series.engine)) engines.push_back(series.engine);
    return engines;
}

std::string lines_of_series(const std::vector<Row>& rows, const std::string& scene,
                            const std::vector<Series>& all) {
    std::string text;
    for (const Series& series : all) {
        text += format_text("  %-8s %-18s %9s  ", series.engine.c_str(), series.mode.c_str(),
                            error_at_usual_rate(rows, scene, series).c_str());
        for (const Order& order : observed_orders(rows, scene, series.engine, series.mode))
            text += format_text(" %g-%g: %.2f", order.from_hz, order.to_hz, order.order);
        text += "\n";
    }
    return text;
}

// Why engines have no rows, each reason once.
std::vector<std::string> reasons_of(const std::vector<Row>& rows, const std::string& scene) {
    std::vector<std::string> reasons;
    for (const Row& row : rows)
        if (row.scene == scene && !row.unsupported.empty() && !contains(reasons, row.unsupported))
            reasons.push_back(row.unsupported);
    return reasons;
}

}  // namespace

std::string scene_report(const Experiment& experiment, const std::vector<Row>& rows) {
    const std::vector<Series> all = series_of(rows, experiment.name);
    std::string text =
        "\n" + experiment.name + ": " + experiment.about + "\n  " + experiment.measures + "\n";
    text +=
        format_text("  %-8s %-18s %9s   %s\n", "engine", "mode", "at 60 Hz", "order between rates");
    text += lines_of_series(rows, experiment.name, all);
    for (const double tolerance : experiment.tolerances) {
        text += format_text("  least work for %g, us/s:", tolerance);
        for (const std::string& engine : engines_of(all))
            text += " " + engine + " " +
                    work_of(least_work(rows, experiment.name, engine, tolerance)) + ",";
        text.back() = '\n';
    }
    for (const std::string& reason : reasons_of(rows, experiment.name))
        text += "  unsupported: " + reason + "\n";
    text += "  Pareto set:";
    for (const Row& row : pareto_set(rows, experiment.name))
        text += format_text(" %s %s (%.3g us/s, %.2g)", row.engine.c_str(), where(row).c_str(),
                            row.cpu_us_per_second, row.error);
    return text + "\n";
}

std::string score_report(const Score& score) {
    if (score.comparisons.empty()) return "\nNo peers for comparison.\n";
    int behind = 0, far_behind = 0;
    std::string lines;
    for (const Comparison& comparison : score.comparisons) {
        behind += comparison.ratio < 1;
        far_behind += comparison.ratio < 0.5;
        if (comparison.ratio >= 1) continue;
        const std::string peer = comparison.best_peer ? comparison.best_peer->engine : "";
        lines += format_text("  %-10s %-8g %6.2f%s  jostle %s, %s %s\n", comparison.scene.c_str(),
                             comparison.tolerance, comparison.ratio,
                             comparison.ratio < 0.5 ? " below 1/2" : "          ",
                             work_of(comparison.ours).c_str(), peer.c_str(),
                             work_of(comparison.best_peer).c_str());
    }
    return format_text(
               "\nWork of the best peer / work of Jostle, geometric mean of %zu: %.3g; of the %d "
               "that both sides reach: %.3g\n",
               score.comparisons.size(), score.mean, score.both_count, score.both_mean) +
           format_text("Behind in %d, below 1/2 in %d:\n", behind, far_behind) + lines;
}

std::string scenes_csv(const std::vector<const Experiment*>& experiments) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Experiment* experiment : experiments) {
        const std::string& measures = experiment->measures;
        const std::size_t end = std::min(measures.find("; "), measures.size());
        std::string tolerances;
        for (const double tolerance : experiment->tolerances)
            tolerances += format_text(tolerances.empty() ? "%g" : " %g", tolerance);
        rows.push_back({{"scene", experiment->name},
                        {"family", experiment->family},
                        {"description", experiment->about},
                        {"error", measures.substr(0, end)},
                        {"second_error", measures.substr(std::min(end + 2, measures.size()))},
                        {"tolerances", tolerances}});
    }
    return csv_text(rows);
}

nlohmann::ordered_json work_json(const std::vector<Row>& rows) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Experiment& experiment : all_experiments())
        for (const std::string& engine : engines_of(series_of(rows, experiment.name)))
            for (const double tolerance : experiment.tolerances) {
                const auto row = least_work(rows, experiment.name, engine, tolerance);
                nlohmann::ordered_json line = {
                    {"scene", experiment.name}, {"tolerance", tolerance}, {"engine", engine}};
                if (row) {
                    line["cpu_us_per_second"] = row->cpu_us_per_second;
                    line["mode"] = row->mode;
                    line["rate_hz"] = row->rate_hz;
                }
                all.push_back(line);
            }
    return all;
}

nlohmann::ordered_json score_json(const Score& score) {
    nlohmann::ordered_json ratios = nlohmann::ordered_json::array();
    for (const Comparison& comparison : score.comparisons)
        ratios.push_back({{"scene", comparison.scene},
                          {"tolerance", comparison.tolerance},
                          {"ratio", rounded(comparison.ratio)}});
    return {{"geometric_mean", rounded(score.mean)},
            {"both_reach", score.both_count},
            {"geometric_mean_of_both", rounded(score.both_mean)},
            {"ratios", ratios}};
}

namespace {

constexpr double usual_rate = 60;

// A row of Jostle; null if there is none.
const Row* row_at(const std::vector<Row>& rows, const std::string& scene, const std::string& mode,
                  double rate_hz) {
    for (const Row& row : rows)
        if (row.scene == scene && row.engine == engine_kinds()[0].name && row.mode == mode &&
            row.rate_hz == rate_hz)
            return &row;
    return nullptr;
}

bool has_no_second(const Experiment& experiment) {
    return experiment.measures.ends_with("none");
}

const char* peer_of(const Comparison& comparison) {
    return comparison.best_peer ? comparison.best_peer->engine.c_str() : "none";
}

// Bold if it failed; with a star if it failed for another reason than the value.
std::string cell_of(const nlohmann::ordered_json& row) {
    if (row.contains("lacks")) return "-";
    if (!row.contains("figure")) return "**lost**";
    const double figure = row["figure"];
    if (row["pass"]) return format_text("%.2g", figure);
    return format_text("**%.2g%s**", figure, row.value("why", "").empty() ? "" : " *");
}

}  // namespace

std::string jostle_table(const std::vector<Row>& rows) {
    const std::string& usual_mode = engine_kinds()[0].modes[0];
    std::string text =
        "| scene | errors | first | second | CPU us/s | first, iterative |\n"
        "|---|---|---|---|---|---|\n";
    for (const Experiment& experiment : all_experiments()) {
        if (!experiment.family.empty()) continue;
        const Row* row = row_at(rows, experiment.name, usual_mode, usual_rate);
        if (!row) continue;
        text += "| " + row->scene + " | " + experiment.measures + " | ";
        if (!row->usable())
            text += row->failed + " | | |";
        else if (has_no_second(experiment))
            text += format_text("%.2g |  | %.3g |", row->error, row->cpu_us_per_second);
        else
            text += format_text("%.2g | %.2g | %.3g |", row->error, row->second_error,
                                row->cpu_us_per_second);
        const Row* swept = row_at(rows, experiment.name, "iterative", usual_rate);
        if (swept && swept->unsupported.empty())
            text += swept->usable() ? format_text(" %.2g |\n", swept->error) : " blown |\n";
        else
            text += " |\n";
    }
    return text;
}

std::string family_table(const std::vector<Row>& rows) {
    const std::string& usual_mode = engine_kinds()[0].modes[0];
    std::string text =
        "| family | members | first error | 30 Hz | 60 Hz | 120 Hz | 480 Hz | limit |\n"
        "|---|---|---|---|---|---|---|---|\n";
    for (const RowFamily& family : all_families()) {
        const std::vector<Experiment> members = members_of(family);
        text += format_text("| %s | %zu | %s |", family.name.c_str(), members.size(),
                            family.measures.substr(0, family.measures.find("; ")).c_str());
        for (const double rate : {30.0, 60.0, 120.0, 480.0}) {
            double worst = -1;
            bool failed = false;
            for (const Experiment& member : members)
                if (const Row* row = row_at(rows, member.name, usual_mode, rate)) {
                    failed = failed || !row->usable();
                    worst = std::max(worst, row->error);
                }
            text += failed ? " blown |" : worst < 0 ? " - |" : format_text(" %.2g |", worst);
        }
        text += family.limit > 0 ? format_text(" %g |\n", family.limit) : " |\n";
    }
    return text;
}

std::string score_table(const Score& score) {
    int behind = 0, far_behind = 0;
    std::string lines;
    for (const Comparison& comparison : score.comparisons) {
        behind += comparison.ratio < 1;
        far_behind += comparison.ratio < 0.5;
        if (comparison.ratio >= 0.5) continue;
        lines += format_text("| %s | %g | %.2g | %s |\n", comparison.scene.c_str(),
                             comparison.tolerance, comparison.ratio, peer_of(comparison));
    }
    std::string text = format_text(
        "Over %zu pairs of scene and tolerance the best peer's least work over Jostle's has a "
        "geometric mean of\n%.3g. Over the %d pairs that both sides reach it is %.3g. Jostle needs "
        "more work in %d of all pairs,\nand more than twice as much in %d",
        score.comparisons.size(), score.mean, score.both_count, score.both_mean, behind,
        far_behind);
    if (far_behind == 0) return text + ".\n";
    return text + ":\n\n| scene | error | ratio | best peer |\n|---|---|---|---|\n" + lines;
}

std::string stability_table(const nlohmann::ordered_json& rows) {
    std::string head = "| test | limit |", line = "|---|---|", text;
    for (const EngineKind& kind : engine_kinds()) {
        head += std::string(" ") + kind.name + " |";
        line += "---|";
    }
    for (const StressTest& test : all_stress_tests()) {
        std::string cells;
        for (const EngineKind& kind : engine_kinds()) {
            std::string cell = "-";
            for (const auto& row : rows)
                if (row["id"] == test.id && row["engine"] == kind.name &&
                    row["mode"] == kind.modes[0])
                    cell = cell_of(row);
            cells += " " + cell + " |";
        }
        text += format_text("| %s | %g |", test.id.c_str(), test.limit) + cells + "\n";
    }
    return head + "\n" + line + "\n" + text;
}

bool replace_section(const std::string& path, const std::string& name, const std::string& text) {
    std::ifstream in(path);
    std::string all{std::istreambuf_iterator<char>(in), {}};
    const std::string begin = "<!-- begin " + name + " -->\n", end = "<!-- end " + name + " -->";
    const std::size_t from = all.find(begin);
    const std::size_t to = from == all.npos ? all.npos : all.find(end, from);
    if (!in || to == all.npos) {
        std::fprintf(stderr, "jostle-bench: %s has no section %s; add the lines\n%s%s\n",
                     path.c_str(), name.c_str(), begin.c_str(), end.c_str());
        return false;
    }
    all.replace(from + begin.size(), to - from - begin.size(), text);
    return write_text(path, all);
}

}  // namespace jostle::bench::accuracy
