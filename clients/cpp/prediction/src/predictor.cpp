// SPDX-License-Identifier: MIT
#include "jostle/client/predictor.h"

#include <algorithm>
#include <utility>

#include "clients/cpp/prediction/src/prediction_engine.h"
#include "jostle/scenes/locks_message.h"
#include "jostle/scenes/shape_message.h"

namespace jostle::client {

using namespace physics;

namespace {

Vec3 to_vector(const v1::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

BodyType to_type(v1::BodyType type) {
    if (type == v1::BODY_TYPE_DYNAMIC) return BodyType::dynamic;
    return type == v1::BODY_TYPE_KINEMATIC ? BodyType::kinematic : BodyType::static_body;
}

Controls to_controls(const v1::ControlInput& input) {
    Controls controls;
    const int axes = std::min(input.axes_size(), static_cast<int>(controls.axes.size()));
    for (int k = 0; k < axes; k++)
        controls.axes[static_cast<std::size_t>(k)] = std::clamp(input.axes(k) / 1000.0, -1.0, 1.0);
    controls.buttons = input.buttons();
    return controls;
}

std::optional<InputAction> to_act(const v1::Input& input) {
    switch (input.kind_case()) {
        case v1::Input::kImpulse: {
            const v1::ImpulseInput& push = input.impulse();
            const auto point =
                push.has_point() ? std::optional(to_vector(push.point())) : std::optional<Vec3>();
            return Push{push.entity(), to_vector(push.impulse()), point};
        }
        case v1::Input::kGrab:
            return Grab{input.grab().entity(), to_vector(input.grab().point())};
        case v1::Input::kDrag:
            return Drag{to_vector(input.drag().target())};
        case v1::Input::kRelease:
            return Release{};
        case v1::Input::kControl:
            return Steer{to_controls(input.control())};
        case v1::Input::kPossess:
            return Steer{};  // releases control
        default:
            return std::nullopt;  // the effect is not predicted
    }
}

std::optional<std::vector<ShapeDef>> shapes_of(const WorldView& view, std::uint32_t id) {
    std::vector<ShapeDef> shapes;
    for (const v1::Shape& told : view.entities().at(id).shapes()) {
        const v1::Shape* outline = view.resolve_shape(told);
        if (!outline) return std::nullopt;
        v1::Shape whole = *outline;
        if (outline != &told) {
            whole = told;
            whole.clear_kind();
            whole.MergeFrom(*outline);
        }
        const auto shape = scenes::shape_from_message(whole, "shape");
        if (!shape.ok()) return std::nullopt;
        shapes.push_back(*shape);
    }
    return shapes;
}

// Velocities from `jostle.motion` (server/world/module_channels.h).
class Motions {
public:
    explicit Motions(const WorldView& view)
        : at_(view.channels().begin()), end_(view.channels().end()) {
        std::uint32_t kind = 0;
        for (const v1::ChannelKind& known : view.channel_kinds()) {
            if (known.name() == motion_channel) break;
            kind++;
        }
        while (at_ != end_ && at_->kind != kind) ++at_;
        while (end_ != at_ && (end_ - 1)->kind != kind) --end_;
    }
    // Entities must be requested in ascending order.
    std::optional<Velocity> of(std::uint32_t entity) {
        while (at_ != end_ && at_->entity < entity) ++at_;
        if (at_ == end_ || at_->entity != entity || at_->values->size() != 6) return std::nullopt;
        const std::vector<std::int32_t>& told = *at_->values;
        const auto vector = [&](std::size_t k) {
            return Vec3{told[k] / velocity_units, told[k + 1] / velocity_units,
                        told[k + 2] / velocity_units};
        };
        return Velocity{vector(0), vector(3)};
    }

private:
    snapshot::Channels::const_iterator at_, end_;
};

// Bodies of the newest frame with known entities.
std::vector<BodyUpdate> bodies_of(const WorldView& view) {
    Motions motions(view);
    std::vector<BodyUpdate> bodies;
    bodies.reserve(view.frame().entities.size());
    auto known = view.entities().begin();
    for (const snapshot::EntityState& state : view.frame().entities) {
        while (known != view.entities().end() && known->first < state.id) ++known;
        if (known == view.entities().end()) break;
        if (known->first != state.id) continue;
        const v1::Entity& about = known->second;
        const Transform pose = to_transform(snapshot::dequantize(state, view.spec()));
        bodies.push_back({.entity = state.id,
                          .type = to_type(about.type()),
                          .mass = about.mass(),
                          .pose = pose,
                          .at_rest = state.at_rest,
                          .velocity = motions.of(state.id),
                          .controllable = about.controllable(),
                          .jointed = about.jointed(),
                          .linear_damping = about.linear_damping(),
                          .angular_damping = about.angular_damping(),
                          .gravity_scale = about.has_gravity_scale() ? about.gravity_scale() : 1,
                          .locks = scenes::locks_of(about.locks())});
    }
    return bodies;
}

}  // namespace

struct Predictor::Impl {
    PredictionEngine engine;
    std::uint32_t followed = 0;
    std::uint32_t newest_frame = 0, newest_control = 0;
};

Predictor::Predictor(PredictorOptions options)
    : impl_(std::make_unique<Impl>(Impl{.engine = PredictionEngine(options)})) {}
Predictor::~Predictor() = default;

void Predictor::begin(const v1::Welcome& welcome) {
    impl_->engine.begin(to_vector(welcome.gravity()), welcome.tick_hz(),
                        static_cast<int>(std::min(welcome.substeps(), 64u)));
    impl_->newest_frame = impl_->newest_control = 0;
}

void Predictor::follow(std::uint32_t entity) {
    if (impl_->followed == entity) return;
    impl_->followed = entity;
    impl_->newest_frame = 0;
    impl_->engine.follow(entity);
}

void Predictor::add_input(std::uint32_t sequence, const v1::Input& input) {
    if (auto action = to_act(input))
        impl_->engine.add_action(sequence, input.tick(), *std::move(action));
}

void Predictor::on_results(const std::vector<v1::InputResult>& results) {
    for (const v1::InputResult& result : results)
        impl_->engine.on_result(result.sequence(), result.tick(),
                                result.code() == v1::INPUT_CODE_APPLIED);
}

void Predictor::on_frame(const WorldView& view) {
    // Skips frames that were already processed and frames without a followed entity.
    const std::uint32_t frame = view.frame().frame;
    const WorldView::ControlledEntityState& controlled_entity = view.controlled_entity();
    if (frame == impl_->newest_frame && controlled_entity.tick == impl_->newest_control) return;
    impl_->newest_frame = frame;
    impl_->newest_control = controlled_entity.tick;
    std::vector<BodyUpdate> bodies;
    if (impl_->followed != 0) bodies = bodies_of(view);
    impl_->engine.on_frame({.number = frame,
                            .bodies = bodies,
                            .shapes_of = [&](std::uint32_t id) { return shapes_of(view, id); },
                            .control = {controlled_entity.entity, controlled_entity.tick,
                                        controlled_entity.module, controlled_entity.words}});
}

std::vector<SmoothPose> Predictor::sample(double position, std::int64_t now_us,
                                          std::vector<SmoothPose> interpolated) {
    return impl_->engine.sample(position, now_us, std::move(interpolated));
}

const Predictor::Stats& Predictor::stats() const {
    return impl_->engine.stats();
}

std::size_t Predictor::bodies() const {
    return impl_->engine.bodies();
}

}  // namespace jostle::client
