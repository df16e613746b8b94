// Purpose: reads the transforms of EXT_mesh_gpu_instancing. Errors: S104 an accessor reaches past its data.
// Source: "EXT_mesh_gpu_instancing", Khronos Group.
#pragma once

#include <cstdint>
#include <optional>

#include "scene/gltf/accessor_reader.h"
#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

// The transforms of the instances of one node.
class InstanceTransforms {
 public:
    // Returns nullopt after an error.
    [[nodiscard]] static std::optional<InstanceTransforms> open(const Document& document, uint32_t node,
                                                                Report& report);

    [[nodiscard]] uint64_t count() const { return count_; }
    // Returns the transform from the space of the instance to the space of the node.
    [[nodiscard]] glm::mat4 transform(uint64_t instance) const;

 private:
    uint64_t count_ = 0;
    std::optional<AccessorReader> translation_, rotation_, scale_;
};

}  // namespace weft::scene::gltf
