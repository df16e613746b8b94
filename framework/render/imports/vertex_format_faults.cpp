#include "render/imports/vertex_format_faults.h"

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::render {
namespace {

bool can_be_vertices(const vk::Device& device, Format format) {
    if (format == Format::undefined) return false;
    VkFormatProperties properties{};
    device.instance_fn().vkGetPhysicalDeviceFormatProperties(device.physical(), vk::to_vk(format),
                                                             &properties);
    return (properties.bufferFeatures & VK_FORMAT_FEATURE_VERTEX_BUFFER_BIT) != 0;
}

class AttributeCheck {
 public:
    AttributeCheck(const std::string& list, const VertexAttribute& attribute)
        : name_("attribute \"" + attribute.name + "\" of the draw list \"" + list + "\"") {}

    void add(const std::string& what, const std::string& help) {
        Diagnostic d;
        d.code = "W255";
        d.message = name_ + what;
        d.help = {help};
        faults_.push_back(std::move(d));
    }
    Diagnostics take() { return std::move(faults_); }

 private:
    std::string name_;
    Diagnostics faults_;
};

}  // namespace

Diagnostics vertex_format_faults(const vk::Device& device, const std::string& list,
                                 const VertexFormat& format) {
    Diagnostics faults;
    for (const VertexAttribute& attribute : format.attributes) {
        AttributeCheck check(list, attribute);
        const FormatInfo& info = format_info(attribute.format);
        const std::string name(info.name);
        if (!can_be_vertices(device, attribute.format)) {
            check.add(" has the format " + name + ", which the device cannot read from vertex buffers",
                      "choose another format, for example rgb32f for three floats");
        } else if (attribute.stream >= format.stride_bytes.size()) {
            check.add(" is in stream " + std::to_string(attribute.stream) + ", but the vertex format has " +
                          std::to_string(format.stride_bytes.size()) + " streams",
                      "give the stride of each stream in VertexFormat::stride_bytes");
        } else if (const uint64_t end = uint64_t{attribute.offset_bytes} + info.bytes_per_texel;
                   end > format.stride_bytes[attribute.stream]) {
            check.add(" ends at byte " + std::to_string(end) + " of the vertex (offset " +
                          std::to_string(attribute.offset_bytes) + ", format " + name +
                          "), but the stride of stream " + std::to_string(attribute.stream) + " is " +
                          std::to_string(format.stride_bytes[attribute.stream]) + " bytes",
                      "correct the offset, the format or the stride; three floats have the format rgb32f");
        }
        for (Diagnostic& fault : check.take()) faults.push_back(std::move(fault));
    }
    return faults;
}

}  // namespace weft::render
