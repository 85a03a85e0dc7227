// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_FILES_H
#define CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_FILES_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_text.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <istream>
#include <ostream>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief is the outcome of reading a layout.
 */
enum class Layout_reading_status
{
  READ,        ///< there is a layout
  CANNOT_OPEN, ///< the file cannot be opened
  MALFORMED    ///< the text is not a layout; the message names the line
};

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief returns the name of the enumerator in lower case.
 */
inline const char* status_name(Layout_reading_status status)
{
  switch(status)
  {
    case Layout_reading_status::READ: return "read";
    case Layout_reading_status::CANNOT_OPEN: return "cannot_open";
    case Layout_reading_status::MALFORMED: return "malformed";
  }
  return "unknown";
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief says what became of the reading of a layout.
 */
struct Layout_reading_result
{
  Layout_reading_status status = Layout_reading_status::READ; ///< the outcome
  std::string message;                                        ///< the outcome as a sentence, empty if there is a layout

  /// whether there is a layout.
  bool is_valid() const { return status == Layout_reading_status::READ; }
};

namespace internal {

// What one of the readers of a text makes of it.
inline Layout_reading_result read_layout_text(std::istream& in, bool (Layout_text::*read)(), Surface_layout& layout)
{
  Layout_reading_result result;
  Layout_text text(in);
  if((text.*read)())
    layout = text.layout;
  else
  {
    result.status = Layout_reading_status::MALFORMED;
    result.message = text.error;
  }
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief reads a layout from a text in the format that \ref Quad_meshing_layout_format describes.
 *
 * \param in the text
 * \param layout the layout; it stays as it is if the text is none
 */
inline Layout_reading_result read_surface_layout(std::istream& in, Surface_layout& layout)
{
  return internal::read_layout_text(in, &internal::Layout_text::read_layout, layout);
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief reads curves as a layout without patches from the `v` and `l` elements of a text in the format OBJ.
 *
 * A point where one curve ends, or where several curves meet, is a node; curves meet where they share a vertex of the
 * file. The pieces between nodes are the arcs, which are aligned; they pass through the other vertices.
 *
 * \param in the text
 * \param layout the layout; it stays as it is if the text holds no curves
 */
inline Layout_reading_result read_layout_curves(std::istream& in, Surface_layout& layout)
{
  return internal::read_layout_text(in, &internal::Layout_text::read_curves, layout);
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief reads a file: curves if its name ends in `.obj`, else a layout.
 */
inline Layout_reading_result read_surface_layout(const std::string& filename, Surface_layout& layout)
{
  errno = 0;
  std::ifstream in(filename);
  if(!in)
  {
    Layout_reading_result result;
    result.status = Layout_reading_status::CANNOT_OPEN;
    result.message =
      std::string("The file cannot be opened: ") + (errno != 0 ? std::strerror(errno) : "unknown reason") + ".";
    return result;
  }
  const bool is_obj = filename.size() > 4 && filename.compare(filename.size() - 4, 4, ".obj") == 0;
  return is_obj ? read_layout_curves(in, layout) : read_surface_layout(in, layout);
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief writes a layout in the format that \ref Quad_meshing_layout_format describes, with the precision of the
 * stream.
 */
inline void write_surface_layout(std::ostream& out, const Surface_layout& layout)
{
  internal::write_layout_text(out, layout);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_FILES_H
