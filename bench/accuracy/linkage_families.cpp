// SPDX-License-Identifier: MIT
//
// Families of joints: pendulums, limits, chains, a closed loop in space, ropes over pulleys, racks,
// beads on wires, and limbs that hit the ground.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/reference.h"
#include "bench/accuracy/row_family.h"
#include "jostle/base/check.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;
using Scale = Parameter::Scale;

// A body without collision whose x axis is along a line between two points.
Body strut(double mass, Vec3 from, Vec3 to, double half_thickness) {
    const Vec3 along = to - from;
    Body body = without_shape(
        solid_box(mass, {0.5 * length(along), half_thickness, half_thickness}, (from + to) * 0.5));
    // axes_along maps z to the line; first x is mapped to z.
    body.pose.rotation =
        axes_along(normalized(along)) * physics::from_axis_angle({0, 1, 0}, -0.5 * pi);
    return body;
}

// Primary: largest deviation of the energy, relative to a scale in J. Second: widest joint gap,
// relative to a length.
class EnergyAndGapMeter final : public Meter {
public:
    EnergyAndGapMeter(const Scene& scene, double scale, double length)
        : scene_(scene), gaps_(scene), scale_(scale), length_(length) {
        for (const Body& body : scene.bodies)
            start_ += kinetic_energy(body, body.pose.rotation, body.velocity, body.spin) -
                      body.mass * dot(scene.gravity, body.pose.position);
    }
    void sample(double, const Engine& engine) override {
        drift_ = std::max(drift_, std::abs(energy(scene_, engine) - start_) / scale_);
        gaps_.sample(engine);
    }
    Errors errors() const override { return {drift_, gaps_.most() / length_}; }

private:
    Scene scene_;
    GapMeter gaps_;
    double start_ = 0, drift_ = 0, scale_, length_;
};

// A rod on a hinge whose axis is horizontal, released at rest. Lasts three periods of small swings.
ExperimentRun swing(const Values& v) {
    const double angle = v["angle"] * pi / 180, half = 0.5 * v["length"];
    const Vec3 forward = azimuth(v["heading"] * pi / 180), axis = cross({0, 0, 1}, forward);
    const auto hanging_at = [=](double theta) {
        return (forward * std::sin(theta) - Vec3{0, 0, std::cos(theta)}) * half;
    };
    Scene scene{.name = "swing"};
    Body rod = strut(1, {}, hanging_at(angle) * 2, half / v["slenderness"]);
    const double rate = std::sqrt(g * half / (rod.inertia.y + half * half));
    scene.bodies = {std::move(rod)};
    scene.joints = {hinge_at(ground, 0, {}, axis)};
    auto meter = track_meter(
        scene, 0, [=](double t) { return hanging_at(pendulum_angle(rate, angle, t)); }, 2 * half,
        2 * half);
    return {std::move(scene), 3 * 2 * pi / rate, std::move(meter)};
}

// Primary: the largest angle past the limit, or the distance from it at the end, rad. Second: the
// spin at the end relative to that of the start.
class StopMeter final : public Meter {
public:
    StopMeter(double limit, double sense, double spin)
        : limit_(limit), sense_(sense), spin_(spin) {}
    void sample(double, const Engine& engine) override {
        const BodyState now = engine.state(0);
        // About -y, from x towards z; continuous over any number of turns.
        const double here = sense_ * std::atan2(now.position.z, now.position.x);
        const double turns = std::round((angle_ - here) / (2 * pi));
        angle_ = here + 2 * pi * turns;
        overshoot_ = std::max(overshoot_, angle_ - limit_);
        last_spin_ = length(now.spin);
    }
    Errors errors() const override {
        return {std::max(overshoot_, std::abs(angle_ - limit_)), last_spin_ / spin_};
    }

private:
    double limit_, sense_, spin_, angle_ = 0, overshoot_ = 0, last_spin_ = 0;
};

