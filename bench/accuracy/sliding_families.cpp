// SPDX-License-Identifier: MIT
//
// Families of one or two bodies that slide, roll or bounce.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/row_family.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;
using Scale = Parameter::Scale;

constexpr double degree = pi / 180;

Quat yawed(double angle) {
    return physics::from_axis_angle({0, 0, 1}, angle);
}

// The rotation that maps a cylinder's axis to z.
Quat upright() {
    return physics::from_axis_angle({1, 0, 0}, 0.5 * pi);
}

// A prism of seven corners, symmetric in y and z.
Body seven_sided_prism(double mass, Vec3 half_extents) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 7; k++) {
        const Vec3 corner = azimuth(2 * pi * k / 7);
        for (const double z : {-1.0, 1.0})
            corners.push_back(
                {half_extents.x * corner.x, half_extents.y * corner.y, half_extents.z * z});
    }
    return solid_hull(mass / solid_hull(1, corners).mass, corners);
}

// A body at rest on the plane z = 0, with its length along x. The width of a capsule and of a
// cylinder is that of the other shapes; a capsule lies.
Body resting_base(const std::string& shape, double mass, double length, double aspect,
                  double flatness) {
    const double width = length / aspect, height = flatness * width;
    const Vec3 half{0.5 * length, 0.5 * width, 0.5 * height};
    if (shape == "hull") {
        Body body = seven_sided_prism(mass, half);
        body.pose.position = {0, 0, half.z};
        return body;
    }
    if (shape == "cylinder") {
        Body body = solid_cylinder(mass, half.x, half.z, {0, 0, half.z});
        body.pose.rotation = upright();
        return body;
    }
    if (shape == "capsule") {
        Body body = solid_capsule(mass, half.z, half.x, {0, 0, half.z});
        body.pose.rotation = physics::from_axis_angle({0, 0, 1}, -0.5 * pi);
        return body;
    }
    return solid_box(mass, half, {0, 0, half.z});
}

Vec3 in_the_plane(Vec3 v) {
    return {v.x, v.y, 0};
}

// Displacement of a body that slides with a uniform slip velocity u along its heading until it
// stops: u' = -mu g u / |u|.
Vec3 stopped_after(Vec3 slip, double friction) {
    return slip * (length(slip) / (2 * friction * g));
}

// Displacement of a lying capsule, and its velocity then. Friction also rotates it about its axis,
// so that the slip across the axis ends (1 + m r^2 / I) times as fast; it rolls on.
struct Thrown {
    Vec3 displacement, velocity;
};
Thrown capsule_thrown(Vec3 velocity, Vec3 axis, double ratio, double friction, double seconds) {
    constexpr double h = 2e-5;  // s
    const Vec3 across = cross({0, 0, 1}, axis);
    double along_slip = dot(velocity, axis), across_slip = dot(velocity, across);
    double along_speed = along_slip, across_speed = across_slip, along = 0, aside = 0;
    for (double t = 0; t < seconds; t += h) {
        const double slip = std::hypot(along_slip, across_slip);
        const double loss = friction * g * h;
        double next_along = along_speed, next_across = across_speed;
        if (slip > loss * (1 + ratio)) {
            next_along -= loss * along_slip / slip, along_slip -= loss * along_slip / slip;
            next_across -= loss * across_slip / slip;
            across_slip -= loss * (1 + ratio) * across_slip / slip;
        } else {
            next_along = 0;
            next_across -= across_slip / (1 + ratio);
            along_slip = across_slip = 0;
        }
        along += 0.5 * h * (along_speed + next_along), along_speed = next_along;
        aside += 0.5 * h * (across_speed + next_across), across_speed = next_across;
    }
    return {axis * along + across * aside, axis * along_speed + across * across_speed};
}

// Primary: distance from the true place at the end. Second: its component across the heading. Both
// relative to the path. The last step ends near `seconds`, where the true velocity is constant.
std::unique_ptr<Meter> landing_place_meter(Vec3 start, const Thrown& truth, double seconds,
                                           Vec3 forward, double path) {
    return last_meter([=](double t, const Engine& engine) {
        const Vec3 error = in_the_plane(engine.state(0).position - start) - truth.displacement -
                           truth.velocity * (t - seconds);
        return Errors{length(error) / path, std::abs(dot(error, cross({0, 0, 1}, forward))) / path};
    });
}

