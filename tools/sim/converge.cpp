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

constexpr double slowest_hz = 4;          // minimum step rate
constexpr std::size_t samples_max = 240;  // maximum number of samples per run
// s of CPU time: shorter runs are repeated and the minimum counts
constexpr double short_run = 0.05;
constexpr double safe_ratio = 0.25;          // of the tolerance: refinement stops below
constexpr double perturbation_ratio = 1e-6;  // of the scale, per second
constexpr double chaotic_growth = 100;       // of a perturbation
constexpr double order_min = 0.5;  // of the reference error: below it, refinement does not help
// errors above this multiple of the reference error belong to the run
constexpr double reference_error_margin = 4;
constexpr double tie_ratio = 1.15;       // of times
constexpr double worse_ratio = 4.0 / 3;  // of errors
constexpr double extent_min = 1e-3;      // m: below it, the motion does not define a scale

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
        return Error{{}, scene.name + " has no dynamic body; --converge needs at least one"};
    const auto& rates = options.rates;
    if (rates.size() == 1)
        return Error{{}, "one rate cannot be compared; --rates needs at least two"};
    for (std::size_t k = 1; k < rates.size(); k++) {
        const double times = rates[k] / rates[0];
        if (std::abs(times - std::round(times)) > 1e-9 * times)
            return Error{{},
                         number(rates[k]) + " Hz is not a multiple of " + number(rates[0]) +
                             " Hz, so the runs have no common sample times"};
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

// Runs a scene with several settings while the budget lasts.
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
        double minimum = trajectory->cpu_seconds;
        spent_ += minimum;
        for (int k = 0; k < 2 && minimum < short_run; k++)
            if (auto repeated = simulate_trajectory(scene_, setting, samples_)) {
                minimum = std::min(minimum, repeated->cpu_seconds);
                spent_ += repeated->cpu_seconds;
            }
        return Run{setting, std::move(*trajectory), 1e6 * minimum / seconds_};
    }

    // Runs with slightly perturbed initial velocities.
    Result<Trajectory> run_perturbed(const StepSettings& setting, double perturbation) {
        on_progress_(name_of(setting) + ", perturbed");
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

// Time in s until the error first exceeds the tolerance; the duration of the run if it never does.
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

// Refines the step rate with the largest number of sub-steps until two successive runs agree.
Result<std::vector<Runs::Run>> refine(Runs& runs, const ConvergenceOptions& options,
                                      const std::vector<double>& rates, int substeps,
                                      Convergence& found) {
    std::vector<Runs::Run> ladder;
    std::vector<double> reference_errors;
    for (const double hz : rates) {
        const bool more = ladder.size() >= 2;
        if (more && !runs.is_within_budget(ladder.back().cpu_us_per_second * hz /
                                           ladder.back().setting.hz)) {
            found.skipped_runs = "all rates from " + number(hz) + " Hz";
            break;
        }
        auto run = runs.run({hz, substeps});
        if (!run) return run.error();
        if (!run->trajectory.failure.empty())
            return Error{
                {}, "the run at " + name_of(run->setting) + " failed: " + run->trajectory.failure};
        ladder.push_back(std::move(*run));
        const double extent = extent_of(ladder.back().trajectory);
        found.scale = options.scale > 0 ? options.scale : extent > extent_min ? extent : 1;
        if (ladder.size() < 2) continue;
        reference_errors.push_back(error_of(
            distance_between(ladder[ladder.size() - 2].trajectory, ladder.back().trajectory),
            found.scale));
        if (options.rates.empty() &&
            reference_errors.back() <= safe_ratio * options.tolerances.back())
            break;
    }
    if (reference_errors.empty())
        return Error{{}, "only one rate is available for comparison; raise --finest-hz"};
    found.finest = ladder.back().setting;
    found.reference_error = reference_errors.back();
    if (reference_errors.size() > 1)
        found.reference_order = analysis::observed_order(
            reference_errors[reference_errors.size() - 2], reference_errors.back(),
            ladder.back().setting.hz / ladder[ladder.size() - 2].setting.hz);
    return ladder;
}

ConvergenceRow row_of(const Runs::Run& run, const Trajectory& reference, const Convergence& found,
                      const SampleTimes& samples) {
    ConvergenceRow row{.setting = run.setting,
                       .cpu_us_per_second = run.cpu_us_per_second,
                       .failure = run.trajectory.failure};
    if (!row.failure.empty()) return row;
    const Distance distance = distance_between(run.trajectory, reference);
    row.distance = distance.position;
    row.angle = distance.angle;
    row.error = error_of(distance, found.scale);
    row.end_error = end_error(run.trajectory, reference, found.scale);
    row.agreement_seconds = agreement_seconds(run.trajectory, reference, found.scale,
                                              found.tolerances.front(), samples);
    return row;
}

// Computes an order only where the error clearly exceeds the reference error; below it, the error
// belongs to the reference as much as to the run.
void add_orders(std::vector<ConvergenceRow>& rows, double reference_error) {
    for (std::size_t k = 1; k < rows.size(); k++) {
        const ConvergenceRow& before = rows[k - 1];
        if (before.setting.substeps != rows[k].setting.substeps) continue;
        if (!(rows[k].error > reference_error_margin * reference_error)) continue;
        rows[k].order = analysis::observed_order(before.error, rows[k].error,
                                                 rows[k].setting.hz / before.setting.hz);
    }
}

// Checks whether slightly perturbed initial conditions diverge as much as the runs.
Status perturbation(Runs& runs, const std::vector<Runs::Run>& ladder,
                    const ConvergenceOptions& options, Convergence& found) {
    const Runs::Run& same = ladder[std::min<std::size_t>(1, ladder.size() - 1)];
    found.perturbation = perturbation_ratio * found.scale;
    auto perturbed_run = runs.run_perturbed(same.setting, found.perturbation);
    if (!perturbed_run) return perturbed_run.error();
    if (perturbed_run->samples() == 0)
        return Error{{}, "the perturbed run failed: " + perturbed_run->failure};
    found.perturbation_error = end_error(same.trajectory, *perturbed_run, found.scale);
    found.growth = found.perturbation_error / (perturbation_ratio * options.seconds);
    return {};
}

// Times scatter, so settings that do not affect the result would be chosen at random.
bool ties(const ConvergenceRow& row, const ConvergenceRow& cheapest) {
    return row.cpu_us_per_second <= tie_ratio * cheapest.cpu_us_per_second ||
           (row.setting.hz == cheapest.setting.hz && row.error == cheapest.error);
}

// Fewer sub-steps, then a lower rate.
bool is_simpler(const ConvergenceRow& row, const ConvergenceRow& other) {
    return row.setting.substeps != other.setting.substeps
               ? row.setting.substeps < other.setting.substeps
               : row.setting.hz < other.setting.hz;
}

Verdict verdict_of(const Convergence& found) {
    if (found.reference_error <= found.tolerances.back()) return Verdict::converged;
    const bool closer = found.reference_order && *found.reference_order > order_min;
    return !closer && found.growth > chaotic_growth ? Verdict::chaotic : Verdict::not_converged;
}

}  // namespace

