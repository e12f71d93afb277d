// SPDX-License-Identifier: MIT
#include "server/world/point_objects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

using physics::PointForm;
using physics::PointObject;
using physics::Vec3;

constexpr double step_min = 1e-6, step_max = 10;  // m

Error bad_object(const PointObject& object, const std::string& why) {
    return {ErrorCode::invalid_argument, "point object " + std::to_string(object.key) + " " + why};
}

std::size_t points_in(const PointObject& object) {
    return object.form == PointForm::heights ? object.heights.size() : object.positions.size();
}

Status check_triangles(const PointObject& object) {
    if (object.triangles.size() > 3 * PointObject::triangles_max)
        return bad_object(object, "has " + std::to_string(object.triangles.size() / 3) +
                                      " triangles; at most " +
                                      std::to_string(PointObject::triangles_max) + " are sent");
    if (object.triangles.size() % 3 != 0) return bad_object(object, "has an incomplete triangle");
    for (const std::uint32_t corner : object.triangles)
        if (corner >= object.positions.size())
            return bad_object(object, "has a triangle with the corner " + std::to_string(corner) +
                                          " of " + std::to_string(object.positions.size()) +
                                          " points");
    return {};
}

Status check_connections(const PointObject& object, std::size_t count) {
    const bool has_columns = object.form == PointForm::grid || object.form == PointForm::heights;
    if (has_columns && (object.columns == 0 || count % object.columns != 0))
        return bad_object(object, "has " + std::to_string(count) + " points in " +
                                      std::to_string(object.columns) +
                                      " columns; columns must be full");
    if (object.form == PointForm::strands) {
        std::size_t sum = 0;
        for (const std::uint32_t size : object.strands) {
            if (size == 0) return bad_object(object, "has an empty strand");
            sum += size;
        }
        if (sum != count)
            return bad_object(object, "has strands of " + std::to_string(sum) + " points and " +
                                          std::to_string(count) + " points");
    }
    return object.form == PointForm::triangles ? check_triangles(object) : Status();
}

Status check(const PointObject& object) {
    const std::size_t count = points_in(object);
    if (count > PointObject::points_max)
        return bad_object(object, "has " + std::to_string(count) + " points; at most " +
                                      std::to_string(PointObject::points_max) + " are sent");
    if (!(object.step >= step_min && object.step <= step_max))
        return bad_object(object, "has a step that is not from 1e-6 to 10 m");
    if (object.form == PointForm::loose) {
        if (!object.ids.empty() && object.ids.size() != count)
            return bad_object(object, "has " + std::to_string(object.ids.size()) + " ids of " +
                                          std::to_string(count) + " points");
        return {};
    }
    if (count == 0) return bad_object(object, "has no points");
    return check_connections(object, count);
}

std::uint32_t step_um_of(const PointObject& object) {
    return static_cast<std::uint32_t>(std::lround(1e6 * object.step));
}

// Whether clients can take the object for the one that they know. Fields of other forms are
// ignored.
bool continues(const PointObjectDescription& known, EntityId entity, const PointObject& object) {
    if (std::tie(known.entity, known.form, known.radius, known.color) !=
            std::tie(entity, object.form, object.radius, object.color) ||
        known.step_um != step_um_of(object))
        return false;
    const PointForm form = object.form;
    if (form == PointForm::loose) return true;
    if (known.points != points_in(object)) return false;
    if (form == PointForm::strands) return std::ranges::equal(known.strands, object.strands);
    if (form == PointForm::triangles) return std::ranges::equal(known.triangles, object.triangles);
    if (known.columns != object.columns) return false;
    return form == PointForm::grid ||
           std::tie(known.origin, known.spacing_x, known.spacing_z) ==
               std::tie(object.origin, object.spacing_x, object.spacing_z);
}

PointObjectDescription description_of(std::uint32_t id, std::uint32_t kind, EntityId entity,
                                      const PointObject& object) {
    const PointForm form = object.form;
    PointObjectDescription made{.id = id,
                                .kind = kind,
                                .key = object.key,
                                .entity = entity,
                                .form = form,
                                .step_um = step_um_of(object),
                                .radius = object.radius,
                                .color = object.color};
    if (form == PointForm::loose) return made;
    made.points = static_cast<std::uint32_t>(points_in(object));
    if (form == PointForm::strands) made.strands = {object.strands.begin(), object.strands.end()};
    if (form == PointForm::triangles)
        made.triangles = {object.triangles.begin(), object.triangles.end()};
    if (form == PointForm::grid || form == PointForm::heights)
        made.columns = static_cast<std::uint32_t>(object.columns);
    if (form == PointForm::heights) {
        made.origin = object.origin;
        made.spacing_x = object.spacing_x;
        made.spacing_z = object.spacing_z;
    }
    return made;
}

std::int32_t quantized(double meters, double steps_per_meter) {
    constexpr double most = point_coordinate_max;
    const double steps = meters * steps_per_meter;
    if (!(steps == steps)) return 0;  // NaN
    return static_cast<std::int32_t>(std::lround(std::clamp(steps, -most, most)));
}

std::size_t points_of(const PointObjectState& state) {
    return state.values.size() / (state.object->form == PointForm::heights ? 1 : 3);
}

// The box around the points, in m.
struct Box {
    Vec3 low, high;
};