// Sinks the body into the floor by an overlap.
ExperimentRun thrown_flat(const Values& v, const std::string& shape, double overlap) {
    const double friction = v["friction"], speed = v["speed"];
    const Vec3 forward = azimuth(v["heading"] * degree);
    Scene scene{.name = "slide", .friction = friction};
    Body body = resting_base(shape, v["mass"], v["length"], v["aspect"], v["flatness"]);
    const Quat turned = yawed((v["heading"] + v["yaw"]) * degree);
    body.pose.rotation = turned * body.pose.rotation;
    body.pose.position.z -= overlap;
    body.velocity = forward * speed;
    const double seconds = speed / (friction * g) + 0.3;
    Thrown truth{stopped_after(body.velocity, friction), {}};
    if (shape == "capsule") {
        const auto& capsule = std::get<physics::Capsule>(*body.shape);
        const double ratio = body.mass * capsule.radius * capsule.radius / body.inertia.y;
        truth = capsule_thrown(body.velocity, rotate(turned, {1, 0, 0}), ratio, friction, seconds);
    }
    const Vec3 start = body.pose.position;
    scene.bodies = {std::move(body), fixed_plane()};
    return {std::move(scene), seconds,
            landing_place_meter(start, truth, seconds, forward, length(truth.displacement))};
}

// A plank is thrown across a moving floor: it slides straight in the frame of the floor.
ExperimentRun thrown_on_a_belt(const Values& v) {
    const double friction = v["friction"];
    const Vec3 forward = azimuth(v["heading"] * degree), belt{v["belt"], 0, 0};
    Scene scene{.name = "belt", .friction = friction};
    Body body = resting_base("box", 1, 0.9, v["aspect"], 0.4);
    body.pose.rotation = yawed(v["yaw"] * degree);
    body.velocity = forward * v["speed"];
    Body floor = fixed_box({100, 50, 0.5}, {0, 0, -0.5});
    floor.motion = Motion::kinematic;
    floor.velocity = belt;
    const Vec3 slip = body.velocity - belt;
    const double seconds = length(slip) / (friction * g) + 0.3;
    const Vec3 slid = stopped_after(slip, friction);
    const Vec3 start = body.pose.position;
    scene.bodies = {std::move(body), std::move(floor)};
    return {std::move(scene), seconds,
            landing_place_meter(start, {belt * seconds + slid, belt}, seconds, normalized(slip),
                                length(slid))};
}

// Gravity is tilted; the axis of the body is horizontal.
ExperimentRun rolled_down(const Values& v) {
    const double radius = v["radius"], slope = v["slope"] * degree, seconds = 2;
    const double half_length = radius * v["aspect"], mass = 1;
    const Vec3 forward = azimuth(v["heading"] * degree);
    Scene scene{.name = "roll", .friction = 0.8};
    scene.gravity = forward * (g * std::sin(slope)) - Vec3{0, 0, g * std::cos(slope)};
    const Vec3 at{0, 0, radius};
    Body body = v.choice("shape") == "cylinder"  ? solid_cylinder(mass, radius, half_length, at)
                : v.choice("shape") == "capsule" ? solid_capsule(mass, radius, half_length, at)
                                                 : solid_sphere(mass, radius, at);
    body.pose.rotation = yawed(v["heading"] * degree);
    body.velocity = forward * v["speed"];
    body.spin = cross({0, 0, 1}, forward) * (v["speed"] / radius);
    const double ratio = body.inertia.y / (mass * radius * radius);
    const double travelled =
        v["speed"] * seconds + 0.5 * g * std::sin(slope) / (1 + ratio) * seconds * seconds;
    scene.bodies = {std::move(body), fixed_plane()};
    return {std::move(scene), seconds,
            landing_place_meter(at, {forward * travelled, {}}, seconds, forward, travelled)};
}

// A ball is thrown, lands without bouncing, slides and rolls. Friction acts along one line, so the
// angular momentum about that line on the ground is constant from the start.
ExperimentRun landed(const Values& v, double shift) {
    const double radius = 0.1, speed = v["speed"], friction = v["friction"];
    const double surface =
        v["spin"] * speed;  // m/s of the surface by the spin; < 1: slides forward
    const Vec3 forward = azimuth(v["heading"] * degree);
    Scene scene{.name = "land", .friction = friction};
    const double fall = std::sqrt(2 * v["height"] / g) - shift;  // s until it lands
    Body ball = solid_sphere(1, radius, {});
    ball.pose.position =
        forward * (speed * shift) + Vec3{0, 0, radius + v["height"] - 0.5 * g * shift * shift};
    ball.velocity = forward * speed - Vec3{0, 0, g * shift};
    ball.spin = cross({0, 0, 1}, forward) * (surface / radius);
    const double rolling = (5 * speed + 2 * surface) / 7;
    // The impact changes the slip by at most 7/2 of the friction impulse per mass.
    const double slip = speed - surface, sign = slip < 0 ? -1 : 1;
    const double jump =
        std::min(friction * g * (fall + shift), std::abs(slip) * 2 / 7);  // of the velocity
    const double after = speed - sign * jump, slip_after = std::abs(slip) - 3.5 * jump;
    const double sliding = slip_after / (3.5 * friction * g);
    const double seconds = fall + sliding + 0.5;
    const double path = speed * fall + 0.5 * (after + rolling) * sliding + rolling * 0.5;
    const Vec3 start = in_the_plane(ball.pose.position);
    scene.bodies = {ball, fixed_plane()};
    auto meter = last_meter([=](double t, const Engine& engine) {
        const BodyState now = engine.state(0);
        const double truth = path + rolling * (t - seconds);
        return Errors{length(in_the_plane(now.position) - start - forward * truth) / path,
                      length(in_the_plane(now.velocity) - forward * rolling) / speed};
    });
    return {std::move(scene), seconds, std::move(meter)};
}

