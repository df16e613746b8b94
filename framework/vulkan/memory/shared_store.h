// Purpose: the images and buffers of resources with `"keep": "shared"`. Plans that follow each other lease
// the same object from the store, if the resource has the same name and shape in both. When the last lease
// ends, the object and its memory are destroyed. Only the plan that runs, and the plan that replaces it, may
// use one store at a time. Thread-safe. Errors: those of the function that makes the object.
#pragma once

#include <functional>

#include "vulkan/device/device_memory.h"
#include "vulkan/device/handle.h"
#include "vulkan/device/lease.h"
#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::vk {

// An image or a buffer with memory of its own. The memory is destroyed last.
struct SharedObject {
    DeviceMemory memory;
    ImageHandle image;
    BufferHandle buffer;
};

using SharedObjects = LeaseStore<SharedObject, const SharedObject*>;
using SharedLease = Lease<SharedObjects, const SharedObject*>;

class SharedStore : public SharedObjects {
 public:
    using Make = std::function<Result<SharedObject>()>;
    // Returns a lease on the object of the resource. If the store does not have the object, the function
    // creates it with `make`.
    [[nodiscard]] Result<SharedLease> get(const ResourceDecl& decl, const Make& make);
};

}  // namespace weft::vk
