// Purpose: a glTF file as plain data after all checks. The code that builds meshes, textures and instances
// reads this data. Indices refer to the vectors of Document; kNone means that there is no such object. In
// `materials`, TextureSlot::texture is still the index of a glTF texture, and the sampler of that texture is
// already applied to the slot.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf/gltf_check.h"
#include "weft/scene/scene.h"

namespace weft::scene::gltf {

enum class ComponentType : uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

[[nodiscard]] constexpr uint32_t size_bytes(ComponentType type) {
    switch (type) {
        case ComponentType::i8:
        case ComponentType::u8:
            return 1;
        case ComponentType::i16:
        case ComponentType::u16:
            return 2;
        case ComponentType::u32:
        case ComponentType::f32:
            return 4;
    }
    return 0;
}

struct BufferView {
    uint32_t buffer = 0;
    uint64_t offset_bytes = 0;
    uint64_t length_bytes = 0;
    // Distance between the beginnings of two elements in bytes; 0 means that elements follow each other
    // without gaps.
    uint64_t stride_bytes = 0;
};

struct Sparse {
    uint64_t count = 0;
    uint32_t index_view = kNone;
    uint64_t index_offset_bytes = 0;
    ComponentType index_type = ComponentType::u32;
    uint32_t value_view = kNone;
    uint64_t value_offset_bytes = 0;
    // True if the sparse indices ascend and are below the accessor's count. check_sparse_indices() sets this
    // member.
    bool ascends = false;
};

struct Accessor {
    // Index of the accessor's buffer view. With kNone all elements are zero, except those of `sparse`.
    uint32_t view = kNone;
    uint64_t offset_bytes = 0;
    uint64_t count = 0;
    ComponentType type = ComponentType::f32;
    uint32_t components = 1;
    bool normalized = false;
    Sparse sparse;
};

// Values of Primitive::mode, as in glTF.
inline constexpr uint32_t kTriangles = 4;
inline constexpr uint32_t kTriangleStrip = 5;
inline constexpr uint32_t kTriangleFan = 6;

// `indices` and all members after it are indices of accessors.
struct Primitive {
    uint32_t mode = kTriangles;
    uint32_t material = kNone;
    uint32_t indices = kNone;
    uint32_t position = kNone;
    uint32_t normal = kNone;
    uint32_t tangent = kNone;
    uint32_t uv = kNone;
    uint32_t second_uv = kNone;
    uint32_t color = kNone;
};

struct MeshSource {
    std::string name;
    std::vector<Primitive> primitives;
};

struct Node {
    std::string name;
    glm::mat4 local{1};
    // The parts of `local`; for a node with a matrix, the identity. Such a node is never animated.
    glm::vec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 scale{1};
    std::vector<uint32_t> children;
    uint32_t mesh = kNone;
    uint32_t camera = kNone;
    uint32_t light = kNone;
};

// An image that is not decoded yet. Its data are either in `bytes` or in the buffer view `view`.
struct EncodedImage {
    std::string name;
    std::vector<uint8_t> bytes;
    uint32_t view = kNone;
};

struct Document {
    std::string name;
    std::vector<std::vector<uint8_t>> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<MeshSource> meshes;
    std::vector<EncodedImage> images;
    // For each glTF texture, the index of its image in `images`, or kNone.
    std::vector<uint32_t> texture_images;
    std::vector<Material> materials;
    // Lights by glTF index. place_nodes() sets their positions and directions from the nodes.
    std::vector<Light> lights;
    // Light functions. Their `picture` is the index of a glTF texture.
    std::vector<LightFunction> light_functions;
    // Cameras by glTF index. nullopt represents a kind of camera that Weft does not support, for example
    // orthographic.
    std::vector<std::optional<Camera>> cameras;
    std::vector<Node> nodes;
    std::vector<uint32_t> roots;
    std::vector<AnimationSource> animations;
    std::map<uint32_t, InstancingSource> instancing;
    std::map<uint32_t, ProbeSource> probes;
};

[[nodiscard]] inline std::span<const uint8_t> view_bytes(const Document& document, uint32_t view) {
    const BufferView& range = document.views[view];
    return std::span(document.buffers[range.buffer]).subspan(range.offset_bytes, range.length_bytes);
}

// Returns the end of a strided range in bytes: offset + stride * (count - 1) + element, or 0 for a count of
// 0. `element` is the size of one element. Returns nullopt when the sum does not fit into 64 bits.
[[nodiscard]] constexpr std::optional<uint64_t> extent_bytes(uint64_t offset, uint64_t stride, uint64_t count,
                                                             uint64_t element) {
    if (count == 0) return 0;
    uint64_t last = 0;
    uint64_t end = 0;
    if (__builtin_mul_overflow(stride, count - 1, &last) || __builtin_add_overflow(last, offset, &end) ||
        __builtin_add_overflow(end, element, &end)) {
        return std::nullopt;
    }
    return end;
}

}  // namespace weft::scene::gltf
