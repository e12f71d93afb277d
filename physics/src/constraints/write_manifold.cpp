// SPDX-License-Identifier: MIT
#include "physics/src/constraints/write_manifold.h"

#include <atomic>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/effective_mass.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

// Impulses of a manifold before its rebuild, in world axes.
struct PreviousImpulses {
    int count = 0;
    Vec3 point[4];  // from a's centre of mass
    double lambda[4] = {}, mean_impulse[4] = {};
    Vec3 friction, roll;
};

PreviousImpulses previous_impulses(const ContactConstraintWide& block, const RollingWide& rolling,
                                   int lane) {
    PreviousImpulses c;
    const Vec3 n = get_lane(block.normal, lane), t1 = get_lane(block.tangent, lane),
               t2 = cross(n, t1);
    const Vec3 arm = get_lane(block.arm_a, lane);
    c.roll = t1 * double{rolling.roll[0][lane]} + t2 * double{rolling.roll[1][lane]};
    c.friction = t1 * double{block.friction[0][lane]} + t2 * double{block.friction[1][lane]};
    for (int i = 0; i < 4; i++) {
        if (block.gap[i][lane] > 0.5f * no_point) continue;
        c.point[c.count] = arm + t1 * double{block.x[i][lane]} + t2 * double{block.y[i][lane]};
        c.mean_impulse[c.count] = double{block.mean_impulse[i][lane]};
        c.lambda[c.count++] = double{block.lambda[i][lane]};
    }
    return c;
}

// Impulses of the points of a manifold after its rebuild.
struct Loads {
    double lambda[4] = {}, mean_impulse[4] = {};
};

// Each new point takes the impulse of the nearest old point within reach. The impulse of an old
// point without a successor (a tilting face rests on other corners) goes to the nearest new point
// without a predecessor, or else to the nearest new point: selecting other points does not change
// the load. `even`: the remembered impulse belongs to the manifold, not to its points
// (SolverTier::slender).
Loads redistribute_loads(const PreviousImpulses& old, const Manifold& m, Vec3 center, double reach,
                         bool even) {
    Loads loads;
    bool consumed[4] = {}, assigned[4] = {};
    ASSERT(old.count <= 4 && m.count >= 1 && reach >= 0);
    const auto distance2 = [&](int i, int j) {
        return length_squared(old.point[j] - (m.point[i] - center));
    };
    const auto transfer = [&](int i, int j) {
        loads.lambda[i] += old.lambda[j];
        loads.mean_impulse[i] += old.mean_impulse[j];
        consumed[j] = assigned[i] = true;
    };
    for (int i = 0; i < m.count; i++) {
        double nearest = reach * reach;
        int best = -1;
        for (int j = 0; j < old.count; j++)
            if (!consumed[j] && distance2(i, j) < nearest) {
                nearest = distance2(i, j);
                best = j;
            }
        if (best >= 0) transfer(i, best);
    }
    for (int j = 0; j < old.count; j++) {
        if (consumed[j] || (old.lambda[j] == 0 && old.mean_impulse[j] == 0)) continue;
        int best = 0;
        for (int i = 1; i < m.count; i++)
            if (assigned[i] == assigned[best] ? distance2(i, j) < distance2(best, j)
                                              : assigned[best])
                best = i;
        transfer(best, j);
    }
    if (even) {
        double sum = 0;
        for (int j = 0; j < old.count; j++) sum += old.mean_impulse[j];
        for (int i = 0; i < m.count; i++) loads.mean_impulse[i] = sum / m.count;
    }
    return loads;
}

// The points whose centre is the friction anchor. For a rim, only points that touch or may touch
// before the manifold is rebuilt; the other points represent the rest of the rim in case the body
// comes down. If they all counted, a disc rolling on its rim would be held at its centre and braked
// by the lever arm of a whole face.
struct SupportExtent {
    Vec3 centre;
    bool bearing[4] = {};
    int count = 0;
};

