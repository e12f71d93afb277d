// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/project_joints.h"

#include <algorithm>
#include <vector>

#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/toi_body.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/joint_graph.h"

namespace jostle::physics {
namespace {

// In each round the rows are linear. Errors of more than half a metre or 0.4 rad take several.
constexpr int projection_rounds = 8;
constexpr double projection_time = 0.05;  // s

struct ProjectedBody {
    std::uint32_t body = none;
    bool movable = false, placed = false;  // placed: by an impact
    bool held = true;                      // in the current attempt
    Quat rotation;                         // where the step has put it
    Vec3 turn;                             // its rotation in the step
    Vec3 before, start;  // m: of the centre at the start of the step, and where the step has put it
};

// A group of bodies connected by joints that hold points.
class JointProjection {
public:
    JointProjection(const StepContext& step, std::vector<std::uint8_t>& visited)
        : world_(step.world), finalize_(step.scratch.finalize), dt_(step.dt), visited_(visited) {}

    void find(std::uint32_t body, std::span<const std::uint32_t> placed) {
        std::vector<std::uint32_t> open{body}, joints;
        visited_[body] = 1;
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            open.pop_back();
            for_each_joint(world_.joints, world_.bodies.cold[at], [&](std::uint32_t index) {
                const Joint& joint = world_.joints.joints[index];
                if (!holds_point(joint.kind)) return;
                joints.push_back(index);
                for (const std::uint32_t other : {joint.body_a, joint.body_b}) {
                    if (!is_dynamic(world_.bodies, other) || visited_[other] != 0) continue;
                    visited_[other] = 1;
                    open.push_back(other);
                }
            });
        }
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
        for (const std::uint32_t index : joints) add(world_.joints.joints[index], placed);
        joints_ = solver_.joints;
        for (DirectJoint& joint : solver_.joints) write_vectors(joint, solver_.bodies);
    }

    // Tolerance of the remaining joint error, m.
    double close_enough() const {
        double scale = 1;
        for (const ProjectedBody& body : bodies_)
            if (!body.held)
                scale = minimum(scale, size_scale(world_.bodies.cold[body.body].radius));
        return tuning::close_enough * scale;
    }

    // Returns false if the projection is too expensive.
    bool prepare() {
        const int joints = static_cast<int>(solver_.joints.size());
        if (joints == 0 || is_net(joints, static_cast<int>(bodies_.size()))) return false;
        std::int64_t cubes = 0;
        for (const DirectJoint& joint : solver_.joints)
            cubes += std::int64_t{joint.rows()} * joint.rows() * joint.rows();
        return solver_.prepare(std::int64_t{tuning::direct_work} * cubes);
    }
    bool is_closed() {
        place_all(1, false);
        return solver_.joint_error() < close_enough();
    }

    // Closes the joints as well as it can be done. First where the step has put the bodies, without
    // moving those that an impact placed, then with them, then from further back on the way of all
    // bodies: there the joints held as the step began.
    void close() {
        constexpr double shares[] = {1, 1, 0.75, 0.5, 0.25, 0};
        std::vector<DirectBody> best = solver_.bodies;
        double least = solver_.joint_error();
        for (std::size_t k = 0; k < std::size(shares) && least >= close_enough(); k++) {
            place_all(shares[k], k > 0);
            if (!prepare()) return;
            move_back();
            if (clamp_displacements()) move_back();
            const double left = solver_.joint_error();
            if (!(left < least)) continue;
            least = left;
            best = solver_.bodies;
        }
        solver_.bodies = best;
    }

    void apply_poses(WorldState& world, double dt) const {
        for (std::size_t k = 0; k < bodies_.size(); k++) {
            const DirectBody& now = solver_.bodies[k];
            if (bodies_[k].body != none && !(now.x == bodies_[k].start))
                move_body_to(world, bodies_[k].body, now.x, now.q, dt);
        }
    }

private:
    // Places the bodies that may move at a share of their way in this step.
    void place_all(double share, bool placed_too) {
        for (std::size_t k = 0; k < bodies_.size(); k++) {
            const ProjectedBody& body = bodies_[k];
            if (!body.movable) continue;
            DirectBody& to = solver_.bodies[k];
            to.x = body.before + (body.start - body.before) * share;
            to.q = share < 1
                       ? normalized(from_rotation_vector(body.turn * -(1 - share)) * body.rotation)
                       : body.rotation;
            set_held(k, body.placed && !placed_too);
        }
        // prepare() drops limits between held bodies.
        solver_.joints = joints_;
        for (DirectJoint& joint : solver_.joints) write_vectors(joint, solver_.bodies);
    }
    // Moves each body as little as its mass allows.
    void move_back() {
        const double enough = 0.1 * close_enough();
        for (int round = 0; round < projection_rounds; round++) {
            for (DirectBody& body : solver_.bodies) body.p = body.l = Vec3{};
            if (!solver_.hold_joints(projection_time, {enough, 1e-4, enough})) return;
            for (std::size_t k = 0; k < bodies_.size(); k++) {
                DirectBody& body = solver_.bodies[k];
                if (!body.pushed) continue;
                body.x = body.x1;
                body.q = normalized(body.q1);
                turn(k);
            }
        }
    }
    // The nearest point of the way that a body has come in this step. Nothing is in that way.
    static Vec3 nearest_on_way(const ProjectedBody& body, Vec3 x) {
        const Vec3 way = body.start - body.before;
        const double length2 = length_squared(way);
        const double at = length2 > 0 ? dot(x - body.before, way) / length2 : 1;
        return body.before + way * maximum(0, minimum(at, 1));
    }
    // Clamps bodies to their maximum displacement from their way and holds them there.
    bool clamp_displacements() {
        bool any = false;
        for (std::size_t k = 0; k < bodies_.size(); k++) {
            if (bodies_[k].held) continue;
            const double most = 0.5 * world_.bodies.cold[bodies_[k].body].inner_radius;
            DirectBody& body = solver_.bodies[k];
            const Vec3 from = nearest_on_way(bodies_[k], body.x);
            const Vec3 displacement = body.x - from;
            const double far = length(displacement);
            if (far <= most) continue;
            body.x = from + displacement * (most / far);
            set_held(k, true);
            any = true;
        }
        return any && prepare();
    }
    void set_held(std::size_t k, bool held) {
        bodies_[k].held = held;
        solver_.bodies[k].pushed = !held;
        const double mass = held ? 0 : world_.bodies.cold[bodies_[k].body].inverse_mass;
        solver_.bodies[k].inverse_mass = mass;
        solver_.bodies[k].inverse_masses = Vec3{mass, mass, mass};
        turn(k);
    }
    void turn(std::size_t k) {
        DirectBody& body = solver_.bodies[k];
        body.axes = to_matrix(body.q);
        body.turned_from = body.q;
        if (bodies_[k].body != none && body.pushed)
            body.inverse_inertia = body.axes * world_.bodies.cold[bodies_[k].body].inverse_inertia *
                                   transpose(body.axes);
    }

