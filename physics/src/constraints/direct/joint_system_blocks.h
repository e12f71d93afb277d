// SPDX-License-Identifier: MIT
//
// The block structure of the matrix J M^-1 J^T of some joints: each body that they can push couples
// every two of its joints, and each joint with itself. So many joints on one body, as on a chassis,
// would cost the cube of their number. Such a body, a hub, is a node of its own instead, with its
// velocity as unknown (D. Baraff, "Linear-time dynamics using Lagrange multipliers", 1996):
//     | A    J_h |
//     | J_h' -M_h|
// Hubs follow the joints in the numbering of nodes. A kernel for blocks of three rows splits a hub
// into two nodes, of its linear and of its angular unknowns.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/constraints/direct/joint_net.h"

namespace jostle::physics {

struct JointSystemBlock {
    int at;  // of the block in the matrix's values
    int later, sooner, body;
    // Whether the body is b of that joint. Not for gears, which have up to four bodies.
    bool later_b, sooner_b;
};
struct JointEnds {
    int a = 0, b = 0;            // body numbers
    int carriers[2] = {-1, -1};  // further bodies of a gear; -1: none
};

struct JointHub {
    int body = 0, at = 0;  // `at`: its diagonal block of 6 rows: v, then w
    int node = 0;          // if it is split: of v; that of w follows
    int angular_at = 0;    // if it is split: the diagonal block of w
};
struct JointHubBlock {
    int at;  // of the block; row-major, its rows are those of the later node
    int joint, hub;
    bool body_b;     // whether the body is b of the joint
    bool hub_later;  // whether the hub is eliminated later
    // If the hub is split: the same of its node of w.
    int angular_at = 0;
    bool angular_later = false;
};
struct JointHubs {
    // Into two nodes of three rows. Every joint of such a hub moves another body that is no hub, so
    // that its own block is positive without the hub.
    bool split = false;
    std::vector<JointHub> hubs;
    std::vector<JointHubBlock> blocks;
};
inline constexpr std::size_t min_hub_joints = 6;  // fewer are cheaper without a node for the body
inline constexpr int hub_rows = 6;

// Analyses the matrix with one node per joint and lists the blocks. Returns false, and the results
// are then unusable, if a factorisation would take more than `max_work` multiplications. `pushed`:
// indexed by body. `hubs`: if not null, bodies with many joints become hubs.
bool find_joint_system_blocks(std::span<const JointEnds> joints, std::span<const int> rows,
                              std::span<const std::uint8_t> pushed, std::int64_t max_work,
                              BlockLdl& matrix, std::vector<JointSystemBlock>& system_blocks,
                              JointHubs* hubs = nullptr);

}  // namespace jostle::physics
