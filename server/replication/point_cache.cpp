// SPDX-License-Identifier: MIT
#include "server/replication/point_cache.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

using snapshot::no_point;
using snapshot::point_levels;

static_assert(point_objects_max == snapshot::point_objects_max &&
              world_points_max == snapshot::world_points_max &&
              physics::PointObject::points_max == snapshot::points_max &&
              physics::PointObject::triangles_max == snapshot::point_triangles_max &&
              point_coordinate_max == snapshot::point_coordinate_max);

snapshot::PointForm form_of(physics::PointForm form) {
    switch (form) {
        case physics::PointForm::loose:
            return snapshot::PointForm::loose;
        case physics::PointForm::strands:
            return snapshot::PointForm::strands;
        case physics::PointForm::grid:
            return snapshot::PointForm::grid;
        case physics::PointForm::triangles:
            return snapshot::PointForm::triangles;
        case physics::PointForm::heights:
            return snapshot::PointForm::heights;
    }
    return snapshot::PointForm::loose;
}

std::size_t points_of(const PointObjectState& state, snapshot::PointForm form) {
    return state.values.size() / snapshot::components_of(form);
}

// For each point of a state, its index in the previous one. Both lists ascend.
std::vector<std::uint32_t> links(const std::vector<std::uint32_t>& ids,
                                 const std::vector<std::uint32_t>& previous) {
    std::vector<std::uint32_t> made;
    made.reserve(ids.size());
    std::size_t at = 0;
    for (const std::uint32_t id : ids) {
        while (at < previous.size() && previous[at] < id) at++;
        const bool known = at < previous.size() && previous[at] == id;
        made.push_back(known ? static_cast<std::uint32_t>(at) : no_point);
    }
    return made;
}

}  // namespace

snapshot::PointLayout layout_of(const PointObjectDescription& object) {
    return {.form = form_of(object.form),
            .points = object.points,
            .columns = object.columns,
            .strands = object.strands,
            .triangles = object.triangles};
}

PointCache::History::History(const PointObjectDescription& object) : layout(layout_of(object)) {
    if (layout.form != snapshot::PointForm::loose) order = snapshot::PointOrder(layout);
}

std::shared_ptr<const PointObjects> PointCache::objects(const FramePtr& frame) {
    const std::lock_guard lock(mutex_);
    if (frame->tick <= tick_) return objects_;
    tick_ = frame->tick;
    if (!frame->points || frame->points == objects_) return objects_;
    objects_ = frame->points;
    std::erase_if(histories_, [&](const auto& entry) {
        return !std::ranges::binary_search(*objects_, entry.first, {},
                                           [](const auto& state) { return state->object->id; });
    });
    for (const StatePtr& state : *objects_) add(state);
    ASSERT(histories_.size() == objects_->size());
    return objects_;
}

void PointCache::add(const StatePtr& state) {
    const auto [at, fresh] = histories_.try_emplace(state->object->id, *state->object);
    History& history = at->second;
    if (!fresh && history.states.back() == state) return;
    history.states.push_back(state);
    const std::size_t points = std::max<std::size_t>(1, points_of(*state, history.layout.form));
    const std::size_t most = std::clamp<std::size_t>(points_retained / points, 4, states_retained);
    while (history.states.size() > most) history.states.pop_front();
    history.encodings.clear();
    std::erase_if(history.variants, [&](const auto& entry) {
        return entry.first.number < history.states.front()->number;
    });
}

std::shared_ptr<const PointCache::Variant> PointCache::variant(History& history,
                                                               const PointObjectState& state,
                                                               std::size_t levels) {
    std::shared_ptr<const Variant>& known = history.variants[{state.number, levels}];
    if (known) return known;
    auto made = std::make_shared<Variant>();
    made->points.number = state.number;
    made->ids = state.ids;
    made->points.values = state.values;
    if (history.layout.form != snapshot::PointForm::loose) {
        coarse_points(history.layout, history.order, made->points.values, levels);
    } else if (levels < point_levels) {
        // Each level has twice the points of the one before it.
        const std::uint32_t mask = (1u << (point_levels - levels)) - 1;
        made->ids.clear();
        made->points.values.clear();
        for (std::size_t k = 0; k < state.ids.size(); k++) {
            if ((state.ids[k] & mask) != 0) continue;
            made->ids.push_back(state.ids[k]);
            for (std::size_t c = 0; c < 3; c++)
                made->points.values.push_back(state.values[3 * k + c]);
        }
    }
    return known = std::move(made);
}

PointCache::Encoding PointCache::encoding(const PointObjectState& state, std::size_t levels,
                                          const SentStates& known) {
    ASSERT(levels >= 1 && levels <= point_levels);
    const std::lock_guard lock(mutex_);
    const auto at = histories_.find(state.object->id);
    if (at == histories_.end()) {
        // Another thread has seen the end of the object.
        History alone(*state.object);
        return encode(alone, state, levels, {});
    }
    History& history = at->second;
    if (history.states.back()->number != state.number) return encode(history, state, levels, known);
    Encoding& made = history.encodings[{levels, known}];
    if (!made.field) made = encode(history, state, levels, known);
    return made;
}

PointCache::Encoding PointCache::encode(History& history, const PointObjectState& state,
                                        std::size_t levels, const SentStates& known) const {
    // Baselines that are stored, up to the first one that is not.
    std::vector<std::shared_ptr<const Variant>> baselines;
    for (const SentPoints& sent : known) {
        const auto at = std::ranges::lower_bound(history.states, sent.number, {},
                                                 [](const StatePtr& s) { return s->number; });
        if (at == history.states.end() || (*at)->number != sent.number) break;
        baselines.push_back(variant(history, **at, sent.levels));
    }
    // Points of each state in the one before it; they differ between clients.
    snapshot::PointState now = variant(history, state, levels)->points;
    std::vector<snapshot::PointState> linked;
    const bool is_loose = history.layout.form == snapshot::PointForm::loose;
    if (is_loose) {
        const std::shared_ptr<const Variant> current = variant(history, state, levels);
        now.previous = links(current->ids,
                             baselines.empty() ? std::vector<std::uint32_t>() : baselines[0]->ids);
        for (std::size_t k = 0; k < baselines.size(); k++) {
            linked.push_back(baselines[k]->points);
            if (k + 1 < baselines.size())
                linked.back().previous = links(baselines[k]->ids, baselines[k + 1]->ids);
        }
    }
    const auto points = [&](std::size_t k) -> const snapshot::PointState* {
        if (k >= baselines.size()) return nullptr;
        return is_loose ? &linked[k] : &baselines[k]->points;
    };
    EncodedPoints encoded{
        .object = state.object->id,
        .number = state.number,
        .back = baselines.empty() ? 0 : state.number - known.front().number + 1,
        .tick = state.tick,
        .packed = snapshot::encode_points(history.layout, history.order, now,
                                          {points(0), points(1), points(2)}, levels)};
    Encoding made{.field = nullptr,
                  .baselines = baselines.size(),
                  .bytes_of_levels = encoded.packed.bytes_of_levels};
    made.field = std::make_shared<const std::string>(serialize_state_(encoded));
    return made;
}

SharedBytes PointCache::description(const PointObjectDescription& object) {
    const std::lock_guard lock(mutex_);
    const auto at = histories_.find(object.id);
    if (at == histories_.end())
        return std::make_shared<const std::string>(serialize_object_(object));
    if (!at->second.description)
        at->second.description = std::make_shared<const std::string>(serialize_object_(object));
    return at->second.description;
}

}  // namespace jostle::server
