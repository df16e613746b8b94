// Purpose: includes tinygltf without its code for files and images, and reads values of its JSON objects.
// Each function returns a fallback if the value is missing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "weft/scene/scene.h"

namespace weft::scene::gltf {

inline uint32_t index_or_none(int index) {
    return index < 0 ? kNone : static_cast<uint32_t>(index);
}

template <class Vector>
Vector vector_or(const std::vector<double>& values, const Vector& fallback) {
    if (values.size() != static_cast<size_t>(Vector::length())) return fallback;
    Vector out;
    for (int i = 0; i < Vector::length(); ++i) out[i] = static_cast<float>(values[static_cast<size_t>(i)]);
    return out;
}

inline std::vector<double> number_array(const tinygltf::Value& object, const char* key) {
    std::vector<double> out;
    const tinygltf::Value& array = object.Get(key);
    for (size_t i = 0; i < array.ArrayLen(); ++i)
        out.push_back(array.Get(static_cast<int>(i)).GetNumberAsDouble());
    return out;
}

inline double number_or(const tinygltf::Value& object, const char* key, double fallback) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

inline const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto it = extensions.find(name);
    return it != extensions.end() && it->second.IsObject() ? &it->second : nullptr;
}

}  // namespace weft::scene::gltf
