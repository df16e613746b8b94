#include "tests/drivers/snapped_graphs.h"

#include <fstream>
#include <sstream>
#include <string>

namespace weft::test {
namespace {

namespace fs = std::filesystem;

// GLSL code for vertex shaders. It moves `gl_Position` to the nearest point of a grid of 1/16 px.
constexpr const char* kOnGrid = R"(
    beyond_picture = 0.0;
    const vec4 unsnapped = gl_Position;
    if (unsnapped.w > 0.0) {
        const vec2 snapped_size = 1.0 / view.inverse_viewport;
        const vec2 snapped_px = (unsnapped.xy / unsnapped.w * 0.5 + 0.5) * snapped_size;
        gl_Position.xy = (round(snapped_px * 16.0) / 16.0 / snapped_size * 2.0 - 1.0) * unsnapped.w;
    }
)";

// GLSL code for vertex shaders, inserted after kOnGrid. It sets `beyond_picture` to 1 if the vertex is
// outside the picture, or nearer to the eye than the near plane. Interpolation then makes the value positive
// in all fragments of the triangle.
constexpr const char* kMarkBeyond = R"(
    if (any(greaterThan(abs(unsnapped.xy), vec2(unsnapped.w))) || unsnapped.z > unsnapped.w) beyond_picture = 1.0;
)";

// GLSL code for fragment shaders, which filters textures in the shader. Function exact_srgb() finds the 8-bit
// code that a driver has decoded, and decodes it in single precision.
constexpr const char* kFilter = R"(
vec3 exact_srgb(vec3 decoded) {
    const vec3 curve = 1.055 * pow(decoded, vec3(1.0 / 2.4)) - 0.055;
    const vec3 code = round(mix(decoded * 12.92, curve, greaterThan(decoded, vec3(0.0031308))) * 255.0) / 255.0;
    return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), greaterThan(code, vec3(0.04045)));
}

vec4 texel(sampler2D image, bool is_srgb, ivec2 at, int level) {
    const vec4 decoded = texelFetch(image, at, level);
    return is_srgb ? vec4(exact_srgb(decoded.rgb), decoded.a) : decoded;
}

vec4 filtered(sampler2D image, bool is_srgb, vec2 uv) {
    const int level = min(2, textureQueryLevels(image) - 1);
    const ivec2 size = textureSize(image, level);
    const vec2 at = uv * vec2(size) - 0.5, share = fract(at);
    const ivec2 low = (ivec2(floor(at)) % size + size) % size, high = (low + 1) % size;
    const vec4 upper = mix(texel(image, is_srgb, low, level), texel(image, is_srgb, ivec2(high.x, low.y), level), share.x);
    const vec4 lower = mix(texel(image, is_srgb, ivec2(low.x, high.y), level), texel(image, is_srgb, high, level), share.x);
    return mix(upper, lower, share.y);
}
)";

constexpr const char* kMain = "void main() {";
constexpr const char* kMaterials = "#include \"material_set.glsl\"\n";
constexpr const char* kSurface = "surface_fragment.glsl";

std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// Inserts `inserted` into `text` before the first occurrence of `what`. Returns false if `text` does not
// contain `what`.
bool insert_before(std::string& text, const std::string& what, const std::string& inserted) {
    const size_t found = text.find(what);
    if (found != std::string::npos) text.insert(found, inserted);
    return found != std::string::npos;
}

bool insert_behind(std::string& text, const std::string& what, const std::string& inserted) {
    const size_t found = text.find(what);
    if (found != std::string::npos) text.insert(found + what.size(), inserted);
    return found != std::string::npos;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
}

bool snap_vertices(const fs::path& shader, Triangles triangles) {
    std::string text = read(shader);
    const size_t projection = text.find("gl_Position = view.view_projection *");
    if (projection == std::string::npos) return false;
    // kMarkBeyond marks triangles that reach beyond the edge of the picture. It is not inserted into the
    // shader of the shadow maps, because the edge of a shadow map is not the edge of the picture.
    const bool marks = triangles == Triangles::whole && shader.filename() != "sun_shadow.vert";
    text.insert(text.find(';', projection) + 1, std::string(kOnGrid) + (marks ? kMarkBeyond : ""));
    const bool has_main = insert_before(text, kMain, "layout(location = 12) out float beyond_picture;\n\n");
    std::ofstream(shader) << text;
    return has_main;
}

bool filter_exactly(const fs::path& shader) {
    std::string text = read(shader);
    if (text.find(kSurface) == std::string::npos) return false;
    const bool has_main = insert_before(text, kMain, "layout(location = 12) in float beyond_picture;\n\n") &&
                          insert_behind(text, kMain, "\n    if (beyond_picture > 0.0) discard;");
    std::ofstream(shader) << text;
    // The compiler searches for an included file in the folder of the including file first. So this changed
    // copy replaces the shared header.
    std::string surface = read(fs::path(WEFT_SOURCE_DIR) / "shaders/include" / kSurface);
    for (const char* name : {"base_color_texture", "emissive_texture"})
        replace_all(surface, "texture(" + std::string(name), "filtered(" + std::string(name) + ", true");
    for (const char* name :
         {"metallic_roughness_texture", "normal_texture", "occlusion_texture", "anisotropy_texture"})
        replace_all(surface, "texture(" + std::string(name), "filtered(" + std::string(name) + ", false");
    const bool has_materials = insert_behind(surface, kMaterials, kFilter);
    std::ofstream(shader.parent_path() / kSurface) << surface;
    return has_main && has_materials && surface.find(" texture(") == std::string::npos;
}

}  // namespace

bool replace_in(const fs::path& file, const std::string& what, const std::string& by) {
    std::string text = read(file);
    const bool found = text.find(what) != std::string::npos;
    replace_all(text, what, by);
    std::ofstream(file) << text;
    return found;
}

SnappedShaders write_snapped_graphs(const fs::path& folder, Triangles triangles) {
    // Weft searches for shaders in the graph's folder first, so the graphs use these copies.
    fs::copy(WEFT_SOURCE_DIR "/graphs", folder, fs::copy_options::recursive);
    fs::copy(WEFT_SOURCE_DIR "/shaders", folder, fs::copy_options::recursive);
    SnappedShaders changed;
    for (const auto& entry : fs::recursive_directory_iterator(WEFT_SOURCE_DIR "/shaders")) {
        const fs::path copy = folder / entry.path().lexically_relative(WEFT_SOURCE_DIR "/shaders");
        if (copy.extension() == ".vert" && snap_vertices(copy, triangles)) ++changed.vertex;
        if (copy.extension() == ".frag" && filter_exactly(copy)) ++changed.fragment;
    }
    const bool has_lines = replace_in(folder / "edges.json", R"("lines": "rg8")", R"("lines": "rg16f")");
    changed.has_wide_lines =
        replace_in(folder / "edges/lines.comp", "layout(rg8)", "layout(rg16f)") && has_lines;
    return changed;
}

}  // namespace weft::test
