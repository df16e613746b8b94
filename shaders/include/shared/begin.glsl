// Opens a header that C++ and GLSL both compile. In C++ the GLSL type names become glm's; in GLSL nothing happens.
// Layout rule: every vec3 is followed by a scalar, every struct is a multiple of 16 bytes (unless it says so), so that
// std140, std430 and C++ agree. No include guard: shared headers include this once each and close with end.glsl.
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
