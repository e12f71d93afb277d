// SPDX-License-Identifier: MIT
//
// Scenes as CreateWorld takes them: read, written and read again, built and stepped.
#include "jostle/scenes/scene_file.h"
#include "tests/fuzz/exercise_scene.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    v1::Scene message;
    if (!message.ParseFromArray(input.data(), static_cast<int>(input.size()))) return;
    if (is_too_large(message)) return;
    const auto scene = scenes::from_message(message);
    if (!scene.ok()) return expect(!scene.error().message.empty(), "a refusal has a reason");
    const auto again = scenes::from_message(scenes::to_message(*scene));
    expect(again.ok(), again.ok() ? "" : "what was written is refused: " + again.error().message);
    exercise_scene(*scene);
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    static jostle::v1::Scene message;
    return jostle::fuzz::mutate_message(message, data, size, size_max, seed);
}
