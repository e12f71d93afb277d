// SPDX-License-Identifier: MIT
//
// Settings of a crowd in scenes.
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "jostle/modules/settings.h"
#include "modules/crowd/src/crowd_checks.h"

namespace jostle::modules {

using namespace physics;
using crowd_detail::coordinate_max;
using crowd_detail::CrowdStore;

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr double person_mass = 75;  // kg

bool is_given(double value) {
    return value == value;
}

// Reads the settings whose names begin with a prefix.
class PrefixReader {
public:
    PrefixReader(const ModuleSettings& given, std::string prefix)
        : reader_(given), prefix_(std::move(prefix)) {}

    void number(const char* name, double& to, double low, double high) {
        reader_.number(prefix_ + name, to, low, high);
    }
    void whole(const char* name, std::uint32_t& to, double low, double high) {
        double value = to;
        number(name, value, low, high);
        to = static_cast<std::uint32_t>(value);
    }
    void flag(const char* name, bool& to) { reader_.flag(prefix_ + name, to); }
    template <class E>
    void choice(const char* name, E& to, E last) {
        auto value = static_cast<std::uint32_t>(to);
        whole(name, value, 0, static_cast<double>(last));
        to = static_cast<E>(value);
    }
    void vector(const char* name, Vec3& to, double low, double high) {
        number((std::string(name) + "_x").c_str(), to.x, low, high);
        number((std::string(name) + "_y").c_str(), to.y, low, high);
        number((std::string(name) + "_z").c_str(), to.z, low, high);
    }
    // nullopt if no component is given.
    std::optional<Vec3> optional_vector(const char* name, double limit) {
        Vec3 value{absent, absent, absent};
        vector(name, value, -limit, limit);
        if (!is_given(value.x) && !is_given(value.y) && !is_given(value.z)) return std::nullopt;
        const auto or_zero = [](double x) { return is_given(x) ? x : 0; };
        return Vec3{or_zero(value.x), or_zero(value.y), or_zero(value.z)};
    }
    void body(const char* name, BodyId& to) { reader_.body(prefix_ + name, to); }
    Status finish() { return reader_.finish(); }

private:
    SettingsReader reader_;
    std::string prefix_;
};

// The prefix of the first setting that has one; empty if none has.
std::string prefix_of(const ModuleSettings& given) {
    constexpr std::array<std::string_view, 8> prefixes{"route_", "wall_",   "obstacle_", "goal_",
                                                       "flock_", "threat_", "agent_",    "group_"};
    const auto match = [&](const std::string& name) -> std::string {
        for (const std::string_view prefix : prefixes)
            if (name.starts_with(prefix) && name != "wall_horizon") return std::string(prefix);
        return "";
    };
    for (const auto& [name, number] : given.numbers)
        if (const std::string prefix = match(name); !prefix.empty()) return prefix;
    for (const auto& [name, body] : given.bodies)
        if (const std::string prefix = match(name); !prefix.empty()) return prefix;
    return "";
}

Status configure_rules(Crowd& crowd, const ModuleSettings& given) {
    CrowdSettings rules = crowd.settings();
    PrefixReader in(given, "");
    in.whole("seed", rules.seed, 0, 4294967295.0);
    in.flag("vertical", rules.vertical);
    in.whole("neighbors", rules.neighbors, 1, crowd_detail::neighbors_max);
    in.number("reach", rules.reach, 0.2, 50);
    in.number("horizon", rules.horizon, 0.05, 20);
    in.number("wall_horizon", rules.wall_horizon, 0.05, 20);
    in.number("side_preference", rules.side_preference, -0.5, 0.5);
    in.number("noise", rules.noise, 0, 0.5);
    in.number("panic_time", rules.panic_time, 0, 1000);
    in.number("panic_speed", rules.panic_speed, 0, 50);
    in.number("contagion", rules.contagion, 0, 0.99);
    in.number("blow_speed", rules.blow_speed, 0.1, 1e3);
    if (Status s = in.finish(); !s.ok()) return s;
    return crowd.set_settings(rules);
}

Vec2 plane_of(const CrowdStore& store, Vec3 v) {
    const Vec3 p = store.to_plane(v);
    return {p.x, p.y};
}

Status configure_route(Crowd& crowd, const CrowdStore& store, const ModuleSettings& given) {
    RouteGrid grid;
    Vec3 center, half{10, 10, 10};
    PrefixReader in(given, "route_");
    in.vector("center", center, -coordinate_max, coordinate_max);
    in.vector("half", half, 0, 1e4);
    in.number("cell", grid.cell, 0.05, 100);
    in.number("clearance", grid.clearance, 0, 10);
    if (Status s = in.finish(); !s.ok()) return s;
    grid.center = plane_of(store, center);
    grid.half_extents = plane_of(store, half);
    return crowd.set_routes(grid);
}

Status configure_wall(Crowd& crowd, const CrowdStore& store, const ModuleSettings& given) {
    Vec3 from, to;
    PrefixReader in(given, "wall_");
    in.vector("from", from, -coordinate_max, coordinate_max);
    in.vector("to", to, -coordinate_max, coordinate_max);
    if (Status s = in.finish(); !s.ok()) return s;
    return crowd.add_wall(plane_of(store, from), plane_of(store, to));
}

Status configure_obstacle(Crowd& crowd, const World& world, const ModuleSettings& given) {
    BodyId body;
    PrefixReader in(given, "obstacle_");
    in.body("body", body);
    if (Status s = in.finish(); !s.ok()) return s;
    if (Status s = crowd.add_walls_of(world, body); !s.ok())
        return Error{s.error().code, "obstacle_body: " + s.error().message};
    return {};
}

// Adds a goal, or an area to a goal with a number that exists already.
Status configure_goal(Crowd& crowd, const CrowdStore& store, const ModuleSettings& given) {
    auto number = static_cast<std::uint32_t>(store.goals.size());
    PrefixReader in(given, "goal_");
    in.whole("number", number, 0, Crowd::goals_max - 1);
    if (number > store.goals.size())
        return Error{ErrorCode::invalid_argument,
                     "goal_number must be at most " + std::to_string(store.goals.size()) +
                         ", the number of goals so far; " + std::to_string(number) + " is given"};
    const bool exists = number < store.goals.size();
    GoalDef goal = exists ? store.goals[number] : GoalDef{};
    Vec3 center, half{1, 1, 1};
    in.vector("center", center, -coordinate_max, coordinate_max);
    in.vector("half", half, 0, 1e4);  // add_goal() checks the components in the plane
    in.choice("end", goal.end, GoalEnd::next);
    in.whole("next", goal.next, 0, Crowd::goals_max - 1);
    if (Status s = in.finish(); !s.ok()) return s;
    goal.areas.push_back({plane_of(store, center), plane_of(store, half)});
    if (exists) return crowd.set_goal(number, goal);
    const auto added = crowd.add_goal(goal);
    return added.ok() ? Status{} : Status(added.error());
}

Status configure_flock(Crowd& crowd, const ModuleSettings& given) {
    FlockDef flock;
    PrefixReader in(given, "flock_");
    in.number("reach", flock.reach, 0.1, 100);
    in.number("separation", flock.separation, 0, 100);
    in.number("separation_weight", flock.separation_weight, 0, 1e3);
    in.number("alignment_weight", flock.alignment_weight, 0, 100);
    in.number("cohesion_weight", flock.cohesion_weight, 0, 100);
    in.number("aim_weight", flock.aim_weight, 0, 100);
    in.number("roam", flock.roam, 0, 1e5);
    in.vector("home", flock.home, -coordinate_max, coordinate_max);
    if (Status s = in.finish(); !s.ok()) return s;
    const auto added = crowd.add_flock(flock);
    return added.ok() ? Status{} : Status(added.error());
}

Status configure_threat(Crowd& crowd, const World& world, const ModuleSettings& given) {
    Threat threat;
    PrefixReader in(given, "threat_");
    in.body("body", threat.body);
    in.number("radius", threat.radius, 0.1, 1000);
    if (Status s = in.finish(); !s.ok()) return s;
    return crowd.add_threat(world, threat);
}

// Reads the settings that agents and groups share.
void read_agent(PrefixReader& in, AgentDef& def) {
    in.choice("kind", def.kind, AgentKind::flyer);
    in.number("radius", def.radius, 0.05, 5);
    in.number("speed", def.speed, 0, 50);
    def.max_speed = maximum(def.max_speed, 1.5 * def.speed);
    in.number("max_speed", def.max_speed, 0, 100);
    in.number("acceleration", def.acceleration, 0.1, 1e4);
    in.flag("slows_in_crowds", def.slows_in_crowds);
    in.whole("flock", def.flock, 0, Crowd::flocks_max - 1);
    Destination& destination = def.destination;
    double goal = -1;
    in.number("goal", goal, 0, Crowd::goals_max - 1);
    if (const auto velocity = in.optional_vector("velocity", 100)) {
        destination.aim = Aim::move;
        destination.velocity = *velocity;
    }
    if (const auto point = in.optional_vector("target", coordinate_max)) {
        destination.aim = Aim::point;
        destination.point = *point;
    }
    if (goal >= 0) {
        destination.aim = Aim::goal;
        destination.goal = static_cast<std::uint32_t>(goal);
    }
    in.number("distance", destination.distance, 0, 1000);
    in.body("follow", destination.body);
    if (!is_null(destination.body)) destination.aim = Aim::follow;
}

Status configure_agent(Crowd& crowd, World& world, const ModuleSettings& given) {
    AgentDef def;
    PrefixReader in(given, "agent_");
    in.body("body", def.body);
    in.vector("position", def.position, -coordinate_max, coordinate_max);
    read_agent(in, def);
    if (Status s = in.finish(); !s.ok()) return s;
    const auto added = crowd.add(world, def);
    return added.ok() ? Status{} : Status(added.error());
}

// Bodies of the agents of a group.
enum class GroupBodies : std::uint8_t { kinematic, dynamic, none };

struct Group {
    AgentDef agent;
    std::uint32_t count = 10, seed = 1;
    Vec3 center, half{5, 0, 5};  // m, region on the ground (walkers) or in space (flyers)
    GroupBodies bodies = GroupBodies::kinematic;
    double height = 1.8, mass = person_mass;
};

// Upright capsules for walkers; balls for flyers, and discs in a planar world.
Result<BodyId> create_body(World& world, const Group& group, bool vertical, Vec3 position,
                           Vec3 velocity) {
    const bool walks = group.agent.kind == AgentKind::walker && !vertical;
    const bool dynamic = group.bodies == GroupBodies::dynamic;
    const double radius = group.agent.radius;
    ShapeDef shape{.geometry = Sphere{radius},
                   .material = {.friction = 0, .friction_rule = Combine::multiply},
                   .mass = group.mass};
    if (walks) shape.geometry = Capsule{radius, maximum(0.5 * group.height - radius, 0.01)};
    return world.create_body({.type = dynamic ? BodyType::dynamic : BodyType::kinematic,
                              .pose = {position, {}},
                              .linear_velocity = velocity,
                              .gravity_scale = walks ? 1.0 : 0.0},
                             shape);
}

// Uniform numbers in [0, 1) (Press et al., "Numerical Recipes").
class GroupRandom {
public:
    explicit GroupRandom(std::uint32_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 1664525u + 1013904223u;
        return (state_ >> 8) / 16777216.0;
    }

private:
    std::uint32_t state_;
};

// Places the agents on a jittered lattice that fills the region.
Status add_group(Crowd& crowd, World& world, const CrowdStore& store, const Group& group) {
    const bool flies = group.agent.kind == AgentKind::flyer;
    const bool vertical = store.settings.vertical;
    const Vec3 half = store.to_plane(group.half), center = store.to_plane(group.center);
    const bool deep = flies && half.z > 0;
    GroupRandom random(group.seed);
    // Number of columns, rows and layers with at least `count` places.
    double spacing = maximum(maximum(half.x, half.y), maximum(deep ? half.z : 0, 0.01));
    const auto places = [&](double step, double length) {
        return static_cast<std::uint64_t>(2 * length / step) + 1;
    };
    const auto total = [&](double step) {
        return places(step, half.x) * places(step, half.y) * (deep ? places(step, half.z) : 1);
    };
    while (total(spacing) < group.count && spacing > 1e-3) spacing *= 0.97;
    const double diameter = 2 * group.agent.radius;
    if (spacing < diameter && group.count > 1)
        return Error{ErrorCode::invalid_argument, "the region has no room for group_count = " +
                                                      std::to_string(group.count) + " agents"};
    const std::uint64_t columns = places(spacing, half.x), rows = places(spacing, half.y);
    const double jitter = maximum(minimum(0.25 * spacing, 0.49 * (spacing - diameter)), 0);
    for (std::uint32_t k = 0; k < group.count; k++) {
        const auto at = [&](std::uint64_t index, double length) {
            return -length + spacing * static_cast<double>(index) +
                   jitter * (2 * random.next() - 1);
        };
        const double x = at(k % columns, half.x), y = at(k / columns % rows, half.y);
        const double z = deep ? at(k / (columns * rows), half.z) : 0;
        Vec3 position = store.to_plane(center + Vec3{x, y, z});
        if (!flies && !vertical) position.y += 0.5 * group.height;  // from the feet to the centre
        AgentDef def = group.agent;
        def.position = position;
        Vec3 velocity;
        if (flies) {
            const SinCos turn = sin_cos(2 * pi * random.next());
            velocity = store.to_plane({turn.cos, turn.sin, 0}) * def.speed;
        }
        if (group.bodies != GroupBodies::none) {
            const auto body = create_body(world, group, vertical, position, velocity);
            if (!body.ok()) return body.error();
            def.body = *body;
        }
        const auto added = crowd.add(world, def);
        if (!added.ok()) return added.error();
    }
    return {};
}

Status configure_group(Crowd& crowd, World& world, const CrowdStore& store,
                       const ModuleSettings& given) {
    Group group;
    PrefixReader in(given, "group_");
    in.whole("count", group.count, 0, Crowd::agents_max);
    in.whole("seed", group.seed, 0, 4294967295.0);
    in.vector("center", group.center, -coordinate_max, coordinate_max);
    in.vector("half", group.half, 0, 1e4);
    in.choice("bodies", group.bodies, GroupBodies::none);
    in.number("height", group.height, 0.1, 20);
    in.number("mass", group.mass, 0.001, 1e5);
    read_agent(in, group.agent);
    if (Status s = in.finish(); !s.ok()) return s;
    return add_group(crowd, world, store, group);
}

}  // namespace

Status Crowd::configure(World& world, const ModuleSettings& given) {
    const std::string prefix = prefix_of(given);
    if (prefix == "route_") return configure_route(*this, *store_, given);
    if (prefix == "wall_") return configure_wall(*this, *store_, given);
    if (prefix == "obstacle_") return configure_obstacle(*this, world, given);
    if (prefix == "goal_") return configure_goal(*this, *store_, given);
    if (prefix == "flock_") return configure_flock(*this, given);
    if (prefix == "threat_") return configure_threat(*this, world, given);
    if (prefix == "agent_") return configure_agent(*this, world, given);
    if (prefix == "group_") return configure_group(*this, world, *store_, given);
    return configure_rules(*this, given);
}

}  // namespace jostle::modules
