// SPDX-License-Identifier: MIT
#include "jostle/client/point_objects.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace jostle::client {
namespace {

using snapshot::no_point;
using snapshot::PointForm;
using snapshot::PointState;

constexpr double extrapolation_s = 0.05;
constexpr double lag_max_ticks = 12;
constexpr double lag_slope = 0.1;  // of the rendered time: how fast the lag may change
constexpr std::size_t intervals_max = 3;
constexpr double elapsed_max_ticks = 15;

Error bad_object(std::uint32_t id, const std::string& what) {
    return {ErrorCode::corrupt_data, "point object " + std::to_string(id) + ": " + what};
}

Result<snapshot::PointLayout> layout_of(const v1::PointObject& object) {
    snapshot::PointLayout layout{.form = static_cast<PointForm>(object.form()),
                                 .points = object.points(),
                                 .columns = object.columns(),
                                 .strands = {object.strands().begin(), object.strands().end()},
                                 .triangles = {}};
    if (static_cast<std::size_t>(object.triangles_size()) > 3 * snapshot::point_triangles_max)
        return bad_object(object.id(), "too many triangles");
    layout.triangles.reserve(static_cast<std::size_t>(object.triangles_size()));
    std::uint32_t corner = 0;
    for (const std::int32_t step : object.triangles())
        layout.triangles.push_back(corner += static_cast<std::uint32_t>(step));
    return layout;
}

}  // namespace

Result<PointObjectView> PointObjectView::create(const v1::PointObject& description,
                                                std::uint32_t divisor) {
    if (description.step_um() == 0 || description.step_um() > 10'000'000)
        return bad_object(description.id(), "step " + std::to_string(description.step_um()) +
                                                " um; must be 1 to 10000000");
    Result<snapshot::PointLayout> layout = layout_of(description);
    if (!layout.ok()) return layout.error();
    Result<snapshot::PointHistory> history = snapshot::PointHistory::create(*std::move(layout));
    if (!history.ok()) return bad_object(description.id(), history.error().message);
    PointObjectView made(description, *std::move(history), std::max(1u, divisor));
    made.description_.clear_triangles();  // PointLayout has them
    return made;
}

PointPosition PointObjectView::position(const PointState& state, std::size_t point) const {
    const double step = 1e-6 * description_.step_um();
    if (history_.layout().form != PointForm::heights)
        return {step * state.values[3 * point], step * state.values[3 * point + 1],
                step * state.values[3 * point + 2]};
    const std::size_t columns = history_.layout().columns;
    const v1::Vec3& origin = description_.origin();
    const double spacing_x{description_.spacing_x()}, spacing_z{description_.spacing_z()};
    return {origin.x() + spacing_x * static_cast<double>(point % columns),
            origin.y() + step * state.values[point],
            origin.z() + spacing_z * static_cast<double>(point / columns)};
}

// A loose object has as many points as its newest state.
std::size_t PointObjectView::points() const {
    const std::size_t declared = history_.layout().points;
    return declared != 0 || !has_points() ? declared
                                          : history_.states().back().points.state.values.size() / 3;
}

std::vector<PointPosition> PointObjectView::newest() const {
    std::vector<PointPosition> positions;
    if (!has_points()) return positions;
    const PointState& state = history_.states().back().points.state;
    const std::size_t count = state.values.size() / snapshot::components_of(history_.layout().form);
    positions.reserve(count);
    for (std::size_t k = 0; k < count; k++) positions.push_back(position(state, k));
    return positions;
}

// An object without motion is not sent, so the shortest of the last intervals is its interval.
double PointObjectView::lag_ticks() const {
    const auto& states = history_.states();
    double interval = states.size() > 1 ? lag_max_ticks : 1;
    for (std::size_t k = states.size(); k > 1 && k + intervals_max > states.size(); k--)
        interval = std::min(interval, static_cast<double>(states[k - 1].tick - states[k - 2].tick));
    return std::max(0.0, interval - 1);
}

