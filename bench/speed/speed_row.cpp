// SPDX-License-Identifier: MIT
#include "bench/speed/speed_row.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/measure.h"
#include "bench/processes/program.h"
#include "bench/result_file.h"
#include "bench/speed/accuracy_check.h"
#include "bench/speed/field_json.h"

namespace jostle::bench {

namespace {

using physics::Transform;
using scenes::SceneDescription;

constexpr int sleep_steps_max = 600;
constexpr double moving_speed = 0.05;  // m/s
// of the dynamic bodies; below it the scene counts as resting
constexpr double moving_share = 0.05;
constexpr int sleep_check_interval = 10;
// A step of a sleeping world takes less time than reading the clock.
constexpr int steps_per_reading_asleep = 20;

// One engine with one scene.
class Run {
public:
    Run(const RowRequest& request, const SceneDescription& scene, const char* doing)
        : scene_(scene),
          asleep_first_(request.scene->asleep_first),
          player_(player_of(*request.scene, scene)),
          dynamic_(std::ranges::count_if(scene.bodies, is_dynamic)),
          engine_(request.engine->make()),
          label_(std::string(request.scene->letter) + " " + request.scene->name + ", " +
                 request.engine->name + ", threads " + std::to_string(request.threads) + ": " +
                 doing + ", step ") {}

    physics::Status start() {
        if (auto status = engine_->init(scene_); !status) return status;
        if (asleep_first_)
            for (int k = 0; k < sleep_steps_max && !asleep_at_; k++) step(k);
        return {};
    }

    // Work outside of the engine's step; call it before the timed section.
    void prepare(int step) {
        if (player_) {
            physics::Vec3 velocity = player_velocity(step * (1 / scene_.hz));
            velocity.y = engine_->velocity(*player_).y;
            engine_->set_velocity(*player_, velocity);
        }
        if (step % 20 == 0) show_progress(label_ + std::to_string(step));
    }
    void step() { engine_->step(); }
    void check_sleep(int steps_done) {
        if (sleep_allowed() && !asleep_at_ && engine_->awake() == 0) asleep_at_ = steps_done;
    }
    // Driven bodies do not sleep. After the timed steps, the player is released so that the scene
    // can fall asleep.
    void release_player(int steps_done) {
        if (!sleep_allowed() || !player_) return;
        for (int k = 1; k <= sleep_steps_max && !asleep_at_; k++) {
            step();
            check_sleep(steps_done + k);
        }
    }

    bool sleep_allowed() const { return scene_.world.sleeping; }
    int awake() const { return engine_->awake(); }
    const char* worst_stage() const { return engine_->worst_stage(); }
    int moving() const {
        int count = 0;
        for (std::uint32_t k = 0; k < scene_.bodies.size(); k++)
            count += is_dynamic(scene_.bodies[k]) && length(engine_->velocity(k)) > moving_speed;
        return count;
    }
    bool is_moving() const { return moving() > moving_share * static_cast<double>(dynamic_); }
    const std::vector<Transform>& poses() {
        poses_.resize(scene_.bodies.size());
        for (std::uint32_t k = 0; k < poses_.size(); k++) poses_[k] = engine_->pose(k);
        return poses_;
    }
    std::optional<int> asleep_at() const { return asleep_at_; }

private:
    void step(int k) {
        prepare(k);
        step();
        check_sleep(k + 1);
    }

