// SPDX-License-Identifier: MIT
//
// Registers the modules that scenes of the catalogue use.
#include <memory>
#include <mutex>

#include "examples/hovercraft/hovercraft.h"
#include "jostle/modules/boats.h"
#include "jostle/modules/character.h"
#include "jostle/modules/cloth.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/particles.h"
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/rope.h"
#include "jostle/modules/vehicle.h"
#include "jostle/scenes/catalog.h"
#include "scenes/src/asteroids.h"
#include "scenes/src/katamari.h"

namespace jostle::scenes {
namespace {

// A module with this tag that the program registered earlier stays registered.
template <class M>
void register_once(const char* tag) {
    static_cast<void>(physics::register_module(tag, [] { return std::make_unique<M>(); }));
}

}  // namespace

void register_catalog_modules() {
    static std::once_flag once;
    std::call_once(once, [] {
        register_once<examples::Hovercraft>("hovercraft");
        register_once<Asteroids>("asteroids");
        register_once<modules::Boats>("boat");
        register_once<modules::Characters>("character");
        register_once<modules::Cloths>("cloth");
        register_once<modules::Crowd>("crowd");
        register_once<modules::Destruction>("destruction");
        register_once<modules::Fields>("fields");
        register_once<Katamari>("katamari");
        register_once<modules::Particles>("particles");
        register_once<modules::Ragdolls>("ragdoll");
        register_once<modules::Ropes>("rope");
        register_once<modules::Vehicles>("vehicle");
    });
}

}  // namespace jostle::scenes
