// SPDX-License-Identifier: MIT
//
// Scripts of bots: lines of behaviours and numbers. What was taken has a line for every bot.
#include "clients/bot/script.h"

#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const auto script = bot::parse_script(std::string(text_of(input)), "bots.txt");
    if (!script.ok())
        return expect(script.error().message.starts_with("bots.txt"), "a refusal names the file");
    for (int i : {0, 1, 2, 1000, 1'000'000'000})
        expect(!bot::line_for(*script, i).behaviour.empty(), "every bot has something to do");
}

}  // namespace jostle::fuzz
