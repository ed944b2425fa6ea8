# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The terminal demo, tuff-demo, from ports/desktop/demo.list: sources compiled once for each build, and once.
tuff_lines(demo_both "${PROJECT_SOURCE_DIR}/ports/desktop/demo.list" "both ")
tuff_lines(demo_once "${PROJECT_SOURCE_DIR}/ports/desktop/demo.list" "once ")

function(tuff_demo_part target)
    tuff_c99(${target})
    target_compile_definitions(${target} PRIVATE _POSIX_C_SOURCE=200809L)
    target_include_directories(${target} PRIVATE include ports/scene ports/desktop)
endfunction()

add_executable(tuff-demo ${demo_once})
tuff_demo_part(tuff-demo)
foreach(build IN LISTS tuff_builds)
    add_library(demo-${build} OBJECT ${demo_both})
    tuff_demo_part(demo-${build})
    target_compile_definitions(demo-${build} PRIVATE ${tuff_scalar_${build}})
    target_sources(tuff-demo PRIVATE $<TARGET_OBJECTS:demo-${build}>)
    # The file, not the target, whose TUFF_SCALAR would be passed on.
    target_link_libraries(tuff-demo PRIVATE $<TARGET_FILE:tuff-${build}>)
    add_dependencies(tuff-demo tuff-${build})
endforeach()
target_link_libraries(tuff-demo PRIVATE m)
