// SPDX-License-Identifier: MIT
//
// Saved states of cloth, with any bytes: refused with a reason, or cloth that a world steps
// with and that is saved as it was read.
#include <algorithm>
#include <memory>

#include "jostle/modules/cloth.h"
#include "jostle/physics/world.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const auto bytes = bytes_of(input);
    auto cloths = std::make_unique<modules::Cloths>();
    if (const physics::Status status = load_module(*cloths, bytes); !status.ok())
        return expect(!status.error().message.empty(), "a refusal has a reason");
    const auto saved = save_module(*cloths);
    expect(std::ranges::equal(saved, bytes), "a state is saved as it was loaded");
    physics::World world;
    expect(world.add_module(std::move(cloths)).ok(), "a world takes the module");
    for (int k = 0; k < 3; k++)
        expect(world.step(1.0 / 60).ok(), "a world steps with loaded cloth");
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
