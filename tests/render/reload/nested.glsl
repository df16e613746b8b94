#include "tint.glsl"
