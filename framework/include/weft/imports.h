// Purpose: what the program around a graph offers it: draw lists, buffers, images, views, the output.
// A graph names the imports it uses; resolve() checks them against this catalogue.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

enum class ImportKind : uint8_t { draw_list, buffer, image, cube, output };

// One of the closed set of pipeline variants that a draw list may need.
struct DrawVariant {
    std::string name;                        // "opaque", "masked"
    std::vector<NamedValue> spec_constants;  // set when the shader declares them
};

// A stream of the canonical vertex format, bound by the name of the shader's input.
struct VertexAttribute {
    std::string name;  // "position", "normal", "tangent", "uv"
    Format format = Format::undefined;
    uint32_t stream = 0;
    uint32_t offset_bytes = 0;
};

struct VertexFormat {
    std::vector<uint32_t> stride_bytes;  // by stream
    std::vector<VertexAttribute> attributes;
};

struct ImportDecl {
    std::string name;
    ImportKind kind = ImportKind::buffer;
    // buffers and images
    ResourceDecl resource;  // format, extent or size; lifetime = imported; import states set
    // draw lists
    std::vector<DrawVariant> variants;
    VertexFormat vertex_format;
    uint32_t draws = 1;  // how many draws are in the list
};

// A descriptor that the program binds beside the ports: in set 0 for all passes with shaders, in sets 2 and 3
// for raster passes that draw lists. Shaders only read it.
struct OfferedBinding {
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::uniform_buffer;
    ShaderStageMask stages = 0;
    uint32_t bytes = 0;    // of a uniform buffer
    bool arrayed = false;  // an image: sampler2DArray, else sampler2D
};

struct ImportCatalog {
    std::map<std::string, ImportDecl, std::less<>> imports;
    std::vector<std::string> views;                        // "camera", "sun(0)", "sun(1)", …
    std::map<std::string, double, std::less<>> numbers;    // that expressions may name: "directionalLights"
    std::map<std::string, uint32_t, std::less<>> strides;  // element types of buffers: "Light" → bytes
    std::vector<OfferedBinding> bindings;                  // empty: not known, and only the sets are checked
};

[[nodiscard]] const char* import_kind_name(ImportKind kind);

}  // namespace weft