SupportExtent support_extent(const Manifold& m, bool rim, double scale) {
    double reach = m.gap[0];
    for (int i = 1; i < m.count; i++) reach = minimum(reach, m.gap[i]);
    reach = maximum(reach, 0) + tuning::reuse_distance * scale;
    SupportExtent f;
    for (int i = 0; i < m.count; i++) {
        f.bearing[i] = !rim || m.gap[i] <= reach;
        f.count += f.bearing[i] ? 1 : 0;
    }
    for (int i = 0; i < m.count; i++)
        if (f.bearing[i]) f.centre += m.point[i] * (1.0 / f.count);
    ASSERT(f.count >= 1);
    return f;
}

bool has_rim(const ShapeStore& shapes, const Contact& contact) {
    const auto rim = [&](std::uint32_t shape) {
        const ShapeKind kind = kind_of(shapes.shapes[shape].geometry);
        return kind == ShapeKind::cylinder || kind == ShapeKind::cone;
    };
    return rim(contact.shape_a) || rim(contact.shape_b);
}

// Lever arm of the small patch in which real round bodies touch.
double patch_of(const ShapeStore& store, const Contact& contact) {
    const auto rounding = [&](std::uint32_t shape) {
        const Geometry& g = store.shapes[shape].geometry;
        if (const auto* sphere = std::get_if<Sphere>(&g)) return sphere->radius;
        if (const auto* capsule = std::get_if<Capsule>(&g)) return capsule->radius;
        return 0.0;
    };
    const double a = rounding(contact.shape_a), b = rounding(contact.shape_b);
    return tuning::contact_patch * (a > 0 && b > 0 ? minimum(a, b) : maximum(a, b));
}

// Rolling, torsional friction and moving surfaces.
void write_rolling(const ContactLaneRef& lane_ref, const Material& ma, const Material& mb,
                   Vec3 surface, Vec3 roll) {
    RollingWide& rolling = *lane_ref.rolling;
    const int lane = lane_ref.lane;
    const Vec3 n = get_lane(lane_ref.block->normal, lane),
               t1 = get_lane(lane_ref.block->tangent, lane);
    const Vec3 t2 = cross(n, t1);
    rolling.surface[0][lane] = as_float(dot(surface, t1));
    ASSERT(is_unit(n, 1e-4) && is_unit(t1, 1e-4));
    rolling.surface[1][lane] = as_float(dot(surface, t2));
    rolling.rolling[lane] = as_float(maximum(ma.rolling_friction, mb.rolling_friction));
    rolling.torsional_friction[lane] =
        as_float(maximum(ma.torsional_friction, mb.torsional_friction));
    rolling.roll[0][lane] = as_float(dot(roll, t1));
    rolling.roll[1][lane] = as_float(dot(roll, t2));
}

bool has_rolling(const RollingWide& rolling, int lane) {
    return rolling.surface[0][lane] != 0 || rolling.surface[1][lane] != 0 ||
           rolling.rolling[lane] != 0 || rolling.torsional_friction[lane] != 0;
}

// Disables a manifold without points.
void disable(ContactConstraintWide& block, int lane) {
    for (int i = 0; i < 4; i++) {
        block.gap[i][lane] = no_point;
        block.lambda[i][lane] = block.mean_impulse[i][lane] = 0;
    }
    block.friction[0][lane] = block.friction[1][lane] = block.torsion[lane] = 0;
}

// The lanes of a block share a byte, and other threads may write other bits of it.
void put_bit(std::uint8_t& bits, int lane, bool on) {
    const std::atomic_ref shared(bits);
    const auto bit = static_cast<std::uint8_t>(1u << lane);
    if (((shared.load(std::memory_order_relaxed) & bit) != 0) == on) return;
    if (on)
        shared.fetch_or(bit, std::memory_order_relaxed);
    else
        shared.fetch_and(static_cast<std::uint8_t>(~bit), std::memory_order_relaxed);
}

}  // namespace

double anchor_blend_of(const ShapedBodies& stores, const Contact& contact) {
    if (stores.bodies.cold[contact.body_b].type != BodyType::dynamic) return 0;
    const auto is_round = [&](std::uint32_t shape) {
        const ShapeKind kind = kind_of(stores.shapes.shapes[shape].geometry);
        return kind == ShapeKind::sphere || kind == ShapeKind::capsule ||
               kind == ShapeKind::cylinder || kind == ShapeKind::cone;
    };
    const bool round_a = is_round(contact.shape_a), round_b = is_round(contact.shape_b);
    if (round_a == round_b) return 0.5;
    return round_a ? 0 : 1;
}

