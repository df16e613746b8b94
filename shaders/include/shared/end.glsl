// Closes what begin.glsl opened.
#ifdef __cplusplus
}  // namespace weft::shared
#endif
