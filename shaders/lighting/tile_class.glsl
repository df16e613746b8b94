// What the lighting of a tile has to be able to do. Each class has a dispatch of its own.

const uint kTileSky = 0u;          // no surface
const uint kTileDirectional = 1u;  // surfaces that no listed light reaches
const uint kTilePunctual = 2u;     // points and spots without light functions
const uint kTileAny = 3u;
const uint kTileClasses = 4u;

// A list of tiles as indirect dispatches read it: three numbers of workgroups, one a tile, then the tiles, row by row.
const uint kTilesBegin = 3u;