std::vector<PointPosition> PointObjectView::sample(double tick, double tick_hz) {
    const auto& states = history_.states();
    if (states.empty()) return {};
    const double target = lag_ticks();
    const double most = lag_slope * std::clamp(tick - last_tick_, 0.0, elapsed_max_ticks);
    lag_ = lag_ < 0 ? target : lag_ + std::clamp(target - lag_, -most, most);
    last_tick_ = tick;
    const double at = tick - lag_;
    std::size_t next = 0;
    while (next + 1 < states.size() && states[next].tick < at) next++;
    if (next == 0) next = std::min<std::size_t>(1, states.size() - 1);
    const auto& b = states[next];
    if (next == 0) return newest();
    const auto& a = states[next - 1];
    // The object moved only in the last ticks before b if it was not sent before.
    const std::uint32_t moved =
        std::min(b.tick - a.tick, divisor_ * (b.points.state.number - a.points.state.number));
    const double width = std::max(1u, moved);
    const double t =
        std::clamp((at - (b.tick - width)) / width, 0.0, 1 + extrapolation_s * tick_hz / width);
    const PointState &from = a.points.state, &to = b.points.state;
    const std::size_t count = to.values.size() / snapshot::components_of(history_.layout().form);
    std::vector<PointPosition> positions;
    positions.reserve(count);
    for (std::size_t k = 0; k < count; k++) {
        const std::size_t before = to.previous.empty() ? k : to.previous[k];
        if (before == no_point) {
            if (t >= 1) positions.push_back(position(to, k));
            continue;
        }
        PointPosition p = position(from, before);
        const PointPosition q = position(to, k);
        for (std::size_t c = 0; c < 3; c++) p[c] += t * (q[c] - p[c]);
        positions.push_back(p);
    }
    return positions;
}

void PointObjects::begin(std::vector<v1::ChannelKind> kinds) {
    kinds_ = std::move(kinds);
    objects_.clear();
    broken_.clear();
}

Status PointObjects::apply(const v1::Snapshot& snapshot) {
    Status first;
    const auto keep_first = [&](const Status& status) {
        if (first.ok() && !status.ok()) first = status;
    };
    for (const std::uint32_t id : snapshot.points_ended()) {
        objects_.erase(id);
        broken_.erase(id);
    }
    for (const v1::PointObject& object : snapshot.point_objects()) keep_first(add(object));
    for (const v1::PointUpdate& one : snapshot.points()) keep_first(update(one));
    return first;
}

std::vector<SmoothPoints> PointObjects::sample(double tick, double tick_hz) {
    std::vector<SmoothPoints> made;
    for (auto& [id, object] : objects_)
        if (object.has_points()) made.push_back({id, object.sample(tick, tick_hz)});
    return made;
}

Status PointObjects::add(const v1::PointObject& description) {
    const std::uint32_t id = description.id();
    objects_.erase(id);
    const std::size_t points = stored_points() + description.points();
    if (objects_.size() >= snapshot::point_objects_max || points > snapshot::world_points_max)
        return Error{ErrorCode::resource_exhausted,
                     "point object " + std::to_string(id) + ": too many objects or points"};
    const std::uint32_t divisor =
        description.kind() < kinds_.size() ? kinds_[description.kind()].divisor() : 1;
    Result<PointObjectView> made = PointObjectView::create(description, divisor);
    if (!made.ok()) return made.error();
    objects_.emplace(id, *std::move(made));
    return {};
}

std::size_t PointObjects::stored_points() const {
    std::size_t points = 0;
    for (const auto& [id, object] : objects_) points += object.points();
    return points;
}

Status PointObjects::update(const v1::PointUpdate& update) {
    const auto at = objects_.find(update.object());
    if (at == objects_.end()) {
        broken_.insert(update.object());
        return bad_object(update.object(), "not described");
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(update.packed().data());
    const Status added = at->second.history_.add(update.number(), update.tick(), update.back(),
                                                 {bytes, update.packed().size()}, update.crc());
    if (added.ok() && stored_points() <= snapshot::world_points_max) {
        broken_.erase(update.object());
        return {};
    }
    broken_.insert(update.object());
    if (!added.ok()) return bad_object(update.object(), added.error().message);
    objects_.erase(at);
    return bad_object(update.object(), "the objects have too many points");
}

}  // namespace jostle::client
