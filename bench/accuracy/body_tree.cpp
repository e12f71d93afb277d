// SPDX-License-Identifier: MIT
#include "bench/accuracy/body_tree.h"

namespace jostle::bench::accuracy {

// Sliders first: the body of a slider is attached to its rail rather than to the end of a loop.
BodyTree tree_of(const Scene& scene) {
    BodyTree tree;
    tree.nodes.resize(scene.bodies.size());
    const auto hang = [&](const Joint& joint) {
        BodyTree::Node& node = tree.nodes[static_cast<std::size_t>(joint.b)];
        if (node.joint) {
            tree.loops.push_back(joint);
            return;
        }
        node = {joint.a, joint};
    };
    for (const Joint& joint : scene.joints)
        if (joint.kind == JointKind::slider) hang(joint);
    for (const Joint& joint : scene.joints)
        if (joint.kind != JointKind::slider && joint.kind != JointKind::spring) hang(joint);
    return tree;
}

}  // namespace jostle::bench::accuracy
