// SPDX-License-Identifier: MIT
#include "scenes/src/module_objects.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <set>
#include <span>
#include <vector>

#include "jostle/modules/fracture_file.h"
#include "jostle/v1/modules.pb.h"
#include "scenes/src/body_name.h"

namespace jostle::scenes {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using ModuleObject = SceneModule::ModuleObject;

std::string setting_of(const FieldDescriptor& field) {
    const std::string& named = field.options().GetExtension(v1::setting);
    return named.empty() ? field.name() : named;
}

v1::SettingRange range_of(const FieldDescriptor& field) {
    if (field.options().HasExtension(v1::range)) return field.options().GetExtension(v1::range);
    v1::SettingRange any;
    any.set_low(field.cpp_type() == FieldDescriptor::CPPTYPE_UINT32 ? 0 : -1e300);
    any.set_high(field.cpp_type() == FieldDescriptor::CPPTYPE_UINT32 ? 4294967295.0 : 1e300);
    return any;
}

bool is_vector(const FieldDescriptor& field) {
    return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE &&
           field.message_type() == v1::Vec3::descriptor();
}

double number_of(const Message& m, const FieldDescriptor& field) {
    const auto& get = *m.GetReflection();
    switch (field.cpp_type()) {
        case FieldDescriptor::CPPTYPE_BOOL:
            return get.GetBool(m, &field) ? 1 : 0;
        case FieldDescriptor::CPPTYPE_UINT32:
            return get.GetUInt32(m, &field);
        case FieldDescriptor::CPPTYPE_INT32:
            return get.GetInt32(m, &field);
        case FieldDescriptor::CPPTYPE_ENUM:
            return get.GetEnumValue(m, &field) - 1;  // 0 is UNSPECIFIED
        default:
            return get.GetDouble(m, &field);
    }
}

void set_number(Message& m, const FieldDescriptor& field, double value) {
    const auto& set = *m.GetReflection();
    switch (field.cpp_type()) {
        case FieldDescriptor::CPPTYPE_BOOL:
            return set.SetBool(&m, &field, value != 0);
        case FieldDescriptor::CPPTYPE_UINT32:
            return set.SetUInt32(&m, &field, static_cast<std::uint32_t>(value));
        case FieldDescriptor::CPPTYPE_INT32:
            return set.SetInt32(&m, &field, static_cast<std::int32_t>(value));
        case FieldDescriptor::CPPTYPE_ENUM:
            return set.SetEnumValue(&m, &field, static_cast<int>(value) + 1);
        default:
            return set.SetDouble(&m, &field, value);
    }
}

void check_size(FieldReader& in, const std::string& path, int size, const FieldDescriptor& list) {
    const v1::SettingRange range = range_of(list);
    if (size >= range.low() && size <= range.high()) return;
    const auto text = [](double count) { return std::to_string(static_cast<int>(count)); };
    in.report_error(path, "has " + std::to_string(size) + " items; it must have " +
                              text(range.low()) + " to " + text(range.high()));
}

// Reads one object, field by field; nested messages have a prefix of their own.
class ModuleObjectReader {
public:
    ModuleObjectReader(FieldReader& in, const SceneDescription& scene, ModuleObject& object)
        : in_(in), scene_(scene), object_(object) {}

    void read(const Message& m, const std::string& path, const std::string& prefix) {
        std::vector<const FieldDescriptor*> given;
        m.GetReflection()->ListFields(m, &given);
        for (const FieldDescriptor* field : given)
            read_field(m, *field, path + "." + field->name(), prefix + setting_of(*field));
        // A bytes field of an object is required.
        const auto& type = *m.GetDescriptor();
        for (int k = 0; k < type.field_count(); k++)
            if (type.field(k)->type() == FieldDescriptor::TYPE_BYTES &&
                m.GetReflection()->GetString(m, type.field(k)).empty())
                in_.report_error(path + "." + type.field(k)->name(),
                                 "is missing; it must be the contents of a file created by "
                                 "jostle-mesh fracture");
    }

private:
    void read_field(const Message& m, const FieldDescriptor& field, const std::string& path,
                    const std::string& name) {
        const auto& get = *m.GetReflection();
        if (field.is_repeated()) return read_list(m, field, path, name);
        if (is_vector(field))
            return read_vector(static_cast<const v1::Vec3&>(get.GetMessage(m, &field)), field, path,
                               name);
        if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
            return read(get.GetMessage(m, &field), path, name + "_");
        if (field.type() == FieldDescriptor::TYPE_BYTES)
            return read_fracture(get.GetString(m, &field), path, name);
        if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
            object_.bodies[name] = find_body(in_, scene_, path, get.GetString(m, &field));
            return;
        }
        const v1::SettingRange range = range_of(field);
        const double value = number_of(m, field);
        if (const auto* known = field.enum_type();
            known && (value < 0 || !known->FindValueByNumber(static_cast<int>(value) + 1)))
            in_.report_error(path, "is not a value of " + known->name());
        object_.settings[name] = in_.number(path, value, range.low(), range.high());
    }
    void read_vector(const v1::Vec3& v, const FieldDescriptor& field, const std::string& path,
                     const std::string& name) {
        const v1::SettingRange range = range_of(field);
        object_.settings[name + "_x"] = in_.number(path + ".x", v.x(), range.low(), range.high());
        object_.settings[name + "_y"] = in_.number(path + ".y", v.y(), range.low(), range.high());
        object_.settings[name + "_z"] = in_.number(path + ".z", v.z(), range.low(), range.high());
    }
    // The only bytes fields of objects are fracture files (jostle/modules/fracture_file.h).
    void read_fracture(const std::string& given, const std::string& path, const std::string& name) {
        const std::span bytes = std::as_bytes(std::span(given));
        if (const auto shape = modules::read_fracture(bytes); !shape.ok())
            in_.report_error(path, "is not a valid fracture file: " + shape.error().message);
        object_.bytes[name].assign(bytes.begin(), bytes.end());
    }
    void read_list(const Message& m, const FieldDescriptor& field, const std::string& path,
                   const std::string& name) {
        const auto& get = *m.GetReflection();
        const int size = get.FieldSize(m, &field);
        check_size(in_, path, size, field);
        for (int k = 0; k < size && !in_.failed(); k++) {
            const std::string item = path + "[" + std::to_string(k) + "]";
            const std::size_t known = object_.settings.size();
            read(get.GetRepeatedMessage(m, &field, k), item, name + std::to_string(k + 1) + "_");
            // The module knows an item only by its settings.
            if (object_.settings.size() == known && !in_.failed())
                in_.report_error(item, "is empty; it must have at least one field");
        }
    }

