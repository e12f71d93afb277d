// SPDX-License-Identifier: MIT
#include "clients/bot/behaviour.h"

#include <algorithm>
#include <cmath>

namespace jostle::bot {
namespace {

constexpr double yard = 9;    // m; area of bots, half the edge length
constexpr double range = 40;  // m from the centre; area of bots that drive
constexpr double pi = 3.14159265358979;
constexpr double forever = 1e18;  // s
// Of racing bots: steering angle at full lock (rad) and distance between the axles (m), both
// approximate, and the distance from its circle (m) at which a car drives straight back.
constexpr double full_lock = 0.6, wheel_base = 2.7, course_correction_m = 10;

// An axis of Controls (jostle/physics/module.h) in thousandths.
std::int32_t axis(double value) {
    return static_cast<std::int32_t>(std::lround(1000 * std::clamp(value, -1.0, 1.0)));
}

void set(v1::Vec3& v, double x, double y, double z) {
    v.set_x(x);
    v.set_y(y);
    v.set_z(z);
}

}  // namespace

Behaviour::Behaviour(const ScriptLine& line, std::uint32_t seed)
    : line_(line), state_(seed * 2654435761u + 12345u) {
    site_ = {random(-yard, yard), random(-yard, yard)};
    static constexpr std::uint32_t colors[] = {0xff595e, 0xffca3a, 0x8ac926, 0x1982c4, 0x6a4c93};
    color_ = colors[seed % 5];
    // Bots start at different times.
    if (line_.values.contains("period")) next_ = random(0, value("period"));
}

double Behaviour::random(double low, double high) {
    state_ = state_ * 1664525u + 1013904223u;
    return low + (high - low) * (state_ >> 8) / 16777216.0;
}

std::vector<std::uint32_t> Behaviour::owned(const client::WorldView& world,
                                            std::uint32_t client_id) const {
    std::vector<std::uint32_t> mine;
    for (const auto& [id, entity] : world.entities())
        if (entity.owner() == client_id) mine.push_back(id);
    return mine;
}

std::uint32_t Behaviour::random_entity(const client::WorldView& world, std::uint32_t client_id) {
    std::vector<std::uint32_t> others;
    for (const auto& [id, entity] : world.entities())
        // Entities spawned by players are excluded: their owner may delete them before this input
        // arrives.
        if (entity.mass() > 0 && entity.owner() == 0 && entity.owner() != client_id)
            others.push_back(id);
    if (others.empty()) return 0;
    return others[static_cast<std::size_t>(random(0, static_cast<double>(others.size())))];
}

std::vector<v1::Input> Behaviour::act(double seconds, const client::WorldView& world,
                                      std::uint32_t client_id) {
    std::vector<v1::Input> out;
    if (world.frame().frame == 0 || line_.behaviour == "idle") return out;
    if (line_.behaviour == "drag") {
        drag(out, world, client_id, seconds);
        return out;
    }
    if (seconds < next_) return out;
    next_ = std::max(next_ + value("period"), seconds);
    if (line_.behaviour == "wander") wander(out, world, client_id);
    if (line_.behaviour == "push") push(out, world, client_id);
    if (line_.behaviour == "throw") throw_ball(out, world, client_id);
    if (line_.behaviour == "builder") build(out, world, client_id);
    if (line_.behaviour == "drive" && take_control(out, world, seconds)) drive(out, world);
    if (line_.behaviour == "walk" && take_control(out, world, seconds)) walk(out, world);
    if (line_.behaviour == "race" && take_control(out, world, seconds)) race(out, world, seconds);
    return out;
}

void Behaviour::wander(std::vector<v1::Input>& out, const client::WorldView& world,
                       std::uint32_t id) {
    const auto mine = owned(world, id);
    if (mine.empty()) {
        v1::SpawnInput& spawn = *out.emplace_back().mutable_spawn();
        spawn.mutable_shape()->mutable_sphere()->set_radius(0.35);
        set(*spawn.mutable_position(), site_[0], 1.5, site_[1]);
        spawn.set_color(color_);
        return;
    }
    const auto entity = world.entities().find(mine.front());
    const auto pose = world.pose_of(mine.front());
    if (!pose) return;
    // A random direction, or back to the centre from outside the yard.
    const double angle = random(0, 6.283), speed = value("strength") * entity->second.mass();
    double x = std::cos(angle), z = std::sin(angle);
    const double distance = std::hypot(pose->position[0], pose->position[2]);
    if (distance > yard) x = -pose->position[0] / distance, z = -pose->position[2] / distance;
    v1::ImpulseInput& impulse = *out.emplace_back().mutable_impulse();
    impulse.set_entity(mine.front());
    set(*impulse.mutable_impulse(), x * speed, 0.2 * speed, z * speed);
}

void Behaviour::push(std::vector<v1::Input>& out, const client::WorldView& world,
                     std::uint32_t id) {
    const std::uint32_t entity = random_entity(world, id);
    const auto pose = world.pose_of(entity);
    if (entity == 0 || !pose) return;
    // Towards the centre, so that the yard does not empty.
    const double x = pose->position[0], z = pose->position[2];
    const double distance = std::max(0.5, std::hypot(x, z));
    const double strength = value("strength") * world.entities().at(entity).mass();
    v1::ImpulseInput& impulse = *out.emplace_back().mutable_impulse();
    impulse.set_entity(entity);
    set(*impulse.mutable_impulse(), -x / distance * strength, 0.4 * strength,
        -z / distance * strength);
}

bool Behaviour::make_room(std::vector<v1::Input>& out, const std::vector<std::uint32_t>& mine) {
    if (static_cast<double>(mine.size()) < value("max_bodies")) return true;
    out.emplace_back().mutable_delete_()->set_entity(mine.front());
    return false;
}

void Behaviour::throw_ball(std::vector<v1::Input>& out, const client::WorldView& world,
                           std::uint32_t id) {
    if (!make_room(out, owned(world, id))) return;
    const double angle = random(0, 6.283), speed = value("speed");
    v1::SpawnInput& spawn = *out.emplace_back().mutable_spawn();
    spawn.mutable_shape()->mutable_sphere()->set_radius(0.25);
    set(*spawn.mutable_position(), yard * std::cos(angle), 2.5, yard * std::sin(angle));
    set(*spawn.mutable_linear_velocity(), -speed * std::cos(angle), 0.25 * speed,
        -speed * std::sin(angle));
    spawn.set_color(color_);
}

void Behaviour::build(std::vector<v1::Input>& out, const client::WorldView& world,
                      std::uint32_t id) {
    const auto mine = owned(world, id);
    const double half = value("size") / 2;
    if (mine.empty()) built_ = 0;
    if (!make_room(out, mine)) {
        // The tower is complete: delete it and build the next one elsewhere.
        out.clear();
        for (const std::uint32_t entity : mine)
            out.emplace_back().mutable_delete_()->set_entity(entity);
        site_ = {random(-yard, yard), random(-yard, yard)};
        built_ = 0;
        return;
    }
    v1::SpawnInput& spawn = *out.emplace_back().mutable_spawn();
    set(*spawn.mutable_shape()->mutable_box()->mutable_half_extents(), half, half, half);
    set(*spawn.mutable_position(), site_[0], half + 2.05 * half * built_ + 0.01, site_[1]);
    spawn.set_color(color_);
    built_++;
}

void Behaviour::drag(std::vector<v1::Input>& out, const client::WorldView& world, std::uint32_t id,
                     double seconds) {
    if (grabbed_ == 0) {
        if (seconds < next_) return;
        next_ = seconds + value("period");
        const std::uint32_t entity = random_entity(world, id);
        const auto pose = world.pose_of(entity);
        if (entity == 0 || !pose) return;
        grabbed_ = entity;
        grab_point_ = pose->position;
        release_at_ = seconds + value("period") / 2;
        v1::GrabInput& grab = *out.emplace_back().mutable_grab();
        grab.set_entity(entity);
        set(*grab.mutable_point(), grab_point_[0], grab_point_[1], grab_point_[2]);
        return;
    }
    if (seconds >= release_at_) {
        out.emplace_back().mutable_release();
        grabbed_ = 0;
        return;
    }
    // In a circle above the grabbed point.
    const double left = release_at_ - seconds;
    set(*out.emplace_back().mutable_drag()->mutable_target(), grab_point_[0] + std::cos(4 * left),
        grab_point_[1] + 1.5, grab_point_[2] + std::sin(4 * left));
}

bool Behaviour::take_control(std::vector<v1::Input>& out, const client::WorldView& world,
                             double seconds) {
    if (world.entities().contains(controlled_) && seconds < change_at_) return true;
    std::vector<std::uint32_t> controllable;
    for (const auto& [id, entity] : world.entities())
        if (entity.controllable()) controllable.push_back(id);
    controlled_ = 0;
    if (controllable.empty()) return false;
    controlled_ =
        controllable[static_cast<std::size_t>(random(0, static_cast<double>(controllable.size())))];
    change_at_ = line_.values.contains("change") ? seconds + value("change") : forever;
    laps_.begin();
    last_position_at_ = -1;
    out.emplace_back().mutable_possess()->set_entity(controlled_);
    return true;
}

// Drives forward with random turns, and back to the centre from outside the range.
void Behaviour::drive(std::vector<v1::Input>& out, const client::WorldView& world) {
    const auto pose = world.pose_of(controlled_);
    if (!pose) return;
    double steer = random(-1, 1) * random(0, 1);
    const auto [x, y, z] = pose->position;
    if (std::hypot(x, z) > range) {
        // The body's -z axis and the direction to the centre, seen from above.
        const auto& q = pose->rotation;
        const double ahead_x = -2 * (q[0] * q[2] + q[3] * q[1]),
                     ahead_z = -1 + 2 * (q[0] * q[0] + q[1] * q[1]);
        const double right = ahead_x * -z - ahead_z * -x, along = ahead_x * -x + ahead_z * -z;
        steer = along < 0 ? (right < 0 ? -1 : 1) : right / (1 + std::hypot(x, z));
    }
    v1::ControlInput& control = *out.emplace_back().mutable_control();
    control.add_axes(axis(steer));
    control.add_axes(axis(random(0.3, 1)));
}

// Drives along the tangent of the circle, and towards the circle if off it.
void Behaviour::race(std::vector<v1::Input>& out, const client::WorldView& world, double seconds) {
    const auto pose = world.pose_of(controlled_);
    if (!pose) return;
    const auto [x, y, z] = pose->position;
    laps_.add_position(seconds, x, z);
    const double since = seconds - last_position_at_;
    const double speed = last_position_at_ < 0 || since <= 0
                             ? 0
                             : std::hypot(x - last_position_[0], z - last_position_[2]) / since;
    last_position_ = pose->position;
    last_position_at_ = seconds;
    const double distance = std::max(1.0, std::hypot(x, z));
    const double off = std::clamp((distance - value("radius")) / course_correction_m, -1.0, 1.0);
    const double course_x = z / distance - off * x / distance,
                 course_z = -x / distance - off * z / distance;
    const auto& q = pose->rotation;
    const double ahead_x = -2 * (q[0] * q[2] + q[3] * q[1]),
                 ahead_z = -1 + 2 * (q[0] * q[0] + q[1] * q[1]);
    const double left = std::atan2(ahead_z * course_x - ahead_x * course_z,
                                   ahead_x * course_x + ahead_z * course_z);
    v1::ControlInput& control = *out.emplace_back().mutable_control();
    control.add_axes(axis(-(left + wheel_base / value("radius")) / full_lock));
    control.add_axes(axis(0.15 + 0.3 * (value("speed") - speed)));
}

void Behaviour::walk(std::vector<v1::Input>& out, const client::WorldView& world) {
    const auto pose = world.pose_of(controlled_);
    if (!pose) return;
    const double x = pose->position[0], z = pose->position[2];
    // The heading is measured from -z, positive to the left.
    double heading = random(-1, 1);
    if (std::hypot(x, z) > yard) heading = std::atan2(x, z) / pi;
    v1::ControlInput& control = *out.emplace_back().mutable_control();
    for (const double value : {0.0, 1.0, 0.0, heading}) control.add_axes(axis(value));
    control.set_buttons(random(0, 1) < 0.2 ? 1 : 0);
}

void LapCounter::add_position(double seconds, double x, double z) {
    if (!seen_) began_ = seconds;
    if (seen_) turned_ += std::atan2(x_ * z - z_ * x, x_ * x + z_ * z);
    seen_ = true;
    x_ = x, z_ = z;
    const double distance = std::hypot(x, z);
    lap_.nearest = std::min(lap_.nearest, distance);
    lap_.furthest = std::max(lap_.furthest, distance);
    constexpr double full_turn = 2 * 3.14159265358979;
    if (std::abs(turned_) < full_turn) return;
    lap_.seconds = seconds - began_;
    laps_.push_back(lap_);
    turned_ -= turned_ < 0 ? -full_turn : full_turn;
    began_ = seconds;
    lap_ = {};
}

}  // namespace jostle::bot
