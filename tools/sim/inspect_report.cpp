// SPDX-License-Identifier: MIT
#include "tools/sim/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "jostle/base/format_text.h"

namespace jostle::sim {
namespace {

using analysis::Analysis;
using analysis::PreconditioningResult;
using analysis::Solution;

constexpr std::size_t rows_shown = 60, redundancies_shown = 12, groups_shown = 40;

std::string bound(double value) {
    return std::abs(value) > 1e200 ? "-" : format_text("%.4g", value);
}

std::string rows_table(const InspectedGroup& group) {
    const Solution* best = group.best();
    const double h = group.system.h;
    std::size_t width = 4;
    for (std::size_t k = 0; k < group.problem.count && k < rows_shown; k++)
        width = std::max(width, group.problem.names[k].size());
    const int name = static_cast<int>(width);
    std::string text =
        format_text("%4s  %-*s %10s %10s %10s %10s %10s %9s %9s\n", "row", name, "what", "A_ii",
                    "softness", "error", "b", "force", "least", "most");
    double most_force = 0;
    if (best != nullptr)
        for (const double x : best->x) most_force = std::max(most_force, std::abs(x) / h);
    // Rounding errors are shown as zero.
    const auto force = [&](double x) { return std::abs(x) / h > 1e-9 * most_force ? x / h : 0.0; };
    for (std::size_t k = 0; k < group.problem.count && k < rows_shown; k++) {
        const physics::ConstraintRow& row = group.system.rows[k];
        const bool known = best != nullptr && k < best->x.size();
        const double least = known ? group.problem.lower_at(k, best->x) : row.lower;
        const double most = known ? group.problem.upper_at(k, best->x) : row.upper;
        const char* mark = known && !best->converged ? "~" : " ";
        text += format_text("%4zu  %-*s %10.4g %10.3g %10.3g %10.3g %10.4g%s%9s %9s\n", k, name,
                            group.problem.names[k].c_str(), group.problem.at(k, k), row.softness,
                            row.error, group.problem.rhs[k] + 0.0, known ? force(best->x[k]) : 0.0,
                            mark, bound(least / h).c_str(), bound(most / h).c_str());
    }
    if (group.problem.count > rows_shown)
        text += format_text("... and %zu more; --json has all of them\n",
                            group.problem.count - rows_shown);
    if (best != nullptr)
        text += format_text(
            "b: the required change of velocity, m/s or rad/s. force and its bounds (N, N m) by "
            "%s.\n"
            "error: position error in m or rad; of limits and contacts the remaining distance.\n",
            name_of(best->method));
    if (best != nullptr && !best->converged)
        text += format_text(
            "~: not converged after %d iterations (residual %.1e): the force may be far from the\n"
            "solution; increase --iterations.\n",
            best->iterations(), best->residual);
    return text;
}

std::string rank_text(const InspectedGroup& group) {
    const Analysis& analysis = group.analysis;
    const std::size_t rows = group.problem.count;
    std::string text;
    if (analysis.singular())
        text += format_text(
            "Rank %zu of %zu: %zu redundant %s, whose forces are not "
            "determined.\n",
            analysis.rank, rows, rows - analysis.rank, rows - analysis.rank == 1 ? "row" : "rows");
    else
        text += format_text("Rank %zu of %zu: no redundant rows.\n", analysis.rank, rows);
    for (std::size_t k = 0; k < analysis.redundancies.size() && k < redundancies_shown; k++)
        text += "  " + to_text(analysis.redundancies[k], group.problem) + "\n";
    if (analysis.redundancies.size() > redundancies_shown)
        text +=
            format_text("  ... and %zu more\n", analysis.redundancies.size() - redundancies_shown);
    if (analysis.inconsistency > 1e-12)
        text += format_text(
            "The redundant rows are contradictory: no impulses produce a share of %.3g of b.\n",
            analysis.inconsistency);
    if (const auto free = group.free_motions())
        text += format_text("Remaining degrees of freedom of the bodies: %d of %d.\n", *free,
                            group.motions());
    text += format_text(
        "Condition number %.4g%s; with diagonal scaling %.4g.\n", analysis.condition,
        analysis.singular() ? " (of the nonzero eigenvalues)" : "", analysis.scaled_condition);
    return text;
}

std::string methods_table(const InspectedGroup& group) {
    std::string text = format_text("%-24s %10s %11s %8s %10s %14s\n", "method", "residual",
                                   "iterations", "ms", "|x|", "out of bounds");
    for (const Solution& solution : group.solutions) {
        if (!solution.failed.empty()) {
            text +=
                format_text("%-24s fails: %s\n", name_of(solution.method), solution.failed.c_str());
            continue;
        }
        const std::string count =
            iterates(solution.method)
                ? format_text("%d%s", solution.iterations(), solution.converged ? "" : "+")
                : "";
        text += format_text("%-24s %10.2e %11s %8.3g %10.4g %14d\n", name_of(solution.method),
                            solution.residual, count.c_str(), solution.milliseconds, solution.size,
                            solution.out_of_bounds);
    }
    text +=
        "All methods except projected Gauss-Seidel treat every row as an equation without "
        "bounds.\n";
    return text;
}

// Residuals after 1, 2, 5, 10, ... iterations.
std::string progress_table(const InspectedGroup& group) {
    std::vector<const Solution*> shown;
    int most = 0;
    for (const Solution& solution : group.solutions)
        if (iterates(solution.method) && solution.iterations() > 0) {
            shown.push_back(&solution);
            most = std::max(most, solution.iterations());
        }
    if (shown.empty()) return "";
    std::string text = format_text("%10s", "iteration");
    for (const Solution* solution : shown) text += format_text(" %23s", name_of(solution->method));
    text += "\n";
    for (int decade = 1; decade <= most; decade *= 10)
        for (const int step : {1, 2, 5}) {
            const int at = decade * step;
            if (at > most) break;
            text += format_text("%10d", at);
            for (const Solution* solution : shown)
                text += at <= solution->iterations()
                            ? format_text(" %23.2e",
                                          solution->residuals[static_cast<std::size_t>(at - 1)])
                            : format_text(" %23s", "");
            text += "\n";
        }
    return text;
}

std::string preconditioning_table(const InspectedGroup& group) {
    std::string text = format_text("%-8s %9s %11s %11s %11s %11s\n", "scaling", "epsilon",
                                   "condition", "gradients", "sweeps", "error");
    for (const PreconditioningResult& t : group.preconditioning)
        text += format_text("%-8s %9.0e %11.3e %10d%s %10d%s %11.2e\n",
                            t.scaled ? "diagonal" : "none", t.epsilon, t.condition,
                            t.gradient_iterations, t.gradients_converged ? " " : "+", t.sweeps,
                            t.sweeps_converged ? " " : "+", t.error);
    text +=
        "epsilon: softness relative to the largest diagonal entry. error: |b - A x| / |b| of the\n"
        "original rows. +: not converged within the limit of iterations.\n";
    return text;
}

std::string list_of(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t k = 0; k < names.size() && k < 8; k++) text += (k == 0 ? "" : ", ") + names[k];
    if (names.size() > 8) text += ", ...";
    return text;
}

std::string full_report(const InspectedGroup& group) {
    return format_text("%zu %s: ", group.bodies.size(),
                       group.bodies.size() == 1 ? "body" : "bodies") +
           list_of(group.bodies) +
           format_text("\n%zu rows, over %.4g ms\n\n", group.problem.count, 1e3 * group.system.h) +
           rows_table(group) + "\n" + rank_text(group) + "\n" + methods_table(group) + "\n" +
           progress_table(group) + "\n" + preconditioning_table(group);
}

std::string group_list(const std::vector<InspectedGroup>& groups) {
    std::string text = format_text("%7s %6s %6s %12s %8s  %s\n", "bodies", "rows", "rank",
                                   "condition", "sweeps", "which");
    for (std::size_t k = 0; k < groups.size() && k < groups_shown; k++) {
        const InspectedGroup& group = groups[k];
        if (!group.unavailable_reason.empty()) {
            text += "  " + group.bodies[0] + ": " + group.unavailable_reason + "\n";
            continue;
        }
        const Solution& swept = group.solutions[0];
        text += format_text("%7zu %6zu %6zu %12.4g %7d%s  ", group.bodies.size(),
                            group.problem.count, group.analysis.rank, group.analysis.condition,
                            swept.iterations(), swept.converged ? " " : "+") +
                list_of(group.bodies) + "\n";
    }
    if (groups.size() > groups_shown)
        text +=
            format_text("... and %zu more; --json has all of them\n", groups.size() - groups_shown);
    return text + "Use a body, as in --inspect " + groups[0].bodies[0] +
           ", to see its group in full.\n";
}

// ---- JSON ----

using json = nlohmann::ordered_json;

json finite_or_null(double value) {
    return std::abs(value) < 1e200 ? json(value) : json(nullptr);
}

json rows_json(const InspectedGroup& group) {
    json rows = json::array();
    for (std::size_t k = 0; k < group.problem.count; k++) {
        const physics::ConstraintRow& row = group.system.rows[k];
        json parts = json::array();
        for (int p = 0; p < row.jacobian_count; p++) {
            const physics::RowJacobian& part = row.jacobians[p];
            parts.push_back({{"body", part.body},
                             {"linear", {part.linear.x, part.linear.y, part.linear.z}},
                             {"angular", {part.angular.x, part.angular.y, part.angular.z}}});
        }
        rows.push_back({{"name", group.problem.names[k]},
                        {"jacobian", parts},
                        {"lower", finite_or_null(row.lower)},
                        {"upper", finite_or_null(row.upper)},
                        {"normal_row", row.normal_row},
                        {"friction", row.friction},
                        {"softness", row.softness},
                        {"error", row.error},
                        {"rate", row.rate},
                        {"bias", row.bias},
                        {"b", group.problem.rhs[k]}});
    }
    return rows;
}

json group_json(const InspectedGroup& group) {
    if (!group.unavailable_reason.empty())
        return {{"bodies", group.bodies}, {"refused", group.unavailable_reason}};
    const Analysis& analysis = group.analysis;
    json redundancies = json::array(), methods = json::array(), preconditioning = json::array();
    for (const auto& redundancy : analysis.redundancies) {
        json of = json::array();
        for (const auto& share : redundancy.of)
            of.push_back({{"row", share.row}, {"factor", share.factor}});
        redundancies.push_back(
            {{"row", redundancy.row}, {"of", of}, {"words", to_text(redundancy, group.problem)}});
    }
    for (const Solution& solution : group.solutions) {
        json line = {{"method", name_of(solution.method)}};
        if (!solution.failed.empty()) {
            line["failed"] = solution.failed;
        } else {
            line["residual"] = finite_or_null(solution.residual);
            line["converged"] = solution.converged;
            line["milliseconds"] = solution.milliseconds;
            line["out_of_bounds"] = solution.out_of_bounds;
            line["impulses"] = solution.x;
            if (iterates(solution.method)) line["residuals"] = solution.residuals;
        }
        methods.push_back(line);
    }
    for (const PreconditioningResult& t : group.preconditioning)
        preconditioning.push_back({{"scaled", t.scaled},
                                   {"epsilon", t.epsilon},
                                   {"condition", finite_or_null(t.condition)},
                                   {"gradient_iterations", t.gradient_iterations},
                                   {"gradients_converged", t.gradients_converged},
                                   {"sweeps", t.sweeps},
                                   {"sweeps_converged", t.sweeps_converged},
                                   {"error", finite_or_null(t.error)}});
    const auto free = group.free_motions();
    return {{"bodies", group.bodies},
            {"h", group.system.h},
            {"rows", rows_json(group)},
            {"matrix", group.problem.matrix},
            {"rank", analysis.rank},
            {"condition", analysis.condition},
            {"scaled_condition", analysis.scaled_condition},
            {"eigenvalues", analysis.eigenvalues},
            {"contradiction", analysis.inconsistency},
            {"motions", group.motions()},
            {"free_motions", free ? json(*free) : json(nullptr)},
            {"redundancies", redundancies},
            {"methods", methods},
            {"treatments", preconditioning}};
}

}  // namespace

