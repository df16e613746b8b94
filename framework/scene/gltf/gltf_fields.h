// Purpose: reads the members of one JSON object, checks their types and ranges, and reports each fault with
// its JSON pointer. After a fault a function returns an empty value, or a list without the wrong items. So
// the caller can continue and find the next fault. Errors: S107 too many items, S108 wrong or missing value,
// S110 an index past the end of its array. Warnings: S154 a number out of range.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/loading/gltf_report.h"
#include "weft/scene/scene.h"

namespace weft::scene::gltf {

enum class Need : uint8_t { optional, required };

class Fields {
 public:
    // `object` must be a JSON object. `object` and `report` must live longer than the Fields object.
    Fields(const nlohmann::json& object, std::string pointer, Report& report)
        : object_(&object), pointer_(std::move(pointer)), report_(&report) {}

    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] std::string pointer_to(const std::string& key) const { return pointer_ + "/" + key; }
    [[nodiscard]] bool has(const char* key) const;
    [[nodiscard]] bool is_object(const char* key) const;
    [[nodiscard]] std::vector<std::string> keys() const;

    std::optional<uint64_t> integer(const char* key, Need need, uint64_t min, uint64_t max) const;
    // Returns the member `key` as an index into the JSON array with the name `array`, which has `size` items.
    // Returns kNone when the member is absent or wrong.
    uint32_t index(const char* key, Need need, size_t size, const char* array) const;
    std::vector<uint32_t> indices(const char* key, uint64_t max_items, size_t size, const char* array) const;
    std::optional<double> number(const char* key, Need need) const;
    // Checks an optional number. A value outside [min, max] causes only a warning, because other code clamps
    // the value later.
    void number_in(const char* key, double min, double max) const;
    // Returns exactly `length` numbers, or an empty vector when the member is absent or wrong.
    std::vector<double> numbers(const char* key, size_t length) const;
    std::optional<std::string> text(const char* key, Need need) const;
    std::vector<std::string> texts(const char* key, uint64_t max_items) const;
    void boolean(const char* key) const;
    std::optional<Fields> object(const char* key, Need need) const;
    [[nodiscard]] std::optional<Fields> extension(const char* name) const;
    // Returns the number of items in the array. Returns 0 when the member is absent, is not an array, or has
    // more than `max_items` items.
    size_t array_size(const char* key, uint64_t max_items) const;
    // Calls `visit` for every object of the array. Items that are not objects are reported and skipped.
    void each(const char* key, uint64_t max_items, const std::function<void(const Fields&)>& visit) const;

    // Reports a wrong member. `found` and `wanted` are parts of the message: "KEY is FOUND; wanted WANTED".
    void wrong(const char* key, const std::string& found, const std::string& wanted) const;
    // Reports a wrong member, too. In this message, FOUND is the value that the JSON contains.
    void wrong(const char* key, const std::string& wanted) const;

 private:
    const nlohmann::json* find(const char* key, Need need) const;
    const nlohmann::json* array(const char* key, uint64_t max_items) const;

    const nlohmann::json* object_;
    std::string pointer_;
    Report* report_;
};

// Returns a text that describes the value in messages. Examples: "text" (with its quotes), 3.5, an object, an
// array of length 2. The text has at most 60 characters.
[[nodiscard]] std::string describe(const nlohmann::json& value);
[[nodiscard]] std::string describe(double value);

// Returns the value if it is a whole number within ±2^53. 3.0 counts as the whole number 3.
[[nodiscard]] std::optional<int64_t> whole_number(const nlohmann::json& value);

}  // namespace weft::scene::gltf
