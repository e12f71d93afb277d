// SPDX-License-Identifier: MIT
//
// Pieces of a solid have the correct volume and hull points.
#include "modules/convex_decomposition/src/cut_mesh.h"

#include <gtest/gtest.h>

#include "jostle/physics/hull.h"
#include "tests/modules/convex_decomposition/solids.h"

namespace jostle::test {
namespace {

using namespace physics;
using namespace modules::convex_decomposition;

TEST(CutMesh, cuts_a_quarter_of_a_cube) {
    const Solid solid = cube();
    const ClosedMesh mesh = *make_closed_mesh(solid.vertices, solid.indices);
    const Piece piece = cut_piece(mesh.triangles, {{0, 0.5, 0}, {0.5, 1, 1}});
    EXPECT_NEAR(piece.volume, 0.25, 1e-12);
    EXPECT_NEAR((*build_hull(piece.points))->volume, 0.25, 1e-12)
        << "includes the corners inside the solid";
}

// The pieces of a ring sum to its volume for any grid of boxes.
TEST(CutMesh, piece_volumes_sum_to_the_mesh_volume) {
    const Solid solid = torus(1, 0.3, 48, 24);
    const ClosedMesh mesh = *make_closed_mesh(solid.vertices, solid.indices);
    double sum = 0;
    const double x[] = {-1.4, -0.77, 0.1, 0.83, 1.4}, y[] = {-0.31, 0.05, 0.31},
                 z[] = {-1.4, -0.2, 0.9, 1.4};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < 3; k++)
                sum +=
                    cut_piece(mesh.triangles, {{x[i], y[j], z[k]}, {x[i + 1], y[j + 1], z[k + 1]}})
                        .volume;
    EXPECT_NEAR(sum, mesh.volume, 1e-12 * mesh.volume);
    EXPECT_NEAR(mesh.volume, 2 * pi * pi * 0.09, 0.03)
        << "the exact volume, minus the part that chords cut off";
}

}  // namespace
}  // namespace jostle::test
