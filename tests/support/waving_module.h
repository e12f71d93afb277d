// SPDX-License-Identifier: MIT
//
// A module that publishes point objects: sheets that wave, and a fountain of loose points.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/state_visitor.h"
#include "jostle/physics/world.h"

namespace jostle::test {

class Waving final : public physics::Module {
public:
    static constexpr int columns = 25, rows = 17, divisor = 3;

    std::string_view tag() const override { return "waving"; }
    void visit(physics::StateVisitor& v) override {
        v.field("steps", steps);
        v.field("sheets", sheets);
        v.field("still_after", still_after);
    }
    physics::Status configure(physics::World&, const physics::ModuleSettings& settings) override {
        for (const auto& [name, number] : settings.numbers)
            (name == "sheets" ? sheets : still_after) = static_cast<std::uint32_t>(number);
        return {};
    }
    void after_step(physics::World&, double) override {
        if (still_after == 0 || steps < still_after) steps++;
    }
    std::vector<physics::ChannelKind> channels() const override {
        return {{"", physics::ChannelForm::points, divisor}};
    }
    void publish(const physics::World&, physics::ChannelWriter& channels) const override {
        if (!channels.wants_points(0)) return;
        for (std::uint32_t key = 1; key <= sheets; key++) {
            const std::vector<physics::Vec3> points = sheet(key);
            channels.points(0, {.key = key,
                                .step = 0.002,
                                .form = physics::PointForm::grid,
                                .positions = points,
                                .columns = columns});
        }
    }

    // A sheet of 1.4 m x 1 m with waves of 10 cm; the k-th one is 20 k m from the origin.
    std::vector<physics::Vec3> sheet(std::uint32_t key) const {
        std::vector<physics::Vec3> points;
        const double time = steps / 60.0;
        for (int row = 0; row < rows; row++)
            for (int column = 0; column < columns; column++) {
                const double x = 0.06 * column, wave = 5 * x - 6 * time + 0.2 * row;
                points.push_back(
                    {20.0 * (key - 1) + x, 3 - 0.06 * row, 0.1 * std::sin(wave) * (0.3 + x)});
            }
        return points;
    }

    std::uint32_t steps = 0, sheets = 1;
    std::uint32_t still_after = 0;  // steps after which nothing moves; 0: never
};

inline void register_waving() {
    static const physics::Status known =
        physics::register_module("waving", [] { return std::make_unique<Waving>(); });
    known.expect();
}

}  // namespace jostle::test
