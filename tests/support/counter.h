// SPDX-License-Identifier: MIT
//
// A test module that counts steps and publishes the count for a body. It can stop publishing,
// publish more values or publish less often.
#pragma once

#include <memory>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::test {

class Counter final : public physics::Module {
public:
    explicit Counter(std::string tag = "counter") : tag_(std::move(tag)) {}

    std::string_view tag() const override { return tag_; }
    void visit(physics::StateVisitor& v) override {
        v.field("steps", steps);
        v.field("every", every);
        v.field("until", until);
        v.field("watched", observed_body);
    }
    Status configure(physics::World&, const physics::ModuleSettings& settings) override {
        for (const auto& [name, number] : settings.numbers)
            (name == "every" ? every : until) = static_cast<std::uint32_t>(number);
        for (const auto& [name, body] : settings.bodies) observed_body = body;
        return {};
    }
    void after_step(physics::World&, double) override { steps++; }
    std::vector<physics::ChannelKind> channels() const override { return kinds; }
    void publish(const physics::World&, physics::ChannelWriter& channels) const override {
        for (std::size_t kind = 0; kind < kinds.size(); kind++) {
            if ((until != 0 && count() >= until) || !channels.begin(kind, observed_body)) continue;
            channels.value(static_cast<std::int32_t>(count()));
            for (std::size_t k = 0; k < padding; k++) channels.value(0);
        }
    }

    std::uint32_t count() const { return steps / every; }

    std::uint32_t steps = 0;
    std::uint32_t every = 1;  // steps per count
    std::uint32_t until = 0;  // the count at which it stops publishing; 0: never
    physics::BodyId observed_body;
    std::size_t padding = 0;                         // additional values after the count
    std::vector<physics::ChannelKind> kinds = {{}};  // each publishes the count

private:
    const std::string tag_;
};

// Several tests of a program may call this.
inline void register_counter() {
    static const Status known =
        physics::register_module("counter", [] { return std::make_unique<Counter>(); });
    known.expect();
}

}  // namespace jostle::test
