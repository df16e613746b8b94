// Purpose: reads values of the JSON objects that tinygltf has parsed. Each function returns a fallback if the
// value is missing.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tinygltf {
class Value;
}

namespace weft::scene::gltf {

[[nodiscard]] uint32_t index_or_none(int index);

template <class Vector>
Vector vector_or(const std::vector<double>& values, const Vector& fallback) {
    if (values.size() != static_cast<size_t>(Vector::length())) return fallback;
    Vector out;
    for (int i = 0; i < Vector::length(); ++i) out[i] = static_cast<float>(values[static_cast<size_t>(i)]);
    return out;
}

// Returns an empty array if the value is missing.
[[nodiscard]] std::vector<double> number_array(const tinygltf::Value& object, const char* key);

[[nodiscard]] double number_or(const tinygltf::Value& object, const char* key, double fallback);

// Returns nullptr if the extension is missing.
[[nodiscard]] const tinygltf::Value* find_extension(const std::map<std::string, tinygltf::Value>& extensions,
                                                    const char* name);

}  // namespace weft::scene::gltf
