// Reads a file with probes, and fits a regular grid of the file to the geometry.
#include <algorithm>
#include <bit>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "scene/loading/field_reader.h"
#include "scene/model/node_placement.h"
#include "scene/probes/probe_grid.h"
#include "scene/probes/scene_tree.h"
#include "weft/scene/place_probes.h"
#include "weft/syntax/json_doc.h"

namespace weft::scene {
namespace {

// The numbers that a file may contain.
using Range = FieldReader::Range;
constexpr Range kSpacing_m{0.01, 1000};
constexpr Range kBoxSide_m{0.01, double{kFarthest_m}};
constexpr Range kCoordinate{-4e6, 4e6};
constexpr Range kStride{1, 1024};
constexpr Range kPlace{-double{kFarthest_m}, double{kFarthest_m}};
constexpr Range kAnyTurn{-1, 1};

// The value of the key "volume" in the file: the volume, and the size of the grid if the file gives a size
// instead of a list of grid points.
struct VolumeText {
    ProbeVolume volume;
    std::optional<glm::ivec3> size;
};

class ProbeReader : public FieldReader {
 public:
    explicit ProbeReader(const JsonDoc& document) : FieldReader(document, "S196", "docs/probes.md") {}

    Probes read(std::optional<glm::ivec3>& size) {
        Probes probes;
        const JsonNode& root = document().root;
        if (!expect(root, JsonKind::object)) return probes;
        check_keys(root, {"version", "volume", "reflections"});
        check_version(root);
        if (const JsonNode* volume = root.find("volume")) {
            VolumeText text = read_volume(*volume);
            probes.volume = std::move(text.volume);
            size = text.size;
        }
        if (const JsonNode* list = root.find("reflections")) probes.reflections = read_reflections(*list);
        return probes;
    }

    void check_count(const ProbeVolume& volume) {
        const size_t count = volume.probes.size() - count_of(volume, ProbeState::dropped);
        if (count <= kMostIrradianceProbes) return;
        const JsonNode* node = document().root.find("volume");
        fault(node->loc, "S197",
              "the volume has " + std::to_string(count) + " probes; the limit is " +
                  std::to_string(kMostIrradianceProbes),
              "use a larger \"spacing\", or list fewer probes");
    }

 private:
    VolumeText read_volume(const JsonNode& node) {
        VolumeText out;
        if (!expect(node, JsonKind::object)) return out;
        check_keys(node, {"origin", "yaw", "spacing", "strides", "size", "probes"});
        out.volume.origin = vector(required(node, "origin"), kPlace, out.volume.origin);
        double spacing_m = 1, yaw_deg = 0;
        if (const JsonNode* spacing = required(node, "spacing"))
            number(*spacing, kSpacing_m, false, spacing_m);
        out.volume.spacing_m = static_cast<float>(spacing_m);
        if (const JsonNode* yaw = node.find("yaw")) number(*yaw, {-180, 180}, false, yaw_deg);
        out.volume.yaw_deg = static_cast<float>(yaw_deg);
        const JsonNode *size = node.find("size"), *probes = node.find("probes");
        if ((size == nullptr) == (probes == nullptr)) {
            fault(node.loc, "the volume needs either \"size\" or \"probes\"",
                  "write \"size\": [x, y, z] for a regular grid, or list the grid points in \"probes\"");
            return out;
        }
        if (size != nullptr) read_size(node, *size, out);
        if (const JsonNode* strides = node.find("strides"); strides != nullptr && size == nullptr)
            read_strides(*strides, out.volume);
        if (probes != nullptr) read_points(*probes, out.volume);
        return out;
    }

    void read_size(const JsonNode& volume, const JsonNode& node, VolumeText& out) {
        if (const JsonNode* strides = volume.find("strides"))
            fault(strides->loc, "a volume with \"size\" has one level and no \"strides\"",
                  "remove \"strides\"");
        if (const JsonNode* yaw = volume.find("yaw"))
            fault(yaw->loc, "a volume with \"size\" has no \"yaw\"",
                  "remove \"yaw\", or list the grid points in \"probes\"");
        const std::optional<glm::ivec3> size = whole_vector(node, {1, kMostGridPoints});
        if (!size) return;
        const uint64_t points =
            static_cast<uint64_t>(size->x) * static_cast<uint64_t>(size->y) * static_cast<uint64_t>(size->z);
        if (points > kMostGridPoints) {
            fault(node.loc, "S197",
                  "the grid has " + std::to_string(points) + " points; the limit is " +
                      std::to_string(kMostGridPoints),
                  "use a smaller \"size\" and a larger \"spacing\"");
            return;
        }
        out.size = size;
    }

    void read_strides(const JsonNode& node, ProbeVolume& volume) {
        if (!expect(node, JsonKind::array)) return;
        volume.strides.clear();
        for (const JsonNode& item : node.items) {
            double value = 1;
            if (!number(item, kStride, true, value)) continue;
            const uint32_t stride = static_cast<uint32_t>(value);
            if (!std::has_single_bit(stride) || (!volume.strides.empty() && stride <= volume.strides.back()))
                fault(item.loc,
                      "the stride " + std::to_string(stride) +
                          " is not a larger power of two than the one before",
                      "write powers of two in ascending order, such as [1, 2, 4]");
            volume.strides.push_back(stride);
        }
        if (volume.strides.empty()) {
            fault(node.loc, "a volume has at least one level", "write \"strides\": [1]");
            volume.strides = {1};
        }
    }

