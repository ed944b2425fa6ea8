/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What each public function is called in the object file. A debugger and a linker's message show these names. */
#ifndef TUFF_NAMES_H
#define TUFF_NAMES_H

#include "scalar.h"

#define tuff_circle_circle               TUFF_LINK_NAME(circle_circle)
#define tuff_circle_polygon              TUFF_LINK_NAME(circle_polygon)
#define tuff_polygon_polygon             TUFF_LINK_NAME(polygon_polygon)
#define tuff_segment_circle              TUFF_LINK_NAME(segment_circle)
#define tuff_segment_polygon             TUFF_LINK_NAME(segment_polygon)
#define tuff_terrain_overlap_circle      TUFF_LINK_NAME(terrain_overlap_circle)
#define tuff_terrain_overlap_hull        TUFF_LINK_NAME(terrain_overlap_hull)
#define tuff_bounce                      TUFF_LINK_NAME(bounce)
#define tuff_edge_normals                TUFF_LINK_NAME(edge_normals)
#define tuff_default_material            TUFF_LINK_NAME(default_material)

#define tuff_terrain_collide             TUFF_LINK_NAME(terrain_collide)
#define tuff_terrain_collide_circle      TUFF_LINK_NAME(terrain_collide_circle)
#define tuff_terrain_collide_report      TUFF_LINK_NAME(terrain_collide_report)
#define tuff_floater_collide             TUFF_LINK_NAME(floater_collide)
#define tuff_floater_collide_circle      TUFF_LINK_NAME(floater_collide_circle)
#define tuff_floater_collide_report      TUFF_LINK_NAME(floater_collide_report)
#define tuff_segment_terrain_intersect   TUFF_LINK_NAME(segment_terrain_intersect)
#define tuff_segment_terrain_first_hit   TUFF_LINK_NAME(segment_terrain_first_hit)
#define tuff_nearby_terrain              TUFF_LINK_NAME(nearby_terrain)
#define tuff_substeps                    TUFF_LINK_NAME(substeps)
#define tuff_polygon_thickness           TUFF_LINK_NAME(polygon_thickness)

#define tuff_chunks_clear                TUFF_LINK_NAME(chunks_clear)
#define tuff_chunks_insert               TUFF_LINK_NAME(chunks_insert)
#define tuff_chunks_move                 TUFF_LINK_NAME(chunks_move)
#define tuff_chunks_remove               TUFF_LINK_NAME(chunks_remove)
#define tuff_world_index                 TUFF_LINK_NAME(world_index)

#define tuff_check_polygon               TUFF_LINK_NAME(check_polygon)
#define tuff_check_hull                  TUFF_LINK_NAME(check_hull)
#define tuff_check_terrain               TUFF_LINK_NAME(check_terrain)
#define tuff_check_body                  TUFF_LINK_NAME(check_body)
#define tuff_check_world                 TUFF_LINK_NAME(check_world)
#define tuff_fault_text                  TUFF_LINK_NAME(fault_text)

#endif
