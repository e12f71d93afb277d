// SPDX-License-Identifier: MIT
#include "tools/sim/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "jostle/base/format_text.h"

namespace jostle::sim {
namespace {

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::converged:
            return "agreed";
        case Verdict::not_converged:
            return "not yet";
        case Verdict::chaotic:
            return "chaotic";
    }
    return "";
}

std::string table(const Convergence& found) {
    std::string text = format_text("%8s %10s %10s %10s %8s %8s %9s %11s\n", "hz", "sub-steps",
                                   "error", "at end", "order", "same to", "us/step", "cpu us/s");
    for (const ConvergenceRow& row : found.rows) {
        const StepSettings& s = row.setting;
        if (!row.failure.empty()) {
            text +=
                format_text("%8g %10d  ended early: %s\n", s.hz, s.substeps, row.failure.c_str());
            continue;
        }
        text += format_text("%8g %10d %10.3g %10.3g %8s %7.3gs %9.3g %11.4g%s\n", s.hz, s.substeps,
                            row.error, row.end_error,
                            row.order ? format_text("%.2f", *row.order).c_str() : "",
                            row.agreement_seconds, row.cpu_us_per_second / s.hz,
                            row.cpu_us_per_second, s == found.finest ? "  finest" : "");
        if (row.worse_than_hz)
            text.insert(text.size() - 1, format_text("  worse than %g Hz", *row.worse_than_hz));
    }
    return text;
}

std::string answer(const Convergence& found, double tolerance) {
    if (found.reference_error > tolerance)
        return format_text("  %-8g unknown: the two finest runs differ by %.3g\n", tolerance,
                           found.reference_error);
    const auto row = found.cheapest(tolerance);
    if (!row) return format_text("  %-8g no setting is accurate enough\n", tolerance);
    return format_text("  %-8g --hz %g --substeps %d  (%.4g us/s, error %.3g)\n", tolerance,
                       row->setting.hz, row->setting.substeps, row->cpu_us_per_second, row->error);
}

// Estimates the rate at which the reference error would reach the tolerance, at the observed order.
std::string rate_needed(const Convergence& found) {
    if (!found.reference_order || *found.reference_order <= 0.1) return "";
    const double times =
        std::pow(found.reference_error / found.tolerances.back(), 1 / *found.reference_order);
    return format_text("; at the observed order %.2f, about %.0f Hz would suffice",
                       *found.reference_order, found.finest.hz * times);
}

std::string verdict(const Convergence& found) {
    switch (found.verdict) {
        case Verdict::converged:
            return format_text("The two finest runs agree: they differ by %.3g.\n",
                               found.reference_error);
        case Verdict::not_converged:
            return format_text("The runs do not agree yet: the two finest differ by %.3g",
                               found.reference_error) +
                   rate_needed(found) +
                   format_text(" (--finest-hz, --budget).\nThey agree to %g for %.3g s.\n",
                               found.tolerances.front(), found.agreement_seconds);
        case Verdict::chaotic:
            break;
    }
    return format_text(
        "The scene is chaotic: no two runs agree. The two finest differ by %.3g. So do runs with\n"
        "initial velocities that differ by %.1g m/s: at the end they are %.3g apart, %.0f times\n"
        "the initial divergence. No rate and no engine can predict the final positions. The two\n"
        "finest agree to %g for %.3g s: reduce --seconds to that time, or use averages over many\n"
        "bodies.\n",
        found.reference_error, found.perturbation, found.perturbation_error, found.growth,
        found.tolerances.front(), found.agreement_seconds);
}

}  // namespace

std::string to_text(const Convergence& found) {
    std::string text = format_text("%s: %d bodies, %g s, one thread\n", found.scene.c_str(),
                                   found.bodies, found.seconds);
    text += format_text(
        "error: the larger of RMS distance of the centres / %.4g m and RMS angle in rad, over all\n"
        "bodies and times, against the finest run. Errors below %.3g, the difference of the two\n"
        "finest runs, are not reported. same to: time until the error exceeds %g.\n\n",
        found.scale, found.reference_error, found.tolerances.front());
    text += table(found) + "\n" + verdict(found);
    const auto worse = std::count_if(found.rows.begin(), found.rows.end(),
                                     [](const ConvergenceRow& row) { return !!row.worse_than_hz; });
    if (worse > 0)
        text += format_text(
            "%td %s by more than a third worse than at a lower rate: finer steps do not help "
            "there.\n",
            worse, worse == 1 ? "error is" : "errors are");
    if (!found.skipped_runs.empty())
        text += "Skipped because they would exceed --budget: " + found.skipped_runs + ".\n";
    text += "Cheapest setting for an error of at most\n";
    for (const double tolerance : found.tolerances) text += answer(found, tolerance);
    return text;
}

std::string to_json(const Convergence& found) {
    using json = nlohmann::ordered_json;
    json rows = json::array(), answers = json::array();
    for (const ConvergenceRow& row : found.rows) {
        json line = {{"hz", row.setting.hz}, {"substeps", row.setting.substeps}};
        if (!row.failure.empty()) {
            line["blown"] = row.failure;
            rows.push_back(line);
            continue;
        }
        line["error"] = row.error;
        line["end_error"] = row.end_error;
        line["distance_m"] = row.distance;
        line["angle_rad"] = row.angle;
        line["agrees_until_s"] = row.agreement_seconds;
        line["order"] = row.order ? json(*row.order) : json(nullptr);
        line["worse_than_hz"] = row.worse_than_hz ? json(*row.worse_than_hz) : json(nullptr);
        line["cpu_us_per_second"] = row.cpu_us_per_second;
        rows.push_back(line);
    }
    for (const double tolerance : found.tolerances) {
        json line = {{"tolerance", tolerance}};
        if (const auto row = found.cheapest(tolerance)) {
            line["hz"] = row->setting.hz;
            line["substeps"] = row->setting.substeps;
            line["cpu_us_per_second"] = row->cpu_us_per_second;
        } else {
            line["hz"] = nullptr;
        }
        answers.push_back(line);
    }
    const json all = {
        {"scene", found.scene},
        {"seconds", found.seconds},
        {"bodies", found.bodies},
        {"scale_m", found.scale},
        {"verdict", name_of(found.verdict)},
        {"finest_hz", found.finest.hz},
        {"finest_substeps", found.finest.substeps},
        {"doubt", found.reference_error},
        {"reference_order", found.reference_order ? json(*found.reference_order) : json(nullptr)},
        {"agreement_s", found.agreement_seconds},
        {"perturbation_m_per_s", found.perturbation},
        {"perturbation_error", found.perturbation_error},
        {"perturbation_growth", found.growth},
        {"skipped_runs", found.skipped_runs},
        {"cheapest", answers},
        {"rows", rows}};
    return all.dump(2) + "\n";
}

}  // namespace jostle::sim
