// SPDX-License-Identifier: MIT
#include "bench/module_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "jostle/modules/character.h"
#include "jostle/modules/cloth.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/particles.h"
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/rope.h"
#include "jostle/modules/vehicle.h"
#include "jostle/physics/mesh.h"

namespace jostle::bench {
namespace {

using namespace physics;
using namespace modules;

// Throws if a call fails: the scenes are part of this file, so a failure is a bug in it.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}
void must(const Status& status) {
    if (!status) throw std::runtime_error(status.error().message);
}

void add_floor(World& world) {
    must(world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}));
}

// Adds a module to a world and returns a reference to it.
template <class M>
M& add(World& world) {
    auto module = std::make_unique<M>();
    M& added = *module;
    must(world.add_module(std::move(module)));
    return added;
}

// Position k of a square grid with `spacing` m between neighbours.
Vec3 grid_position(int k, double spacing) {
    constexpr int side = 16;
    return {spacing * (k % side), 0, spacing * (k / side)};
}

// Ragdolls that wave on the floor, or lie and twitch; none sleeps.
class RagdollScene final : public ModuleScene {
public:
    RagdollScene(int count, RagdollMode mode) : ragdolls_(add<Ragdolls>(world_)) {
        add_floor(world_);
        RagdollDef figure = human_figure();
        figure.sleep_allowed = false;
        for (int k = 0; k < count; k++) {
            ids_.push_back(must(ragdolls_.add(world_, figure, {grid_position(k, 2.5), {}})));
            must(ragdolls_.set_mode(world_, ids_.back(), mode));
        }
    }
    void step(int k) override {
        RagdollPose pose{.rotations = std::vector<Quat>(11)};
        pose.rotations[3] = from_axis_angle({0, 0, 1}, 0.6 * sin_cos(0.1 * k).sin);
        for (std::size_t i = 0; i < ids_.size(); i++) {
            pose.root.position = grid_position(static_cast<int>(i), 2.5);
            must(ragdolls_.set_pose(ids_[i], pose));
        }
        must(world_.step(1.0 / 60));
    }

private:
    World world_;
    Ragdolls& ragdolls_;
    std::vector<RagdollId> ids_;
};

// 400 m of gentle hills, as triangles of 2 m.
Geometry hills() {
    constexpr std::uint32_t side = 201;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t r = 0; r < side; r++)
        for (std::uint32_t c = 0; c < side; c++) {
            const double x = 2.0 * c - 200, z = 2.0 * r - 200;
            vertices.push_back({x, 0.6 * sin_cos(0.12 * x).sin * sin_cos(0.09 * z).cos, z});
            if (r == 0 || c == 0) continue;
            const std::uint32_t k = r * side + c;
            triangles.push_back({k, k - side, k - 1});
            triangles.push_back({k - 1, k - side, k - side - 1});
        }
    return Mesh{must(build_mesh(vertices, triangles))};
}

// Characters that walk on hills, each on its own circle.
class Walkers final : public ModuleScene {
public:
    explicit Walkers(int count) : characters_(add<Characters>(world_)) {
        must(world_.create_body({.type = BodyType::static_body}, {.geometry = hills()}));
        for (int k = 0; k < count; k++)
            ids_.push_back(
                must(characters_.add(world_, {.feet = grid_position(k, 4) + Vec3{0, 0.8, 0}})));
    }
    void step(int k) override {
        for (std::size_t i = 0; i < ids_.size(); i++) {
            const SinCos turn = sin_cos(0.01 * k + static_cast<double>(i));
            must(characters_.set_controls(
                ids_[i], {.walk = {3 * turn.cos, 0, 3 * turn.sin}, .jump = k % 120 == 0}));
        }
        must(world_.step(1.0 / 60));
    }

private:
    World world_;
    Characters& characters_;
    std::vector<CharacterId> ids_;
};

