// SPDX-License-Identifier: MIT
#include "physics/src/math/principal_axes.h"

#include "jostle/base/check.h"

namespace jostle::physics {

PrincipalAxes principal_axes(const Mat3& inertia) {
    Quat frame;
    Mat3 m = inertia;
    const double size = absolute(m.x.x) + absolute(m.y.y) + absolute(m.z.z);
    ASSERT(m.x.x >= 0 && m.y.y >= 0 && m.z.z >= 0);
    for (int sweep = 0; sweep < 20; sweep++) {
        const double off[] = {absolute(m.y.z), absolute(m.x.z), absolute(m.x.y)};
        const int axis = off[0] >= off[1] && off[0] >= off[2] ? 0 : (off[1] >= off[2] ? 1 : 2);
        if (off[axis] <= 1e-16 * size) break;
        const int i = (axis + 1) % 3, k = (axis + 2) % 3;
        const Vec3 columns[3] = {m.x, m.y, m.z};
        const double mixed = columns[i][k];
        // Half of the angle that makes the off-diagonal element zero.
        const double angle = 0.5 * arc_tangent(2 * mixed, columns[i][i] - columns[k][k]);
        Vec3 along;
        along[axis] = 1;
        frame = normalized(frame * from_axis_angle(along, angle));
        const Mat3 turned = to_matrix(frame);
        m = transpose(turned) * inertia * turned;
    }
    return {frame, {m.x.x, m.y.y, m.z.z}};
}

}  // namespace jostle::physics
