/* Made by tuff_shapes. Change the picture, not this file:

     python -m tuff_shapes --quiet --name small_rocks --strip 5 --model hull ports/scene/rocks/small.png -o ports/scene/rocks/small.h

   40 x 40 pixels, 1 unit a pixel, y down.
   5 pieces: 5 parts, 32 vertices, 712 bytes where pointers have 32 bits; largest error 1.99 pixels at (32.0, 13.0) of frame 2.

   Use:
     uint16_t i, first = small_rocks_first[frame], count = (uint16_t)(small_rocks_first[frame + 1] - first);
     tuff_terrain now[SMALL_ROCKS_FRAME_PIECES];
     for (i = 0; i < count; ++i) { now[i] = small_rocks[first + i]; now[i].position.x += x; now[i].position.y += y; }
     tuff_floater_collide(&ship, TUFF_REAL(8.0), now, count, &ship_hull);
     The frame's upper left corner is drawn small_rocks_origins[frame].x to the left of (x, y) and .y above. */
#ifndef SMALL_ROCKS_SHAPES_H
#define SMALL_ROCKS_SHAPES_H

#include <tuff/tuff.h>

#define SMALL_ROCKS_PITCH_LOG2 6    /* advice for the chunks: 2^6 units */

/* small_rocks_0: 1 part, 7 vertices, 152 bytes; largest error 1.50 pixels at (27.0, 32.0), mean 0.44 */
#define SMALL_ROCKS_0_PART_COUNT 1
#define SMALL_ROCKS_0_VERTEX_COUNT 7
#define SMALL_ROCKS_0_RADIUS TUFF_REAL_RAW(973727)
#define SMALL_ROCKS_0_BOUNDING_RADIUS TUFF_REAL_RAW(1096919)
#define SMALL_ROCKS_0_ORIGIN_X TUFF_RATIO(1254, 64)
#define SMALL_ROCKS_0_ORIGIN_Y TUFF_RATIO(1286, 64)
#define SMALL_ROCKS_0_AT(x, y) { { (x), (y) }, SMALL_ROCKS_0_RADIUS, SMALL_ROCKS_0_BOUNDING_RADIUS, small_rocks_0_parts, SMALL_ROCKS_0_PART_COUNT }
static const tuff_vec2 small_rocks_0_vertices[SMALL_ROCKS_0_VERTEX_COUNT] = {
    { TUFF_RATIO(-303, 64), TUFF_RATIO(-996, 64) }, { TUFF_RATIO(557, 64), TUFF_RATIO(-863, 64) },
    { TUFF_RATIO(1049, 64), TUFF_RATIO(217, 64) }, { TUFF_RATIO(497, 64), TUFF_RATIO(885, 64) },
    { TUFF_RATIO(-461, 64), TUFF_RATIO(913, 64) }, { TUFF_RATIO(-949, 64), TUFF_RATIO(319, 64) },
    { TUFF_RATIO(-870, 64), TUFF_RATIO(-454, 64) }
};
static const tuff_unit2 small_rocks_0_normals[SMALL_ROCKS_0_VERTEX_COUNT] = {
    { TUFF_UNIT_EITHER(164104574, 0.152834296f), TUFF_UNIT_EITHER(-1061127322, -0.988251805f) },
    { TUFF_UNIT_EITHER(977126406, 0.910019875f), TUFF_UNIT_EITHER(-445135363, -0.41456461f) },
    { TUFF_UNIT_EITHER(827708058, 0.770863175f), TUFF_UNIT_EITHER(683974323, 0.63700074f) },
    { TUFF_UNIT_EITHER(31369455, 0.0292150807f), TUFF_UNIT_EITHER(1073283496, 0.999573171f) },
    { TUFF_UNIT_EITHER(-829659562, -0.7726807f), TUFF_UNIT_EITHER(681605836, 0.634794891f) },
    { TUFF_UNIT_EITHER(-1068177926, -0.994818211f), TUFF_UNIT_EITHER(-109166955, -0.101669647f) },
    { TUFF_UNIT_EITHER(-741945981, -0.690991044f), TUFF_UNIT_EITHER(-776168581, -0.722863317f) }
};
static const tuff_polygon small_rocks_0_parts[SMALL_ROCKS_0_PART_COUNT] = {
    { small_rocks_0_vertices + 0, small_rocks_0_normals + 0, 0x0u, 7 }
};

