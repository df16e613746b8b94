#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "graph/plan/plan_fields.h"
#include "graph/plan/plan_names.h"
#include "weft/compile.h"
#include "weft/report/plan_dump.h"

namespace weft {
namespace {

using Json = nlohmann::ordered_json;

class JsonVisitor {
 public:
    template <class T>
    void operator()(const char* name, const T& value) {
        object_[name] = json_of(value);
    }

    template <class T>
    static Json json_of(const T& value) {
        if constexpr (std::is_same_v<T, Format>)
            return std::string(format_info(value).name);
        else if constexpr (std::is_same_v<T, Access>)
            return access_name(value);
        else if constexpr (std::is_enum_v<T>)
            return enum_name(value);
        else if constexpr (std::is_same_v<T, uint32_t> || kIsId<T>)
            return value == kNoId ? Json(nullptr) : Json(static_cast<uint32_t>(value));
        else if constexpr (std::is_arithmetic_v<T>)
            return value;
        else
            return object_of(value);
    }
    static Json json_of(const std::string& text) { return text; }
    static Json json_of(const AccessState& state) {
        return {{"stages", stages_text(state.stages)},
                {"access", access_text(state.access)},
                {"layout", layout_text(state.layout)}};
    }
    template <class T>
    static Json json_of(const std::vector<T>& items) {
        return array_of(items);
    }
    static Json json_of(const ClockTable& clocks) {
        Json array = Json::array();
        for (Position position(0); position < clocks.size(); ++position)
            array.push_back(array_of(clocks[position]));
        return array;
    }
    template <class T, size_t N>
    static Json json_of(const std::array<T, N>& items) {
        return array_of(items);
    }
    template <class T>
    static Json json_of(const std::optional<T>& item) {
        return item ? json_of(*item) : Json(nullptr);
    }

 private:
    template <class T>
    static Json object_of(const T& value) {
        JsonVisitor visitor;
        visit_fields(visitor, value);
        return std::move(visitor.object_);
    }
    template <class T>
    static Json array_of(const T& items) {
        Json array = Json::array();
        for (const auto& item : items) array.push_back(json_of(item));
        return array;
    }

    Json object_ = Json::object();
};

}  // namespace

std::string plan_to_json(const FramePlan& plan) {
    Json json = {{"hash", plan_hash(plan)}};
    json.update(JsonVisitor::json_of(plan));
    // Names come from files and may contain bytes that are not valid UTF-8. These bytes are replaced;
    // otherwise the JSON library would throw an exception.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace weft
