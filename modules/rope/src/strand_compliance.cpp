// SPDX-License-Identifier: MIT
#include "modules/rope/src/strand_compliance.h"

#include "jostle/base/check.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

constexpr Mat3 none{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

Mat3 outer_product(Vec3 a, Vec3 b) {
    return {a * b.x, a * b.y, a * b.z};
}

}  // namespace

// Without other forces, substitution is d_i = A d_{i+1} + B d_{i+2}, so the blocks W of the inverse
// follow from those of later nodes: W_ij = A W_{i+1,j} + B W_{i+2,j} for i < j, and W_ii has P - w
// w^T / p in addition (K. Takahashi et al., "Formation of a sparse bus impedance matrix", 1973).
void StrandCompliance::compute(std::span<const LinkRow> links, const StrandElimination& solved,
                               std::span<const std::uint32_t> nodes) {
    ASSERT(!nodes.empty() && nodes.back() <= links.size());
    count_ = nodes.size();
    blocks_.resize(count_ * count_);
    const std::size_t first = nodes[0], last = links.size();
    for (std::vector<Mat3>* each : {&once_, &twice_, &own_, &next_})
        each->assign(last - first + 1, none);
    own_.back() = to_matrix(solved.steps[last].inverse);
    for (std::size_t i = last; i-- > first;) {
        const StrandElimination::Step& step = solved.steps[i];
        const StrandElimination::RodStep& rod = solved.rod_steps[i];
        const Vec3 w = rod.weighted;
        const Mat3 p = to_matrix(step.inverse);
        const Mat3 alone = p - outer_product(w, w * step.inverse_pivot);
        const double skip = links[i].skip;
        const std::size_t k = i - first;
        once_[k] = outer_product(w, step.row * step.inverse_pivot) - p * rod.next;
        next_[k] = once_[k] * own_[k + 1];
        own_[k] = alone;
        if (skip != 0) {
            twice_[k] = alone * -skip;
            next_[k] = next_[k] + twice_[k] * transpose(next_[k + 1]);
            const Mat3 after = once_[k] * next_[k + 1] + twice_[k] * own_[k + 2];
            own_[k] = own_[k] + twice_[k] * transpose(after);
        }
        own_[k] = to_matrix(symmetric_part(own_[k] + once_[k] * transpose(next_[k])));
    }
    for (std::size_t from = 0; from < count_; from++) {
        std::size_t k = nodes[from] - first, to = from;
        Mat3 now = own_[k], after = transpose(next_[k]);
        blocks_[from * count_ + from] = now;
        while (to > 0) {
            k--;
            Mat3 before = once_[k] * now;
            if (links[first + k].skip != 0) before = before + twice_[k] * after;
            after = now;
            now = before;
            if (nodes[to - 1] != first + k) continue;
            to--;
            blocks_[from * count_ + to] = now;
            blocks_[to * count_ + from] = transpose(now);
        }
    }
}

}  // namespace jostle::modules::rope_detail
