# quad_meshing_program(<source> TEST|PROGRAM): one executable from one source file.
#
# The build type says how they are optimized. A test keeps its assertions whatever it says. All programs of a kind in one
# folder share a precompiled header, made from Precompiled.h of that folder if there is one.

find_program(CGAL_QUAD_MESHING_CCACHE ccache)
mark_as_advanced(CGAL_QUAD_MESHING_CCACHE)

function(quad_meshing_compile_options target kind)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    set(options -Wall -Wextra)
    if(kind STREQUAL "TEST")
      list(APPEND options -UNDEBUG)
    endif()
    if(CGAL_QUAD_MESHING_SANITIZE)
      # With the sanitizers GCC takes default arguments in CGAL's headers for uninitialized.
      list(APPEND options -Wno-maybe-uninitialized -O1 -UNDEBUG -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=undefined)
      target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      list(APPEND options -fpch-preprocess) # lets ccache see through precompiled headers
    endif()
  elseif(MSVC)
    set(options /W3 /bigobj)
    if(kind STREQUAL "TEST")
      list(APPEND options /UNDEBUG)
    endif()
  endif()
  target_compile_options(${target} PRIVATE ${options})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(CGAL_QUAD_MESHING_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_DEPEND=1;CCACHE_SLOPPINESS=pch_defines,time_macros;${CGAL_QUAD_MESHING_CCACHE}")
  endif()
endfunction()

# A library without content that owns the precompiled header of the programs of one kind in a folder.
function(quad_meshing_precompiled_header kind owner_variable)
  set(header "${CMAKE_CURRENT_SOURCE_DIR}/Precompiled.h")
  set(owner "${PROJECT_NAME}_precompiled_${kind}")
  if(NOT EXISTS "${header}")
    set(owner "")
  elseif(NOT TARGET ${owner})
    set(source "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
    file(WRITE "${source}.in" "// The precompiled header needs a source file to belong to.\n")
    configure_file("${source}.in" "${source}" COPYONLY)
    add_library(${owner} OBJECT "${source}")
    target_link_libraries(${owner} PRIVATE CGAL::Quad_meshing CGAL::Data Boost::program_options)
    quad_meshing_compile_options(${owner} ${kind})
    target_precompile_headers(${owner} PRIVATE "${header}")
  endif()
  set(${owner_variable} "${owner}" PARENT_SCOPE)
endfunction()

function(quad_meshing_program source kind)
  get_filename_component(name "${source}" NAME_WE)
  add_executable(${name} "${source}")
  target_link_libraries(${name} PRIVATE CGAL::Quad_meshing CGAL::Data Boost::program_options)
  quad_meshing_compile_options(${name} ${kind})
  if(kind STREQUAL "PROGRAM")
    set_source_files_properties("${source}" PROPERTIES
      COMPILE_DEFINITIONS "CGAL_QUAD_MESHING_VERSION=\"${CGAL_Quad_meshing_VERSION}\"")
  endif()
  quad_meshing_precompiled_header(${kind} owner)
  if(owner)
    target_precompile_headers(${name} REUSE_FROM ${owner})
  endif()
endfunction()
