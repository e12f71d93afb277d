// SPDX-License-Identifier: MIT
//
// The tree of joints of a scene, for engines with joint coordinates.
#pragma once

#include <optional>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

// Each body is attached to the tree by one joint; the other joints close loops. A free body has no
// joint.
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
