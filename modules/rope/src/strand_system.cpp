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

// The terms that the elimination of a node and its link adds to the next node.
struct Carried {
    Symmetric3 block;
    Vec3 right;
};

// Eliminates a node with P = D^-1, then the multiplier of the link to the next node with w = P e:
//     d = P (r + e u - N d_next),   u = (f . d_next - g - w . r) / p,
//     f = e + N w,   p = e . w + c.
// The next node receives -N P N + f f^T / p and -N P r + f (g + w . r) / p. 1 / p is the stiffness
// along e of everything before the link.
inline void eliminate(const NodeRow& node, const LinkRow& link, Vec3 e, const CrossBlock* cross,
                      Carried& carried, StrandElimination::Step& step) {
    step.inverse = node.fixed ? Symmetric3{} : inverse(node.diagonal + carried.block);
    step.right = node.right + carried.right;
    const Vec3 w = step.inverse * e, moved = step.inverse * step.right;
    step.inverse_pivot = inverse_pivot_of(dot(e, w) + link.compliance);
    step.target = link.right + dot(w, step.right);
    step.row = e + w * link.next;
    const double pull = step.inverse_pivot * step.target;
    if (cross != nullptr && cross->any) {
        step.row += cross->block * w;
        const Symmetric3 next = scalar_matrix(link.next) + cross->block;
        carried.block = outer(step.row, step.inverse_pivot) - sandwich(next, step.inverse);
        carried.right = step.row * pull - next * moved;
    } else {
        carried.block =
            outer(step.row, step.inverse_pivot) - step.inverse * (link.next * link.next);
        carried.right = step.row * pull - moved * link.next;
    }
}

// The displacement of an eliminated node, from that of the next node.
inline Vec3 substitute(const LinkRow& link, Vec3 e, const CrossBlock* cross,
                       const StrandElimination::Step& step, Vec3 next, double& multiplier) {
    multiplier = (dot(step.row, next) - step.target) * step.inverse_pivot;
    Vec3 right = step.right + e * multiplier - next * link.next;
    if (cross != nullptr && cross->any) right -= cross->block * next;
    return step.inverse * right;
}

}  // namespace

// Eliminates from both ends towards the middle, which halves the chain of dependent operations.
// Seen from the last end, a link has the direction -e.
void solve_chain(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
                 std::span<const CrossBlock> cross, StrandElimination& memory,
                 std::span<Vec3> displacements, std::span<double> multipliers) {
    ASSERT(nodes.size() == links.size() + 1 && (cross.empty() || cross.size() == links.size()));
    memory.steps.resize(nodes.size());
    std::vector<StrandElimination::Step>& steps = memory.steps;
    const auto cross_of = [&](std::size_t k) { return cross.empty() ? nullptr : &cross[k]; };
    const std::size_t last = links.size(), middle = last / 2;
    Carried front{}, back{};
    for (std::size_t k = 0; k < middle; k++) {
        eliminate(nodes[k], links[k], links[k].direction, cross_of(k), front, steps[k]);
        const std::size_t j = last - k;
        eliminate(nodes[j], links[j - 1], -links[j - 1].direction, cross_of(j - 1), back, steps[j]);
    }
    if (last - middle > middle)
        eliminate(nodes[middle + 1], links[middle], -links[middle].direction, cross_of(middle),
                  back, steps[middle + 1]);
    const NodeRow& node = nodes[middle];
    Vec3 before{};
    if (!node.fixed)
        before = inverse(node.diagonal + front.block + back.block) *
                 (node.right + front.right + back.right);
    Vec3 after = before;
    displacements[middle] = before;
    if (last - middle > middle) {
        after = substitute(links[middle], -links[middle].direction, cross_of(middle),
                           steps[middle + 1], after, multipliers[middle]);
        displacements[middle + 1] = after;
    }
    for (std::size_t k = middle; k-- > 0;) {
        before =
            substitute(links[k], links[k].direction, cross_of(k), steps[k], before, multipliers[k]);
        displacements[k] = before;
        const std::size_t j = last - k;
        after = substitute(links[j - 1], -links[j - 1].direction, cross_of(j - 1), steps[j], after,
                           multipliers[j - 1]);
        displacements[j] = after;
    }
}

// As solve_chain(), with the coupling s to the node after the next:
//     d_i = P (r + e u - N d_{i+1} - s d_{i+2}),
//     u = (f . d_{i+1} + s w . d_{i+2} - g - w . r) / p,   f = e + N^T w.
// N is not symmetric after the elimination of previous nodes.
void solve_rod(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
               std::span<const CrossBlock> cross, StrandElimination& memory,
               std::span<Vec3> displacements, std::span<double> multipliers) {
    ASSERT(nodes.size() == links.size() + 1 && (cross.empty() || cross.size() == links.size()));
    memory.steps.resize(nodes.size());
    memory.rod_steps.resize(nodes.size());
    // Terms added to the next node, to its coupling, and to the node after it.
    Symmetric3 block, block_after;
    Vec3 right, right_after;
    Mat3 coupling = diagonal({0, 0, 0});
    for (std::size_t i = 0; i < nodes.size(); i++) {
        StrandElimination::Step& step = memory.steps[i];
        StrandElimination::RodStep& rod = memory.rod_steps[i];
        const NodeRow& node = nodes[i];
        step.inverse = node.fixed ? Symmetric3{} : inverse(node.diagonal + block);
        step.right = node.right + right;
        if (i == links.size()) break;
        const LinkRow& link = links[i];
        const Mat3 p = to_matrix(step.inverse);
        rod.next = coupling + diagonal({link.next, link.next, link.next});
        if (!cross.empty() && cross[i].any) rod.next = rod.next + to_matrix(cross[i].block);
        rod.weighted = step.inverse * link.direction;
        const Vec3 moved = step.inverse * step.right;
        step.inverse_pivot = inverse_pivot_of(dot(link.direction, rod.weighted) + link.compliance);
        step.target = link.right + dot(rod.weighted, step.right);
        step.row = link.direction + transposed_times(rod.next, rod.weighted);
        const double pull = step.inverse_pivot * step.target;
        const Mat3 back = transpose(rod.next) * p;
        block = block_after + outer(step.row, step.inverse_pivot) - symmetric_part(back * rod.next);
        right = right_after + step.row * pull - transposed_times(rod.next, moved);
        // Columns of s f w^T / p - s N^T P.
        const Vec3 f = step.row * (link.skip * step.inverse_pivot), w = rod.weighted;
        coupling = Mat3{f * w.x, f * w.y, f * w.z} - back * link.skip;
        block_after = outer(w, link.skip * link.skip * step.inverse_pivot) -
                      step.inverse * (link.skip * link.skip);
        right_after = (w * pull - moved) * link.skip;
    }
    Vec3 after = memory.steps.back().inverse * memory.steps.back().right, second;
    displacements[links.size()] = after;
    for (std::size_t i = links.size(); i-- > 0;) {
        const StrandElimination::Step& step = memory.steps[i];
        const StrandElimination::RodStep& rod = memory.rod_steps[i];
        const LinkRow& link = links[i];
        const double u =
            (dot(step.row, after) + link.skip * dot(rod.weighted, second) - step.target) *
            step.inverse_pivot;
        multipliers[i] = u;
        const Vec3 d = step.inverse *
                       (step.right + link.direction * u - rod.next * after - second * link.skip);
        second = after;
        after = d;
        displacements[i] = d;
    }
}

}  // namespace jostle::modules::rope_detail