// A rod rotates against the limit of its hinge, without gravity.
ExperimentRun stop_at_limit(const Values& v) {
    const double limit = v["limit"] * pi / 180, spin = v["spin"], length = v["length"];
    const double sense = v.choice("sense") == "left" ? 1 : -1;
    Scene scene{.name = "limit", .gravity = {}, .planar = true};
    Body rod = strut(1, {}, {length, 0, 0}, 0.05 * length);
    rod.spin = Vec3{0, -sense * spin, 0};
    rod.velocity = cross(rod.spin, rod.pose.position);
    scene.bodies = {std::move(rod)};
    Joint hinge = hinge_at(ground, 0, {}, {0, -1, 0});
    hinge.limit = sense > 0 ? Limit{0, limit} : Limit{-limit, 0};
    scene.joints = {hinge};
    return {std::move(scene), limit / spin + 0.5, std::make_unique<StopMeter>(limit, sense, spin)};
}

// Links of 0.2 m, released horizontal; the last one is heavier.
ExperimentRun loaded_links(const Values& v) {
    constexpr double link = 0.2;
    const int count = v.whole("links");
    const Vec3 forward = azimuth(v["heading"] * pi / 180);
    Scene scene{.name = "chain"};
    double scale = 0;
    for (int k = 0; k < count; k++) {
        const double mass = k == count - 1 ? 0.1 * v["ratio"] : 0.1;
        scene.bodies.push_back(strut(mass, forward * (link * k), forward * (link * (k + 1)), 0.02));
        scene.joints.push_back(ball_at(k - 1, k, forward * (link * k)));
        scale += mass * g * link * (k + 0.5);
    }
    auto meter = std::make_unique<EnergyAndGapMeter>(scene, scale, link);
    return {std::move(scene), 2, std::move(meter)};
}

// The frame of the next hinge of a link with twisted axes: Denavit and Hartenberg.
Transform next_hinge(const Transform& hinge, double angle, double length, double twist) {
    const Quat turned = hinge.rotation * physics::from_axis_angle({0, 0, 1}, angle);
    return {hinge.position + rotate(turned, {length, 0, 0}),
            turned * physics::from_axis_angle({1, 0, 0}, twist)};
}

// Bennett's linkage: four hinges in space whose axes are neither parallel nor concurrent. It moves
// although its rows outnumber its degrees of freedom.
ExperimentRun bennett(const Values& v) {
    const double twist = v["twist"] * pi / 180, ratio = v["ratio"], start = v["angle"] * pi / 180;
    const double other_twist = std::asin(ratio * std::sin(twist));
    const double other = 2 * std::atan2(-std::sin(0.5 * (twist + other_twist)) /
                                            std::sin(0.5 * (twist - other_twist)),
                                        std::tan(0.5 * start));
    const Quat tilt = physics::from_axis_angle({1, 0, 0}, v["tilt"] * pi / 180);
    Transform hinges[5] = {{{}, tilt}};
    const double lengths[] = {1, ratio, 1, ratio}, angles[] = {start, other, -start, -other};
    const double twists[] = {twist, other_twist, twist, other_twist};
    for (int k = 0; k < 4; k++)
        hinges[k + 1] = next_hinge(hinges[k], angles[k], lengths[k], twists[k]);
    ASSERT(length(hinges[4].position) < 1e-9);
    // The last link is fixed.
    Scene scene{.name = "bennett"};
    for (int k = 0; k < 3; k++)
        scene.bodies.push_back(strut(lengths[k], hinges[k].position, hinges[k + 1].position, 0.03));
    for (int k = 0; k < 4; k++)
        scene.joints.push_back(hinge_at(k == 0 ? ground : k - 1, k == 3 ? ground : k,
                                        hinges[k].position, rotate(hinges[k].rotation, {0, 0, 1})));
    // The ground is always the first end.
    std::swap(scene.joints[3].a, scene.joints[3].b);
    auto meter = std::make_unique<EnergyAndGapMeter>(scene, (2 + ratio) * g, 1);
    return {std::move(scene), 3, std::move(meter)};
}

Joint of_jostle_only(int a, int b, physics::JointKind kind, Transform frame_a, Transform frame_b) {
    return {.a = a, .b = b, .other = OtherJoint{std::move(kind), frame_a, frame_b}};
}

