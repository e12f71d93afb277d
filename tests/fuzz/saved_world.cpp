// SPDX-License-Identifier: MIT
//
// Saved worlds that were forged: refused with a reason, or loaded as worlds whose stores agree
// before and after each step, that can be asked, saved and loaded again. Particles are the module
// that saved worlds may hold.
#include <vector>

#include "jostle/modules/particles.h"
#include "jostle/physics/serialization.h"
#include "jostle/physics/world.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/particle_work.h"
#include "tests/fuzz/saved_world.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace physics;

void expect_sound(const World& world) {
    if (const auto fault = find_fault(state_of(world))) expect(false, *fault);
}

}  // namespace

void run(Bytes input) {
    modules::register_particles();
    const std::span<const std::byte> bytes = bytes_of(input);
    std::vector<std::byte> saved(bytes.begin(), bytes.end());
    update_saved_header(saved);
    auto world = load(saved);
    if (!world.ok()) return expect(!world.error().message.empty(), "a refusal has a reason");
    if (has_many_particles(*world)) return;
    static_cast<void>(world->queries().cast_ray({{0, 50, 0}, {0, -100, 0}}));
    for (int k = 0; k < 3; k++) {
        const Status stepped = world->step(1.0 / 60);
        expect(stepped.ok(),
               stepped.ok() ? "" : "a world stands still: " + stepped.error().message);
        expect_sound(*world);
    }
    std::vector<BodyState> bodies;
    world->copy_bodies(bodies);
    static_cast<void>(world->summary());
    const auto again = load(save(*world));
    expect(again.ok(), again.ok() ? "" : "what was saved is refused: " + again.error().message);
    expect(state_hash(*again) == state_hash(*world), "what was loaded is what was saved");
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
