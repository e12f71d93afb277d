// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/predicted_pair.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/constraints/write_manifold.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

SweptShape swept(const ShapedBodies& stores, std::uint32_t body, std::uint32_t shape, double dt) {
    const ShapeRecord& s = stores.shapes.shapes[shape];
    const BodyWarm& warm = warm_of(stores, body);
    return {&s.geometry,
            s.offset,
            s.axes,
            stores.bodies.cold[body].radius,
            {0, warm.center, warm.rotation, warm.v * dt, warm.w * dt}};
}

struct PredictedPose {
    Vec3 center;
    Mat3 axes;

    TransformedShape place(const ShapeRecord& shape) const {
        return {&shape.geometry, center + axes * shape.offset,
                shape.aligned ? axes : axes * shape.axes};
    }
};

// The pose of a body at a time from the start of the step, at its current velocities.
PredictedPose predicted_pose(const BodyWarm& warm, double time) {
    if (time == 0 || (warm.v == Vec3{} && warm.w == Vec3{})) return {warm.center, warm.axes};
    return {warm.center + warm.v * time,
            to_matrix(from_rotation_vector(warm.w * time) * warm.rotation)};
}

}  // namespace

PredictedPair::Side::Side(const ShapedBodies& stores, std::uint32_t body, std::uint32_t shape_index,
                          double time) {
    const BodyWarm& warm = warm_of(stores, body);
    const PredictedPose pose = predicted_pose(warm, time);
    v = warm.v;
    w = warm.w;
    center = pose.center;
    shape = pose.place(stores.shapes.shapes[shape_index]);
}

Vec3 PredictedPair::Side::velocity_at(Vec3 point) const {
    return v + cross(w, point - center);
}

PredictedPair::PredictedPair(const ShapedBodies& stores, const Contact& contact, double time)
    : time_(time),
      anchor_blend_(time == 0 ? 0 : anchor_blend_of(stores, contact)),
      a_(stores, contact.body_a, contact.shape_a, time),
      b_(stores, contact.body_b, contact.shape_b, time) {}

void PredictedPair::rewind_manifold(Manifold& m, double displacement) const {
    ASSERT(anchor_blend_ >= 0 && anchor_blend_ <= 1);
    if (time_ == 0) return;
    const Vec3 carried = (a_.v + (b_.v - a_.v) * anchor_blend_) * time_;
    for (int i = 0; i < m.count; i++) {
        const Vec3 apart = b_.velocity_at(m.point[i]) - a_.velocity_at(m.point[i]);
        m.gap[i] -= dot(m.normal, apart) * time_;
        m.point[i] -= carried;
    }
    m.distance = m.count > 0 ? smallest_gap(m) : m.distance - displacement;
}

// The forces of n sub-steps act at their starts, on average (n - 1) / 2n of a step after its start.
// The prediction is limited to half the thickness, because a body may be stopped before it gets
// there.
double time_of_forces(const ContactGraph& stores, const Contact& c, double displacement,
                      double dt) {
    if (displacement < tuning::noticed_motion * scale_of_pair(stores.bodies, c)) return 0;
    const BodyCold &a = stores.bodies.cold[c.body_a], &b = stores.bodies.cold[c.body_b];
    const double thin =
        b.type == BodyType::dynamic ? minimum(a.inner_radius, b.inner_radius) : a.inner_radius;
    const int n = substeps_of(stores.islands.islands[a.island].colour_set, stores);
    return dt * minimum(0.5 - 0.5 / n, 0.5 * thin / displacement);
}

double midpoint_time(const ContactGraph& stores, const Contact& c, double displacement, double dt) {
    const bool touching = c.composite ? c.touching_children > 0 : c.touching;
    return touching ? time_of_forces(stores, c, displacement, dt) : 0;
}

std::optional<double> time_to_contact(const ShapedBodies& stores, const Contact& c, double dt) {
    const Impact impact = time_of_impact(swept(stores, c.body_a, c.shape_a, dt),
                                         swept(stores, c.body_b, c.shape_b, dt), 0,
                                         tuning::sweep_gap * scale_of_pair(stores.bodies, c));
    if (impact.at_start) return 0;
    if (impact.fraction > 1) return std::nullopt;
    return impact.fraction * dt;
}

TransformedShape predicted_shape(const ShapedBodies& stores, std::uint32_t shape, double time) {
    const ShapeRecord& record = stores.shapes.shapes[shape];
    return predicted_pose(warm_of(stores, record.body), time).place(record);
}

double smallest_gap(const Manifold& m) {
    double gap = m.distance;
    for (int i = 0; i < m.count; i++) gap = i == 0 ? m.gap[0] : minimum(gap, m.gap[i]);
    return gap;
}

}  // namespace jostle::physics
