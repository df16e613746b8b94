// Opens a header that both C++ and GLSL compile. In C++ it maps GLSL type names to glm's; in GLSL it does
// nothing. Layout rule: every vec3 is followed by a scalar, and the size of every struct is a multiple of 16
// bytes (unless stated otherwise), so that std140, std430 and C++ agree. No include guard: each shared header
// includes this once and ends with end.glsl.
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace weft::shared {
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
#endif
