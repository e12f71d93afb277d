// SPDX-License-Identifier: MIT
//
// Formats responses for jostlectl: tables and sentences, or the message as JSON. Pure functions.
#pragma once

#include <string>

#include "jostle/v1/admin.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::ctl {

std::string worlds_text(const v1::ListWorldsResponse& worlds);
std::string room_text(const v1::GetRoomResponse& room);
std::string clients_text(const v1::ListClientsResponse& clients);
std::string reports_text(const v1::ListReportsResponse& reports);
std::string players_text(const v1::ListPlayersResponse& players);
std::string attributes_text(const v1::GetAttributesResponse& attributes);
std::string bans_text(const v1::ListBansResponse& bans);

// The message as multi-line protobuf JSON, including zero values.
std::string json_text(const google::protobuf::Message& message);

}  // namespace jostle::ctl
