// Purpose: samplers as graphs declare them; equal ones are made once.
// Errors: V413.
#pragma once

#include <map>
#include <tuple>

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

class SamplerCache {
 public:
    explicit SamplerCache(Device& device) : device_(&device) {}
    // Integer images take an integer border. Borders are zero: transparent black, and the far plane of a
    // shadow map.
    [[nodiscard]] Result<VkSampler> get(const SamplerDecl& decl, bool integer_border);

 private:
    using Key = std::tuple<SamplerFilter, SamplerFilter, SamplerWrap, bool, bool>;
    Device* device_;
    std::map<Key, SamplerHandle> samplers_;
};

}  // namespace weft::vk
