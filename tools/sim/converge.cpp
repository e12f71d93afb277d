// SPDX-License-Identifier: MIT
#include "tools/sim/converge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "jostle/analysis/work_error.h"

namespace jostle::sim {
namespace {

using physics::Error;
using physics::Result;
using physics::Status;

constexpr double slowest_hz = 4;              // of any step
constexpr std::size_t samples_max = 240;      // looked at in a run
constexpr double short_run = 0.05;            // s of processor time: repeated, the least counts
constexpr double safe_ratio = 0.25;           // of the tolerance: agreement that leaves no doubt
constexpr double perturbation_ratio = 1e-6;   // of the scale, a second
constexpr double chaotic_growth = 100;        // of a nudge
constexpr double order_min = 0.5;             // of the doubt: below, refining does not help
constexpr double reference_error_margin = 4;  // times it: an error that is the run's own
constexpr double extent_min = 1e-3;           // m: bodies that hardly move say nothing of a scale

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string name_of(const StepSettings& setting) {
    return number(setting.hz) + " Hz, " + std::to_string(setting.substeps) + " sub-steps";
}

double error_of(const Distance& distance, double scale) {
    return std::max(distance.position / scale, distance.angle);
}

Status check(const scenes::SceneDescription& scene, const ConvergenceOptions& options) {
    const auto is_dynamic = [](const auto& b) { return b.body.type == physics::BodyType::dynamic; };
    if (std::none_of(scene.bodies.begin(), scene.bodies.end(), is_dynamic))
        return Error{{}, scene.name + " has no dynamic body: there is nothing to converge"};
    const auto& rates = options.rates;
    if (rates.size() == 1)
        return Error{{}, "one rate cannot be compared with anything: give two or more"};
    for (std::size_t k = 1; k < rates.size(); k++) {
        const double times = rates[k] / rates[0];
        if (std::abs(times - std::round(times)) > 1e-9 * times)
            return Error{{},
                         number(rates[k]) + " Hz is no multiple of " + number(rates[0]) +
                             " Hz, so that the runs have no times in common"};
    }
    return {};
}

std::vector<double> rates_of(const scenes::SceneDescription& scene,
                             const ConvergenceOptions& options) {
    if (!options.rates.empty()) return options.rates;
    std::vector<double> rates = {0.5 * scene.hz >= slowest_hz ? 0.5 * scene.hz : scene.hz};
    while (2 * rates.back() <= options.finest_hz * (1 + 1e-9)) rates.push_back(2 * rates.back());
    return rates;
}

std::vector<int> substeps_of(const scenes::SceneDescription& scene,
                             const ConvergenceOptions& options) {
    std::vector<int> substeps = options.substeps;
    const int usual = scene.world.substeps;
    if (substeps.empty())
        substeps = {std::max(usual / 4, 1), std::max(usual / 2, 1), usual, std::min(2 * usual, 64)};
    std::sort(substeps.begin(), substeps.end());
    substeps.erase(std::unique(substeps.begin(), substeps.end()), substeps.end());
    return substeps;
}

// Runs a scene at one setting after the other, as long as the budget lasts.
class Runs {
public:
    Runs(const scenes::SceneDescription& scene, const ConvergenceOptions& options,
         SampleTimes samples, const ProgressCallback& on_progress)
        : scene_(scene),
          samples_(samples),
          seconds_(static_cast<double>(samples.count) / samples.hz),
          budget_(options.budget_seconds),
          on_progress_(on_progress) {}

    struct Run {
        StepSettings setting;
        Trajectory trajectory;
        double cpu_us_per_second = 0;
    };

    Result<Run> run(const StepSettings& setting) {
        on_progress_(name_of(setting));
        auto trajectory = simulate_trajectory(scene_, setting, samples_);
        if (!trajectory) return trajectory.error();
        double least = trajectory->cpu_seconds;
        spent_ += least;
        for (int k = 0; k < 2 && least < short_run; k++)
            if (auto again = simulate_trajectory(scene_, setting, samples_)) {
                least = std::min(least, again->cpu_seconds);
                spent_ += again->cpu_seconds;
            }
        return Run{setting, std::move(*trajectory), 1e6 * least / seconds_};
    }

