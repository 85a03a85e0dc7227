# Puts the pages of write_html_page() together: the files of src/Quad_meshing/page and the library three.js, which
# Debian's package libjs-three has.
#
# Sets CGAL_QUAD_MESHING_PAGE_DIR to a folder with the header CGAL/Quad_meshing/IO/internal/page_text.h, which holds the
# text of the page before and behind the scene; empty where three.js is absent: then the function says so.

find_path(CGAL_QUAD_MESHING_THREE_JS_DIR NAMES examples/js/controls/OrbitControls.js
          PATHS /usr/share/javascript/three /usr/local/share/javascript/three
          DOC "The folder of three.min.js and examples/js/controls/OrbitControls.js (optional)")
mark_as_advanced(CGAL_QUAD_MESHING_THREE_JS_DIR)

# The C++ code of an array of string literals, short enough for every compiler.
function(quad_meshing_literals text code_variable)
  set(piece_length 8000)
  string(LENGTH "${text}" length)
  set(code "")
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} ${piece_length} piece)
    string(APPEND code "R\"page(${piece})page\",\n")
    math(EXPR begin "${begin} + ${piece_length}")
  endwhile()
  set(${code_variable} "${code}" PARENT_SCOPE)
endfunction()

function(quad_meshing_write_page source_dir target_dir)
  set(names page.css colors.js layers.js panel.js picking.js view.js)
  file(READ "${source_dir}/page.html" page)
  foreach(name ${names})
    file(READ "${source_dir}/${name}" text)
    string(REPLACE "@${name}@" "${text}" page "${page}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source_dir}/${name}")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source_dir}/page.html")

  # The scene divides the page; the library is put in behind it.
  string(FIND "${page}" "@scene@" place)
  string(SUBSTRING "${page}" 0 ${place} before)
  math(EXPR place "${place} + 7")
  string(SUBSTRING "${page}" ${place} -1 behind)
  foreach(file three.min.js examples/js/controls/OrbitControls.js)
    file(READ "${CGAL_QUAD_MESHING_THREE_JS_DIR}/${file}" text)
    get_filename_component(name "${file}" NAME)
    string(REPLACE "@${name}@" "${text}" behind "${behind}")
  endforeach()
  quad_meshing_literals("${before}" before)
  quad_meshing_literals("${behind}" behind)
  file(CONFIGURE OUTPUT "${target_dir}/CGAL/Quad_meshing/IO/internal/page_text.h" @ONLY CONTENT
"// Made by cmake/Quad_meshing_page.cmake. Holds three.js, Copyright three.js authors, under the MIT license.

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_PAGE_TEXT_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_PAGE_TEXT_H

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What stands in a page before and behind the scene.
inline const char* const page_before_scene[] = {
@before@};
inline const char* const page_behind_scene[] = {
@behind@};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_PAGE_TEXT_H
")
endfunction()

set(CGAL_QUAD_MESHING_PAGE_DIR "")
if(CGAL_QUAD_MESHING_THREE_JS_DIR AND EXISTS "${CGAL_QUAD_MESHING_THREE_JS_DIR}/three.min.js")
  set(CGAL_QUAD_MESHING_PAGE_DIR "${CMAKE_CURRENT_BINARY_DIR}/page")
  quad_meshing_write_page("${CMAKE_CURRENT_SOURCE_DIR}/src/Quad_meshing/page" "${CGAL_QUAD_MESHING_PAGE_DIR}")
else()
  message(STATUS "NOTICE: three.js was not found, write_html_page() will say so.")
endif()