    const SceneDescription& scene_;
    bool asleep_first_;
    std::optional<std::uint32_t> player_;
    std::ptrdiff_t dynamic_;  // number of dynamic bodies
    std::unique_ptr<Engine> engine_;
    std::string label_;
    std::optional<int> asleep_at_;
    std::vector<Transform> poses_;
};

// Times of single steps or of blocks of steps: milliseconds per step, and the most expensive stage
// of the last step of each.
struct StepTimes {
    std::vector<double> ms;
    std::vector<const char*> worst_stage;  // null: the engine does not report it
};
StepTimes time_steps(Run& run, const StepClock& clock, int steps, int block) {
    StepTimes times;
    times.ms.reserve(static_cast<std::size_t>(steps));
    for (int done = 0; done < steps;) {
        const int count = std::min(block, steps - done);
        run.prepare(done);
        const double began = clock.seconds();
        for (int k = 0; k < count; k++) run.step();
        times.ms.push_back(1e3 * (clock.seconds() - began) / count);
        times.worst_stage.push_back(run.worst_stage());
        done += count;
        run.check_sleep(done);
    }
    return times;
}

// The first step, which creates all contacts, counts only if there is no other.
void write_worst_step(SpeedRow& row, const StepTimes& times) {
    const std::size_t first = times.ms.size() > 1 ? 1 : 0;
    const auto worst = static_cast<std::size_t>(
        std::max_element(times.ms.begin() + static_cast<std::ptrdiff_t>(first), times.ms.end()) -
        times.ms.begin());
    row.ms_worst = rounded(times.ms[worst]);
    if (times.worst_stage[worst] != nullptr) row.worst_stage = times.worst_stage[worst];
}

// Rounded to 0.1 mm, so that heights of 1 m and 100 m are equally precise.
double highest(const SceneDescription& scene, const std::vector<Transform>& poses) {
    double top = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < poses.size(); k++)
        if (is_dynamic(scene.bodies[k]) && is_finite(poses[k]))
            top = std::max(top, poses[k].position.y);
    return 1e-4 * std::round(1e4 * top);
}

std::optional<int> count_tunnelled(const SpeedScene& speed_scene, const SceneDescription& scene,
                                   const std::vector<Transform>& poses) {
    if (!speed_scene.tunnelled_beyond_x) return std::nullopt;
    int count = 0;
    for (std::size_t k = 0; k < poses.size(); k++)
        count +=
            is_dynamic(scene.bodies[k]) && poses[k].position.x > *speed_scene.tunnelled_beyond_x;
    return count;
}

// Splits the times into moving and resting steps; the first step of a block decides.
void split_by_motion(SpeedRow& row, const std::vector<double>& ms,
                     const std::vector<bool>& is_moving) {
    std::vector<double> moving, resting;
    const std::size_t block = (is_moving.size() + ms.size() - 1) / ms.size();
    for (std::size_t k = 1; k < ms.size(); k++)
        (is_moving[k * block] ? moving : resting).push_back(ms[k]);
    if (!moving.empty()) row.ms_moving_mean = rounded(mean(moving));
    if (!resting.empty()) row.ms_rest_mean = rounded(mean(resting));
}

// The second run of the same steps: checks every tenth step and the last. Returns for each step
// whether the scene was moving.
std::vector<bool> measure_accuracy(SpeedRow& row, const SceneDescription& scene, Run& run) {
    std::vector<bool> is_moving;
    const AccuracyCheck check(scene);
    double peak = 0, peak_drift = 0;
    for (int k = 1; k <= row.steps; k++) {
        run.prepare(k - 1);
        run.step();
        is_moving.push_back(run.is_moving());
        if (k % sleep_check_interval != 0 && k != row.steps) continue;
        const std::vector<Transform>& poses = run.poses();
        const Penetration now = check.penetration(poses);
        const double drift = check.joint_drift(poses);
        peak = std::max(peak, now.deepest);
        peak_drift = std::max(peak_drift, drift);
        if (k < row.steps) continue;
        row.max_penetration_m = rounded(now.deepest);
        row.mean_penetration_m = rounded(now.mean);
        row.contacts_over_1cm = now.over_1cm;
        row.bodies_lost = now.lost;
        if (!scene.joints.empty()) row.joint_drift_m = rounded(drift);
    }
    row.peak_penetration_m = rounded(peak);
    if (!scene.joints.empty()) row.peak_joint_drift_m = rounded(peak_drift);
    return is_moving;
}

SpeedRow named_row(const RowRequest& request) {
    return {.scene = request.scene->letter,
            .name = request.scene->name,
            .engine = request.engine->name,
            .threads = request.threads,
            .steps = request.steps,
            .parameters = values_of(request.scene->parameters, request.parameters)};
}

struct TimedRun {
    std::vector<double> ms;        // per step, or per block of steps
    std::vector<Transform> poses;  // at the end
};

// Fills in the times, the memory and the values of the final poses.
physics::Result<TimedRun> run_timed(SpeedRow& row, const RowRequest& request,
                                    const SceneDescription& scene) {
    Run run(request, scene, "timing");
    if (auto status = run.start(); !status) return status.error();
    const StepClock clock{request.threads};
    StepTimes times = time_steps(run, clock, row.steps,
                                 request.scene->asleep_first ? steps_per_reading_asleep : 1);
    const std::vector<double>& ms = times.ms;
    row.ms_mean = rounded(mean(ms));
    row.ms_p99 = rounded(percentile_99(ms));
    row.ms_first = rounded(ms[0]);
    write_worst_step(row, times);
    row.clock = clock.name();
    row.rss_mib = rounded(peak_memory_bytes() / (1 << 20));
    if (run.sleep_allowed()) {
        row.awake_at_end = run.awake();
        row.moving_at_end = run.moving();
    }
    row.top_m = highest(scene, run.poses());
    std::vector<Transform> poses = run.poses();
    row.tunnelled = count_tunnelled(*request.scene, scene, poses);
    run.release_player(row.steps);
    row.asleep_at_step = run.asleep_at();
    return TimedRun{std::move(times.ms), std::move(poses)};
}

}  // namespace

