// Purpose: random access to the elements of one accessor as floats or indices, for every component type and
// stride, dense or sparse. open() checks the accessor's extent against the loaded bytes once more. After
// that, every element below count() is readable.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/gltf/gltf_document.h"

namespace weft::scene::gltf {

// Checks that the indices of every sparse accessor ascend and are below its count. Stores the results in
// Sparse::ascends. So each accessor is checked only once per file, although several primitives may open it.
void check_sparse_indices(Document& document);

class AccessorReader {
 public:
    // Call check_sparse_indices() first. Returns nullopt when the accessor reaches past the end of its bytes,
    // or when its sparse indices do not ascend or are not below its count.
    [[nodiscard]] static std::optional<AccessorReader> open(const Document& document, uint32_t accessor);

    [[nodiscard]] uint64_t count() const { return count_; }
    // Returns one component of an element as a float. Normalised integers are mapped to [0, 1] or [-1, 1];
    // other values are returned unchanged.
    [[nodiscard]] float component(uint64_t element, uint32_t component) const;
    [[nodiscard]] uint32_t index(uint64_t element) const;

    template <class Vector>
    [[nodiscard]] Vector vector(uint64_t element) const {
        Vector out;
        for (int i = 0; i < Vector::length(); ++i) out[i] = component(element, static_cast<uint32_t>(i));
        return out;
    }

 private:
    // Returns the bytes of one element. The span is empty when the file stores no data for the element: then
    // the element is zero.
    [[nodiscard]] std::span<const uint8_t> element_bytes(uint64_t element) const;

    std::span<const uint8_t> data_;
    uint64_t stride_bytes_ = 0;
    uint64_t element_bytes_ = 0;
    uint64_t count_ = 0;
    ComponentType type_ = ComponentType::f32;
    uint32_t components_ = 1;
    bool normalized_ = false;
    // Returns the position of `element` in the sparse indices, or nullopt if it is not there.
    [[nodiscard]] std::optional<uint64_t> sparse_row(uint64_t element) const;

    ComponentType sparse_type_ = ComponentType::u32;
    uint64_t sparse_count_ = 0;
    // Bytes of the sparse indices. The indices are in ascending order, so sparse_row() can use a binary
    // search.
    std::span<const uint8_t> sparse_indices_;
    std::span<const uint8_t> sparse_values_;
};

}  // namespace weft::scene::gltf
