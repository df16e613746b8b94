#include "scene/gltf/mesh_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "scene/gltf/mesh_topology.h"
#include "scene/gltf/vertex_streams.h"
#include "scene/model/mesh_attributes.h"
#include "weft/limits.h"

namespace weft::scene::gltf {
namespace {

bool is_usable_point(const glm::vec3& p) {
    return std::abs(p.x) <= kMaxCoordinateM && std::abs(p.y) <= kMaxCoordinateM &&
           std::abs(p.z) <= kMaxCoordinateM;
}

bool reads_second_uvs(const Material& material) {
    for (const TextureSlot* slot :
         {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
          &material.occlusion_texture, &material.emissive_texture, &material.anisotropy_texture}) {
        if (slot->texture != kNone && slot->uv_set == 1) return true;
    }
    return false;
}

// Bytes per vertex in main memory: positions, normals, tangents and uvs. Colours and second uvs are optional.
constexpr uint64_t kHostBytesPerVertex = 12 + 12 + 16 + 8, kHostBytesPerColor = 16, kHostBytesPerSecondUv = 8;
// Bytes per vertex in total: main memory, the position (16 bytes) and the other attributes (24 bytes) on the
// GPU, and the staging buffer (24 bytes, because the positions and the attributes are uploaded in turn).
constexpr uint64_t kBytesPerVertex = kHostBytesPerVertex + 16 + 24 + 24;
// Bytes for each colour, second uv and index in total: main memory and the copy on the GPU. The copy has 8
// bytes for each colour or second uv, and 4 bytes for each index. The last 2 bytes for each index are a
// reserve.
constexpr uint64_t kBytesPerColor = kHostBytesPerColor + 8, kBytesPerSecondUv = kHostBytesPerSecondUv + 8,
                   kBytesPerIndex = 4 + 4 + 2;

uint64_t memory_of(const Mesh& mesh) {
    return sizeof(Mesh) + mesh.name.size() + mesh.positions.capacity() * kBytesPerVertex +
           mesh.colors.capacity() * kBytesPerColor + mesh.second_uvs.capacity() * kBytesPerSecondUv +
           mesh.indices.capacity() * kBytesPerIndex;
}

class Builder {
 public:
    Builder(const Document& document, const SceneLimits& limits, MemoryBudget& memory, Report& report)
        : document_(document), limits_(limits), memory_(memory), report_(report) {}

    // Builds the mesh of the primitive at the JSON pointer `pointer`. The mesh has no indices when no
    // triangle remains. `label` names the primitive in messages.
    Mesh build(const Primitive& primitive, const std::string& label, const std::string& pointer) {
        Mesh mesh;
        label_ = label;
        std::optional<AccessorReader> positions =
            open_accessor(document_, primitive.position, pointer + "/attributes/POSITION", report_);
        if (!positions) return mesh;
        std::vector<uint32_t> indices = read_indices(primitive, positions->count(), pointer);
        if (indices.empty() || !within_limits(indices, primitive.normal == kNone, pointer) ||
            !take(most_memory_of(primitive, indices), pointer))
            return mesh;
        drop_unusable(indices, *positions, pointer);
        if (indices.empty()) return mesh;
        const std::vector<uint32_t> used = make_compact(indices);
        mesh.indices = std::move(indices);
        mesh.positions.reserve(used.size());
        for (const uint32_t vertex : used) mesh.positions.push_back(positions->vector<glm::vec3>(vertex));
        read_attributes(primitive, {document_, report_, label, pointer + "/attributes", used}, mesh);
        // Every vertex gets uvs, even if the file has none, so that one vertex layout is enough for all
        // meshes.
        mesh.uvs.resize(mesh.positions.size(), glm::vec2(0));
        compute_bounds(mesh);
        shrink(mesh);
        return mesh;
    }
    // Gives the memory that was used to build `mesh` back to the budget. Then takes the bytes of the finished
    // mesh and its name from the budget. Returns false after a limit was exceeded: then the caller builds no
    // more meshes.
    bool settle(const Mesh& mesh, const std::string& pointer) {
        memory_.give_back(taken_bytes_);
        taken_bytes_ = 0;
        if (is_full_) return false;
        return mesh.indices.empty() ||
               take_memory(memory_, {memory_of(mesh), "S107", pointer, label_}, report_);
    }

