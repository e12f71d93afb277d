// SPDX-License-Identifier: MIT
#include "jostle/snapshot/frame_models.h"

#include <array>
#include <string_view>

#include "jostle/snapshot/start_models.h"

namespace jostle::snapshot {
namespace {

constexpr std::string_view alphabet =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+,-./:;<=>";
constexpr std::uint16_t trained = 8;  // `seen` of models that the training scenes used often

// 65536 / (1 + exp(0.4 (19.5 - level))); levels above half mirror those below.
constexpr std::array<std::uint16_t, 20> levels = {64,   64,   64,    89,    133,   198,  295,
                                                  439,  652,  968,   1434,  2117,  3108, 4531,
                                                  6537, 9296, 12964, 17625, 23222, 29502};

std::array<FrameModels, 2> read_letters() {
    std::array<FrameModels, 2> tables;
    for (std::size_t table = 0; table < 2; table++) {
        const std::string_view letters = start_model_letters[table];
        const std::span<BitModel> models = all_of(tables[table]);
        for (std::size_t i = 0; i < models.size() && i < letters.size(); i++)
            models[i] = model_of_letter(letters[i]);
    }
    return tables;
}

}  // namespace

BitModel model_of_letter(char letter) {
    const std::size_t index = alphabet.find(letter), level = index / 2;
    const std::uint32_t one = level < 20 ? levels[level] : 65536u - levels[39 - level];
    return {.one = static_cast<std::uint16_t>(one),
            .seen = index % 2 == 0 ? std::uint16_t{0} : trained};
}

const FrameModels& start_models(std::int64_t base_age) {
    static const std::array<FrameModels, 2> tables = read_letters();
    return tables[base_age > 2 ? 1 : 0];
}

}  // namespace jostle::snapshot
