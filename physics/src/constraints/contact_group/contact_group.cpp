// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_group/contact_group.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

// Of one iteration, in products of blocks: measured for boxes.
constexpr std::int64_t work_per_manifold = 20;

std::size_t index(int i) {
    ASSERT(i >= 0);
    return static_cast<std::size_t>(i);
}

// Square root of a symmetric matrix that is positive semidefinite: locked axes are zero.
void put_root(const SolverBody& body, double* root) {
    const float* inertia = body.inertia;
    const double a[9] = {inertia[0], inertia[3], inertia[4], inertia[3], inertia[1],
                         inertia[5], inertia[4], inertia[5], inertia[2]};
    std::fill(root, root + 9, 0.0);
    const double least = 1e-7 * maximum(a[0], maximum(a[4], a[8]));
    for (int j = 0; j < 3; j++) {
        double pivot = a[4 * j];
        for (int k = 0; k < j; k++) pivot -= root[3 * j + k] * root[3 * j + k];
        if (!(pivot > least)) continue;
        root[4 * j] = square_root(pivot);
        for (int i = j + 1; i < 3; i++) {
            double sum = a[3 * i + j];
            for (int k = 0; k < j; k++) sum -= root[3 * i + k] * root[3 * j + k];
            root[3 * i + j] = sum / root[4 * j];
        }
    }
}

template <class Root>
void put_scaled(const Root& root, const double* j, double* g) {
    for (int k = 0; k < 3; k++) g[k] = root.linear[k] * j[k];
    const double* c = root.angular;
    g[3] = c[0] * j[3] + c[3] * j[4] + c[6] * j[5];
    g[4] = c[4] * j[4] + c[7] * j[5];
    g[5] = c[8] * j[5];
}

void put(double* row, Vec3 linear, Vec3 angular) {
    row[0] = linear.x, row[1] = linear.y, row[2] = linear.z;
    row[3] = angular.x, row[4] = angular.y, row[5] = angular.z;
}

// The manifold at the poses of the current sub-step, as PairBodies::follow() in contact_kernel.h.
struct Followed {
    Vec3 arm_a, arm_b, moved, rotated;
};
Followed follow(const ManifoldOfGroup& manifold, const SolverBody& a, const SolverBody* b,
                double ahead) {
    const ContactConstraintWide& m = *manifold.lane_ref.block;
    const int lane = manifold.lane_ref.lane;
    Followed f{get_lane(m.arm_a, lane), get_lane(m.arm_b, lane), {}, {}};
    const Vec3 dp_a = to_vec3(a.dp), dr_a = to_vec3(a.dr);
    const Vec3 dp_b = b != nullptr ? to_vec3(b->dp) : Vec3{},
               dr_b = b != nullptr ? to_vec3(b->dr) : Vec3{};
    f.moved = (dp_b + cross(dr_b, f.arm_b)) - (dp_a + cross(dr_a, f.arm_a));
    f.rotated = dr_b - dr_a;
    if (manifold.mover != nullptr)
        f.arm_b = f.arm_b + (dp_a - dp_b) + (to_vec3(a.v) - to_vec3(b->v)) * ahead;
    if (manifold.b < 0) return f;
    const Vec3 displacement = dp_b - dp_a;
    if (length_squared(displacement) >= double{tuning::arm_follows} * length_squared(f.arm_a))
        return f;
    const Vec3 step_a = displacement * double{m.anchor_blend[lane]};
    f.arm_a = f.arm_a + step_a;
    f.arm_b = f.arm_b + (step_a - displacement);
    return f;
}

}  // namespace

void ContactGroup::set(std::vector<SolverBody*> bodies, std::vector<ManifoldOfGroup> contacts,
                       std::int64_t max_work) {
    bodies_ = std::move(bodies);
    manifolds_ = std::move(contacts);
    std::vector<int> first(bodies_.size());
    for (std::size_t i = 0; i < first.size(); i++) first[i] = static_cast<int>(i);
    for (const ManifoldOfGroup& contact : manifolds_) {
        ASSERT(index(contact.a) < bodies_.size() && contact.a != contact.b);
        if (contact.b < 0) continue;
        int& other = first[index(std::max(contact.a, contact.b))];
        other = std::min(other, std::min(contact.a, contact.b));
    }
    matrix_.set_pattern(first);
    impulses_.clear();
    unsolved_ = 0;
    missed_ = false;
    work_ = 0;
    max_work_ = max_work;
}

void ContactGroup::load_bodies() {
    roots_.resize(bodies_.size());
    problem_.root.resize(bodies_.size());
    free_.resize(6 * bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); i++) {
        const SolverBody& body = *bodies_[i];
        RootMass& root = roots_[i];
        const double linear = square_root(double{body.inverse_mass});
        root.linear[0] = linear * double{body.free_x};
        root.linear[1] = linear * double{body.free_y};
        root.linear[2] = linear * double{body.free_z};
        put_root(body, root.angular);
        problem_.root[i] = linear;
        put(&free_[6 * i], to_vec3(body.free), to_vec3(body.free + 3));
    }
}

