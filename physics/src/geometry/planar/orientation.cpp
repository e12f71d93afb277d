// SPDX-License-Identifier: MIT
#include "jostle/physics/planar.h"
#include "physics/src/geometry/planar/expansion.h"

namespace jostle::physics::planar {

double doubled_area(Vec2 a, Vec2 b, Vec2 c) {
    const Rounded ax = two_difference(a.x, c.x), ay = two_difference(a.y, c.y),
                  bx = two_difference(b.x, c.x), by = two_difference(b.y, c.y);
    // (ax by - ay bx), each factor a value and its error: eight products, each a value and its
    // error.
    Expansion<16> sum;
    const auto add = [&](double p, double q) {
        if (p != 0 && q != 0) sum.add(two_product(p, q));
    };
    add(ax.error, by.error);
    add(-ay.error, bx.error);
    add(ax.error, by.value);
    add(ax.value, by.error);
    add(-ay.error, bx.value);
    add(-ay.value, bx.error);
    add(ax.value, by.value);
    add(-ay.value, bx.value);
    return sum.value();
}

int orientation(Vec2 a, Vec2 b, Vec2 c) {
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    // Shewchuk's bound A of the rounding error.
    constexpr double bound = (3 + 16 * 0x1p-53) * 0x1p-53;
    const double area = left - right, error = bound * (absolute(left) + absolute(right));
    if (area > error) return 1;
    if (area < -error) return -1;
    const double exact = doubled_area(a, b, c);
    return exact > 0 ? 1 : (exact < 0 ? -1 : 0);
}

}  // namespace jostle::physics::planar
