// SPDX-License-Identifier: MIT
#include "tools/sim/trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/analysis/work_error.h"

namespace jostle::sim {
namespace {

using analysis::Rms;
using analysis::thread_seconds;
using physics::BodyType;
using physics::Quat;
using physics::Vec3;

std::vector<physics::BodyId> dynamic_bodies(const scenes::BuiltScene& built) {
    std::vector<physics::BodyId> found;
    for (const physics::BodyId id : built.bodies)
        if (const auto body = built.world.body(id); body && body->type == BodyType::dynamic)
            found.push_back(id);
    return found;
}

// Angle of the rotation from one to the other, from its sine: rounding of the cosine hides angles
// below 1e-8.
double angle_between(Quat a, Quat b) {
    const Quat d = conjugate(a) * b;
    return 2 * std::atan2(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::abs(d.w));
}

struct DistanceSum {
    Rms position, angle;

    void add(const Trajectory& a, const Trajectory& b, std::size_t sample) {
        for (std::size_t k = sample * a.bodies; k < (sample + 1) * a.bodies; k++) {
            position.add(length_squared(a.at[k] - b.at[k]));
            const double turned = angle_between(a.rotations[k], b.rotations[k]);
            angle.add(turned * turned);
        }
    }
    Distance value() const { return {position.value(), angle.value()}; }
};

}  // namespace

physics::Result<Trajectory> simulate_trajectory(scenes::SceneDescription scene,
                                                const StepSettings& setting,
                                                const SampleTimes& samples) {
    scene.world.substeps = setting.substeps;
    scene.world.tolerance = 0;  // a tolerance would override the sub-steps
    scene.world.threads = 1;
    auto built = scenes::build_scene(scene);
    if (!built) return built.error();
    const std::vector<physics::BodyId> bodies = dynamic_bodies(*built);
    const long steps = std::lround(setting.hz / samples.hz);
    Trajectory trajectory{.bodies = bodies.size()};
    for (std::size_t sample = 0; sample < samples.count; sample++) {
        const double before = thread_seconds();
        for (long step = 0; step < steps; step++)
            if (const auto status = built->world.step(1 / setting.hz); !status) {
                trajectory.failure = status.error().message;
                return trajectory;
            }
        trajectory.cpu_seconds += thread_seconds() - before;
        for (const physics::BodyId id : bodies) {
            const auto body = built->world.body(id);
            if (!body) {
                trajectory.failure = "a body was removed";
                return trajectory;
            }
            trajectory.at.push_back(body->center);
            trajectory.rotations.push_back(body->pose.rotation);
        }
    }
    return trajectory;
}

// Directions distributed over the sphere by the golden angle, so that they differ for all bodies.
scenes::SceneDescription perturbed(scenes::SceneDescription scene, double speed) {
    constexpr double golden_angle = 2.399963229728653;
    for (std::size_t k = 0; k < scene.bodies.size(); k++) {
        physics::BodyDef& body = scene.bodies[k].body;
        if (body.type != BodyType::dynamic) continue;
        const double height = std::fmod(0.5 + 0.618033988749895 * static_cast<double>(k), 2.0) - 1;
        const double around = golden_angle * static_cast<double>(k);
        const double wide = std::sqrt(1 - height * height);
        body.linear_velocity +=
            Vec3{wide * std::cos(around), height, wide * std::sin(around)} * speed;
    }
    return scene;
}

double extent_of(const Trajectory& trajectory) {
    if (trajectory.at.empty()) return 0;
    Vec3 low = trajectory.at[0], high = low;
    for (const Vec3 p : trajectory.at)
        for (int k = 0; k < 3; k++) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    return length(high - low);
}

Distance distance_between(const Trajectory& a, const Trajectory& b) {
    DistanceSum sum;
    const std::size_t samples = std::min(a.samples(), b.samples());
    for (std::size_t sample = 0; sample < samples; sample++) sum.add(a, b, sample);
    return sum.value();
}

Distance distance_at(const Trajectory& a, const Trajectory& b, std::size_t sample) {
    DistanceSum sum;
    sum.add(a, b, sample);
    return sum.value();
}

}  // namespace jostle::sim
