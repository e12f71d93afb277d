// SPDX-License-Identifier: MIT
//
// Saved states of ropes, with any bytes: refused with a reason, or ropes that a world steps
// with and that are saved as they were read.
#include <algorithm>
#include <memory>

#include "jostle/modules/rope.h"
#include "jostle/physics/world.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const auto bytes = bytes_of(input);
    auto ropes = std::make_unique<modules::Ropes>();
    if (const physics::Status status = load_module(*ropes, bytes); !status.ok())
        return expect(!status.error().message.empty(), "a refusal has a reason");
    const auto saved = save_module(*ropes);
    expect(std::ranges::equal(saved, bytes), "a state is saved as it was loaded");
    physics::World world;
    expect(world.add_module(std::move(ropes)).ok(), "a world takes the module");
    for (int k = 0; k < 3; k++)
        expect(world.step(1.0 / 60).ok(), "a world steps with loaded ropes");
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
