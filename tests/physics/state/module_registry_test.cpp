// SPDX-License-Identifier: MIT
//
// Kinds of modules by their tags.
#include "physics/src/state/module_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/physics/module.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::Contains;
using testing::HasSubstr;

struct Kite : Module {
    std::string_view tag() const override { return "kite"; }
    void visit(StateVisitor&) override {}
};

TEST(ModuleRegistry, creates_registered_modules) {
    must(register_module("kite", [] { return std::make_unique<Kite>(); }));
    EXPECT_EQ(must(make_module("kite"))->tag(), "kite");
    EXPECT_THAT(module_tags(), Contains("kite"));
    EXPECT_THAT(register_module("kite", [] { return std::make_unique<Kite>(); }).error().message,
                HasSubstr("registered already"));
    EXPECT_THAT(make_module("boat").error().message, HasSubstr("kite"));
    must(register_module("sail", [] { return std::make_unique<Kite>(); }));
    EXPECT_THAT(make_module("sail").error().message, HasSubstr("creates \"kite\""));
}

TEST(ModuleRegistry, rejects_settings_by_default) {
    World world;
    Kite kite;
    EXPECT_TRUE(kite.configure(world, {}).ok());
    EXPECT_THAT(kite.configure(world, {.numbers = {{"span", 2}}, .bodies = {}}).error().message,
                HasSubstr("accepts no settings; remove \"span\""));
}

}  // namespace
}  // namespace jostle::test
