// SPDX-License-Identifier: MIT
//
// The modules that scenes of the catalogue have.
#include <memory>
#include <mutex>

#include "examples/hovercraft/hovercraft.h"
#include "jostle/modules/boats.h"
#include "jostle/modules/character.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/vehicle.h"
#include "jostle/scenes/catalog.h"
#include "scenes/src/katamari.h"

namespace jostle::scenes {
namespace {

// A program that made its own of that tag known before keeps it.
template <class M>
void make_known(const char* tag) {
    static_cast<void>(physics::register_module(tag, [] { return std::make_unique<M>(); }));
}

}  // namespace

void register_catalog_modules() {
    static std::once_flag once;
    std::call_once(once, [] {
        make_known<examples::Hovercraft>("hovercraft");
        make_known<modules::Boats>("boat");
        make_known<modules::Characters>("character");
        make_known<modules::Destruction>("destruction");
        make_known<modules::Fields>("fields");
        make_known<Katamari>("katamari");
        make_known<modules::Ragdolls>("ragdoll");
        make_known<modules::Vehicles>("vehicle");
    });
}

}  // namespace jostle::scenes