 private:
    bool take(uint64_t bytes, const std::string& pointer) {
        is_full_ = !take_memory(memory_, {bytes, "S107", pointer, label_}, report_);
        if (is_full_) return false;
        taken_bytes_ += bytes;
        return true;
    }

    // Returns the peak memory in bytes while the mesh is built, without the memory of its indices. Vertices
    // with mirrored uvs are duplicated, and flat shading copies all vertex streams.
    [[nodiscard]] uint64_t most_memory_of(const Primitive& primitive,
                                          const std::vector<uint32_t>& indices) const {
        const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
        const uint64_t range = uint64_t{*high} - *low + 1, corners = indices.size();
        const bool flat = primitive.normal == kNone;
        const bool splits = primitive.uv != kNone && (flat || primitive.tangent == kNone);
        const uint64_t read = std::min(range, corners), drawn = flat ? corners : read;
        // Temporary data while a mesh is built: kScratch bytes per vertex and kFrame bytes per triangle.
        constexpr uint64_t kScratch = 24, kFrame = 16;
        uint64_t vertex_bytes = kHostBytesPerVertex + kScratch;
        if (primitive.color != kNone) vertex_bytes += kHostBytesPerColor;
        if (primitive.second_uv != kNone) vertex_bytes += kHostBytesPerSecondUv;
        return drawn * vertex_bytes * (splits ? 2 : 1) + (flat ? read * vertex_bytes : 0) +
               (range + read) * sizeof(uint32_t) + corners / 3 * kFrame;
    }

    // Frees unused capacity of the streams. Duplicating vertices lets the vectors grow beyond their final
    // size.
    static void shrink(Mesh& mesh) {
        mesh.positions.shrink_to_fit();
        mesh.normals.shrink_to_fit();
        mesh.tangents.shrink_to_fit();
        mesh.uvs.shrink_to_fit();
        mesh.colors.shrink_to_fit();
        mesh.second_uvs.shrink_to_fit();
    }
    void read_attributes(const Primitive& primitive, const StreamSource& from, Mesh& mesh) {
        mesh.uvs = read_uvs(from, primitive.uv, "TEXCOORD_0");
        mesh.colors = read_colors(from, primitive.color);
        read_second_uvs(primitive, from, mesh);
        if (primitive.normal == kNone) {
            make_flat(mesh);
        } else {
            read_normals(from, primitive.normal, mesh);
        }
        const bool own_tangents = primitive.normal != kNone && primitive.tangent != kNone;
        if (own_tangents && read_tangents(from, primitive.tangent, mesh)) return;
        generate_tangents(mesh, uv_set_of_tangents(primitive));
    }

    [[nodiscard]] uint32_t uv_set_of_tangents(const Primitive& primitive) const {
        if (primitive.material == kNone) return 0;
        const Material& material = document_.materials[primitive.material];
        const bool bumpy = material.normal_texture.texture != kNone;
        return bumpy ? material.normal_texture.uv_set : material.anisotropy_texture.uv_set;
    }

    // Reads the second uv set, but only if a texture of the material uses it.
    void read_second_uvs(const Primitive& primitive, const StreamSource& from, Mesh& mesh) {
        if (primitive.material == kNone) return;
        const Material& material = document_.materials[primitive.material];
        if (!reads_second_uvs(material)) return;
        mesh.second_uvs = read_uvs(from, primitive.second_uv, "TEXCOORD_1");
        if (primitive.second_uv != kNone) return;
        report_.warn("S160", from.attributes + "/TEXCOORD_1",
                     "a texture of " + gltf::label("material", primitive.material, material.name) +
                         " uses TEXCOORD_1, which " + label_ + " does not have; TEXCOORD_0 is used instead",
                     "give the mesh a second set of texture coordinates (TEXCOORD_1)");
    }

