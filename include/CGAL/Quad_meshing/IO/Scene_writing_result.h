// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_SCENE_WRITING_RESULT_H
#define CGAL_QUAD_MESHING_IO_SCENE_WRITING_RESULT_H

#include <string>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// \brief How the writing of a scene or a layer ended.
enum class Scene_writing_status
{
  WRITTEN,       ///< the file is complete
  NO_VIEWER,     ///< the package was built without three.js; nothing was written
  INVALID_SCENE, ///< a layer is not consistent; nothing was written
  WRITING_FAILED ///< the stream is not good any more
};

/// \ingroup PkgQuadMeshingIORef
/// \brief returns the name of a status in lower case, for instance `"no_viewer"`.
inline const char* status_name(Scene_writing_status status)
{
  switch(status)
  {
    case Scene_writing_status::WRITTEN: return "written";
    case Scene_writing_status::NO_VIEWER: return "no_viewer";
    case Scene_writing_status::INVALID_SCENE: return "invalid_scene";
    case Scene_writing_status::WRITING_FAILED: return "writing_failed";
  }
  return "";
}

/*!
\ingroup PkgQuadMeshingIORef

\brief The answer of `write_html_page()`, `write_png_picture()` and `write_vtk()`.
*/
struct Scene_writing_result
{
  Scene_writing_status status = Scene_writing_status::WRITTEN; ///< how it ended
  std::string message;                                         ///< the same as a sentence, with what is wrong

  /// returns whether all was written.
  bool is_valid() const { return status == Scene_writing_status::WRITTEN; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_SCENE_WRITING_RESULT_H
