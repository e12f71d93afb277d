// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutate_message.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <vector>

#include "tests/fuzz/reader.h"

namespace jostle::fuzz {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr std::size_t text_growth = 24;

std::string mutated_text(std::string text, bool is_text) {
    const std::size_t before = text.size();
    text.resize(before + text_growth);
    text.resize(
        LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), before, text.size()));
    // Mostly what can be UTF-8: else the message would not be read at all.
    if (is_text)
        for (char& c : text) c = static_cast<char>(c & 0x7f);
    return text;
}

// Sets or changes one field that holds a single value.
void mutate_single(Message& m, const FieldDescriptor& field, Random& random) {
    const Reflection& r = *m.GetReflection();
    switch (field.cpp_type()) {
        case FieldDescriptor::CPPTYPE_DOUBLE:
            return r.SetDouble(&m, &field, mutated_number(r.GetDouble(m, &field), random));
        case FieldDescriptor::CPPTYPE_FLOAT:
            return r.SetFloat(&m, &field,
                              std::bit_cast<float>(static_cast<std::uint32_t>(any_bits(random))));
        case FieldDescriptor::CPPTYPE_BOOL:
            return r.SetBool(&m, &field, !r.GetBool(m, &field));
        case FieldDescriptor::CPPTYPE_ENUM:
            return r.SetEnumValue(&m, &field, static_cast<int>(below(random, 8)));
        case FieldDescriptor::CPPTYPE_UINT32:
            return r.SetUInt32(
                &m, &field,
                static_cast<std::uint32_t>(mutated_integer(r.GetUInt32(m, &field), random)));
        case FieldDescriptor::CPPTYPE_UINT64:
            return r.SetUInt64(&m, &field, mutated_integer(r.GetUInt64(m, &field), random));
        case FieldDescriptor::CPPTYPE_INT32:
            return r.SetInt32(
                &m, &field,
                static_cast<std::int32_t>(mutated_integer(
                    static_cast<std::uint64_t>(std::int64_t{r.GetInt32(m, &field)}), random)));
        case FieldDescriptor::CPPTYPE_INT64:
            return r.SetInt64(&m, &field,
                              static_cast<std::int64_t>(mutated_integer(
                                  static_cast<std::uint64_t>(r.GetInt64(m, &field)), random)));
        case FieldDescriptor::CPPTYPE_STRING:
            return r.SetString(
                &m, &field,
                mutated_text(r.GetString(m, &field), field.type() == FieldDescriptor::TYPE_STRING));
        case FieldDescriptor::CPPTYPE_MESSAGE:
            return mutate(*r.MutableMessage(&m, &field), random);
    }
}

void mutate_element(Message& m, const FieldDescriptor& field, int at, Random& random) {
    const Reflection& r = *m.GetReflection();
    switch (field.cpp_type()) {
        case FieldDescriptor::CPPTYPE_DOUBLE:
            return r.SetRepeatedDouble(&m, &field, at,
                                       mutated_number(r.GetRepeatedDouble(m, &field, at), random));
        case FieldDescriptor::CPPTYPE_UINT32:
            return r.SetRepeatedUInt32(&m, &field, at,
                                       below(random, 2) == 0
                                           ? below(random, 16)
                                           : static_cast<std::uint32_t>(any_bits(random)));
        case FieldDescriptor::CPPTYPE_MESSAGE:
            return mutate(*r.MutableRepeatedMessage(&m, &field, at), random);
        default:
            return;
    }
}

// A new element: a copy of one that is there, or an empty one that is varied at once.
void add_element(Message& m, const FieldDescriptor& field, Random& random) {
    const Reflection& r = *m.GetReflection();
    const int size = r.FieldSize(m, &field);
    const int from =
        size == 0 ? -1 : static_cast<int>(below(random, static_cast<std::uint32_t>(size)));
    switch (field.cpp_type()) {
        case FieldDescriptor::CPPTYPE_DOUBLE:
            return r.AddDouble(
                &m, &field,
                mutated_number(from < 0 ? 1 : r.GetRepeatedDouble(m, &field, from), random));
        case FieldDescriptor::CPPTYPE_UINT32:
            return r.AddUInt32(&m, &field, below(random, 16));
        case FieldDescriptor::CPPTYPE_MESSAGE: {
            Message& fresh = *r.AddMessage(&m, &field);
            if (from >= 0 && below(random, 4) != 0)
                fresh.CopyFrom(r.GetRepeatedMessage(m, &field, from));
            return mutate(fresh, random);
        }
        default:
            return;
    }
}

