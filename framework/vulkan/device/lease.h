// Purpose: a Lease is the right to use one object of a store. It can be moved but not copied. The store must
// outlive it.
#pragma once

#include <string>
#include <utility>

namespace weft::vk {

// The store makes the leases. When a lease ends, it calls give_back(key) of the store. `Object` is a Vulkan
// object, or a pointer to an object of the store.
template <class Store, class Object>
class Lease {
 public:
    Lease() = default;
    ~Lease() { reset(); }
    Lease(Lease&& other) noexcept
        : store_(std::exchange(other.store_, nullptr)),
          key_(std::move(other.key_)),
          object_(std::exchange(other.object_, Object{})) {}
    Lease& operator=(Lease&& other) noexcept {
        if (this != &other) {
            reset();
            store_ = std::exchange(other.store_, nullptr);
            key_ = std::move(other.key_);
            object_ = std::exchange(other.object_, Object{});
        }
        return *this;
    }

    // Returns null for an empty lease.
    [[nodiscard]] Object get() const { return object_; }
    void reset() {
        object_ = Object{};
        if (store_ != nullptr) std::exchange(store_, nullptr)->give_back(key_);
    }

 private:
    friend Store;
    Lease(Store& store, std::string key, Object object)
        : store_(&store), key_(std::move(key)), object_(object) {}

    Store* store_ = nullptr;
    std::string key_;
    Object object_{};
};

}  // namespace weft::vk
