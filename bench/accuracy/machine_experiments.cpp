// SPDX-License-Identifier: MIT
//
// J5 to J8: a motor with a slider, a motor with a limit, and chains hanging between two points.
#include <cmath>
#include <limits>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/reference.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

// --- J5 ---

// Crank of 0.2 m at 10 rad/s, rod of 0.6 m, a slider along x. The crank rotates from x towards z,
// about -y.
ExperimentRun slider_crank(double) {
    constexpr double crank_length = 0.2, rod_length = 0.6, rate = 10;
    constexpr Vec3 axis{0, -1, 0};
    Scene scene{.name = "j5", .gravity = {}, .planar = true};
    Body crank = without_shape(solid_box(1, {0.5 * crank_length, 0.02, 0.02}, {0.1, 0, 0}));
    Body rod = without_shape(solid_box(1, {0.5 * rod_length, 0.02, 0.02}, {0.5, 0, 0}));
    Body slider = without_shape(solid_box(1, {0.05, 0.05, 0.05}, {0.8, 0, 0}));
    crank.spin = axis * rate;
    crank.velocity = cross(crank.spin, crank.pose.position);
    const Vec3 pin{crank_length, 0, 0}, pin_velocity = cross(crank.spin, pin);
    rod.spin = axis * (-rate * crank_length / rod_length);
    rod.velocity = pin_velocity + cross(rod.spin, rod.pose.position - pin);
    scene.bodies = {crank, rod, slider};
    Joint driven = hinge_at(ground, 0, {}, axis);
    driven.motor = Motor{rate, 1e4};
    scene.joints = {driven,
                    hinge_at(0, 1, pin, axis),
                    hinge_at(1, 2, {0.8, 0, 0}, axis),
                    {.kind = JointKind::slider, .b = 2, .anchor = {0.8, 0, 0}, .axis = {1, 0, 0}}};
    const auto truth = [](double t) {
        const double angle = rate * t, up = crank_length * std::sin(angle);
        const double along = std::sqrt(rod_length * rod_length - up * up);
        return Vec3{crank_length * std::cos(angle) + along, 0, 0};
    };
    auto meter = track_meter(scene, 2, truth, crank_length, 1);
    return {std::move(scene), 3, std::move(meter)};
}

// --- J6 ---

class LimitMeter final : public Meter {
public:
    LimitMeter(double torque_over_inertia, double target, double limit)
        : acceleration_(torque_over_inertia),
          target_(target),
          limit_(limit),
          reached_at_(std::sqrt(2 * limit / torque_over_inertia)) {}

    void sample(double t, const Engine& engine) override {
        const BodyState now = engine.state(0);
        const double truth = t < reached_at_ ? std::min(target_, acceleration_ * t) : 0;
        const Vec3 z = rotate(now.rotation, {0, 0, 1});
        const double angle = std::atan2(z.x, z.z);
        errors_.primary = std::max(errors_.primary, std::abs(now.spin.y - truth) / target_);
        errors_.secondary = std::max(errors_.secondary, angle - limit_);
    }
    Errors errors() const override { return errors_; }

private:
    double acceleration_, target_, limit_, reached_at_;
    Errors errors_;
};

// The limit is reached before the motor reaches its speed.
ExperimentRun motor_and_limit(double) {
    Scene scene{.name = "j6", .gravity = {}, .planar = true};
    const Body rod = without_shape(solid_box(1, {0.05, 0.05, 0.5}, {0, 0, 0.5}));
    const double torque = 0.5, target = 2, limit = pi / 4;
    Joint joint = hinge_at(ground, 0, {});
    joint.motor = Motor{target, torque};
    joint.limit = Limit{-1, limit};
    scene.bodies = {rod};
    scene.joints = {joint};
    auto meter = std::make_unique<LimitMeter>(torque / (rod.inertia.y + 0.25), target, limit);
    return {std::move(scene), 3, std::move(meter)};
}

// --- J7 and J8 ---

