// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/apply_joint_impacts.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/constraints/impact.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

// An impulse propagates through a row of this many pairs in a step, and continues in the next one.
constexpr int max_rounds = 64;

struct JointImpact {
    const ContactConstraintWide* block;
    const ContactConstraintWideMeta* meta;
    int lane;
    double closing = 0;  // m/s
};

Vec3 solver_velocity_at(const SolverBody& body, Vec3 arm) {
    return to_vec3(body.v) + cross(to_vec3(body.w), arm);
}

// A manifold with an impact within the step: its points at that time, relative to the centre of a.
struct JointImpactPoints {
    Vec3 center_b;  // relative to the centre of a
    std::vector<ImpactPoint> points;
    double closing = 0;  // m/s: of the fastest closing point
};

JointImpactPoints joint_impact_points(const SolverBodies& hot, const JointImpact& s, double dt) {
    const ContactConstraintWide& block = *s.block;
    const int k = s.lane;
    const SolverBody &a = hot[static_cast<std::size_t>(block.a[k])],
                     &b = hot[static_cast<std::size_t>(block.b[k])];
    const Vec3 n = get_lane(block.normal, k), t1 = get_lane(block.tangent, k), t2 = cross(n, t1);
    const Vec3 arm_a = get_lane(block.arm_a, k), arm_b = get_lane(block.arm_b, k);
    JointImpactPoints impact;
    double first = dt;  // s until the impact
    for (int i = 0; i < 4; i++) {
        const double gap{block.gap[i][k]};
        if (gap > 0.5 * double{no_point}) continue;
        const Vec3 in_plane = t1 * double{block.x[i][k]} + t2 * double{block.y[i][k]};
        const double closing = -dot(
            n, solver_velocity_at(b, arm_b + in_plane) - solver_velocity_at(a, arm_a + in_plane));
        if (closing <= tuning::restitution_speed || gap > closing * dt) continue;
        impact.closing = maximum(impact.closing, closing);
        impact.points.push_back({in_plane, n});
        first = minimum(first, maximum(gap, 0) / closing);
    }
    // The arms follow as in the solver (PairBodies::follow).
    const Vec3 apart = (solver_velocity_at(b, arm_b) - solver_velocity_at(a, arm_a)) * first;
    const Vec3 meets_a = arm_a + apart * double{block.anchor_blend[k]};
    for (ImpactPoint& p : impact.points) p.position += meets_a;
    impact.center_b = arm_a - arm_b + apart;
    return impact;
}

ImpactBody solver_impact_body(const SolverBody& hot, Vec3 center) {
    const auto at = [&](int k) { return double{hot.inertia[k]}; };
    return {
        .center = center,
        .inverse_mass = Vec3{double{hot.free_x}, double{hot.free_y}, double{hot.free_z}} *
                        double{hot.inverse_mass},
        .inverse_inertia = {{at(0), at(3), at(4)}, {at(3), at(1), at(5)}, {at(4), at(5), at(2)}},
        .v = to_vec3(hot.v),
        .w = to_vec3(hot.w)};
}

void set_solver_velocity(SolverBody& hot, const ImpactBody& body) {
    const Vec3 v = body.v, w = body.w;
    hot.v[0] = as_float(v.x), hot.v[1] = as_float(v.y), hot.v[2] = as_float(v.z);
    hot.w[0] = as_float(w.x), hot.w[1] = as_float(w.y), hot.w[2] = as_float(w.z);
}

// Returns whether there was an impact.
bool resolve_joint_impact(SolverBodies& hot, const JointImpact& s, double dt) {
    const JointImpactPoints impact = joint_impact_points(hot, s, dt);
    if (impact.points.empty()) return false;
    SolverBody &hot_a = hot[static_cast<std::size_t>(s.block->a[s.lane])],
               &hot_b = hot[static_cast<std::size_t>(s.block->b[s.lane])];
    ImpactBody a = solver_impact_body(hot_a, {}), b = solver_impact_body(hot_b, impact.center_b);
    resolve_impact(a, b, impact.points, double{s.meta->restitution[s.lane]},
                   double{s.block->mu[s.lane]});
    set_solver_velocity(hot_a, a);
    set_solver_velocity(hot_b, b);
    return true;
}

// Finds bouncing pairs in which a body has joints.
void find_bouncing_pairs(const BodyStore& bodies, const ContactStore& contacts,
                         const GraphColour& colour, std::vector<JointImpact>& found) {
    const auto jointed = [&](std::uint32_t body) { return bodies.cold[body].first_joint != none; };
    for (std::size_t k = 0; k < colour.metas.size(); k++) {
        const ContactConstraintWideMeta& meta = colour.metas[k];
        if (meta.bits(LaneFlag::bounces) == 0) continue;
        for (int lane = 0; lane < 8; lane++) {
            if (!meta.has(LaneFlag::bounces, lane) || meta.contact[lane] == no_contact) continue;
            const Contact& c = contacts.contacts[meta.contact[lane]];
            if (jointed(c.body_a) || jointed(c.body_b))
                found.push_back({&colour.blocks[k], &meta, lane});
        }
    }
}

}  // namespace

void apply_joint_impacts(StepContext& step, std::span<const ColourRun> runs) {
    std::vector<JointImpact> pairs;
    for (const ColourRun& run : runs) {
        if (pair_kind_of(run.number) != PairKind::dynamic) continue;
        find_bouncing_pairs(step.world.bodies, step.world.contacts, *run.colour, pairs);
        if (run.single != nullptr)
            find_bouncing_pairs(step.world.bodies, step.world.contacts, *run.single, pairs);
    }
    if (pairs.empty()) return;
    SolverBodies& hot = step.scratch.solver.hot;
    std::vector<JointImpact> closing;
    for (int round = 0; round < max_rounds; round++) {
        closing.clear();
        for (JointImpact& s : pairs) {
            s.closing = joint_impact_points(hot, s, step.dt).closing;
            if (s.closing > 0) closing.push_back(s);
        }
        // Ties are broken by contact, not by position: the islands of a task depend on the number
        // of threads.
        std::sort(closing.begin(), closing.end(), [](const JointImpact& x, const JointImpact& y) {
            return std::tuple(-x.closing, x.meta->contact[x.lane]) <
                   std::tuple(-y.closing, y.meta->contact[y.lane]);
        });
        bool any = false;
        for (const JointImpact& s : closing) any |= resolve_joint_impact(hot, s, step.dt);
        if (!any) return;
    }
}

}  // namespace jostle::physics