void mutate_repeated(Message& m, const FieldDescriptor& field, Random& random) {
    const Reflection& r = *m.GetReflection();
    const auto size = static_cast<std::uint32_t>(r.FieldSize(m, &field));
    if (size == 0) return add_element(m, field, random);
    const int a = static_cast<int>(below(random, size)), b = static_cast<int>(below(random, size));
    switch (below(random, 8)) {
        case 0:
            return add_element(m, field, random);
        case 1:
            r.SwapElements(&m, &field, a, static_cast<int>(size) - 1);
            return r.RemoveLast(&m, &field);
        case 2:
            return r.SwapElements(&m, &field, a, b);
        default:
            return mutate_element(m, field, a, random);
    }
}

// Unpacks records; what is no record at the end is left out.
struct OwnedRecord {
    std::uint8_t kind = 0;
    std::string bytes;
};
std::vector<OwnedRecord> unpack(Bytes input) {
    std::vector<OwnedRecord> records;
    for (Reader in(input); !in.done();) {
        const Record record = take_record(in);
        records.push_back({record.kind, std::string(text_of(record.bytes))});
    }
    return records;
}
std::string pack(const std::vector<OwnedRecord>& records) {
    std::string out;
    for (const OwnedRecord& record : records) {
        const std::size_t size = std::min<std::size_t>(record.bytes.size(), 0xffff);
        out += static_cast<char>(record.kind);
        out += static_cast<char>(size & 0xff);
        out += static_cast<char>(size >> 8);
        out.append(record.bytes, 0, size);
    }
    return out;
}

std::size_t copy_back(const std::string& changed, std::uint8_t* data, std::size_t size,
                      std::size_t size_max) {
    if (changed.size() > size_max) return LLVMFuzzerMutate(data, size, size_max);
    std::copy(changed.begin(), changed.end(), data);
    return changed.size();
}

}  // namespace

void mutate(Message& message, Random& random) {
    const Reflection& r = *message.GetReflection();
    const auto& descriptor = *message.GetDescriptor();
    if (descriptor.field_count() == 0) return;
    std::vector<const FieldDescriptor*> exists;
    r.ListFields(message, &exists);
    // Mostly what is there already: messages would else grow without end.
    const FieldDescriptor* field =
        !exists.empty() && below(random, 4) != 0
            ? exists[below(random, static_cast<std::uint32_t>(exists.size()))]
            : descriptor.field(static_cast<int>(
                  below(random, static_cast<std::uint32_t>(descriptor.field_count()))));
    if (below(random, 12) == 0) return r.ClearField(&message, field);
    if (field->is_repeated()) return mutate_repeated(message, *field, random);
    mutate_single(message, *field, random);
}

std::size_t mutate_message(Message& message, std::uint8_t* data, std::size_t size,
                           std::size_t size_max, unsigned seed) {
    Random random(seed + 1);
    if (below(random, 4) == 0) return LLVMFuzzerMutate(data, size, size_max);
    message.Clear();
    static_cast<void>(message.ParsePartialFromArray(data, static_cast<int>(size)));
    for (std::uint32_t k = 1 + below(random, 3); k > 0; k--) mutate(message, random);
    return copy_back(message.SerializePartialAsString(), data, size, size_max);
}

std::size_t mutate_records(Message& message, std::uint8_t message_kind, std::uint8_t kinds,
                           std::uint8_t* data, std::size_t size, std::size_t size_max,
                           unsigned seed) {
    Random random(seed + 1);
    if (below(random, 8) == 0) return LLVMFuzzerMutate(data, size, size_max);
    std::vector<OwnedRecord> records = unpack({data, size});
    const std::uint32_t count = static_cast<std::uint32_t>(records.size());
    const std::uint32_t a = below(random, count), b = below(random, count);
    switch (count == 0 ? 0 : below(random, 8)) {
        case 0: {
            OwnedRecord fresh{static_cast<std::uint8_t>(below(random, kinds)), {}};
            if (count > 0 && below(random, 2) == 0) fresh = records[a];
            records.insert(records.begin() + b, fresh);
            break;
        }
        case 1:
            records.erase(records.begin() + a);
            break;
        case 2:
            std::swap(records[a], records[b]);
            break;
        case 3:
            records[a].kind = static_cast<std::uint8_t>(below(random, kinds));
            break;
        default: {
            std::string& bytes = records[a].bytes;
            if (records[a].kind % kinds != message_kind || below(random, 8) == 0) {
                bytes = mutated_text(std::move(bytes), false);
                break;
            }
            message.Clear();
            static_cast<void>(message.ParsePartialFromString(bytes));
            for (std::uint32_t k = 1 + below(random, 3); k > 0; k--) mutate(message, random);
            bytes = message.SerializePartialAsString();
        }
    }
    return copy_back(pack(records), data, size, size_max);
}

}  // namespace jostle::fuzz
