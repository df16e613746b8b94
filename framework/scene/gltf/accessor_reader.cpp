#include "scene/gltf/accessor_reader.h"

#include <algorithm>
#include <cstring>

namespace weft::scene::gltf {
namespace {

template <class T>
T load_value(const uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

uint32_t load_index(const uint8_t* bytes, ComponentType type) {
    if (type == ComponentType::u8) return *bytes;
    if (type == ComponentType::u16) return load_value<uint16_t>(bytes);
    return load_value<uint32_t>(bytes);
}

// Returns the bytes of `count` elements from `offset` on, or nullopt when some of them lie outside the buffer
// view. `offset`, `stride` and `element` (the size of one element) are in bytes.
std::optional<std::span<const uint8_t>> range_of(const Document& document, uint32_t view, uint64_t offset,
                                                 uint64_t stride, uint64_t count, uint64_t element) {
    const std::span<const uint8_t> bytes = view_bytes(document, view);
    const std::optional<uint64_t> end = extent_bytes(offset, stride, count, element);
    if (!end || *end > bytes.size()) return std::nullopt;
    return bytes.subspan(offset, *end - offset);
}

bool ascends(const Document& document, const Accessor& accessor) {
    const Sparse& sparse = accessor.sparse;
    const uint64_t index_bytes = size_bytes(sparse.index_type);
    const auto indices = range_of(document, sparse.index_view, sparse.index_offset_bytes, index_bytes,
                                  sparse.count, index_bytes);
    if (!indices) return false;
    uint64_t least = 0;
    for (uint64_t i = 0; i < sparse.count; ++i) {
        const uint32_t index = load_index(&(*indices)[i * index_bytes], sparse.index_type);
        if (index < least || index >= accessor.count) return false;
        least = uint64_t{index} + 1;
    }
    return true;
}

}  // namespace

void check_sparse_indices(Document& document) {
    for (Accessor& accessor : document.accessors)
        if (accessor.sparse.count != 0) accessor.sparse.ascends = ascends(document, accessor);
}

std::optional<AccessorReader> AccessorReader::open(const Document& document, uint32_t accessor) {
    const Accessor& source = document.accessors[accessor];
    AccessorReader reader;
    reader.count_ = source.count;
    reader.type_ = source.type;
    reader.components_ = source.components;
    reader.normalized_ = source.normalized;
    reader.element_bytes_ = uint64_t{size_bytes(source.type)} * source.components;
    reader.stride_bytes_ = reader.element_bytes_;
    if (source.view != kNone) {
        const uint64_t stride = document.views[source.view].stride_bytes;
        if (stride != 0) reader.stride_bytes_ = stride;
        const auto range = range_of(document, source.view, source.offset_bytes, reader.stride_bytes_,
                                    source.count, reader.element_bytes_);
        if (!range) return std::nullopt;
        reader.data_ = *range;
    }
    const Sparse& sparse = source.sparse;
    if (sparse.count == 0) return reader;
    if (!sparse.ascends) return std::nullopt;
    const uint64_t index_bytes = size_bytes(sparse.index_type);
    const auto indices = range_of(document, sparse.index_view, sparse.index_offset_bytes, index_bytes,
                                  sparse.count, index_bytes);
    const auto values = range_of(document, sparse.value_view, sparse.value_offset_bytes,
                                 reader.element_bytes_, sparse.count, reader.element_bytes_);
    if (!indices || !values) return std::nullopt;
    reader.sparse_type_ = sparse.index_type;
    reader.sparse_count_ = sparse.count;
    reader.sparse_indices_ = *indices;
    reader.sparse_values_ = *values;
    return reader;
}

std::optional<uint64_t> AccessorReader::sparse_row(uint64_t element) const {
    const uint64_t index_bytes = size_bytes(sparse_type_);
    uint64_t low = 0, high = sparse_count_;
    while (low < high) {
        const uint64_t middle = low + (high - low) / 2;
        const uint32_t index = load_index(&sparse_indices_[middle * index_bytes], sparse_type_);
        if (index == element) return middle;
        (index < element ? low : high) = index < element ? middle + 1 : middle;
    }
    return std::nullopt;
}

std::span<const uint8_t> AccessorReader::element_bytes(uint64_t element) const {
    assert(element < count_);
    if (sparse_count_ != 0) {
        if (const std::optional<uint64_t> row = sparse_row(element))
            return sparse_values_.subspan(*row * element_bytes_, element_bytes_);
    }
    if (data_.empty()) return {};
    return data_.subspan(element * stride_bytes_, element_bytes_);
}

float AccessorReader::component(uint64_t element, uint32_t component) const {
    assert(component < components_);
    const std::span<const uint8_t> bytes = element_bytes(element);
    if (bytes.empty()) return 0;
    const uint8_t* at = &bytes[uint64_t{component} * size_bytes(type_)];
    switch (type_) {
        case ComponentType::f32:
            return load_value<float>(at);
        case ComponentType::u8:
            return static_cast<float>(*at) / (normalized_ ? 255.0f : 1.0f);
        case ComponentType::u16:
            return static_cast<float>(load_value<uint16_t>(at)) / (normalized_ ? 65535.0f : 1.0f);
        case ComponentType::i8: {
            const auto value = static_cast<float>(load_value<int8_t>(at));
            return normalized_ ? std::max(value / 127.0f, -1.0f) : value;
        }
        case ComponentType::i16: {
            const auto value = static_cast<float>(load_value<int16_t>(at));
            return normalized_ ? std::max(value / 32767.0f, -1.0f) : value;
        }
        case ComponentType::u32:
            return static_cast<float>(load_value<uint32_t>(at));
    }
    return 0;
}

uint32_t AccessorReader::index(uint64_t element) const {
    const std::span<const uint8_t> bytes = element_bytes(element);
    return bytes.empty() ? 0 : load_index(bytes.data(), type_);
}

}  // namespace weft::scene::gltf
