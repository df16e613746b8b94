#include "vulkan/memory/shared_store.h"

namespace weft::vk {
namespace {

// Returns a text that is equal for two declarations if one object can serve both.
std::string key_of(const ResourceDecl& d) {
    std::string key = d.name;
    const std::initializer_list<uint64_t> numbers{static_cast<uint64_t>(d.kind),
                                                  static_cast<uint64_t>(d.image_kind),
                                                  static_cast<uint64_t>(d.format),
                                                  d.extent.width,
                                                  d.extent.height,
                                                  d.extent.depth,
                                                  d.mips,
                                                  d.layers,
                                                  d.samples,
                                                  d.size_bytes,
                                                  d.usage};
    for (const uint64_t number : numbers) key += " " + std::to_string(number);
    return key;
}

}  // namespace

Result<SharedLease> SharedStore::get(const ResourceDecl& decl, const Make& make) {
    std::string key = key_of(decl);
    // The lock is held while the object is made. So two plans that are created at the same time never make
    // two objects for one resource.
    const std::lock_guard lock(mutex_);
    auto found = entries_.find(key);
    if (found == entries_.end()) {
        Result<SharedObject> object = make();
        if (!object) return object.take_errors();
        found = entries_.try_emplace(key).first;
        found->second.owner = std::move(*object);
    }
    return lease(std::move(key), found->second, &found->second.owner);
}

}  // namespace weft::vk
