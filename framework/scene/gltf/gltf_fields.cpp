#include "scene/gltf/gltf_fields.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "weft/limits.h"

namespace weft::scene::gltf {
namespace {

using nlohmann::json;

// Largest number that is accepted in the JSON. Products of two accepted numbers still fit into a float32.
constexpr double kMaxNumber = 1e18;
// 2^53: up to this limit, a double represents every whole number exactly.
constexpr double kMaxWhole = 9007199254740992.0;

bool is_usable_number(const json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= kMaxNumber;
}

std::string quoted(const char* key) {
    std::string text(key);
    text.insert(text.begin(), '"');
    text.push_back('"');
    return text;
}

}  // namespace

std::string describe(const json& value) {
    if (value.is_array()) return "an array of length " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

std::string describe(double value) {
    return describe(json(value));
}

std::optional<int64_t> whole_number(const json& value) {
    if (!value.is_number()) return std::nullopt;
    const double number = value.get<double>();
    if (std::abs(number) > kMaxWhole || std::floor(number) != number) return std::nullopt;
    return static_cast<int64_t>(number);
}

void Fields::wrong(const char* key, const std::string& found, const std::string& wanted) const {
    report_->error("S108", pointer_to(key), quoted(key) + " is " + found + "; wanted " + wanted,
                   "correct the value or export the scene again; the glTF Validator lists all such errors");
}

void Fields::wrong(const char* key, const std::string& wanted) const {
    const auto it = object_->find(key);
    wrong(key, it == object_->end() ? "missing" : describe(*it), wanted);
}

const json* Fields::find(const char* key, Need need) const {
    const auto it = object_->find(key);
    if (it != object_->end()) return &*it;
    if (need == Need::required) {
        report_->error("S108", pointer_, quoted(key) + " is missing",
                       "add " + quoted(key) + " or export the scene again");
    }
    return nullptr;
}

bool Fields::has(const char* key) const {
    return object_->contains(key);
}

bool Fields::is_object(const char* key) const {
    const auto it = object_->find(key);
    return it != object_->end() && it->is_object();
}

std::vector<std::string> Fields::keys() const {
    std::vector<std::string> names;
    for (const auto& [key, value] : object_->items()) names.push_back(key);
    return names;
}

std::optional<uint64_t> Fields::integer(const char* key, Need need, uint64_t min, uint64_t max) const {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    const std::optional<int64_t> number = whole_number(*value);
    if (number && *number >= 0 && static_cast<uint64_t>(*number) >= min &&
        static_cast<uint64_t>(*number) <= max) {
        return static_cast<uint64_t>(*number);
    }
    wrong(key, "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    return std::nullopt;
}

uint32_t Fields::index(const char* key, Need need, size_t size, const char* array) const {
    const json* value = find(key, need);
    if (value == nullptr) return kNone;
    const std::optional<int64_t> number = whole_number(*value);
    if (number && *number >= 0 && static_cast<uint64_t>(*number) < size)
        return static_cast<uint32_t>(*number);
    report_->error(
        "S110", pointer_to(key),
        quoted(key) + " is " + describe(*value) + ", but the file has " + std::to_string(size) + " " + array,
        size == 0 ? "add the missing " + std::string(array)
                  : "use an index of 0 to " + std::to_string(size - 1));
    return kNone;
}

std::vector<uint32_t> Fields::indices(const char* key, uint64_t max_items, size_t size,
                                      const char* array_name) const {
    std::vector<uint32_t> out;
    const json* items = array(key, max_items);
    if (items == nullptr) return out;
    for (size_t i = 0; i < items->size(); ++i) {
        const std::optional<int64_t> number = whole_number((*items)[i]);
        if (number && *number >= 0 && static_cast<uint64_t>(*number) < size) {
            out.push_back(static_cast<uint32_t>(*number));
            continue;
        }
        report_->error("S110", pointer_to(key) + "/" + std::to_string(i),
                       "the index is " + describe((*items)[i]) + ", but the file has " +
                           std::to_string(size) + " " + array_name,
                       "use the index of one of the " + std::string(array_name));
    }
    return out;
}

std::optional<double> Fields::number(const char* key, Need need) const {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (is_usable_number(*value)) return value->get<double>();
    wrong(key, "a number between -1e18 and 1e18");
    return std::nullopt;
}

void Fields::number_in(const char* key, double min, double max) const {
    const std::optional<double> value = number(key, Need::optional);
    if (!value || (*value >= min && *value <= max)) return;
    report_->warn(
        "S154", pointer_to(key),
        quoted(key) + " is " + describe(*value) + " and was clamped to " + describe(*value < min ? min : max),
        "keep the value between " + describe(min) + " and " + describe(max));
}

std::vector<double> Fields::numbers(const char* key, size_t length) const {
    const json* value = find(key, Need::optional);
    if (value == nullptr) return {};
    std::vector<double> out;
    bool good = value->is_array() && value->size() == length;
    for (size_t i = 0; good && i < length; ++i) {
        good = is_usable_number((*value)[i]);
        if (good) out.push_back((*value)[i].get<double>());
    }
    if (good) return out;
    wrong(key, "an array of " + std::to_string(length) + " numbers between -1e18 and 1e18");
    return {};
}

std::optional<std::string> Fields::text(const char* key, Need need) const {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (value->is_string()) return value->get<std::string>();
    wrong(key, "a string");
    return std::nullopt;
}

std::vector<std::string> Fields::texts(const char* key, uint64_t max_items) const {
    std::vector<std::string> out;
    const json* items = array(key, max_items);
    if (items == nullptr) return out;
    for (const json& item : *items) {
        if (item.is_string()) {
            out.push_back(item.get<std::string>());
        } else {
            wrong(key, "an array that contains " + describe(item), "an array of strings");
        }
    }
    return out;
}

void Fields::boolean(const char* key) const {
    const json* value = find(key, Need::optional);
    if (value != nullptr && !value->is_boolean()) wrong(key, "true or false");
}

std::optional<Fields> Fields::object(const char* key, Need need) const {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (value->is_object()) return Fields(*value, pointer_to(key), *report_);
    wrong(key, "an object");
    return std::nullopt;
}

std::optional<Fields> Fields::extension(const char* name) const {
    const std::optional<Fields> extensions = object("extensions", Need::optional);
    return extensions ? extensions->object(name, Need::optional) : std::nullopt;
}

const json* Fields::array(const char* key, uint64_t max_items) const {
    const json* value = find(key, Need::optional);
    if (value == nullptr) return nullptr;
    if (!value->is_array()) {
        wrong(key, "an array");
        return nullptr;
    }
    if (value->size() <= max_items) return value;
    const std::string_view name(key);
    const bool material = name == "materials" || name == "textures" || name == "images";
    report_->error("S107", pointer_to(key),
                   quoted(key) + " has " + std::to_string(value->size()) + " items, the limit is " +
                       std::to_string(max_items),
                   "split the scene into several files, " +
                       raise_limit_text(material ? "scene.materials" : "scene.arrayItems"));
    return nullptr;
}

size_t Fields::array_size(const char* key, uint64_t max_items) const {
    const json* items = array(key, max_items);
    return items != nullptr ? items->size() : 0;
}

void Fields::each(const char* key, uint64_t max_items,
                  const std::function<void(const Fields&)>& visit) const {
    const json* items = array(key, max_items);
    if (items == nullptr) return;
    for (size_t i = 0; i < items->size(); ++i) {
        std::string pointer = pointer_to(key) + "/" + std::to_string(i);
        if ((*items)[i].is_object()) {
            visit(Fields((*items)[i], std::move(pointer), *report_));
            continue;
        }
        report_->error("S108", std::move(pointer),
                       "the item is " + describe((*items)[i]) + "; wanted an object",
                       "export the scene again");
    }
}

}  // namespace weft::scene::gltf
