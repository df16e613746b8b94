// Purpose: the resources that a program offers to graphs: draw lists, buffers, images, views, the output. A
// graph names the imports that it uses; resolve() checks them against this catalogue.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

enum class ImportKind : uint8_t { draw_list, buffer, image, cube, output };

// A pipeline variant that a draw list may need. The set of variants is fixed.
struct DrawVariant {
    std::string name;                        // "opaque", "masked"
    std::vector<NamedValue> spec_constants;  // set if the shader declares them
};

// An attribute of the standard vertex format, bound by the name of the shader's input.
struct VertexAttribute {
    std::string name;  // "position", "normal", "tangent", "uv"
    Format format = Format::undefined;
    uint32_t stream = 0;
    uint32_t offset_bytes = 0;
};

struct VertexFormat {
    std::vector<uint32_t> stride_bytes;  // index: stream
    std::vector<VertexAttribute> attributes;
};

struct ImportDecl {
    std::string name;
    ImportKind kind = ImportKind::buffer;
    // buffers and images
    ResourceDecl resource;  // format, extent or size; lifetime = imported; import states are set
    // draw lists
    std::vector<DrawVariant> variants;
    VertexFormat vertex_format;
    uint32_t draws = 1;  // number of draws in the list
};

// A descriptor that the program binds besides the ports: in set 0 for all passes with shaders, in sets 2 and
// 3 for raster passes that draw lists. Shaders may only read it.
struct OfferedBinding {
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::uniform_buffer;
    ShaderStageMask stages = 0;
    uint32_t bytes = 0;    // size of a uniform buffer
    bool arrayed = false;  // for images: sampler2DArray instead of sampler2D
};

struct ImportCatalog {
    std::map<std::string, ImportDecl, std::less<>> imports;
    std::vector<std::string> views;                        // "camera", "sun(0)", "sun(1)", …
    std::map<std::string, double, std::less<>> numbers;    // numbers that expressions may name:
                                                           // "directionalLights"
    std::map<std::string, uint32_t, std::less<>> strides;  // sizes of element types of buffers: "Light" →
                                                           // bytes
    std::vector<OfferedBinding> bindings;                  // empty: unknown, so only set numbers are checked
};

[[nodiscard]] const char* import_kind_name(ImportKind kind);

}  // namespace weft