/* small_rocks_1: 1 part, 6 vertices, 136 bytes; largest error 1.38 pixels at (20.0, 8.0), mean 0.48 */
#define SMALL_ROCKS_1_PART_COUNT 1
#define SMALL_ROCKS_1_VERTEX_COUNT 6
#define SMALL_ROCKS_1_RADIUS TUFF_REAL_RAW(918010)
#define SMALL_ROCKS_1_BOUNDING_RADIUS TUFF_REAL_RAW(1055349)
#define SMALL_ROCKS_1_ORIGIN_X TUFF_RATIO(1297, 64)
#define SMALL_ROCKS_1_ORIGIN_Y TUFF_RATIO(1270, 64)
#define SMALL_ROCKS_1_AT(x, y) { { (x), (y) }, SMALL_ROCKS_1_RADIUS, SMALL_ROCKS_1_BOUNDING_RADIUS, small_rocks_1_parts, SMALL_ROCKS_1_PART_COUNT }
static const tuff_vec2 small_rocks_1_vertices[SMALL_ROCKS_1_VERTEX_COUNT] = {
    { TUFF_RATIO(180, 64), TUFF_RATIO(-917, 64) }, { TUFF_RATIO(958, 64), TUFF_RATIO(-380, 64) },
    { TUFF_RATIO(839, 64), TUFF_RATIO(543, 64) }, { TUFF_RATIO(-211, 64), TUFF_RATIO(922, 64) },
    { TUFF_RATIO(-942, 64), TUFF_RATIO(407, 64) }, { TUFF_RATIO(-810, 64), TUFF_RATIO(-586, 64) }
};
static const tuff_unit2 small_rocks_1_normals[SMALL_ROCKS_1_VERTEX_COUNT] = {
    { TUFF_UNIT_EITHER(609943625, 0.568054259f), TUFF_UNIT_EITHER(-883679964, -0.822991073f) },
    { TUFF_UNIT_EITHER(1064927541, 0.99179107f), TUFF_UNIT_EITHER(137298350, 0.127869055f) },
    { TUFF_UNIT_EITHER(364548644, 0.339512378f), TUFF_UNIT_EITHER(1009963262, 0.940601587f) },
    { TUFF_UNIT_EITHER(-618407159, -0.575936556f), TUFF_UNIT_EITHER(877777928, 0.817494392f) },
    { TUFF_UNIT_EITHER(-1064378939, -0.991280138f), TUFF_UNIT_EITHER(-141488439, -0.131771371f) },
    { TUFF_UNIT_EITHER(-340472594, -0.317089826f), TUFF_UNIT_EITHER(-1018331929, -0.948395491f) }
};
static const tuff_polygon small_rocks_1_parts[SMALL_ROCKS_1_PART_COUNT] = {
    { small_rocks_1_vertices + 0, small_rocks_1_normals + 0, 0x0u, 6 }
};

/* small_rocks_2: 1 part, 7 vertices, 152 bytes; largest error 1.99 pixels at (32.0, 13.0), mean 0.61 */
#define SMALL_ROCKS_2_PART_COUNT 1
#define SMALL_ROCKS_2_VERTEX_COUNT 7
#define SMALL_ROCKS_2_RADIUS TUFF_REAL_RAW(1015619)
#define SMALL_ROCKS_2_BOUNDING_RADIUS TUFF_REAL_RAW(1116323)
#define SMALL_ROCKS_2_ORIGIN_X TUFF_RATIO(1272, 64)
#define SMALL_ROCKS_2_ORIGIN_Y TUFF_RATIO(1290, 64)
#define SMALL_ROCKS_2_AT(x, y) { { (x), (y) }, SMALL_ROCKS_2_RADIUS, SMALL_ROCKS_2_BOUNDING_RADIUS, small_rocks_2_parts, SMALL_ROCKS_2_PART_COUNT }
static const tuff_vec2 small_rocks_2_vertices[SMALL_ROCKS_2_VERTEX_COUNT] = {
    { TUFF_RATIO(210, 64), TUFF_RATIO(-1032, 64) }, { TUFF_RATIO(901, 64), TUFF_RATIO(-524, 64) },
    { TUFF_RATIO(1027, 64), TUFF_RATIO(300, 64) }, { TUFF_RATIO(495, 64), TUFF_RATIO(954, 64) },
    { TUFF_RATIO(-605, 64), TUFF_RATIO(874, 64) }, { TUFF_RATIO(-1054, 64), TUFF_RATIO(141, 64) },
    { TUFF_RATIO(-794, 64), TUFF_RATIO(-747, 64) }
};
static const tuff_unit2 small_rocks_2_normals[SMALL_ROCKS_2_VERTEX_COUNT] = {
    { TUFF_UNIT_EITHER(636002699, 0.592323661f), TUFF_UNIT_EITHER(-865113907, -0.805700123f) },
    { TUFF_UNIT_EITHER(1061404503, 0.988509953f), TUFF_UNIT_EITHER(-162302145, -0.151155651f) },
    { TUFF_UNIT_EITHER(832956342, 0.775751054f), TUFF_UNIT_EITHER(677573049, 0.631039083f) },
    { TUFF_UNIT_EITHER(-77884610, -0.0725356936f), TUFF_UNIT_EITHER(1070913391, 0.997365832f) },
    { TUFF_UNIT_EITHER(-915617216, -0.852734983f), TUFF_UNIT_EITHER(560862388, 0.522343814f) },
    { TUFF_UNIT_EITHER(-1030479667, -0.959708989f), TUFF_UNIT_EITHER(-301717020, -0.280995876f) },
    { TUFF_UNIT_EITHER(-293212675, -0.273075581f), TUFF_UNIT_EITHER(-1032931669, -0.961992562f) }
};
static const tuff_polygon small_rocks_2_parts[SMALL_ROCKS_2_PART_COUNT] = {
    { small_rocks_2_vertices + 0, small_rocks_2_normals + 0, 0x0u, 7 }
};

