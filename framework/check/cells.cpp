#include "check/cells.h"

namespace weft::check {

Cells::Cells(const ResourceDecl& resource) : whole_(resource.whole()) {
    for (AspectMask rest = whole_.aspects; rest != 0; rest &= rest - 1)
        for (uint32_t mip = 0; mip < whole_.mips; ++mip)
            for (uint32_t layer = 0; layer < whole_.layers; ++layer) {
                Cell cell;
                cell.range = {mip, 1, layer, 1, static_cast<AspectMask>(rest & -rest)};
                cells_.push_back(std::move(cell));
            }
}

}  // namespace weft::check
