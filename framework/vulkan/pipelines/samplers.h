// Purpose: creates the samplers that graphs declare; equal samplers are created once. Errors: V413.
#pragma once

#include <map>
#include <tuple>

#include "vulkan/device/handle.h"
#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::vk {

class SamplerCache {
 public:
    explicit SamplerCache(Device& device) : device_(&device) {}
    // Integer images need an integer border colour. Border colours are zero: transparent black, or the far
    // plane of a shadow map.
    [[nodiscard]] Result<VkSampler> get(const SamplerDecl& decl, bool integer_border);

 private:
    using Key = std::tuple<SamplerFilter, SamplerFilter, SamplerWrap, bool, bool>;
    Device* device_;
    std::map<Key, SamplerHandle> samplers_;
};

}  // namespace weft::vk
