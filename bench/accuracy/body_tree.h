// SPDX-License-Identifier: MIT
//
// Who hangs on whom in a scene: what engines with joint coordinates build from.
#pragma once

#include <optional>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

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

}  // namespace jostle::bench::accuracy