    std::vector<uint32_t> read_indices(const Primitive& primitive, uint64_t vertices,
                                       const std::string& pointer) {
        std::vector<uint32_t> indices;
        const std::optional<AccessorReader> reader =
            open_accessor(document_, primitive.indices, pointer + "/indices", report_);
        if (primitive.indices != kNone && !reader) return indices;
        uint64_t count = reader ? reader->count() : vertices;
        const uint64_t triangles = triangle_count(primitive.mode, count);
        // Triangles are counted before their indices are read and checked. Many primitives may share the same
        // indices, so a small file can contain very many triangles.
        triangles_ = saturating_add(triangles_, triangles);
        if (triangles_ > limits_.triangles) {
            report_over_limit(pointer, triangles_, "triangles", limits_.triangles);
            return indices;
        }
        if (primitive.mode == kTriangles && count % 3 != 0) {
            report_.warn("S156", pointer,
                         label_ + ": the number of indices, " + std::to_string(count) +
                             ", is not a multiple of 3; the last incomplete triangle is ignored",
                         "export the mesh as triangles");
            count -= count % 3;
        }
        // Memory for the indices in the file, plus three indices for each triangle if a strip or fan is
        // converted to a list.
        const bool lists = primitive.mode == kTriangles;
        if (!take(count * sizeof(uint32_t) + (lists ? 0 : triangles * 3 * sizeof(uint32_t)), pointer))
            return indices;
        indices.resize(count);
        if (!reader) {
            std::iota(indices.begin(), indices.end(), 0u);
            return triangle_list(primitive.mode, std::move(indices));
        }
        for (uint64_t i = 0; i < count; ++i) {
            indices[i] = reader->index(i);
            if (indices[i] < vertices) continue;
            report_.error("S111", pointer + "/indices",
                          "index " + std::to_string(i) + " is " + std::to_string(indices[i]) +
                              ", but there are " + std::to_string(vertices) + " vertices",
                          "export the scene again");
            return {};
        }
        return triangle_list(primitive.mode, std::move(indices));
    }

    // Adds the vertices of the primitive to the total before memory is allocated for them. Returns false
    // after it reported that the total exceeds the limit.
    bool within_limits(const std::vector<uint32_t>& indices, bool flat, const std::string& pointer) {
        const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
        vertices_ += std::max<uint64_t>(uint64_t{*high} - *low + 1, flat ? indices.size() : 0);
        if (vertices_ > limits_.vertices) report_over_limit(pointer, vertices_, "vertices", limits_.vertices);
        return vertices_ <= limits_.vertices;
    }

    void report_over_limit(const std::string& pointer, uint64_t found, const char* what, uint64_t limit) {
        is_full_ = true;
        report_.error(
            "S107", pointer,
            "the meshes up to this one have " + std::to_string(found) + " " + what +
                " together, the limit is " + std::to_string(limit),
            "simplify the meshes or split the scene, " + raise_limit_text("scene." + std::string(what)));
    }

    void drop_unusable(std::vector<uint32_t>& indices, const AccessorReader& positions,
                       const std::string& pointer) {
        size_t kept = 0;
        for (size_t i = 0; i + 2 < indices.size(); i += 3) {
            bool usable = true;
            for (size_t k = 0; k < 3; ++k)
                usable &= is_usable_point(positions.vector<glm::vec3>(indices[i + k]));
            if (!usable) continue;
            for (size_t k = 0; k < 3; ++k) indices[kept++] = indices[i + k];
        }
        if (kept == indices.size()) return;
        report_.warn("S152", pointer + "/attributes/POSITION",
                     label_ + ": " + std::to_string((indices.size() - kept) / 3) +
                         " triangles have a position that is not finite or beyond 1e12 m, and are ignored",
                     "remove NaN, infinite and very large positions from the mesh");
        indices.resize(kept);
    }

