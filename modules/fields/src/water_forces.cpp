// SPDX-License-Identifier: MIT
#include "modules/fields/src/water_forces.h"

#include <algorithm>
#include <array>

#include "modules/fields/src/wave_train.h"

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

// A corner of a submerged panel.
struct Corner {
    Vec3 arm;     // m, from the centre of mass
    double head;  // m of water
};

// Sums in m^3 and m^4 of water. Times density and gravity, they are N and N m.
struct WaterSums {
    Vec3 force, torque;
    Vec3 flow;  // m/s times m^2
    double area = 0;
};

// Pressure over a flat triangle with a head that is linear between its corners:
//     F = -n int p dA,   T = -int p r x n dA, and int p r dA = A/12 (sum p sum r + sum p r).
void add_triangle(const Corner& a, const Corner& b, const Corner& c, WaterSums& sums,
                  std::vector<WaterScratch::Wet>& wet) {
    const Vec3 area = cross(b.arm - a.arm, c.arm - a.arm) * 0.5;
    const double head = a.head + b.head + c.head;
    const Vec3 arms = a.arm + b.arm + c.arm;
    const Vec3 moment = arms * head + a.arm * a.head + b.arm * b.head + c.arm * c.head;
    sums.force -= area * (head * (1.0 / 3));
    sums.torque -= cross(moment, area) * (1.0 / 12);
    wet.push_back({area, arms * (1.0 / 3)});
}

// The submerged part of a triangle: 3 or 4 corners, clipped at depth zero.
void add_clipped_panel(const std::array<Corner, 3>& corners, const std::array<double, 3>& depth,
                       WaterSums& sums, std::vector<WaterScratch::Wet>& wet) {
    std::array<Corner, 4> left;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; k++) {
        const std::size_t next = (k + 1) % 3;
        if (depth[k] > 0) left[count++] = corners[k];
        if ((depth[k] > 0) == (depth[next] > 0)) continue;
        const double share = depth[k] / (depth[k] - depth[next]);
        left[count++] = {corners[k].arm + (corners[next].arm - corners[k].arm) * share, 0};
    }
    for (std::size_t k = 1; k + 1 < count; k++)
        add_triangle(left[0], left[k], left[k + 1], sums, wet);
}

// Removes torque that the true surface cannot have, but its panels can.
Vec3 without_symmetric_torque(const PanelSurface& surface, const Load& load, Vec3 force,
                              Vec3 torque) {
    const Vec3 arm = apply(load.body.pose, surface.center) - load.body.center;
    if (surface.ball > 0) return cross(arm, force);
    if (!surface.round) return torque;
    const Vec3 axis = rotate(load.body.pose.rotation, surface.axis);
    return torque - axis * dot(torque - cross(arm, force), axis);
}

// Mean velocity of the water over the submerged part. For a body that is short compared with the
// waves, the velocity at its middle; otherwise the mean over some vertices.
Vec3 mean_flow(const WaveTrain& train, const Load& load, const WaterScratch& scratch) {
    const std::vector<double>& depth = scratch.pressure.depth;
    Vec3 middle;
    double wet = 0;
    for (std::size_t k = 0; k < depth.size(); k++)
        if (depth[k] > 0) middle += scratch.arms[k], wet++;
    const WaveTrain::Sample sample = train.at(load.body.center + middle * (1 / wet));
    if (sample.depth > 0 && 8 * load.record.reach < train.shortest_wavelength())
        return sample.velocity;
    const std::size_t stride = 1 + depth.size() / 12;
    Vec3 sum;
    double count = 0;
    for (std::size_t k = 0; k<depth.size(); k += depth[k]> 0 ? stride : 1) {
        if (!(depth[k] > 0)) continue;
        sum += train.at(load.body.center + scratch.arms[k]).velocity;
        count++;
    }
    return sum * (1 / count);
}

void add_wet_panels(const PanelSurface& surface, const WaterScratch& scratch, WaterSums& sums,
                    std::vector<WaterScratch::Wet>& wet) {
    const std::vector<double>& depths = scratch.pressure.depth;
    const std::vector<double>& heads = scratch.pressure.head;
    for (const auto& t : surface.triangles) {
        const std::array<double, 3> depth{depths[t[0]], depths[t[1]], depths[t[2]]};
        const std::array<Corner, 3> corners{{{scratch.arms[t[0]], heads[t[0]]},
                                             {scratch.arms[t[1]], heads[t[1]]},
                                             {scratch.arms[t[2]], heads[t[2]]}}};
        if (depth[0] > 0 && depth[1] > 0 && depth[2] > 0)
            add_triangle(corners[0], corners[1], corners[2], sums, wet);
        else if (depth[0] > 0 || depth[1] > 0 || depth[2] > 0)
            add_clipped_panel(corners, depth, sums, wet);
    }
}

void add_surface(const WaveTrain& train, const PanelSurface& surface, const Load& load,
                 WaterScratch& scratch, WaterSums& sums) {
    const Mat3 axes = to_matrix(load.body.pose.rotation);
    const Vec3 origin = load.body.pose.position - load.body.center;
    scratch.arms.clear();
    for (const Vec3 vertex : surface.vertices) scratch.arms.push_back(origin + axes * vertex);
    train.sample_pressure(load.body.center, scratch.arms, load.record.reach + length(origin),
                          scratch.pressure);
    const std::vector<double>& depth = scratch.pressure.depth;
    const auto wet = std::ranges::count_if(depth, [](double d) { return d > 0; });
    if (wet == 0) return;
    WaterSums own;
    add_wet_panels(surface, scratch, own, scratch.wet);
    sums.force += own.force;
    sums.torque += without_symmetric_torque(surface, load, own.force, own.torque);
    const double area = surface.area * static_cast<double>(wet) / static_cast<double>(depth.size());
    sums.flow += mean_flow(train, load, scratch) * area;
    sums.area += area;
}

