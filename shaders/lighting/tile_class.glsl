// Classes of tiles, by the lighting code that a tile needs. Each class has a separate dispatch.

const uint kTileSky = 0u;          // The tile shows only sky.
const uint kTileDirectional = 1u;  // The tile has surfaces, but no light in its list.
const uint kTilePunctual = 2u;     // All lights in the list are points and spots without light functions.
const uint kTileAny = 3u;
const uint kTileClasses = 4u;

// Layout of a list of tiles: three workgroup counts for the indirect dispatch, with one workgroup per tile, then the
// numbers of the tiles, row by row.
const uint kTilesBegin = 3u;
