// SPDX-License-Identifier: MIT
//
// The matrix of a group: its pattern, which is reused while bodies, joints and rows are unchanged,
// and its values, J M^-1 J^T.
#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"

namespace jostle::physics {
namespace {

// A redundant group with more joints is a net, not a mechanism of a few loops.
constexpr std::size_t max_loop_joints = 8;
constexpr double min_damper = 1e-30;  // N s/m or N m s
// m: for bodies that do not rotate and are held at their centres.
constexpr double min_reach = 0.01;

// Radius of gyration in metres of the principal axis with the largest moment.
double gyration_of(const DirectBody& body) {
    const Vec3& i = body.moments;
    ASSERT(i.x >= 0 && i.y >= 0 && i.z >= 0);
    return square_root(maximum(i.x, maximum(i.y, i.z)) * body.inverse_mass);
}

}  // namespace

// ---- the pattern ----

// Records which features the group has in addition to rigid joints.
void DirectGroup::list_what_acts() {
    damped_ = sprung_ = damped_springs_ = actuated_ = limited_ = locked_ = curved_ = false;
    for (DirectBody& body : bodies) {
        damped_ |= body.linear_damping != 0 || body.angular_damping != 0;
        locked_ |= body.pushed && (!body.turns_freely || body.inverse_masses.x == 0 ||
                                   body.inverse_masses.y == 0 || body.inverse_masses.z == 0);
        body.spring_square = 0;
    }
    std::size_t pushed = 0;
    for (const DirectBody& body : bodies) pushed += body.pushed ? 1 : 0;
    // Without loops each joint connects one more body to the ground or to the first body.
    const bool grounded = std::any_of(joints.begin(), joints.end(), [&](const DirectJoint& joint) {
        return !bodies[as_index(joint.a)].pushed || !bodies[as_index(joint.b)].pushed;
    });
    const auto gears = static_cast<std::size_t>(std::count_if(
        joints.begin(), joints.end(), [](const DirectJoint& joint) { return joint.is_gear(); }));
    const std::size_t holding = joints.size() - gears;  // a gear is a single row
    net_ = holding > max_loop_joints &&
           is_redundant(static_cast<int>(holding), static_cast<int>(pushed));
    looped_ = !net_ && joints.size() + (grounded ? 0 : 1) > pushed;
    double arms = 0;
    for (DirectJoint& joint : joints) {
        curved_ |= joint.path != nullptr;
        arms += length(joint.arm_a) + length(joint.arm_b) + joint.distance;
        for (const int body : {joint.a, joint.b}) arms += gyration_of(bodies[as_index(body)]);
        for (FreeAxis& free_axis : joint.free_axes) {
            // Locked axes allow no motion along this free axis. The axis of a swing of zero is
            // undefined.
            if (free_axis.kind != FreeAxis::Kind::swing && !joint.is_gear() &&
                response_of(free_axis, bodies[as_index(joint.a)], bodies[as_index(joint.b)]) <=
                    min_response(joint))
                nothing_along(free_axis);
            limited_ |= free_axis.has_limit();
            actuated_ |= free_axis.steps > 0;
            sprung_ |= free_axis.rate > 0;
            damped_springs_ |= free_axis.is_damped();
            for (const int body : {joint.a, joint.b})
                bodies[as_index(body)].spring_square += free_axis.rate * free_axis.rate;
        }
    }
    damped_ |= damped_springs_;
    bounded_ = limited_ || actuated_ || damped_springs_;
    smooth_ = !damped_ && !limited_ && !actuated_;
    // A spring's rate refers to its own two bodies. With several springs on a body, the sum of
    // squares bounds the rate.
    double most = 0;
    for (const DirectBody& body : bodies)
        if (body.pushed) most = maximum(most, body.spring_square);
    spring_rate_ = square_root(most);
    ASSERT(!joints.empty());
    reach_ = maximum(min_reach, arms / static_cast<double>(joints.size()));
}

bool DirectGroup::prepare(std::int64_t max_work) {
    count_ = {};
    factored_ = false;
    energy_ = false;
    step_ = 0;
    list_what_acts();
    std::vector<int> pattern;
    pattern.reserve(joints.size() * 3 + bodies.size());
    pattern.push_back(locked_ ? 1 : 0);
    for (const DirectBody& body : bodies) pattern.push_back(body.pushed ? 1 : 0);
    for (const DirectJoint& joint : joints)
        if (!joint.is_gear())
            pattern.insert(pattern.end(), {joint.a, joint.b, joint.rows()});
        else
            for (int k = 0; k < joint.gear[0].part_count; k++)
                pattern.insert(pattern.end(), {-1, joint.gear[0].parts[k].body});
    if (pattern != pattern_) {
        ASSERT(max_work >= 0);
        pattern_.clear();
        if (!find_pattern(max_work)) return false;
        pattern_ = std::move(pattern);
    }
    ball_tree_ = is_ball_tree();
    return matrix_.work() <= max_work;
}

bool DirectGroup::is_ball_tree() const {
    return joints.size() >= min_coarse_joints && !looped_ && !net_ && !locked_ &&
           hubs_.hubs.empty() &&
           std::all_of(joints.begin(), joints.end(),
                       [](const DirectJoint& joint) { return joint.is_ball_alone(); }) &&
           std::all_of(bodies.begin(), bodies.end(), [](const DirectBody& body) {
               return body.pushed || (body.v == Vec3{} && body.w == Vec3{});
           });
}

bool DirectGroup::find_pattern(std::int64_t max_work) {
    std::vector<JointEnds> ends;
    std::vector<int> rows;
    std::vector<std::uint8_t> pushed;
    for (const DirectJoint& joint : joints) {
        ends.push_back({joint.a, joint.b});
        if (joint.is_gear())
            for (const DirectGear::End& end : joint.gear[0].ends) {
                const bool known = end.carrier < 0 || end.carrier == joint.a ||
                                   end.carrier == joint.b || end.carrier == ends.back().carriers[0];
                if (!known) ends.back().carriers[ends.back().carriers[0] < 0 ? 0 : 1] = end.carrier;
            }
        rows.push_back(joint.rows());
    }
    for (const DirectBody& body : bodies) pushed.push_back(body.pushed ? 1 : 0);
    // A hub must move freely: its inverse inertia is inverted.
    if (!find_joint_system_blocks(ends, rows, pushed, max_work, matrix_, system_blocks_,
                                  locked_ ? nullptr : &hubs_))
        return false;
    if (locked_) hubs_ = {};
    right_side_.assign(as_index(matrix_.rows()), 0);
    ASSERT(matrix_.rows() > 0);
    // Sorted by position, so that the contributions to a block are summed consecutively.
    std::sort(system_blocks_.begin(), system_blocks_.end(),
              [](const JointSystemBlock& x, const JointSystemBlock& y) {
                  return std::pair(x.at, x.body) < std::pair(y.at, y.body);
              });
    const auto first_gear = std::stable_partition(
        system_blocks_.begin(), system_blocks_.end(), [&](const JointSystemBlock& c) {
            return !joints[as_index(c.later)].is_gear() && !joints[as_index(c.sooner)].is_gear();
        });
    gear_blocks_.assign(first_gear, system_blocks_.end());
    system_blocks_.erase(first_gear, system_blocks_.end());
    return true;
}

// ---- the values ----

namespace {

// Adds the response of a body of two ball joints, or of one, to their block.
void add_ball_block(const JointSystemBlock& c, const DirectJoint& later, const DirectJoint& sooner,
                    const Mat3& turned, Vec3 mass, double* block) {
    const Vec3 r = c.later_b ? later.lever_b : -later.lever_a;
    const Vec3 s = c.sooner_b ? sooner.lever_b : -sooner.lever_a;
    // Rows of I^-1 [r]x^T, that is, its columns times the axes of the world.
    const Vec3 rows[] = {turned.y * r.z - turned.z * r.y, turned.z * r.x - turned.x * r.z,
                         turned.x * r.y - turned.y * r.x};
    for (int i = 0; i < 3; i++) {
        const Vec3 y = rows[i];
        block[3 * i] += y.y * s.z - y.z * s.y;
        block[3 * i + 1] += y.z * s.x - y.x * s.z;
        block[3 * i + 2] += y.x * s.y - y.y * s.x;
        block[4 * i] += mass[i];
    }
}

}  // namespace

// `linear`: factor of the inverse masses; `response`: replaces the inverse inertia.
void DirectGroup::assemble(double linear, const Mat3 DirectBody::*response) {
    matrix_.clear();
    double* const values = matrix_.values().data();
    for (const JointSystemBlock& c : system_blocks_) {
        const DirectJoint &later = joints[as_index(c.later)], &sooner = joints[as_index(c.sooner)];
        const DirectBody& body = bodies[as_index(c.body)];
        const Vec3* const rows = c.later_b ? later.angular_b : later.angular_a;
        const Vec3* const columns = c.sooner_b ? sooner.angular_b : sooner.angular_a;
        const int n = sooner.rows(), m = later.rows();
        ASSERT(n >= 1 && m >= 1);
        double* const block = values + c.at;
        const Mat3& turned = body.*response;
        if (later.is_ball_alone() && sooner.is_ball_alone()) {
            add_ball_block(c, later, sooner, turned,
                           body.inverse_masses * (c.later_b == c.sooner_b ? linear : -linear),
                           block);
            continue;
        }
        for (int i = 0; i < m; i++) {
            const Vec3 y = turned * rows[i];
            for (int k = 0; k < n; k++) block[i * n + k] += dot(y, columns[k]);
        }
        const Vec3 mass = body.inverse_masses * (c.later_b == c.sooner_b ? linear : -linear);
        if (later.is_ball() && sooner.is_ball()) {
            for (int i = 0; i < 3; i++) block[i * n + i] += mass[i];
        } else if (later.is_ball()) {
            for (int k = 0; k < n; k++)
                for (int i = 0; i < 3; i++) block[i * n + k] += mass[i] * sooner.linear[k][i];
        } else if (sooner.is_ball()) {
            for (int i = 0; i < m; i++)
                for (int k = 0; k < 3; k++) block[i * n + k] += mass[k] * later.linear[i][k];
        } else {
            for (int i = 0; i < m; i++) {
                const Vec3 pushed = scaled(mass, later.linear[i]);
                for (int k = 0; k < n; k++) block[i * n + k] += dot(pushed, sooner.linear[k]);
            }
        }
    }
    for (const JointSystemBlock& c : gear_blocks_) assemble_gears(c, linear, response);
    assemble_hubs(linear, response);
    if (locked_) drop_locked();
    if (sprung_) soften(step_);
    if (resorting_ && (looped_ || net_))
        regularize(proximal);
    else if (looped_)
        regularize(energy_ ? mean_loop_compliance : loop_compliance);
    count_.skipped_rows = matrix_.factor();
    count_.factors++;
}

DirectGroup::RowPart DirectGroup::row_part(const DirectJoint& joint, int row, int body) const {
    if (joint.is_gear()) {
        const DirectGear::Part& part = part_of(joint.gear[0], body);
        return {part.linear, part.angular};
    }
    Vec3 line;
    if (!joint.is_ball())
        line = joint.linear[row];
    else if (row < 3)
        line[row] = 1;
    return joint.b == body ? RowPart{line, joint.angular_b[row]}
                           : RowPart{-line, joint.angular_a[row]};
}

void DirectGroup::assemble_hub_block(const DirectJoint& joint, const JointHubBlock& coupling,
                                     double* block) const {
    constexpr Vec3 axes_of_world[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3* const angular = coupling.body_b ? joint.angular_b : joint.angular_a;
    const int rows = joint.rows();
    for (int r = 0; r < rows; r++) {
        Vec3 line;
        if (!joint.is_ball())
            line = joint.linear[r];
        else if (r < 3)
            line = axes_of_world[r];
        if (!coupling.body_b) line = -line;
        for (int k = 0; k < 3; k++)
            if (coupling.hub_later)
                block[k * rows + r] = line[k], block[(k + 3) * rows + r] = angular[r][k];
            else
                block[r * hub_rows + k] = line[k], block[r * hub_rows + k + 3] = angular[r][k];
    }
}

// The rows of joints of which one is a gear.
void DirectGroup::assemble_gears(const JointSystemBlock& c, double linear,
                                 const Mat3 DirectBody::*response) {
    const DirectJoint &later = joints[as_index(c.later)], &sooner = joints[as_index(c.sooner)];
    const DirectBody& body = bodies[as_index(c.body)];
    double* const block = matrix_.values().data() + c.at;
    const int n = sooner.rows(), m = later.rows();
    for (int i = 0; i < m; i++) {
        const RowPart row = row_part(later, i, c.body);
        const Vec3 turned = body.*response * row.angular,
                   moved = scaled(row.linear, body.inverse_masses * linear);
        for (int k = 0; k < n; k++) {
            const RowPart column = row_part(sooner, k, c.body);
            block[i * n + k] += dot(turned, column.angular) + dot(moved, column.linear);
        }
    }
}

void DirectGroup::assemble_hubs(double linear, const Mat3 DirectBody::*response) {
    double* const values = matrix_.values().data();
    for (const JointHub& hub : hubs_.hubs) {
        const DirectBody& body = bodies[as_index(hub.body)];
        double* const block = values + hub.at;
        const Mat3 inertia = inverse(body.*response);
        const Vec3 columns[] = {inertia.x, inertia.y, inertia.z};
        for (int i = 0; i < 3; i++) {
            block[i * hub_rows + i] = -body.mass / linear;
            for (int k = 0; k < 3; k++) block[(i + 3) * hub_rows + k + 3] = -columns[k][i];
        }
    }
    for (const JointHubBlock& coupling : hubs_.blocks) {
        const DirectJoint& joint = joints[as_index(coupling.joint)];
        double* const block = values + coupling.at;
        const int rows = joint.rows();
        if (!joint.is_gear()) {
            assemble_hub_block(joint, coupling, block);
            continue;
        }
        const int hub = hubs_.hubs[as_index(coupling.hub)].body;
        for (int r = 0; r < rows; r++) {
            const RowPart part = row_part(joint, r, hub);
            for (int k = 0; k < 3; k++)
                if (coupling.hub_later) {
                    block[k * rows + r] = part.linear[k];
                    block[(k + 3) * rows + r] = part.angular[k];
                } else {
                    block[r * hub_rows + k] = part.linear[k];
                    block[r * hub_rows + k + 3] = part.angular[k];
                }
        }
    }
}

void DirectGroup::solve() {
    for (const JointHub& hub : hubs_.hubs) {
        double* const rows = right_side_.data() + matrix_.row_of(hub.node);
        std::fill(rows, rows + hub_rows, 0.0);
    }
    matrix_.solve(right_side_);
    count_.solves++;
}

// Makes dependent rows independent.
void DirectGroup::regularize(double compliance) {
    double* const values = matrix_.values().data();
    for (std::size_t k = 0; k < joints.size(); k++) {
        const int node = static_cast<int>(k), rows = joints[k].rows();
        double* const block = values + matrix_.block_at(node, node);
        for (int r = 0; r < rows; r++) block[r * (rows + 1)] *= 1 + compliance;
    }
}

// Threshold below which a response is rounding noise of the movable axes, 1/kg.
double DirectGroup::min_response(const DirectJoint& joint) const {
    double sum = 0;
    for (const int index : {joint.a, joint.b}) {
        const DirectBody& body = bodies[as_index(index)];
        const Mat3& turn = body.inverse_inertia;
        if (body.pushed) sum += body.inverse_mass + turn.x.x + turn.y.y + turn.z.z;
    }
    return 1e-20 * sum;
}

// Rows along locked axes: the factorisation skips rows with a zero diagonal.
void DirectGroup::drop_locked() {
    double* const values = matrix_.values().data();
    for (std::size_t k = 0; k < joints.size(); k++) {
        DirectJoint& joint = joints[k];
        const int node = static_cast<int>(k), rows = joint.rows();
        double* const block = values + matrix_.block_at(node, node);
        const double least = min_response(joint);
        for (int r = 0; r < rows; r++) {
            double& diagonal = block[r * (rows + 1)];
            joint.blocked[as_index(r)] = diagonal <= least && !joint.off[as_index(r)];
            if (diagonal <= least) diagonal = 0;
        }
    }
}

// Compliance of a spring row: from its force over the step if it is stretched, from its damping at
// velocity level.
void DirectGroup::soften(double h) {
    double* const values = matrix_.values().data();
    for (std::size_t k = 0; k < joints.size(); k++) {
        const DirectJoint& joint = joints[k];
        for (std::size_t i = 0; i < joint.free_axes.size(); i++) {
            const FreeAxis& free_axis = joint.free_axes[i];
            if (free_axis.rate == 0 || free_axis.at_limit != 0 || free_axis.is_held()) continue;
            const double compliance = free_axis.implicit
                                          ? 1 / (spring_pull(free_axis, h) * h)
                                          : 1 / maximum(free_axis.damper, min_damper);
            if (!free_axis.implicit && !free_axis.is_damped()) continue;
            const int row = joint.first_free_axis() + static_cast<int>(i),
                      node = static_cast<int>(k);
            values[matrix_.block_at(node, node) + row * (joint.rows() + 1)] += compliance;
        }
    }
}

}  // namespace jostle::physics
