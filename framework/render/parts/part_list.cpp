#include "render/parts/part_list.h"

#include <algorithm>

#include "weft/render/import_catalog.h"

namespace weft::render {

void PartList::add_first(std::unique_ptr<GpuPart> part) {
    parts_.push_back({kFirstPart, std::move(part), nullptr, 0});
}

Result<PartId> PartList::add(std::unique_ptr<GpuPart> part, std::unique_ptr<vk::UploadBatch> uploads) {
    if (Status submitted = uploads->submit(); !submitted) return submitted.take_errors();
    parts_.push_back({next_, std::move(part), std::move(uploads), 0});
    note_change(*parts_.back().part);
    return next_++;
}

bool PartList::remove(PartId part, uint64_t until) {
    const auto found = std::ranges::find(parts_, part, &Entry::id);
    if (part == kFirstPart || found == parts_.end()) return false;
    note_change(*found->part);
    found->until = until;
    retired_.push_back(std::move(*found));
    parts_.erase(found);
    return true;
}

void PartList::drop_retired(uint64_t frame) {
    for (Entry& entry : retired_)
        if (entry.until <= frame) entry.uploads.reset();
    std::erase_if(retired_, [&](const Entry& entry) { return entry.until <= frame; });
    for (Entry& entry : parts_)
        if (entry.uploads && entry.uploads->is_over()) entry.uploads.reset();
}

GpuPart* PartList::find(PartId part) const {
    const auto found = std::ranges::find(parts_, part, &Entry::id);
    return found != parts_.end() ? found->part.get() : nullptr;
}

void PartList::begin_frame(uint32_t slot, double time_s) {
    for (Entry& entry : parts_) {
        entry.part->begin_frame(slot, time_s);
        if (!entry.part->moving().any_changed()) continue;
        for (const char* name : kDrawLists)
            if (const PartDrawList* list = entry.part->list(name); list && list->changed) ++versions_[name];
    }
}

void PartList::note_change(const GpuPart& part) {
    ++parts_version_;
    for (const char* name : kDrawLists)
        if (part.list(name) != nullptr) ++versions_[name];
}

uint64_t PartList::version(std::string_view list) const {
    const auto found = versions_.find(list);
    return found == versions_.end() ? 0 : found->second;
}

}  // namespace weft::render
