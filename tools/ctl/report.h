// SPDX-License-Identifier: MIT
//
// What jostlectl says of an answer: a table or a sentence for people, the message as JSON for
// programs. Pure functions.
#pragma once

#include <string>

#include "jostle/v1/admin.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::ctl {

std::string worlds_text(const v1::ListWorldsResponse& worlds);
std::string clients_text(const v1::ListClientsResponse& clients);

// The answer as protobuf's JSON, in lines; zeros are there.
std::string json_text(const google::protobuf::Message& message);

}  // namespace jostle::ctl
