// Purpose: a glTF file as plain data after all checks. The builders of meshes, textures and instances read
// it. Indices refer to the vectors of Document; kNone means absent. TextureSlot::texture of `materials` is
// still the index of a glTF texture here; the texture's sampler is already applied to the slot.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

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
    uint64_t stride_bytes = 0;  // 0: tightly packed
};

struct Sparse {
    uint64_t count = 0;
    uint32_t index_view = kNone;
    uint64_t index_offset_bytes = 0;
    ComponentType index_type = ComponentType::u32;
    uint32_t value_view = kNone;
    uint64_t value_offset_bytes = 0;
    bool ascends = false;  // true if the indices ascend and are below the accessor's count: see
                           // check_sparse_indices()
};

struct Accessor {
    uint32_t view = kNone;  // kNone: all elements are zero
    uint64_t offset_bytes = 0;
    uint64_t count = 0;
    ComponentType type = ComponentType::f32;
    uint32_t components = 1;
    bool normalized = false;
    Sparse sparse;
};

inline constexpr uint32_t kTriangles = 4;
inline constexpr uint32_t kTriangleStrip = 5;
inline constexpr uint32_t kTriangleFan = 6;

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
    std::vector<uint32_t> children;
    uint32_t mesh = kNone;
    uint32_t camera = kNone;
    uint32_t light = kNone;
};

// An image that is not decoded yet: either its own bytes or a view of a buffer.
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
    std::vector<uint32_t> texture_images;  // for each glTF texture its image, or kNone
    std::vector<Material> materials;
    std::vector<Light> lights;                   // in the coordinate space of their node
    std::vector<LightFunction> light_functions;  // `picture` is the index of a glTF texture
    std::vector<std::optional<Camera>> cameras;  // nullopt: a kind of camera that is not supported
    std::vector<Node> nodes;
    std::vector<uint32_t> roots;
};

[[nodiscard]] inline std::span<const uint8_t> view_bytes(const Document& document, uint32_t view) {
    const BufferView& range = document.views[view];
    return std::span(document.buffers[range.buffer]).subspan(range.offset_bytes, range.length_bytes);
}

// offset + stride * (count - 1) + element; 0 for a count of 0. nullopt when the sum does not fit 64 bits.
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
