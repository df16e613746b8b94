#include <algorithm>
#include <array>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

constexpr uint64_t kMaxOffset = 1ull << 53;
// tinygltf stores the byte offsets of a sparse accessor in an int, so larger offsets are refused.
constexpr uint64_t kMaxSparseOffset = INT32_MAX;

uint64_t component_bytes(uint64_t type) {
    for (const ComponentType known : {ComponentType::i8, ComponentType::u8, ComponentType::i16,
                                      ComponentType::u16, ComponentType::u32, ComponentType::f32}) {
        if (type == static_cast<uint64_t>(known)) return size_bytes(known);
    }
    return 0;
}

bool is_index_type(uint64_t type) {
    return type == static_cast<uint64_t>(ComponentType::u8) ||
           type == static_cast<uint64_t>(ComponentType::u16) ||
           type == static_cast<uint64_t>(ComponentType::u32);
}

uint32_t component_count(std::string_view type) {
    static constexpr std::array<std::pair<std::string_view, uint32_t>, 7> kTypes{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, count] : kTypes) {
        if (type == name) return count;
    }
    return 0;
}

void check_view(Checker& c, const Fields& view) {
    const uint32_t buffer = view.index("buffer", Need::required, c.out.buffers.size(), "buffers");
    const uint64_t offset = view.integer("byteOffset", Need::optional, 0, kMaxOffset).value_or(0);
    const uint64_t length = view.integer("byteLength", Need::required, 1, kMaxOffset).value_or(0);
    const uint64_t stride = view.integer("byteStride", Need::optional, 4, 252).value_or(0);
    if (stride % 4 != 0) view.wrong("byteStride", "a multiple of 4");
    c.view_lengths.push_back(length);
    c.view_strides.push_back(stride);
    if (buffer == kNone || offset + length <= c.out.buffers[buffer].length_bytes) return;
    c.report.error("S104", view.pointer_to("byteLength"),
                   "the view covers bytes " + std::to_string(offset) + " to " +
                       std::to_string(offset + length) + ", but buffer " + std::to_string(buffer) +
                       " has only " + std::to_string(c.out.buffers[buffer].length_bytes) + " bytes",
                   "shorten the view or export the scene again");
}

void check_buffers(Checker& c) {
    c.root.each("buffers", c.limits.array_items, [&](const Fields& buffer) {
        BufferSource source;
        source.uri = buffer.text("uri", Need::optional);
        source.length_bytes = buffer.integer("byteLength", Need::required, 1, kMaxOffset).value_or(0);
        c.out.buffers.push_back(std::move(source));
    });
    c.out.buffers.resize(c.sizes["buffers"]);
    c.root.each("bufferViews", c.limits.array_items, [&](const Fields& view) { check_view(c, view); });
    c.view_lengths.resize(c.sizes["bufferViews"]);
    c.view_strides.resize(c.sizes["bufferViews"]);
}

struct Range {
    uint64_t offset = 0;
    uint64_t stride = 0;
    uint64_t count = 0;
    uint64_t element = 0;
};

void check_extent(Checker& c, const std::string& pointer, uint32_t view, const Range& range) {
    const std::optional<uint64_t> end = extent_bytes(range.offset, range.stride, range.count, range.element);
    if (end && *end <= c.view_lengths[view]) return;
    c.report.error("S104", pointer,
                   std::to_string(range.count) + " elements need " +
                       (end ? std::to_string(*end) + " bytes" : std::string("more than 2^64 bytes")) +
                       ", but buffer view " + std::to_string(view) + " has only " +
                       std::to_string(c.view_lengths[view]) + " bytes",
                   "lower \"count\" to the number of elements in the buffer view, or export the scene again");
}

void check_sparse(Checker& c, const Fields& accessor, uint64_t accessor_count, uint64_t element) {
    const std::optional<Fields> sparse = accessor.object("sparse", Need::optional);
    if (!sparse) return;
    const uint64_t max_count = std::min<uint64_t>(accessor_count, INT32_MAX);
    const uint64_t count = sparse->integer("count", Need::required, 1, max_count).value_or(0);
    // The limit applies to the sum of all accessors, to limit the time of check_sparse_indices(). Several
    // accessors may share the bytes of their indices, but each check of an accessor reads these bytes again.
    c.sparse_values += count;
    if (c.sparse_values > c.limits.vertices && c.sparse_values - count <= c.limits.vertices)
        c.report.error("S107", sparse->pointer_to("count"),
                       "the sparse accessors up to this one have " + std::to_string(c.sparse_values) +
                           " values together, the limit is " + std::to_string(c.limits.vertices),
                       "export without sparse accessors, " + raise_limit_text("scene.vertices"));
    const std::optional<Fields> indices = sparse->object("indices", Need::required);
    const std::optional<Fields> values = sparse->object("values", Need::required);
    if (!indices || !values) return;
    const uint64_t type = indices->integer("componentType", Need::required, 5121, 5125).value_or(5121);
    if (!is_index_type(type)) indices->wrong("componentType", "5121, 5123 or 5125");
    const uint32_t index_view =
        indices->index("bufferView", Need::required, c.view_lengths.size(), "bufferViews");
    const uint32_t value_view =
        values->index("bufferView", Need::required, c.view_lengths.size(), "bufferViews");
    const uint64_t index_offset =
        indices->integer("byteOffset", Need::optional, 0, kMaxSparseOffset).value_or(0);
    const uint64_t value_offset =
        values->integer("byteOffset", Need::optional, 0, kMaxSparseOffset).value_or(0);
    const uint64_t index_bytes = component_bytes(type);
    if (index_view != kNone) {
        check_extent(c, indices->pointer(), index_view, {index_offset, index_bytes, count, index_bytes});
    }
    if (value_view != kNone)
        check_extent(c, values->pointer(), value_view, {value_offset, element, count, element});
}

