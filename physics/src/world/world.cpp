// SPDX-License-Identifier: MIT
//
// World: checks arguments, changes state, runs the step.
#include "jostle/physics/world.h"
#include "jostle/base/check.h"

#include "jostle/physics/limits.h"
#include "physics/src/foundation/fp_mode.h"
#include "physics/src/stages/step_world.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {

World::World(std::unique_ptr<WorldState> state)
    : state_(std::move(state)), scratch_(std::make_unique<StepScratch>()) {}
World::World() : World(WorldDef{}) {}

World::World(const WorldDef& def) : World(create(def).value()) {}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldDef& def) {
    if (Status s = check_world(def); !s.ok()) return s.error();
    auto state = std::make_unique<WorldState>();
    state->def = def;
    state->shapes.statics = make_broad_phase(def.broad_phase);
    state->shapes.moving = make_broad_phase(def.broad_phase);
    state->thread_pool = std::make_unique<ThreadPool>(def.threads);
    return World(std::move(state));
}

namespace {

// Marks a step as in progress for its lifetime.
class SteppingScope {
public:
    SteppingScope(ListenerStore& listeners, World& world) : listeners_(listeners) {
        ASSERT(listeners.stepping == nullptr);
        listeners_.stepping = &world;
    }
    ~SteppingScope() { listeners_.stepping = nullptr; }
    SteppingScope(const SteppingScope&) = delete;
    SteppingScope& operator=(const SteppingScope&) = delete;

private:
    ListenerStore& listeners_;
};

}  // namespace

Status World::step(double dt) {
    if (Status s = check_range("dt", dt, 1e-5, 0.25); !s.ok()) return s;
    if (Status s = check_not_stepping(state_->listeners, "step the world"); !s.ok()) return s;
    const auto stopped = [&] {
        return Error{ErrorCode::aborted,
                     "stop_stepping() was called; call resume_stepping() to continue"};
    };
    if (scratch_->stopped) return stopped();
    const ListenerStore& listeners = state_->listeners;
    const FpModeScope fp_mode;  // applies to listeners too
    const SteppingScope stepping(state_->listeners, *this);
    for (const auto& entry : listeners.order) entry.listener->before_step(*this, dt);
    state_->listeners.refresh_hooks();
    step_world(*state_, *scratch_, dt);
    for (const auto& entry : listeners.order) entry.listener->after_step(*this, dt);
    if (scratch_->stopped) return stopped();
    return {};
}
void World::parallel_for(int count, int grain,
                         const std::function<void(int first, int last)>& function) const {
    ASSERT(count >= 0 && grain >= 1);
    ThreadPool& thread_pool = *state_->thread_pool;
    if (thread_pool.size() > 1 && count >= 4 * grain) thread_pool.wake();
    thread_pool.run(count, grain, function);
}
void World::count_work(std::int64_t work) {
    ASSERT(work >= 0);
    state_->listeners.work += work;
}
void World::stop_stepping() {
    scratch_->stopped = true;
}
void World::resume_stepping() {
    scratch_->stopped = false;
}
double World::time() const {
    return state_->time;
}

std::uint64_t World::step_count() const {
    return state_->steps;
}
Vec3 World::gravity() const {
    return state_->def.gravity;
}
double World::tolerance() const {
    return state_->def.tolerance;
}

std::int64_t World::substep_budget() const {
    return state_->def.substep_budget;
}

std::int64_t World::step_budget() const {
    return state_->def.step_budget;
}

int World::max_pairs_per_shape() const {
    return state_->def.max_pairs_per_shape;
}

Status World::set_max_pairs_per_shape(int pairs) {
    WorldDef def = state_->def;
    def.max_pairs_per_shape = pairs;
    if (Status s = check_world(def); !s.ok()) return s;
    state_->def.max_pairs_per_shape = pairs;
    return {};
}

int World::overload_level() const {
    return state_->overload_level.level;
}

int World::substeps() const {
    return state_->def.substeps;
}

JointSolver World::joint_solver() const {
    return state_->def.joint_solver;
}

Status World::set_joint_solver(JointSolver solver) {
    if (Status s = check_joint_solver("joint_solver", solver); !s.ok()) return s;
    state_->def.joint_solver = solver;
    for (Island& island : state_->islands.islands) island.too_dense_for = -1;
    return {};
}

Status World::set_gravity(Vec3 gravity) {
    WorldState& world = *state_;
    WorldDef def = world.def;
    def.gravity = gravity;
    if (Status s = check_world(def); !s.ok()) return s;
    if (gravity == world.def.gravity) return {};
    // Resting bodies may fall.
    for (std::uint32_t body = 0; body < world.bodies.ids.size(); body++)
        if (world.bodies.ids.alive(body)) wake_body(world, body);
    world.def.gravity = gravity;
    for (std::uint32_t i = 0; i < world.contacts.ids.size(); i++)
        if (world.contacts.ids.alive(i) && world.contacts.contacts[i].colour >= 0)
            derive_flags(world, world.contacts.contacts[i]);
    for (const BodyWarm& warm : world.bodies.awake)
        update_motion_bound(world, warm.body, expected_dt(world));
    return {};
}

Status World::set_threads(int threads) {
    if (Status s = check_range("threads", threads, 1, limits::max_threads); !s.ok()) return s;
    if (threads == state_->def.threads) return {};
    state_->def.threads = threads;
    state_->thread_pool = std::make_unique<ThreadPool>(threads);
    state_->thread_choice = {};
    state_->thread_usage = {};
    return {};
}

Events World::events() const {
    const EventStore& e = state_->events;
    return {.contacts_began = e.contacts_began,
            .contacts_ended = e.contacts_ended,
            .contacts = e.contacts,
            .hits = e.hits,
            .triggers_entered = e.triggers_entered,
            .triggers_stayed = e.triggers_stayed,
            .triggers_left = e.triggers_left,
            .joints_broke = e.joints_broke,
            .fell_asleep = e.fell_asleep,
            .woke = e.woke,
            .quarantined = e.quarantined};
}

const StepProfile& World::profile() const {
    return state_->profile;
}

}  // namespace jostle::physics
