// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/project_joints.h"

#include <algorithm>
#include <vector>

#include "physics/src/constraints/direct/joint_system_blocks.h"
#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/toi_body.h"
#include "physics/src/state/joint_graph.h"

namespace jostle::physics {
namespace {

constexpr int rounds = 3;  // iterations of Newton's method
constexpr int joint_rows = 3;

struct ProjectedBody {
    std::uint32_t body = none;
    bool held = false;
    bool placed = false;  // held only because an impact placed it
    Vec3 center, start;
    Quat rotation;
    Mat3 axes, inverse_inertia;
    double inverse_mass = 0;
    Vec3 push, twist;  // of the current iteration
};
struct ProjectedJoint {
    JointEnds ends;
    Vec3 local_a, local_b;  // arms in body axes, m
    Vec3 arm_a, arm_b, gap;
};

// A group of bodies connected by point joints.
class JointProjection {
public:
    JointProjection(const WorldState& world, std::vector<std::uint8_t>& visited)
        : world_(world), visited_(visited) {}

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
    }

    double widest() {
        double most = 0;
        for (ProjectedJoint& joint : joints_) {
            const ProjectedBody &a = bodies_[as_index(joint.ends.a)],
                                &b = bodies_[as_index(joint.ends.b)];
            joint.arm_a = a.axes * joint.local_a;
            joint.arm_b = b.axes * joint.local_b;
            joint.gap = (b.center + joint.arm_b) - (a.center + joint.arm_a);
            most = maximum(most, length(joint.gap));
        }
        return most;
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
        const int joints = static_cast<int>(joints_.size());
        if (joints == 0 || is_net(joints, static_cast<int>(bodies_.size()))) return false;
        std::vector<JointEnds> ends;
        std::vector<std::uint8_t> pushed;
        for (const ProjectedJoint& joint : joints_) ends.push_back(joint.ends);
        for (const ProjectedBody& body : bodies_) pushed.push_back(body.held ? 0 : 1);
        return find_joint_system_blocks(
            ends, std::vector<int>(as_index(joints), joint_rows), pushed,
            std::int64_t{tuning::direct_work} * joints * joint_rows * joint_rows * joint_rows,
            matrix_, system_blocks_);
    }

    void move_back() {
        assemble();
        matrix_.factor();
        std::vector<double> x(as_index(matrix_.rows()));
        for (std::size_t k = 0; k < joints_.size(); k++)
            for (int axis = 0; axis < joint_rows; axis++)
                x[as_index(matrix_.row_of(static_cast<int>(k)) + axis)] = -joints_[k].gap[axis];
        matrix_.solve(x);
        for (ProjectedBody& body : bodies_) body.push = body.twist = {};
        for (std::size_t k = 0; k < joints_.size(); k++) {
            const double* const at = x.data() + matrix_.row_of(static_cast<int>(k));
            const Vec3 push{at[0], at[1], at[2]};
            const JointEnds& ends = joints_[k].ends;
            ProjectedBody &a = bodies_[as_index(ends.a)], &b = bodies_[as_index(ends.b)];
            a.push -= push;
            a.twist -= cross(joints_[k].arm_a, push);
            b.push += push;
            b.twist += cross(joints_[k].arm_b, push);
        }
        for (ProjectedBody& body : bodies_) {
            if (body.held) continue;
            body.center += body.push * body.inverse_mass;
            body.rotation =
                normalized(from_rotation_vector(body.inverse_inertia * body.twist) * body.rotation);
            turn(body);
        }
    }

    // Closes the joints. Returns false if an error remains. Large errors may not converge in the
    // available iterations; all bodies then stay where they are.
    bool close() {
        const std::vector<ProjectedBody> previous = bodies_;
        const double left = widest();
        for (int round = 0; round < rounds; round++) {
            move_back();
            if (widest() < close_enough()) break;
        }
        clamp_displacements();
        if (widest() > left) bodies_ = previous;
        return widest() < close_enough();
    }
    // Retries with the bodies placed by impacts movable, if the others could not close the joints.
    void project_with_placed() {
        for (ProjectedBody& body : bodies_)
            if (body.placed) body.held = false;
        if (prepare()) close();
    }

