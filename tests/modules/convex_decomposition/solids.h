// SPDX-License-Identifier: MIT
//
// Closed meshes for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"

namespace jostle::test {

struct Solid {
    std::vector<physics::Vec3> vertices;
    std::vector<std::uint32_t> indices;

    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        indices.insert(indices.end(), {a, b, c, a, c, d});
    }
};

// A counter-clockwise outline in x and y with the triangles that fill it, extruded along z from 0
// to depth.
inline Solid prism(const std::vector<std::array<double, 2>>& outline,
                   const std::vector<std::array<std::uint32_t, 3>>& cap, double depth) {
    Solid solid;
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const double z : {0.0, depth})
        for (const auto& [x, y] : outline) solid.vertices.push_back({x, y, z});
    for (std::uint32_t k = 0; k < n; k++) solid.quad(k, (k + 1) % n, n + (k + 1) % n, n + k);
    for (const auto& [a, b, c] : cap) {
        solid.indices.insert(solid.indices.end(), {a, c, b});
        solid.indices.insert(solid.indices.end(), {n + a, n + b, n + c});
    }
    return solid;
}

inline Solid cube() {
    return prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, 1);
}
// Three unit squares: 3 m^3 at a depth of 1 m.
inline Solid l_shape() {
    return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 1);
}

// A ball of radius 1 about the y axis with two poles and `rings` - 1 rings of `around` corners.
inline Solid ball(std::uint32_t around, std::uint32_t rings) {
    Solid solid;
    solid.vertices.push_back({0, 1, 0});
    for (std::uint32_t j = 1; j < rings; j++)
        for (std::uint32_t i = 0; i < around; i++) {
            const double a = 2 * physics::pi * i / around, b = physics::pi * j / rings;
            solid.vertices.push_back(
                {std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)});
        }
    solid.vertices.push_back({0, -1, 0});
    const auto south = static_cast<std::uint32_t>(solid.vertices.size() - 1);
    for (std::uint32_t i = 0; i < around; i++) {
        const std::uint32_t next = (i + 1) % around, last = south - around;
        solid.indices.insert(solid.indices.end(), {0, 1 + next, 1 + i});
        solid.indices.insert(solid.indices.end(), {south, last + i, last + next});
        for (std::uint32_t j = 0; j + 2 < rings; j++) {
            const std::uint32_t a = 1 + j * around;
            solid.quad(a + i, a + next, a + around + next, a + around + i);
        }
    }
    return solid;
}

// About the y axis; the tube is round with radius `thin`.
inline Solid torus(double wide, double thin, std::uint32_t around, std::uint32_t along) {
    Solid solid;
    for (std::uint32_t i = 0; i < around; i++)
        for (std::uint32_t j = 0; j < along; j++) {
            const double a = 2 * physics::pi * i / around, b = 2 * physics::pi * j / along;
            const double r = wide + thin * std::cos(b);
            solid.vertices.push_back({r * std::cos(a), thin * std::sin(b), r * std::sin(a)});
        }
    for (std::uint32_t i = 0; i < around; i++)
        for (std::uint32_t j = 0; j < along; j++) {
            const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % along;
            solid.quad(i * along + j, i * along + j1, i1 * along + j1, i1 * along + j);
        }
    return solid;
}

}  // namespace jostle::test