GroupRow& ContactGroup::add_row(const ManifoldOfGroup& manifold, Vec3 direction, Vec3 turn_a,
                                Vec3 turn_b) {
    GroupRow& row = problem_.rows.emplace_back();
    row.a = manifold.a;
    row.b = manifold.b;
    double j[6];
    put(j, -direction, -turn_a);
    put_scaled(roots_[index(row.a)], j, row.ga);
    row.response = dot6(row.ga, row.ga);
    row.offset = dot6(j, &free_[6 * index(row.a)]);
    put(j, direction, turn_b);
    if (row.b >= 0) {
        put_scaled(roots_[index(row.b)], j, row.gb);
        row.response += dot6(row.gb, row.gb);
        row.offset += dot6(j, &free_[6 * index(row.b)]);
    } else if (manifold.mover != nullptr) {
        double v[6];
        put(v, to_vec3(manifold.mover->v), to_vec3(manifold.mover->w));
        row.offset += dot6(j, v);
    }
    row.free = row.offset;
    return row;
}

// Rows that nothing can move are left out.
void ContactGroup::add_disc(int first, int size, double factor) {
    for (int k = 0; k < size; k++)
        if (!(problem_.row(first + k).response > 0)) factor = 0;
    if (!(factor > 0)) {
        for (int k = 0; k < size; k++) problem_.row(first + k).impulse = 0;
        return;
    }
    problem_.discs.push_back({first, size, factor});
    problem_.contacts.back().discs++;
}

void ContactGroup::load_manifold(const ContactSettings& settings, const ManifoldOfGroup& manifold,
                                 bool relaxing) {
    const ContactConstraintWide& m = *manifold.lane_ref.block;
    const ContactConstraintWideMeta& meta = *manifold.lane_ref.meta;
    const int lane = manifold.lane_ref.lane;
    const SolverBody& a = *bodies_[index(manifold.a)];
    const SolverBody* b = manifold.b >= 0 ? bodies_[index(manifold.b)] : manifold.mover;
    const Vec3 n = get_lane(m.normal, lane), t1 = get_lane(m.tangent, lane), t2 = cross(n, t1);
    const double ahead = (relaxing ? -0.5 : 0.5) * double{settings.h};
    const Followed at = follow(manifold, a, b, ahead);
    const double size = double{std::bit_cast<float>(std::uint32_t{meta.size[lane]} << 16)};
    const double gravity = double{settings.gravity_ratio};
    const double slop = double{settings.slop} * size_scale(size),
                 push = double{settings.push_speed} * speed_scale(size, gravity * gravity);
    const double s0 = dot(n, at.moved), s1 = dot(t1, at.rotated), s2 = dot(t2, at.rotated);

    problem_.contacts.push_back({static_cast<int>(problem_.rows.size()), 0,
                                 static_cast<int>(problem_.discs.size()), 0, manifold.load});
    for (int i = 0; i < 4; i++) {
        const double x = double{m.x[i][lane]}, y = double{m.y[i][lane]};
        const double start = double{m.gap[i][lane]};
        if (start > 0.5 * double{no_point}) continue;
        const double gap = start + s0 + y * s1 - x * s2;
        const Vec3 tilt = t1 * y - t2 * x;
        GroupRow& row = add_row(manifold, n, cross(at.arm_a, n) + tilt, cross(at.arm_b, n) + tilt);
        row.impulse = double{m.lambda[i][lane]};
        if (gap > 0)
            row.offset += gap * double{settings.inverse_h};
        else if (!relaxing)
            row.offset += maximum(minimum((gap + slop) * double{settings.bias_rate}, 0), -push);
        problem_.contacts.back().points++;
    }
    const RollingWide* rolling = manifold.lane_ref.rolling;
    const bool rolls = meta.has(LaneFlag::rolls, lane);
    const int first = static_cast<int>(problem_.rows.size());
    for (int k = 0; k < 2; k++) {
        const Vec3 t = k == 0 ? t1 : t2;
        GroupRow& row = add_row(manifold, t, cross(at.arm_a, t), cross(at.arm_b, t));
        row.impulse = double{m.friction[k][lane]};
        if (rolls) row.offset += double{rolling->surface[k][lane]};
    }
    const double mu = double{m.mu[lane]};
    add_disc(first, 2, mu);
    add_row(manifold, {}, n, n).impulse = double{m.torsion[lane]};
    add_disc(first + 2, 1,
             maximum(mu * double{m.friction_radius[lane]},
                     rolls ? double{rolling->torsional_friction[lane]} : 0));
    if (!rolls) return;
    for (int k = 0; k < 2; k++) {
        const Vec3 t = k == 0 ? t1 : t2;
        add_row(manifold, {}, t, t).impulse = double{rolling->roll[k][lane]};
    }
    add_disc(first + 3, 2, double{rolling->rolling[lane]});
}

