#include "scene/gltf/instancing_build.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/node_placement.h"

namespace weft::scene::gltf {

std::optional<InstanceTransforms> InstanceTransforms::open(const Document& document, uint32_t node,
                                                           Report& report) {
    const InstancingSource& source = document.instancing.at(node);
    const std::string pointer =
        "/nodes/" + std::to_string(node) + "/extensions/EXT_mesh_gpu_instancing/attributes/";
    InstanceTransforms transforms;
    const auto open_one = [&](uint32_t accessor, const char* key, std::optional<AccessorReader>& reader) {
        if (accessor == kNone) return true;
        const Accessor& data = document.accessors[accessor];
        if (data.type != ComponentType::f32 && !data.normalized) {
            report.error("S116", pointer + key,
                         "\"" + std::string(key) +
                             "\" is an accessor of integers that are not normalised; wanted floats, or "
                             "integers with \"normalized\": true",
                         "export the instances again");
            return false;
        }
        reader = AccessorReader::open(document, accessor);
        if (!reader) {
            report.error("S104", pointer + key,
                         "the accessor reaches past the end of its data, or its sparse indices do not ascend",
                         "export the instances again");
            return false;
        }
        transforms.count_ = reader->count();
        return true;
    };
    if (open_one(source.translation, "TRANSLATION", transforms.translation_) &&
        open_one(source.rotation, "ROTATION", transforms.rotation_) &&
        open_one(source.scale, "SCALE", transforms.scale_))
        return transforms;
    return std::nullopt;
}

glm::mat4 InstanceTransforms::transform(uint64_t instance) const {
    glm::mat4 placed(1);
    if (translation_) placed = glm::translate(placed, translation_->vector<glm::vec3>(instance));
    if (rotation_) {
        const glm::vec4 xyzw = unit_quaternion(rotation_->vector<glm::vec4>(instance));
        placed *= glm::mat4_cast(glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z));
    }
    return scale_ ? glm::scale(placed, scale_->vector<glm::vec3>(instance)) : placed;
}

}  // namespace weft::scene::gltf
