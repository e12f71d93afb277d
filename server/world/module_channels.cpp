// SPDX-License-Identifier: MIT
#include "server/world/module_channels.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

bool comes_before(const Channel& a, const Channel& b) {
    return std::tie(a.kind, a.entity) < std::tie(b.kind, b.entity);
}

constexpr std::size_t name_length_max = 32;

bool is_name(const std::string& name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return name.size() <= name_length_max && std::all_of(name.begin(), name.end(), fits);
}

Error bad_kind(const std::string& tag, const physics::ChannelKind& kind, const std::string& why) {
    return {ErrorCode::invalid_argument,
            "module \"" + tag + "\": channel \"" + kind.name + "\" " + why};
}

Result<physics::ChannelKind> full_kind(const std::string& tag, physics::ChannelKind kind) {
    if (!is_name(kind.name))
        return bad_kind(tag, kind,
                        "has an invalid name; must have at most 32 characters of a-z, 0-9 and _");
    if (kind.divisor < 1 || kind.divisor > 255)
        return bad_kind(tag, kind,
                        "has the divisor " + std::to_string(kind.divisor) + "; must be 1 to 255");
    kind.name = kind.name.empty() ? tag : tag + "." + kind.name;
    return kind;
}

}  // namespace

Result<ModuleChannels> ModuleChannels::of(const physics::World& world) {
    ModuleChannels made;
    for (const std::string& tag : world.modules()) {
        ModuleKinds module{tag, static_cast<std::uint32_t>(made.kinds_.size()), 0};
        for (physics::ChannelKind& kind : world.module(tag)->channels()) {
            Result<physics::ChannelKind> full = full_kind(tag, std::move(kind));
            if (!full.ok()) return full.error();
            for (const physics::ChannelKind& known : made.kinds_)
                if (known.name == full->name)
                    return bad_kind(tag, *full, "is declared twice; names must be unique");
            made.kinds_.push_back(*std::move(full));
            module.count++;
        }
        if (module.count > 0) made.modules_.push_back(std::move(module));
    }
    if (made.kinds_.size() > channel_kinds_max)
        return Error{ErrorCode::resource_exhausted,
                     "the modules of the world declare " + std::to_string(made.kinds_.size()) +
                         " kinds of channels; a hosted world may have at most " +
                         std::to_string(channel_kinds_max)};
    ASSERT(made.kinds_.size() <= channel_kinds_max);
    if (made.kinds_.size() < channel_kinds_max) {
        made.motion_ = static_cast<std::uint32_t>(made.kinds_.size());
        made.kinds_.push_back({.name = motion_kind});
    }
    return made;
}

std::optional<ModuleChannels::PointObjectOrigin> ModuleChannels::point_object(
    std::uint32_t id) const {
    const auto id_of = [](const auto& state) { return state->object->id; };
    const PointObjects& objects = *points();
    const auto found = std::ranges::lower_bound(objects, id, {}, id_of);
    if (found == objects.end() || id_of(*found) != id) return std::nullopt;
    const PointObjectDescription& object = *(*found)->object;
    for (const ModuleKinds& module : modules_)
        if (object.kind >= module.first && object.kind < module.first + module.count)
            return PointObjectOrigin{module.tag, object.key};
    return std::nullopt;
}

std::vector<bool> ModuleChannels::due(const ModuleKinds& module, std::uint32_t tick) const {
    std::vector<bool> due(module.count);
    ASSERT(tick > 0 && module.first + module.count <= kinds_.size());
    for (std::uint32_t k = 0; k < module.count; k++)
        due[k] = (tick - 1) % static_cast<std::uint32_t>(kinds_[module.first + k].divisor) == 0;
    // The first points do not wait for the ticks of their kind.
    for (std::uint32_t k = 0; begins_points_ && k < module.count; k++)
        if (kinds_[module.first + k].form == physics::ChannelForm::points) due[k] = true;
    return due;
}