// A spinning ball hits a plane obliquely, without gravity. The impulse along the plane is limited
// by friction and stops the slip at most.
ExperimentRun bounced(const Values& v, double shift) {
    const double radius = 0.1, speed = v["speed"], friction = v["friction"];
    const double angle = v["angle"] * degree, restitution = v["restitution"];
    const Vec3 forward = azimuth(v["heading"] * degree), up{0, 0, 1};
    Scene scene{.name = "bounce", .gravity = {}, .friction = friction, .restitution = restitution};
    Body ball = solid_sphere(1, radius, {});
    ball.velocity = (forward * std::cos(angle) - up * std::sin(angle)) * speed;
    ball.pose.position = up * radius - ball.velocity * (0.4 - shift);
    ball.spin = azimuth(v["spin_heading"] * degree) * (v["spin"] * speed / radius);
    const double down = speed * std::sin(angle);
    const Vec3 slip = in_the_plane(ball.velocity) + cross(ball.spin, up * -radius);
    const double impulse = std::min(friction * (1 + restitution) * down, length(slip) * 2 / 7);
    const Vec3 kick = length(slip) > 0 ? slip * (-impulse / length(slip)) : Vec3{};
    const Vec3 velocity = in_the_plane(ball.velocity) + kick + up * (restitution * down);
    const Vec3 spin = ball.spin + cross(up * -radius, kick) * (1 / (0.4 * radius * radius));
    scene.bodies = {ball, fixed_plane()};
    auto meter = last_meter([=](double, const Engine& engine) {
        const BodyState now = engine.state(0);
        return Errors{length(now.velocity - velocity) / speed,
                      length(now.spin - spin) * radius / speed};
    });
    return {std::move(scene), 0.8, std::move(meter)};
}

// A ball hits another one: an impulse along the line of centres.
ExperimentRun shot(const Values& v, double shift) {
    const double radius = 0.1, speed = v["speed"], mass = v["ratio"];
    const double restitution = v["restitution"];
    const Vec3 forward = azimuth(v["heading"] * degree);
    const Vec3 aside = azimuth((v["heading"] + 90) * degree);
    Scene scene{.name = "shot", .gravity = {}, .restitution = restitution};
    const double offset = 2 * radius * v["offset"];
    const double gap = std::sqrt(4 * radius * radius - offset * offset);
    Body a = solid_sphere(1, radius, forward * (-gap - speed * (0.4 - shift)));
    a.velocity = forward * speed;
    scene.bodies = {a, solid_sphere(mass, radius, aside * offset)};
    const Vec3 normal = (forward * gap + aside * offset) * (1 / (2 * radius));
    const double impulse = (1 + restitution) * dot(a.velocity, normal) * mass / (1 + mass);
    const Vec3 of_a = a.velocity - normal * impulse, of_b = normal * (impulse / mass);
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 va = engine.state(0).velocity, vb = engine.state(1).velocity;
        return Errors{(length(va - of_a) + mass * length(vb - of_b)) / speed,
                      length(va + vb * mass - a.velocity) / speed};
    });
    return {std::move(scene), 0.8, std::move(meter)};
}

const Parameter heading_range{"heading, deg", 0, 360};
const Parameter yaw_range{"yaw, deg", 0, 180};

RowFamily slide_family() {
    return {.name = "slide",
            .about = "a body is thrown flat and slides until it stops",
            .measures = "position error at the end / path; the same across the heading",
            .tolerances = {0.02, 0.002, 2e-4},
            .parameters = {{.name = "shape", .choices = {"box", "hull", "cylinder", "capsule"}},
                           yaw_range,
                           heading_range,
                           {"length, m", 0.2, 2, Scale::logarithmic},
                           {"aspect", 1, 6},
                           {"flatness", 0.2, 0.7},
                           {"friction", 0.2, 0.8},
                           {"speed, m/s", 2, 8},
                           {"mass, kg", 0.1, 1000, Scale::logarithmic}},
            // A plank of 0.9 x 0.3 x 0.2 m.
            .examples = {{0, 45, 30, 0.9, 3, 0.667, 0.4, 5, 1}},
            .drawn = 11,
            .limit = 0.02,
            .second_limit = 1e-3,
            .start = [](const Values& v, double) { return thrown_flat(v, v.choice("shape"), 0); }};
}

