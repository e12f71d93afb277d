// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_report.h"

#include <cstdio>
#include <fstream>
#include <iterator>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/flag_selection.h"
#include "bench/accuracy/stress_test.h"
#include "bench/result_file.h"
#include "jostle/base/format_text.h"

namespace jostle::bench::accuracy {
namespace {

constexpr double usual_rate = 60;

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
    const EngineKind& jostle = engine_kinds()[0];
    std::string text = "| scene | errors | first | second | CPU us/s |\n|---|---|---|---|---|\n";
    for (const Experiment& experiment : all_experiments())
        for (const Row& row : rows) {
            if (row.scene != experiment.name || row.engine != jostle.name ||
                row.mode != jostle.modes[0] || row.rate_hz != usual_rate)
                continue;
            text += "| " + row.scene + " | " + experiment.measures + " | ";
            if (!row.usable())
                text += row.failed + " | | |\n";
            else if (has_no_second(experiment))
                text += format_text("%.2g |  | %.3g |\n", row.error, row.cpu_us_per_second);
            else
                text += format_text("%.2g | %.2g | %.3g |\n", row.error, row.second_error,
                                    row.cpu_us_per_second);
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
        "geometric mean of\n%.3g. Jostle needs more work in %d of them, and more than twice as "
        "much in %d",
        score.comparisons.size(), score.mean, behind, far_behind);
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