    // Renumbers `indices`, so that they refer only to vertices that the primitive uses. Returns the old
    // indices of these vertices in ascending order. Without this, several primitives that use parts of one
    // large buffer would each copy the whole buffer.
    static std::vector<uint32_t> make_compact(std::vector<uint32_t>& indices) {
        const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
        const uint32_t first = *low;
        std::vector<uint32_t> renumbered(*high - first + 1, kNone);
        for (const uint32_t index : indices) renumbered[index - first] = 0;
        std::vector<uint32_t> used;
        for (uint32_t i = 0; i < renumbered.size(); ++i) {
            if (renumbered[i] == kNone) continue;
            renumbered[i] = static_cast<uint32_t>(used.size());
            used.push_back(first + i);
        }
        for (uint32_t& index : indices) index = renumbered[index - first];
        return used;
    }

    const Document& document_;
    const SceneLimits& limits_;
    MemoryBudget& memory_;
    Report& report_;
    bool is_full_ = false;
    uint64_t taken_bytes_ = 0;  // Bytes taken from the memory budget for the primitive that is being built.
    std::string label_;         // Label for messages of the primitive that is being built.
    uint64_t triangles_ = 0;
    uint64_t vertices_ = 0;
};

bool is_drawable(const Primitive& primitive, const std::string& label, const std::string& pointer,
                 Report& report) {
    static constexpr std::array<const char*, 4> kModes{"points", "lines", "a line loop", "a line strip"};
    if (!has_triangles(primitive.mode)) {
        report.warn("S151", pointer + "/mode",
                    label + " consists of " + std::string(kModes[std::min<uint32_t>(primitive.mode, 3)]) +
                        " and is ignored, because Weft draws only triangles",
                    "export the mesh as triangles");
        return false;
    }
    if (primitive.position == kNone) {
        report.warn("S156", pointer + "/attributes", label + " has no POSITION and is ignored",
                    "add positions, or remove the primitive");
        return false;
    }
    return true;
}

std::string mesh_name(const MeshSource& source, size_t mesh, size_t primitive) {
    const std::string name = source.name.empty() ? "mesh " + std::to_string(mesh) : source.name;
    return source.primitives.size() > 1 ? name + "/" + std::to_string(primitive) : name;
}

// Returns a text for messages: `mesh "Body"`, or `part 2 of mesh "Body"` if the mesh has several primitives.
std::string primitive_label(const MeshSource& source, size_t mesh, size_t primitive) {
    const std::string whole = label("mesh", mesh, source.name);
    return source.primitives.size() > 1 ? "part " + std::to_string(primitive) + " of " + whole : whole;
}

}  // namespace

BuiltMeshes build_meshes(const Document& document, const SceneLimits& limits, const LoadOptions& options,
                         MemoryBudget& memory, Report& report) {
    BuiltMeshes built;
    Builder builder(document, limits, memory, report);
    StageProgress progress(options, "meshes", document.meshes.size());
    for (size_t m = 0; m < document.meshes.size(); ++m) {
        const MeshSource& source = document.meshes[m];
        std::vector<BuiltPrimitive>& primitives = built.of_gltf_mesh.emplace_back();
        for (size_t p = 0; p < source.primitives.size(); ++p) {
            const Primitive& primitive = source.primitives[p];
            const std::string pointer = "/meshes/" + std::to_string(m) + "/primitives/" + std::to_string(p);
            const std::string name = primitive_label(source, m, p);
            if (!is_drawable(primitive, name, pointer, report)) continue;
            Mesh mesh = builder.build(primitive, name, pointer);
            mesh.name = mesh_name(source, m, p);
            if (!builder.settle(mesh, pointer)) return built;
            if (mesh.indices.empty()) continue;
            primitives.push_back({static_cast<uint32_t>(built.meshes.size()), primitive.material});
            built.meshes.push_back(std::move(mesh));
        }
        progress.step();
    }
    return built;
}

}  // namespace weft::scene::gltf
