// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/passes_through.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_composite.h"

namespace jostle::physics {
namespace {

constexpr double gap = 1e-5;  // m, at which the sweeps stop

// The shape on the same path in the opposite direction: at fraction 0 it is where the given one is
// at `until`.
SweptShape reversed(const SweptShape& shape, double until) {
    SweptShape back = shape;
    back.sweep = {0,
                  center_at(shape.sweep, until),
                  rotation_at(shape.sweep, until),
                  -shape.sweep.translation,
                  -shape.sweep.rotation_vector,
                  1};
    return back;
}

}  // namespace

// The first and the last touch bound the time of the overlap. Convex shapes that do not rotate
// overlap all the time in between; for other shapes several times are tested.
bool passes_through(const SweptShape& a, const SweptShape& b, double from, double until) {
    ASSERT(from >= 0 && until <= 1 && !(until < from));
    const Impact first = time_of_impact(a, b, from, gap, until);
    if (!first.at_start && first.fraction > until) return false;
    const double begin = first.at_start ? from : first.fraction;
    const Impact last =
        time_of_impact(reversed(a, until), reversed(b, until), 0, gap, until - begin);
    const double end =
        last.at_start || last.fraction > until - begin ? until : until - last.fraction;
    const auto overlap_at = [&](double share) {
        const double fraction = begin + share * (end - begin);
        return shapes_overlap(transformed_shape_at(a, fraction), transformed_shape_at(b, fraction));
    };
    for (const double share : {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875})
        if (overlap_at(share)) return true;
    return false;
}

}  // namespace jostle::physics
