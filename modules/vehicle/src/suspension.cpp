// SPDX-License-Identifier: MIT
//
// Soft constraint rows (E. Catto, "Soft Constraints", 2011) with a selectable degree of
// implicitness. With W = J M^-1 J^T, v the velocity at the end of the sub-step without the loads,
// and x the current compression of the springs,
//
//     N = k x - (c + theta h k) (v + h W N)
//
// theta = z^2 / (4 + z^2), z^2 = h^2 k W. For a soft spring, theta is close to 0, and the spring
// preserves its frequency and energy to second order. For a stiff spring, theta is close to 1, and
// the spring is damped out. The scheme is stable for theta >= 1/2 or z < 2, and theta reaches 1/2
// at z = 2. For one row, x' = x + h v' and v' = (v - h k x W) / (1 + theta z^2) have the
// determinant 1 / D and the trace 1 + 1 / D - z^2 / D with D = 1 + theta z^2.
#include "modules/vehicle/src/car_parts.h"

#include "modules/vehicle/src/small_linear_system.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Stiffness of the bump stop relative to that of the spring.
constexpr double stop_stiffness_ratio = 30;

struct Row {
    double push;        // N, current spring force
    double resistance;  // N s/m: c + theta h k
    double velocity;    // m/s, at the end of the sub-step without load
    bool active;
};
struct Rows {
    std::array<Row, wheels_max> of;
    std::array<std::array<double, wheels_max>, wheels_max> w;  // lower triangle
};

double anti_roll_stiffness(const Car& car, std::uint32_t wheel) {
    double stiffness = 0;
    for (const AntiRollBar& bar : car.def.anti_roll_bars)
        if (bar.left == wheel || bar.right == wheel) stiffness += bar.stiffness;
    return stiffness;
}

// N, along the suspension.
double anti_roll_force(const Car& car, std::uint32_t wheel) {
    double push = 0;
    for (const AntiRollBar& bar : car.def.anti_roll_bars) {
        if (bar.left != wheel && bar.right != wheel) continue;
        const std::uint32_t other = bar.left == wheel ? bar.right : bar.left;
        push += bar.stiffness * (car.wheels[wheel].travel - car.wheels[other].travel);
    }
    return push;
}

void fill_effective_mass(const Car& car, const Contacts& contacts, Rows& rows) {
    const double inverse_mass = 1 / car.mass;
    for (std::size_t i = 0; i < contacts.count; i++) {
        const Contact& a = contacts.all[i];
        const Vec3 spin = car.inverse_inertia * cross(a.arm, a.normal);
        const Vec3 along = a.normal * inverse_mass;
        for (std::size_t j = 0; j <= i; j++) {
            const Contact& b = contacts.all[j];
            rows.w[i][j] = dot(b.normal, along + cross(spin, b.arm));
        }
    }
}

Row make_row(const Car& car, const ChassisFrame& frame, const Contact& contact, double w) {
    const WheelRuntime& wheel = car.wheels[contact.wheel];
    const Suspension& suspension = car.def.wheels[contact.wheel].suspension;
    double stiffness = wheel.stiffness, damping = wheel.damping;
    double push = suspension.preload + stiffness * contact.pressed;
    const double too_far = contact.pressed - (suspension.max_length - suspension.min_length);
    if (too_far > 0) {
        const double stop = stop_stiffness_ratio * wheel.stiffness;
        push += stop * too_far;
        stiffness += stop;
        damping = maximum(damping, 2 * square_root(stop / w));  // critical
    }
    if (!car.def.anti_roll_bars.empty()) {
        push += anti_roll_force(car, contact.wheel);
        stiffness += 2 * anti_roll_stiffness(car, contact.wheel);
    }
    const double lever2 = contact.lever * contact.lever;
    const double z2 = frame.h * frame.h * stiffness * lever2 * w;
    const double theta = z2 / (4 + z2);
    Row row;
    row.active = true;
    row.push = contact.lever * push;
    row.resistance = maximum(lever2 * (damping + theta * frame.h * stiffness), 1e-9);
    const Vec3 other = (frame.next_v - frame.v) + cross(frame.next_w - frame.w, contact.arm);
    row.velocity = dot(contact.velocity + other, contact.normal);
    return row;
}

// Solves (1 / B + h W) N = push / B - v for the active rows.
void solve(const ChassisFrame& frame, const Rows& rows, Contacts& contacts) {
    SmallLinearSystem<wheels_max> system;
    std::array<std::size_t, wheels_max> bearing;
    std::size_t count = 0;
    for (std::size_t i = 0; i < contacts.count; i++)
        if (rows.of[i].active) bearing[count++] = i;
    system.size = count;
    for (std::size_t i = 0; i < count; i++) {
        const Row& row = rows.of[bearing[i]];
        for (std::size_t j = 0; j <= i; j++)
            system.a[i][j] = frame.h * rows.w[bearing[i]][bearing[j]];
        system.a[i][i] += 1 / row.resistance;
        system.b[i] = row.push / row.resistance - row.velocity;
    }
    system.solve();
    for (Contact& contact : contacts) contact.load = 0;
    for (std::size_t i = 0; i < count; i++) contacts.all[bearing[i]].load = system.b[i];
}

}  // namespace

void solve_loads(const Car& car, const ChassisFrame& frame, Contacts& contacts) {
    if (contacts.count == 0) return;
    Rows rows;
    fill_effective_mass(car, contacts, rows);
    for (std::size_t i = 0; i < contacts.count; i++)
        rows.of[i] = make_row(car, frame, contacts.all[i], rows.w[i][i]);
    // A wheel cannot pull: rows with negative load are deactivated one after the other.
    for (std::size_t round = 0; round < contacts.count; round++) {
        solve(frame, rows, contacts);
        bool pulls = false;
        for (std::size_t i = 0; i < contacts.count; i++)
            if (contacts.all[i].load < 0) {
                rows.of[i].active = false;
                pulls = true;
            }
        if (!pulls) return;
    }
    for (Contact& contact : contacts) contact.load = maximum(contact.load, 0);
}

}  // namespace jostle::modules::vehicle_detail
