// SPDX-License-Identifier: MIT
#include "constraints/joints/joint_rows.h"

namespace jostle::physics {
namespace {

Vec3 vec(const float* f) {
    return {double{f[0]}, double{f[1]}, double{f[2]}};
}
void put(float* f, Vec3 v) {
    f[0] = static_cast<float>(v.x);
    f[1] = static_cast<float>(v.y);
    f[2] = static_cast<float>(v.z);
}

Vec3 across(const Mat3& inverse_inertia, Vec3 arm, Vec3 v) {
    return cross(inverse_inertia * cross(arm, v), arm);
}

// Solves the part of a symmetric 3x3 matrix that is not singular: locked axes leave zero rows.
Vec3 solve3(const Mat3& m, Vec3 v) {
    const double det = determinant(m);
    const double scale = maximum(m.x.x, maximum(m.y.y, m.z.z));
    if (det > 1e-12 * scale * scale * scale) return inverse(m) * v;
    Vec3 out;
    for (int k = 0; k < 3; k++) {
        const double d = k == 0 ? m.x.x : (k == 1 ? m.y.y : m.z.z);
        out[k] = d > 1e-12 * scale && d > 0 ? v[k] / d : 0;
    }
    return out;
}

Softness of(const JointStep& step, const Softness& softness) {
    return step.relax ? Softness{} : softness;
}

}  // namespace

JointPair::JointPair(JointWork& work, std::span<HotBody> bodies) : work_(work) {
    const HotBody &a = bodies[work.a.hot], &b = bodies[work.b.hot];
    const Quat turn_a = from_rotation_vector(vec(a.dr)), turn_b = from_rotation_vector(vec(b.dr));
    arm_a = rotate(turn_a, work.a.arm);
    arm_b = rotate(turn_b, work.b.arm);
    frame_a = turn_a * work.a.frame;
    frame_b = turn_b * work.b.frame;
    carrier = work.b.pushed ? turn_b * work.b.body : turn_a * work.a.body;
    apart = work.apart + (vec(b.dp) - vec(a.dp)) + ((arm_b - work.b.arm) - (arm_a - work.a.arm));
    va = vec(a.v);
    wa = vec(a.w);
    vb = vec(b.v);
    wb = vec(b.w);
    start_va_ = va;
    start_wa_ = wa;
    start_vb_ = vb;
    start_wb_ = wb;
}

void JointPair::store(std::span<HotBody> bodies) {
    const auto write = [&](JointSide& side, Vec3 v, Vec3 w, Vec3 old_v, Vec3 old_w) {
        if (!side.pushed) return;
        put(bodies[side.hot].v, v);
        put(bodies[side.hot].w, w);
        side.given_v += v - old_v;
        side.given_w += w - old_w;
    };
    write(work_.a, va, wa, start_va_, start_wa_);
    write(work_.b, vb, wb, start_vb_, start_wb_);
}

void JointPair::push(Vec3 impulse) {
    va -= scaled(work_.a.inverse_mass, impulse);
    wa -= work_.a.inverse_inertia * cross(arm_a, impulse);
    vb += scaled(work_.b.inverse_mass, impulse);
    wb += work_.b.inverse_inertia * cross(arm_b, impulse);
}

void JointPair::turn(Vec3 impulse) {
    wa -= work_.a.inverse_inertia * impulse;
    wb += work_.b.inverse_inertia * impulse;
}

Mat3 JointPair::point_matrix() const {
    const Vec3 mass = work_.a.inverse_mass + work_.b.inverse_mass;
    const auto column = [&](Vec3 unit) {
        return scaled(mass, unit) + across(work_.a.inverse_inertia, arm_a, unit) +
               across(work_.b.inverse_inertia, arm_b, unit);
    };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

double JointPair::inverse_mass_along(Vec3 unit) const {
    const Vec3 mass = work_.a.inverse_mass + work_.b.inverse_mass;
    const Vec3 ta = cross(arm_a, unit), tb = cross(arm_b, unit);
    return dot(scaled(mass, unit), unit) + dot(ta, work_.a.inverse_inertia * ta) +
           dot(tb, work_.b.inverse_inertia * tb);
}

void hold_points(JointPair& pair, const JointStep& step, const Softness& softness, Vec3& impulse) {
    const Softness s = of(step, softness);
    const Vec3 error = pair.anchor_velocity() + pair.apart * s.bias_rate;
    const Vec3 d = solve3(pair.point_matrix(), error) * -s.mass_scale - impulse * s.impulse_scale;
    impulse += d;
    pair.push(d);
}

void hold_turns(JointPair& pair, const JointStep& step, const Softness& softness, Vec3 error,
                Vec3& impulse) {
    const Softness s = of(step, softness);
    const Vec3 d = solve3(pair.turn_matrix(), pair.spin() + error * s.bias_rate) * -s.mass_scale -
                   impulse * s.impulse_scale;
    impulse += d;
    pair.turn(d);
}

void hold_axis(JointPair& pair, const JointStep& step, const Softness& softness, Vec3 axis,
               Vec3 error, Vec3& impulse) {
    const Softness s = of(step, softness);
    const Vec3 p = normalized(cross(axis, absolute(axis.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 q = cross(axis, p);
    const Mat3 k = pair.turn_matrix();
    const double pp = dot(p, k * p), pq = dot(p, k * q), qq = dot(q, k * q);
    const double det = pp * qq - pq * pq;
    if (!(det > 1e-12 * pp * qq)) return;
    const Vec3 want = pair.spin() + error * s.bias_rate;
    const double ep = dot(p, want), eq = dot(q, want);
    // What accumulated in the step before lies across the axis as it was then.
    impulse -= axis * dot(axis, impulse);
    const Vec3 d = (p * (qq * ep - pq * eq) + q * (pp * eq - pq * ep)) * (-s.mass_scale / det) -
                   impulse * s.impulse_scale;
    impulse += d;
    pair.turn(d);
}

Row angle_row(const JointPair& pair, Vec3 axis) {
    return {axis, true, pair.inverse_spin_about(axis)};
}
Row length_row(const JointPair& pair, Vec3 line) {
    return {line, false, pair.inverse_mass_along(line)};
}

namespace {

double speed_of(const JointPair& pair, const Row& row) {
    return dot(row.direction, row.angular ? pair.spin() : pair.anchor_velocity());
}

}  // namespace

void apply_row(JointPair& pair, const Row& row, double impulse) {
    if (row.angular)
        pair.turn(row.direction * impulse);
    else
        pair.push(row.direction * impulse);
}

void limit_row(JointPair& pair, const JointStep& step, const Row& row, double room,
               double& impulse) {
    if (!(row.inverse_mass > 0)) return;
    Softness s;
    double bias = 0;
    if (room > 0) {
        bias = room * step.inverse_h;  // may be used up within the sub-step, no more
    } else if (!step.relax) {
        s = step.rigid;
        bias = room * s.bias_rate;
    }
    const double now =
        maximum(0, impulse - s.mass_scale * (speed_of(pair, row) + bias) / row.inverse_mass -
                       s.impulse_scale * impulse);
    apply_row(pair, row, now - impulse);
    impulse = now;
}

void spring_row(JointPair& pair, const Row& row, const Softness& s, double error, double& impulse) {
    if (!(row.inverse_mass > 0)) return;
    const double d =
        -s.mass_scale * (speed_of(pair, row) + error * s.bias_rate) / row.inverse_mass -
        s.impulse_scale * impulse;
    impulse += d;
    apply_row(pair, row, d);
}

void motor_row(JointPair& pair, const Row& row, double speed, double most, double& impulse) {
    if (!(row.inverse_mass > 0)) return;
    const double now =
        clamp(impulse - (speed_of(pair, row) - speed) / row.inverse_mass, -most, most);
    apply_row(pair, row, now - impulse);
    impulse = now;
}

}  // namespace jostle::physics