/* small_rocks_3: 1 part, 5 vertices, 120 bytes; largest error 1.30 pixels at (33.0, 21.0), mean 0.50 */
#define SMALL_ROCKS_3_PART_COUNT 1
#define SMALL_ROCKS_3_VERTEX_COUNT 5
#define SMALL_ROCKS_3_RADIUS TUFF_REAL_RAW(878653)
#define SMALL_ROCKS_3_BOUNDING_RADIUS TUFF_REAL_RAW(1111766)
#define SMALL_ROCKS_3_ORIGIN_X TUFF_RATIO(1248, 64)
#define SMALL_ROCKS_3_ORIGIN_Y TUFF_RATIO(1276, 64)
#define SMALL_ROCKS_3_AT(x, y) { { (x), (y) }, SMALL_ROCKS_3_RADIUS, SMALL_ROCKS_3_BOUNDING_RADIUS, small_rocks_3_parts, SMALL_ROCKS_3_PART_COUNT }
static const tuff_vec2 small_rocks_3_vertices[SMALL_ROCKS_3_VERTEX_COUNT] = {
    { TUFF_RATIO(615, 64), TUFF_RATIO(-778, 64) }, { TUFF_RATIO(1037, 64), TUFF_RATIO(276, 64) },
    { TUFF_RATIO(-137, 64), TUFF_RATIO(868, 64) }, { TUFF_RATIO(-959, 64), TUFF_RATIO(509, 64) },
    { TUFF_RATIO(-624, 64), TUFF_RATIO(-728, 64) }
};
static const tuff_unit2 small_rocks_3_normals[SMALL_ROCKS_3_VERTEX_COUNT] = {
    { TUFF_UNIT_EITHER(996813755, 0.928355157f), TUFF_UNIT_EITHER(-399103799, -0.371694386f) },
    { TUFF_UNIT_EITHER(483455757, 0.450253248f), TUFF_UNIT_EITHER(958745032, 0.892900884f) },
    { TUFF_UNIT_EITHER(-429747887, -0.400233895f), TUFF_UNIT_EITHER(983990985, 0.916413009f) },
    { TUFF_UNIT_EITHER(-1036408329, -0.965230465f), TUFF_UNIT_EITHER(-280676468, -0.261400342f) },
    { TUFF_UNIT_EITHER(-43295746, -0.0403223038f), TUFF_UNIT_EITHER(-1072868577, -0.999186754f) }
};
static const tuff_polygon small_rocks_3_parts[SMALL_ROCKS_3_PART_COUNT] = {
    { small_rocks_3_vertices + 0, small_rocks_3_normals + 0, 0x0u, 5 }
};

