// SPDX-License-Identifier: MIT
#include "modules/rope/src/strand_system.h"

#include "jostle/base/check.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// A link between two fixed nodes has no effect.
double inverse_pivot_of(double pivot) {
    return pivot > 0 ? 1 / pivot : 0;
}

}  // namespace

// Eliminates node i with P = D^-1, then the multiplier of link i with w = P e:
//     d_i = P (r + e u - N d_{i+1}),   u = (f . d_{i+1} - g - w . r) / p,
//     f = e + N w,   p = e . w + c.
// The next node receives -N P N + f f^T / p and -N P r + f (g + w . r) / p. 1 / p is the stiffness
// along e of everything before the link.
void solve_chain(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
                 StrandElimination& memory, std::span<Vec3> displacements,
                 std::span<double> multipliers) {
    ASSERT(nodes.size() == links.size() + 1);
    memory.steps.resize(nodes.size());
    Symmetric3 carried;
    Vec3 carried_right;
    for (std::size_t i = 0; i < nodes.size(); i++) {
        StrandElimination::Step& step = memory.steps[i];
        const NodeRow& node = nodes[i];
        step.inverse = node.fixed ? Symmetric3{} : inverse(node.diagonal + carried);
        step.right = node.right + carried_right;
        if (i == links.size()) break;
        const LinkRow& link = links[i];
        const Vec3 w = step.inverse * link.direction, moved = step.inverse * step.right;
        step.inverse_pivot = inverse_pivot_of(dot(link.direction, w) + link.compliance);
        step.target = link.right + dot(w, step.right);
        step.row = link.direction + w * link.next;
        if (link.has_cross) {
            step.row += link.cross * w;
            const Symmetric3 next = scalar_matrix(link.next) + link.cross;
            carried = outer(step.row, step.inverse_pivot) - sandwich(next, step.inverse);
            carried_right = step.row * (step.inverse_pivot * step.target) - next * moved;
        } else {
            carried = outer(step.row, step.inverse_pivot) - step.inverse * (link.next * link.next);
            carried_right = step.row * (step.inverse_pivot * step.target) - moved * link.next;
        }
    }
    Vec3 after = memory.steps.back().inverse * memory.steps.back().right;
    displacements[links.size()] = after;
    for (std::size_t i = links.size(); i-- > 0;) {
        const StrandElimination::Step& step = memory.steps[i];
        const LinkRow& link = links[i];
        const double u = (dot(step.row, after) - step.target) * step.inverse_pivot;
        multipliers[i] = u;
        Vec3 right = step.right + link.direction * u - after * link.next;
        if (link.has_cross) right -= link.cross * after;
        after = step.inverse * right;
        displacements[i] = after;
    }
}

// As solve_chain(), with the coupling s to the node after the next:
//     d_i = P (r + e u - N d_{i+1} - s d_{i+2}),
//     u = (f . d_{i+1} + s w . d_{i+2} - g - w . r) / p,   f = e + N^T w.
// N is not symmetric after the elimination of previous nodes.
void solve_rod(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
               StrandElimination& memory, std::span<Vec3> displacements,
               std::span<double> multipliers) {
    ASSERT(nodes.size() == links.size() + 1);
    memory.steps.resize(nodes.size());
    // What elimination adds to the next node, to its coupling, and to the node after it.
    Symmetric3 block, block_after;
    Vec3 right, right_after;
    Mat3 coupling = diagonal({0, 0, 0});
    for (std::size_t i = 0; i < nodes.size(); i++) {
        StrandElimination::Step& step = memory.steps[i];
        const NodeRow& node = nodes[i];
        step.inverse = node.fixed ? Symmetric3{} : inverse(node.diagonal + block);
        step.right = node.right + right;
        if (i == links.size()) break;
        const LinkRow& link = links[i];
        const Mat3 p = to_matrix(step.inverse);
        step.next = coupling + diagonal({link.next, link.next, link.next});
        if (link.has_cross) step.next = step.next + to_matrix(link.cross);
        step.weighted = step.inverse * link.direction;
        const Vec3 moved = step.inverse * step.right;
        step.inverse_pivot = inverse_pivot_of(dot(link.direction, step.weighted) + link.compliance);
        step.target = link.right + dot(step.weighted, step.right);
        step.row = link.direction + transposed_times(step.next, step.weighted);
        const double pull = step.inverse_pivot * step.target;
        const Mat3 back = transpose(step.next) * p;
        block =
            block_after + outer(step.row, step.inverse_pivot) - symmetric_part(back * step.next);
        right = right_after + step.row * pull - transposed_times(step.next, moved);
        // Columns of s f w^T / p - s N^T P.
        const Vec3 f = step.row * (link.skip * step.inverse_pivot), w = step.weighted;
        coupling = Mat3{f * w.x, f * w.y, f * w.z} - back * link.skip;
        block_after = outer(w, link.skip * link.skip * step.inverse_pivot) -
                      step.inverse * (link.skip * link.skip);
        right_after = (w * pull - moved) * link.skip;
    }
    Vec3 after = memory.steps.back().inverse * memory.steps.back().right, second;
    displacements[links.size()] = after;
    for (std::size_t i = links.size(); i-- > 0;) {
        const StrandElimination::Step& step = memory.steps[i];
        const LinkRow& link = links[i];
        const double u =
            (dot(step.row, after) + link.skip * dot(step.weighted, second) - step.target) *
            step.inverse_pivot;
        multipliers[i] = u;
        const Vec3 d = step.inverse *
                       (step.right + link.direction * u - step.next * after - second * link.skip);
        second = after;
        after = d;
        displacements[i] = d;
    }
}

}  // namespace jostle::modules::rope_detail
