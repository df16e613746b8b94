// Reads the file of a camera path, and computes the tangents of its curves.
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "scene/loading/field_reader.h"
#include "weft/scene/camera_path.h"

namespace weft::scene {
namespace {

using Range = FieldReader::Range;
constexpr Range kTime_s{0, 1e6};
constexpr Range kPlace_m{-1e9, 1e9};
constexpr Range kFieldOfView_deg{0.01, 179};
constexpr double kUsualFieldOfView_deg = 50;

struct Key {
    double time_s = 0;
    glm::vec4 eye{0}, at{0};
    double fov_y_deg = kUsualFieldOfView_deg;
    bool cut = false;
};

class PathReader : public FieldReader {
 public:
    explicit PathReader(const JsonDoc& document) : FieldReader(document, "S195", "docs/command-line.md") {}

    std::vector<Key> read() {
        std::vector<Key> keys;
        const JsonNode& root = document().root;
        if (!expect(root, JsonKind::object)) return keys;
        check_keys(root, {"version", "keys"});
        check_version(root);
        const JsonNode* list = required(root, "keys");
        if (list == nullptr || !expect(*list, JsonKind::array)) return keys;
        if (list->items.empty()) fault(list->loc, "the path has no keys", "add at least one key");
        if (list->items.size() > kMostCameraKeys) {
            fault(list->loc,
                  "the path has " + count_text(list->items.size(), "key") + "; the limit is " +
                      std::to_string(kMostCameraKeys),
                  "write fewer keys");
            return keys;
        }
        for (const JsonNode& item : list->items) keys.push_back(read_key(item, keys));
        return keys;
    }

 private:
    Key read_key(const JsonNode& node, const std::vector<Key>& before) {
        Key key;
        if (!before.empty()) key.fov_y_deg = before.back().fov_y_deg;
        if (!expect(node, JsonKind::object)) return key;
        check_keys(node, {"time", "eye", "at", "fovY", "cut"});
        const JsonNode *time = required(node, "time"), *eye = required(node, "eye"),
                       *at = required(node, "at");
        if (time != nullptr && number(*time, kTime_s, false, key.time_s) && !before.empty() &&
            static_cast<float>(key.time_s) <= static_cast<float>(before.back().time_s))
            fault(time->loc, "the time of this key is not after the time of the key before it",
                  "write the keys in the order of their times, with different times");
        key.eye = glm::vec4(vector(eye, kPlace_m, glm::vec3(0)), 0);
        key.at = glm::vec4(vector(at, kPlace_m, glm::vec3(0, 0, -1)), 0);
        if (eye != nullptr && at != nullptr && glm::distance(key.eye, key.at) < 1e-6f)
            fault(node.loc, "the camera has no view direction, because it looks at its own position",
                  "write two different points in \"eye\" and \"at\"");
        if (const JsonNode* fov = node.find("fovY")) number(*fov, kFieldOfView_deg, false, key.fov_y_deg);
        if (const JsonNode* cut = node.find("cut"); cut != nullptr && expect(*cut, JsonKind::boolean))
            key.cut = cut->boolean;
        return key;
    }
};

// Returns a smooth curve through all values. The tangent at a key is the slope between the key before and the
// key after it; at the first and the last key, the slope to the only neighbour. The tangent is 0 if the value
// stays the same before or after the key, so that a camera that stands does not drift. Source: Catmull and
// Rom 1974, "A Class of Local Interpolating Splines", with unequal times.
MotionSampler curve_through(const std::vector<float>& times_s, const std::vector<glm::vec4>& values) {
    MotionSampler curve{Interpolation::cubic_spline, false, times_s, {}};
    for (size_t i = 0; i < values.size(); ++i) {
        const size_t before = i == 0 ? i : i - 1, after = std::min(i + 1, values.size() - 1);
        const bool stands = (before < i && values[before] == values[i]) ||
                            (i < after && values[i] == values[after]) || before == after;
        const glm::vec4 tangent =
            stands ? glm::vec4(0) : (values[after] - values[before]) / (times_s[after] - times_s[before]);
        curve.values.insert(curve.values.end(), {tangent, values[i], tangent});
    }
    return curve;
}

CameraShot shot_of(const std::vector<Key>& keys) {
    std::vector<float> times_s;
    std::vector<glm::vec4> eyes, ats, fields;
    for (const Key& key : keys) {
        times_s.push_back(static_cast<float>(key.time_s));
        eyes.push_back(key.eye);
        ats.push_back(key.at);
        fields.emplace_back(static_cast<float>(glm::radians(key.fov_y_deg)), 0, 0, 0);
    }
    return {curve_through(times_s, eyes), curve_through(times_s, ats), curve_through(times_s, fields)};
}

}  // namespace

Result<CameraPath> read_camera_path(const std::string& file, const FileReader& reader) {
    const Result<JsonDoc> document = read_json(file, reader);
    if (!document) return document.errors();
    PathReader path_reader(*document);
    const std::vector<Key> keys = path_reader.read();
    if (!path_reader.faults().empty()) return std::move(path_reader.faults());
    CameraPath path;
    for (size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
        for (end = begin + 1; end < keys.size() && !keys[end].cut;) ++end;
        path.shots.push_back(shot_of({keys.begin() + static_cast<std::ptrdiff_t>(begin),
                                      keys.begin() + static_cast<std::ptrdiff_t>(end)}));
    }
    return path;
}

}  // namespace weft::scene