    void apply_poses(WorldState& world, double dt) const {
        for (const ProjectedBody& body : bodies_)
            if (length(body.center - body.start) >= close_enough())
                move_body_to(world, body.body, body.center, body.rotation, dt);
    }

private:
    // Clamps bodies to their maximum displacement and holds them there.
    void clamp_displacements() {
        for (ProjectedBody& body : bodies_) {
            if (body.held) continue;
            const double most = 0.5 * world_.bodies.cold[body.body].inner_radius;
            const Vec3 displacement = body.center - body.start;
            const double far = length(displacement);
            if (far <= most) continue;
            body.center = body.start + displacement * (most / far);
            body.held = true;
        }
    }
    void turn(ProjectedBody& body) const {
        body.axes = to_matrix(body.rotation);
        body.inverse_inertia =
            body.axes * world_.bodies.cold[body.body].inverse_inertia * transpose(body.axes);
    }

    int number_of(std::uint32_t body, std::span<const std::uint32_t> placed) {
        for (std::size_t k = bodies_.size();
             k-- > 0;)  // backwards: usually the previous joint has the body
            if (bodies_[k].body == body && body != none) return static_cast<int>(k);
        ProjectedBody to;
        to.body = body;
        to.held = true;
        if (body != none) {
            const BodyWarm& warm = warm_of(world_, body);
            const BodyCold& cold = world_.bodies.cold[body];
            to.center = to.start = warm.center;
            to.rotation = warm.rotation;
            to.held = cold.type != BodyType::dynamic || cold.set != BodySet::awake ||
                      cold.asleep_in_place || cold.locks != 0;
            to.placed = !to.held && std::binary_search(placed.begin(), placed.end(), body);
            to.held |= to.placed;
            to.inverse_mass = cold.inverse_mass;
            turn(to);
        } else {
            to.axes = to_matrix(Quat{});
        }
        bodies_.push_back(to);
        return static_cast<int>(bodies_.size()) - 1;
    }

    void add(const Joint& joint, std::span<const std::uint32_t> placed) {
        const auto arm = [&](std::uint32_t body, const Transform& frame) {
            return body == none ? frame.position
                                : frame.position - world_.bodies.cold[body].local_center;
        };
        ProjectedJoint to;
        to.ends.a = number_of(joint.body_a, placed);
        to.ends.b = number_of(joint.body_b, placed);
        to.local_a = arm(joint.body_a, joint.frame_a);
        to.local_b = arm(joint.body_b, joint.frame_b);
        joints_.push_back(to);
    }

    // J M^-1 J^T.
    void assemble() {
        matrix_.clear();
        for (const JointSystemBlock& c : system_blocks_) {
            const ProjectedBody& body = bodies_[as_index(c.body)];
            const ProjectedJoint &later = joints_[as_index(c.later)],
                                 &sooner = joints_[as_index(c.sooner)];
            const double sign = c.later_b == c.sooner_b ? 1 : -1;
            const Vec3 at = c.later_b ? later.arm_b : later.arm_a;
            const Vec3 by = c.sooner_b ? sooner.arm_b : sooner.arm_a;
            double* const block = matrix_.values().data() + c.at;
            for (int column = 0; column < joint_rows; column++) {
                Vec3 unit;
                unit[column] = 1;
                const Vec3 moved =
                    unit * body.inverse_mass + cross(body.inverse_inertia * cross(by, unit), at);
                for (int row = 0; row < joint_rows; row++)
                    block[row * joint_rows + column] += sign * moved[row];
            }
        }
    }

    const WorldState& world_;
    std::vector<std::uint8_t>& visited_;
    std::vector<ProjectedBody> bodies_;
    std::vector<ProjectedJoint> joints_;
    std::vector<JointSystemBlock> system_blocks_;
    BlockLdl matrix_;
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
        JointProjection group(world, visited);
        group.find(body, placed);
        if (group.widest() < group.close_enough() || !group.prepare()) continue;
        if (!group.close()) group.project_with_placed();
        group.apply_poses(world, step.dt);
    }
}

}  // namespace jostle::physics