    // FinalizeScratch has the start of bodies that moved far or were deflected.
    void find_way(const BodyCold& cold, const BodyWarm& warm, ProjectedBody& to) const {
        const bool recorded = cold.at < finalize_.fast.size() &&
                              (finalize_.fast[cold.at] != 0 || finalize_.deflected[cold.at] != 0);
        to.before = warm.center - warm.v * dt_;
        to.turn = warm.w * dt_;
        if (!recorded) return;
        to.before = finalize_.previous[cold.at].center;
        to.turn =
            rotation_vector_between(finalize_.previous[cold.at].rotation, warm.rotation, to.turn);
    }

    int number_of(std::uint32_t body, std::span<const std::uint32_t> placed) {
        for (std::size_t k = bodies_.size();
             k-- > 0;)  // backwards: usually the previous joint has the body
            if (bodies_[k].body == body && body != none) return static_cast<int>(k);
        ProjectedBody to{.body = body};
        DirectBody& state = solver_.bodies.emplace_back();
        if (body != none) {
            const BodyWarm& warm = warm_of(world_, body);
            const BodyCold& cold = world_.bodies.cold[body];
            state.x = to.start = to.before = warm.center;
            to.rotation = warm.rotation;
            if (cold.set == BodySet::awake) find_way(cold, warm, to);
            state.q = warm.rotation;
            state.mass = cold.mass;
            state.moments = {cold.inertia.x.x, cold.inertia.y.y, cold.inertia.z.z};
            to.movable = cold.type == BodyType::dynamic && cold.set == BodySet::awake &&
                         !cold.asleep_in_place && cold.locks == 0;
            to.placed = to.movable && std::binary_search(placed.begin(), placed.end(), body);
            to.held = !to.movable || to.placed;
        }
        bodies_.push_back(to);
        set_held(bodies_.size() - 1, to.held);
        return static_cast<int>(bodies_.size()) - 1;
    }

    void add(const Joint& from, std::span<const std::uint32_t> placed) {
        const auto end = [&](std::uint32_t body, const Transform& frame) {
            const Vec3 center = body == none ? Vec3{} : world_.bodies.cold[body].local_center;
            return DirectEnd{frame.position - center, frame.rotation};
        };
        DirectJoint joint;
        joint.a = number_of(from.body_a, placed);
        joint.b = number_of(from.body_b, placed);
        set_up_rigid(joint, from.kind, end(from.body_a, from.frame_a),
                     end(from.body_b, from.frame_b));
        solver_.joints.push_back(joint);
    }

    const WorldState& world_;
    const FinalizeScratch& finalize_;
    double dt_;
    std::vector<std::uint8_t>& visited_;
    std::vector<ProjectedBody> bodies_;  // by number in the solver
    std::vector<DirectJoint> joints_;    // with all limits
    DirectGroup solver_;
};

}  // namespace

void project_joints(StepContext& step, std::span<const std::uint32_t> placed) {
    WorldState& world = step.world;
    if (world.joints.ids.alive_count() == 0) return;
    ASSERT(std::is_sorted(placed.begin(), placed.end()));
    std::vector<std::uint8_t> visited;
    for (const std::uint32_t body : placed) {
        if (world.bodies.cold[body].first_joint == none) continue;
        if (visited.empty()) visited.resize(world.bodies.cold.size());
        if (visited[body] != 0) continue;
        JointProjection group(step, visited);
        group.find(body, placed);
        if (!group.prepare() || group.is_closed()) continue;
        group.close();
        group.apply_poses(world, step.dt);
    }
}

}  // namespace jostle::physics
