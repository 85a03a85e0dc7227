// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_HTML_PAGE_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_HTML_PAGE_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/check_scene.h>
#include <CGAL/Quad_meshing/IO/internal/write_scene_json.h>
#include <CGAL/Quad_meshing/IO/write_html_page.h>

#ifdef CGAL_QUAD_MESHING_HAS_PAGE
#include <CGAL/Quad_meshing/IO/internal/page_text.h>
#endif

#include <ostream>
#include <string>

namespace CGAL {
namespace Quad_meshing {

CGAL_QUAD_MESHING_INLINE bool has_html_viewer()
{
#ifdef CGAL_QUAD_MESHING_HAS_PAGE
  return true;
#else
  return false;
#endif
}

CGAL_QUAD_MESHING_INLINE Scene_writing_result write_html_page(std::ostream& os, const Scene& scene)
{
  Scene_writing_result result = internal::check_scene(scene);
  if(!result.is_valid())
    return result;
#ifdef CGAL_QUAD_MESHING_HAS_PAGE
  for(const char* piece : internal::page_before_scene)
    os << piece;
  internal::write_scene_json(os, scene);
  for(const char* piece : internal::page_behind_scene)
    os << piece;
  os.flush();
  if(!os)
  {
    result.status = Scene_writing_status::WRITING_FAILED;
    result.message = "The page could not be written.";
  }
  else
    result.message = "The page was written.";
#else
  (void)os;
  result.status = Scene_writing_status::NO_VIEWER;
  result.message = "The package was built without three.js (Debian's libjs-three), which pages need.";
#endif
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_HTML_PAGE_IMPL_H
