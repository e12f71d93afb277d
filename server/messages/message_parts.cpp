// SPDX-License-Identifier: MIT
#include "server/messages/message_parts.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include <array>
#include <cstdint>

#include "jostle/base/check.h"
#include "jostle/v1/scene.pb.h"

namespace jostle::server {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedOutputStream;

std::string encode_header(int field_number, std::string_view own, std::size_t shared_bytes) {
    const std::uint32_t tag =
        WireFormatLite::MakeTag(field_number, WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
    std::array<std::uint8_t, 10> bytes{};  // a tag and a length of at most five bytes each
    std::uint8_t* end = CodedOutputStream::WriteTagToArray(tag, bytes.data());
    end = CodedOutputStream::WriteVarint32ToArray(
        static_cast<std::uint32_t>(own.size() + shared_bytes), end);
    std::string header(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::size_t>(end - bytes.data()));
    ASSERT(header.size() >= 2 && header.size() <= bytes.size());
    header += own;
    return header;
}

v1::BodyType to_message(physics::BodyType type) {
    switch (type) {
        case physics::BodyType::static_body:
            return v1::BODY_TYPE_STATIC;
        case physics::BodyType::kinematic:
            return v1::BODY_TYPE_KINEMATIC;
        case physics::BodyType::dynamic:
            return v1::BODY_TYPE_DYNAMIC;
    }
    return v1::BODY_TYPE_UNSPECIFIED;
}

}  // namespace jostle::server