    void read_points(const JsonNode& node, ProbeVolume& volume) {
        if (!expect(node, JsonKind::array)) return;
        if (node.items.size() > kMostGridPoints) {
            fault(node.loc, "S197",
                  "the volume lists " + std::to_string(node.items.size()) + " grid points; the limit is " +
                      std::to_string(kMostGridPoints),
                  "list fewer grid points");
            return;
        }
        std::map<glm::ivec3, Probe, PointOrder> points;
        std::vector<std::pair<const JsonNode*, glm::ivec3>> substitutes;
        for (const JsonNode& item : node.items) {
            const std::optional<Probe> probe = read_point(item, volume);
            if (probe && !points.emplace(probe->at, *probe).second)
                fault(item.loc, "the grid point is listed twice", "remove one of the two entries");
            if (probe && probe->substitute)
                substitutes.push_back({item.find("substitute"), *probe->substitute});
        }
        for (const auto& [item, at] : substitutes) {
            const auto found = points.find(at);
            if (found == points.end() || found->second.state == ProbeState::dropped)
                fault(item->loc, "the volume has no probe at the grid point of the substitute",
                      "name the grid point of a probe that is listed without \"dropped\"");
        }
        for (const auto& [at, probe] : points) volume.probes.push_back(probe);
    }

    std::optional<Probe> read_point(const JsonNode& node, const ProbeVolume& volume) {
        if (!expect(node, JsonKind::object)) return std::nullopt;
        check_keys(node, {"at", "offset", "dropped", "substitute"});
        const JsonNode* at = required(node, "at");
        if (at == nullptr) return std::nullopt;
        const std::optional<glm::ivec3> point = whole_vector(*at, kCoordinate);
        if (!point) return std::nullopt;
        Probe probe{*point, 0, glm::vec3(0), ProbeState::kept};
        bool on_grid = false;
        for (uint32_t i = 0; i < volume.strides.size(); ++i) {
            const int stride = static_cast<int>(volume.strides[i]);
            if (point->x % stride != 0 || point->y % stride != 0 || point->z % stride != 0) continue;
            probe.level = i;
            on_grid = true;
        }
        if (!on_grid)
            fault(at->loc, "no level of the volume has this grid point", "use multiples of the first stride");
        if (const JsonNode* offset = node.find("offset")) {
            const float most =
                kMostOffset * volume.spacing_m * static_cast<float>(volume.strides[probe.level]);
            probe.offset = vector(offset, kPlace, probe.offset);
            probe.state = ProbeState::moved;
            if (glm::length(probe.offset) > most * 1.0001f)
                fault(offset->loc,
                      "the offset is longer than " + number_text(double{kMostOffset}) + " spacings",
                      "write an offset with a length of at most " + number_text(double{most}) + " m");
        }
        if (const JsonNode* dropped = node.find("dropped");
            dropped != nullptr && expect(*dropped, JsonKind::boolean) && dropped->boolean)
            probe.state = ProbeState::dropped;
        if (const JsonNode* substitute = node.find("substitute")) {
            probe.substitute = whole_vector(*substitute, kCoordinate);
            if (probe.state != ProbeState::dropped)
                fault(substitute->loc, "only a grid point without a probe can have a substitute",
                      "write \"dropped\": true, or remove \"substitute\"");
        }
        return probe;
    }

    std::vector<ReflectionProbe> read_reflections(const JsonNode& node) {
        std::vector<ReflectionProbe> out;
        if (!expect(node, JsonKind::array)) return out;
        if (node.items.size() > kMostReflectionProbes) {
            fault(node.loc, "S197",
                  "the file has " + std::to_string(node.items.size()) + " reflection probes; the limit is " +
                      std::to_string(kMostReflectionProbes),
                  "use larger boxes and fewer probes");
            return out;
        }
        for (const JsonNode& item : node.items) {
            if (!expect(item, JsonKind::object)) continue;
            check_keys(item, {"name", "position", "box"});
            ReflectionProbe probe;
            probe.name = "reflection " + std::to_string(out.size() + 1);
            if (const JsonNode* name = item.find("name"); name != nullptr && expect(*name, JsonKind::string))
                probe.name = name->string;
            probe.position = vector(required(item, "position"), kPlace, probe.position);
            if (const JsonNode* box = item.find("box"); box != nullptr && expect(*box, JsonKind::object))
                probe.box = read_box(*box);
            out.push_back(std::move(probe));
        }
        return out;
    }

    ProbeBox read_box(const JsonNode& node) {
        ProbeBox box;
        check_keys(node, {"center", "size", "rotation"});
        box.center = vector(required(node, "center"), kPlace, box.center);
        box.half_size_m = 0.5f * vector(required(node, "size"), kBoxSide_m, glm::vec3(2));
        const JsonNode* turn = node.find("rotation");
        const std::vector<double> v =
            turn != nullptr ? numbers(*turn, 4, kAnyTurn, false) : std::vector<double>{};
        if (v.empty()) return box;
        const glm::vec4 unit = unit_quaternion(glm::vec4(v[0], v[1], v[2], v[3]));
        box.rotation = glm::quat(unit.w, unit.x, unit.y, unit.z);
        return box;
    }
};

}  // namespace

Result<Probes> read_probes(const std::string& path, const FileReader& reader, const Scene& scene,
                           const SceneLimits& limits, const LoadOptions& options) {
    const Result<JsonDoc> document = read_json(path, reader);
    if (!document) return document.errors();
    ProbeReader file(*document);
    std::optional<glm::ivec3> size;
    Probes probes = file.read(size);
    if (!file.faults().empty()) return std::move(file.faults());
    if (size) {
        Result<TriangleTree> tree = scene_tree(scene, limits, options);
        if (!tree) return tree.take_errors();
        probes.volume = settled_grid(*tree, probes.volume, *size, options.threads);
    }
    file.check_count(probes.volume);
    if (!file.faults().empty()) return std::move(file.faults());
    if (probes.reflections.empty()) probes.reflections = scene.probes.reflections;
    return probes;
}

}  // namespace weft::scene
