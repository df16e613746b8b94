// Last lines of a header that began with begin.glsl.
#ifdef __cplusplus
}  // namespace weft::shared
#endif