Box box_of(const PointObjectState& state) {
    const PointObjectDescription& object = *state.object;
    const bool is_heights = object.form == PointForm::heights;
    const std::size_t components = is_heights ? 1 : 3;
    std::int32_t low[3] = {}, high[3] = {};
    for (std::size_t at = 0; at < state.values.size(); at++) {
        const std::size_t c = at % components;
        low[c] = at < components ? state.values[at] : std::min(low[c], state.values[at]);
        high[c] = at < components ? state.values[at] : std::max(high[c], state.values[at]);
    }
    const double step = 1e-6 * object.step_um;
    if (!is_heights)
        return {{step * low[0], step * low[1], step * low[2]},
                {step * high[0], step * high[1], step * high[2]}};
    const Vec3& origin = object.origin;
    const double columns = object.columns,
                 rows = static_cast<double>(state.values.size()) / columns;
    return {{origin.x, origin.y + step * low[0], origin.z},
            {origin.x + object.spacing_x * (columns - 1), origin.y + step * high[0],
             origin.z + object.spacing_z * (rows - 1)}};
}

void place(PointObjectState& state, const physics::World& world, physics::BodyId body) {
    const auto [low, high] = box_of(state);
    state.center = 0.5 * (low + high);
    state.reach = 0.5 * length(high - low) + state.object->radius;
    if (state.object->entity == 0) return;
    if (const physics::Result<physics::BodyState> carrier = world.body(body); carrier.ok())
        state.center = carrier->pose.position + rotate(carrier->pose.rotation, state.center);
}

}  // namespace

void PointObjectPublisher::begin(std::uint32_t tick) {
    tick_ = tick;
    next_.clear();
    next_points_ = 0;
}

void PointObjectPublisher::keep(std::uint32_t kind) {
    for (auto at = known_.lower_bound({kind, 0}); at != known_.end() && at->first.first == kind;) {
        const auto moved = at++;
        next_points_ += points_of(*moved->second.state);
        next_.insert(known_.extract(moved));
    }
}

Status PointObjectPublisher::add(const physics::World& world, std::uint32_t kind, EntityId entity,
                                 const PointObject& object) {
    if (Status s = check(object); !s.ok()) return s;
    const std::size_t count = points_in(object);
    if (next_.contains({kind, object.key})) return bad_object(object, "is published twice");
    if (next_.size() == point_objects_max)
        return bad_object(object, "is one more than the " + std::to_string(point_objects_max) +
                                      " objects of a world that are sent");
    if (next_points_ + count > world_points_max)
        return bad_object(object, "exceeds the " + std::to_string(world_points_max) +
                                      " points of a world that are sent");
    const auto at = known_.find({kind, object.key});
    const Known* known = at == known_.end() ? nullptr : &at->second;
    if (known && !continues(*known->state->object, entity, object)) known = nullptr;
    Known made;
    auto state = std::make_shared<PointObjectState>();
    state->object = known ? known->state->object
                          : std::make_shared<const PointObjectDescription>(
                                description_of(next_object_, kind, entity, object));
    state->number = known ? known->state->number + 1 : 1;
    state->tick = tick_;
    if (Status s = add_points(made, known, object, *state); !s.ok()) return s;
    if (!known) next_object_++;
    place(*state, world, object.body);
    const bool is_same =
        known && known->state->values == state->values && known->state->ids == state->ids;
    made.state = is_same ? known->state : std::move(state);
    next_points_ += count;
    next_.emplace(Key{kind, object.key}, std::move(made));
    return {};
}

// Quantizes the points. Loose points are ordered by their ids, which count the points of the object
// in the order in which they appeared.
Status PointObjectPublisher::add_points(Known& to, const Known* known, const PointObject& object,
                                        PointObjectState& state) {
    const double per_meter = 1e6 / state.object->step_um;
    if (object.form == PointForm::heights) {
        state.values.reserve(object.heights.size());
        for (const double height : object.heights)
            state.values.push_back(quantized(height, per_meter));
        return {};
    }
    const std::size_t count = object.positions.size();
    state.values.reserve(3 * count);
    const auto add = [&](std::size_t point) {
        const Vec3& p = object.positions[point];
        for (const double x : {p.x, p.y, p.z}) state.values.push_back(quantized(x, per_meter));
    };
    if (object.form != PointForm::loose) {
        for (std::size_t point = 0; point < count; point++) add(point);
        return {};
    }
    // The module's id and the index of each point.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> points(count);
    for (std::uint32_t k = 0; k < count; k++)
        points[k] = {object.ids.empty() ? k : object.ids[k], k};
    if (!std::ranges::is_sorted(points)) std::ranges::sort(points);
    for (std::size_t k = 1; k < count; k++)
        if (points[k - 1].first == points[k].first)
            return bad_object(object,
                              "has two points with the id " + std::to_string(points[k].first));
    to.next_id = known ? known->next_id : 1;
    to.ids.reserve(count);
    std::size_t before = 0;
    for (const auto& [id, point] : points) {
        while (known && before < known->ids.size() && known->ids[before].first < id) before++;
        const bool is_known = known && before < known->ids.size() && known->ids[before].first == id;
        to.ids.emplace_back(id, is_known ? known->ids[before].second : to.next_id++);
    }
    // By id of the state.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(count);
    for (std::size_t k = 0; k < count; k++) order[k] = {to.ids[k].second, points[k].second};
    if (!std::ranges::is_sorted(order)) std::ranges::sort(order);
    state.ids.reserve(count);
    for (const auto& [id, point] : order) {
        state.ids.push_back(id);
        add(point);
    }
    return {};
}

void PointObjectPublisher::end() {
    std::swap(known_, next_);
    next_.clear();
    PointObjects objects;
    objects.reserve(known_.size());
    for (const auto& [key, known] : known_) objects.push_back(known.state);
    std::ranges::sort(objects, {}, [](const auto& state) { return state->object->id; });
    if (objects != *objects_) objects_ = std::make_shared<const PointObjects>(std::move(objects));
}

}  // namespace jostle::server
