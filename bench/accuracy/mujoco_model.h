// SPDX-License-Identifier: MIT
//
// A scene of the laboratory as MuJoCo's XML, and who is whose parent in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "accuracy/lab_scene.h"
#include "jostle/base/result.h"

namespace jostle::bench::lab {

// Bodies hang in a tree by one joint each; the other joints close loops. A free body has none.
struct BodyTree {
    struct Node {
        int parent = ground;
        std::optional<Joint> joint;  // none: free or fixed
    };
    std::vector<Node> nodes;  // by body
    std::vector<Joint> loops;
};
BodyTree tree_of(const Scene& scene);

Result<std::string> mujoco_xml(const Scene& scene, const BodyTree& tree, const std::string& mode);

}  // namespace jostle::bench::lab