/* small_rocks_4: 1 part, 7 vertices, 152 bytes; largest error 1.50 pixels at (5.0, 21.1), mean 0.43 */
#define SMALL_ROCKS_4_PART_COUNT 1
#define SMALL_ROCKS_4_VERTEX_COUNT 7
#define SMALL_ROCKS_4_RADIUS TUFF_REAL_RAW(878415)
#define SMALL_ROCKS_4_BOUNDING_RADIUS TUFF_REAL_RAW(1101640)
#define SMALL_ROCKS_4_ORIGIN_X TUFF_RATIO(1284, 64)
#define SMALL_ROCKS_4_ORIGIN_Y TUFF_RATIO(1304, 64)
#define SMALL_ROCKS_4_AT(x, y) { { (x), (y) }, SMALL_ROCKS_4_RADIUS, SMALL_ROCKS_4_BOUNDING_RADIUS, small_rocks_4_parts, SMALL_ROCKS_4_PART_COUNT }
static const tuff_vec2 small_rocks_4_vertices[SMALL_ROCKS_4_VERTEX_COUNT] = {
    { TUFF_RATIO(636, 64), TUFF_RATIO(-664, 64) }, { TUFF_RATIO(1035, 64), TUFF_RATIO(-221, 64) },
    { TUFF_RATIO(918, 64), TUFF_RATIO(442, 64) }, { TUFF_RATIO(252, 64), TUFF_RATIO(680, 64) },
    { TUFF_RATIO(-745, 64), TUFF_RATIO(640, 64) }, { TUFF_RATIO(-1075, 64), TUFF_RATIO(42, 64) },
    { TUFF_RATIO(-659, 64), TUFF_RATIO(-651, 64) }
};
static const tuff_unit2 small_rocks_4_normals[SMALL_ROCKS_4_VERTEX_COUNT] = {
    { TUFF_UNIT_EITHER(797837301, 0.7430439f), TUFF_UNIT_EITHER(-718593867, -0.66924268f) },
    { TUFF_UNIT_EITHER(1057403295, 0.98478353f), TUFF_UNIT_EITHER(186600581, 0.173785329f) },
    { TUFF_UNIT_EITHER(361330801, 0.336515546f), TUFF_UNIT_EITHER(1011118963, 0.941677928f) },
    { TUFF_UNIT_EITHER(-43044281, -0.0400881097f), TUFF_UNIT_EITHER(1072878695, 0.999196172f) },
    { TUFF_UNIT_EITHER(-940098518, -0.875534952f), TUFF_UNIT_EITHER(518783463, 0.483154744f) },
    { TUFF_UNIT_EITHER(-920608782, -0.857383728f), TUFF_UNIT_EITHER(-552630957, -0.514677703f) },
    { TUFF_UNIT_EITHER(-10778332, -0.0100381039f), TUFF_UNIT_EITHER(-1073687726, -0.999949634f) }
};
static const tuff_polygon small_rocks_4_parts[SMALL_ROCKS_4_PART_COUNT] = {
    { small_rocks_4_vertices + 0, small_rocks_4_normals + 0, 0x0u, 7 }
};

#define SMALL_ROCKS_FRAME_COUNT 5
#define SMALL_ROCKS_FRAME_PIECES 1    /* the most of any frame */
#define SMALL_ROCKS_COUNT 5
#define SMALL_ROCKS_WIDTH TUFF_RATIO(2560, 64)
#define SMALL_ROCKS_HEIGHT TUFF_RATIO(2560, 64)
static const tuff_terrain small_rocks[SMALL_ROCKS_COUNT] = {
    SMALL_ROCKS_0_AT(TUFF_WHOLE(0), TUFF_WHOLE(0)),
    SMALL_ROCKS_1_AT(TUFF_WHOLE(0), TUFF_WHOLE(0)),
    SMALL_ROCKS_2_AT(TUFF_WHOLE(0), TUFF_WHOLE(0)),
    SMALL_ROCKS_3_AT(TUFF_WHOLE(0), TUFF_WHOLE(0)),
    SMALL_ROCKS_4_AT(TUFF_WHOLE(0), TUFF_WHOLE(0))
};
static const uint16_t small_rocks_first[SMALL_ROCKS_FRAME_COUNT + 1] = {
    0, 1, 2, 3, 4, 5
};
static const tuff_vec2 small_rocks_origins[SMALL_ROCKS_FRAME_COUNT] = {
    { TUFF_RATIO(1254, 64), TUFF_RATIO(1286, 64) }, { TUFF_RATIO(1297, 64), TUFF_RATIO(1270, 64) },
    { TUFF_RATIO(1272, 64), TUFF_RATIO(1290, 64) }, { TUFF_RATIO(1248, 64), TUFF_RATIO(1276, 64) },
    { TUFF_RATIO(1284, 64), TUFF_RATIO(1304, 64) }
};

#endif