    FieldReader& in_;
    const SceneDescription& scene_;
    ModuleObject& object_;
};

// Writes one object and counts the settings that have a field.
class ModuleObjectWriter {
public:
    ModuleObjectWriter(const SceneDescription& scene, const ModuleObject& object)
        : scene_(scene), object_(object) {}

    // Returns false if there was nothing to write.
    bool write(Message& m, const std::string& prefix) {
        const std::size_t previous_size = written_.size();
        const auto& type = *m.GetDescriptor();
        for (int k = 0; k < type.field_count(); k++)
            write_field(m, *type.field(k), prefix + setting_of(*type.field(k)));
        return written_.size() > previous_size;
    }
    bool all_written() const {
        return written_.size() ==
               object_.settings.size() + object_.bodies.size() + object_.bytes.size();
    }

private:
    void write_field(Message& m, const FieldDescriptor& field, const std::string& name) {
        const auto& set = *m.GetReflection();
        if (field.is_repeated()) {
            for (int k = 1;; k++) {
                Message* item = set.AddMessage(&m, &field);
                if (write(*item, name + std::to_string(k) + "_")) continue;
                set.RemoveLast(&m, &field);
                return;
            }
        }
        if (is_vector(field) || field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
            if (!write(*set.MutableMessage(&m, &field), name + "_")) set.ClearField(&m, &field);
        } else if (field.type() == FieldDescriptor::TYPE_BYTES) {
            const auto bytes = object_.bytes.find(name);
            if (bytes == object_.bytes.end()) return;
            set.SetString(&m, &field,
                          std::string(reinterpret_cast<const char*>(bytes->second.data()),
                                      bytes->second.size()));
            written_.insert("bytes " + name);
        } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
            const auto body = object_.bodies.find(name);
            if (body == object_.bodies.end()) return;
            set.SetString(&m, &field, name_of(scene_, body->second));
            written_.insert("body " + name);
        } else if (const auto number = object_.settings.find(name);
                   number != object_.settings.end()) {
            set_number(m, field, number->second);
            written_.insert(name);
        }
    }

    const SceneDescription& scene_;
    const ModuleObject& object_;
    std::set<std::string> written_;
};

}  // namespace

void read_module_objects(FieldReader& in, const SceneDescription& scene, SceneModule& module,
                         const std::string& path, const Message& message) {
    const auto& type = *message.GetDescriptor();
    const auto& get = *message.GetReflection();
    for (int f = 0; f < type.field_count(); f++) {
        const FieldDescriptor& list = *type.field(f);
        const int size = get.FieldSize(message, &list);
        check_size(in, path + "." + list.name(), size, list);
        for (int k = 0; k < size && !in.failed(); k++) {
            ModuleObject& object = module.objects.emplace_back(ModuleObject{.list = list.name()});
            ModuleObjectReader(in, scene, object)
                .read(get.GetRepeatedMessage(message, &list, k),
                      path + "." + list.name() + "[" + std::to_string(k) + "]", "");
        }
    }
}

bool write_module_objects(Message& message, const SceneDescription& scene,
                          const SceneModule& module) {
    bool all = true;
    for (const ModuleObject& object : module.objects) {
        const FieldDescriptor* list = message.GetDescriptor()->FindFieldByName(object.list);
        if (!list || !list->is_repeated()) {
            all = false;
            continue;
        }
        ModuleObjectWriter writer(scene, object);
        writer.write(*message.GetReflection()->AddMessage(&message, list), "");
        all = all && writer.all_written();
    }
    return all;
}

}  // namespace jostle::scenes
