// SPDX-License-Identifier: MIT
#include "jostle/snapshot/point_history.h"

#include <algorithm>
#include <string>
#include <utility>

namespace jostle::snapshot {

PointHistory::PointHistory(PointLayout layout)
    : layout_(std::move(layout)),
      order_(layout_.form == PointForm::loose ? PointOrder() : PointOrder(layout_)) {}

Result<PointHistory> PointHistory::create(PointLayout layout) {
    if (Status s = check_layout(layout); !s.ok()) return s.error();
    return PointHistory(std::move(layout));
}

PointBaselines PointHistory::baselines(bool refines) const {
    const auto at = [&](std::size_t back) {
        return back <= usable_ ? &states_[states_.size() - back].points.state : nullptr;
    };
    // The other states do not precede a state that replaces the newest one.
    if (refines) return {at(1), nullptr, nullptr};
    return {at(1), at(2), at(3)};
}

Result<DecodedPoints> PointHistory::read(std::uint32_t number, std::uint32_t back,
                                         std::span<const std::byte> bytes) const {
    const std::uint32_t known = usable_ > 0 ? states_.back().points.state.number : 0;
    if (back != 0 && (usable_ == 0 || back - 1 > number || number - (back - 1) != known))
        return Error{ErrorCode::failed_precondition,
                     "points: state " + std::to_string(number) + " is based on state " +
                         std::to_string(std::int64_t{number} - back + 1) +
                         "; the newest known one is " + std::to_string(known)};
    return read_points(layout_, order_, number, bytes,
                       back == 0 ? PointBaselines{} : baselines(back == 1));
}

Status PointHistory::add(std::uint32_t number, std::uint32_t tick, std::uint32_t back,
                         std::span<const std::byte> bytes, std::uint32_t crc) {
    Result<DecodedPoints> decoded = read(number, back, bytes);
    if (!decoded.ok()) return decoded.error();
    if (decoded->crc != crc)
        return Error{ErrorCode::corrupt_data,
                     "points: CRC mismatch in state " + std::to_string(number)};
    Entry entry{*std::move(decoded), tick};
    if (back == 1) {
        refine(std::move(entry));
        return {};
    }
    if (back == 0) states_.clear();
    states_.push_back(std::move(entry));
    if (states_.size() > states_max) states_.pop_front();
    usable_ = back == 0 ? 1 : std::min(usable_ + 1, baselines_max);
    return {};
}

// A loose point of the refined state may be new although an earlier state has it, so the earlier
// states are no longer baselines.
void PointHistory::refine(Entry entry) {
    Entry& coarse = states_.back();
    for (std::uint32_t& index : entry.points.state.previous)
        if (index != no_point) index = coarse.points.state.previous[index];
    entry.tick = coarse.tick;
    coarse = std::move(entry);
    usable_ = 1;
}

}  // namespace jostle::snapshot
