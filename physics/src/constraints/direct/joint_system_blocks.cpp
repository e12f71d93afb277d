// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/joint_system_blocks.h"

#include <algorithm>
#include <array>

#include "jostle/base/check.h"

namespace jostle::physics {

namespace {

std::array<int, 4> bodies_of(const JointEnds& ends) {
    return {ends.a, ends.b, ends.carriers[0], ends.carriers[1]};
}

// Whether each of these joints of the body moves another one that is no hub.
bool all_move_others(std::span<const JointEnds> joints, const std::vector<int>& list, int body,
                     std::span<const std::uint8_t> pushed, const std::vector<int>& hub_of) {
    return std::all_of(list.begin(), list.end(), [&](int joint) {
        const JointEnds& ends = joints[as_index(joint)];
        const int other = ends.a == body ? ends.b : ends.a;
        return pushed[as_index(other)] != 0 && hub_of[as_index(other)] < 0;
    });
}

}  // namespace

bool find_joint_system_blocks(std::span<const JointEnds> joints, std::span<const int> rows,
                              std::span<const std::uint8_t> pushed, std::int64_t max_work,
                              BlockLdl& matrix, std::vector<JointSystemBlock>& system_blocks,
                              JointHubs* hubs) {
    ASSERT(joints.size() == rows.size());
    std::vector<std::vector<int>> of_body(pushed.size());
    for (std::size_t k = 0; k < joints.size(); k++)
        for (const int body : bodies_of(joints[k]))
            if (body >= 0 && pushed[as_index(body)] != 0)
                of_body[as_index(body)].push_back(static_cast<int>(k));
    system_blocks.clear();
    ASSERT(max_work >= 0);
    std::vector<int> rows_of_node(rows.begin(), rows.end());
    std::vector<int> hub_of(pushed.size(), -1);  // indexed by body
    if (hubs != nullptr) {
        hubs->hubs.clear();
        hubs->blocks.clear();
        for (std::size_t n = 0; n < of_body.size(); n++) {
            if (of_body[n].size() < min_hub_joints) continue;
            if (hubs->split &&
                !all_move_others(joints, of_body[n], static_cast<int>(n), pushed, hub_of))
                continue;
            hub_of[n] = static_cast<int>(hubs->hubs.size());
            hubs->hubs.push_back(
                {.body = static_cast<int>(n), .node = static_cast<int>(rows_of_node.size())});
            if (hubs->split)
                rows_of_node.insert(rows_of_node.end(), {hub_rows / 2, hub_rows / 2});
            else
                rows_of_node.push_back(hub_rows);
        }
    }
    std::vector<BlockLdl::Edge> edges;
    for (std::size_t n = 0; n < of_body.size(); n++) {
        const std::vector<int>& list = of_body[n];
        if (hub_of[n] >= 0) {
            const int node = hubs->hubs[as_index(hub_of[n])].node;
            for (const int joint : list) {
                edges.push_back({joint, node});
                if (hubs->split) edges.push_back({joint, node + 1});
            }
            if (hubs->split) edges.push_back({node, node + 1});
            continue;
        }
        int least = BlockLdl::max_rows;
        for (const int joint : list) least = std::min(least, rows[as_index(joint)]);
        if (clique_work(list.size(), least) > max_work) return false;
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k < i; k++) edges.push_back({list[i], list[k]});
    }
    std::vector<BlockLdl::Sign> signs;
    if (hubs != nullptr && !hubs->hubs.empty()) {
        signs.assign(rows_of_node.size(), BlockLdl::Sign::negative);
        for (std::size_t k = 0; k < joints.size(); k++) {
            const std::array<int, 4> of = bodies_of(joints[k]);
            const bool moves = std::any_of(of.begin(), of.end(), [&](int body) {
                return body >= 0 && pushed[as_index(body)] != 0 && hub_of[as_index(body)] < 0;
            });
            signs[k] = moves ? BlockLdl::Sign::positive : BlockLdl::Sign::waits;
        }
    }
    if (!matrix.analyze(rows_of_node, edges, max_work, signs)) return false;
    for (std::size_t n = 0; n < of_body.size(); n++) {
        const std::vector<int>& list = of_body[n];
        const int body = static_cast<int>(n);
        if (hub_of[n] >= 0) {
            JointHub& hub = hubs->hubs[as_index(hub_of[n])];
            hub.at = matrix.block_at(hub.node, hub.node);
            if (hubs->split) hub.angular_at = matrix.block_at(hub.node + 1, hub.node + 1);
            const auto at = [&](int node, int joint) {
                return matrix.is_later(node, joint) ? matrix.block_at(node, joint)
                                                    : matrix.block_at(joint, node);
            };
            for (const int joint : list) {
                hubs->blocks.push_back({at(hub.node, joint), joint, hub_of[n],
                                        joints[as_index(joint)].b == body,
                                        matrix.is_later(hub.node, joint)});
                if (!hubs->split) continue;
                hubs->blocks.back().angular_at = at(hub.node + 1, joint);
                hubs->blocks.back().angular_later = matrix.is_later(hub.node + 1, joint);
            }
            continue;
        }
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k <= i; k++) {
                const bool first_later = matrix.is_later(list[i], list[k]);
                const int later = first_later ? list[i] : list[k];
                const int sooner = first_later ? list[k] : list[i];
                system_blocks.push_back({matrix.block_at(later, sooner), later, sooner, body,
                                         joints[as_index(later)].b == body,
                                         joints[as_index(sooner)].b == body});
            }
    }
    return true;
}

}  // namespace jostle::physics