// Two weights on a rope over two pulleys 20 m above: z_a + ratio z_b is constant.
ExperimentRun atwood(const Values& v) {
    const double ratio = v["ratio"], mass = v["mass"], seconds = 1, height = 20;
    const Vec3 a{-1, 0, 0}, b{1, 0, 0}, up{0, 0, height};
    Scene scene{.name = "pulley"};
    scene.bodies = {without_shape(solid_sphere(1, 0.1, a)),
                    without_shape(solid_sphere(mass, 0.1, b))};
    scene.joints = {of_jostle_only(
        0, 1,
        physics::PulleyJoint{
            .point_a = a + up, .point_b = b + up, .length = height * (1 + ratio), .ratio = ratio},
        {}, {})};
    const double tension = g * (1 + ratio) / (1 + ratio * ratio / mass);
    const double of_a = tension - g, of_b = ratio * tension / mass - g;  // m/s^2
    const double travel = 0.5 * seconds * seconds * std::max(std::abs(of_a), std::abs(of_b));
    auto meter = last_meter([=](double t, const Engine& engine) {
        const Vec3 error_a = engine.state(0).position - a - Vec3{0, 0, 0.5 * of_a * t * t};
        const Vec3 error_b = engine.state(1).position - b - Vec3{0, 0, 0.5 * of_b * t * t};
        return Errors{std::max(length(error_a), length(error_b)) / travel,
                      std::abs(error_a.z + ratio * error_b.z)};
    });
    return {std::move(scene), seconds, std::move(meter)};
}

// A rack falls and spins its pinion.
ExperimentRun rack(const Values& v) {
    const double radius = v["radius"], mass = v["mass"], seconds = 1;
    Scene scene{.name = "rack"};
    Body pinion = without_shape(solid_cylinder(1, radius, 0.05, {}));
    Body bar = without_shape(solid_box(mass, {0.05, 0.05, 0.5}, {radius, 0, 0}));
    const double acceleration = g * mass / (mass + pinion.inertia.y / (radius * radius));
    const double travel = 0.5 * acceleration * seconds * seconds;
    const Vec3 start = bar.pose.position;
    scene.bodies = {std::move(pinion), std::move(bar)};
    const Quat along_y = axes_along({0, 1, 0});
    scene.joints = {hinge_at(ground, 0, {}),
                    {.kind = JointKind::slider, .b = 1, .anchor = start, .axis = {0, 0, 1}},
                    of_jostle_only(0, 1, physics::RackJoint{radius}, {{}, along_y}, {{}, {}})};
    auto meter = last_meter([=](double t, const Engine& engine) {
        const Vec3 truth = start - Vec3{0, 0, 0.5 * acceleration * t * t};
        const double rim = length(engine.state(0).spin) * radius;
        return Errors{length(engine.state(1).position - truth) / travel,
                      std::abs(rim - acceleration * t)};
    });
    return {std::move(scene), seconds, std::move(meter)};
}

// A bead on a circular wire of 256 points in a vertical plane: a pendulum without rotation.
ExperimentRun bead(const Values& v) {
    const double radius = v["radius"], angle = v["angle"] * pi / 180, rate = std::sqrt(g / radius);
    const auto on_wire = [=](double theta) {
        return Vec3{std::sin(theta), 0, -std::cos(theta)} * radius;
    };
    physics::PathJoint path{.closed = true};
    path.points.clear();
    constexpr int points = 256;
    for (int k = 0; k < points; k++) path.points.push_back(on_wire(2 * pi * k / points));
    Scene scene{.name = "bead"};
    scene.bodies = {without_shape(solid_sphere(1, 0.05, on_wire(angle)))};
    scene.joints = {of_jostle_only(ground, 0, std::move(path), {}, {})};
    const double seconds = 2 * 2 * pi / rate;
    Rms distance;
    auto meter = track_meter(
        scene, 0, [=](double t) { return on_wire(pendulum_angle(rate, angle, t)); }, radius, 1);
    return {std::move(scene), seconds, std::move(meter)};
}

// Primary: largest angle past the limits of a cone-twist joint, rad. Second: widest joint gap, m.
class LimbMeter final : public Meter {
public:
    explicit LimbMeter(const Scene& scene) : joints_(scene.joints) {}