void ContactGroup::store_velocities() const {
    for (std::size_t i = 0; i < bodies_.size(); i++) {
        SolverBody& body = *bodies_[i];
        for (int k = 0; k < 3; k++) {
            body.v[k] = static_cast<float>(velocity_[6 * i + index(k)]);
            body.w[k] = static_cast<float>(velocity_[6 * i + 3 + index(k)]);
        }
    }
}

void ContactGroup::store() const {
    if (impulses_.empty()) return;
    store_velocities();
    store_impulses();
}

void ContactGroup::store_impulses() const {
    for (std::size_t k = 0; k < manifolds_.size(); k++) {
        const ContactLaneRef& lane_ref = manifolds_[k].lane_ref;
        ContactConstraintWide& m = *lane_ref.block;
        const int lane = lane_ref.lane;
        int row = problem_.contacts[k].first;
        const auto next = [&] { return static_cast<float>(problem_.row(row++).impulse); };
        // Sweeps pull impulses towards their means, which must not lag behind.
        for (int i = 0; i < 4; i++)
            if (!(m.gap[i][lane] > 0.5f * no_point))
                m.lambda[i][lane] = m.mean_impulse[i][lane] = next();
        m.friction[0][lane] = next();
        m.friction[1][lane] = next();
        m.torsion[lane] = next();
        if (!lane_ref.meta->has(LaneFlag::rolls, lane)) continue;
        lane_ref.rolling->roll[0][lane] = next();
        lane_ref.rolling->roll[1][lane] = next();
    }
}

// Sets y_ to the effect of the impulses before the pass. Returns whether they add energy: impulses
// that press light bodies from both sides do, because the bodies have moved.
bool ContactGroup::start_adds_energy(double usual_speed) {
    std::fill(y_.begin(), y_.end(), 0.0);
    double energy = 0, allowed = 0;
    for (std::size_t i = 0; i < start_.size(); i++) {
        energy += start_[i] * problem_.rows[i].free;
        add_impulse(problem_.rows[i], start_[i], y_);
    }
    for (const double y : y_) energy += 0.5 * y * y;
    for (const SolverBody* body : bodies_)
        allowed += usual_speed * usual_speed / double{body->inverse_mass};
    return energy > allowed;
}

bool ContactGroup::find_solution(double tolerance) {
    if (unsolved_ >= max_unsolved || work_ >= max_work_) return false;
    if (!impulses_.empty() && solver_.still_solves(problem_, y_, tolerance)) return true;
    const bool solved = solver_.solve(problem_, matrix_, y_, tolerance);
    work_ +=
        solver_.iterations() * (matrix_.products() + work_per_manifold * std::ssize(manifolds_));
    if (!solved) unsolved_++;
    return solved;
}

bool ContactGroup::run(const ContactSettings& settings, bool relaxing) {
    load_bodies();
    problem_.clear(static_cast<int>(bodies_.size()));
    for (const ManifoldOfGroup& manifold : manifolds_) load_manifold(settings, manifold, relaxing);
    y_.resize(free_.size());
    const double tolerance = relative_tolerance * tuning::usual_gravity *
                             double{settings.gravity_ratio} * double{settings.h};
    // Within a step the rows keep their meaning, and their impulses are known in double precision.
    ASSERT(impulses_.empty() || impulses_.size() == problem_.rows.size());
    for (std::size_t i = 0; i < impulses_.size(); i++) problem_.rows[i].impulse = impulses_[i];
    start_.resize(problem_.rows.size());
    for (std::size_t i = 0; i < start_.size(); i++) start_[i] = problem_.rows[i].impulse;
    const bool solved = find_solution(tolerance);
    missed_ = missed_ || !solved;
    impulses_.clear();
    if (solved) {
        for (const GroupRow& row : problem_.rows) impulses_.push_back(row.impulse);
    } else {
        for (std::size_t i = 0; i < start_.size(); i++) problem_.rows[i].impulse = start_[i];
        if (start_adds_energy(tolerance / relative_tolerance)) {
            std::fill(y_.begin(), y_.end(), 0.0);
            for (GroupRow& row : problem_.rows) row.impulse = 0;
        }
    }
    velocity_ = free_;
    for (std::size_t i = 0; i < bodies_.size(); i++) {
        const double* y = &y_[6 * i];
        double* v = &velocity_[6 * i];
        for (int k = 0; k < 3; k++) v[k] += roots_[i].linear[k] * y[k];
        const double* c = roots_[i].angular;
        v[3] += c[0] * y[3];
        v[4] += c[3] * y[3] + c[4] * y[4];
        v[5] += c[6] * y[3] + c[7] * y[4] + c[8] * y[5];
    }
    store_velocities();
    store_impulses();
    return solved;
}

}  // namespace jostle::physics
