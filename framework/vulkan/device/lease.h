// Purpose: objects that several users share by a key. A user has a lease on the object; when the last lease
// ends, the object is destroyed. Thread-safe.
#pragma once

#include <cassert>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace weft::vk {

// The right to use one object of a store. A lease can be moved but not copied. The store must outlive it.
// `Object` is a Vulkan object, or a pointer to an object of the store.
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

// The base of a store. `Owner` owns an object, and `Object` is what a lease gives to its user.
template <class Owner, class Object>
class LeaseStore {
 public:
    LeaseStore() = default;
    LeaseStore(const LeaseStore&) = delete;
    LeaseStore& operator=(const LeaseStore&) = delete;

 protected:
    ~LeaseStore() = default;

    struct Entry {
        Owner owner;
        uint32_t leases = 0;
    };
    // Call this function with the lock held. `object` belongs to the entry with this key.
    [[nodiscard]] Lease<LeaseStore, Object> lease(std::string key, Entry& entry, Object object) {
        ++entry.leases;
        return {*this, std::move(key), object};
    }

    std::mutex mutex_;
    std::map<std::string, Entry> entries_;  // An entry stays at its address until it is erased.

 private:
    friend Lease<LeaseStore, Object>;
    void give_back(const std::string& key) {
        // Declared before the lock, so that the object is destroyed after the lock is released.
        Owner last;
        const std::lock_guard lock(mutex_);
        const auto found = entries_.find(key);
        assert(found != entries_.end() && found->second.leases > 0);
        if (--found->second.leases > 0) return;
        last = std::move(found->second.owner);
        entries_.erase(found);
    }
};

}  // namespace weft::vk