SpeedRow measure_row(const RowRequest& request) {
    SceneDescription scene = build(*request.scene, request.parameters);
    scene.world.threads = request.threads;
    scene.world.sleeping = request.sleep || request.scene->sleeps || request.scene->asleep_first;
    SpeedRow row = named_row(request);
    row.bodies = static_cast<int>(scene.bodies.size());
    if (row.steps == 0) row.steps = request.scene->steps;
    auto timed = run_timed(row, request, scene);
    if (!timed) {
        row.failed = timed.error().message;
        return row;
    }
    if (!request.accuracy) return row;
    Run second_run(request, scene, "accuracy");
    if (auto status = second_run.start(); !status) {
        row.failed = status.error().message;
        return row;
    }
    split_by_motion(row, timed->ms, measure_accuracy(row, scene, second_run));
    row.repeats = second_run.poses() == timed->poses;
    return row;
}

SpeedRow measure_row_in_child(const RowRequest& request) {
    const ChildResult answer = run_in_child([&] { return to_json(measure_row(request)).dump(); });
    show_progress("");
    if (answer.failure.empty()) return speed_row_from(nlohmann::ordered_json::parse(answer.text));
    SpeedRow row = named_row(request);
    row.failed = answer.failure;
    return row;
}

namespace {

// The list of fields, written and read in this order.
template <class Row, class Field>
void visit_identity(Row& row, Field&& field) {
    field("scene", row.scene);
    field("name", row.name);
    field("engine", row.engine);
    field("threads", row.threads);
    field("steps", row.steps);
    field("failed", row.failed);
}

template <class Row, class Field>
void visit_figures(Row& row, Field&& field) {
    field("bodies", row.bodies);
    field("ms_mean", row.ms_mean);
    field("ms_p99", row.ms_p99);
    field("ms_worst", row.ms_worst);
    field("worst_stage", row.worst_stage);
    field("ms_first", row.ms_first);
    field("ms_moving_mean", row.ms_moving_mean);
    field("ms_rest_mean", row.ms_rest_mean);
    field("clock", row.clock);
    field("max_penetration_m", row.max_penetration_m);
    field("peak_penetration_m", row.peak_penetration_m);
    field("mean_penetration_m", row.mean_penetration_m);
    field("contacts_over_1cm", row.contacts_over_1cm);
    field("joint_drift_m", row.joint_drift_m);
    field("peak_joint_drift_m", row.peak_joint_drift_m);
    field("bodies_lost", row.bodies_lost);
    field("repeats", row.repeats);
    field("asleep_at_step", row.asleep_at_step);
    field("awake_at_end", row.awake_at_end);
    field("moving_at_end", row.moving_at_end);
    field("top_m", row.top_m);
    field("tunnelled", row.tunnelled);
    field("rss_mib", row.rss_mib);
}

}  // namespace

std::optional<double> SpeedRow::error_m() const {
    if (!max_penetration_m) return std::nullopt;
    return std::max(*max_penetration_m, joint_drift_m.value_or(0));
}

nlohmann::ordered_json to_json(const SpeedRow& row) {
    nlohmann::ordered_json json;
    visit_identity(row, FieldWriter{json});
    write_parameters(json, row.parameters);
    if (!row.failed) visit_figures(row, FieldWriter{json});
    return json;
}

SpeedRow speed_row_from(const nlohmann::ordered_json& json) {
    SpeedRow row;
    visit_identity(row, FieldReader{json});
    row.parameters = read_parameters(json);
    if (!row.failed) visit_figures(row, FieldReader{json});
    return row;
}

}  // namespace jostle::bench
