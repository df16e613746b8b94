#include "scene/gltf/parse/values.h"

#include <tiny_gltf.h>

#include "weft/scene/scene.h"

namespace weft::scene::gltf {

uint32_t index_or_none(int index) {
    return index < 0 ? kNone : static_cast<uint32_t>(index);
}

std::vector<double> number_array(const tinygltf::Value& object, const char* key) {
    std::vector<double> out;
    const tinygltf::Value& array = object.Get(key);
    for (size_t i = 0; i < array.ArrayLen(); ++i)
        out.push_back(array.Get(static_cast<int>(i)).GetNumberAsDouble());
    return out;
}

double number_or(const tinygltf::Value& object, const char* key, double fallback) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

const tinygltf::Value* find_extension(const std::map<std::string, tinygltf::Value>& extensions,
                                      const char* name) {
    const auto it = extensions.find(name);
    return it != extensions.end() && it->second.IsObject() ? &it->second : nullptr;
}

}  // namespace weft::scene::gltf