    void sample(double, const Engine& engine) override {
        for (const Joint& joint : joints_) {
            const auto& kind = std::get<physics::ConeTwistJoint>(joint.other->kind);
            const BodyState a = engine.state(joint.a), b = engine.state(joint.b);
            const Quat frame_a = a.rotation * joint.other->frame_a.rotation;
            Quat turned = conjugate(frame_a) * (b.rotation * joint.other->frame_b.rotation);
            if (turned.w < 0) turned = {-turned.x, -turned.y, -turned.z, -turned.w};
            const double twist = 2 * std::atan2(turned.x, turned.w);
            const double swing =
                2 * std::atan2(std::hypot(turned.y, turned.z), std::hypot(turned.x, turned.w));
            most_.primary =
                std::max({most_.primary, swing - kind.swing, std::abs(twist) - kind.twist.upper});
            const Vec3 gap = a.position + rotate(a.rotation, joint.other->frame_a.position) -
                             b.position - rotate(b.rotation, joint.other->frame_b.position);
            most_.secondary = std::max(most_.secondary, length(gap));
        }
    }
    Errors errors() const override { return most_; }

private:
    std::vector<Joint> joints_;
    Errors most_;
};

// A trunk with two limbs of two capsules each is thrown to the ground. Limbs are along x.
ExperimentRun limbs(const Values& v) {
    const double direction = v["heading"] * pi / 180, slope = v["slope"] * pi / 180;
    const double swing = v["swing"] * pi / 180, twist = v["twist"] * pi / 180;
    Scene scene{.name = "limbs", .friction = 0.5};
    const Quat turned =
        physics::from_axis_angle({0, 0, 1}, v["yaw"] * pi / 180) *
        physics::from_axis_angle(azimuth(v["tilt_heading"] * pi / 180), v["tilt"] * pi / 180);
    const Vec3 centre{0, 0, 1.6};
    const auto add = [&](Body body, Vec3 at, Quat own) {
        body.pose = {centre + rotate(turned, at), turned * own};
        body.velocity =
            (azimuth(direction) * std::cos(slope) - Vec3{0, 0, std::sin(slope)}) * v["speed"];
        scene.bodies.push_back(std::move(body));
    };
    add(solid_box(20, {0.2, 0.12, 0.3}, {}), {}, {});
    const Quat lying = physics::from_axis_angle({0, 0, 1}, -0.5 * pi);  // y to x
    constexpr double half = 0.15, radius = 0.05, reach = half + radius;
    for (const double side : {-1.0, 1.0}) {
        int parent = 0;
        double anchor = 0.2;  // m from the centre of the trunk
        for (int k = 0; k < 2; k++) {
            const int child = static_cast<int>(scene.bodies.size());
            add(solid_capsule(3, radius, half, {}), {side * (anchor + reach), 0, 0}, lying);
            // The x axis of the joint points outwards.
            const Quat outwards = side > 0 ? Quat{} : physics::from_axis_angle({0, 0, 1}, pi);
            const Vec3 in_parent = k == 0 ? Vec3{side * anchor, 0, 0} : Vec3{0, side * reach, 0};
            scene.joints.push_back(of_jostle_only(
                parent, child,
                physics::ConeTwistJoint{.swing = swing, .twist = {true, -twist, twist}},
                {in_parent, k == 0 ? outwards : conjugate(lying) * outwards},
                {{0, -side * reach, 0}, conjugate(lying) * outwards}));
            parent = child;
            anchor += 2 * reach;
        }
    }
    scene.bodies.push_back(fixed_plane());
    auto meter = std::make_unique<LimbMeter>(scene);
    return {std::move(scene), 1.5, std::move(meter)};
}

}  // namespace

