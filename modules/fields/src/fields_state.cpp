// SPDX-License-Identifier: MIT
//
// Serialization of fields. Loaded values are untrusted.
#include <algorithm>

#include "jostle/modules/fields.h"
#include "jostle/modules/settings.h"
#include "jostle/physics/limits.h"
#include "modules/fields/src/field_checks.h"
#include "modules/fields/src/field_scratch.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Visits a variant: its index, then the fields of the alternative by `visit_kind(v, kind)`.
template <class Variant, std::size_t kind = 0, class VisitKind>
void visit_variant(StateVisitor& v, std::uint8_t index, Variant& variant, VisitKind&& visit_kind) {
    if constexpr (kind < std::variant_size_v<Variant>) {
        if (index != kind) return visit_variant<Variant, kind + 1>(v, index, variant, visit_kind);
        if (v.loading()) variant.template emplace<kind>();
        visit_kind(std::get<kind>(variant));
    } else {
        v.fail("kind", "is not a valid kind");
    }
}

template <class Variant, class VisitKind>
void visit_kinds(StateVisitor& v, std::string_view name, Variant& variant, VisitKind&& visit_kind) {
    v.enter(name);
    auto index = static_cast<std::uint8_t>(variant.index());
    v.field("kind", index);
    visit_variant(v, index, variant, visit_kind);
    v.leave();
}

struct VisitVolume {
    StateVisitor& v;

    void operator()(Everywhere&) const {}
    void operator()(BoxVolume& box) const {
        v.field("pose", box.pose);
        v.field("half_extents", box.half_extents);
    }
    void operator()(SphereVolume& sphere) const {
        v.field("center", sphere.center);
        v.field("radius", sphere.radius);
    }
    void operator()(CapsuleVolume& capsule) const {
        v.field("from", capsule.from);
        v.field("to", capsule.to);
        v.field("radius", capsule.radius);
    }
};

struct VisitLaw {
    StateVisitor& v;

    void operator()(Central& central) const {
        v.field("body", central.body);
        v.field("point", central.point);
        v.field("strength", central.strength);
        v.field("falloff", central.falloff);
        v.field("nearest", central.min_distance);
        v.field("per_mass", central.per_mass);
    }
    void operator()(Turbulence& t) const {
        v.field("wind", t.wind);
        v.field("speed", t.speed);
        v.field("scale", t.scale);
        v.field("rate", t.rate);
        v.field("octaves", t.octaves);
        v.field("seed", t.seed);
        v.field("density", t.density);
        v.field("drag", t.drag);
    }
    void operator()(UserField& user) const {
        v.field("law", user.law);
        v.all("parameters", user.parameters, [&](double& p) { v.field("value", p); });
        v.field("per_mass", user.per_mass);
        v.field("steady", user.steady);
    }
    void operator()(Waves& waves) const {
        v.field("level", waves.level);
        v.field("density", waves.density);
        v.all("components", waves.components, [&](WaveComponent& wave) {
            v.field("amplitude", wave.amplitude);
            v.field("length", wave.length);
            v.field("heading", wave.heading);
            v.field("phase", wave.phase);
        });
        v.field("flow", waves.flow);
        v.field("drag", waves.drag);
        v.field("damping", waves.damping);
    }
};

void visit_explosion(StateVisitor& v, Explosion& e) {
    v.field("center", e.center);
    v.field("radius", e.radius);
    v.field("strength", e.strength);
    v.field("core", e.core);
    v.field("falloff", e.falloff);
    v.field("fade", e.fade);
    v.field("standoff", e.standoff);
    v.field("points", e.points);
    v.field("mask", e.mask);
    v.field("most_speed", e.max_speed);
}

}  // namespace

void Fields::visit_entry(StateVisitor& v, Entry& entry) {
    v.field("key", entry.key.number);
    visit_kinds(v, "law", entry.field.law, VisitLaw{v});
    visit_kinds(v, "volume", entry.field.volume, VisitVolume{v});
    v.field("mask", entry.field.mask);
    v.field("seen", entry.last_wake_position);
    if (!v.loading()) return;
    if (Status s = fields_detail::check(entry.field); !s.ok()) v.fail("law", s.error().message);
    if (entry.key.number == 0 || entry.key.number > last_key_)
        v.fail("key", "was not assigned yet");
    entry.force = nullptr;
    const auto* user = std::get_if<UserField>(&entry.field.law);
    if (user != nullptr) entry.force = find_user_field(user->law);
}

void Fields::visit(StateVisitor& v) {
    v.field("last_key", last_key_);
    v.all("fields", entries_, [&](Entry& entry) { visit_entry(v, entry); });
    v.all("charges", charges_, [&](Charge& charge) {
        v.field("time", charge.time);
        visit_explosion(v, charge.explosion);
        if (!v.loading()) return;
        if (Status s = fields_detail::check(charge); !s.ok()) v.fail("time", s.error().message);
    });
    if (!v.loading()) return;
    if (entries_.size() > fields_max) v.fail("fields", "has more than 64 elements");
    if (count_waters_except({}) > waters_max) v.fail("fields", "has more than 4 waters");
    if (charges_.size() > charges_max) v.fail("charges", "has more than 128 elements");
    // Fields are in the order of add(), so keys are unique and increasing.
    const auto not_increasing = [](const Entry& a, const Entry& b) { return !(a.key < b.key); };
    if (std::ranges::adjacent_find(entries_, not_increasing) != entries_.end())
        v.fail("fields", "has keys that are not strictly increasing");
}

void Fields::restored(const World&) {
    scratch_->body_cache.clear();
    blasts_.clear();
}

}  // namespace jostle::modules
