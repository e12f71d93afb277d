// SPDX-License-Identifier: MIT
//
// Attribute values as bytes of saved worlds and journals. After malformed bytes the reader is not
// ok() and the value is false.
#pragma once

#include "server/util/bytes.h"
#include "server/world/attribute.h"

namespace jostle::server {

void write_attribute_value(ByteWriter& to, const AttributeValue& value);
AttributeValue read_attribute_value(ByteReader& from);

}  // namespace jostle::server