    // The same with starts that hardly differ.
    Result<Trajectory> run_perturbed(const StepSettings& setting, double perturbation) {
        on_progress_(name_of(setting) + ", nudged");
        return simulate_trajectory(perturbed(scene_, perturbation), setting, samples_);
    }

    bool is_within_budget(double cpu_us_per_second) const {
        return spent_ + 1e-6 * cpu_us_per_second * seconds_ <= budget_;
    }

private:
    const scenes::SceneDescription& scene_;
    SampleTimes samples_;
    double seconds_, budget_, spent_ = 0;
    const ProgressCallback& on_progress_;
};

// s: when the error at one sample first passes the tolerance; the whole run when it never does.
double agreement_seconds(const Trajectory& a, const Trajectory& b, double scale, double tolerance,
                         const SampleTimes& samples) {
    const std::size_t count = std::min(a.samples(), b.samples());
    for (std::size_t k = 0; k < count; k++)
        if (error_of(distance_at(a, b, k), scale) > tolerance)
            return static_cast<double>(k) / samples.hz;
    return static_cast<double>(count) / samples.hz;
}

double end_error(const Trajectory& a, const Trajectory& b, double scale) {
    return error_of(distance_at(a, b, std::min(a.samples(), b.samples()) - 1), scale);
}

// With the most sub-steps, from the lowest rate up, until two neighbours agree.
Result<std::vector<Runs::Run>> refine(Runs& runs, const ConvergenceOptions& options,
                                      const std::vector<double>& rates, int substeps,
                                      Convergence& found) {
    std::vector<Runs::Run> ladder;
    std::vector<double> doubts;
    for (const double hz : rates) {
        const bool more = ladder.size() >= 2;
        if (more && !runs.is_within_budget(ladder.back().cpu_us_per_second * hz /
                                           ladder.back().setting.hz)) {
            found.skipped_runs = "all rates from " + number(hz) + " Hz on";
            break;
        }
        auto run = runs.run({hz, substeps});
        if (!run) return run.error();
        if (!run->trajectory.failure.empty())
            return Error{
                {}, "the run at " + name_of(run->setting) + " ended: " + run->trajectory.failure};
        ladder.push_back(std::move(*run));
        const double extent = extent_of(ladder.back().trajectory);
        found.scale = options.scale > 0 ? options.scale : extent > extent_min ? extent : 1;
        if (ladder.size() < 2) continue;
        doubts.push_back(error_of(
            distance_between(ladder[ladder.size() - 2].trajectory, ladder.back().trajectory),
            found.scale));
        if (options.rates.empty() && doubts.back() <= safe_ratio * options.tolerances.back()) break;
    }
    if (doubts.empty())
        return Error{{}, "there is one rate alone, so nothing to compare: raise --finest-hz"};
    found.finest = ladder.back().setting;
    found.reference_error = doubts.back();
    if (doubts.size() > 1)
        found.reference_order = convergence::observed_order(
            doubts[doubts.size() - 2], doubts.back(),
            ladder.back().setting.hz / ladder[ladder.size() - 2].setting.hz);
    return ladder;
}

ConvergenceRow row_of(const Runs::Run& run, const Trajectory& truth, const Convergence& found,
                      const SampleTimes& samples) {
    ConvergenceRow row{.setting = run.setting,
                       .cpu_us_per_second = run.cpu_us_per_second,
                       .failure = run.trajectory.failure};
    if (!row.failure.empty()) return row;
    const Distance distance = distance_between(run.trajectory, truth);
    row.distance = distance.position;
    row.angle = distance.angle;
    row.error = error_of(distance, found.scale);
    row.end_error = end_error(run.trajectory, truth, found.scale);
    row.agreement_seconds =
        agreement_seconds(run.trajectory, truth, found.scale, found.tolerances.front(), samples);
    return row;
}

// Only where the error is clear of the doubt: below, it is as much the truth's as the run's.
void add_orders(std::vector<ConvergenceRow>& rows, double reference_error) {
    for (std::size_t k = 1; k < rows.size(); k++) {
        const ConvergenceRow& before = rows[k - 1];
        if (before.setting.substeps != rows[k].setting.substeps) continue;
        if (!(rows[k].error > reference_error_margin * reference_error)) continue;
        rows[k].order = convergence::observed_order(before.error, rows[k].error,
                                                    rows[k].setting.hz / before.setting.hz);
    }
}

// Whether starts that hardly differ part as the runs do.
Status perturbation(Runs& runs, const std::vector<Runs::Run>& ladder,
                    const ConvergenceOptions& options, Convergence& found) {
    const Runs::Run& same = ladder[std::min<std::size_t>(1, ladder.size() - 1)];
    found.perturbation = perturbation_ratio * found.scale;
    auto perturbed_run = runs.run_perturbed(same.setting, found.perturbation);
    if (!perturbed_run) return perturbed_run.error();
    if (perturbed_run->samples() == 0)
        return Error{{}, "the nudged run ended: " + perturbed_run->failure};
    found.perturbation_error = end_error(same.trajectory, *perturbed_run, found.scale);
    found.growth = found.perturbation_error / (perturbation_ratio * options.seconds);
    return {};
}

Verdict verdict_of(const Convergence& found) {
    if (found.reference_error <= found.tolerances.back()) return Verdict::converged;
    const bool closer = found.reference_order && *found.reference_order > order_min;
    return !closer && found.growth > chaotic_growth ? Verdict::chaotic : Verdict::not_converged;
}

}  // namespace

std::optional<ConvergenceRow> Convergence::cheapest(double tolerance) const {
    if (reference_error > tolerance) return {};
    std::vector<convergence::WorkError> runs;
    for (const ConvergenceRow& row : rows)
        runs.push_back({row.cpu_us_per_second,
                        row.failure.empty() ? row.error : std::numeric_limits<double>::infinity()});
    const auto best = convergence::least_work(runs, tolerance);
    if (!best) return {};
    return rows[*best];
}

Result<Convergence> converge(const scenes::SceneDescription& scene,
                             const ConvergenceOptions& options,
                             const ProgressCallback& on_progress) {
    if (auto status = check(scene, options); !status) return status.error();
    const std::vector<double> rates = rates_of(scene, options);
    const std::vector<int> substeps = substeps_of(scene, options);
    // Every step of the lowest rate, or every second one, and so on.
    const double steps = std::round(options.seconds * rates[0]);
    if (steps < 1)
        return Error{{},
                     number(options.seconds) + " s are less than one step at " + number(rates[0]) +
                         " Hz: simulate longer"};
    const double stride = std::ceil(steps / static_cast<double>(samples_max));
    const SampleTimes samples{rates[0] / stride, static_cast<std::size_t>(steps / stride)};

    Convergence found{.scene = scene.name,
                      .seconds = static_cast<double>(samples.count) / samples.hz,
                      .tolerances = options.tolerances};
    Runs runs(scene, options, samples, on_progress);
    auto ladder = refine(runs, options, rates, substeps.back(), found);
    if (!ladder) return ladder.error();
    const Trajectory& truth = ladder->back().trajectory;
    found.bodies = static_cast<int>(truth.bodies);
    found.agreement_seconds = agreement_seconds((*ladder)[ladder->size() - 2].trajectory, truth,
                                                found.scale, found.tolerances.front(), samples);
    if (auto status = perturbation(runs, *ladder, options, found); !status) return status.error();
    found.verdict = verdict_of(found);

    for (const int count : substeps)
        for (const Runs::Run& step : *ladder) {
            if (count == substeps.back()) {
                found.rows.push_back(row_of(step, truth, found, samples));
                continue;
            }
            if (!runs.is_within_budget(step.cpu_us_per_second)) {
                found.skipped_runs = "some settings";
                break;
            }
            const auto run = runs.run({step.setting.hz, count});
            if (!run) return run.error();
            found.rows.push_back(row_of(*run, truth, found, samples));
        }
    // Nothing is known better than the finest run's neighbour says.
    for (ConvergenceRow& row : found.rows) row.error = std::max(row.error, found.reference_error);
    found.rows.back().end_error = found.reference_error;
    add_orders(found.rows, found.reference_error);
    return found;
}

}  // namespace jostle::sim