void check_accessor_data(Checker& c, const Fields& accessor, uint64_t count, uint64_t element) {
    const uint64_t offset = accessor.integer("byteOffset", Need::optional, 0, kMaxOffset).value_or(0);
    const uint32_t view = accessor.index("bufferView", Need::optional, c.view_lengths.size(), "bufferViews");
    if (count == 0 || element == 0) return;
    check_sparse(c, accessor, count, element);
    if (view == kNone) {
        // An accessor without a buffer view has no bytes in the file that limit the number of its elements.
        // So the scene's limit for vertices applies.
        if (count <= c.limits.vertices) return;
        c.report.error("S107", accessor.pointer_to("count"),
                       "the accessor has " + std::to_string(count) +
                           " elements without a buffer view, the limit is " +
                           std::to_string(c.limits.vertices),
                       "lower \"count\", " + raise_limit_text("scene.vertices"));
        return;
    }
    const uint64_t stride = c.view_strides[view] != 0 ? c.view_strides[view] : element;
    if (stride < element) {
        accessor.wrong("bufferView", "a view with a stride of " + std::to_string(stride) + " bytes",
                       "a stride of at least " + std::to_string(element) + " bytes, the size of an element");
    }
    check_extent(c, accessor.pointer_to("count"), view, {offset, stride, count, element});
}

void check_accessor(Checker& c, const Fields& accessor) {
    AccessorShape shape;
    shape.component_type = accessor.integer("componentType", Need::required, 5120, 5126).value_or(0);
    const uint64_t component = component_bytes(shape.component_type);
    if (shape.component_type != 0 && component == 0)
        accessor.wrong("componentType", "5120 to 5123, 5125 or 5126");
    if (const std::optional<std::string> type = accessor.text("type", Need::required)) {
        shape.components = component_count(*type);
        if (shape.components == 0) accessor.wrong("type", "SCALAR, VEC2 to VEC4 or MAT2 to MAT4");
    }
    shape.count = accessor.integer("count", Need::required, 1, kMaxOffset).value_or(0);
    shape.has_view = accessor.has("bufferView");
    accessor.boolean("normalized");
    check_accessor_data(c, accessor, shape.count, component * shape.components);
    c.accessors.push_back(shape);
}

void check_attribute(Checker& c, const Fields& attributes, const char* key, uint32_t components,
                     uint64_t count) {
    const uint32_t index = attributes.index(key, Need::optional, c.accessors.size(), "accessors");
    if (index == kNone) return;
    const AccessorShape& shape = c.accessors[index];
    const bool without_alpha = std::string_view(key) == "COLOR_0" && shape.components == 3;
    if (shape.components != components && !without_alpha) {
        attributes.wrong(key, "an accessor with " + std::to_string(shape.components) + " components",
                         "an accessor with " + std::to_string(components));
    }
    if (shape.component_type == static_cast<uint64_t>(ComponentType::u32)) {
        attributes.wrong(key, "an accessor of 32-bit integers",
                         "an accessor of floats, or of 8- or 16-bit integers");
    }
    if (shape.count != count) {
        attributes.wrong(key, "an accessor with " + std::to_string(shape.count) + " elements",
                         "an accessor with " + std::to_string(count) + " elements, as many as POSITION has");
    }
}

void check_attributes(Checker& c, const Fields& attributes) {
    static constexpr std::array<std::pair<std::string_view, uint32_t>, 6> kRead{{{"POSITION", 3},
                                                                                 {"NORMAL", 3},
                                                                                 {"TANGENT", 4},
                                                                                 {"TEXCOORD_0", 2},
                                                                                 {"TEXCOORD_1", 2},
                                                                                 {"COLOR_0", 4}}};
    const uint32_t position = attributes.index("POSITION", Need::optional, c.accessors.size(), "accessors");
    const uint64_t count = position != kNone ? c.accessors[position].count : 0;
    for (const std::string& key : attributes.keys()) {
        const auto* const known =
            std::find_if(kRead.begin(), kRead.end(), [&](const auto& r) { return r.first == key; });
        if (known == kRead.end()) {
            attributes.index(key.c_str(), Need::optional, c.accessors.size(), "accessors");
        } else if (position != kNone) {
            check_attribute(c, attributes, key.c_str(), known->second, count);
        }
    }
}

void check_primitive(Checker& c, const Fields& primitive) {
    primitive.integer("mode", Need::optional, 0, 6);
    primitive.index("material", Need::optional, c.sizes["materials"], "materials");
    const uint32_t indices = primitive.index("indices", Need::optional, c.accessors.size(), "accessors");
    if (indices != kNone) {
        const AccessorShape& shape = c.accessors[indices];
        if (shape.components != 1 || !is_index_type(shape.component_type) || !shape.has_view) {
            primitive.wrong("indices", "an accessor of another kind",
                            "a SCALAR accessor of 8-, 16- or 32-bit unsigned integers with a buffer view");
        }
    }
    if (const std::optional<Fields> attributes = primitive.object("attributes", Need::required)) {
        check_attributes(c, *attributes);
    }
}

}  // namespace

void check_geometry(Checker& c) {
    check_buffers(c);
    c.root.each("accessors", c.limits.array_items,
                [&](const Fields& accessor) { check_accessor(c, accessor); });
    c.accessors.resize(c.sizes["accessors"]);
    c.root.each("meshes", c.limits.array_items, [&](const Fields& mesh) {
        mesh.text("name", Need::optional);
        if (!mesh.has("primitives")) mesh.wrong("primitives", "an array of primitives");
        mesh.each("primitives", c.limits.array_items, [&](const Fields& p) { check_primitive(c, p); });
    });
}

}  // namespace weft::scene::gltf