std::string to_text(const Inspection& found) {
    const std::string head = format_text("%s after step %llu (%.4g s)\n", found.scene.c_str(),
                                         static_cast<unsigned long long>(found.step), found.time);
    if (found.groups.empty())
        return head + "No joint and no contact can act now: there is nothing to solve.\n";
    if (found.groups.size() > 1) return head + group_list(found.groups);
    const InspectedGroup& group = found.groups[0];
    return head + (group.unavailable_reason.empty() ? full_report(group)
                                                    : group.unavailable_reason + "\n");
}

std::string to_json(const Inspection& found) {
    json groups = json::array();
    for (const InspectedGroup& group : found.groups) groups.push_back(group_json(group));
    const json all = {
        {"scene", found.scene}, {"step", found.step}, {"seconds", found.time}, {"groups", groups}};
    return all.dump() + "\n";
}

std::string residuals_csv(const Inspection& found) {
    std::string text = "scene,step,group,method,converged,iteration,residual\n";
    for (std::size_t group = 0; group < found.groups.size(); group++)
        for (const Solution& solution : found.groups[group].solutions)
            for (std::size_t k = 0; k < solution.residuals.size(); k++)
                text += format_text("%s,%llu,%zu,%s,%d,%zu,%.6g\n", found.scene.c_str(),
                                    static_cast<unsigned long long>(found.step), group,
                                    name_of(solution.method), solution.converged ? 1 : 0, k + 1,
                                    solution.residuals[k]);
    return text;
}

}  // namespace jostle::sim