void mark_worse(std::vector<ConvergenceRow>& rows) {
    for (ConvergenceRow& row : rows) {
        const ConvergenceRow* best = nullptr;
        for (const ConvergenceRow& other : rows)
            if (other.failure.empty() && other.setting.substeps == row.setting.substeps &&
                other.setting.hz < row.setting.hz && (!best || other.error < best->error))
                best = &other;
        if (best && row.failure.empty() && row.error > worse_ratio * best->error)
            row.worse_than_hz = best->setting.hz;
    }
}

std::optional<ConvergenceRow> Convergence::cheapest(double tolerance) const {
    if (reference_error > tolerance) return {};
    std::vector<analysis::WorkError> runs;
    for (const ConvergenceRow& row : rows)
        runs.push_back({row.cpu_us_per_second,
                        row.failure.empty() ? row.error : std::numeric_limits<double>::infinity()});
    const auto best = analysis::least_work(runs, tolerance);
    if (!best) return {};
    const ConvergenceRow& cheapest_row = rows[*best];
    const ConvergenceRow* chosen = &cheapest_row;
    for (std::size_t k = 0; k < rows.size(); k++)
        if (runs[k].error <= tolerance && ties(rows[k], cheapest_row) &&
            is_simpler(rows[k], *chosen))
            chosen = &rows[k];
    return *chosen;
}

Result<Convergence> converge(const scenes::SceneDescription& scene,
                             const ConvergenceOptions& options,
                             const ProgressCallback& on_progress) {
    if (auto status = check(scene, options); !status) return status.error();
    const std::vector<double> rates = rates_of(scene, options);
    const std::vector<int> substeps = substeps_of(scene, options);
    // Samples at every step of the lowest rate, or every second one, and so on.
    const double steps = std::round(options.seconds * rates[0]);
    if (steps < 1)
        return Error{{},
                     number(options.seconds) + " s is less than one step at " + number(rates[0]) +
                         " Hz; increase --seconds"};
    const double stride = std::ceil(steps / static_cast<double>(samples_max));
    const SampleTimes samples{rates[0] / stride, static_cast<std::size_t>(steps / stride)};

    Convergence found{.scene = scene.name,
                      .seconds = static_cast<double>(samples.count) / samples.hz,
                      .tolerances = options.tolerances};
    Runs runs(scene, options, samples, on_progress);
    auto ladder = refine(runs, options, rates, substeps.back(), found);
    if (!ladder) return ladder.error();
    const Trajectory& reference = ladder->back().trajectory;
    found.bodies = static_cast<int>(reference.bodies);
    found.agreement_seconds = agreement_seconds((*ladder)[ladder->size() - 2].trajectory, reference,
                                                found.scale, found.tolerances.front(), samples);
    if (auto status = perturbation(runs, *ladder, options, found); !status) return status.error();
    found.verdict = verdict_of(found);

    for (const int count : substeps)
        for (const Runs::Run& step : *ladder) {
            if (count == substeps.back()) {
                found.rows.push_back(row_of(step, reference, found, samples));
                continue;
            }
            if (!runs.is_within_budget(step.cpu_us_per_second)) {
                found.skipped_runs = "some settings";
                break;
            }
            const auto run = runs.run({step.setting.hz, count});
            if (!run) return run.error();
            found.rows.push_back(row_of(*run, reference, found, samples));
        }
    // No error can be known more accurately than the reference error.
    for (ConvergenceRow& row : found.rows) row.error = std::max(row.error, found.reference_error);
    found.rows.back().end_error = found.reference_error;
    add_orders(found.rows, found.reference_error);
    mark_worse(found.rows);
    return found;
}

}  // namespace jostle::sim