RowFamily overlap_family() {
    return {.name = "overlap",
            .about = "a body that starts inside the floor slides until it stops",
            .measures = "position error at the end / path; the same across the heading",
            .tolerances = {0.02, 0.002, 2e-4},
            .parameters = {{.name = "shape", .choices = {"box", "hull", "cylinder"}},
                           {"overlap, mm", 0.5, 10, Scale::logarithmic},
                           yaw_range,
                           heading_range,
                           {"length, m", 0.3, 1.5, Scale::logarithmic},
                           {"aspect", 1, 4},
                           {"flatness", 0.3, 0.7},
                           {"friction", 0.2, 0.6},
                           {"speed, m/s", 3, 8},
                           {"mass, kg", 0.1, 1000, Scale::logarithmic}},
            .examples = {{0, 6, 20, 30, 0.6, 1, 0.5, 0.25, 4, 1}},
            .drawn = 5,
            .limit = 0.02,
            .limit_from_hz = 30,
            .start = [](const Values& v, double) {
                return thrown_flat(v, v.choice("shape"), 1e-3 * v["overlap"]);
            }};
}

RowFamily belt_family() {
    return {.name = "belt",
            .about = "a plank is thrown across a moving floor",
            .measures = "position error at the end / path on the floor; the same across the slip",
            .tolerances = {0.02, 0.002, 2e-4},
            .parameters = {yaw_range,
                           heading_range,
                           {"aspect", 1, 5},
                           {"belt, m/s", 0.5, 4},
                           {"friction", 0.2, 0.7},
                           {"speed, m/s", 2, 6}},
            .limit = 0.02,
            .second_limit = 1e-3,
            .start = [](const Values& v, double) { return thrown_on_a_belt(v); }};
}

RowFamily roll_family() {
    return {.name = "roll",
            .about = "a round body rolls down a slope for 2 s",
            .measures = "position error at the end / path; the same across the heading",
            // Contacts at rest are 0.05 mm deep, which shortens the lever of friction: 1e-4.
            .tolerances = {0.02, 0.002},
            .parameters = {{.name = "shape", .choices = {"cylinder", "capsule", "sphere"}},
                           heading_range,
                           {"radius, m", 0.05, 0.5, Scale::logarithmic},
                           {"aspect", 0.2, 4, Scale::logarithmic},
                           {"slope, deg", 2, 20},
                           {"speed, m/s", 0, 4}},
            .drawn = 6,
            .limit = 0.02,
            .second_limit = 1e-3,
            .start = [](const Values& v, double) { return rolled_down(v); }};
}

RowFamily land_family() {
    return {.name = "land",
            .about = "a spinning ball is thrown, lands, slides and rolls",
            .measures = "position error at the end / path; relative error of the velocity",
            .tolerances = {0.02, 0.002},
            .parameters = {heading_range,
                           {"height, m", 0.05, 2, Scale::logarithmic},
                           {"speed, m/s", 1, 6},
                           {"spin", -0.5, 2.5},
                           {"friction", 0.1, 0.6}},
            .drawn = 5,
            .limit = 0.02,
            .phases = 16,
            .start = landed};
}

RowFamily bounce_family() {
    return {.name = "bounce",
            .about = "a spinning ball bounces obliquely off a plane",
            .measures = "relative errors of the velocity; of the spin",
            .tolerances = {0.02, 0.002, 2e-4},
            .parameters = {heading_range,
                           {"angle, deg", 10, 80},
                           {"speed, m/s", 1, 20, Scale::logarithmic},
                           {"spin_heading, deg", 0, 360},
                           {"spin", 0, 2},
                           {"friction", 0.05, 0.8},
                           {"restitution", 0, 0.95}},
            .drawn = 6,
            .limit = 0.02,
            .second_limit = 0.02,
            .phases = 16,
            .start = bounced};
}

RowFamily shot_family() {
    return {.name = "shot",
            .about = "a ball hits another one off-centre",
            .measures = "relative error of the momenta; of their sum",
            .tolerances = {0.05, 0.01, 0.002},
            .parameters = {heading_range,
                           {"offset", 0, 0.95},
                           {"speed, m/s", 1, 20, Scale::logarithmic},
                           {"ratio", 0.05, 20, Scale::logarithmic},
                           {"restitution", 0, 1}},
            .limit = 0.05,
            .phases = 16,
            .start = shot};
}

}  // namespace

std::vector<RowFamily> sliding_families() {
    return {slide_family(), overlap_family(), belt_family(), roll_family(),
            land_family(),  bounce_family(),  shot_family()};
}

}  // namespace jostle::bench::accuracy
