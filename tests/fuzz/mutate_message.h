// SPDX-License-Identifier: MIT
//
// Varies protobuf messages field by field, so that what comes out is still a message: bytes changed
// at random rarely are, because of the lengths before each part. A quarter of all variations is of
// bytes all the same.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/values.h"

namespace jostle::fuzz {

// One field of the message, or of a message within it, is set, changed, added, moved or taken away.
void mutate(google::protobuf::Message& message, Random& random);

// For LLVMFuzzerCustomMutator: `message` is an empty one of the kind that the input holds.
std::size_t mutate_message(google::protobuf::Message& message, std::uint8_t* data, std::size_t size,
                           std::size_t size_max, unsigned seed);

// The same for inputs that are records (reader.h), of which those of `message_kind` hold messages.
// `kinds`: how many kinds of records there are.
std::size_t mutate_records(google::protobuf::Message& message, std::uint8_t message_kind,
                           std::uint8_t kinds, std::uint8_t* data, std::size_t size,
                           std::size_t size_max, unsigned seed);

}  // namespace jostle::fuzz
