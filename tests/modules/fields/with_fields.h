// SPDX-License-Identifier: MIT
//
// A world with a Fields module, in one line.
#pragma once

#include "jostle/modules/fields.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {

using namespace physics;

inline Fields& fields_of(World& world) {
    register_fields();
    if (world.module("fields") == nullptr) test::must(world.add_module(std::make_unique<Fields>()));
    return *dynamic_cast<Fields*>(world.module("fields"));
}

inline FieldKey add_field(World& world, const VolumeField& field) {
    return test::must(fields_of(world).add(world, field));
}

}  // namespace jostle::modules
