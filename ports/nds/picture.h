/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   How text leaves a Nintendo DS for ports/nds/run.c, to which libretro's DeSmuME shows the picture and no memory: the main screen is a ring
   of characters, one a pixel, written left to right and down. Red and green hold a character's low and high four bits. Blue holds the mark
   of the lap, so that one store both writes a character and says that it is there: the reader takes pixels up to the first without the
   lap's mark, whatever line was being drawn. Only the upper bits of each color are used, which no conversion of pixels changes. */
#define PICTURE_WIDTH  256u
#define PICTURE_HEIGHT 192u
#define PICTURE_SIZE   (PICTURE_WIDTH * PICTURE_HEIGHT)

/* By turns; neither black nor white has them, which is what the screen shows at first. */
#define PICTURE_MARK(lap) (2u << ((lap) & 1u))
