// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/joint_system_blocks.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {

bool find_joint_system_blocks(std::span<const JointEnds> joints, std::span<const int> rows,
                              std::span<const std::uint8_t> pushed, std::int64_t max_work,
                              BlockLdl& matrix, std::vector<JointSystemBlock>& system_blocks) {
    ASSERT(joints.size() == rows.size());
    std::vector<std::vector<int>> of_body(pushed.size());
    for (std::size_t k = 0; k < joints.size(); k++)
        for (const int body : {joints[k].a, joints[k].b})
            if (pushed[as_index(body)] != 0) of_body[as_index(body)].push_back(static_cast<int>(k));
    system_blocks.clear();
    ASSERT(max_work >= 0);
    for (const std::vector<int>& list : of_body) {
        int least = BlockLdl::max_rows;
        for (const int joint : list) least = std::min(least, rows[as_index(joint)]);
        if (clique_work(list.size(), least) > max_work) return false;
    }
    std::vector<BlockLdl::Edge> edges;
    for (const std::vector<int>& list : of_body)
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k < i; k++) edges.push_back({list[i], list[k]});
    if (!matrix.analyze(rows, edges, max_work)) return false;
    for (std::size_t n = 0; n < of_body.size(); n++) {
        const std::vector<int>& list = of_body[n];
        const int body = static_cast<int>(n);
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k <= i; k++) {
                const bool first_later = matrix.is_later(list[i], list[k]);
                const int later = first_later ? list[i] : list[k];
                const int sooner = first_later ? list[k] : list[i];
                ASSERT(joints[as_index(later)].a == body || joints[as_index(later)].b == body);
                system_blocks.push_back({matrix.block_at(later, sooner), later, sooner, body,
                                         joints[as_index(later)].b == body,
                                         joints[as_index(sooner)].b == body});
            }
    }
    return true;
}

}  // namespace jostle::physics
