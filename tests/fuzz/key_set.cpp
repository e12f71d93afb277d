// SPDX-License-Identifier: MIT
//
// Key sets of login services: JSON or not, with points of the curve or others.
#include "server/auth/key_set.h"

#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const auto keys = server::read_key_set(text_of(input));
    if (!keys.ok()) return expect(!keys.error().message.empty(), "a refusal has a reason");
    expect(!keys->keys.empty(), "a key set that was taken has a key");
    for (const auto& [id, key] : keys->keys)
        expect(!key.verifies("anything", std::string(64, '\1')), "nobody signed that");
}

}  // namespace jostle::fuzz
