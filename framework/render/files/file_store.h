// Purpose: the buffers and images whose content comes from files (the key "file" of a resource). Each content
// exists once: plans that need the same content share it. An object lives as long as a FileUse refers to it.
// Threads: acquire() may run on any thread, upload_files() on the thread that submits. Errors: W145 a file
// cannot be used; errors of Vulkan (their codes begin with V) if the device lacks memory or does not support
// the image.
#pragma once

#include <list>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "load/file_stamps.h"
#include "render/files/device_object.h"
#include "weft/load/resource_content.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class FileStore;

// A buffer or an image of the store.
struct FileObject : DeviceObject {
    ResourceDecl decl;
    uint64_t hash = 0;
    ResourceContent content;  // Empty after the upload.
    bool uploaded = false;
    uint32_t uses = 0;  // Number of FileUses.
};

// Keeps an object of the store alive.
class FileUse {
 public:
    FileUse(FileStore& store, FileObject& object) : store_(&store), object_(&object) {}
    ~FileUse();
    FileUse(FileUse&& other) noexcept
        : store_(other.store_), object_(std::exchange(other.object_, nullptr)) {}
    FileUse& operator=(FileUse&& other) noexcept;

    [[nodiscard]] const vk::Image& image() const { return object_->image; }
    [[nodiscard]] const vk::Buffer& buffer() const { return object_->buffer; }
    [[nodiscard]] uint64_t hash() const { return object_->hash; }

 private:
    friend Status upload_files(const std::map<std::string, FileUse>& uses);

    FileStore* store_;
    FileObject* object_;
};
// Key: name of the resource. For texture 2 of the table "pictures": "pictures[2]".
using FileUses = std::map<std::string, FileUse>;

// Adds the buffers, images and tables of textures of a graph to the imports of an executor.
void bind_files(const ResolvedGraph& graph, const FileUses& uses, vk::ImportBindings& to);

// Copies content that is not uploaded yet to the device. Waits until the device has copied it.
[[nodiscard]] Status upload_files(const FileUses& uses);

class FileStore {
 public:
    explicit FileStore(vk::Device& device) : device_(device) {}
    FileStore(const FileStore&) = delete;
    FileStore& operator=(const FileStore&) = delete;

    // Reads the files of all resources of the graph that a pass uses, and creates the missing objects. Files
    // that have not changed since the last call are not read again. Submits nothing.
    [[nodiscard]] Result<FileUses> acquire(const ResolvedGraph& graph, const LoadSettings& settings);

 private:
    friend class FileUse;
    friend Status upload_files(const FileUses& uses);

    struct KnownFile {
        FileStamps stamps;
        uint64_t hash = 0;
    };
    [[nodiscard]] Status acquire(const ResolvedGraph& graph, const ResourceDecl& decl,
                                 const LoadSettings& settings, FileUses& uses);
    [[nodiscard]] FileObject* find(const ResourceDecl& decl, uint64_t hash);
    [[nodiscard]] Result<FileObject*> make(const ResourceDecl& decl, ResourceContent content);
    [[nodiscard]] Result<FileObject*> find_or_make(const ResolvedGraph& graph, const ResourceDecl& decl,
                                                   const LoadSettings& settings);
    void release(FileObject* object);

    vk::Device& device_;
    std::mutex mutex_;  // Protects all members below, and FileObject::uses.
    std::list<FileObject> objects_;
    std::map<std::string, KnownFile> known_;  // Key: path of the file.
};

}  // namespace weft::render
