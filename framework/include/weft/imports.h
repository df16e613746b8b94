// Purpose: lists the resources that a program offers to graphs: draw lists, buffers, images, tables of
// textures, views and the output. A graph names the imports that it uses, and resolve() checks these names
// against this catalogue.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

enum class ImportKind : uint8_t { draw_list, buffer, image, cube, output, views, textures };

// A variant of the pipelines that draw a list. Each list has a fixed set of variants, and each draw of the
// list uses one of them.
struct DrawVariant {
    std::string name;  // Name of the variant, such as "opaque" or "masked".
    // Values of specialisation constants. A value is ignored if the shader does not declare the constant.
    std::vector<NamedValue> spec_constants;
};

// An attribute of the vertices of a draw list. It is bound to the shader's input with the same name.
struct VertexAttribute {
    std::string name;  // The lists of a scene have "position", "normal", "tangent" and "uv".
    // The shader's input has the same number class: float, uint or int. Tight vectors of three floats have
    // the format rgb32f.
    Format format = Format::undefined;
    uint32_t stream = 0;        // The vertex buffer with the attribute: an index into stride_bytes.
    uint32_t offset_bytes = 0;  // Offset of the attribute from the start of its vertex.
};

struct VertexFormat {
    // stride_bytes[s] is the number of bytes from one vertex to the next in stream s.
    std::vector<uint32_t> stride_bytes;
    std::vector<VertexAttribute> attributes;
};

struct ImportDecl {
    std::string name;
    ImportKind kind = ImportKind::buffer;
    // For buffers and images: format, extent or size, and import states. The lifetime is `imported`. For
    // tables of textures: the number of textures, and import states; see texture_table().
    ResourceDecl resource;
    bool read_only = false;  // True: passes must not write the buffer or image (W147).
    // True: the program uses what a frame writes, so the passes that write the buffer or image always run.
    bool observed = false;
    // The members from `variants` to `draw_sets` describe a draw list.
    std::vector<DrawVariant> variants;
    VertexFormat vertex_format;
    uint32_t draws = 1;  // Number of draws in the list.
    // The descriptor sets that the source of the draws binds: set s has the bit 1 << s.
    uint32_t draw_sets = 1u << 2 | 1u << 3;
    // The members `views` and `rects` describe a list of views: the number of its views, and for each view
    // its rectangle in pixels for passes with "into": "rects". If `rects` is empty, the views form a grid.
    uint32_t views = 0;
    // True: no scene is loaded, so Weft assumes the number `views`. The real number depends on the scene.
    bool assumes_views = false;
    std::vector<RectPx> rects;
};

// A descriptor that the program binds itself, in addition to the ports of a pass: in set 0 for all passes
// with shaders, in sets 2 and 3 for raster passes that draw lists. Shaders may only read it.
struct OfferedBinding {
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::uniform_buffer;
    ShaderStageMask stages = 0;
    uint32_t bytes = 0;    // Size in bytes; only for a uniform buffer.
    bool arrayed = false;  // True: the image is a sampler2DArray. False: the image is a sampler2D.
};

struct ImportCatalog {
    std::map<std::string, ImportDecl, std::less<>> imports;
    // Names that passes may use as a view without an import: single views such as "camera", and those lists
    // of views in `imports` that are always offered, such as "sun".
    std::vector<std::string> views;
    // Numbers that expressions may use by name, such as "directionalLights".
    std::map<std::string, double, std::less<>> numbers;
    // The element types of buffers that graphs may name, such as "Light". Value: size of one element in
    // bytes.
    std::map<std::string, uint32_t, std::less<>> strides;
    // All descriptors that the program binds. If the list is empty, the descriptors are unknown, and only the
    // set numbers in shaders are checked.
    std::vector<OfferedBinding> bindings;
};

[[nodiscard]] const char* import_kind_name(ImportKind kind);
// Returns the state of the textures of a table, before, during and after each frame.
[[nodiscard]] AccessState texture_table_state();
// Returns an import of kind "textures" with `count` 2D textures, at least 1. Between frames, all of them are
// in the layout shader_read_only.
[[nodiscard]] ImportDecl texture_table(const std::string& name, uint32_t count);

}  // namespace weft
