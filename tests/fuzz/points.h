// SPDX-License-Identifier: MIT
//
// Points from a stranger: on a coarse grid, where planes, lines and duplicates are many, or any
// doubles.
#pragma once

#include <vector>

#include "jostle/physics/vec3.h"
#include "tests/fuzz/reader.h"

namespace jostle::fuzz {

enum class PointKind : std::uint8_t { grid, fine, any };

inline physics::Vec3 take_point(Reader& in, PointKind kind) {
    const auto number = [&]() -> double {
        switch (kind) {
            case PointKind::grid:
                return in.number<std::int8_t>() / 16.0;
            case PointKind::fine:
                return in.number<std::int32_t>() / 1e8;
            default:
                return in.number<double>();
        }
    };
    const double x = number(), y = number();
    return {x, y, number()};
}

inline PointKind take_point_kind(Reader& in) {
    return static_cast<PointKind>(in.number<std::uint8_t>() % 3);
}

inline std::vector<physics::Vec3> take_points(Reader& in, PointKind kind, std::size_t most) {
    std::vector<physics::Vec3> points;
    while (!in.done() && points.size() < most) points.push_back(take_point(in, kind));
    return points;
}

}  // namespace jostle::fuzz