// Saloon cars that drive in circles, on a plane or on hills.
template <bool over_hills, WheelCast cast>
class Cars final : public ModuleScene {
public:
    explicit Cars(int count) : vehicles_(add<Vehicles>(world_)) {
        if (over_hills)
            must(world_.create_body({.type = BodyType::static_body}, {.geometry = hills()}));
        else
            add_floor(world_);
        for (int k = 0; k < count; k++) {
            const BodyId chassis = must(world_.create_body(
                {.pose = {.position =
                              grid_position(k, 12) + Vec3{-90, over_hills ? 1.6 : 0.7, -90}},
                 .sleep_allowed = false},
                {.geometry = Box{{0.8, 0.25, 2}}, .mass = 1500}));
            VehicleDef def = saloon({.chassis = chassis});
            def.cast = cast;
            const CarId car = must(vehicles_.add(world_, def));
            must(vehicles_.set_controls(world_, car, {.throttle = 0.3, .steering = 0.4}));
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Vehicles& vehicles_;
};

// Crates that fly in turbulent air, or float on two waves.
template <bool afloat>
class Crates final : public ModuleScene {
public:
    explicit Crates(int count) : fields_(add<Fields>(world_)) {
        VolumeField field{.law = Turbulence{.speed = 3}};
        if (afloat)
            field.law = Waves{.components = {{.amplitude = 0.3, .length = 14},
                                             {.amplitude = 0.1, .length = 6, .heading = 1}}};
        must(fields_.add(world_, field));
        for (int k = 0; k < count; k++)
            must(world_.create_body({.pose = {.position = grid_position(k, 2.5)},
                                     .gravity_scale = afloat ? 1.0 : 0.0,
                                     .sleep_allowed = false},
                                    {.geometry = Box{{0.5, 0.3, 0.4}}, .density = 400}));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Fields& fields_;
};

// Concrete walls of 4 m x 3 m with 150 chunks each. Either they stay intact while 100 crates roll
// near them, or a heavy ball breaks one after another, one every 20 steps.
template <bool breaking>
class Walls final : public ModuleScene {
public:
    explicit Walls(int count) : destruction_(add<Destruction>(world_)) {
        add_floor(world_);
        const Vec3 half{2, 1.5, 0.15};
        FracturedShape wall = must(fracture_box(half, random_seeds(half, 150, 1)));
        anchor(wall, {0, -1, 0}, half.y - 1e-6);
        for (int k = 0; k < count; k++)
            must(destruction_.add(
                world_, wall, {.pose = {.position = grid_position(k, 6) + Vec3{0, half.y, 0}}}));
        if (breaking) return;
        for (int k = 0; k < 100; k++)
            must(world_.create_body({.pose = {.position = grid_position(k, 6) + Vec3{0, 0.5, 2}},
                                     .sleep_allowed = false},
                                    {.geometry = Box{{0.4, 0.4, 0.4}}}));
    }
    void step(int k) override {
        if (breaking && k % 20 == 0) throw_at(grid_position(k / 20, 6));
        must(world_.step(1.0 / 60));
    }

private:
    void throw_at(Vec3 target) {
        must(world_.create_body(
            {.pose = {.position = target + Vec3{0, 1.8, -3}}, .linear_velocity = {0, 1, 25}},
            {.geometry = Sphere{0.3}, .density = 7800}));
    }

    World world_;
    Destruction& destruction_;
};

// Releases `count` chunks at once at the start of the measurement: stacks of boxes, or a wall of
// Voronoi hulls. With `passing`, the chunks do not collide with each other.
template <bool hulls, bool passing = false>
class Burst final : public ModuleScene {
public:
    explicit Burst(int count) : destruction_(add<Destruction>(world_)) {
        add_floor(world_);
        DestructionLimits limits;
        limits.passing_volume = passing ? 1 : 0;
        must(destruction_.set_limits(limits));
        const Vec3 half{0.2 * count / 80, 4, 0.1};
        const FracturedShape wall = must(hulls ? fracture_box(half, random_seeds(half, count, 1))
                                               : split_box(half, (count + 39) / 40, 40, 1));
        id_ = must(destruction_.add(world_, wall, {.pose = {.position = {0, half.y + 0.01, 0}}}));
    }
    void step(int k) override {
        if (k == 120) must(destruction_.break_near(world_, id_, {}, 1e6));
        must(world_.step(1.0 / 60));
    }

private:
    World world_;
    Destruction& destruction_;
    DestructibleId id_;
};

// A throw of each object in its own direction, with linear drag:
// v = g / c + (v0 - g / c) exp(-c t). The objects do not meet anything.
class Throw : public ModuleScene {
public:
    static constexpr double drag = 0.5;  // 1/s
    static Vec3 gravity() { return {0, -9.81, 0}; }
    static Vec3 velocity_of(int k) {
        const SinCos turn = sin_cos(0.61803398875 * 2 * pi * k);
        return {10 * turn.cos, 20 + 0.001 * k, 10 * turn.sin};
    }
    static Vec3 start_of(int k) { return grid_position(k, 2); }
    std::optional<double> error() const override {
        const double t = world_.time();
        const Vec3 last = gravity() * (1 / drag);
        double sum = 0;
        for (int k = 0; k < count_; k++) {
            const Vec3 truth = start_of(k) + last * t +
                               (velocity_of(k) - last) * ((1 - std::exp(-drag * t)) / drag);
            sum += length_squared(position_of(k) - truth);
        }
        return square_root(sum / count_);
    }

protected:
    explicit Throw(int count) : count_(count) {}
    virtual Vec3 position_of(int k) const = 0;

    int count_;
    World world_;
};

template <ParticleIntegrator integrator>
class ParticleThrow final : public Throw {
public:
    explicit ParticleThrow(int count) : Throw(count), particles_(add<Particles>(world_)) {
        key_ = must(particles_.add(world_, {.integrator = integrator,
                                            .count_max = static_cast<std::uint32_t>(count),
                                            .linear_drag = drag,
                                            .collide_bodies = false}));
        for (int k = 0; k < count; k++) {
            const ParticleStart start{start_of(k), velocity_of(k)};
            must(particles_.group(key_)->add(std::span(&start, 1)));
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    Vec3 position_of(int k) const override {
        return particles_.group(key_)->positions()[static_cast<std::size_t>(k)];
    }

    Particles& particles_;
    ParticleKey key_;
};

// The peer: rigid bodies without collisions.
class BodyThrow final : public Throw {
public:
    explicit BodyThrow(int count) : Throw(count) {
        for (int k = 0; k < count; k++)
            bodies_.push_back(must(world_.create_body(
                {.pose = {.position = start_of(k)},
                 .linear_velocity = velocity_of(k),
                 .linear_damping = drag,
                 .sleep_allowed = false},
                {.geometry = Sphere{0.05}, .filter = {.category = 1, .mask = 0}})));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    Vec3 position_of(int k) const override {
        return world_.body(bodies_[static_cast<std::size_t>(k)])->pose.position;
    }

    std::vector<BodyId> bodies_;
};

// Particles in a steady state: emitted at a rate that replaces those whose lifetime ended.
template <bool smoke, bool balls>
class EmittedParticles final : public ModuleScene {
public:
    explicit EmittedParticles(int count) : particles_(add<Particles>(world_)) {
        if (!smoke)
            must(world_.create_body({.type = BodyType::static_body}, {.geometry = hills()}));
        ParticleGroupDef def{.count_max = static_cast<std::uint32_t>(count),
                             .radius = balls ? 0.05 : 0,
                             .gravity_scale = smoke ? -0.02 : 1,
                             .linear_drag = smoke ? 1.0 : 0,
                             .collide_bodies = !smoke,
                             .collide_particles = balls};
        if (smoke) def.flow = {.speed = 1, .scale = 2};
        def.emitter = {.shape = EmitterShape::box,
                       .position = {0, 6, 0},
                       .half_extents = {20, 1, 20},
                       .rate = count / 2.0,
                       .speed = 0,
                       .lifetime = 2};
        must(particles_.add(world_, def));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Particles& particles_;
};

// The bodies that the agents of a crowd move.
enum class CrowdBodies { none, kinematic, dynamic };

// Agents on a circle that swap places with the opposite one, in the proportions of the example
// "Circle" of RVO2: a circumference of 3.35 radii per agent.
template <CrowdBodies bodies>
class CrowdCircle final : public ModuleScene {
public:
    explicit CrowdCircle(int count) : crowd_(add<Crowd>(world_)) {
        if (bodies == CrowdBodies::dynamic)
            must(world_.create_body({.type = BodyType::static_body},
                                    {.geometry = Plane{}, .material = {.friction = 0}}));
        const double circle = 3.35 * radius * count / (2 * pi);
        for (int k = 0; k < count; k++) {
            const SinCos turn = sin_cos(2 * pi * k / count);
            const Vec3 p{circle * turn.cos, 0.9, circle * turn.sin};
            AgentDef def{.position = p, .radius = radius, .speed = 1.3};
            def.destination = {.aim = Aim::point, .point = -p};
            const BodyType type =
                bodies == CrowdBodies::dynamic ? BodyType::dynamic : BodyType::kinematic;
            if (bodies != CrowdBodies::none)
                def.body = must(world_.create_body(
                    {.type = type, .pose = {p, {}}},
                    {.geometry = Capsule{radius, 0.9 - radius},
                     .material = {.friction = 0, .friction_rule = Combine::multiply},
                     .mass = 75}));
            must(crowd_.add(world_, def));
        }
    }
    void step(int k) override {
        must(world_.step(1.0 / 60));
        if (k % 60 == 0) overlap_ = std::max(overlap_, largest_overlap());
        if (arrival_ == 0 && crowd_.counts().arrived == crowd_.counts().agents)
            arrival_ = world_.time();
    }
    std::string errors() override {
        char text[128];
        std::snprintf(text, sizeof text,
                      "overlap %.2f %% of a radius, %u of %u arrived, the last one after %.0f s",
                      100 * overlap_ / radius, crowd_.counts().arrived, crowd_.counts().agents,
                      arrival_ > 0 ? arrival_ : world_.time());
        return text;
    }

private:
    static constexpr double radius = 0.25;  // m
    // Of two agents, m.
    double largest_overlap() {
        std::vector<Vec3> points;
        for (const AgentId id : crowd_.ids())
            points.push_back(must(crowd_.state(world_, id)).position);
        std::sort(points.begin(), points.end(), [](Vec3 a, Vec3 b) { return a.x < b.x; });
        double worst = 0;
        for (std::size_t a = 0; a < points.size(); a++)
            for (std::size_t b = a + 1; b < points.size() && points[b].x - points[a].x < 2 * radius;
                 b++) {
                Vec3 offset = points[b] - points[a];
                offset.y = 0;
                worst = std::max(worst, 2 * radius - length(offset));
            }
        return worst;
    }

    World world_;
    Crowd& crowd_;
    double overlap_ = 0, arrival_ = 0;  // m, s
};

// A flock of kinematic balls around a home.
class Flock final : public ModuleScene {
public:
    explicit Flock(int count) : crowd_(add<Crowd>(world_)) {
        must(crowd_.add_flock({.roam = 30}));
        for (int k = 0; k < count; k++) {
            const Vec3 p{1.2 * (k % 10), 1.2 * (k / 10 % 10), 1.2 * (k / 100)};
            const SinCos turn = sin_cos(static_cast<double>(k));
            const BodyId body =
                must(world_.create_body({.type = BodyType::kinematic,
                                         .pose = {p, {}},
                                         .linear_velocity = {turn.cos, 0, turn.sin}},
                                        {.geometry = Sphere{0.1}}));
            must(crowd_.add(world_, {.body = body,
                                     .kind = AgentKind::flyer,
                                     .radius = 0.1,
                                     .speed = 4,
                                     .max_speed = 6}));
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Crowd& crowd_;
};

// Where ropes are attached, 10 m above their loads.
Vec3 hook(int k) {
    return grid_position(k, 3) + Vec3{0, 12, 0};
}

// Loads of 10 kg on ropes of 1 kg, 10 m and 100 links. Closed form of the load: the rope stretches
// by its tension over E A.
class RopeLoads final : public ModuleScene {
public:
    explicit RopeLoads(int count) : ropes_(add<Ropes>(world_)) {
        for (int k = 0; k < count; k++) {
            const Vec3 top = hook(k), end = top - Vec3{0, length_, 0};
            const BodyId load = must(world_.create_body(
                {.pose = {end, {}}, .sleep_allowed = false},
                {.geometry = Sphere{0.1}, .density = load_mass_ / (4.0 / 3 * pi * 1e-3)}));
            const RopeKey rope = must(ropes_.add(
                world_,
                {.points = {top, end}, .links = 100, .mass_per_length = 0.1, .damping = 1}));
            must(ropes_.attach(world_, rope, {.node = 0, .point = top}));
            must(ropes_.attach(world_, rope, {.node = 100, .body = load}));
            loads_.push_back(load);
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }
    std::optional<double> error() const override {
        const double stretch = (load_mass_ + 0.5) * 9.81 / 1e6;
        double sum = 0;
        for (std::size_t k = 0; k < loads_.size(); k++) {
            const Vec3 expected = hook(static_cast<int>(k)) - Vec3{0, length_ * (1 + stretch), 0};
            sum += length_squared(must(world_.body(loads_[k])).center - expected);
        }
        return std::sqrt(sum / static_cast<double>(loads_.size()));
    }
    std::string errors() override {
        double most = 0;
        for (const RopeKey rope : ropes_.ropes()) {
            double sum = 0;
            const auto x = ropes_.positions(rope);
            for (std::size_t i = 1; i < x.size(); i++) sum += length(x[i] - x[i - 1]);
            most = std::max(most, sum / length_ - 1);
        }
        char text[80];
        std::snprintf(text, sizeof text, "stretch %.4f %%", 100 * most);
        return text;
    }

private:
    static constexpr double length_ = 10, load_mass_ = 10;
    World world_;
    Ropes& ropes_;
    std::vector<BodyId> loads_;
};

// The peer of RopeLoads: 100 rods in a row, jointed by points.
class JointedLoads final : public ModuleScene {
public:
    explicit JointedLoads(int count) : world_({.joint_solver = JointSolver::direct}) {
        for (int k = 0; k < count; k++) add_chain(hook(k));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }
    std::optional<double> error() const override {
        double sum = 0;
        for (std::size_t k = 0; k < loads_.size(); k++) {
            const Vec3 expected = hook(static_cast<int>(k)) - Vec3{0, 10, 0};
            sum += length_squared(must(world_.body(loads_[k])).center - expected);
        }
        return std::sqrt(sum / static_cast<double>(loads_.size()));
    }

private:
    void add_chain(Vec3 top) {
        BodyId before = {};
        Vec3 at = top;
        for (int k = 0; k < 100; k++) {
            const BodyId rod = must(world_.create_body(
                {.pose = {at - Vec3{0, 0.05, 0}, {}}, .sleep_allowed = false},
                {.geometry = Capsule{0.02, 0.03}, .mass = 0.01, .filter = {.mask = 0}}));
            connect(before, rod, at);
            before = rod;
            at.y -= 0.1;
        }
        loads_.push_back(
            must(world_.create_body({.pose = {at, {}}, .sleep_allowed = false},
                                    {.geometry = Sphere{0.1}, .mass = 10, .filter = {.mask = 0}})));
        connect(before, loads_.back(), at);
    }
    void connect(BodyId a, BodyId b, Vec3 at) {
        const Vec3 origin = is_null(a) ? Vec3{} : must(world_.body(a)).pose.position;
        must(world_.create_joint({.body_a = a,
                                  .body_b = b,
                                  .frame_a = {at - origin, {}},
                                  .frame_b = {at - must(world_.body(b)).pose.position, {}},
                                  .kind = BallJoint{}}));
    }

    World world_;
    std::vector<BodyId> loads_;
};

// Horizontal rods of 1 m, held at one end. Closed form: the deflection of an Euler-Bernoulli
// cantilever under its own weight, w L^4 / 8 E I.
class RopeCantilevers final : public ModuleScene {
public:
    explicit RopeCantilevers(int count) : ropes_(add<Ropes>(world_)) {
        for (int k = 0; k < count; k++) {
            const Vec3 at = hook(k);
            const RopeKey rod = must(ropes_.add(world_, {.points = {at, at + Vec3{1, 0, 0}},
                                                         .links = 40,
                                                         .mass_per_length = 0.1,
                                                         .bending_stiffness = 2,
                                                         .damping = 5}));
            must(ropes_.attach(world_, rod, {.node = 0, .point = at, .direction = {1, 0, 0}}));
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }
    std::optional<double> error() const override {
        const double deflection = 0.1 * 9.81 / (8 * 2.0);
        double sum = 0;
        for (const RopeKey rod : ropes_.ropes()) {
            const auto x = ropes_.positions(rod);
            const double off = x.front().y - x.back().y - deflection;
            sum += off * off;
        }
        return std::sqrt(sum / static_cast<double>(ropes_.ropes().size()));
    }

private:
    World world_;
    Ropes& ropes_;
};

// Ropes that hang over bars and swing, with contacts.
class RopesOverBars final : public ModuleScene {
public:
    explicit RopesOverBars(int count) : ropes_(add<Ropes>(world_)) {
        for (int k = 0; k < count; k++) {
            const Vec3 at = grid_position(k, 4) + Vec3{0, 3, 0};
            must(world_.create_body(
                {.type = BodyType::static_body, .pose = {at, from_axis_angle({1, 0, 0}, pi / 2)}},
                {.geometry = Cylinder{.radius = 0.3, .half_length = 1}}));
            must(ropes_.add(world_, {.points = {at + Vec3{-1.5, 0.5, 0}, at + Vec3{1.5, 0.5, 0}},
                                     .links = 60,
                                     .damping = 0.02}));
        }
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Ropes& ropes_;
};

// A square sheet of 1 m that hangs by its first row; the objects are its vertices. Closed form of
// its last row: the elastic stretch under its own weight, rho g L^2 / 2 E.
template <bool bends>
class HangingSheet final : public ModuleScene {
public:
    explicit HangingSheet(int count) : cloths_(add<Cloths>(world_)) {
        rows_ = static_cast<std::uint32_t>(std::lround(std::sqrt(count)));
        const ClothDef def{
            .grid = {.rows = rows_, .columns = rows_, .across = {1, 0, 0}, .down = {0, -1, 0}},
            .bending_stiffness = bends ? 1e-5 : 0,
            .damping = 0.5};
        closed_form_ = def.mass_per_area * 9.81 / (2 * def.stretch_stiffness);
        key_ = must(cloths_.add(world_, def));
        const std::vector<Vec3> points = cloths_.positions(key_);
        for (std::uint32_t c = 0; c < rows_; c++)
            must(cloths_.attach(world_, key_, {.vertex = c, .point = points[c]}));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }
    std::optional<double> error() const override {
        const std::vector<Vec3> points = cloths_.positions(key_);
        double sum = 0;
        for (std::size_t k = points.size() - rows_; k < points.size(); k++) {
            const double off = points[k].y + 1 + closed_form_;
            sum += off * off;
        }
        return std::sqrt(sum / rows_);
    }

private:
    World world_;
    Cloths& cloths_;
    ClothKey key_;
    std::uint32_t rows_ = 0;
    double closed_form_ = 0;
};

// A sheet that falls over a ball; the objects are its vertices.
class DrapedSheet final : public ModuleScene {
public:
    explicit DrapedSheet(int count) : cloths_(add<Cloths>(world_)) {
        must(world_.create_body({.type = BodyType::static_body}, {.geometry = Sphere{0.4}}));
        const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(count)));
        must(cloths_.add(world_, {.grid = {.rows = rows,
                                           .columns = rows,
                                           .origin = {-0.7, 0.5, -0.7},
                                           .across = {1.4, 0, 0},
                                           .down = {0, 0, 1.4}}}));
    }
    void step(int) override { must(world_.step(1.0 / 60)); }

private:
    World world_;
    Cloths& cloths_;
};

template <class Scene>
std::unique_ptr<ModuleScene> make(int count) {
    return std::make_unique<Scene>(count);
}

template <RagdollMode mode>
std::unique_ptr<ModuleScene> figures(int count) {
    return std::make_unique<RagdollScene>(count, mode);
}

constexpr ModuleCase cases[] = {
    {"character_hills", 100, make<Walkers>},
    {"crowd_circle", 1000, make<CrowdCircle<CrowdBodies::none>>, 24000},
    {"crowd_circle_kinematic", 1000, make<CrowdCircle<CrowdBodies::kinematic>>, 24000},
    {"crowd_circle_dynamic", 200, make<CrowdCircle<CrowdBodies::dynamic>>, 7200},
    {"crowd_flock", 1000, make<Flock>},
    {"destruction_whole", 20, make<Walls<false>>},
    {"destruction_breaking", 36, make<Walls<true>>},
    {"destruction_burst_boxes", 2000, make<Burst<false>>},
    {"destruction_burst_hulls", 2000, make<Burst<true>>},
    {"destruction_burst_passing", 2000, make<Burst<true, true>>},
    {"field_turbulence", 500, make<Crates<false>>},
    {"field_waves", 500, make<Crates<true>>},
    {"particles_throw_explicit", 20000, make<ParticleThrow<ParticleIntegrator::explicit_euler>>},
    {"particles_throw_semi", 20000, make<ParticleThrow<ParticleIntegrator::semi_implicit_euler>>},
    {"particles_throw_implicit", 20000, make<ParticleThrow<ParticleIntegrator::implicit_euler>>},
    {"particles_throw_verlet", 20000, make<ParticleThrow<ParticleIntegrator::verlet>>},
    {"particles_throw_rk4", 20000, make<ParticleThrow<ParticleIntegrator::runge_kutta_4>>},
    {"throw_bodies", 2000, make<BodyThrow>},
    {"particles_smoke", 20000, make<EmittedParticles<true, false>>},
    {"particles_rain", 20000, make<EmittedParticles<false, false>>},
    {"particles_balls", 20000, make<EmittedParticles<false, true>>},
    {"cloth_hangs", 10000, make<HangingSheet<true>>},
    {"cloth_hangs_threads", 10000, make<HangingSheet<false>>},
    {"cloth_drapes", 2500, make<DrapedSheet>},
    {"rope_loads", 10, make<RopeLoads>},
    {"rope_loads_joints", 10, make<JointedLoads>},
    {"rope_cantilevers", 20, make<RopeCantilevers>},
    {"rope_bars", 20, make<RopesOverBars>},
    {"ragdoll_limp", 40, figures<RagdollMode::limp>},
    {"ragdoll_powered", 40, figures<RagdollMode::powered>},
    {"ragdoll_kinematic", 40, figures<RagdollMode::kinematic>},
    {"vehicle_flat_ray", 100, make<Cars<false, WheelCast::ray>>},
    {"vehicle_flat_cylinder", 100, make<Cars<false, WheelCast::cylinder>>},
    {"vehicle_flat_bodies", 100, make<Cars<false, WheelCast::body>>},
    {"vehicle_hills_ray", 100, make<Cars<true, WheelCast::ray>>},
    {"vehicle_hills_cylinder", 100, make<Cars<true, WheelCast::cylinder>>},
    {"vehicle_hills_bodies", 100, make<Cars<true, WheelCast::body>>},
};

}  // namespace

std::span<const ModuleCase> module_cases() {
    return cases;
}

}  // namespace jostle::bench
