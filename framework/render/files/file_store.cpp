#include "render/files/file_store.h"

#include <algorithm>
#include <set>
#include <utility>

#include "load/text_reader.h"
#include "vulkan/device/to_vk.h"

namespace weft::render {
namespace {

// True if the same object can serve for both resources.
bool same_object(const ResourceDecl& a, const ResourceDecl& b) {
    return a.kind == b.kind && a.image_kind == b.image_kind && a.format == b.format && a.extent == b.extent &&
           a.mips == b.mips && a.layers == b.layers && a.size_bytes == b.size_bytes && a.usage == b.usage;
}

Status upload(vk::Device& device, FileObject& object) {
    const std::vector<std::vector<std::byte>>& levels = object.content.levels;
    if (object.decl.kind == ResourceKind::buffer) return vk::upload_buffer(device, object.buffer, levels[0]);
    const std::vector<std::span<const std::byte>> mips(levels.begin(), levels.end());
    return vk::upload_image(device, object.image, mips);
}

std::string texture_name(const ResourceDecl& table, size_t texture) {
    return table.name + "[" + std::to_string(texture) + "]";
}

// Returns one declaration for each object that a resource needs: `decl` itself if the resource has a file, or
// one image for each texture if the resource is a table with files. Otherwise the result is empty.
std::vector<ResourceDecl> with_files(const ResourceDecl& decl) {
    if (!decl.file.empty()) return {decl};
    std::vector<ResourceDecl> textures;
    for (const TextureFile& file : decl.texture_files) {
        ResourceDecl texture = decl;
        texture.name = texture_name(decl, textures.size());
        texture.file = file.name;
        texture.file_path = file.path;
        texture.extent = {file.width_px, file.height_px, 1};
        texture.mips = file.mips;
        textures.push_back(std::move(texture));
    }
    return textures;
}

}  // namespace

void bind_files(const ResolvedGraph& graph, const FileUses& uses, vk::ImportBindings& to) {
    for (const ResourceDecl& resource : graph.resources) {
        std::vector<VkImageView> views;
        for (size_t i = 0; i < resource.texture_files.size(); ++i)
            if (const auto use = uses.find(texture_name(resource, i)); use != uses.end())
                views.push_back(use->second.image().view());
        if (!views.empty()) to.textures.insert_or_assign(resource.name, std::move(views));
        const auto use = uses.find(resource.name);
        if (use == uses.end()) continue;
        if (resource.kind == ResourceKind::buffer)
            to.buffers.emplace(resource.name, use->second.buffer().handle());
        if (resource.kind == ResourceKind::image) to.images.emplace(resource.name, &use->second.image());
    }
}

FileUse::~FileUse() {
    if (object_ != nullptr) store_->release(object_);
}

FileUse& FileUse::operator=(FileUse&& other) noexcept {
    std::swap(store_, other.store_);
    std::swap(object_, other.object_);
    return *this;
}

Status upload_files(const FileUses& uses) {
    for (const auto& [name, use] : uses) {
        FileObject& object = *use.object_;
        if (object.uploaded) continue;
        if (Status done = upload(use.store_->device_, object); !done) return done;
        object.uploaded = true;
        object.content = {};
    }
    return Unit{};
}

Result<FileUses> FileStore::acquire(const ResolvedGraph& graph, const LoadSettings& settings) {
    std::set<ResourceId> used;
    for (const PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses) used.insert(use.resource);
    FileUses uses;
    Diagnostics faults;
    for (const ResourceId id : used) {
        for (const ResourceDecl& decl : with_files(graph.resources[id])) {
            const Status acquired = acquire(graph, decl, settings, uses);
            if (!acquired)
                for (const Diagnostic& fault : acquired.errors()) faults.push_back(fault);
        }
    }
    if (!faults.empty()) return faults;
    return uses;
}

Status FileStore::acquire(const ResolvedGraph& graph, const ResourceDecl& decl, const LoadSettings& settings,
                          FileUses& uses) {
    Result<FileObject*> object = find_or_make(graph, decl, settings);
    if (!object) return object.take_errors();
    uses.emplace(decl.name, FileUse(*this, **object));
    return Unit{};
}

FileObject* FileStore::find(const ResourceDecl& decl, uint64_t hash) {
    const auto found = std::ranges::find_if(objects_, [&](const FileObject& object) {
        return object.hash == hash && same_object(object.decl, decl);
    });
    if (found == objects_.end()) return nullptr;
    ++found->uses;
    return &*found;
}

// Returns an object whose number `uses` already includes the use by the caller.
Result<FileObject*> FileStore::find_or_make(const ResolvedGraph& graph, const ResourceDecl& decl,
                                            const LoadSettings& settings) {
    {
        const std::lock_guard lock(mutex_);
        const auto known = known_.find(decl.file_path);
        if (reads_disk(settings) && known != known_.end() && known->second.stamps.hold())
            if (FileObject* object = find(decl, known->second.hash)) return object;
    }
    // Created before the file is read: then `stamps` shows if the file changes during the reading.
    FileStamps stamps;
    Result<ResourceContent> content = read_resource_content(graph, decl, settings);
    if (!content) return content.take_errors();
    stamps.take({decl.file_path});
    const uint64_t hash = content->hash;
    {
        const std::lock_guard lock(mutex_);
        known_.insert_or_assign(decl.file_path, KnownFile{std::move(stamps), hash});
        if (FileObject* object = find(decl, hash)) return object;
    }
    return make(decl, std::move(*content));
}

Result<FileObject*> FileStore::make(const ResourceDecl& decl, ResourceContent content) {
    Result<DeviceObject> made = create_object(device_, decl, vk::buffer_usage_to_vk(decl.usage));
    if (!made) return made.take_errors();
    FileObject object{std::move(*made)};
    object.decl = decl;
    object.hash = content.hash;
    object.content = std::move(content);
    const std::lock_guard lock(mutex_);
    objects_.push_back(std::move(object));
    objects_.back().uses = 1;
    return &objects_.back();
}

void FileStore::release(FileObject* object) {
    const std::lock_guard lock(mutex_);
    if (--object->uses > 0) return;
    objects_.remove_if([&](const FileObject& o) { return &o == object; });
}

}  // namespace weft::render