std::vector<RowFamily> linkage_families() {
    const Parameter any_heading{"heading, deg", 0, 360};
    return {
        {.name = "swing",
         .about = "a rod on a hinge, released at rest, three periods",
         .measures = "RMS position error / length; widest joint gap / length",
         .tolerances = {0.01, 0.001, 1e-5},
         .parameters = {{"angle, deg", 5, 175},
                        {"length, m", 0.2, 5, Scale::logarithmic},
                        {"slenderness", 3, 50, Scale::logarithmic},
                        any_heading},
         .examples = {{163, 1, 10, 0}},
         .drawn = 5,
         .short_max_hz = 480,
         .start = [](const Values& v, double) { return swing(v); }},
        {.name = "limit",
         .about = "a rod rotates against the limit of its hinge",
         .measures = "angle past the limit, or off it at the end, rad; spin at the end / start",
         .tolerances = {0.1, 0.01, 0.001},
         .parameters = {{"limit, deg", 20, 180},
                        {"spin, rad/s", 1, 20, Scale::logarithmic},
                        {"length, m", 0.2, 2},
                        {.name = "sense", .choices = {"left", "right"}}},
         .examples = {{180, 6, 1, 0}},
         .drawn = 5,
         .limit = 0.02,
         .start = [](const Values& v, double) { return stop_at_limit(v); }},
        {.name = "chain",
         .about = "a chain with a heavy end, released horizontal, 2 s",
         .measures = "largest drift of the energy / depth of the fall; widest gap / link length",
         .tolerances = {0.1, 0.01, 0.001},
         .parameters = {{"links", 2, 30, Scale::whole},
                        {"ratio", 1, 1000, Scale::logarithmic},
                        any_heading},
         .examples = {{20, 1000, 30}},
         .drawn = 5,
         .limit = 0.1,
         .second_limit = 0.01,
         .short_max_hz = 120,
         .start = [](const Values& v, double) { return loaded_links(v); }},
        {.name = "bennett",
         .about = "Bennett's linkage of four hinges in space, released at rest, 3 s",
         .measures = "largest drift of the energy / weight times length; widest gap, m",
         .tolerances = {0.01, 0.001, 1e-4},
         .parameters = {{"twist, deg", 30, 75},
                        {"ratio", 0.4, 0.95},
                        {"angle, deg", 40, 140},
                        {"tilt, deg", 30, 150}},
         .limit = 0.01,
         .second_limit = 0.001,
         .start = [](const Values& v, double) { return bennett(v); }},
        {.name = "pulley",
         .about = "two weights on a rope over pulleys, 1 s",
         .measures = "largest position error at the end / travel; error of the length, m",
         .tolerances = {0.01, 0.001, 1e-5},
         .parameters = {{"mass, kg", 0.1, 10, Scale::logarithmic},
                        {"ratio", 0.5, 3, Scale::logarithmic}},
         .drawn = 3,
         .limit = 0.01,
         .start = [](const Values& v, double) { return atwood(v); }},
        {.name = "rack",
         .about = "a rack falls and spins its pinion, 1 s",
         .measures = "position error at the end / travel; slip at the end, m/s",
         .tolerances = {0.01, 0.001, 1e-5},
         .parameters = {{"radius, m", 0.05, 1, Scale::logarithmic},
                        {"mass, kg", 0.1, 10, Scale::logarithmic}},
         .drawn = 3,
         .limit = 0.01,
         .start = [](const Values& v, double) { return rack(v); }},
        {.name = "bead",
         .about = "a bead on a circular wire, released at rest, two periods",
         .measures = "RMS position error / radius; none",
         .tolerances = {0.01, 0.001, 1e-4},
         .parameters = {{"radius, m", 0.2, 5, Scale::logarithmic}, {"angle, deg", 5, 170}},
         .drawn = 3,
         .limit = 0.1,
         .short_max_hz = 120,
         .start = [](const Values& v, double) { return bead(v); }},
        {.name = "limbs",
         .about = "a trunk with jointed limbs is thrown to the ground",
         .measures = "largest angle past a limit, rad; widest joint gap, m",
         .tolerances = {0.1, 0.02},
         .parameters = {{"speed, m/s", 5, 10},
                        {"slope, deg", 10, 90},
                        any_heading,
                        {"yaw, deg", 0, 360},
                        {"tilt, deg", 0, 180},
                        {"tilt_heading, deg", 0, 360},
                        {"swing, deg", 20, 60},
                        {"twist, deg", 10, 45}},
         .drawn = 6,
         .limit = 0.0175,
         .second_limit = 0.005,
         .start = [](const Values& v, double) { return limbs(v); }},
    };
}

}  // namespace jostle::bench::accuracy
