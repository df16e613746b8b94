// Purpose: creates the samplers that graphs declare. Equal samplers are created only once. Errors: V413 (a
// sampler could not be created).
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "vulkan/device/handle.h"
#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::vk {

class SamplerCache {
 public:
    explicit SamplerCache(Device& device) : device_(&device) {}
    // `integer_border` must be true for integer images, because these need an integer border colour. All
    // border colours are zero: transparent black, or the far plane in a shadow map.
    [[nodiscard]] Result<VkSampler> get(const SamplerDecl& decl, bool integer_border);

 private:
    using Key = std::tuple<SamplerFilter, SamplerFilter, SamplerWrap, std::optional<CompareOp>,
                           SamplerReduction, float, float, float, float, bool>;
    Device* device_;
    std::map<Key, SamplerHandle> samplers_;
};

}  // namespace weft::vk