// A ball that is small compared with the waves, in closed form: the cap of it below the tangent
// plane of the surface (E. W. Weisstein, "Spherical Cap", MathWorld), in the pressure gradient at
// the middle of the cap.
void add_ball(const WaveTrain& train, const PanelSurface& surface, const Load& load,
              WaterScratch& scratch, WaterSums& sums) {
    const Vec3 arm = apply(load.body.pose, surface.center) - load.body.center;
    const Vec3 center = load.body.center + arm;
    const double r = surface.ball;
    // The distance to an inclined surface is shorter along its normal than vertically.
    const WaveTrain::Sample over = train.at(center);
    const double below = over.depth / square_root(1 + length_squared(over.slope));
    const double depth = clamp(r + below, 0, 2 * r);
    if (depth == 0) return;
    const double volume = pi * depth * depth * (3 * r - depth) / 3;
    const double lack = 2 * r - depth;
    const double middle = 0.75 * lack * lack / (3 * r - depth);  // below the centre
    const WaveTrain::Sample at = train.at(center - Vec3{0, middle, 0});
    const Vec3 force = at.lift * volume;
    sums.force += force;
    sums.torque += cross(arm, force);
    const double share = volume / (4.0 / 3 * pi * r * r * r), size = 4 * pi * r * r * share;
    sums.flow += at.velocity * size;
    sums.area += size;
    scratch.wet_balls += pi * r * r * share;
}

// Projected submerged area along the direction: the larger of the areas of both sides.
double wet_area(const WaterScratch& scratch, Vec3 direction) {
    double front = 0, back = 0;
    for (const WaterScratch::Wet& panel : scratch.wet) {
        const double projected = dot(panel.area, direction);
        (projected > 0 ? front : back) += absolute(projected);
    }
    return maximum(front, back) + scratch.wet_balls;
}

// Motion of the body at the middle of the sub-step. Pressure and gravity act half before and half
// after it, so a body that floats at rest is not damped.
struct Middle {
    Vec3 acceleration;  // m/s^2
    Vec3 turn;          // rad/s, change within half a sub-step
};

// Quadratic drag on the rotation about the axis a. Each panel moves along its normal at |w| a . (r
// x n), and each side of a body carries half of the drag. The torque is K |w|^2 with
//     K = density / 2 * drag * sum A |a . (r x n)|^3 / 2.
void drag_spin(const Waves& waves, Load& load, Vec3 turn,
               const std::vector<WaterScratch::Wet>& wet) {
    const Vec3 w = load.body.angular_velocity + turn;
    const double spin = length(w);
    if (!(spin > 1e-9) || waves.drag == 0) return;
    const Vec3 axis = w * (1 / spin);
    double sum = 0;
    for (const WaterScratch::Wet& panel : wet) {
        const double squared = length_squared(panel.area);
        const double sweep = absolute(dot(axis, cross(panel.arm, panel.area)));
        if (squared > 0) sum += sweep * sweep * sweep / squared;
    }
    const double torque = 0.25 * waves.density * waves.drag * sum;  // divided by spin^2
    const double inertia = dot(axis, load.inertia() * axis);
    if (inertia > 0) load.turn(w * (1 / (1 + torque / inertia * spin * load.h) - 1));
}

void apply_wave_damping(double rate, Vec3 flow, const Middle& middle, Load& load) {
    const double lost = 1 - 1 / (1 + rate * load.h);
    const Vec3 v = load.body.linear_velocity + middle.acceleration * (0.5 * load.h);
    load.push((flow - v) * (load.body.mass * lost));
    load.turn((load.body.angular_velocity + middle.turn) * -lost);
}

Middle middle_of(const Load& load, Vec3 force, Vec3 torque) {
    const Mat3 axes = to_matrix(load.body.pose.rotation);
    const Vec3 own = transposed_times(axes, torque);
    return {load.gravity + force * (1 / load.body.mass),
            axes * (load.record.inverse_inertia * own) * (0.5 * load.h)};
}

}  // namespace

void apply_water_forces(const Waves& waves, const WaveTrain& train, Load& load,
                        WaterScratch& scratch) {
    const double gravity = -load.gravity.y;
    if (!(gravity > 0)) return;
    if (load.body.pose.position.y - load.record.reach >= train.max_surface_height()) return;
    WaterSums sums;
    scratch.wet.clear();
    scratch.wet_balls = 0;
    for (const PanelSurface& surface : load.record.panels)
        if (surface.ball > 0 && surface.ball < train.shortest_wavelength() / 8)
            add_ball(train, surface, load, scratch, sums);
        else
            add_surface(train, surface, load, scratch, sums);
    if (!(sums.area > 0)) return;
    const double weight = waves.density * gravity;  // N/m^3
    const Vec3 force = sums.force * weight, torque = sums.torque * weight;
    const Middle middle = middle_of(load, force, torque);
    const Vec3 flow = sums.flow * (1 / sums.area);
    const double displaced = waves.density * maximum(sums.force.y, 0);  // kg
    apply_wave_damping(waves.damping * displaced / load.body.mass, flow, middle, load);
    load.drag(
        flow, waves.density, waves.drag,
        [&](Vec3 direction) { return wet_area(scratch, direction); }, middle.acceleration);
    drag_spin(waves, load, middle.turn, scratch.wet);
    load.push(force * load.h);
    load.angular_impulse += torque * load.h;
    load.body.angular_velocity += middle.turn * 2;
}

}  // namespace jostle::modules::fields_detail
