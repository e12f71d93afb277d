// SPDX-License-Identifier: MIT
#include "tools/sim/report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

namespace jostle::sim {

using physics::Stage;
using physics::stage_count;

void StepStatistics::add(const physics::StepProfile& profile, double step_ms) {
    step_ms_.push_back(step_ms);
    if (step_ms_.size() > 1 && step_ms > worst_step_ms_) {
        worst_ = profile;
        worst_step_ms_ = step_ms;
        worst_step_ = step_ms_.size();
    }
    const auto work = static_cast<double>(profile.work);
    work_ += work;
    if (step_ms_.size() > 1) worst_work_ = std::max(worst_work_, work);
    steps_at_overload_level_.at(static_cast<std::size_t>(profile.overload_level))++;
    for (std::size_t k = 0; k < stage_count; k++) {
        stage_ms_[k] += profile.stage_ms[k];
        stage_skipped_[k] = profile.stage_skipped[k];
        if (stage_skipped_[k] == nullptr) stage_ran_[k] = true;
    }
}

void StepStatistics::fill(Report& report, const physics::World& world) const {
    const physics::WorldSummary summary = world.summary();
    report.steps = step_ms_.size();
    report.bodies = summary.bodies;
    report.contacts = summary.contacts;
    report.awake_bodies = summary.awake_bodies;
    report.energy_joules = summary.kinetic_energy + summary.potential_energy;
    report.max_penetration_m = summary.max_penetration;
    report.state_hash = physics::state_hash(world);
    if (step_ms_.empty()) return;
    const auto n = static_cast<double>(step_ms_.size());
    report.ms_per_step_mean = std::accumulate(step_ms_.begin(), step_ms_.end(), 0.0) / n;
    std::vector<double> sorted = step_ms_;
    std::sort(sorted.begin(), sorted.end());
    report.ms_per_step_p99 = sorted[static_cast<std::size_t>(0.99 * (n - 1) + 0.5)];
    report.work_mean = work_ / n;
    report.work_worst = worst_work_;
    report.steps_at_overload_level = steps_at_overload_level_;
    report.worst_step = worst_step_;
    report.worst_step_ms = worst_step_ms_;
    report.worst_stage = worst_.worst_stage;
    report.worst_stage_ms = worst_.worst_stage_ms;
    for (std::size_t k = 0; k < stage_count; k++) {
        report.stage_ms_mean[k] = stage_ms_[k] / n;
        if (!stage_ran_[k]) report.stage_skipped[k] = stage_skipped_[k];
    }
}

namespace {

std::string hex(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

void add_text_line(std::string& out, const char* name, const std::string& value) {
    char padded[64];
    std::snprintf(padded, sizeof padded, "%-22s ", name);
    out += padded + value + "\n";
}

void line(std::string& out, const char* name, const char* format, double value) {
    char number[64];
    std::snprintf(number, sizeof number, format, value);
    add_text_line(out, name, number);
}

std::string worst_step(const Report& r) {
    char words[160];
    std::snprintf(words, sizeof words, "%llu: %.4f ms, including %s %.4f",
                  static_cast<unsigned long long>(r.worst_step), r.worst_step_ms,
                  stage_name(r.worst_stage), r.worst_stage_ms);
    return words;
}

// Number of steps at each overload level, from 0.
std::string overload_steps(const Report& r) {
    std::string words;
    for (const std::uint64_t steps : r.steps_at_overload_level)
        words += std::to_string(steps) + " ";
    words.pop_back();
    return words;
}

}  // namespace

std::string to_text(const Report& r) {
    std::string out = "scene                  " + r.scene + "\n";
    line(out, "steps", "%.0f", static_cast<double>(r.steps));
    line(out, "bodies", "%.0f", r.bodies);
    line(out, "contacts", "%.0f", r.contacts);
    line(out, "ms_per_step_mean", "%.4f", r.ms_per_step_mean);
    line(out, "ms_per_step_p99", "%.4f", r.ms_per_step_p99);
    if (r.worst_step > 0) add_text_line(out, "worst_step", worst_step(r));
    line(out, "work_per_step_mean", "%.0f", r.work_mean);
    line(out, "work_per_step_worst", "%.0f", r.work_worst);
    if (r.steps_at_overload_level[0] < r.steps)
        add_text_line(out, "steps_at_overload_level", overload_steps(r));
    line(out, "cpu_ms_per_step_mean", "%.4f", r.cpu_ms_per_step_mean);
    add_text_line(out, "arithmetic", physics::arithmetic_name(physics::arithmetic()));
    add_text_line(out, "instructions", physics::instruction_set_name(physics::instruction_set()));
    out += "state_hash             " + hex(r.state_hash) + "\n";
    line(out, "energy_joules", "%.6g", r.energy_joules);
    line(out, "max_penetration_m", "%.6g", r.max_penetration_m);
    line(out, "awake_bodies", "%.0f", r.awake_bodies);
    out += "stages, ms per step (mean):\n";
    for (int k = 0; k < stage_count; k++) {
        const std::string name = std::string("  ") + stage_name(static_cast<Stage>(k));
        const char* reason = r.stage_skipped[static_cast<std::size_t>(k)];
        if (reason == nullptr)
            line(out, name.c_str(), "%.4f", r.stage_ms_mean[static_cast<std::size_t>(k)]);
        else
            add_text_line(out, name.c_str(), std::string("skipped: ") + reason);
    }
    return out;
}

std::string to_json(const Report& r) {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object(), skipped = stages;
    for (std::size_t k = 0; k < stage_count; k++) {
        const char* name = stage_name(static_cast<Stage>(k));
        stages[name] = r.stage_ms_mean[k];
        if (r.stage_skipped[k] != nullptr) skipped[name] = r.stage_skipped[k];
    }
    nlohmann::ordered_json worst = nullptr;
    if (r.worst_step > 0)
        worst = {{"step", r.worst_step},
                 {"ms", r.worst_step_ms},
                 {"stage", stage_name(r.worst_stage)},
                 {"stage_ms", r.worst_stage_ms}};
    nlohmann::ordered_json tolerance = nullptr;
    if (r.tolerance)
        tolerance = {{"tolerance_m", r.tolerance->tolerance},
                     {"measured", r.tolerance->measured},
                     {"islands_over", r.tolerance->islands_over},
                     {"worst_m", r.tolerance->worst}};
    const nlohmann::ordered_json json = {
        {"scene", r.scene},
        {"hz", r.hz},
        {"substeps", r.substeps},
        {"threads", r.threads},
        {"steps", r.steps},
        {"bodies", r.bodies},
        {"contacts", r.contacts},
        {"ms_per_step_mean", r.ms_per_step_mean},
        {"ms_per_step_p99", r.ms_per_step_p99},
        {"worst_step", worst},
        {"work_per_step_mean", r.work_mean},
        {"work_per_step_worst", r.work_worst},
        {"steps_at_overload_level", r.steps_at_overload_level},
        {"cpu_ms_per_step_mean", r.cpu_ms_per_step_mean},
        {"arithmetic", physics::arithmetic_name(physics::arithmetic())},
        {"instructions", physics::instruction_set_name(physics::instruction_set())},
        {"state_hash", hex(r.state_hash)},
        {"energy_joules", r.energy_joules},
        {"max_penetration_m", r.max_penetration_m},
        {"awake_bodies", r.awake_bodies},
        {"error_tolerance", tolerance},
        {"stages", stages},
        {"stages_skipped", skipped}};
    return json.dump(2) + "\n";
}

}  // namespace jostle::sim
