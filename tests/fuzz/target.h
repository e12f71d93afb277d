// SPDX-License-Identifier: MIT
//
// What a fuzz target is: a file that defines run(). It is handed one input after another, and must
// neither crash, nor hang, nor take more memory than the input is worth, nor find a promise broken.
// docs/design/fuzzing.md says how to add one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

// libFuzzer's own variation, for targets that have one of theirs (LLVMFuzzerCustomMutator).
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t size_max);

namespace jostle::fuzz {

using Bytes = std::span<const std::uint8_t>;

// Each target defines it. The same bytes do the same again: a report is replayed from its file.
void run(Bytes input);

// A promise of ours that no input may break; libFuzzer reports the abort with the input.
inline void expect(bool promise, const std::string& what) {
    if (promise) return;
    std::fprintf(stderr, "broken promise: %s\n", what.c_str());
    std::abort();
}

inline std::string_view text_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline std::span<const std::byte> bytes_of(Bytes bytes) {
    return std::as_bytes(bytes);
}

}  // namespace jostle::fuzz