void ModuleChannels::publish(const physics::World& world, std::uint32_t tick,
                             const physics::ChannelWriter::NameOf& name_of) {
    newly_oversized_.clear();
    if (modules_.empty() && !publishes_motion_ && channels_->empty()) return;
    ASSERT(!next_);
    next_ = std::make_shared<Channels>();
    next_values_ = 0;
    points_.begin(tick);
    for (const ModuleKinds& module : modules_) {
        const std::vector<bool> now = due(module, tick);
        // Between its ticks a kind keeps its last values, even those of entities removed since.
        for (const Channel& channel : *channels_)
            if (channel.kind >= module.first && channel.kind < module.first + module.count &&
                !now[channel.kind - module.first])
                add(channel);
        for (std::uint32_t k = 0; publishes_points_ && k < module.count; k++)
            if (!now[k]) points_.keep(module.first + k);
        if (std::none_of(now.begin(), now.end(), [](bool due) { return due; })) continue;
        publish_module(world, module, now, name_of);
    }
    points_.end();
    begins_points_ = false;
    if (publishes_motion_ && motion_) add_motion(world, name_of);
    std::stable_sort(next_->begin(), next_->end(), comes_before);
    const auto same = [](const Channel& a, const Channel& b) {
        return a.kind == b.kind && a.entity == b.entity;
    };
    next_->erase(std::unique(next_->begin(), next_->end(), same), next_->end());
    // An unchanged list keeps its pointer.
    const auto is_unchanged = [](const Channel& a, const Channel& b) {
        return a.kind == b.kind && a.entity == b.entity && a.values == b.values;
    };
    if (!std::ranges::equal(*next_, *channels_, is_unchanged)) channels_ = std::move(next_);
    next_ = nullptr;
}

void ModuleChannels::publish_module(const physics::World& world, const ModuleKinds& module,
                                    const std::vector<bool>& due,
                                    const physics::ChannelWriter::NameOf& name_of) {
    physics::ChannelWriter::OnPoints on_points;
    if (publishes_points_)
        on_points = [&](std::uint32_t kind, EntityId entity, const physics::PointObject& object) {
            if (kind >= module.count) return;
            const Status added = points_.add(world, module.first + kind, entity, object);
            if (!added.ok() && warned_.insert(module.first + kind).second)
                newly_oversized_.push_back(
                    {kinds_[module.first + kind].name, 0, added.error().message});
        };
    physics::ChannelWriter writer(name_of, due, std::move(on_points));
    world.module(module.tag)->publish(world, writer);
    for (auto& written : writer.channels())
        if (written.kind < module.count)
            add({module.first + written.kind, written.entity,
                 std::make_shared<const std::vector<std::int32_t>>(std::move(written.values))});
}

void ModuleChannels::add_motion(const physics::World& world,
                                const physics::ChannelWriter::NameOf& name_of) {
    constexpr double value_max = 1 << 30;
    world.copy_awake_bodies(bodies_);
    for (const physics::BodyState& body : bodies_) {
        if (body.type == physics::BodyType::static_body) continue;
        auto values = std::make_shared<std::vector<std::int32_t>>();
        values->reserve(6);
        for (const physics::Vec3& v : {body.linear_velocity, body.angular_velocity})
            for (int k = 0; k < 3; k++)
                values->push_back(static_cast<std::int32_t>(
                    std::lround(std::clamp(v[k] * velocity_units, -value_max, value_max))));
        if (const EntityId entity = name_of(body.id); entity != 0)
            add({*motion_, entity, std::move(values)});
    }
}

void ModuleChannels::add(Channel channel) {
    ASSERT(channel.values && channel.kind < kinds_.size());
    if (channel.values->size() > channel_values_max)
        return skip_oversized(channel, channel.values->size(), channel_values_max, " values");
    if (next_->size() == channels_max)
        return skip_oversized(channel, channels_max + 1, channels_max, " channels in a world");
    if (next_values_ + channel.values->size() > frame_values_max)
        return skip_oversized(channel, next_values_ + channel.values->size(), frame_values_max,
                              " values in a world");
    next_values_ += channel.values->size();
    ASSERT(next_values_ <= frame_values_max);
    const auto old = std::lower_bound(channels_->begin(), channels_->end(), channel, comes_before);
    if (old != channels_->end() && !comes_before(channel, *old) && *old->values == *channel.values)
        channel.values = old->values;
    next_->push_back(std::move(channel));
}

void ModuleChannels::skip_oversized(const Channel& channel, std::size_t size, std::size_t max,
                                    const char* noun) {
    ASSERT(size > max);
    if (!warned_.insert(channel.kind).second) return;
    newly_oversized_.push_back(
        {kinds_[channel.kind].name, channel.entity,
         std::to_string(size) + noun + "; at most " + std::to_string(max) + " are sent"});
}

}  // namespace jostle::server
