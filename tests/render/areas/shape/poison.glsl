// Returns NaN instead of `value` in frames that fill all images with NaN.
vec4 poisoned(vec4 value, float time) { return time > 1000.0 ? vec4(uintBitsToFloat(0x7FC00000u)) : value; }