void write_manifold(ContactGraph& stores, const Contact& contact, const Manifold& m, bool fresh) {
    ASSERT(m.count >= 1 && m.count <= 4);
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, contact);
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    const PreviousImpulses old =
        fresh ? PreviousImpulses{} : previous_impulses(block, *lane_ref.rolling, lane);
    const Vec3 center_a = warm_of(stores, contact.body_a).center,
               center_b = warm_of(stores, contact.body_b).center;

    const SupportExtent support =
        support_extent(m, has_rim(stores.shapes, contact), scale_of_pair(stores.bodies, contact));
    const Vec3 centre = support.centre;
    ASSERT(support.count >= 1 && is_unit(m.normal, 1e-5));
    // Damaged geometry may have no normal.
    const Vec3 n = length_squared(m.normal) > 0.5 ? m.normal : Vec3{0, 1, 0};
    const Vec3 t1 = stores.def.planar
                        ? Vec3{-n.y, n.x, 0}
                        : normalized(cross(n, absolute(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
    const Vec3 t2 = cross(n, t1), arm_a = centre - center_a, arm_b = centre - center_b;
    put_lane(block.normal, lane, n);
    put_lane(block.tangent, lane, t1);
    put_lane(block.arm_a, lane, arm_a);
    put_lane(block.arm_b, lane, arm_b);

    const BodyCold &ca = stores.bodies.cold[contact.body_a],
                   &cb = stores.bodies.cold[contact.body_b];
    const double size = size_of_pair(ca, cb);
    ASSERT(ca.type == BodyType::dynamic && size > 0);
    const double reach =
        minimum(tuning::match_distance * size_scale(size), tuning::match_fraction * size);
    const Loads loads =
        redistribute_loads(old, m, center_a, reach, contact.colour_set.tier > SolverTier::pile);
    double friction_radius = 0;
    for (int i = 0; i < 4; i++) {
        const bool used = i < m.count;
        const Vec3 r = used ? m.point[i] - centre : Vec3{};
        const double x = dot(r, t1), y = dot(r, t2);
        block.x[i][lane] = as_float(x);
        block.y[i][lane] = as_float(y);
        block.gap[i][lane] = used ? as_float(m.gap[i]) : no_point;
        block.lambda[i][lane] = as_float(loads.lambda[i]);
        block.mean_impulse[i][lane] = as_float(loads.mean_impulse[i]);
        if (support.bearing[i]) friction_radius += square_root(x * x + y * y) / support.count;
    }
    block.friction_radius[lane] =
        as_float(maximum(friction_radius, patch_of(stores.shapes, contact)));
    block.anchor_blend[lane] = as_float(anchor_blend_of(stores, contact));
    block.friction[0][lane] = as_float(dot(old.friction, t1));
    block.friction[1][lane] = as_float(dot(old.friction, t2));
    if (fresh) block.torsion[lane] = 0;
    write_effective_mass(stores, stores.graph, contact, {n, t1, arm_a, arm_b});

    const Material& ma = stores.shapes.shapes[contact.shape_a].material;
    const Material& mb = stores.shapes.shapes[contact.shape_b].material;
    const ContactModifier modifier = modifier_of(stores, contact);
    if (!modifier.enabled) disable(block, lane);
    ASSERT(modifier.friction >= 0 && modifier.restitution >= 0);
    block.mu[lane] = as_float(modifier.friction);
    write_rolling(lane_ref, ma, mb, modifier.surface_velocity, old.roll);
    ContactConstraintWideMeta& meta = *lane_ref.meta;
    meta.restitution[lane] = as_float(modifier.restitution);
    meta.moved[lane] = 0;
    put_bit(meta.bits(LaneFlag::bounces), lane, meta.restitution[lane] > 0);
    put_bit(meta.bits(LaneFlag::rolls), lane, has_rolling(*lane_ref.rolling, lane));
    put_bit(meta.bits(LaneFlag::needs_rebuild), lane, false);
    ASSERT(meta.contact[lane] < stores.contacts.contacts.size());
}

}  // namespace jostle::physics
