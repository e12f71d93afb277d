// SPDX-License-Identifier: MIT
//
// The parts of a hull side by side, so that a few are looked at in one go: its vertices in double,
// by four, for whoever asks which lies furthest along a direction; the normals of its faces and the
// arcs of its edges in float, by eight, for the separating axis test, which only asks of most of
// them whether they can be left out. The last of each is repeated to fill the lanes.
//
// Lanes do not meet, but for the furthest vertex, of which equal ones are told apart by number: the
// bits are those of any other width.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jostle/physics/hull.h"

namespace jostle::physics {

struct VertexLanes {
    alignas(16) double x[4], y[4], z[4];
};
struct DirectionLanes {
    alignas(16) float x[8], y[8], z[8];
};
// All normals between those of an edge's two faces, which are square to the edge.
struct ArcLanes {
    DirectionLanes first, second;  // the normals of the two faces
    // A direction without its part along the edge lies between the two when it looks along both of
    // these.
    DirectionLanes after_first, before_second;
    DirectionLanes along;  // unit
};

struct HullLanes {
    std::vector<VertexLanes> vertices;
    std::vector<DirectionLanes> normals;
    std::vector<ArcLanes> arcs;
    double outer_radius = 0;  // m: of the ball about the centre of mass that holds the hull
};

HullLanes lanes_of(const ConvexHull& hull);

// Which vertex lies furthest along d (any length); of equal ones the first.
std::size_t furthest_vertex(const HullLanes& lanes, Vec3 d);

// A ball in one shape and one in another: along a direction n from the first to the second the
// shapes are no further apart than the balls are, n . apart - radii.
struct InnerBalls {
    Vec3 apart;  // m, from the first to the second, in the frame of the hull
    double radii = 0;
};
// For each normal, or each arc's best normal, how far apart the balls are, m: the least of the
// pairs of balls, and a little more than that, for rounding. `sign`: -1 where normals look from the
// second shape to the first. As many as the lanes hold.
void show_normals(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign,
                  float* to);
void show_arcs(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign, float* to);

}  // namespace jostle::physics