class SagMeter final : public Meter {
public:
    SagMeter(const Scene& scene, Joint lowest, double sag, double gap_length)
        : gaps_(scene),
          body_(lowest.a),
          local_(apply_inverse(pose_of(scene, lowest.a), lowest.anchor)),
          sag_(sag),
          gap_length_(gap_length) {}

    void sample(double, const Engine& engine) override {
        const BodyState now = engine.state(body_);
        const double found = -(now.position + rotate(now.rotation, local_)).z;
        error_ = std::abs(found - sag_) / sag_;
        gaps_.sample(engine);
    }
    Errors errors() const override { return {error_, gaps_.most() / gap_length_}; }

private:
    GapMeter gaps_;
    int body_;
    Vec3 local_;
    double sag_, gap_length_, error_ = 0;
};

struct Hanging {
    const char* name;
    int links;
    double length, span, seconds, damping_ends;
    double mass;
    Vec3 half_extents;  // a link along x
    JointKind joint;
};

// Starts from a V shape, damped until it rests. The slowest mode of such a chain has about 3 rad/s,
// so twice as much is critical damping.
ExperimentRun hanging(const Hanging& description) {
    Scene scene{.name = description.name, .damping = 6};
    const double half_length = 0.5 * description.length * description.links;
    const double along = 0.5 * description.span / half_length;  // cosine of the legs' slope
    const double down = std::sqrt(1 - along * along);
    Vec3 from;
    for (int k = 0; k < description.links; k++) {
        const bool first_leg = k < description.links / 2;
        const Vec3 direction{along, 0, first_leg ? -down : down};
        const double angle = std::atan2(first_leg ? down : -down, along);
        Body link = without_shape(solid_box(description.mass, description.half_extents,
                                            from + direction * (0.5 * description.length)));
        link.pose.rotation = physics::from_axis_angle({0, 1, 0}, angle);
        scene.bodies.push_back(std::move(link));
        scene.joints.push_back({.kind = description.joint, .a = k - 1, .b = k, .anchor = from});
        from += direction * description.length;
    }
    Joint end{.kind = description.joint, .a = ground, .b = description.links - 1, .anchor = from};
    scene.joints.push_back(end);
    const Joint lowest{
        .a = description.links / 2 - 1,
        .anchor = scene.joints[static_cast<std::size_t>(description.links) / 2].anchor};
    auto meter = std::make_unique<SagMeter>(
        scene, lowest, catenary_sag(description.links, description.length, description.span),
        description.length);
    return {std::move(scene), description.seconds, std::move(meter), description.damping_ends};
}

}  // namespace

std::vector<Experiment> machine_experiments() {
    const std::vector<double> tolerances = {0.01, 0.001, 1e-4};
    constexpr const char* sag = "relative error of the sag; widest joint gap / link length";
    return {
        {.name = "j5",
         .about = "a slider-crank at 10 rad/s for 3 s",
         .measures = "RMS position error of the slider / crank length; widest joint gap, m",
         .tolerances = tolerances,
         .start = slider_crank},
        {.name = "j6",
         .about = "a motor of 0.5 N m turns a rod against a limit",
         .measures = "largest error of the spin / 2 rad/s; largest overshoot, rad",
         .tolerances = tolerances,
         .start = motor_and_limit},
        {.name = "j7",
         .about = "a chain of 40 links settles between two points, then 1 s without damping",
         .measures = sag,
         .tolerances = tolerances,
         .max_hz = 480,
         .start =
             [](double) {
                 return hanging(
                     {"j7", 40, 0.1, 3.0, 21, 20, 0.05, {0.05, 0.01, 0.01}, JointKind::ball});
             },
         .short_max_hz = 120},
        {.name = "j8",
         .about = "a bridge of 20 planks settles between two points",
         .measures = sag,
         .tolerances = tolerances,
         .max_hz = 480,
         .start =
             [](double) {
                 return hanging(
                     {"j8", 20, 0.5, 9.8, 20, 0, 1, {0.25, 0.4, 0.04}, JointKind::hinge});
             },
         .short_max_hz = 120},
    };
}

}  // namespace jostle::bench::accuracy
